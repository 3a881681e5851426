// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/departures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr double usual_error = 1e-6;

double distance(const WorkPoint& point) {
    return point.ok() ? std::abs(std::log(point.error / usual_error))
                      : std::numeric_limits<double>::infinity();
}

}  // namespace

Departures departures(const Course& course, const std::vector<WorkPoint>& points,
                      const SampleDepartures& sample) {
    const auto nearest =
        std::min_element(points.begin(), points.end(), [](const auto& left, const auto& right) {
            return distance(left) < distance(right);
        });
    if (nearest == points.end() || !nearest->ok()) return {};
    const DepartureSamples found = sample(*nearest);
    Departures result{nearest->h, found.times, {}, {}, {}};
    const std::size_t first = course.keeps_energy ? 1 : 0;
    for (const std::vector<double>& each : found.departures) {
        if (each.size() < first)
            throw EnvironmentError("a compiled program does not answer as it should: it says no "
                                   "departure of the energy");
        result.largest.resize(each.size());
        for (std::size_t i = 0; i < each.size(); ++i)
            result.largest[i] = std::max(result.largest[i], each[i]);
        if (course.keeps_energy) result.energy.push_back(each.front());
        if (each.size() == first) continue;
        double sum = 0;
        for (std::size_t i = first; i < each.size(); ++i) sum += each[i] * each[i];
        result.invariants.push_back(std::sqrt(sum));
    }
    return result;
}

}  // namespace hvi::gen
