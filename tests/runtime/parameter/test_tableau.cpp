// Generated steppers with a parameter have the right coefficients: those of Algorithm 4.3, carried
// out with 1500 bits from functions and integrals that stand here.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/coefficients/coefficients.hpp>

#include "ball.hpp"
#include "numbers.hpp"
#include "parameter/exponential.hpp"
#include "parameter/gauss.hpp"
#include "parameter/moving_node.hpp"
#include "parameter/times_pi.hpp"
#include "parameter/trigonometric.hpp"
#include "parameter/two_frequencies.hpp"
#include "parameter/with_line.hpp"

using parameter::Ball;
using parameter::Numbers;
using Balls = std::vector<Ball>;
using BallMatrix = std::vector<Balls>;
using Code = hvi::Status::Code;

namespace {

/// A basis function: its value and its integral from 0.
struct Psi {
    std::function<Ball(const Ball& tau)> value;
    std::function<Ball(const Ball& tau)> integral;
};

Psi power(int n) {
    const auto raised = [](const Ball& tau, int exponent) {
        Ball result(1.0);
        for (int i = 0; i < exponent; ++i) { result = result * tau; }
        return result;
    };
    return {[=](const Ball& tau) { return raised(tau, n); },
            [=](const Ball& tau) { return raised(tau, n + 1) / Ball(n + 1.0); }};
}
Psi cosine(const Ball& w) {
    return {[=](const Ball& tau) { return cos(w * tau); },
            [=](const Ball& tau) { return sin(w * tau) / w; }};
}
Psi sine(const Ball& w) {
    return {[=](const Ball& tau) { return sin(w * tau); },
            [=](const Ball& tau) { return (Ball(1.0) - cos(w * tau)) / w; }};
}
Psi exponential(const Ball& w) {
    return {[=](const Ball& tau) { return exp(w * tau); },
            [=](const Ball& tau) { return (exp(w * tau) - Ball(1.0)) / w; }};
}

struct Exact {
    Balls b;
    BallMatrix A;
};

/// The x with m x = right, by elimination.
BallMatrix solved(BallMatrix m, BallMatrix right) {
    const std::size_t s = m.size();
    for (std::size_t k = 0; k < s; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < s; ++i) {
            if (m[i][k].bound() > m[pivot][k].bound()) { pivot = i; }
        }
        std::swap(m[k], m[pivot]);
        std::swap(right[k], right[pivot]);
        for (std::size_t i = 0; i < s; ++i) {
            if (i == k) { continue; }
            const Ball factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < s; ++j) { m[i][j] = m[i][j] - factor * m[k][j]; }
            for (std::size_t j = 0; j < right[i].size(); ++j) {
                right[i][j] = right[i][j] - factor * right[k][j];
            }
        }
    }
    for (std::size_t k = 0; k < s; ++k) {
        for (Ball& entry : right[k]) { entry = entry / m[k][k]; }
    }
    return right;
}

/// Algorithm 4.3: M_ij = psi_i(c_j), b = M^-1 B, A = A_psi M^-T, that is M A^T = A_psi^T.
Exact exact(const std::vector<Psi>& basis, const Balls& c) {
    const std::size_t s = c.size();
    BallMatrix m(s, Balls(s));
    BallMatrix right(s, Balls(s + 1));
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            m[i][j] = basis[i].value(c[j]);
            right[i][j] = basis[i].integral(c[j]);
        }
        right[i][s] = basis[i].integral(Ball(1.0));
    }
    const BallMatrix x = solved(m, right);
    Exact result{Balls(s), BallMatrix(s, Balls(s))};
    for (std::size_t j = 0; j < s; ++j) {
        result.b[j] = x[j][s];
        for (std::size_t i = 0; i < s; ++i) { result.A[i][j] = x[j][i]; }
    }
    return result;
}

template <class T>
struct Oscillator {
    using Vector = std::array<T, 1>;
    void dHdq(const Vector& q, const Vector&, Vector& out) const { out[0] = q[0]; }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out[0] = p[0]; }
    void dHdq(const Vector& q, Vector& out) const { out[0] = q[0]; }
    void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
};

/// The largest error of b and of a_ij = m_ij b_j, in units of the last place of the largest |a_ij|.
template <class T, class Coefficients>
double error_of(const Coefficients& found, const Exact& exact) {
    const std::size_t s = exact.b.size();
    double largest = 0;
    Ball size;
    const auto larger = [&](const Ball& value) {
        if (value.bound() > largest) {
            largest = value.bound();
            size = value;
        }
    };
    for (std::size_t j = 0; j < s; ++j) {
        larger(exact.b[j]);
        for (std::size_t i = 0; i < s; ++i) { larger(exact.A[i][j]); }
    }
    const Ball ulp = size.template ulp<T>();
    double worst = 0;
    for (std::size_t j = 0; j < s; ++j) {
        const Ball b = Ball::of(found.b[j]);
        worst = std::max(worst, ((b - exact.b[j]) / ulp).bound());
        for (std::size_t i = 0; i < s; ++i) {
            const Ball a = Ball::of(found.m[i][j]) * b;
            worst = std::max(worst, ((a - exact.A[i][j]) / ulp).bound());
        }
    }
    return worst;
}

/// From 1e-12 to 1e3, evenly in the logarithm, and random ones, of random signs.
std::vector<double> parameters(unsigned seed) {
    Numbers random(seed);
    std::vector<double> result;
    for (int k = 0; k <= 75; ++k) {
        result.push_back(std::pow(10.0, -12 + k / 5.0));
        result.push_back(std::pow(10.0, random.between(-12, 3)));
        result.push_back(random.between(0, 30));
    }
    for (double& w : result) {
        if (random.between(-1, 1) < 0) { w = -w; }
    }
    return result;
}

using Basis = std::function<std::vector<Psi>(const Ball& w)>;
using Nodes = std::function<Balls(const Ball& w)>;

struct Method {
    Basis basis;
    Nodes nodes;
};

/// The results for one scalar.
struct Seen {
    int methods = 0;
    double worst = 0;
};

template <class T, template <class, class> class Stepper>
void compare(Seen& seen, T w, const Exact& exact) {
    const Stepper<Oscillator<T>, hvi::FixedPoint> stepper(Oscillator<T>{}, w);
    if (!stepper.status().ok()) { return; }
    ++seen.methods;
    const auto& found = stepper.coefficients();
    seen.worst = std::max(seen.worst, error_of<T>(found, exact));
    CHECK(hvi::detail::complementary(found.m, found.mt));
}

template <template <class, class> class Stepper>
void compare_all(const Method& method, const std::vector<double>& at) {
    Seen of_float, of_double, of_long_double, of_quad;
    const auto exact_at = [&](double w) { return exact(method.basis(w), method.nodes(w)); };
    for (const double w : at) {
        CAPTURE(w);
        const auto shorter = static_cast<float>(w);
        compare<float, Stepper>(of_float, shorter, exact_at(static_cast<double>(shorter)));
        const Exact reference = exact_at(w);
        compare<double, Stepper>(of_double, w, reference);
        compare<long double, Stepper>(of_long_double, static_cast<long double>(w), reference);
#ifdef __SIZEOF_FLOAT128__
        compare<scalars::Quad, Stepper>(of_quad, static_cast<scalars::Quad>(w), reference);
#endif
    }
    const auto check = [&](const Seen& seen) {
        CHECK(seen.methods > static_cast<int>(at.size()) * 9 / 10);
        CHECK(seen.worst < 2);
    };
    check(of_float);
    check(of_double);
    check(of_long_double);
#ifdef __SIZEOF_FLOAT128__
    check(of_quad);
#endif
}

Nodes fixed(const Balls& c) {
    return [c](const Ball&) { return c; };
}

const Ball one(1.0);
const Ball third = one / Ball(3.0);
const Balls thirds{Ball(0.0), third, third + third, one};
const Balls halves{Ball(0.0), Ball(0.5), one};

const Basis trigonometric = [](const Ball& w) {
    return std::vector<Psi>{power(0), cosine(w), sine(w)};
};
const Basis with_line = [](const Ball& w) {
    return std::vector<Psi>{power(0), power(1), cosine(w), sine(w)};
};

}  // namespace

using namespace hvi::generated;

TEST_CASE("1, cos, sin") {
    compare_all<Trigonometric>({trigonometric, fixed(halves)}, parameters(1));
}

TEST_CASE("1, tau, cos, sin") { compare_all<WithLine>({with_line, fixed(thirds)}, parameters(2)); }

TEST_CASE("near poles and zeros of weights") {
    std::vector<double> at;
    for (const double place :
         {9.42477796076938, -18.84955592153876, 942.477796076938, 8.986818915818128, 10.435740}) {
        for (const double distance : {-1e-4, -3e-6, 3e-6, 1e-4}) {
            at.push_back(place * (1 + distance));
        }
    }
    compare_all<WithLine>({with_line, fixed(thirds)}, at);
}

TEST_CASE("1, cos, sin at Gauss' nodes, with a square root in the angles") {
    const Ball distance = sqrt(Ball(15.0)) / Ball(10.0);
    const Balls nodes{Ball(0.5) - distance, Ball(0.5), Ball(0.5) + distance};
    compare_all<Gauss>({trigonometric, fixed(nodes)}, parameters(3));
}

TEST_CASE("1, tau, exp(w tau), exp(-w tau)") {
    const Basis basis = [](const Ball& w) {
        return std::vector<Psi>{power(0), power(1), exponential(w), exponential(Ball(0.0) - w)};
    };
    compare_all<Exponential>({basis, fixed(thirds)}, parameters(4));
}

TEST_CASE("angles that are multiples of pi") {
    const Basis basis = [](const Ball& w) { return trigonometric(w * Ball::pi()); };
    compare_all<TimesPi>({basis, fixed(halves)}, parameters(5));
}

TEST_CASE("a node that moves") {
    const Basis basis = [](const Ball&) { return std::vector<Psi>{power(0), power(1), power(2)}; };
    const Nodes nodes = [](const Ball& w) { return Balls{Ball(0.0), w, one}; };
    std::vector<double> at;
    for (const double w : parameters(6)) {
        if (std::abs(w) > 1e-5) { at.push_back(w); }
    }
    compare_all<MovingNode>({basis, nodes}, at);
}

TEST_CASE("two frequencies, six functions") {
    const Basis basis = [](const Ball& w) {
        return std::vector<Psi>{power(0), power(1), cosine(w), sine(w), cosine(w + w), sine(w + w)};
    };
    Balls nodes;
    for (int k = 0; k <= 5; ++k) { nodes.push_back(Ball(k) / Ball(5.0)); }
    compare_all<TwoFrequencies>({basis, fixed(nodes)}, parameters(7));
}
