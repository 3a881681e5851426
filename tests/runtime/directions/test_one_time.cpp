// Derivatives at one time of steps in scaled time, beside those of the exact motion.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>
#include <directions/gauss_growing.hpp>
#include <directions/gauss_planet.hpp>
#include <directions/verlet_comet.hpp>
#include <hvi/one_time.hpp>

namespace {

using namespace hvi::generated;

const double pi = std::acos(-1.0);

using Matrix = std::vector<std::vector<double>>;

/// Component of (q, p) in a state that has a time and its momentum.
template <class State>
double& component(State& x, std::size_t k) {
    const std::size_t n = x.q.size() - 1;
    return k < n ? x.q[k] : x.p[k - n];
}

/// The states of a run to a time, and the sizes of its steps, of which the last is another.
template <class Stepper>
struct Course {
    std::vector<typename Stepper::State> x{Stepper::initial()};
    std::vector<double> h;

    Course(double size, double until) {
        Stepper stepper;
        while (true) {
            typename Stepper::State next = x.back();
            REQUIRE(stepper.step(next, size).ok());
            if (next.q.back() >= until) { break; }
            x.push_back(next);
            h.push_back(size);
        }
        // By secants.
        double rest = 0, before = 0, late = x.back().q.back() - until;
        typename Stepper::State end = x.back();
        for (double next = size; late != 0 && next != rest;) {
            before = rest;
            rest = next;
            end = x.back();
            REQUIRE(Stepper().step(end, rest).ok());
            const double now = end.q.back() - until;
            if (std::abs(now) < 1e-14 || now == late) { break; }
            next = rest - now * (rest - before) / (now - late);
            late = now;
        }
        CHECK(std::abs(end.q.back() - until) < 1e-13);
        x.push_back(end);
        h.push_back(rest);
    }
};

/// The derivative of (q, p) at a time by (q, p) at the start, by columns forward.
template <class Stepper>
Matrix forward(const Course<Stepper>& course) {
    using State = typename Stepper::State;
    const typename Stepper::System system(typename Stepper::Parameters{});
    const std::size_t size = 2 * (course.x.front().q.size() - 1);
    std::vector<State> d(size);
    for (std::size_t k = 0; k < size; ++k) {
        component(d[k], k) = 1;
        hvi::OneTime<State>(system, course.x.front()).begin(d[k]);
    }
    Stepper stepper;
    State x = course.x.front();
    for (const double h : course.h) { REQUIRE(stepper.step(x, d, h).ok()); }
    Matrix result(size, std::vector<double>(size));
    for (std::size_t k = 0; k < size; ++k) {
        hvi::OneTime<State>(system, x).end(d[k]);
        CHECK(d[k].q.back() == 0);
        CHECK(d[k].p.back() == 0);
        for (std::size_t row = 0; row < size; ++row) { result[row][k] = component(d[k], row); }
    }
    return result;
}

/// Returns that matrix by its rows, which covectors pulled back give.
template <class Stepper>
Matrix backward(const Course<Stepper>& course) {
    using State = typename Stepper::State;
    const typename Stepper::System system(typename Stepper::Parameters{});
    const std::size_t size = 2 * (course.x.front().q.size() - 1);
    Matrix result(size, std::vector<double>(size));
    for (std::size_t row = 0; row < size; ++row) {
        State lambda{};
        component(lambda, row) = 1;
        hvi::OneTime<State>(system, course.x.back()).pull_back_end(lambda);
        Stepper stepper;
        for (std::size_t step = course.h.size(); step-- > 0;) {
            REQUIRE(stepper.pull_back(course.x[step], lambda, course.h[step]).ok());
        }
        hvi::OneTime<State>(system, course.x.front()).pull_back_begin(lambda);
        CHECK(lambda.q.back() == 0);
        CHECK(lambda.p.back() == 0);
        for (std::size_t k = 0; k < size; ++k) { result[row][k] = component(lambda, k); }
    }
    return result;
}

void check_near(const Matrix& found, const Matrix& expected, double tolerance) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t row = 0; row < found.size(); ++row) {
        for (std::size_t k = 0; k < found.size(); ++k) {
            CAPTURE(row, k, found[row][k], expected[row][k]);
            CHECK(std::abs(found[row][k] - expected[row][k]) < tolerance);
        }
    }
}

}  // namespace

TEST_CASE("the derivative of a revolution, forward and backward") {
    // Neighbours have the periods 2 pi (-2 H)^(-3/2): I - 6 pi f dH^T.
    const double x = 0.5, v = std::sqrt(3.0);
    const std::array<double, 4> f{0, v, -1 / (x * x), 0}, slope{1 / (x * x), 0, 0, v};
    Matrix expected(4, std::vector<double>(4));
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            expected[i][k] = (i == k ? 1.0 : 0.0) - 6 * pi * f[i] * slope[k];
        }
    }
    const Course<GaussPlanet> course(0.1, 2 * pi);
    check_near(forward(course), expected, 1e-8);
    check_near(backward(course), expected, 1e-8);
}

TEST_CASE("the derivative of a motion that depends on the time, forward and backward") {
    const Matrix expected{{5.0 / 3, 7.0 / 6}, {7.0 / 6, 17.0 / 12}};
    const Course<GaussGrowing> course(0.05, 1);
    check_near(forward(course), expected, 1e-10);
    check_near(backward(course), expected, 1e-10);
}

TEST_CASE("forward and backward agree where the derivatives of H are those of T and U") {
    const Course<VerletComet> course(0.1, 1);
    const Matrix rows = backward(course), columns = forward(course);
    double largest = 0;
    for (const std::vector<double>& row : columns) {
        for (const double entry : row) { largest = std::max(largest, std::abs(entry)); }
    }
    check_near(rows, columns, 1e-11 * largest);
}
