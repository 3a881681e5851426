// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/peers.hpp"

#include <array>
#include <chrono>

#include "generator/study/departures.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr std::array tolerances{1e-3, 1e-5, 1e-6, 1e-8, 1e-9, 1e-11, 1e-12, 1e-14};

/// The tolerance of the equations in implicit methods of equal steps. A looser one shows in errors
/// of 1e-10, a tighter one is below round-off where coordinates are large.
constexpr double tolerance_of_equations = 1e-12;

/// Runs of what chooses its steps.
std::vector<WorkPoint> by_tolerance(const fs::path& program, const Peer& peer,
                                    const Course& course) {
    std::vector<WorkPoint> points;
    for (const double tolerance : tolerances) {
        const auto start = std::chrono::steady_clock::now();
        const Measurement run = measure_peer(
            program, peer, {course.until, course.first_count, tolerance}, seconds_of_timing);
        points.push_back(work_point(course, run));
        points.back().tolerance = tolerance;
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        // It was run once to be looked at, and three times to be timed.
        if (taken.count() > 4 * longest_of_search) break;
    }
    return points;
}

}  // namespace

std::vector<PeerCurve> peer_curves(const fs::path& program, const PeerLibrary& library,
                                   const SceneStepper& stepper, const Course& course) {
    std::vector<PeerCurve> curves;
    for (const Peer& peer : library.peers) {
        if (!applies(peer, stepper.system)) continue;
        const auto run_of = [equal = peer.takes_equal_steps, until = course.until,
                             first = course.first_count](const WorkPoint& point) {
            return equal ? PeerRun{until, point.steps, tolerance_of_equations}
                         : PeerRun{until, first, point.tolerance};
        };
        WorkCurve curve{library.name + ":" + peer.name, peer.order, true, {}, {}};
        curve.points =
            !peer.takes_equal_steps
                ? by_tolerance(program, peer, course)
                : work_points(course, [&](std::int64_t count, double seconds) {
                      return measure_peer(program, peer,
                                          {course.until, count, tolerance_of_equations}, seconds);
                  });
        curve.departures = departures(course, curve.points, [&](const WorkPoint& point) {
            return sample_departures_of_peer(program, peer, run_of(point), departure_parts);
        });
        curves.push_back(
            {std::move(curve), [program, peer, run_of](const WorkPoint& point, double seconds) {
                 return measure_peer(program, peer, run_of(point), seconds);
             }});
    }
    return curves;
}

}  // namespace hvi::gen
