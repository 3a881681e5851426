// In float, double and long double --float128 changes no bit.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>

#include <catch2/catch.hpp>
#include <wide/kepler.hpp>
#include <wide/newton_kepler.hpp>
#include <wide/nonseparable.hpp>
#include <wide/oscillator.hpp>
#include <wide/pendulum.hpp>
#include <wide/plain_kepler.hpp>
#include <wide/plain_newton_kepler.hpp>
#include <wide/plain_nonseparable.hpp>
#include <wide/plain_oscillator.hpp>
#include <wide/plain_pendulum.hpp>
#include <wide/plain_trig3_nonseparable.hpp>
#include <wide/plain_verlet_pendulum.hpp>
#include <wide/trig3_nonseparable.hpp>
#include <wide/verlet_pendulum.hpp>

using namespace hvi::generated;

namespace {

template <class Vector>
bool are_equal(const Vector& a, const Vector& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (!(a[k] == b[k])) { return false; }
    }
    return true;
}

template <class Wide, class Plain>
void compare() {
    using Scalar = typename Wide::Scalar;
    Wide wide;
    Plain plain;
    auto x = Wide::initial();
    auto y = Plain::initial();
    for (int i = 0; i < 50; ++i) {
        const Scalar h = Scalar(i < 40 ? 1 : -1) / 50;
        REQUIRE(wide.step(x, h).ok());
        REQUIRE(plain.step(y, h).ok());
        REQUIRE(are_equal(x.q, y.q));
        REQUIRE(are_equal(x.p, y.p));
    }
}

}  // namespace

TEMPLATE_TEST_CASE("with and without --float128", "", float, double, long double) {
    using T = TestType;
    compare<BasicWideKepler<T>, BasicKepler<T>>();
    compare<BasicWideNewtonKepler<T>, BasicNewtonKepler<T>>();
    compare<BasicWideNonseparable<T>, BasicNonseparable<T>>();
    compare<BasicWideOscillator<T>, BasicOscillator<T>>();
    compare<BasicWidePendulum<T>, BasicPendulum<T>>();
    compare<BasicWideTrig3Nonseparable<T>, BasicTrig3Nonseparable<T>>();
    compare<BasicWideVerletPendulum<T>, BasicVerletPendulum<T>>();
    BasicWideTrig3Nonseparable<T> wide;
    BasicTrig3Nonseparable<T> plain;
    auto x = BasicTrig3Nonseparable<T>::initial();
    auto y = BasicWideTrig3Nonseparable<T>::initial();
    REQUIRE(plain.step(x, T(1) / 50).ok());
    REQUIRE(wide.step(y, T(1) / 50).ok());
    CHECK(are_equal(wide.position(T(1) / 3), plain.position(T(1) / 3)));
}
