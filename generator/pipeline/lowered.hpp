// A scene on its way to steppers, as all methods take it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/lower/gradient_kernels.hpp"
#include "generator/lower/system.hpp"
#include "generator/read/unrolling.hpp"

namespace hvi::gen {

/// A scene with checked words and an initial state, and its system.
struct LoweredScene {
    Scene scene;
    UnrollDecision unrolling;
    std::optional<WrittenOutScene> written;  ///< where sums are written out
    System system;
    GradientKernels gradients;  ///< where sums are written out

    [[nodiscard]] Place place() const { return whole(scene.function.source); }  ///< of H or L
};

/// Lowers a scene. Throws InputError and MathError for a word without a meaning, a scene that
/// cannot start, an L whose Legendre transform is not regular, and as system_of() does.
[[nodiscard]] LoweredScene lowered(const Scene& scene, const UnrollWish& wish = {});

/// Lowers a scene whose sums stay loops, or are written out, as was decided.
[[nodiscard]] LoweredScene lowered_with_loops(const Scene& scene, const UnrollDecision& decision,
                                              const std::vector<SystemPass>& passes = {});
[[nodiscard]] LoweredScene lowered_written_out(const Scene& scene, WrittenOutScene written,
                                               const UnrollDecision& decision,
                                               const std::vector<SystemPass>& passes = {});

}  // namespace hvi::gen
