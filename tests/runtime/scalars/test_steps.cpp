// Steps in each scalar, to its own precision.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstring>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <hvi/generated/chebyshev_3.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/lobatto_3.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/generated/trig3.hpp>
#include <hvi/generic_stepper.hpp>
#include <hvi/newton.hpp>

#include "scalars.hpp"

using namespace hvi::generated;
using hvi::detail::abs;
using scalars::at_most;
using scalars::eps;
using scalars::ratio;

namespace {

template <class T>
using State = hvi::State<std::array<T, 1>>;

template <class T>
const std::vector<T> step_sizes{ratio<T>(1, 2),   ratio<T>(3, 10), ratio<T>(1, 10),
                                ratio<T>(1, 100), -ratio<T>(1, 4), -ratio<T>(1, 2)};

template <class Stepper>
typename Stepper::State one_step(Stepper stepper, typename Stepper::State x,
                                 typename Stepper::Scalar h) {
    REQUIRE(stepper.step(x, h).ok());
    return x;
}

/// A sum of two terms that may cancel: to a few units in the last place of the larger one.
template <class T>
void check_row(T value, T first, T second) {
    CHECK(at_most(abs(value - (first + second)), 4 * eps<T> * (abs(first) + abs(second))));
}

template <class T>
void check_relative(T value, T exact) {
    CHECK(at_most(abs(value - exact), 4 * eps<T> * abs(exact)));
}

/// The components of the one-step matrix of the oscillator.
template <class T>
struct Rows {
    T qq, qp, pq, pp;
};

template <class T>
void check_oscillator(const State<T>& x, const Rows<T>& exact) {
    check_row(x.q[0], 2 * exact.qq, exact.qp);
    check_row(x.p[0], 2 * exact.pq, exact.pp);
}

}  // namespace

TEMPLATE_TEST_CASE("(6.2) and (6.3): steps with H = q p", "", HVI_SCALARS) {
    using T = TestType;
    for (const T h : step_sizes<T>) {
        const T cheby = -(((h + 10) * h + 48) * h + 96) / (((h - 10) * h + 48) * h - 96);
        const State<T> x = one_step(Chebyshev3<scalars::Dilation<T>>{}, {{T(2)}, {T(2)}}, h);
        check_relative(x.q[0], 2 * cheby);
        check_relative(x.p[0], 2 / cheby);
        const T gauss = ((h + 6) * h + 12) / ((h - 6) * h + 12);
        const State<T> y = one_step(Gauss2<scalars::Dilation<T>>{}, {{T(2)}, {T(2)}}, h);
        check_relative(y.q[0], 2 * gauss);
        check_relative(y.p[0], 2 / gauss);
    }
}

TEMPLATE_TEST_CASE("(6.5) and (6.6): steps with the oscillator", "", HVI_SCALARS) {
    using T = TestType;
    const scalars::Oscillator<T> oscillator{ratio<T>(5, 4)};
    const T w2 = ratio<T>(25, 16);
    const State<T> start{{T(2)}, {T(1)}};
    for (const T h : step_sizes<T>) {
        const T z2 = h * h * w2;
        const T D = ((z2 - 12) * z2 + 288) * z2 + 9216;
        const T cheby = (((-z2 + 228) * z2 - 4320) * z2 + 9216) / D;
        check_oscillator(one_step(Chebyshev3<scalars::Oscillator<T>>{oscillator}, start, h),
                         {cheby, h * ((36 * z2 - 1248) * z2 + 9216) / D,
                          h * w2 * ((-12 * z2 + 1248) * z2 - 9216) / D, cheby});
        const T E = (z2 + 12) * z2 + 144;
        const T gauss = ((z2 - 60) * z2 + 144) / E;
        const T gauss_qp = h * (-12 * z2 + 144) / E;
        const Rows<T> exact{gauss, gauss_qp, -w2 * gauss_qp, gauss};
        using Gauss = Gauss2<scalars::Oscillator<T>>;
        using Separable = Gauss2Separable<scalars::Oscillator<T>>;
        check_oscillator(one_step(Gauss{oscillator}, start, h), exact);
        check_oscillator(one_step(Separable{oscillator}, start, h), exact);
    }
}

TEMPLATE_TEST_CASE("explicit Störmer-Verlet on the oscillator", "", HVI_SCALARS) {
    using T = TestType;
    for (const T h : step_sizes<T>) {
        const T diagonal = 1 - h * h / 2;
        check_oscillator(
            one_step(StormerVerletSeparable<scalars::Oscillator<T>>{}, {{T(2)}, {T(1)}}, h),
            {diagonal, h, -h * (1 - h * h / 4), diagonal});
    }
}

TEMPLATE_TEST_CASE("Newton's method in the scalars that Eigen computes in", "", float, double,
                   long double) {
    using T = TestType;
    const State<T> start{{T(2)}, {T(1)}};
    for (const T h : {ratio<T>(1, 10), ratio<T>(-1, 2), T(100), T(10000)}) {
        const T z2 = h * h;
        const T E = (z2 + 12) * z2 + 144;
        const T gauss = ((z2 - 60) * z2 + 144) / E;
        const T gauss_qp = h * (-12 * z2 + 144) / E;
        const Rows<T> exact{gauss, gauss_qp, -gauss_qp, gauss};
        using Gauss = Gauss2<scalars::Oscillator<T>, hvi::Newton>;
        using Separable = Gauss2Separable<scalars::Oscillator<T>, hvi::Newton>;
        check_oscillator(one_step(Gauss{}, start, h), exact);
        check_oscillator(one_step(Separable{}, start, h), exact);
    }
}

namespace {

template <class Stepper>
void check_return() {
    using T = typename Stepper::Scalar;
    Stepper stepper;
    State<T> x{{ratio<T>(7, 10)}, {ratio<T>(-2, 5)}};
    const State<T> start = x;
    for (int i = 0; i < 20; ++i) { REQUIRE(stepper.step(x, ratio<T>(3, 10)).ok()); }
    for (int i = 0; i < 20; ++i) { REQUIRE(stepper.step(x, ratio<T>(-3, 10)).ok()); }
    CHECK(at_most(abs(x.q[0] - start.q[0]), 16 * eps<T>));
    CHECK(at_most(abs(x.p[0] - start.p[0]), 16 * eps<T>));
}

}  // namespace

TEMPLATE_TEST_CASE("steps back return", "", HVI_SCALARS) {
    using System = scalars::Duffing<TestType>;
    check_return<Gauss3<System>>();
    check_return<Gauss4<System>>();
    check_return<Lobatto3<System>>();
    check_return<Lobatto3Separable<System>>();
    check_return<Trig3<System>>();
    check_return<StormerVerletSeparable<System>>();
}

TEMPLATE_TEST_CASE("the table-driven stepper agrees", "", HVI_SCALARS) {
    using T = TestType;
    using Generic = hvi::GenericStepper<T>;
    using Table = typename Generic::Vector;
    const std::vector<Table> A{{0, 0, 0},
                               {ratio<T>(5, 24), ratio<T>(1, 3), ratio<T>(-1, 24)},
                               {ratio<T>(1, 6), ratio<T>(2, 3), ratio<T>(1, 6)}};
    const std::vector<Table> A_tilde{{ratio<T>(1, 6), ratio<T>(-1, 6), 0},
                                     {ratio<T>(1, 6), ratio<T>(1, 3), 0},
                                     {ratio<T>(1, 6), ratio<T>(5, 6), 0}};
    const Generic generic(
        {A[2], A, A_tilde},
        [](const Table& q, const Table&, Table& out) { out[0] = q[0] + q[0] * q[0] * q[0]; },
        [](const Table&, const Table& p, Table& out) { out = p; });
    typename Generic::State x{{ratio<T>(7, 10)}, {ratio<T>(-2, 5)}};
    State<T> y{{x.q[0]}, {x.p[0]}};
    Lobatto3Separable<scalars::Duffing<T>> stepper;
    for (int i = 0; i < 10; ++i) {
        REQUIRE(generic.step(x, ratio<T>(1, 10)).ok());
        REQUIRE(stepper.step(y, ratio<T>(1, 10)).ok());
        CHECK(at_most(abs(x.q[0] - y.q[0]), 16 * eps<T>));
        CHECK(at_most(abs(x.p[0] - y.p[0]), 16 * eps<T>));
    }
}

TEMPLATE_TEST_CASE("vectors of Eigen in each scalar that it computes in", "", float, double,
                   long double) {
    using T = TestType;
    using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    Gauss3<scalars::Oscillator<T>> gauss;
    Gauss3<scalars::Oscillator<T, Column>> dynamic;
    State<T> x{{T(2)}, {T(1)}};
    hvi::State<Column> y{Column::Constant(1, T(2)), Column::Constant(1, T(1))};
    for (int i = 0; i < 20; ++i) {
        REQUIRE(gauss.step(x, ratio<T>(1, 10)).ok());
        REQUIRE(dynamic.step(y, ratio<T>(1, 10)).ok());
    }
    CHECK((x.q[0] == y.q[0] && x.p[0] == y.p[0]));
}

TEST_CASE("the padding of a long double is no part of a state") {
    using Vector = std::array<long double, 1>;
    Vector a, b;
    std::memset(&a, 0x55, sizeof a);
    std::memset(&b, 0xaa, sizeof b);
    a[0] = b[0] = 1.0L / 3;
    CHECK(hvi::detail::same_bits(a, b));
    b[0] = std::nextafter(b[0], 1.0L);
    CHECK_FALSE(hvi::detail::same_bits(a, b));
    a[0] = 0.0L;
    b[0] = -0.0L;
    CHECK_FALSE(hvi::detail::same_bits(a, b));
}

#ifdef __SIZEOF_FLOAT128__

namespace {

using scalars::Quad;

/// cos(1) and sin(1) by their series.
State<Quad> turned_by_one() {
    Quad term = 1;
    State<Quad> x{{Quad(0)}, {Quad(0)}};
    for (int n = 0; n < 40; ++n) {
        const Quad sign = n % 4 < 2 ? 1 : -1;
        (n % 2 == 0 ? x.q : x.p)[0] += (n % 2 == 0 ? sign : -sign) * term;
        term /= n + 1;
    }
    return x;
}

/// log2 of the error at t = 1, from q = 1 and p = 0.
template <class Stepper>
double error_at_one(int steps) {
    Stepper stepper;
    State<Quad> x{{Quad(1)}, {Quad(0)}};
    for (int i = 0; i < steps; ++i) { REQUIRE(stepper.step(x, Quad(1) / steps).ok()); }
    const State<Quad> exact = turned_by_one();
    return std::log2(static_cast<double>(abs(x.q[0] - exact.q[0]) + abs(x.p[0] - exact.p[0])));
}

template <class Stepper>
void check_order(double order, int most_steps, double best) {
    double last = error_at_one<Stepper>(8);
    for (int steps = 16; steps <= most_steps; steps *= 2) {
        const double error = error_at_one<Stepper>(steps);
        INFO("steps " << steps << ", error 2^" << error);
        CHECK(last - error == Approx(order).margin(0.1));
        last = error;
    }
    CHECK(last < best);
}

}  // namespace

TEST_CASE("binary128 converges far below what a double can hold") {
    // A single double among the coefficients or in a stop of an iteration ends this near 2^-55.
    check_order<Gauss4<scalars::Oscillator<Quad>>>(8, 1024, -103);
    check_order<Gauss3<scalars::Oscillator<Quad>>>(6, 1024, -75);
    check_order<Lobatto3Separable<scalars::Oscillator<Quad>>>(4, 8192, -60);
}

#endif
