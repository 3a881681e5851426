// Integrators of other libraries in a report.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "generator/simulate/peers.hpp"
#include "generator/study/work.hpp"

namespace hvi::gen {

/// A curve of one of them, and how its runs are made again.
struct PeerCurve {
    WorkCurve curve;
    MeasureAgain again;
};

/// Measures all integrators of the library that apply to the scene. The program is made of
/// `stepper`, which is made for peers, and the library's driver. Throws what ask() does.
[[nodiscard]] std::vector<PeerCurve> peer_curves(const std::filesystem::path& program,
                                                 const PeerLibrary& library,
                                                 const SceneStepper& stepper, const Course& course);

}  // namespace hvi::gen
