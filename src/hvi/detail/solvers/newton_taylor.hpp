// Fixed points with first-order corrections of the forces between evaluations.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/fixed_point.hpp>

namespace hvi {
namespace detail {

/// Places Q of the last evaluations of dH/dq, their results Lp, and what the derivative of dH/dq
/// shares with them.
template <class System, std::size_t stages>
struct Tangents {
    std::array<typename System::Vector, stages> Q{}, Lp{};
    std::array<typename System::Tangent, stages> at{};
};

}  // namespace detail

/// Solver policy of steppers of scenes with quadratic kinetic energy. A sweep with dH/dq + d2H/dq2
/// (Q - Q_0) follows each evaluation of dH/dq, Q_0 being the place of that evaluation: the first
/// term of the Neumann series of Newton's method. The same solution takes fewer evaluations, which
/// pays where d2H/dq2 times a vector, and a sweep, cost much less than dH/dq. More sweeps save
/// fewer evaluations than they cost.
struct NewtonTaylor {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    using Iteration = detail::Sweeps<Vector, true>;
};

}  // namespace hvi
