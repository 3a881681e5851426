// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/lagrangian_equations.hpp"

#include <set>
#include <utility>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/hamiltonian/legendre.hpp"

namespace hvi::gen {

namespace {

/// The names of the values in the stages of coordinates, velocities, and the time where it occurs.
std::vector<StageNames>
names_in_stages(const Lagrangian& L, const std::vector<std::string>& momenta, std::size_t stages) {
    std::vector<std::string> varying = variables(L);
    if (depends_on_time(L)) varying.push_back("t");
    std::set<std::string> taken = symbols_in(L.expression);
    taken.insert(varying.begin(), varying.end());
    taken.insert(momenta.begin(), momenta.end());
    return stage_names(varying, taken, stages);
}

class LagrangianWriter {
public:
    LagrangianWriter(const ButcherPair& pair, const Lagrangian& L, LagrangianEquations& result)
        : pair_(pair),
          L_(L),
          gradient_(gradient(L)),
          terms_(names_in_stages(L, result.momenta, pair.stages())),
          result_(result) {}

    void write() {
        for (std::size_t k = 0; k < L_.degrees_of_freedom(); ++k)
            result_.legendre.push_back({result_.momenta[k], gradient_.by_velocities[k]});
        if (is_needed("t"))
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
    [[nodiscard]] bool is_needed(const std::string& variable) const {
        return occurs_in(variable, gradient_.by_coordinates) ||
               occurs_in(variable, gradient_.by_velocities);
    }

    void write_stages(std::size_t k) {
        for (std::size_t i = 0; i < pair_.stages(); ++i) {
            if (is_needed(L_.coordinates[k]))
                result_.positions.push_back(
                    {terms_.name(L_.coordinates[k], i), position(k, pair_.A[i])});
            result_.velocities_in_stages.push_back(
                {terms_.in_stage(gradient_.by_velocities[k], i), momentum(k, pair_.A_tilde[i])});
        }
    }

    /// q + h sum_j row_j V^j
    [[nodiscard]] Expression position(std::size_t k, const NumberVector& row) {
        return terms_.moved(Expression::symbol(L_.coordinates[k]),
                            Expression::symbol(L_.velocities[k]), terms_.written(row), false);
    }

    /// p + h sum_j row_j dL/dq(Q^j, V^j)
    [[nodiscard]] Expression momentum(std::size_t k, const NumberVector& row) {
        return terms_.moved(Expression::symbol(result_.momenta[k]), gradient_.by_coordinates[k],
                            terms_.written(row), false);
    }

    const ButcherPair& pair_;
    const Lagrangian& L_;
    LagrangianGradient gradient_;
    StageTerms terms_;
    LagrangianEquations& result_;
};

LagrangianEquations equations(const Method& method, const Lagrangian& L,
                              std::vector<std::string> momenta) {
    LagrangianEquations result;
    static_cast<StepTitle&>(result) = title_of(method, L);
    result.lagrangian = L.expression;
    result.coordinates = L.coordinates;
    result.velocities = L.velocities;
    result.momenta = std::move(momenta);
    return on_new_ground([&](const Ground& ground) {
        const Derivation derivation = derive_on(ground, method);
        LagrangianWriter(derivation.tableau, L, result).write();
        return result;
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
