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

/// Functions of time in [0,1]: polynomials over Q.
struct Times {
    using Function = RationalPolynomial;

    Ground ground;

    [[nodiscard]] static Function one() { return Function(1); }
    [[nodiscard]] static Function product(const Function& g, const Function& h) { return g * h; }
    /// Returns the integral from 0.
    [[nodiscard]] static Function from_start(const Function& g) { return antiderivative(g); }
    /// Returns the integral up to 1.
    [[nodiscard]] static Function to_end(const Function& g) { return all(g) - from_start(g); }
    /// NOTE: the velocity may be any function.
    [[nodiscard]] static Function over_link(const Function&) { return {}; }
    [[nodiscard]] Number total(const Function& g) const { return number(all(g), ground); }
    [[nodiscard]] static bool is_zero(const Function& g) { return g == Function(); }

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

    Stages(const PartitionedMethod& method, NumberMatrix over_link)
        : b_{method.b}, A_(method.A), over_link_(std::move(over_link)) {
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
    [[nodiscard]] Function over_link(const Function& g) const { return over_link_ * g; }
    [[nodiscard]] Number total(const Function& g) const { return (b_ * g).front(); }
    [[nodiscard]] static bool is_zero(const Function& g) {
        return std::all_of(g.begin(), g.end(), [](const Number& x) { return x.is_zero(); });
    }

private:
    NumberMatrix b_, A_, to_end_, over_link_;
};

/// Functions on the stages at the roots of a polynomial over Q, where all weights are rational:
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
    [[nodiscard]] Function over_link(const Function& g) const { return stages_.projected(g) - g; }
    [[nodiscard]] Number total(const Function& g) const { return number(all(g), ground_); }
    [[nodiscard]] static bool is_zero(const Function& g) { return g == Function(); }

private:
    [[nodiscard]] Function all(const Function& g) const {
        return stages_.defect(Colour::f, g, 1) + Function(1);
    }

    PolynomialFunctions stages_;
    Ground ground_;
};

/// Computes weights from the leaves to the middle. The values of branches are remembered, as many
/// trees share them.
template <class Domain>
class WeightOn : public TreeWeight {
public:
    explicit WeightOn(Domain domain) : domain_(std::move(domain)) {}

    [[nodiscard]] Number operator()(const SeriesTree& tree) override {
        return domain_.total(at_vertex(tree));
    }
    [[nodiscard]] bool is_nothing(const SeriesTree& branch) override {
        return Domain::is_zero(on_edge(branch));
    }

private:
    using Function = typename Domain::Function;

    Function at_vertex(const SeriesTree& tree) {
        Function result = domain_.one();
        for (const SeriesTreePointer& child : tree.children) {
            result = domain_.product(result, on_edge(*child));
        }
        return result;
    }

    const Function& on_edge(const SeriesTree& branch) {
        const auto known = on_edges_.find(branch.text);
        if (known != on_edges_.end()) { return known->second; }
        return on_edges_.emplace(branch.text, over(*branch.above, at_vertex(branch))).first->second;
    }

    Function over(End end, const Function& below) const {
        switch (end) {
        case End::p: return domain_.from_start(below);
        case End::q: return domain_.to_end(below);
        case End::link: break;
        }
        return domain_.over_link(below);
    }

    Domain domain_;
    std::map<std::string, Function> on_edges_;
};

template <class Domain>
TreeWeightPointer weight_on(Domain domain) {
    return std::make_unique<WeightOn<Domain>>(std::move(domain));
}

void check_exact(const PartitionedMethod& method) {
    if (method.is_exact()) { return; }
    throw MathError("the coefficients of the method have no closed form");
}

TreeWeightPointer weight_of(const Tableau& tableau, const Ground& ground) {
    if (const RationalPolynomial* const P = tableau.node_polynomial()) {
        return weight_on(StagesAtRoots(PolynomialStages(*P), ground));
    }
    const PartitionedMethod method = partitioned_method(tableau);
    check_exact(method);
    return weight_on(Stages(method, zeros(method.stages(), method.stages())));
}

TreeWeightPointer weight_of(const GalerkinRule& rule, const Ground& ground) {
    if (rule.over_rationals) {
        return weight_on(StagesAtRoots(ProjectedStages(*rule.over_rationals), ground));
    }
    const PartitionedMethod method = partitioned_method(rule);
    check_exact(method);
    return weight_on(Stages(method, projection(rule) + identity(rule.nodes()) * Number(-1)));
}

}  // namespace

TreeWeightPointer exact_weight(const Ground& ground) { return weight_on(Times{ground}); }

TreeWeightPointer method_weight(const DerivedMethod& method, const Ground& ground) {
    return std::visit([&](const auto& derived) { return weight_of(derived, ground); }, method);
}

}  // namespace hvi::gen
