// Many steps in each scalar: neither time nor energy drifts by rounding.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/lobatto_3.hpp>
#include <hvi/generated/trig3.hpp>

#include "scalars.hpp"

using namespace hvi::generated;
using hvi::detail::abs;
using scalars::eps;

namespace {

template <class T>
using State = hvi::State<std::array<T, 1>>;

/// Returns the largest difference from equal steps in a format of more bits, in units of epsilon.
template <template <class, class> class Stepper, class T, class Longer>
double lag(T h, int steps) {
    Stepper<scalars::Oscillator<T>, hvi::FixedPoint> stepper;
    Stepper<scalars::Oscillator<Longer>, hvi::FixedPoint> reference;
    State<T> x{{T(1)}, {T(0)}};
    State<Longer> y{{Longer(1)}, {Longer(0)}};
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok() || !reference.step(y, static_cast<Longer>(h)).ok()) {
            FAIL("no convergence");
        }
    }
    const auto difference = [](T a, Longer b) { return abs(static_cast<Longer>(a) - b); };
    const Longer sum = difference(x.q[0], y.q[0]) + difference(x.p[0], y.p[0]);
    return static_cast<double>(sum / static_cast<Longer>(eps<T>));
}

}  // namespace

TEST_CASE("time does not run fast or slow by the rounding of the weights") {
    // NOTE: if products h b_i were rounded one by one, some lags would be 3,000 to 12,000.
    CHECK(lag<Gauss4, float, double>(0.1F, 100'000) < 500);
    CHECK(lag<Trig3, float, double>(0.3F, 100'000) < 500);
    CHECK(lag<Gauss4, double, long double>(0.1, 100'000) < 500);
    CHECK(lag<Lobatto3, double, long double>(0.1, 100'000) < 500);
    CHECK(lag<Trig3, double, long double>(0.3, 100'000) < 500);
}

TEST_CASE("in float the energy of the oscillator walks at random") {
    // In units of 2^-24. With coefficients rounded one by one it drifts, gauss:3 to 1300 here.
    double worst = 0.0;
    const auto walk = [&](auto stepper) {
        State<float> x{{2.0F}, {1.0F}};
        for (int i = 0; i < 2'000'000; ++i) {
            if (!stepper.step(x, 0.1F).ok()) { FAIL("no convergence"); }
            const auto q = static_cast<double>(x.q[0]);
            const auto p = static_cast<double>(x.p[0]);
            worst = std::fmax(worst, std::abs((p * p + q * q) / 5 - 1.0) * 0x1p24);
        }
    };
    walk(Gauss2<scalars::Oscillator<float>>{});
    walk(Gauss3<scalars::Oscillator<float>>{});
    CHECK(worst < 300);
}
