// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/report/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/draw/curves.hpp"

namespace hvi::gen {

namespace {

using Curve = CurvesPicture::Curve;

constexpr std::size_t parts_shown = 100;

/// NOTE: an orbit that got lost is as far away as one likes, and would hide the others.
bool is_drawn(const WorkPoint& point) { return point.ok() && point.error > 0 && point.error < 10; }

/// Errors over what they cost; points without are left out.
template <class Cost>
CurvesPicture work(const SceneReport& scene, const std::string& what, const std::string& axis,
                   Cost cost) {
    CurvesPicture picture{scene.name + ": error against " + what,
                          axis,
                          "error at the end",
                          true,
                          true,
                          {},
                          "noisy run time"};
    for (const WorkCurve& curve : scene.curves) {
        Curve drawn{curve.name, {}, curve.is_peer};
        for (const WorkPoint& point : curve.points)
            if (is_drawn(point) && cost(point) > 0)
                drawn.points.emplace_back(cost(point), point.error);
        picture.curves.push_back(std::move(drawn));
    }
    return picture;
}

/// Rings around run times that are noisy. Precondition: the curves are those of the scene.
void add_rings(CurvesPicture& picture, const SceneReport& scene) {
    for (std::size_t i = 0; i < scene.curves.size(); ++i)
        for (const WorkPoint& point : scene.curves[i].points)
            if (is_drawn(point) && point.is_noisy())
                picture.curves[i].ringed.emplace_back(point.seconds, point.error);
}

/// Departures over time, of which `values` are some: the largest in each hundredth of the run, as a
/// line through all of them would be a bar.
CurvesPicture over_time(const SceneReport& scene, const std::string& what,
                        std::vector<double> Departures::*values) {
    CurvesPicture picture{
        scene.name + ": " + what + " over time", "t", "error of the " + what, false, false, {}};
    for (const WorkCurve& curve : scene.curves) {
        const Departures& departures = curve.departures;
        Curve drawn{fmt::format("{}, h = {:.3g}", curve.name, departures.h), {}, curve.is_peer};
        const std::vector<double>& all = departures.*values;
        for (std::size_t k = 0; k < parts_shown; ++k) {
            const std::size_t end = (k + 1) * all.size() / parts_shown;
            double largest = 0;
            for (std::size_t i = k * all.size() / parts_shown; i < end; ++i)
                if (std::isfinite(all[i])) largest = std::max(largest, all[i]);
            if (largest > 0) drawn.points.emplace_back(departures.times[end - 1], largest);
        }
        picture.curves.push_back(std::move(drawn));
    }
    return picture;
}

bool is_empty(const CurvesPicture& picture) {
    for (const Curve& curve : picture.curves)
        if (!curve.points.empty()) return false;
    return true;
}

void add(std::vector<Picture>& pictures, const std::string& name, const CurvesPicture& picture) {
    if (!is_empty(picture)) pictures.push_back({name, picture.title, draw(picture)});
}

std::vector<Picture> pictures_of(const SceneReport& scene) {
    std::vector<Picture> pictures;
    CurvesPicture times =
        work(scene, "run time", "run time in seconds", [](const auto& p) { return p.seconds; });
    add_rings(times, scene);
    add(pictures, scene.name + "-1-time", times);
    add(pictures, scene.name + "-2-evaluations",
        work(scene, "evaluations", "evaluations of dH/dq",
             [](const auto& p) { return static_cast<double>(p.evaluations); }));
    add(pictures, scene.name + "-3-energy", over_time(scene, "energy", &Departures::energy));
    add(pictures, scene.name + "-4-invariants",
        over_time(scene, "invariants", &Departures::invariants));
    return pictures;
}

std::vector<Picture> pictures_of(const EdgeChapter& chapter) {
    std::vector<Picture> pictures;
    for (const CurvesPicture& picture : chapter.pictures)
        add(pictures, fmt::format("edges-{}-{}", chapter.name, pictures.size() + 1), picture);
    return pictures;
}

}  // namespace

Pictures report_pictures(const Report& report) {
    Pictures pictures;
    for (const SceneReport& scene : report.scenes) pictures.of_scenes.push_back(pictures_of(scene));
    for (const EdgeChapter& chapter : report.edges)
        pictures.of_edges.push_back(pictures_of(chapter));
    return pictures;
}

}  // namespace hvi::gen
