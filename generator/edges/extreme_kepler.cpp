// Kepler's problem on eccentric orbits, and the fall into the centre.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/edges/extreme.hpp"
#include "generator/edges/passage.hpp"

namespace hvi::gen {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr const char* kepler_scene = "kepler";
constexpr double most_eccentric = 0.9999;

void add_passage(const ExtremeMethod& method, const EdgeProgram& program, double e,
                 EdgeChapter& chapter) {
    const Passage passage(e);
    const Refinement refinement = refined(passage, program, method.parts, passage.begin(), {},
                                          [](const auto& end) { return end; });
    chapter.checks.push_back(order_check(method.name, method.order, kepler_scene,
                                         fmt::format("e = {}: past the pericentre", e),
                                         refinement));
    if (e != most_eccentric) return;  // the others look alike in these units
    CurvesPicture::Curve& curve =
        curve_of(method, chapter,
                 {fmt::format("Past the pericentre, e = {}", e), "steps", "error", true, true, {}});
    for (const auto& point : refinement.errors)
        if (point.second > 0) curve.points.push_back(point);
}

/// Adds runs from the apocentre once around. Only the largest numbers of steps resolve the
/// pericentre.
void add_orbit(const ExtremeMethod& method, const EdgeProgram& program, double e,
               EdgeChapter& chapter) {
    const std::vector<double> apocentre{-(1 + e), 0, 0, -std::sqrt((1 - e) / (1 + e))};
    CurvesPicture::Curve& curve = curve_of(method, chapter,
                                           {fmt::format("Once around, e = {}", e),
                                            "steps an orbit",
                                            "largest relative error of the energy",
                                            true,
                                            true,
                                            {}});
    int all = 0, ok = 0, stopped = 0;
    std::string wrong;
    for (long steps = 4; steps <= 4096; steps *= 2, ++all) {
        const Heard heard =
            program.ask("advance", 2 * pi / static_cast<double>(steps), steps, apocentre);
        if (!is_whole(heard)) {
            if (wrong.empty()) wrong = fmt::format("; in {} steps {}", steps, end_text(heard));
            continue;
        }
        ++(heard.answers.text("status") == "ok" ? ok : stopped);
        const double error = heard.answers.number("energy_error") / 0.5;
        if (heard.answers.text("status") == "ok" && error > 0 && std::isfinite(error))
            curve.points.emplace_back(static_cast<double>(steps), error);
    }
    chapter.checks.push_back(
        {method.name, kepler_scene, fmt::format("e = {}: once around in 4, 8, ... 4096 steps", e),
         std::string(ends_well),
         fmt::format("ok in {}, a status in {} of {}{}", ok, stopped, all, wrong),
         ok + stopped == all});
}

/// Adds a fall from rest at (1, 0). By symmetry no method leaves the axis, and 0 times a finite
/// number is 0.
void add_fall(const ExtremeMethod& method, const EdgeProgram& program, double h, double mu,
              const std::string& what, EdgeChapter& chapter) {
    const Heard heard = program.ask("advance", h, 1000, {1, 0, 0, 0}, {mu, 0});
    EdgeCheck check{method.name,     kepler_scene,   what, std::string(ends_well) + ", on the axis",
                    end_text(heard), is_whole(heard)};
    if (heard.failure.empty()) {
        const std::vector<double> end = heard.answers.numbers("end");
        const bool on_axis = end.at(1) == 0 && end.at(3) == 0;
        check.seen += on_axis ? ", on the axis" : ", off the axis";
        check.agrees = check.agrees && on_axis;
    }
    chapter.checks.push_back(std::move(check));
}

}  // namespace

EdgeProgram kepler_program(Builds& builds, const ComposedMethod& method) {
    return {builds, method, edge_scene(kepler_scene)};
}

void add_kepler(const ExtremeMethod& method, EdgeChapter& chapter) {
    const EdgeProgram& program = method.kepler;
    for (const double e : {0.9, 0.99, 0.999, most_eccentric}) {
        add_passage(method, program, e, chapter);
        add_orbit(method, program, e, chapter);
    }
    add_fall(method, program, 0.0078125, 1, "a fall from rest, steps of 0.0078125", chapter);
    // NOTE: the first step of Stormer-Verlet ends in the centre: 1 - h^2 mu/2 = 0.
    add_fall(method, program, 1, 2, "a fall from rest, a step of 1 with mu = 2", chapter);
}

}  // namespace hvi::gen
