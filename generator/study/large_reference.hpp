// The solution that methods on a scene of any size are measured against.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

#include "generator/program/builds.hpp"
#include "generator/program/private_directory.hpp"
#include "generator/read/scene.hpp"
#include "generator/study/contender.hpp"
#include "generator/study/curves.hpp"
#include "generator/study/work.hpp"

namespace hvi::gen {

/// An end that is in a file: programs read it there, as it is long.
class LargeReference {
public:
    /// Orders the program. Throws what scene_stepper() does, for the scene's [exact] too.
    LargeReference(Builds& builds, const Scene& scene, double until);

    void wait() const { static_cast<void>(built(build_)); }

    /// The scene's exact solution at its end, or one by a method of high order in long double, with
    /// steps halved until the end does not move, or for so many seconds. `count` are the scene's
    /// own steps. Throws MathError where no run comes to the end, and as ask() does.
    [[nodiscard]] Reference compute(std::int64_t count, double seconds = 30) const;

    /// Measures runs of a method. Precondition: compute().
    [[nodiscard]] MeasureSteps measured(const Contender& contender) const;

private:
    double until_;
    std::string method_;  ///< empty where the solution is exact
    Build build_;
    FreshDirectory directory_;
    std::filesystem::path file_;
};

}  // namespace hvi::gen
