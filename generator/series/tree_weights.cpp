// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/tree_weights.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/exact/methods/projected_stages.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

Number number(const RationalPolynomial& constant, const Ground& ground) {
    return ground.rational(constant.coefficient(0), "1");
}

/// Functions of the time in [0,1], polynomials over Q.
struct Times {
    using Function = RationalPolynomial;

    Ground ground;

    [[nodiscard]] static Function one() { return Function(1); }
    [[nodiscard]] static Function product(const Function& g, const Function& h) { return g * h; }
    /// The integral from 0.
    [[nodiscard]] static Function from_start(const Function& g) { return antiderivative(g); }
    /// The integral up to 1.
    [[nodiscard]] static Function to_end(const Function& g) { return all(g) - from_start(g); }
    [[nodiscard]] Number total(const Function& g) const { return number(all(g), ground); }

private:
    [[nodiscard]] static Function all(const Function& g) {
        Function result;
        result.set_coefficient(0, g.integral_over_unit_interval());
        return result;
    }
};

/// Functions on the stages of a method, by its coefficients.
class Stages {
public:
    using Function = NumberVector;

    explicit Stages(const PartitionedMethod& method) : b_{method.b}, A_(method.A) {
        for (const NumberVector& row : method.A_tilde) {
            NumberVector& rest = to_end_.emplace_back();
            for (std::size_t j = 0; j < row.size(); ++j) { rest.push_back(method.b[j] - row[j]); }
        }
    }

    [[nodiscard]] Function one() const { return Function(A_.size(), Number(1)); }
    [[nodiscard]] static Function product(Function g, const Function& h) {
        for (std::size_t i = 0; i < g.size(); ++i) { g[i] = g[i] * h[i]; }
        return g;
    }
    [[nodiscard]] Function from_start(const Function& g) const { return A_ * g; }
    [[nodiscard]] Function to_end(const Function& g) const { return to_end_ * g; }
    [[nodiscard]] Number total(const Function& g) const { return (b_ * g).front(); }

private:
    NumberMatrix b_, A_, to_end_;
};

/// The same at the roots of a polynomial over Q, where all weights are rational: of
/// PolynomialStages or ProjectedStages.
template <class PolynomialFunctions>
class StagesAtRoots {
public:
    using Function = RationalPolynomial;

    StagesAtRoots(PolynomialFunctions stages, Ground ground)
        : stages_(std::move(stages)), ground_(std::move(ground)) {}

    [[nodiscard]] Function one() const { return stages_.one(); }
    [[nodiscard]] Function product(const Function& g, const Function& h) const {
        return stages_.product(g, h);
    }
    [[nodiscard]] Function from_start(const Function& g) const {
        return stages_.apply(Colour::f, g, 1);
    }
    [[nodiscard]] Function to_end(const Function& g) const {
        return all(g) - stages_.apply(Colour::g, g, 1);
    }
    [[nodiscard]] Number total(const Function& g) const { return number(all(g), ground_); }

private:
    [[nodiscard]] Function all(const Function& g) const {
        return stages_.defect(Colour::f, g, 1) + Function(1);
    }

    PolynomialFunctions stages_;
    Ground ground_;
};

/// From the leaves to the middle. What hangs on an edge is remembered, as many trees have it.
template <class Domain>
class Weight {
public:
    explicit Weight(Domain domain) : domain_(std::move(domain)) {}

    [[nodiscard]] Number operator()(const Tree& tree) { return domain_.total(at_vertex(tree)); }

private:
    using Function = typename Domain::Function;

    Function at_vertex(const Tree& tree) {
        Function result = domain_.one();
        for (const TreePointer& child : tree.children) {
            result = domain_.product(result, on_edge(*child));
        }
        return result;
    }

    Function on_edge(const Tree& tree) {
        const auto known = on_edges_.find(tree.text);
        if (known != on_edges_.end()) { return known->second; }
        const Function below = at_vertex(tree);
        Function result =
            tree.root == Colour::f ? domain_.from_start(below) : domain_.to_end(below);
        return on_edges_.emplace(tree.text, std::move(result)).first->second;
    }

    Domain domain_;
    std::map<std::string, Function> on_edges_;
};

template <class Domain>
TreeWeight weight_on(Domain domain) {
    const auto weight = std::make_shared<Weight<Domain>>(std::move(domain));
    return [weight](const Tree& tree) { return (*weight)(tree); };
}

TreeWeight weight_of(const PartitionedMethod& method) {
    if (!method.is_exact()) {
        throw MathError("the coefficients of the method have no closed form");
    }
    return weight_on(Stages(method));
}

TreeWeight weight_of(const Tableau& tableau, const Ground& ground) {
    if (const RationalPolynomial* const P = tableau.node_polynomial()) {
        return weight_on(StagesAtRoots(PolynomialStages(*P), ground));
    }
    return weight_of(partitioned_method(tableau));
}

/// NOTE: for T = p^T K p/2 the momenta in the stages enter by their projections alone, which
/// partitioned_method() takes.
TreeWeight weight_of(const GalerkinRule& rule, const Ground& ground) {
    if (rule.over_rationals) {
        return weight_on(StagesAtRoots(ProjectedStages(*rule.over_rationals), ground));
    }
    return weight_of(partitioned_method(rule));
}

/// Of n vertices what can hang on the middle one, ascending.
std::vector<TreePointer> below_middle(const std::vector<std::vector<TreePointer>>& branches,
                                      int n) {
    std::vector<TreePointer> result;
    for (int size = 1; 2 * size <= n; ++size) {
        for (const TreePointer& branch : branches[static_cast<std::size_t>(size) - 1]) {
            if (2 * size < n || branch->root == Colour::f) { result.push_back(branch); }
        }
    }
    return result;
}

}  // namespace

/// A tree has one vertex in its middle, from which no branch has half of all vertices or more, or
/// an edge with half of them at either end: then it is written from the end on the edge's q.
/// NOTE: the middle has no edge above it, and so may have one child more than elsewhere.
std::vector<std::vector<TreePointer>> unrooted_trees(TreeFamily family, int vertices) {
    const auto branches = trees(family, vertices / 2);
    const std::vector<Kind> all_kinds = kinds(family);
    std::vector<std::vector<TreePointer>> result{{graft(Colour::f, {})}};
    for (int n = 2; n <= vertices; ++n) {
        std::vector<TreePointer>& level = result.emplace_back();
        for (const Kind& kind : all_kinds) {
            const auto& roots = all_kinds[kind.children].roots;
            std::vector<TreePointer> candidates;
            std::vector<int> sizes;
            for (const TreePointer& branch : below_middle(branches, n)) {
                if (std::find(roots.begin(), roots.end(), branch->root) == roots.end()) continue;
                candidates.push_back(branch);
                sizes.push_back(branch->vertices);
            }
            const auto add = [&](const std::vector<std::size_t>& chosen) {
                std::vector<TreePointer> children;
                for (const std::size_t i : chosen) { children.push_back(candidates[i]); }
                level.push_back(graft(Colour::f, std::move(children)));
            };
            for_each_multiset(sizes, n - 1, kind.most_children + 1, add);
        }
    }
    return result;
}

TreeWeight exact_weight(const Ground& ground) { return weight_on(Times{ground}); }

TreeWeight method_weight(const DerivedMethod& method, const Ground& ground) {
    return std::visit([&](const auto& derived) { return weight_of(derived, ground); }, method);
}

}  // namespace hvi::gen
