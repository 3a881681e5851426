// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/counted_sweeps.hpp"

#include <utility>
#include <vector>

#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/exact/algebra/polynomial_in_square.hpp"
#include "generator/exact/methods/even_map.hpp"
#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/exact/methods/tree_conditions.hpp"
#include "generator/support/error.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_pairs = 300'000;  // of classes, as of values of order conditions

/// Calls `examine` with the stages of the method in exact arithmetic.
template <class Examine>
auto on_exact_stages(const Tableau& tableau, Examine examine) {
    if (const RationalPolynomial* const P = tableau.node_polynomial()) {
        return examine(PolynomialStages(*P));
    }
    const PartitionedMethod method = partitioned_method(tableau);
    if (tableau.digits > 0 || !method.is_exact()) {
        throw MathError("sweeps of this method are not looked at: its coefficients are known by "
                        "enclosures alone");
    }
    if (tableau.galerkin && !tableau.parameters.empty()) {
        return examine(GalerkinStages(tableau, *tableau.galerkin));
    }
    return examine(NumberStages(method));
}

/// Returns the most vertices of trees whose weights are those of the method.
template <class Swept>
PowerOfStep agreement(const Swept& stages, TreeFamily family, int max_order) {
    TreeClasses<Swept> classes(stages, family);
    std::size_t values = 0;
    while (classes.vertices() < max_order && values <= most_pairs) {
        classes.grow();
        values = classes.size() * static_cast<std::size_t>(stages.count());
        const int n = classes.vertices();
        for (const Colour root : {Colour::f, Colour::g}) {
            for (const auto& psi : classes.values(root)) {
                if (!stages.is_cut(root, psi)) { continue; }
                const auto weight = stages.weight_of_method(root, psi, n);
                if (!conditions::is_zero(weight).holds) { return {n - 1, false}; }
            }
        }
    }
    return {classes.vertices(), true};
}

/// Looks at the conditions of symplecticity for trees of more and more vertices.
template <class Swept>
class Symplecticity {
public:
    Symplecticity(const Swept& stages, TreeFamily family, int max_order)
        : stages_(stages), classes_(stages, family), family_(family), max_order_(max_order) {}

    [[nodiscard]] PowerOfStep found() {
        for (int n = 1; n <= max_order_; ++n) {
            classes_.grow();
            f_.push_back(classes_.values(Colour::f));
            g_.push_back(classes_.values(Colour::g));
            if (pairs(n) > most_pairs) { return {n - 1, true}; }
            if (!holds(n)) { return {n - 1, false}; }
        }
        return {max_order_, true};
    }

private:
    using Function = typename Swept::Function;
    using Scalar = typename Swept::Scalar;

    [[nodiscard]] const std::vector<Function>& f(int n) const {
        return f_[static_cast<std::size_t>(n) - 1];
    }
    [[nodiscard]] const std::vector<Function>& g(int n) const {
        return g_[static_cast<std::size_t>(n) - 1];
    }

    [[nodiscard]] std::size_t pairs(int n) const {
        std::size_t count = f(n).size();
        for (int m = 1; m < n; ++m) { count += f(m).size() * g(n - m).size(); }
        return count;
    }

    [[nodiscard]] bool holds(int n) const {
        if (family_ == TreeFamily::general && !is_free_of_colour(n)) { return false; }
        const int most = family_ == TreeFamily::nystrom ? 1 : n - 1;
        for (int m = 1; m <= std::min(most, n - 1); ++m) {
            for (const Function& u : f(m)) {
                for (const Function& v : g(n - m)) {
                    if (!is_zero(defect(u, m, v, n - m))) { return false; }
                }
            }
        }
        return family_ != TreeFamily::nystrom || holds_between_forces(n);
    }

    [[nodiscard]] bool is_free_of_colour(int n) const {
        for (const Function& psi : f(n)) {
            if (!is_zero(weight(Colour::f, psi, n) - weight(Colour::g, psi, n))) { return false; }
        }
        return true;
    }

    /// Returns whether the conditions hold for two roots g and an f between them.
    [[nodiscard]] bool holds_between_forces(int n) const {
        for (int m = 1; 2 * m < n; ++m) {
            const int k = n - 1 - m;
            for (const Function& u : g(m)) {
                for (const Function& v : g(k)) {
                    if (!is_zero(by_way_of_f(u, m, v, k) - by_way_of_f(v, k, u, m))) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /// Returns gamma(u) gamma(v) (a(u o v) + a(v o u) - a(u) a(v)).
    [[nodiscard]] Scalar defect(const Function& u, int m, const Function& v, int k) const {
        const Function chi_u = stages_.apply(Colour::f, u, m);
        const Function chi_v = stages_.apply(Colour::g, v, k);
        return weight(Colour::f, stages_.product(u, chi_v), m) +
               weight(Colour::g, stages_.product(v, chi_u), k) -
               weight(Colour::f, u, m) * weight(Colour::g, v, k);
    }

    /// Returns gamma(f[u]) gamma(f[v]) (a(v o f[u]) - a(f[u]) a(v)).
    [[nodiscard]] Scalar by_way_of_f(const Function& u, int m, const Function& v, int k) const {
        const Function f_u = stages_.apply(Colour::g, u, m);  // psi of f[u]
        const Function chi = stages_.apply(Colour::f, f_u, m + 1);
        return Scalar(k + 1) * (weight(Colour::g, stages_.product(v, chi), k) -
                                weight(Colour::f, f_u, m + 1) * weight(Colour::g, v, k));
    }

    [[nodiscard]] Scalar weight(Colour root, const Function& psi, int vertices) const {
        return stages_.weight(root, psi, vertices);
    }
    [[nodiscard]] static bool is_zero(const Scalar& scalar) {
        return conditions::is_zero(scalar).holds;
    }

    const Swept& stages_;
    TreeClasses<Swept> classes_;
    TreeFamily family_;
    int max_order_;
    std::vector<std::vector<Function>> f_, g_;  ///< psi by number of vertices
};

/// Returns b.Phi of f[g[f[...]]] with 1, 2, ... vertices, or of g[f[g[...]]], until they are 0.
template <class Swept>
NumberVector weights_of_tall_trees(const Swept& stages, Colour root) {
    const auto other = [](Colour colour) { return colour == Colour::f ? Colour::g : Colour::f; };
    NumberVector weights;
    for (int n = 1;; ++n) {
        auto psi = stages.one();
        Colour colour = n % 2 == 1 ? root : other(root);  // of the leaf
        for (int m = 1; m < n; ++m, colour = other(colour)) { psi = stages.apply(colour, psi, 1); }
        if (stages.is_cut(root, psi)) { return weights; }
        weights.push_back(conditions::to_number(stages.weight(root, psi, 1)));
    }
}

/// Returns the map of q' = omega p, p' = -omega q: each g in a tree brings a sign.
EvenMap map_of_tall_trees(const NumberVector& f, const NumberVector& g) {
    EvenMap map{{Number(1)}, {}, {}, {Number(1)}, {Number(1)}};
    for (std::size_t k = 0; 2 * k < std::max(f.size(), g.size()); ++k) {
        const Number sign(k % 2 == 0 ? 1 : -1);
        const auto append = [&](NumberVector& entry, const NumberVector& weights, std::size_t n,
                                const Number& factor) {
            if (n < weights.size()) { entry.push_back(factor * weights[n]); }
        };
        append(map.m12, f, 2 * k, sign);
        append(map.m21, g, 2 * k, -sign);
        append(map.m11, f, 2 * k + 1, -sign);
        append(map.m22, g, 2 * k + 1, -sign);
    }
    return map;
}

}  // namespace

SweptFamily swept_family(const Tableau& tableau, SweepForm form, TreeFamily family, int sweeps,
                         int max_order) {
    const Progress::Stage stage("checking conditions of counted sweeps");
    HVI_CHECK(max_order >= 1 && max_order <= most_vertices && sweeps > 0);
    HVI_CHECK((form == SweepForm::positions) == (family == TreeFamily::nystrom));
    return on_exact_stages(tableau, [&](const auto& base) -> SweptFamily {
        const SweptStages stages(base, form, sweeps);
        return {conditions::examine(stages, conditions::Exactly(), conditions::ExactDefect(),
                                    family, max_order),
                agreement(stages, family, max_order),
                Symplecticity(stages, family, max_order).found()};
    });
}

OscillatorMap swept_oscillator(const Tableau& tableau, int sweeps) {
    return on_exact_stages(tableau, [&](const auto& base) {
        const SweptStages stages(base, SweepForm::positions, sweeps);
        return oscillator_map(map_of_tall_trees(weights_of_tall_trees(stages, Colour::f),
                                                weights_of_tall_trees(stages, Colour::g)));
    });
}

std::optional<Term> first_of_determinant(const OscillatorMap& map) {
    const NumberPolynomial diagonal = product(even(map.m11), even(map.m22)),
                           other = shifted(product(odd(map.m12), odd(map.m21)));
    for (std::size_t k = 1; k < std::max(diagonal.size(), other.size()); ++k) {
        const auto of = [k](const NumberPolynomial& all) {
            return k < all.size() ? all[k] : Number(0);
        };
        const Number coefficient = of(diagonal) - of(other);
        if (!coefficient.is_zero()) { return Term{coefficient, 2 * k}; }
    }
    return {};
}

int stage_order(const Tableau& tableau) {
    return on_exact_stages(tableau, [](const auto& stages) {
        TreeClasses classes(stages, TreeFamily::general);
        const auto are_equal = [&] {
            return classes.values(Colour::f).size() == 1 && classes.values(Colour::g).size() == 1;
        };
        for (classes.grow(); are_equal(); classes.grow()) {
            if (classes.vertices() == most_vertices) { return most_vertices - 1; }
        }
        return classes.vertices() - 2;
    });
}

}  // namespace hvi::gen
