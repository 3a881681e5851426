// Momenta become paths and kicks become momenta with one step size, to twice the digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>
#include <hvi/detail/stages/free_path.hpp>
// Behind it: its templates find what lanes have for them all the same.
#include <hvi/detail/lanes/velocity_lanes.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/stages/velocity_stages.hpp>
#include <hvi/detail/trajectories/trajectory_stages.hpp>

namespace {

constexpr std::size_t stages = 3;
using Two = std::array<double, 2>;
using Exact = hvi::detail::Pair<long double>;  // 128 bits

// Coefficients of gauss:3, in doubles.
constexpr double b[stages] = {5.0 / 18, 4.0 / 9, 5.0 / 18};
constexpr double c[stages] = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr double n[stages][stages] = {};  // not used where forces are given

/// Each position is moved by its own momentum, with masses that are no powers of two.
struct Apart {
    static constexpr bool has_diagonal_mass = true;
    double K[2] = {1.0 / 3, 0.7};
    template <class In, class Out>
    void inverse_mass(const In& p, Out& out) const {
        for (std::size_t k = 0; k < 2; ++k) { out[k] = K[k] * p[k]; }
    }
    template <class In, class Out>
    void dHdp(const In& p, Out& out) const {
        inverse_mass(p, out);
    }
};

/// Positions are moved by sums of momenta, and by a constant velocity.
struct Together {
    static constexpr bool has_diagonal_mass = false;
    template <class In, class Out>
    void inverse_mass(const In& p, Out& out) const {
        out[0] = 2.0 * p[0] - p[1];
        out[1] = 2.0 * p[1] - p[0];
    }
    void dHdp(const Two& p, Two& out) const {
        inverse_mass(p, out);
        out[0] += 0.5;
    }
};

/// Numbers in [1, 2) without a pattern.
double number(int i) { return 1 + std::fmod(0.6180339887498949 * i, 1.0); }

double force(std::size_t j, std::size_t k) {
    return 0.1 * number(static_cast<int>(17 + 5 * j + 3 * k));
}

constexpr Two momenta = {0.3, -1.7};

Exact exact(double x) { return {static_cast<long double>(x), 0}; }

/// |a - b|, in units of 2^-100.
double distance(const Exact& x, const Exact& y) {
    return static_cast<double>(std::abs((x - y).hi) * 0x1p100L);
}

/// The exact sum of the rounded kicks of component k: `factor` times its change.
struct Kicked {
    double factor;
    Exact kicks{};

    Kicked(double factor_, std::size_t k) : factor(factor_) {
        for (std::size_t j = 0; j < stages; ++j) {
            const volatile double kick = factor * force(j, k);
            kicks = kicks + exact(kick);
        }
    }

    [[nodiscard]] double error(double from, double to, double remainder) const {
        const Exact next = exact(factor) * (exact(to) + exact(remainder));
        return distance(next, exact(factor) * exact(from) + kicks);
    }
};

template <class System>
hvi::detail::VelocityStages<Two, stages> begun(const System& system, double h) {
    hvi::detail::VelocityStages<Two, stages> s;
    REQUIRE(s.begin({{0.4, 0.9}, momenta}, h).ok());
    s.weigh(system, b);
    s.drift_freely(system, c);
    for (std::size_t j = 0; j < stages; ++j) {
        for (std::size_t k = 0; k < 2; ++k) { s.Lp[j][k] = force(j, k); }
        s.drift(system, j);
    }
    return s;
}

}  // namespace

// NOTE: with p moved by the forces in place of the kicks these errors are 10^13 and more.

TEST_CASE("one by one, paths are h K p, and p takes what the kicks were rounded to") {
    const Apart system;
    for (const double h : {0.2, 1.0 / 7, -0.0937}) {
        auto s = begun(system, h);
        for (std::size_t k = 0; k < 2; ++k) {
            const Exact path = exact(s.free_path[k]) + exact(s.rest_of_path[k]);
            CHECK(distance(path, exact(h * system.K[k]) * exact(momenta[k])) < 1);
        }
        s.end_p(system);
        for (std::size_t k = 0; k < 2; ++k) {
            const Kicked kicked(h * system.K[k], k);
            CHECK(kicked.error(momenta[k], s.at.p[k], s.remainder.p[k]) < 1);
        }
        s.end_q(0, 0.0);
        const Exact q = exact(s.at.q[0]) + exact(s.remainder.q[0]);
        CHECK(distance(q, exact(0.4) + exact(s.free_path[0]) + exact(s.rest_of_path[0])) < 1);
    }
}

TEST_CASE("where momenta move several positions, they are scaled by h alone") {
    const Together system;
    constexpr double h = 0.2;
    auto s = begun(system, h);
    const Exact u = exact(h) * exact(momenta[0]), v = exact(h) * exact(momenta[1]);
    const Exact path = exact(s.free_path[0]) + exact(s.rest_of_path[0]);
    // h/2 is rounded once; it is a constant.
    CHECK(std::abs(static_cast<double>((path - (u + u - v + exact(0.1))).hi)) < 0x1p-53);
    s.end_p(system);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(Kicked(h, k).error(momenta[k], s.at.p[k], s.remainder.p[k]) < 1);
    }
}

TEST_CASE("a momentum that moves nothing takes the forces") {
    Apart system;
    system.K[1] = 0;
    auto s = begun(system, 0.2);
    s.end_p(system);
    Exact sum = exact(momenta[1]);
    for (std::size_t j = 0; j < stages; ++j) { sum = sum + exact(force(j, 1)); }
    CHECK(distance(exact(s.at.p[1]) + exact(s.remainder.p[1]), sum) < 1);
    const Kicked kicked(0.2 * system.K[0], 0);
    CHECK(kicked.error(momenta[0], s.at.p[0], s.remainder.p[0]) < 1);
}

TEST_CASE("stages side by side do the same") {
    const Apart system;
    constexpr double h = 0.2;
    hvi::detail::VelocityLanes<Two, stages> s;
    REQUIRE(s.begin({{0.4, 0.9}, momenta}, h).ok());
    s.weigh(system, b);
    const hvi::detail::VelocityTable<double, stages> table(c, n);
    s.drift_freely(system, table);
    for (std::size_t k = 0; k < 2; ++k) {
        const Exact path = exact(s.free_path[k]) + exact(s.rest_of_path[k]);
        CHECK(distance(path, exact(h * system.K[k]) * exact(momenta[k])) < 1);
        for (std::size_t j = 0; j < stages; ++j) { s.Lp[k].set(j, force(j, k)); }
    }
    s.drifts(system);
    s.advance(system, table);
    for (std::size_t k = 0; k < 2; ++k) {
        const Kicked kicked(h * system.K[k], k);
        CHECK(kicked.error(momenta[k], s.at.p[k], s.remainder.p[k]) < 1);
    }
}

TEST_CASE("trajectories side by side do the same") {
    const Apart system;
    constexpr double h = 0.2;
    using Stages = hvi::detail::VelocityTrajectories<Two, stages>;
    typename Stages::State x(hvi::State<Two>{{0.4, 0.9}, momenta});
    Stages s;
    for (std::size_t lane = 0; lane < hvi::trajectories_at_once; ++lane) { s.resize(lane, h, b); }
    REQUIRE(s.begin(x));
    s.drift_freely(system, c);
    const typename Stages::Mask all(true);
    s.forces(system, all, [&](std::size_t j, auto& out) {
        // Such that -h b_j of it is about the force; what it is exactly is read from Lp.
        for (std::size_t k = 0; k < 2; ++k) { out[k] = force(j, k) / (-h * b[j]); }
    });
    const struct {
        typename Stages::Mask converged, not_finite;
        typename Stages::Lane iterations;
    } outcome{all, typename Stages::Mask(false), 1.0};
    REQUIRE(s.advance(system, x, outcome, c).ok());
    for (std::size_t k = 0; k < 2; ++k) {
        const double factor = h * system.K[k];
        Exact kicks{};
        for (std::size_t j = 0; j < stages; ++j) {
            CHECK(s.Lp[j][k][5] == Approx(force(j, k)));
            const volatile double kick = factor * s.Lp[j][k][5];
            kicks = kicks + exact(kick);
        }
        const Exact next = exact(factor) * (exact(x.p[k][5]) + exact(x.carried.p[k][5]));
        CHECK(distance(next, exact(factor) * exact(momenta[k]) + kicks) < 1);
    }
}

TEST_CASE("products and sums keep what rounding cuts off") {
    using Lane = hvi::Lanes<double, 4>;
    double x[4], y[4];
    for (int i = 0; i < 4; ++i) {
        x[i] = number(i);
        y[i] = number(10 + i);
    }
    const hvi::detail::Pair<Lane> products = two_product(Lane::load(x), Lane::load(y));
    double hi[4], lo[4];
    products.hi.store(hi);
    products.lo.store(lo);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(distance(exact(hi[i]) + exact(lo[i]), exact(x[i]) * exact(y[i])) == 0);
    }

    const auto check = [&](auto pair, std::size_t count) {
        Exact sum{};
        for (std::size_t i = 0; i < count; ++i) { sum = sum + exact(hi[i % 4] * std::pow(3.0, i)); }
        CHECK(distance(exact(pair.hi) + exact(pair.lo), sum) < 1);
    };
    std::array<double, 16> terms{};
    for (std::size_t i = 0; i < terms.size(); ++i) { terms[i] = hi[i % 4] * std::pow(3.0, i); }
    check(hvi::detail::exact_sum_of<1>(terms.data()), 1);
    check(hvi::detail::exact_sum_of<2>(terms.data()), 2);
    check(hvi::detail::exact_sum_of<3>(terms.data()), 3);
    check(hvi::detail::exact_sum_of<6>(terms.data()), 6);
    check(hvi::detail::exact_sum_of<7>(terms.data()), 7);
    check(hvi::detail::exact_sum_of<8>(terms.data()), 8);
    const auto term = [&](std::size_t i) { return terms[i]; };
    check(hvi::detail::exact_sum<double, 5>(term), 5);
    check(hvi::detail::exact_sum<double, 16>(term), 16);
}
