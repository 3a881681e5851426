// Newton's method for systems in which each degree of freedom is coupled with few others.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/linear/sparse_lu.hpp>
#include <hvi/detail/solvers/newton_structured.hpp>

namespace hvi {

/// Solver policy of steppers of lattices and the like with quadratic kinetic energy. Needs Eigen.
struct NewtonOfSparse {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration =
        detail::NewtonLoop<Vector, detail::FactoredEquations<Vector, detail::SparseLuFactors>>;
};

}  // namespace hvi
