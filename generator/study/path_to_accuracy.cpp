// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/path_to_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hvi::gen {

namespace {

constexpr double close_by = 1.04;  // so near to the fewest steps is near enough
constexpr std::size_t most_points = 24;
constexpr double most_steps_of_path = 1e8;
constexpr double rough = 0.1;       // from here down an error is one of an order
constexpr double round_off = 1e-6;  // from here down errors may have ended to fall

bool is_reached(const WorkPoint& point, double accuracy) {
    return point.ok() && point.error <= accuracy;
}

double order_of(const WorkCurve& curve) { return std::max(1, curve.order); }

/// The runs on both sides of the accuracy: the one with the fewest steps that reaches it, and the
/// last before it.
struct Sides {
    const WorkPoint* before = nullptr;
    const WorkPoint* reached = nullptr;
};

Sides sides(const WorkCurve& curve, double accuracy) {
    Sides result;
    for (const WorkPoint& point : curve.points) {
        if (is_reached(point, accuracy)) {
            result.reached = &point;
            break;
        }
        result.before = &point;
    }
    return result;
}

/// The factor on the number of steps that makes the wanted error of another.
double ratio_of_steps(double error, double wanted, double slope) {
    return std::pow(error / wanted, 1 / slope);
}

/// Whether errors have ended to fall: two runs with more steps than the best are no better.
bool is_at_round_off(const WorkCurve& curve) {
    const WorkPoint* best = nullptr;
    int behind = 0;
    for (const WorkPoint& point : curve.points) {
        if (!point.ok()) continue;
        const bool is_better = best == nullptr || point.error < best->error / 2;
        behind = is_better ? 0 : behind + 1;
        if (is_better) best = &point;
    }
    return best != nullptr && best->error < round_off && behind >= 2;
}

/// The slope between two runs, where it is one.
double slope(const WorkPoint& coarse, const WorkPoint& fine, double order) {
    const double seen =
        std::log(coarse.error / fine.error) /
        std::log(static_cast<double>(fine.steps) / static_cast<double>(coarse.steps));
    return std::clamp(seen, order / 2, 3 * order);
}

/// Between the two: by the secant, but well inside.
double inside(const Sides& sides, double wanted, double order) {
    constexpr double margin = 0.15;
    const auto low = static_cast<double>(sides.before->steps);
    const auto high = static_cast<double>(sides.reached->steps);
    const double width = std::log(high / low);
    if (!sides.before->ok()) return std::sqrt(low * high);
    const double back = std::log(wanted / std::max(sides.reached->error, wanted * 1e-6)) /
                        slope(*sides.before, *sides.reached, order) / width;
    return high * std::exp(-width * std::clamp(back, margin, 1 - margin));
}

/// Towards more steps than any so far.
double beyond(const WorkCurve& curve, double wanted, double order) {
    constexpr double most = 8, least = 1.1;
    const WorkPoint& last = curve.points.back();
    const auto steps = static_cast<double>(last.steps);
    if (!last.ok() || last.error > rough) return 2 * steps;
    double fall = order;
    if (curve.points.size() > 1) {
        const WorkPoint& other = curve.points[curve.points.size() - 2];
        if (other.ok() && other.error < rough) fall = slope(other, last, order);
    }
    return steps * std::clamp(ratio_of_steps(last.error, wanted, fall), least, most);
}

}  // namespace

void add_point(WorkCurve& curve, const WorkPoint& point) {
    auto& points = curve.points;
    const auto place = std::find_if(points.begin(), points.end(), [&](const WorkPoint& each) {
        return each.steps >= point.steps;
    });
    if (place == points.end() || place->steps != point.steps) {
        points.insert(place, point);
        return;
    }
    const double seconds = place->seconds;
    *place = point;
    if (seconds > 0) place->seconds = std::min(seconds, point.seconds);
}

std::optional<WorkPoint> cheapest(const WorkCurve& curve, double accuracy) {
    std::optional<WorkPoint> best;
    for (const WorkPoint& point : curve.points)
        if (is_reached(point, accuracy) && point.seconds > 0 &&
            (!best || point.seconds < best->seconds))
            best = point;
    return best;
}

std::optional<std::int64_t> next_count(const WorkCurve& curve, double accuracy) {
    const double order = order_of(curve);
    const double wanted = accuracy * std::pow(close_by, -order / 2);
    const Sides found = sides(curve, accuracy);
    if (curve.points.size() >= most_points) return {};
    double next = 0;
    if (found.reached == nullptr) {
        if (is_at_round_off(curve)) return {};
        next = beyond(curve, wanted, order);
        if (next > most_steps_of_path) return {};
        return std::max<std::int64_t>(curve.points.back().steps + 1, std::llround(next));
    }
    const std::int64_t high = found.reached->steps;
    if (ratio_of_steps(accuracy, found.reached->error, order) < close_by) return {};
    if (found.before == nullptr) {
        constexpr double most = 8;
        next = static_cast<double>(high) /
               std::clamp(ratio_of_steps(wanted, found.reached->error, order), 1.1, most);
        const std::int64_t count = std::clamp<std::int64_t>(std::llround(next), 1, high);
        return count < high ? std::optional(count) : std::nullopt;
    }
    const std::int64_t low = found.before->steps;
    if (high - low < 2 || static_cast<double>(high) < close_by * static_cast<double>(low))
        return {};
    return std::clamp<std::int64_t>(std::llround(inside(found, wanted, order)), low + 1, high - 1);
}

double predicted_seconds(const WorkCurve& curve, double accuracy) {
    double least = std::numeric_limits<double>::infinity();
    for (const WorkPoint& point : curve.points)
        if (point.ok())
            least = std::min(least, point.seconds *
                                        ratio_of_steps(point.error, accuracy, order_of(curve)));
    return least;
}

bool is_hopeless(const WorkCurve& curve, double accuracy, double seconds) {
    constexpr double small = 1e-3, far_off = 30, off = 3;
    if (is_reached(curve.points.front(), accuracy)) return false;
    double least = 1;
    for (const WorkPoint& point : curve.points)
        if (point.ok()) least = std::min(least, point.error);
    const double predicted = predicted_seconds(curve, accuracy);
    return std::isfinite(predicted) && predicted > (least < small ? off : far_off) * seconds;
}

std::optional<std::size_t> fastest(const std::vector<WorkCurve>& curves, double accuracy) {
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto point = cheapest(curves[i], accuracy);
        if (!point || !(point->seconds < least)) continue;
        least = point->seconds;
        best = i;
    }
    return best;
}

}  // namespace hvi::gen
