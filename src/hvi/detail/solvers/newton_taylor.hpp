// Fixed points with first-order corrections of the forces between evaluations.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/fixed_point.hpp>

namespace hvi {
namespace detail {

/// Where dH/dq was last evaluated, what it was there, and what its derivative shares with it.
template <class System, std::size_t stages>
struct Tangents {
    std::array<typename System::Vector, stages> Q{}, Lp{};
    std::array<typename System::Tangent, stages> at{};
};

}  // namespace detail

/// Solver policy of steppers of scenes with quadratic kinetic energy. Between two evaluations of
/// dH/dq there is a sweep with dH/dq + d2H/dq2 (Q - Q_0), Q_0 being the place of the last
/// evaluation: the first term of the Neumann series of Newton's method. Fewer evaluations to the
/// same end; it pays where d2H/dq2 times a vector, and a sweep, cost much less than dH/dq. More
/// sweeps save fewer evaluations than they cost.
struct NewtonTaylor {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    using Iteration = detail::Sweeps<Vector, true>;
};

}  // namespace hvi
