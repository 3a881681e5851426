// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/gradient.hpp"

#include "generator/hamiltonian/algebra.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Returns the derivatives by n variables from number `begin` on.
std::vector<Expression> derivatives(const Algebra& algebra, std::size_t begin, std::size_t n) {
    std::vector<Expression> result;
    for (std::size_t i = begin; i < begin + n; ++i)
        result.push_back(
            algebra.written(algebra.derivative(algebra.function(), algebra.variables()[i])));
    return result;
}

}  // namespace

Gradient gradient(const Hamiltonian& hamiltonian) {
    const Progress::Stage stage("differentiating the Hamiltonian");
    const Algebra algebra(hamiltonian);
    const std::size_t n = hamiltonian.degrees_of_freedom();
    return {derivatives(algebra, 0, n), derivatives(algebra, n, n)};
}

LagrangianGradient gradient(const Lagrangian& lagrangian) {
    const Progress::Stage stage("differentiating the Lagrangian");
    const Algebra algebra(lagrangian);
    const std::size_t n = lagrangian.degrees_of_freedom();
    return {derivatives(algebra, 0, n), derivatives(algebra, n, n)};
}

}  // namespace hvi::gen
