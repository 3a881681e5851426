// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/time_cases.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "generator/edges/extreme.hpp"

namespace hvi::gen {

namespace {

constexpr const char* oscillator = R"toml(name = "oscillator"
coordinates = "q"
momenta = "p"
hamiltonian = "(p^2 + q^2)/2"
[initial]
q = 1
p = 0
)toml";

/// A ball that falls for a time of 1.
constexpr const char* ball = R"toml(name = "ball"
coordinates = "q"
momenta = "p"
hamiltonian = "p^2/2 + q"
[initial]
q = "1/2"
p = 0
)toml";

/// A corner whose walls are both met at t = 1.
constexpr const char* corner = R"toml(name = "corner"
coordinates = ["x", "y"]
momenta = ["px", "py"]
hamiltonian = "(px^2 + py^2)/2"
[initial]
x = 1
y = 1
px = -1
py = -1
[events.first]
zero = "x"
direction = "down"
set = {px = "-px"}
[events.second]
zero = "y"
direction = "down"
set = {py = "-py"}
)toml";

/// A pendulum whose U is negative up to q = pi/2, which the motion passes.
constexpr const char* crossing = R"toml(name = "pendulum"
coordinates = "q"
momenta = "p"
hamiltonian = "p^2/2 - cos(q)"
[initial]
q = 0
p = 2
)toml";

constexpr double step = 0.015625;
constexpr double pi = 3.14159265358979323846;

Scene with(const std::string& scene, const std::string& more) { return scene_of(scene + more); }

Scene with_scale(const std::string& scene, const std::string& scale) {
    return with(scene, "[time]\nscale = \"" + scale + "\"\n");
}

Scene with_event(const std::string& scene, const std::string& event) {
    return with(scene, "[events.met]\n" + event + "\n");
}

using Judge = std::function<bool(const EventfulMeasurement&)>;

/// Expects the end of the run, and these numbers of events.
Judge counts(std::vector<std::int64_t> expected) {
    return [expected = std::move(expected)](const EventfulMeasurement& seen) {
        return seen.run.ok() && seen.events == expected;
    };
}

/// Expects a status with these words, at a time between two.
Judge stops(const std::string& words, double from, double to) {
    return [=](const EventfulMeasurement& seen) {
        return !seen.run.ok() && seen.run.status.find(words) != std::string::npos &&
               seen.t >= from && seen.t <= to;
    };
}

bool are_near(const std::vector<double>& x, const std::vector<double>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](double a, double b) { return std::abs(a - b) <= 1e-12; });
}

bool ends_at(const EventfulMeasurement& seen, const std::vector<double>& state) {
    const auto* end = std::get_if<EndOfRun>(&seen.run.end);
    return end != nullptr && are_near(end->state, state);
}

}  // namespace

// NOTE: for dt/ds = 1 - t, t is 1 - exp(-s). For dt/ds = sqrt(q - 1/2) the state reaches q = 1/2,
// where the scale vanishes, at t = pi/3 in a finite s. Where U passes through zero dt/ds is
// infinite: an explicit step may be on the other side at once, where -T takes the place of T.
std::vector<RunCase> runs_in_scaled_time() {
    return {
        {with_scale(oscillator, "1 - t"), "dt/ds = 1 - t vanishes on the way, at t = 1", step, 2,
         "a status, as the time stands, at t = 1", stops("the time does not go on", 1 - 1e-9, 1)},
        {with_scale(oscillator, "sqrt(q - 1/2)"),
         "dt/ds = sqrt(q - 1/2) is no number behind t = pi/3", step, 2,
         "a status, at t = pi/3 within a hundredth", stops("", pi / 3 - 0.01, pi / 3 + 0.01)},
        {with_scale(crossing, "logarithmic"), "logarithmic, where U passes through zero", step, 2,
         "a status, or an energy that is off by more than 1/2, of which a run warns",
         [](const EventfulMeasurement& seen) {
             return !seen.run.ok() || !(seen.run.departures.front() <= 0.5);
         }},
    };
}

std::vector<RunCase> runs_with_events() {
    return {
        {with_event(oscillator, "zero = \"p\""), "zero where the run begins", step, 10,
         "3 events: that at t = 0 is none", counts({3})},
        {with_event(oscillator, "zero = \"t - 1\""), "zero where the run ends", step, 1, "1 event",
         counts({1})},
        {with_event(oscillator, "zero = \"(t - 1/2)^2\""), "zero without a change of sign", step, 1,
         "0 events", counts({0})},
        {with_event(oscillator, "zero = \"(t - 1/2)^2 - 1/10^12\""),
         "zero twice within 2e-6, in one step", step, 1, "2 events", counts({2})},
        {with_event(oscillator, "zero = \"sqrt(q - 1/2)\""),
         "a function that is no number behind t = pi/3", step, 2,
         "a status, at t = pi/3 within two steps",
         stops("no number", pi / 3 - 2 * step, pi / 3 + 2 * step)},
        {with_event(ball, "zero = \"q\"\ndirection = \"down\"\nset = {p = \"-p\"}"),
         "a jump at t = 1, where a state is asked for; and times in the past",
         step,
         2,
         "1 event, q = 1/2, 3/8, 0, 3/8, 1/2 at t = 0, 1/2, 1, 3/2, 2, and none at t = -1",
         [](const EventfulMeasurement& seen) {
             return counts({1})(seen) && are_near(seen.outputs, {0.5, 0.375, 0, 0.375, 0.5});
         },
         2,
         {-1, 0, 0.5, 1, 1.5, 2}},
        // NOTE: the ball flies for 1, 1, 1/2, 1/4, ... With steps of the first order it comes to
        // rest on the floor.
        {with_event(ball, "zero = \"q\"\ndirection = \"down\"\nset = {p = \"-p/2\"}"),
         "infinitely many before t = 3: a ball that loses half of its speed", step, 4,
         "a status, at t = 3 within a tenth", stops("again and again", 2.9, 3.1), 2},
        {scene_of(corner), "two walls at the same time", step, 2,
         "1, 1 events, and back where it began",
         [](const EventfulMeasurement& seen) {
             return counts({1, 1})(seen) && ends_at(seen, {1, 1, 1, 1});
         }},
        {with_event(oscillator, "zero = \"t + 1\"\ndirection = \"down\"\n"
                                "[events.never]\nzero = \"t + 1\"\ndirection = \"up\""),
         "steps backward: down is as the run goes", -step, -2, "1, 0 events", counts({1, 0})},
        {with_event(oscillator, "zero = \"t + 30\""), "steps backward, zero at t = -30, the end",
         -step, -30, "1 event", counts({1})},
    };
}

std::vector<RefusedScale> refused_scales() {
    const std::string not_positive = "is not seen to be positive";
    return {
        {with_scale(oscillator, "0"), "dt/ds = 0", not_positive},
        {with_scale(oscillator, "-1"), "dt/ds = -1", not_positive},
        {with_scale(oscillator, "sqrt(q - 2)"), "dt/ds = sqrt(q - 2), from q = 1", "has no value"},
        {with_scale(oscillator, "logarithmic"), "logarithmic, where U is positive", not_positive}};
}

std::vector<ClaimedJump> claimed_jumps() {
    const auto floor = [](const std::string& after) {
        return with_event(ball, "zero = \"q\"\ndirection = \"down\"\ncanonical = true\n"
                                "set = {p = \"" +
                                    after + "\"}");
    };
    return {{floor("-p"), "p -> -p, said to be symplectic", true},
            {floor("-p/2"), "p -> -p/2, said to be symplectic", false}};
}

}  // namespace hvi::gen
