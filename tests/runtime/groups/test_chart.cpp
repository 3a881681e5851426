// The natural chart of SO(3): against series, identities and differences in more digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include <catch2/catch.hpp>
#include <hvi/detail/groups/chart.hpp>
#include <hvi/detail/groups/orthogonal.hpp>

using namespace hvi::detail;

namespace {

using Long = long double;

/// c_k(y) by its series in long double, where the terms do not cancel too much.
Long series(int k, Long y) {
    Long factorial = 1;
    for (int i = 2; i <= k; ++i) { factorial *= i; }
    Long term = 1 / factorial, sum = 0;
    for (int j = 1; j < 60; ++j) {
        sum += term;
        term *= -y / static_cast<Long>((k + 2 * j - 1) * (k + 2 * j));
    }
    return sum;
}

struct Random {
    std::mt19937 engine{7};
    std::uniform_real_distribution<double> inside{-1, 1};

    Vector3<double> vector() { return {inside(engine), inside(engine), inside(engine)}; }
    Vector3<double> of_length(double length) {
        const Vector3<double> v = vector();
        return (length / std::sqrt(dot(v, v))) * v;
    }
};

Vector3<Long> wide(const Vector3<double>& v) { return {Long(v[0]), Long(v[1]), Long(v[2])}; }

/// The derivative by component a of xi, by differences of fourth order.
template <class F>
Long derivative(const Vector3<double>& xi, std::size_t a, F f) {
    constexpr Long h = 1e-4L;
    const auto at = [&](Long e) {
        Vector3<Long> x = wide(xi);
        x[a] += e;
        return f(ChartPoint<Long>(x));
    };
    return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

constexpr std::array lengths{1e-9, 1e-3, 0.3, 1.0, 1.999999, 2.000001, 3.1, 3.2, 5.0, 6.2};

}  // namespace

TEST_CASE("the functions of an angle are those of their series, on both sides of the switch") {
    for (int i = 0; i <= 4000; ++i) {
        const double y = 39.4 * i / 4000;
        const AngleFunctions<double> c = angle_functions(y);
        const std::array values{c.c1, c.c2, c.c3, c.c4, c.c5, c.c6, c.c7};
        const std::array bounds{1.0, 1.0, 6.0, 14.0, 35.0, 100.0, 300.0};
        for (std::size_t k = 0; k < values.size(); ++k) {
            const Long exact = series(static_cast<int>(k) + 1, Long(y));
            // NOTE: c_1 and c_2 vanish at angles of pi and 2 pi, and are right to parts of 1.
            const double size = k < 2 ? 1 : static_cast<double>(exact);
            CAPTURE(y, k);
            CHECK(std::abs(static_cast<double>(Long(values[k]) - exact)) <
                  bounds[k] * 2.3e-16 * size);
        }
    }
}

TEST_CASE("rounding has no bias in the functions of an angle, so that derivatives stay those") {
    // Values are off by up to half a unit in the last place, 7e-18 for c_3. Where the constant is
    // off, as the nearest number to 1/6 is by 9e-18, that shows in the mean: c_2' is then no longer
    // (2 c_4 - c_3)/2, and T has other derivatives than gradient().
    Random random;
    constexpr int count = 400'000;
    std::array<double, 5> mean{};  // in units of 1e-18
    for (int i = 0; i < count; ++i) {
        const double y = 0.6 + 0.4 * random.inside(random.engine);
        const AngleFunctions<double> c = angle_functions(y);
        const std::array values{c.c1, c.c2, c.c3, c.c4, c.c5};
        for (std::size_t k = 0; k < values.size(); ++k) {
            const Long off = Long(values[k]) - series(static_cast<int>(k) + 1, Long(y));
            mean[k] += 1e18 * static_cast<double>(off) / count;
        }
    }
    // A hundredth of a unit in the last place, but for what this many values scatter.
    const std::array bounds{0.5, 0.5, 0.3, 0.07, 0.009};
    for (std::size_t k = 0; k < mean.size(); ++k) {
        CAPTURE(k);
        CHECK(std::abs(mean[k]) < bounds[k]);
    }
    CHECK(std::abs(2 * mean[3] - mean[2]) < 0.3);
}

TEST_CASE("T and its inverse, and the exponential map, belong together") {
    Random random;
    for (const double length : lengths) {
        for (int i = 0; i < 50; ++i) {
            const ChartPoint<double> point(random.of_length(length));
            const Vector3<double> v = random.vector();
            const double near = length > 5 ? 2e-13 : 4e-15;
            const auto is_near = [&](const Vector3<double>& a, const Vector3<double>& b,
                                     double off) {
                const Vector3<double> d = a - b;
                CHECK(std::sqrt(dot(d, d)) < off);
            };
            CAPTURE(length);
            is_near(point.T_inverse(point.T(v)), v, near);
            is_near(point.T_inverse_transposed(point.T_transposed(v)), v, near);
            // dexp_xi = exp(hat xi) dexp_{-xi}
            is_near(point.turned(point.T(v)), point.T_transposed(v), 4e-15);
            is_near(point.turned_back(point.turned(v)), v, 4e-15);
            const Vector3<double> w = random.vector();
            CHECK(dot(point.T(v), w) == Approx(dot(v, point.T_transposed(w))).margin(1e-14));
        }
    }
}

TEST_CASE("starting values leave out terms of T^-1 of the eighth power alone") {
    // T^-1 = 1 + hat xi/2 + (1/12 + x^2/720 + x^4/30240 + x^6/1209600 + ...) hat xi^2, by
    // Bernoulli's numbers; each term is at most 1/39 of the one before, times x^2.
    Random random;
    for (const double length : {1e-9, 1e-3, 0.1, 0.3, 1.0, 2.0, 3.0}) {
        const Vector3<double> xi = random.of_length(length), v = random.of_length(1);
        const Vector3<double> off = ChartPoint<double>(xi).T_inverse(v) - nearly_T_inverse(xi, v);
        CAPTURE(length);
        CHECK(std::sqrt(dot(off, off)) <
              std::pow(length, 8) / (1209600 * (1 - length * length / 39)) + 1e-15);
    }
}

TEST_CASE("T xi' is the angular velocity of exp(hat xi) in the body") {
    Random random;
    for (const double length : lengths) {
        const Vector3<double> xi = random.of_length(length), v = random.vector();
        const ChartPoint<Long> point(wide(xi));
        // exp(-hat xi) d/de exp(hat(xi + e v)) w = (T v) x w
        const Vector3<double> w = random.vector();
        Vector3<Long> moved{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t a = 0; a < 3; ++a) {
                moved[i] += Long(v[a]) * derivative(xi, a, [&](const ChartPoint<Long>& at) {
                                return at.turned(wide(w))[i];
                            });
            }
        }
        const Vector3<Long> seen = point.turned_back(moved);
        const Vector3<Long> expected = cross(point.T(wide(v)), wide(w));
        CAPTURE(length);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(std::abs(static_cast<double>(seen[i] - expected[i])) < 1e-13);
        }
    }
}

TEST_CASE("the derivatives of the chart are those of T") {
    Random random;
    for (const double length : lengths) {
        for (int i = 0; i < 10; ++i) {
            const Vector3<double> xi = random.of_length(length);
            const Vector3<double> L = random.vector(), w = random.vector();
            const ChartPoint<double> point(xi);
            const Vector3<double> gradient = point.gradient(L, w);
            const Matrix3<double> of_T = point.derivative_of_T(w);
            const Matrix3<double> of_transposed = point.derivative_of_T_transposed(L);
            const Matrix3<double> hessian = point.hessian(L, w);
            CAPTURE(length);
            for (std::size_t a = 0; a < 3; ++a) {
                const auto is_near = [&](double seen, auto f) {
                    CHECK(std::abs(static_cast<double>(Long(seen) - derivative(xi, a, f))) < 2e-13);
                };
                is_near(gradient[a], [&](const auto& at) { return dot(wide(L), at.T(wide(w))); });
                for (std::size_t k = 0; k < 3; ++k) {
                    is_near(of_T[3 * k + a], [&](const auto& at) { return at.T(wide(w))[k]; });
                    is_near(of_transposed[3 * k + a],
                            [&](const auto& at) { return at.T_transposed(wide(L))[k]; });
                    is_near(hessian[3 * k + a],
                            [&](const auto& at) { return at.gradient(wide(L), wide(w))[k]; });
                }
            }
        }
    }
}

TEST_CASE("the way to a rotation is of second order and turns nothing") {
    Random random;
    const ChartPoint<double> point(random.of_length(2));
    Matrix3<double> R = point.turn();
    for (std::size_t i = 0; i < 3; ++i) { R[4 * i] += 1; }
    CHECK(is_rotation(R));
    // A strain of 1e-5: R (1 + S), with a symmetric S.
    const Matrix3<double> strained =
        product(R, Matrix3<double>{1 + 1e-5, 2e-6, 3e-6, 2e-6, 1 - 1e-5, 4e-6, 3e-6, 4e-6, 1});
    CHECK_FALSE(is_rotation(strained));
    const Matrix3<double> way = way_to_rotation(strained);
    for (std::size_t k = 0; k < 9; ++k) { CHECK(std::abs(strained[k] + way[k] - R[k]) < 4e-10); }
    Matrix3<double> mirrored = R;
    for (std::size_t k = 0; k < 3; ++k) { mirrored[k] = -mirrored[k]; }
    CHECK_FALSE(is_rotation(mirrored));
    CHECK_FALSE(is_rotation(Matrix3<double>{}));
}
