// Extreme orbits: eccentric, of extreme size, with extreme masses, and in collision.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/extreme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/support/bar.hpp"

namespace hvi::gen {

Scene scene_of(const std::string& text) { return scene_from_toml(Source{"scene.toml", text}); }

bool is_whole(const Heard& heard) {
    if (!heard.failure.empty()) return false;
    if (heard.answers.text("status") != "ok") return heard.answers.integer("untouched") == 1;
    const std::vector<double> end = heard.answers.numbers("end");
    return std::all_of(end.begin(), end.end(), [](double x) { return std::isfinite(x); });
}

std::string end_text(const Heard& heard) {
    if (!heard.failure.empty()) return heard.failure;
    const std::string status = heard.answers.text("status");
    if (status == "ok") return is_whole(heard) ? "ok" : "ok, and not finite";
    return fmt::format("after {} steps {}, the state {}", heard.answers.integer("steps"), status,
                       heard.answers.integer("untouched") == 1 ? "untouched" : "changed");
}

CurvesPicture::Curve& curve_of(const ExtremeMethod& method, EdgeChapter& chapter,
                               const CurvesPicture& picture) {
    auto found =
        std::find_if(chapter.pictures.begin(), chapter.pictures.end(),
                     [&](const CurvesPicture& each) { return each.title == picture.title; });
    if (found == chapter.pictures.end())
        found = chapter.pictures.insert(chapter.pictures.end(), picture);
    return found->curves.emplace_back(CurvesPicture::Curve{method.name, {}});
}

EdgeChapter extreme(Builds& builds, const std::vector<ExactMethod>& methods) {
    EdgeChapter chapter{
        "extreme",
        "Extreme orbits",
        "Passages of the pericentre of Kepler's problem, from a right angle before it to one after "
        "it: by symmetry the end is the mirrored beginning, and Kepler's equation tells the time. "
        "The errors have to fall with the order of the method, which its exact coefficients tell, "
        "and the literature of a composition, down to round-off. In steps that do not resolve the "
        "pericentre, in falls into the centre "
        "and among three bodies that meet, all that is asked for is a finite state, or a status "
        "and the state untouched, and an end. H scaled by a power of two, with h divided by it, is "
        "the same map, of which each bit is asked for. Where one of two bodies is 1e-12 of the "
        "other their relative motion is Kepler's. The total momentum and the total angular "
        "momentum are invariants that these methods conserve: up to round-off, a few units in the "
        "largest numbers for each step, and for each of the steps that a composition consists of.",
        {},
        {}};
    std::vector<ExtremeMethod> all;
    for (const ExactMethod& method : methods)
        all.push_back({method.name(), method.parts(), known_order(method),
                       kepler_program(builds, method), scaled_forms(builds, method),
                       two_bodies_program(builds, method), three_bodies_program(builds, method)});
    Bar bar;
    double done = 0;
    for (const ExtremeMethod& method : all) {
        bar.show(done++ / static_cast<double>(all.size()), "extreme orbits: " + method.name);
        add_kepler(method, chapter);
        add_scaled(method, chapter);
        add_bodies(method, chapter);
    }
    return chapter;
}

}  // namespace hvi::gen
