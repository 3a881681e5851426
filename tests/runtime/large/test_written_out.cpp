// Sums that stay loops, against the same sums written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>
#include <large/chain.hpp>
#include <large/chain_gauss.hpp>
#include <large/chain_of_1.hpp>
#include <large/chain_of_100.hpp>
#include <large/chain_of_2.hpp>
#include <large/chain_of_64.hpp>
#include <large/gauss_of_1.hpp>
#include <large/gauss_of_100.hpp>
#include <large/gauss_of_64.hpp>
#include <large/plane.hpp>
#include <large/plane_of_4.hpp>
#include <large/ring.hpp>
#include <large/ring_of_1.hpp>
#include <large/ring_of_2.hpp>
#include <large/ring_of_64.hpp>
#include <large/stars.hpp>
#include <large/stars_of_2.hpp>
#include <large/stars_of_21.hpp>

namespace {

namespace generated = hvi::generated;

/// Parameters that the scenes make of N are numbers in headers.
template <class From>
void copy_made_of_size(const From& from, generated::Chain::Parameters& to) {
    to.amplitude = from.amplitude;
}
template <class From>
void copy_made_of_size(const From& from, generated::ChainGauss::Parameters& to) {
    to.amplitude = from.amplitude;
}
template <class From>
void copy_made_of_size(const From& from, generated::Plane::Parameters& to) {
    to.a = from.a;
}
template <class From>
void copy_made_of_size(const From& from, generated::Stars::Parameters& to) {
    to.m = from.m;
}
template <class From>
void copy_made_of_size(const From&, generated::Ring::Parameters&) {}

/// Steps of both from where the scene begins: how far apart they end, of the largest value.
template <class Loops, class WrittenOut>
double distance(std::ptrdiff_t n, double h) {
    typename Loops::Parameters parameters;
    parameters.N = n;
    copy_made_of_size(typename WrittenOut::Parameters{}, parameters);
    Loops loops(parameters);
    WrittenOut written_out;
    auto y = WrittenOut::initial();
    const typename Loops::State x_0 = Loops::initial(parameters);
    REQUIRE(x_0.q.size() == y.q.size());
    // NOTE: from the same bits, as sin(2 pi i/N) is rounded for loops.
    typename Loops::State x{{y.q.begin(), y.q.end()}, {y.p.begin(), y.p.end()}};
    double largest = 1, apart = 0;
    const auto compare = [&](double a, double b) {
        largest = std::max(largest, std::abs(b));
        apart = std::max(apart, std::abs(a - b));
    };
    for (int step = 0; step < 50; ++step) {
        REQUIRE(loops.step(x, h).ok());
        REQUIRE(written_out.step(y, h).ok());
    }
    for (std::size_t i = 0; i < y.q.size(); ++i) {
        CHECK(std::abs(x_0.q[i] - WrittenOut::initial().q[i]) < 1e-12);
        CHECK(std::abs(x_0.p[i] - WrittenOut::initial().p[i]) < 1e-12);
        compare(x.q[i], y.q[i]);
        compare(x.p[i], y.p[i]);
    }
    return apart / largest;
}

}  // namespace

TEST_CASE("where sums go in the same order, loops have the bits of what is written out") {
    CHECK(distance<generated::Chain, generated::ChainOf2>(2, 0.1) == 0);
    CHECK(distance<generated::Ring, generated::RingOf1>(1, 0.1) == 0);
    CHECK(distance<generated::Ring, generated::RingOf2>(2, 0.1) == 0);
}

TEST_CASE("where sums go in another order they agree to rounding") {
    CHECK(distance<generated::Chain, generated::ChainOf1>(1, 0.1) < 1e-14);
    // NOTE: written out, a spring pulls two places by one number; a loop has the force on a place.
    CHECK(distance<generated::Chain, generated::ChainOf64>(64, 0.1) < 1e-14);
    CHECK(distance<generated::Chain, generated::ChainOf100>(100, 0.1) < 1e-14);
    CHECK(distance<generated::ChainGauss, generated::GaussOf1>(1, 0.1) < 1e-14);
    CHECK(distance<generated::ChainGauss, generated::GaussOf64>(64, 0.1) < 1e-14);
    CHECK(distance<generated::ChainGauss, generated::GaussOf100>(100, 0.1) < 1e-14);
    CHECK(distance<generated::Ring, generated::RingOf64>(64, 0.1) < 1e-14);
    CHECK(distance<generated::Plane, generated::PlaneOf4>(4, 0.1) < 1e-13);
    CHECK(distance<generated::Stars, generated::StarsOf2>(2, 0.01) < 1e-14);
    CHECK(distance<generated::Stars, generated::StarsOf21>(21, 0.01) < 1e-13);
}
