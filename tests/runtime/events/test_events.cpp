// Events of runs, against times that are known in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/events.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/integrate_at.hpp>

using namespace hvi;

namespace {

const double pi = std::acos(-1.0);

/// H = p^2/2 + q, above a floor at q = 0: steps are exact.
struct Ball {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector&, Vector& out) const { out = {1.0}; }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
};
using BallStepper = generated::StormerVerletSeparable<Ball>;
using BallState = BallStepper::State;

/// H = (p^2 + q^2)/2: q = cos(t).
struct Spring {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector& q, const Vector&, Vector& out) const { out = q; }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
};
using SpringStepper = generated::Gauss4<Spring>;
using SpringState = SpringStepper::State;
const SpringState at_one{{1.0}, {0.0}};

/// H = |p|^2/2, in a quarter of the plane.
struct Billiard {
    using Vector = std::array<double, 2>;
    void dHdq(const Vector&, Vector& out) const { out = {0.0, 0.0}; }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
};
using BilliardStepper = generated::StormerVerletSeparable<Billiard>;

/// H = |p|^2/2 - 1/|q|.
struct Planet {
    using Vector = std::array<double, 2>;
    void dHdq(const Vector& q, const Vector&, Vector& out) const {
        const double r = std::hypot(q[0], q[1]);
        out = {q[0] / (r * r * r), q[1] / (r * r * r)};
    }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
};
using PlanetStepper = generated::Gauss4<Planet>;

/// An event of the spring at which q is `at`, which writes its times.
Event<SpringStepper> spring_at(double at, std::vector<double>& times,
                               Direction direction = Direction::both) {
    Event<SpringStepper> event;
    event.zero = [at](const SpringState& x, double) { return x.q[0] - at; };
    event.direction = direction;
    event.act = [&times](SpringState&, double t) {
        times.push_back(t);
        return After::go_on;
    };
    return event;
}

/// The derivative of q - at along the motion.
double velocity(const SpringState& x, double) { return x.p[0]; }

void agree(const std::vector<double>& found, const std::vector<double>& expected,
           double tolerance = 1e-11) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(std::abs(found[k] - expected[k]) < tolerance);
    }
}

/// A floor of this restitution, which counts bounces and keeps the time of the last one.
struct Floor {
    double restitution;
    int count = 0;
    double last = 0;

    [[nodiscard]] Event<BallStepper> event() {
        Event<BallStepper> event;
        event.zero = [](const BallState& x, double) { return x.q[0]; };
        event.direction = Direction::down;
        event.act = [this](BallState& x, double t) {
            x.p[0] *= -restitution;
            ++count;
            last = t;
            return After::jump;
        };
        return event;
    }
};

}  // namespace

TEST_CASE("a ball jumps for a thousand times without losing height") {
    Floor floor{1};
    BallStepper stepper;
    BallState x{{0.5}, {0.0}};
    double highest = 0;
    const auto run = integrate(stepper, x, 0.0, 0.07, 29000, events(floor.event()),
                               [&](const BallState& y, double) {
                                   highest = std::max(highest, y.p[0] * y.p[0] / 2 + y.q[0]);
                               });
    CHECK(run.ok());
    CHECK(run.ending == Ending::all_steps);
    CHECK(run.run.steps == 29000);
    CHECK(floor.count == 1015);  // at 1, 3, ..., 2029, until 2030
    CHECK(std::abs(floor.last - 2029) < 1e-9);
    CHECK(std::abs(highest - 0.5) < 1e-12);
}

TEST_CASE("bounces that accumulate end the run where they do") {
    // For the restitution 1/2 bounces are at 1, 2, 2 1/2, ... and come to an end at 3.
    Floor floor{0.5};
    BallStepper stepper;
    BallState x{{0.5}, {0.0}};
    const auto run = integrate(stepper, x, 0.0, 0.1, 60, events(floor.event()));
    CHECK(!run.ok());
    CHECK(run.ending == Ending::accumulation);
    CHECK(run.event == 0);
    CHECK(run.t == floor.last);
    CHECK(std::abs(run.t - 3) < 1e-6);
    CHECK(floor.count > 20);
    CHECK(std::abs(x.q[0]) < 1e-15);
}

TEST_CASE("crossings by direction, at the times of the cosine") {
    const auto found = [](Direction direction) {
        std::vector<double> times;
        SpringStepper stepper;
        SpringState x = at_one;
        const auto run =
            integrate(stepper, x, 0.0, 0.3, 40, events(spring_at(0.25, times, direction)));
        CHECK(run.ok());
        return times;
    };
    const double a = std::acos(0.25);
    agree(found(Direction::down), {a, 2 * pi + a}, 1e-7);
    agree(found(Direction::up), {2 * pi - a, 4 * pi - a}, 1e-7);
    agree(found(Direction::both), {a, 2 * pi - a, 2 * pi + a, 4 * pi - a}, 1e-7);
}

TEST_CASE("two zeros in one step are found with a slope, and missed without") {
    // q is above 0.999 for 0.0894 around each maximum; steps are of 0.3.
    const auto found = [](bool has_slope) {
        std::vector<double> times;
        SpringStepper stepper;
        SpringState x = at_one;
        Event<SpringStepper> event = spring_at(0.999, times);
        if (has_slope) { event.slope = velocity; }
        const auto run = integrate(stepper, x, 0.0, 0.3, 2000, events(event));
        CHECK(run.ok());
        return times;
    };
    std::vector<double> expected;
    for (int k = 0; 2 * pi * k < 600; ++k) {
        if (k > 0) { expected.push_back(2 * pi * k - std::acos(0.999)); }
        expected.push_back(2 * pi * k + std::acos(0.999));
    }
    agree(found(true), expected, 1e-5);
    CHECK(found(false).size() < expected.size() / 2);
}

TEST_CASE("steps have the same bits with and without events and output") {
    PlanetStepper plain, watched;
    PlanetStepper::State x{{0.5, 0.0}, {0.0, std::sqrt(3.0)}}, y = x, z = x;
    CHECK(integrate(plain, x, 0.0, 0.03, 3000).ok());
    Event<PlanetStepper> event;
    event.zero = [](const auto& at, double) { return at.q[0] * at.p[0] + at.q[1] * at.p[1]; };
    CHECK(integrate(watched, y, 0.0, 0.03, 3000, events(event)).ok());
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
    std::vector<double> times;
    for (int k = 0; k <= 900; ++k) { times.push_back(0.1 * k); }
    times.back() = 89.99;
    PlanetStepper other;
    const Run run = integrate_at(other, z, 0.0, 0.03, times, [](const auto&, double) {});
    CHECK(run.steps == 3000);
    CHECK(x.q == z.q);
    CHECK(x.p == z.p);
}

TEST_CASE("angular momentum is what it was at each of a thousand perihelia") {
    PlanetStepper stepper;
    PlanetStepper::State x{{0.5, 0.0}, {0.0, std::sqrt(3.0)}};
    const double momentum = 0.5 * std::sqrt(3.0);
    int count = 0;
    double largest = 0, latest = 0, radius = 0;
    Event<PlanetStepper> event;
    event.direction = Direction::up;
    event.zero = [](const auto& at, double) { return at.q[0] * at.p[0] + at.q[1] * at.p[1]; };
    event.act = [&](auto& at, double t) {
        ++count;
        largest = std::max(largest, std::abs(at.q[0] * at.p[1] - at.q[1] * at.p[0] - momentum));
        radius = std::max(radius, std::abs(std::hypot(at.q[0], at.q[1]) - 0.5));
        latest = t;
        return After::go_on;
    };
    const auto steps = static_cast<std::int64_t>(std::ceil(1000.5 * 2 * pi / 0.05));
    double at_steps = 0;
    const auto watch = [&](const auto& y, double) {
        at_steps = std::max(at_steps, std::abs(y.q[0] * y.p[1] - y.q[1] * y.p[0] - momentum));
    };
    CHECK(integrate(stepper, x, 0.0, 0.05, steps, events(event), watch).ok());
    CHECK(count == 1000);
    // NOTE: what the steps themselves have lost to rounding is 1.4e-15.
    CHECK(at_steps < 2e-15);
    CHECK(largest < at_steps + 3e-16);
    CHECK(radius < 1e-9);
    CHECK(std::abs(latest - 2000 * pi) < 1e-5);
}

TEST_CASE("events at the start, at the end, and without a change of sign") {
    const auto count = [](double start_q, double start_p, double at, double h, int steps) {
        std::vector<double> times;
        SpringStepper stepper;
        SpringState x{{start_q}, {start_p}};
        const auto run = integrate(stepper, x, 0.0, h, steps, events(spring_at(at, times)));
        CHECK(run.ok());
        return times.size();
    };
    CHECK(count(0, 1, 0, 0.1, 20) == 0);  // it begins there
    CHECK(count(0, -1, 0, 0.1, 20) == 0);
    CHECK(count(0, 1, 0, 0.1, 40) == 1);   // and comes back
    CHECK(count(1, 0, 1, 0.1, 200) == 0);  // it touches 1 at each maximum
    CHECK(count(0, 1, 1.5, 0.1, 200) == 0);
    // NOTE: at the end the function is zero to the last bit.
    BallStepper stepper;
    BallState x{{0.5}, {-0.5}};  // q = 1/2 - t/2 - t^2/2 is zero at (sqrt(5) - 1)/2
    int at_end = 0;
    Event<BallStepper> clock;
    clock.zero = [](const BallState&, double t) { return t - 1; };
    clock.act = [&](BallState&, double t) {
        CHECK(t == 1);
        ++at_end;
        return After::go_on;
    };
    CHECK(integrate(stepper, x, 0.0, 0.125, 8, events(clock)).ok());
    CHECK(at_end == 1);
    CHECK(integrate(stepper, x, 1.0, 0.125, 8, events(clock)).ok());
    CHECK(at_end == 1);
}

TEST_CASE("a run ends at an event, and goes on from there") {
    std::vector<double> times;
    SpringStepper stepper;
    SpringState x = at_one;
    Event<SpringStepper> event = spring_at(0, times);
    event.act = [&](SpringState&, double t) {
        times.push_back(t);
        return times.size() % 2 == 0 ? After::stop : After::go_on;
    };
    const auto first = integrate(stepper, x, 0.0, 0.1, 1000, events(event));
    CHECK(first.ok());
    CHECK(first.ending == Ending::event);
    CHECK(std::abs(first.t - 1.5 * pi) < 1e-11);
    CHECK(first.run.steps == 47);
    CHECK(std::abs(x.q[0]) < 4e-15);
    const auto second = integrate(stepper, x, first.t, 0.1, 1000, events(event));
    CHECK(second.ending == Ending::event);
    agree(times, {0.5 * pi, 1.5 * pi, 2.5 * pi, 3.5 * pi});
}

TEST_CASE("steps back in time, and a start at another one") {
    std::vector<double> times;
    SpringStepper stepper;
    SpringState x = at_one;  // at t = -30
    const auto run =
        integrate(stepper, x, -30.0, -0.1, 50, events(spring_at(0, times, Direction::up)));
    CHECK(run.ok());
    CHECK(run.t == -30 - 50 * 0.1);
    // Back in time q goes down at -30 - pi/2 and up at -30 - 3 pi/2.
    agree(times, {-30 - 1.5 * pi});
}

TEST_CASE("both walls of a corner at the same time") {
    std::vector<std::pair<int, double>> seen;
    const auto wall = [&](std::size_t k) {
        Event<BilliardStepper> event;
        event.zero = [k](const auto& x, double) { return x.q[k]; };
        event.direction = Direction::down;
        event.act = [&seen, k](auto& x, double t) {
            seen.emplace_back(static_cast<int>(k), t);
            x.p[k] = -x.p[k];
            return After::jump;
        };
        return event;
    };
    for (const double where : {0.3, 0.5, 1.0}) {  // within a step, and where it ends
        seen.clear();
        BilliardStepper stepper;
        BilliardStepper::State x{{where, where}, {-1.0, -1.0}};
        const auto run = integrate(stepper, x, 0.0, 0.5, 10, events(wall(0), wall(1)));
        CAPTURE(where);
        CHECK(run.ok());
        REQUIRE(seen.size() == 2);
        CHECK(seen[0].first + seen[1].first == 1);
        for (const auto& [k, t] : seen) { CHECK(std::abs(t - where) < 1e-15); }
        for (const double q : x.q) { CHECK(std::abs(q - (5 - where)) < 1e-14); }
        CHECK(x.p == Billiard::Vector{1, 1});
    }
}

TEST_CASE("a kick on the way does not count again at once") {
    int count = 0;
    BilliardStepper stepper;
    BilliardStepper::State x{{-1.0, 0.0}, {1.0, 0.0}};
    Event<BilliardStepper> kick;
    kick.zero = [](const auto& y, double) { return y.q[0]; };
    kick.act = [&](auto& y, double) {
        ++count;
        y.p[0] = 2;
        return After::jump;
    };
    CHECK(integrate(stepper, x, 0.0, 0.3, 10, events(kick)).ok());
    CHECK(count == 1);
    CHECK(std::abs(x.q[0] - 4) < 1e-14);
}

TEST_CASE("no event counts within the cooldown of the last one") {
    std::vector<double> times;
    SpringStepper stepper;
    SpringState x = at_one;
    Event<SpringStepper> event = spring_at(0, times);
    event.cooldown = 5;
    CHECK(integrate(stepper, x, 0.0, 0.1, 200, events(event)).ok());
    agree(times, {0.5 * pi, 2.5 * pi, 4.5 * pi});
}

TEST_CASE("an angle is zero at multiples of its period, not where it jumps by one") {
    std::vector<double> times;
    SpringStepper stepper;
    SpringState x = at_one;
    Event<SpringStepper> event;
    // The angle of (q, p) is -t.
    event.zero = [](const SpringState& y, double) { return std::atan2(y.p[0], y.q[0]) - 1; };
    event.period = 2 * pi;
    event.act = [&](SpringState&, double t) {
        times.push_back(t);
        return After::go_on;
    };
    CHECK(integrate(stepper, x, 0.0, 0.1, 150, events(event)).ok());
    agree(times, {2 * pi - 1, 4 * pi - 1});
}

TEST_CASE("what has no value, and steps that fail, end a run with its state") {
    BallStepper stepper;
    BallState x{{0.5}, {0.0}};
    Event<BallStepper> event;
    event.zero = [](const BallState& y, double) { return std::sqrt(y.q[0]) + 1; };
    const auto run = integrate(stepper, x, 0.0, 0.25, 100, events(event));
    CHECK(run.ending == Ending::undefined);
    CHECK(run.run.steps == 4);
    CHECK(run.t == 1);
    CHECK(x.q[0] == 0);
    BallState y{{0.5}, {std::numeric_limits<double>::infinity()}};
    const BallState before = y;
    event.zero = [](const BallState&, double t) { return t - 10; };
    const auto failed = integrate(stepper, y, 0.0, 0.25, 100, events(event));
    CHECK(failed.ending == Ending::failed_step);
    CHECK(failed.run.status.code() == Status::Code::not_finite);
    CHECK(failed.run.steps == 0);
    CHECK(y.p == before.p);
}

TEST_CASE("states at given times, before the start and of no steps") {
    std::vector<double> seen;
    double error = 0;
    SpringStepper stepper;
    SpringState x = at_one;
    const auto observe = [&](const SpringState& y, double t) {
        seen.push_back(t);
        error = std::max(error, std::abs(y.q[0] - std::cos(t)));
    };
    const std::vector<double> times{-1, 0, 0.05, 0.1, 0.15, 0.15, 1, pi};
    const Run run = integrate_at(stepper, x, 0.0, 0.1, times, observe);
    CHECK(run.ok());
    CHECK(run.steps == 32);
    CHECK(seen == std::vector<double>(times.begin() + 1, times.end()));
    CHECK(error < 1e-12);
    CHECK(integrate_at(stepper, x, 0.0, 0.0, {1.0}, observe).steps == 0);
    CHECK(integrate_at(stepper, x, 0.0, -0.1, {-0.05, -0.2}, observe).steps == 2);
    CHECK(integrate_at(stepper, x, 0.0, 0.1, {}, observe).steps == 0);
}

TEST_CASE("a time that does not go on ends a run") {
    BallStepper stepper;
    BallState x{{0.5}, {0.0}};
    detail::EventSteps<BallStepper> steps({}, stepper);
    steps.take_time_from([](const BallState& y) { return y.q[0]; });  // which falls
    EventRun<double> run;
    run.t = 0.5;
    steps.begin(x, 0.5, 0.1);
    steps.take(stepper, x, 0.1, 0.6, run);
    CHECK(run.ending == Ending::time_stands);
    CHECK(!run.ok());
    CHECK(run.run.steps == 0);
    CHECK(x.q[0] == 0.5);
}
