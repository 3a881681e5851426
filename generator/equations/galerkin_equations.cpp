// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/galerkin_equations.hpp"

namespace hvi::gen {

namespace {

class GalerkinWriter {
public:
    GalerkinWriter(const GalerkinRule& rule, const Hamiltonian& H, const Gradient& gradient)
        : rule_(rule),
          H_(H),
          gradient_(gradient),
          terms_(rule, H.coordinates, varying(H), symbols_in(H.expression)) {}

    [[nodiscard]] GalerkinEquations equations() {
        GalerkinEquations result;
        if (is_needed("t")) result.positions = terms_.times();
        for (std::size_t k = 0; k < H_.degrees_of_freedom(); ++k) write_positions(result, k);
        for (std::size_t k = 0; k < H_.degrees_of_freedom(); ++k) write_conditions(result, k);
        for (const std::string& x : H_.coordinates)
            result.update.push_back({x, terms_.position_at_end(x)});
        for (std::size_t k = 0; k < H_.degrees_of_freedom(); ++k)
            result.update.push_back(
                {H_.momenta[k],
                 terms_.momentum_at_end(H_.momenta[k], gradient_.by_coordinates[k], true)});
        result.is_exact = terms_.is_exact();
        return result;
    }

private:
    static std::vector<std::string> varying(const Hamiltonian& H) {
        std::vector<std::string> names = variables(H);
        if (depends_on_time(H)) names.push_back("t");
        return names;
    }

    [[nodiscard]] bool is_needed(const std::string& variable) const {
        return occurs_in(variable, gradient_.by_coordinates) ||
               occurs_in(variable, gradient_.by_momenta);
    }

    /// Writes (4.6c).
    void write_positions(GalerkinEquations& result, std::size_t k) {
        const std::string& x = H_.coordinates[k];
        if (!is_needed(x)) return;
        for (std::size_t i = 0; i < rule_.nodes(); ++i)
            result.positions.push_back({terms_.name(x, i), terms_.position(x, i)});
    }

    /// Writes (4.6d), then (4.6e).
    void write_conditions(GalerkinEquations& result, std::size_t k) {
        const std::string& p = H_.momenta[k];
        for (std::size_t j = 0; j < rule_.functions(); ++j)
            result.conditions.push_back(
                terms_.condition(Expression::symbol(p), p, gradient_.by_coordinates[k], true, j));
        for (std::size_t i = 0; i < rule_.nodes(); ++i)
            result.conditions.push_back({terms_.velocity(H_.coordinates[k], i),
                                         terms_.at_node(gradient_.by_momenta[k], i)});
    }

    const GalerkinRule& rule_;
    const Hamiltonian& H_;
    const Gradient& gradient_;
    GalerkinTerms terms_;
};

}  // namespace

GalerkinEquations galerkin_equations(const GalerkinRule& rule, const Hamiltonian& hamiltonian,
                                     const Gradient& gradient) {
    return GalerkinWriter(rule, hamiltonian, gradient).equations();
}

}  // namespace hvi::gen
