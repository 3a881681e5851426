// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/lagrangian_equations.hpp"

#include <set>
#include <utility>
#include <variant>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/hamiltonian/legendre.hpp"

namespace hvi::gen {

namespace {

/// Returns the names that vary from stage to stage: coordinates, velocities, and the time where it
/// occurs.
std::vector<std::string> varying(const Lagrangian& L) {
    std::vector<std::string> names = variables(L);
    if (depends_on_time(L)) names.push_back("t");
    return names;
}

/// Returns the names in L and of its momenta.
std::set<std::string> taken(const Lagrangian& L, const std::vector<std::string>& momenta) {
    std::set<std::string> names = symbols_in(L.expression);
    names.insert(momenta.begin(), momenta.end());
    return names;
}

std::vector<StageNames>
names_in_stages(const Lagrangian& L, const std::vector<std::string>& momenta, std::size_t stages) {
    const std::vector<std::string> names = varying(L);
    std::set<std::string> used = taken(L, momenta);
    used.insert(names.begin(), names.end());
    return stage_names(names, used, stages);
}

bool is_needed(const std::string& variable, const LagrangianGradient& gradient) {
    return occurs_in(variable, gradient.by_coordinates) ||
           occurs_in(variable, gradient.by_velocities);
}

/// Writes the equations for a tableau.
class LagrangianWriter {
public:
    LagrangianWriter(const ButcherPair& pair, const Lagrangian& L,
                     const LagrangianGradient& gradient, LagrangianEquations& result)
        : pair_(pair),
          L_(L),
          gradient_(gradient),
          terms_(names_in_stages(L, result.momenta, pair.stages())),
          result_(result) {}

    void write() {
        if (is_needed("t", gradient_))
            for (std::size_t i = 0; i < pair_.stages(); ++i)
                result_.positions.push_back(terms_.time(i, pair_.c[i]));
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k) write_stages(k);
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k)
            result_.update.push_back({L_.coordinates[k], position(k, pair_.b)});
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k)
            result_.update.push_back({result_.momenta[k], momentum(k, pair_.b)});
        result_.is_exact = terms_.is_exact();
    }

private:
    void write_stages(std::size_t k) {
        for (std::size_t i = 0; i < pair_.stages(); ++i) {
            if (is_needed(L_.coordinates[k], gradient_))
                result_.positions.push_back(
                    {terms_.name(L_.coordinates[k], i), position(k, pair_.A[i])});
            result_.conditions.push_back(
                {terms_.in_stage(gradient_.by_velocities[k], i), momentum(k, pair_.A_tilde[i])});
        }
    }

    /// Returns q + h sum_j row_j V^j.
    [[nodiscard]] Expression position(std::size_t k, const NumberVector& row) {
        return terms_.moved(Expression::symbol(L_.coordinates[k]),
                            Expression::symbol(L_.velocities[k]), terms_.written(row), false);
    }

    /// Returns p + h sum_j row_j dL/dq(Q^j, V^j).
    [[nodiscard]] Expression momentum(std::size_t k, const NumberVector& row) {
        return terms_.moved(Expression::symbol(result_.momenta[k]), gradient_.by_coordinates[k],
                            terms_.written(row), false);
    }

    const ButcherPair& pair_;
    const Lagrangian& L_;
    const LagrangianGradient& gradient_;
    StageTerms terms_;
    LagrangianEquations& result_;
};

/// Writes the equations for the general form.
class GeneralLagrangianWriter {
public:
    GeneralLagrangianWriter(const GalerkinRule& rule, const Lagrangian& L,
                            const LagrangianGradient& gradient, LagrangianEquations& result)
        : rule_(rule),
          L_(L),
          gradient_(gradient),
          terms_(rule, L.coordinates, varying(L), taken(L, result.momenta)),
          result_(result) {}

    void write() {
        result_.basis = rule_.provenance.basis;
        if (is_needed("t", gradient_)) result_.positions = terms_.times();
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k) write_at_nodes(k);
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k)
            for (std::size_t j = 0; j < rule_.functions(); ++j)
                result_.conditions.push_back(
                    terms_.condition(gradient_.by_velocities[k], result_.momenta[k],
                                     gradient_.by_coordinates[k], false, j));
        for (const std::string& x : L_.coordinates)
            result_.update.push_back({x, terms_.position_at_end(x)});
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k)
            result_.update.push_back(
                {result_.momenta[k],
                 terms_.momentum_at_end(result_.momenta[k], gradient_.by_coordinates[k], false)});
        result_.is_exact = terms_.is_exact();
    }

private:
    /// Writes (4.14c) and (4.14e).
    void write_at_nodes(std::size_t k) {
        const std::string &x = L_.coordinates[k], &v = L_.velocities[k];
        for (std::size_t i = 0; i < rule_.nodes(); ++i)
            if (is_needed(x, gradient_))
                result_.positions.push_back({terms_.name(x, i), terms_.position(x, i)});
        for (std::size_t i = 0; i < rule_.nodes(); ++i)
            result_.positions.push_back({terms_.name(v, i), terms_.velocity(x, i)});
    }

    const GalerkinRule& rule_;
    const Lagrangian& L_;
    const LagrangianGradient& gradient_;
    GalerkinTerms terms_;
    LagrangianEquations& result_;
};

void write(const Tableau& tableau, const Lagrangian& L, const LagrangianGradient& gradient,
           LagrangianEquations& result) {
    LagrangianWriter(tableau, L, gradient, result).write();
}

void write(const GalerkinRule& rule, const Lagrangian& L, const LagrangianGradient& gradient,
           LagrangianEquations& result) {
    GeneralLagrangianWriter(rule, L, gradient, result).write();
}

LagrangianEquations equations(const Method& method, const Lagrangian& L,
                              std::vector<std::string> momenta) {
    LagrangianEquations result;
    static_cast<StepTitle&>(result) = title_of(method, L);
    result.lagrangian = L.expression;
    result.coordinates = L.coordinates;
    result.velocities = L.velocities;
    result.momenta = std::move(momenta);
    const LagrangianGradient slopes = gradient(L);
    for (std::size_t k = 0; k < L.degrees_of_freedom(); ++k)
        result.legendre.push_back({result.momenta[k], slopes.by_velocities[k]});
    return on_new_ground([&](const Ground& ground) {
        LagrangianEquations written = result;
        std::visit([&](const auto& derived) { write(derived, L, slopes, written); },
                   derive_any_on(ground, method).method);
        return written;
    });
}

}  // namespace

LagrangianEquations lagrangian_equations(const Method& method, const Lagrangian& lagrangian) {
    check_regular(lagrangian);
    return equations(method, lagrangian, momentum_names(lagrangian));
}

LagrangianEquations lagrangian_equations(const Method& method, const Hamiltonian& hamiltonian) {
    return equations(method, legendre_transform(hamiltonian), hamiltonian.momenta);
}

}  // namespace hvi::gen
