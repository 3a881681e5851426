// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/gradient.hpp"

#include "generator/hamiltonian/algebra.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

Gradient gradient(const Hamiltonian& hamiltonian) {
    const Progress::Stage stage("differentiating the Hamiltonian");
    const Algebra algebra(hamiltonian);
    Gradient result;
    for (const GiNaC::symbol& variable : algebra.variables()) {
        const bool is_coordinate = result.by_coordinates.size() < hamiltonian.degrees_of_freedom();
        auto& derivatives = is_coordinate ? result.by_coordinates : result.by_momenta;
        derivatives.push_back(algebra.written(algebra.derivative(algebra.hamiltonian(), variable)));
    }
    return result;
}

}  // namespace hvi::gen
