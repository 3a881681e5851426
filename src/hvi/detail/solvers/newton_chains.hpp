// Newton's method for chains: the matrix is a band.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/linear/band.hpp>
#include <hvi/detail/solvers/newton_structured.hpp>

namespace hvi {

/// Solver policy of steppers of chains and rings of any length with quadratic kinetic energy.
struct NewtonOfChains {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration =
        detail::NewtonLoop<Vector, detail::FactoredEquations<Vector, detail::BandFactors>>;
};

}  // namespace hvi
