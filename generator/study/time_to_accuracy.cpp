// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/time_to_accuracy.hpp"

#include <algorithm>
#include <cmath>

namespace hvi::gen {

namespace {

bool is_timed(const WorkPoint& point) { return point.ok() && point.seconds > 0; }

/// Between a run that misses the accuracy and one that reaches it.
double seconds_between(const WorkPoint& missed, const WorkPoint& reached, double accuracy) {
    constexpr double least = 1e-17;  // of errors, as the logarithm of 0 has no place on the line
    const double part =
        std::log(missed.error / accuracy) / std::log(missed.error / std::max(reached.error, least));
    return missed.seconds * std::pow(reached.seconds / missed.seconds, part);
}

std::optional<Quickest> first(const std::vector<Quickest>& in_order, bool is_peer) {
    const auto found = std::find_if(in_order.begin(), in_order.end(),
                                    [&](const Quickest& each) { return each.is_peer == is_peer; });
    return found == in_order.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<double> seconds_to(const WorkCurve& curve, double accuracy) {
    std::optional<double> least;
    const WorkPoint* before = nullptr;
    for (const WorkPoint& point : curve.points) {
        if (!is_timed(point)) continue;
        if (point.error <= accuracy) {
            const bool is_between = before != nullptr && before->error > accuracy;
            const double seconds =
                is_between ? std::min(seconds_between(*before, point, accuracy), point.seconds)
                           : point.seconds;
            if (!least || seconds < *least) least = seconds;
        }
        before = &point;
    }
    return least;
}

std::vector<Quickest> in_order_of_time(const SceneReport& scene, double accuracy) {
    std::vector<Quickest> result;
    for (const WorkCurve& curve : scene.curves)
        if (const auto seconds = seconds_to(curve, accuracy))
            result.push_back({curve.name, *seconds, curve.is_peer});
    std::stable_sort(result.begin(), result.end(),
                     [](const Quickest& a, const Quickest& b) { return a.seconds < b.seconds; });
    return result;
}

std::vector<TimeToAccuracy> times_to_accuracies(const SceneReport& scene) {
    std::vector<TimeToAccuracy> times;
    for (const double accuracy : {1e-4, 1e-8, 1e-11}) {
        const std::vector<Quickest> all = in_order_of_time(scene, accuracy);
        times.push_back({accuracy, first(all, false), first(all, true)});
    }
    return times;
}

}  // namespace hvi::gen
