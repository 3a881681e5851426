// Checks that the derivative of a step is symplectic.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/edges/edges.hpp"
#include "generator/edges/method_on_scene.hpp"

namespace hvi::gen {

namespace {

/// Returns a bound of the effect of rounding, beside |D|^T |J| |D|. A step solves its equations up
/// to changes of 8 units in the last place (src/hvi/fixed_point.hpp), which are 16 of 2^-53. Such
/// an error of D is twice in D^T J D, and each sum of its products is rounded once for each term.
/// Where velocities are solved for, momenta have this error, and velocities this error times the
/// condition number of d2L/dv2. Charts of rotations are a dozen products more, back and forth.
double bound_of(const Scene& scene, long steps, double condition) {
    const auto terms = static_cast<double>(variables(unrolled(scene)).size());
    const double of_charts = scene.rotations.texts.empty() ? 1 : 4;
    return std::ldexp(2 * 16 * condition * of_charts * static_cast<double>(steps) + terms, -53);
}

EdgeCheck check(const MethodOnScene& subject, long steps) {
    const auto& [method, scene, program] = subject;
    const double h = usual_step(scene);
    const Heard heard = program.ask({fmt::format("{}", h), std::to_string(steps)});
    const bool has_ended = heard.failure.empty();
    const double bound = bound_of(scene, steps * static_cast<long>(method.parts()),
                                  has_ended ? heard.answers.number("condition") : 1);
    EdgeCheck check{method.name(),
                    scene.name,
                    fmt::format("{} {} of {}", steps, steps == 1 ? "step" : "steps", h),
                    fmt::format("below {:.1e}", bound),
                    heard.failure,
                    false};
    if (!has_ended) return check;
    if (!heard.answers.has("defect")) {
        check.seen = "no derivative: a step ends with a status";
        check.agrees = true;
        return check;
    }
    const double defect = heard.answers.number("defect");
    check.seen = fmt::format("{:.1e}", defect);
    check.agrees = defect < bound;
    return check;
}

}  // namespace

EdgeChapter symplecticity(Builds& builds, const std::vector<ExactMethod>& methods,
                          const std::vector<Scene>& scenes) {
    EdgeChapter chapter{
        "symplecticity",
        "Symplecticity",
        "The largest entry of D^T J D - J, where D is the derivative of the map of the steps, "
        "beside that of |D|^T |J| |D| where it was largest on the way. All these methods are "
        "symplectic by their exact coefficients: what is seen should be rounding alone, which is "
        "32 times 2^-53 a step at most where each step, and each that a composition consists of, "
        "leaves D right to 8 units in the last place; of a Lagrangian, where these are units of "
        "momenta, times the condition number of d2L/dv2, and of rotations four times as much, for "
        "the "
        "functions of their charts. There D is by canonical coordinates of both ends. D is no "
        "difference quotient: dual numbers "
        "take the code that computes in double "
        "through its steps and differentiate each of its operations exactly, up to their rounding. "
        "So this shows that the code is symplectic up to rounding where it was run: from the start "
        "of each scene, with the step that the scene asks for; where one of these ends with a "
        "status "
        "there is no derivative.",
        {},
        {}};
    add_cases(
        chapter, methods, scenes,
        [&](const ExactMethod& method, const Scene& scene) {
            return EdgeProgram::symplectic(builds, method, scene);
        },
        [](const MethodOnScene& subject) {
            return std::vector{check(subject, 1), check(subject, 1000)};
        });
    return chapter;
}

}  // namespace hvi::gen
