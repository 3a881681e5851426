// Sums over pairs of indices, in lanes and in chunks, against loops over all of them in long
// double.
// SPDX-License-Identifier: GPL-2.0-or-later

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/chunks.hpp>

namespace {

using hvi::detail::Place;
using hvi::detail::Team;
using Long = long double;

std::vector<double> numbers(std::size_t count, std::size_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> result(count);
    for (double& x : result) { x = number(random); }
    return result;
}

constexpr std::size_t sizes[] = {1, 2, 3, 4, 5, 8, 9, 16, 17, 19, 20, 64, 65, 300, 1000};

/// Whether all agree to so many units in the last place of the largest.
bool agree(const std::vector<double>& x, const std::vector<Long>& expected, double ulps) {
    Long largest = 0;
    for (const Long each : expected) { largest = std::max(largest, std::abs(each)); }
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(std::abs(Long(x[i]) - expected[i]) <= Long(ulps) * 0x1p-53L * largest)) {
            return false;
        }
    }
    return x.size() == expected.size();
}

/// H = - sum_{i<j} m_i m_j / sqrt(r^2 + eps^2), as hvi-gen writes it.
template <std::size_t width>
struct Gravity {
    explicit Gravity(std::size_t n) : N(n), m(numbers(n, n + 1)) {}

    std::size_t N;
    std::vector<double> m;
    double eps = 0.1;

    void add_pairs(const double* q, double* out, Place from, Place to, Place stride) const {
        const Place n = static_cast<Place>(N);
        const double* const x = q;
        const double* const y = q + n;
        double* const out_x = out;
        double* const out_y = out + n;
        for (Place i = from; i < to; i += stride) {
            const double x_i = x[i], y_i = y[i], m_i = m[static_cast<std::size_t>(i)];
            const double* const m_ = m.data();
            const double eps2 = eps * eps;
            hvi::detail::Total<double, width> total_x, total_y;
            hvi::detail::along<double, width>(i + 1, n, [&](auto stretch, Place j) HVI_INLINED {
                const auto dx = x_i - stretch.load(x + j);
                const auto dy = y_i - stretch.load(y + j);
                const auto r2 = dx * dx + dy * dy + eps2;
                const auto f = m_i * stretch.load(m_ + j) / (r2 * hvi::math::sqrt(r2));
                const auto f_x = f * dx;
                const auto f_y = f * dy;
                total_x.add(f_x);
                total_y.add(f_y);
                hvi::detail::subtract(out_x + j, f_x);
                hvi::detail::subtract(out_y + j, f_y);
            });
            out_x[i] += total_x.sum();
            out_y[i] += total_y.sum();
        }
    }

    [[nodiscard]] std::vector<double> slope(const std::vector<double>& q, Team& team) const {
        std::vector<double> out(2 * N, 0.0), memory;
        hvi::detail::chunked(team, 0, static_cast<Place>(N), out.data(), out.size(), memory,
                             [&](Place from, Place to, Place stride, double* part) {
                                 add_pairs(q.data(), part, from, to, stride);
                             });
        return out;
    }

    [[nodiscard]] double energy(const std::vector<double>& q) const {
        const Place n = static_cast<Place>(N);
        const double* const x = q.data();
        const double* const y = x + n;
        const double* const m_ = m.data();
        hvi::detail::CompensatedTotal<double> total;
        for (Place i = 0; i < n; ++i) {
            const double x_i = x[i], y_i = y[i], m_i = m_[i], eps2 = eps * eps;
            hvi::detail::Total<double, width> inner;
            hvi::detail::along<double, width>(i + 1, n, [&](auto stretch, Place j) HVI_INLINED {
                const auto dx = x_i - stretch.load(x + j);
                const auto dy = y_i - stretch.load(y + j);
                inner.add(-(m_i * stretch.load(m_ + j)) /
                          hvi::math::sqrt(dx * dx + dy * dy + eps2));
            });
            total.add(inner.sum());
        }
        return total.sum();
    }
};

/// Each pair twice, from the last to the first.
template <std::size_t width>
std::vector<Long> all_pairs(const Gravity<width>& of, const std::vector<double>& q) {
    const std::size_t n = of.N;
    const Long eps = Long(of.eps);
    std::vector<Long> out(2 * n, 0.0L);
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = n; j-- > 0;) {
            const Long dx = Long(q[i]) - Long(q[j]), dy = Long(q[n + i]) - Long(q[n + j]);
            const Long r = std::sqrt(dx * dx + dy * dy + eps * eps);
            const Long f = i == j ? 0 : Long(of.m[i]) * Long(of.m[j]) / (r * r * r);
            out[i] += f * dx;
            out[n + i] += f * dy;
        }
    }
    return out;
}

template <std::size_t width>
Long energy_of(const Gravity<width>& of, const std::vector<double>& q) {
    const std::size_t n = of.N;
    const Long eps = Long(of.eps);
    Long result = 0;
    for (std::size_t j = n; j-- > 0;) {
        for (std::size_t i = 0; i < j; ++i) {
            const Long dx = Long(q[i]) - Long(q[j]), dy = Long(q[n + i]) - Long(q[n + j]);
            result -= Long(of.m[i]) * Long(of.m[j]) / std::sqrt(dx * dx + dy * dy + eps * eps);
        }
    }
    return result;
}

TEMPLATE_TEST_CASE_SIG("forces and energies of pairs", "", ((std::size_t width), width), 1, 2, 4,
                       8) {
    Team team(2);
    for (const std::size_t n : sizes) {
        CAPTURE(n);
        const Gravity<width> gravity(n);
        const std::vector<double> q = numbers(2 * n, n);
        const double terms = static_cast<double>(n);
        CHECK(agree(gravity.slope(q, team), all_pairs(gravity, q), 20 * std::sqrt(terms)));
        CHECK(agree({gravity.energy(q)}, {energy_of(gravity, q)}, 30 * std::sqrt(terms)));
    }
}

TEST_CASE("the bits do not depend on how many threads there are, nor on who takes what") {
    for (const std::size_t n : {20U, 255U, 256U, 257U, 1000U}) {
        CAPTURE(n);
        const Gravity<4> gravity(n);
        const std::vector<double> q = numbers(2 * n, n);
        Team one(1);
        const std::vector<double> expected = gravity.slope(q, one);
        for (const unsigned threads : {2U, 3U, 5U}) {
            Team team(threads);
            for (int again = 0; again < 20; ++again) {
                if (gravity.slope(q, team) != expected) { FAIL(threads << " threads"); }
            }
        }
    }
}

TEST_CASE("chunks add to what is there, and their memory may be larger and used before") {
    Team team(3);
    const auto count =
        GENERATE(Place{0}, Place{1}, Place{255}, Place{256}, Place{1000}, Place{9999});
    std::vector<double> out{1, 2, 3}, memory(1000, 77.0);
    hvi::detail::chunked(team, 5, 5 + count, out.data(), out.size(), memory,
                         [](Place from, Place to, Place stride, double* part) {
                             for (Place i = from; i < to; i += stride) {
                                 part[0] += 1;
                                 part[1] += static_cast<double>(i);
                             }
                         });
    const double n = static_cast<double>(count);
    CHECK(out == std::vector<double>{1 + n, 2 + 5 * n + n * (n - 1) / 2, 3});
    CHECK(hvi::detail::chunks_of(count, 3 * static_cast<std::size_t>(count)) >= 1);
}

TEMPLATE_TEST_CASE_SIG("each index has its turn once, and none where there is none", "",
                       ((std::size_t width), width), 1, 2, 4, 8) {
    for (Place first = -3; first < 4; ++first) {
        for (Place last = first - 20; last < first + 40; ++last) {
            std::vector<Place> seen;
            double sum = 0;
            hvi::detail::Total<double, width> total;
            hvi::detail::along<double, width>(first, last, [&](auto stretch, Place j) {
                for (Place k = 0; k < stretch.count; ++k) { seen.push_back(j + k); }
                total.add(stretch.indices(j));
            });
            std::vector<Place> expected;
            for (Place j = first; j < last; ++j) {
                expected.push_back(j);
                sum += static_cast<double>(j);
            }
            if (seen != expected) { FAIL(first << " to " << last); }
            REQUIRE(total.sum() == sum);
        }
    }
}

/// H = sum over all i and j of K[i,j] q[i]^2 q[j], where i = j is allowed and K is not symmetric.
TEST_CASE("a rectangle with its diagonal") {
    const std::size_t n = GENERATE(1U, 2U, 3U, 7U, 8U, 19U, 64U, 65U);
    const std::vector<double> K = numbers(n * n, 7), q = numbers(n, 8);
    const Place size = static_cast<Place>(n);
    std::vector<double> out(n, 0.0);
    for (Place i = 0; i < size; ++i) {
        const double q_i = q[static_cast<std::size_t>(i)];
        const double* const row = K.data() + i * size;
        hvi::detail::Total<double, 4> total;
        hvi::detail::along<double, 4>(0, size, [&](auto stretch, Place j) HVI_INLINED {
            const auto k = stretch.load(row + j);
            total.add(2 * q_i * k * stretch.load(q.data() + j));
            hvi::detail::add(out.data() + j, q_i * q_i * k);
        });
        out[static_cast<std::size_t>(i)] += total.sum();
    }
    std::vector<Long> expected(n, 0.0L);
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = n; j-- > 0;) {
            const Long x = Long(q[j]);
            expected[k] += 2 * Long(q[k]) * Long(K[k * n + j]) * x + Long(K[j * n + k]) * x * x;
        }
    }
    CHECK(agree(out, expected, 4 * static_cast<double>(n)));
}

/// H = sum_i sum_{j>i}^{n-1} cos(q[i]) (q[j+1] - q[j])^3: two neighbours in lanes.
TEST_CASE("neighbours, both of them in lanes") {
    const std::size_t n = GENERATE(1U, 2U, 3U, 9U, 19U, 20U, 64U, 65U);
    const std::vector<double> q = numbers(n, 9);
    const Place size = static_cast<Place>(n);
    std::vector<double> out(n, 0.0);
    const double* const at = q.data();
    double* const to = out.data();
    for (Place i = 0; i < size; ++i) {
        const double cos_i = std::cos(at[i]), sin_i = std::sin(at[i]);
        hvi::detail::Total<double, 8> total;
        hvi::detail::along<double, 8>(i + 1, size - 1, [&](auto stretch, Place j) HVI_INLINED {
            const auto d = stretch.load(at + j + 1) - stretch.load(at + j);
            const auto f = 3 * cos_i * d * d;
            total.add(-sin_i * d * d * d);
            hvi::detail::add(to + j + 1, f);
            hvi::detail::subtract(to + j, f);
        });
        to[i] += total.sum();
    }
    std::vector<Long> expected(n, 0.0L);
    for (std::size_t j = 0; j + 1 < n; ++j) {
        const Long d = Long(q[j + 1]) - Long(q[j]);
        for (std::size_t i = 0; i < j; ++i) {
            const Long x = Long(q[i]);
            expected[i] -= std::sin(x) * d * d * d;
            expected[j + 1] += 3 * std::cos(x) * d * d;
            expected[j] -= 3 * std::cos(x) * d * d;
        }
    }
    CHECK(agree(out, expected, 4 * static_cast<double>(n)));
}

/// H = sum_{i<j} (q[i] - 3 q[j]).
TEST_CASE("what is the same for all inner indices is spread") {
    const Place n = 23;
    std::vector<double> out(23, 0.0);
    for (Place i = 0; i < n; ++i) {
        hvi::detail::Total<double, 4> total;
        hvi::detail::along<double, 4>(i + 1, n, [&](auto stretch, Place j) HVI_INLINED {
            total.add(stretch.spread(1));
            hvi::detail::subtract(out.data() + j, stretch.spread(3));
        });
        out[static_cast<std::size_t>(i)] += total.sum();
    }
    std::vector<double> expected;
    for (int i = 0; i < 23; ++i) { expected.push_back(22 - i - 3 * i); }
    CHECK(out == expected);
}

TEST_CASE("a compensated total keeps what a sum loses") {
    hvi::detail::CompensatedTotal<double> total;
    CHECK(total.sum() == 0);
    total.add(1e16);
    for (int i = 0; i < 1000; ++i) { total.add(0.25); }
    total.add(-1e16);
    CHECK(total.sum() == 250);
}

}  // namespace
