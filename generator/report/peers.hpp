// Integrators of other libraries in a report.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/program/compiler.hpp"
#include "generator/read/scene.hpp"
#include "generator/report/work.hpp"
#include "generator/simulate/peers.hpp"

namespace hvi::gen {

/// Of all that apply to the scene. Throws what stepper_for_peers(), built_program() and ask() do.
[[nodiscard]] std::vector<WorkCurve> peer_curves(const Compiler& compiler,
                                                 const PeerLibrary& library, const Scene& scene,
                                                 const Course& course);

}  // namespace hvi::gen
