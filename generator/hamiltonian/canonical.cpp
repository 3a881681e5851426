// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/canonical.hpp"

#include <optional>

#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// A two-form by its entries, i < j; the coordinates are q, p and t.
using TwoForm = std::vector<std::vector<ex>>;

class JumpOnSurface {
public:
    JumpOnSurface(const Hamiltonian& hamiltonian, const SceneEvent& event)
        : algebra_(hamiltonian), n_(hamiltonian.degrees_of_freedom()) {
        variables_ = algebra_.variables();
        const ex t = algebra_.read(Expression::symbol("t"), nullptr);
        variables_.push_back(GiNaC::ex_to<symbol>(t));
        for (const symbol& variable : variables_) after_.push_back(variable);
        for (const NamedExpression& each : event.set)
            for (std::size_t k = 0; k < 2 * n_; ++k)
                if (variables_[k].get_name() == each.name)
                    after_[k] = algebra_.read(each.expression, each.place.source);
        g_ = algebra_.read(event.zero.expression, event.zero.place.source);
        solve();
    }

    [[nodiscard]] CanonicalFinding finding() const {
        CanonicalFinding result;
        const TwoForm form = change();
        const std::size_t count = variables_.size();
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 1; j < count; ++j)
                for (std::size_t k = j + 1; k < count; ++k)
                    look_at(form[i][j] * slope(k) - form[i][k] * slope(j) + form[j][k] * slope(i),
                            k + 1 == count && slope(k).is_zero(), result);
        return result;
    }

private:
    [[nodiscard]] ex by(const ex& of, std::size_t k) const {
        return algebra_.derivative(of, variables_[k]);
    }
    [[nodiscard]] ex slope(std::size_t k) const { return by(g_, k); }

    /// Solves g = 0 for a variable v in which it is linear: g = a v + b gives v = -b/a.
    void solve() {
        for (std::size_t k = variables_.size(); k-- > 0 && !solution_;) {
            const ex a = by(g_, k);
            if (a.is_zero() || !by(a, k).is_zero()) continue;
            const ex b = g_.subs(variables_[k] == 0);
            solution_ = variables_[k] == -b / a;
        }
    }

    /// Returns the change of H in the jump.
    [[nodiscard]] ex change_of_H() const {
        GiNaC::exmap jump;
        for (std::size_t k = 0; k < 2 * n_; ++k) jump[variables_[k]] = after_[k];
        return algebra_.function().subs(jump, GiNaC::subs_options::no_pattern) -
               algebra_.function();
    }

    /// Returns dP^dQ - dp^dq - d(change of H)^dt.
    [[nodiscard]] TwoForm change() const {
        const std::size_t count = variables_.size();
        const ex energy = change_of_H();
        TwoForm form(count, std::vector<ex>(count));
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 1; j < count; ++j) {
                ex entry;
                for (std::size_t k = 0; k < n_; ++k) {
                    const ex& Q = after_[k];
                    const ex& P = after_[n_ + k];
                    entry += by(P, i) * by(Q, j) - by(P, j) * by(Q, i);
                }
                if (i < n_ && j == i + n_) entry += 1;  // -dp^dq = dq^dp
                if (j + 1 == count) entry -= by(energy, i);
                form[i][j] = entry;
            }
        return form;
    }

    void look_at(const ex& entry, bool is_of_energy, CanonicalFinding& result) const {
        if (result.holds == Vanishing::refuted) return;
        const Vanishing holds = vanishes(entry);
        if (holds == Vanishing::proved) return;
        result.holds = holds;
        result.fault = is_of_energy ? "H changes by " +
                                          to_text(algebra_.written(multiplied_out(change_of_H())))
                                    : "dq^dp is not kept";
    }

    /// Whether the expression vanishes where g = 0.
    [[nodiscard]] Vanishing vanishes(const ex& expression) const {
        const Vanishing everywhere = vanishing_by_monomials(algebra_, expression);
        if (everywhere == Vanishing::proved) return everywhere;
        if (!solution_) return Vanishing::unknown;
        return vanishing_by_monomials(algebra_,
                                      expression.subs(*solution_, GiNaC::subs_options::no_pattern));
    }

    Algebra algebra_;
    std::size_t n_;
    std::vector<symbol> variables_;  ///< q, p, t
    std::vector<ex> after_;          ///< the values of `variables_` after the jump
    ex g_;
    std::optional<ex> solution_;
};

}  // namespace

CanonicalFinding canonical(const Hamiltonian& hamiltonian, const std::vector<Parameter>& parameters,
                           const SceneEvent& event) {
    Hamiltonian with_values = hamiltonian;
    with_values.parameters = parameters;
    return JumpOnSurface(with_values, event).finding();
}

}  // namespace hvi::gen
