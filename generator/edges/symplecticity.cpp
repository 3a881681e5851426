// Whether the derivative of a step is symplectic.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/edges/edges.hpp"
#include "generator/edges/program.hpp"
#include "generator/support/bar.hpp"

namespace hvi::gen {

namespace {

EdgeCheck check(const std::string& method, const Scene& scene, long steps,
                const EdgeProgram& program) {
    const double h = usual_step(scene);
    const Heard heard = program.ask({fmt::format("{}", h), std::to_string(steps)});
    EdgeCheck check{
        method, scene.name,    fmt::format("{} {} of {}", steps, steps == 1 ? "step" : "steps", h),
        "",     heard.failure, false};
    if (!heard.failure.empty()) return check;
    const auto bits = static_cast<int>(heard.answers.integer("bits"));
    // NOTE: differences with a distance of eps^(1/4) lose a quarter of the digits; and rounding
    // errors of many steps, their growth, and the fifth derivatives take some more.
    const double bound = 1e5 * std::pow(2.0, 0.75 * (1 - bits));
    check.expected = fmt::format("below {:.0e}, in {} bits", bound, bits);
    if (!heard.answers.has("defect")) {
        check.seen = "a step that fails";
        return check;
    }
    const double defect = heard.answers.number("defect");
    check.seen = fmt::format("{:.1e}", defect);
    check.agrees = defect < bound;
    return check;
}

}  // namespace

EdgeChapter symplecticity(const Compiler& compiler, const std::vector<Method>& methods) {
    EdgeChapter chapter{
        "symplecticity",
        "Symplecticity",
        "The largest entry of D^T J D - J, where D is the derivative of the map of the steps, "
        "divided by the square of the largest entry of D where that is above 1. All these methods "
        "are symplectic by their exact coefficients. D is a difference quotient of order four in "
        "the widest numbers that the compiler has, not exact: so this shows symplecticity to the "
        "digits that are said, of steps in these numbers, and proves nothing beyond.",
        {},
        {}};
    Bar bar;
    double done = 0;
    const double all = static_cast<double>(methods.size() * edge_scenes.size());
    for (const Method& method : methods) {
        const std::string name = method.name;
        for (const std::string scene_name : edge_scenes) {
            bar.show(done++ / all, fmt::format("symplecticity: {}, {}", name, scene_name));
            const Scene scene = edge_scene(scene_name);
            const EdgeProgram program = EdgeProgram::symplectic(compiler, method, scene);
            for (const long steps : {1L, 1000L})
                chapter.checks.push_back(check(name, scene, steps, program));
        }
    }
    return chapter;
}

}  // namespace hvi::gen
