// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/report/pictures.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/draw/curves.hpp"

namespace hvi::gen {

namespace {

using Curve = CurvesPicture::Curve;

/// Errors over what they cost; points without are left out.
template <class Cost>
CurvesPicture work(const SceneReport& scene, const std::string& axis, Cost cost) {
    CurvesPicture picture{scene.name, axis, "error at the end", true, true, {}};
    for (const WorkCurve& curve : scene.curves) {
        Curve drawn{curve.name, {}, curve.is_peer};
        for (const WorkPoint& point : curve.points) {
            // NOTE: an orbit that got lost is as far away as one likes, and would hide the others.
            const bool is_there = point.ok() && point.error > 0 && point.error < 10;
            if (is_there && cost(point) > 0) drawn.points.emplace_back(cost(point), point.error);
        }
        picture.curves.push_back(std::move(drawn));
    }
    return picture;
}

/// Departures over time, of which `values` are some.
CurvesPicture over_time(const SceneReport& scene, const std::string& axis,
                        std::vector<double> Departures::*values) {
    CurvesPicture picture{scene.name, "t", axis, false, false, {}};
    for (const WorkCurve& curve : scene.curves) {
        const Departures& departures = curve.departures;
        Curve drawn{fmt::format("{}, h = {:.3g}", curve.name, departures.h), {}, curve.is_peer};
        const std::vector<double>& all = departures.*values;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i] > 0 && std::isfinite(all[i]))
                drawn.points.emplace_back(departures.times[i], all[i]);
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
    if (!is_empty(picture)) pictures.push_back({name, draw(picture)});
}

std::vector<Picture> pictures_of(const SceneReport& scene) {
    std::vector<Picture> pictures;
    add(pictures, scene.name + "-1-time",
        work(scene, "run time in seconds", [](const auto& p) { return p.seconds; }));
    add(pictures, scene.name + "-2-evaluations",
        work(scene, "evaluations of dH/dq",
             [](const auto& p) { return static_cast<double>(p.evaluations); }));
    add(pictures, scene.name + "-3-energy",
        over_time(scene, "error of the energy", &Departures::energy));
    add(pictures, scene.name + "-4-invariants",
        over_time(scene, "error of the invariants", &Departures::invariants));
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
