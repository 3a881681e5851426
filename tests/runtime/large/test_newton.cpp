// Newton's method of large scenes: against closed forms, where springs are linear, and against
// Newton's method by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <catch2/catch.hpp>
#include <large/all_pairs.hpp>
#include <large/all_pairs_3.hpp>
#include <large/chain_rule.hpp>
#include <large/hard_springs.hpp>
#include <large/masses_gauss.hpp>
#include <large/masses_newton.hpp>
#include <large/membrane.hpp>
#include <large/membrane_3.hpp>
#include <large/springs.hpp>
#include <large/springs_3.hpp>

namespace {

using Real = long double;
using Complex = std::complex<Real>;
using Vector = std::vector<double>;
using State = hvi::State<Vector>;
using Code = hvi::Status::Code;
namespace generated = hvi::generated;

const Real pi = std::acos(Real(-1));

Real real(std::size_t i) { return static_cast<Real>(i); }

/// Returns the factor of exp(z t) in a step of Gauss' method: the diagonal Pade approximation of
/// exp(z).
template <int stages>
Complex growth(Complex z) {
    const Complex even = stages == 2 ? 1.0L + z * z / 12.0L : 1.0L + z * z / 10.0L;
    const Complex odd = stages == 2 ? z / 2.0L : z / 2.0L + z * z * z / 120.0L;
    return (even + odd) / (even - odd);
}

/// Solves q'' = -omega^2 q, with q + i p/omega = w, for `steps` steps of size h.
template <int stages>
Complex turned(Complex w, Real omega, Real h, int steps) {
    for (int step = 0; step < steps; ++step) { w *= growth<stages>(Complex(0, -omega * h)); }
    return w;
}

/// A shape that oscillates.
struct Mode {
    std::vector<Real> shape;
    Real omega;
    Complex start;  ///< q + i p/omega at the start
};

/// The sum of modes after some steps, each of few iterations: with the right factors the second
/// correction of linear equations is one of rounding.
template <int stages, class Stepper>
void check_modes(Stepper stepper, const std::vector<Mode>& modes, double h, int most_iterations) {
    constexpr int steps = 20;
    const std::size_t n = modes.front().shape.size();
    const auto at = [&](int step) {
        std::vector<Real> q(n, 0), p(n, 0);
        for (const Mode& mode : modes) {
            const Complex w = turned<stages>(mode.start, mode.omega, static_cast<Real>(h), step);
            for (std::size_t i = 0; i < n; ++i) {
                q[i] += w.real() * mode.shape[i];
                p[i] += w.imag() * mode.omega * mode.shape[i];
            }
        }
        return std::pair(q, p);
    };
    const auto begin = at(0);
    State x{Vector(begin.first.begin(), begin.first.end()),
            Vector(begin.second.begin(), begin.second.end())};
    for (int step = 0; step < steps; ++step) {
        const hvi::Status status = stepper.step(x, h);
        REQUIRE(status.ok());
        CHECK(status.iterations <= most_iterations);
    }
    const auto end = at(steps);
    Real size_p = 1;
    for (const Mode& mode : modes) { size_p = std::max(size_p, mode.omega); }
    // NOTE: a step adds h v, which is omega h times as large as q.
    const Real near = 1e-15L * (200 + 2 * size_p * static_cast<Real>(h));
    for (std::size_t i = 0; i < n; ++i) {
        CAPTURE(i);
        CHECK(std::abs(static_cast<Real>(x.q[i]) - end.first[i]) < near);
        CHECK(std::abs(static_cast<Real>(x.p[i]) - end.second[i]) < near * size_p);
    }
}

template <class Stepper>
Stepper of_size(std::size_t n) {
    typename Stepper::Parameters parameters;
    parameters.N = static_cast<std::ptrdiff_t>(n);
    return Stepper(parameters);
}

std::vector<Mode> modes_of_springs(std::size_t n) {
    std::vector<Mode> modes;
    for (const std::size_t j : {std::size_t{1}, (n + 1) / 2, n}) {
        Mode mode{{}, 20 * std::sin(pi * real(j) / (2 * real(n + 1))), {0.3L, 0.1L * real(j % 3)}};
        for (std::size_t i = 1; i <= n; ++i) {
            mode.shape.push_back(std::sin(pi * real(i * j) / real(n + 1)));
        }
        modes.push_back(mode);
    }
    return modes;
}

std::vector<Mode> modes_of_membrane(std::size_t n) {
    std::vector<Mode> modes;
    for (const std::size_t a : {std::size_t{0}, std::size_t{1}, n / 2}) {
        const std::size_t b = (2 * a) % n;
        const Real first = std::sin(pi * real(a) / real(n));
        const Real second = std::sin(pi * real(b) / real(n));
        Mode mode{{}, std::sqrt(400 * (first * first + second * second) + 1), {0.2L, -0.3L}};
        for (std::size_t k = 0; k < n * n; ++k) {
            mode.shape.push_back(std::cos(2 * pi * real(k / n * a + k % n * b) / real(n)));
        }
        modes.push_back(mode);
    }
    return modes;
}

/// All deviate from their mean, which rests.
std::vector<Mode> modes_of_pairs(std::size_t n) {
    Mode mode{{}, std::sqrt(2 * real(n)), {0.4L, 0.2L}};
    for (std::size_t i = 0; i < n; ++i) {
        mode.shape.push_back(std::cos(2 * pi * real(3 * i) / real(n)));
    }
    return {mode};
}

// ---- Newton's method by hand ----

using Reals = std::vector<Real>;

/// Gauss' method with two stages for p^2/2 + U(q), U of hard springs: a Nystrom method.
class HandSprings {
public:
    explicit HandSprings(Real h) : h_(h) {}

    void step(Reals& q, Reals& p) const {
        const std::size_t n = q.size();
        const Real r = std::sqrt(Real(3)) / 6;
        const Real a[2][2] = {{0.25L, 0.25L - r}, {0.25L + r, 0.25L}};
        const Real c[2] = {0.5L - r, 0.5L + r};
        Real b[2][2] = {};
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) { b[i][j] = a[i][0] * a[0][j] + a[i][1] * a[1][j]; }
        }
        Reals Q(2 * n);
        for (std::size_t k = 0; k < 2 * n; ++k) { Q[k] = q[k % n]; }
        for (int iteration = 0; iteration < 40; ++iteration) {
            Reals residual(2 * n);
            std::vector<Reals> J(2 * n, Reals(2 * n, 0));
            for (std::size_t i = 0; i < 2; ++i) {
                for (std::size_t k = 0; k < n; ++k) {
                    residual[i * n + k] = Q[i * n + k] - q[k] - h_ * c[i] * p[k];
                    J[i * n + k][i * n + k] = 1;
                }
            }
            for (std::size_t j = 0; j < 2; ++j) {
                for_each_spring(&Q[j * n], n, [&](auto l, auto m, Real force, Real slope) {
                    for (std::size_t i = 0; i < 2; ++i) {
                        const Real factor = h_ * h_ * b[i][j];
                        const auto add = [&](std::size_t row, Real sign) {
                            if (row >= n) { return; }
                            residual[i * n + row] += sign * factor * force;
                            if (m < n) { J[i * n + row][j * n + m] += sign * factor * slope; }
                            if (l < n) { J[i * n + row][j * n + l] -= sign * factor * slope; }
                        };
                        add(m, 1);
                        add(l, -1);
                    }
                });
            }
            solve(J, residual);
            for (std::size_t k = 0; k < 2 * n; ++k) { Q[k] -= residual[k]; }
        }
        for (std::size_t k = 0; k < n; ++k) { q[k] += h_ * p[k]; }
        for (std::size_t j = 0; j < 2; ++j) {
            for_each_spring(&Q[j * n], n, [&](auto l, auto m, Real force, Real) {
                const auto add = [&](std::size_t row, Real sign) {
                    if (row >= n) { return; }
                    p[row] -= sign * h_ / 2 * force;
                    q[row] -= sign * h_ * h_ / 2 * (1 - c[j]) * force;
                };
                add(m, 1);
                add(l, -1);
            });
        }
    }

private:
    /// Between l and m; the walls are n.
    template <class F>
    static void for_each_spring(const Real* q, std::size_t n, F f) {
        for (std::size_t m = 0; m + 1 < n; ++m) {
            const Real r = q[m + 1] - q[m];
            f(m, m + 1, r + r * r * r, 1 + 3 * r * r);
        }
        f(n, std::size_t{0}, q[0], Real(1));
        f(n, n - 1, q[n - 1], Real(1));
    }

    static void solve(std::vector<Reals>& A, Reals& x) {
        const std::size_t n = x.size();
        for (std::size_t k = 0; k < n; ++k) {
            std::size_t row = k;
            for (std::size_t i = k; i < n; ++i) {
                if (std::abs(A[i][k]) > std::abs(A[row][k])) { row = i; }
            }
            std::swap(A[k], A[row]);
            std::swap(x[k], x[row]);
            for (std::size_t i = k + 1; i < n; ++i) {
                const Real factor = A[i][k] / A[k][k];
                for (std::size_t j = k; j < n; ++j) { A[i][j] -= factor * A[k][j]; }
                x[i] -= factor * x[k];
            }
        }
        for (std::size_t k = n; k-- > 0;) {
            for (std::size_t j = k + 1; j < n; ++j) { x[k] -= A[k][j] * x[j]; }
            x[k] /= A[k][k];
        }
    }

    Real h_;
};

}  // namespace

TEST_CASE("a chain of linear springs, far beyond its fastest period") {
    for (const std::size_t n : {1U, 2U, 3U, 70U, 500U}) {
        CAPTURE(n);
        for (const double h : {0.01, 0.5, 50.0}) {
            check_modes<2>(of_size<generated::Springs>(n), modes_of_springs(n), h, 8);
            check_modes<3>(of_size<generated::Springs3>(n), modes_of_springs(n), h, 8);
        }
    }
}

TEST_CASE("a membrane of linear springs") {
    for (const std::size_t n : {1U, 2U, 3U, 9U, 20U}) {
        CAPTURE(n);
        for (const double h : {0.01, 0.5, 50.0}) {
            check_modes<2>(of_size<generated::Membrane>(n), modes_of_membrane(n), h, 8);
            check_modes<3>(of_size<generated::Membrane3>(n), modes_of_membrane(n), h, 8);
        }
    }
}

TEST_CASE("linear springs between all pairs") {
    for (const std::size_t n : {5U, 70U, 300U}) {
        CAPTURE(n);
        for (const double h : {0.01, 0.5, 5.0}) {
            check_modes<2>(of_size<generated::AllPairs>(n), modes_of_pairs(n), h, 12);
            check_modes<3>(of_size<generated::AllPairs3>(n), modes_of_pairs(n), h, 12);
        }
    }
}

TEST_CASE("springs that become harder, against Newton's method by hand") {
    constexpr std::size_t n = 12;
    auto stepper = of_size<generated::HardSprings>(n);
    State x{Vector(n), Vector(n)};
    for (std::size_t i = 0; i < n; ++i) { x.q[i] = std::sin(7 * static_cast<double>(i + 1)); }
    Reals q(x.q.begin(), x.q.end()), p(n, 0);
    for (int step = 0; step < 4; ++step) {
        REQUIRE(stepper.step(x, 0.5).ok());
        HandSprings(0.5L).step(q, p);
        for (std::size_t i = 0; i < n; ++i) {
            CAPTURE(step, i);
            CHECK(std::abs(static_cast<Real>(x.q[i]) - q[i]) < 1e-13L);
            CHECK(std::abs(static_cast<Real>(x.p[i]) - p[i]) < 1e-13L);
        }
    }
}

TEST_CASE("products of second derivatives have the bits of any number of threads, and are right") {
    const generated::MassesNewton::Parameters parameters;
    generated::MassesNewton one(parameters), two(parameters, 2);
    generated::MassesGauss by_sweeps;
    State x = generated::MassesNewton::initial(), y = x, z = x;
    for (int step = 0; step < 10; ++step) {
        REQUIRE(one.step(x, 0.02).ok());
        REQUIRE(two.step(y, 0.02).ok());
        REQUIRE(by_sweeps.step(z, 0.02).ok());
    }
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
    for (std::size_t i = 0; i < x.q.size(); ++i) {
        CHECK(x.q[i] == Approx(z.q[i]).epsilon(1e-12));
        CHECK(x.p[i] == Approx(z.p[i]).epsilon(1e-12).margin(1e-12));
    }
}

TEMPLATE_TEST_CASE("a copy of a stepper goes on where the other is, and needs it no more", "",
                   generated::Springs, generated::Membrane, generated::AllPairs) {
    std::optional<TestType> first(TestType{});
    State x = TestType::initial();
    REQUIRE(first->step(x, 0.5).ok());
    TestType second(*first);
    State y = x;
    REQUIRE(first->step(x, 0.5).ok());
    first.reset();
    REQUIRE(second.step(y, 0.5).ok());
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
}

TEST_CASE("more nodes than functions: two functions at Gauss' three nodes are of order 4") {
    const auto error = [](int steps) {
        auto stepper = of_size<generated::ChainRule>(20);
        State x = generated::ChainRule::initial();
        x.q.resize(20);
        x.p.resize(20);
        for (int step = 0; step < steps; ++step) {
            if (!stepper.step(x, 2.0 / steps).ok()) { return Vector{}; }
        }
        return x.q;
    };
    const Vector coarse = error(4), middle = error(8), fine = error(16);
    REQUIRE(fine.size() == 20);
    Real first = 0, second = 0;
    for (std::size_t i = 0; i < 20; ++i) {
        first = std::max(first, static_cast<Real>(std::abs(coarse[i] - middle[i])));
        second = std::max(second, static_cast<Real>(std::abs(middle[i] - fine[i])));
    }
    CHECK(std::log2(first / second) == Approx(4).margin(0.3));
}

TEST_CASE("a step that fails says why, and leaves every bit") {
    auto stepper = of_size<generated::HardSprings>(100);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, 1e200}) {
        State x{Vector(100, 0.25), Vector(100, 0.5)};
        x.q[50] = bad;
        const State before = x;
        const hvi::Status status = stepper.step(x, 0.5);
        CHECK_FALSE(status.ok());
        CHECK(x.p == before.p);
        for (std::size_t i = 0; i < 100; ++i) {
            CHECK((x.q[i] == before.q[i] || (i == 50 && std::isnan(bad))));
        }
        // And the next step from elsewhere is that of a fresh stepper.
        State y{Vector(100, 0.25), Vector(100, 0.5)}, z = y;
        REQUIRE(stepper.step(y, 0.5).ok());
        REQUIRE(of_size<generated::HardSprings>(100).step(z, 0.5).ok());
        CHECK(y.q == z.q);
        CHECK(y.p == z.p);
    }
}
