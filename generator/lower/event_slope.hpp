// Derivatives of events: by variables, by the time, and along the motion.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/lower/lowered_events.hpp"

namespace hvi::gen {

/// Returns, by the number of each node, whether the values depend on it; the nodes of the values
/// are included.
[[nodiscard]] std::vector<bool> nodes_of(const Graph& graph, const std::vector<Scaled>& values);

/// Returns dq/dt = dH/dp and dp/dt = -dH/dq for variables with these numbers. H is differentiated
/// only by their conjugates. Precondition: H is in the graph of the events, and so are the
/// variables that it depends on.
[[nodiscard]] EventMotion motion_under(LoweredEvents& events, const Scaled& hamiltonian,
                                       const std::vector<std::size_t>& numbers);

/// Sets the derivatives of `zero`, and its slope: {zero, H} plus the derivative by the time. With g
/// for `zero`, and velocities that are solved for, so that p = dL/dv(q, v),
///
///     dv = M^-1 (dp - d2L/dvdq dq - d2L/dvdt dt), where M = d2L/dv2,
///     dg = dg/dq dq + dg/dt dt + w (dp - d2L/dvdq dq - d2L/dvdt dt), where M w = dg/dv.
///
/// Precondition: the motion has each variable that `zero` depends on.
void differentiate(LoweredEvents& events, LoweredEvent& event);

}  // namespace hvi::gen
