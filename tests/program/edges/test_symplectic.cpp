// Defects of maps whose derivative is known, as programs of the report measure them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <catch2/catch.hpp>
#include <driver/dual.hpp>
#include <driver/edge_symplectic.hpp>
#include <hvi/state.hpp>

#include "tests/program/edges/epsilon.hpp"

namespace {

using hvi::Status;
using hvi::test::eps;

/// Steps of so many degrees of freedom, that do what `Map` does.
template <std::size_t n, class Map>
struct Stepper {
    using Scalar = hvi::driver::Dual<2 * n>;
    using Vector = std::array<Scalar, n>;
    using State = hvi::State<Vector>;
    struct Parameters {};

    explicit Stepper(const Parameters&) {}
    Status step(State& x, Scalar h) { return map(x.q, x.p, h); }

    Map map;
};

template <std::size_t n, class Map>
double defect(Map, double h, std::int64_t steps) {
    typename Stepper<n, Map>::State x;
    for (std::size_t k = 0; k < n; ++k) {
        x.q[k] = 1;
        x.p[k] = 0.5;
    }
    const auto found = hvi::driver::SymplecticDefect<Stepper<n, Map>>().of(x, h, steps);
    return found ? *found : -1;
}

/// Symplectic Euler for the pendulum, with p multiplied after it by 1 - loss. det D is that power
/// of 1 - loss.
struct Pendulum {
    double loss = 0;
    template <class Vector, class Number>
    Status operator()(Vector& q, Vector& p, Number h) const {
        q[0] += h * p[0];
        p[0] = (p[0] - h * hvi::math::sin(q[0])) * (1 - loss);
        return {};
    }
};
struct LosingPendulum : Pendulum {
    LosingPendulum() : Pendulum{1e-9} {}
};

/// Explicit Euler for the oscillator: D = (1 h; -h 1), and det D is 1 + h^2.
struct ExplicitEuler {
    template <class Vector, class Number>
    Status operator()(Vector& q, Vector& p, Number h) const {
        const Number before = q[0];
        q[0] += h * p[0];
        p[0] -= h * before;
        return {};
    }
};

/// q += h M p with an M that is not symmetric: the entry of D^T J D for the two momenta is
/// h (M_12 - M_21). The first body has a mass of 10^-12.
struct Shears {
    template <class Vector, class Number>
    Status operator()(Vector& q, Vector& p, Number h) const {
        const Number first = 1e12 * p[0] + p[1] + 1e-9 * p[1];
        q[1] += h * (p[0] + p[1]);
        q[0] += h * first;
        return {};
    }
};

struct NotANumber {
    template <class Vector, class Number>
    Status operator()(Vector& q, Vector&, Number) const {
        q[0] = hvi::math::sqrt(q[0] - 1);
        return {};
    }
};

struct Failing {
    template <class Vector, class Number>
    Status operator()(Vector&, Vector&, Number) const {
        return Status(Status::Code::not_converged);
    }
};

}  // namespace

TEST_CASE("symplectic maps have a defect of rounding alone") {
    CHECK(defect<1>(Pendulum{}, 0.1, 1) <= 4 * eps);
    CHECK(defect<1>(Pendulum{}, 0.1, 1000) <= 1000 * 4 * eps);
}

TEST_CASE("the defect of maps that are not symplectic") {
    // 1 + h^2 - 1, beside 1 + h^2.
    CHECK(std::abs(defect<1>(ExplicitEuler{}, 0.5, 1) - 0.2) <= 4 * eps);
    CHECK(std::abs(defect<1>(ExplicitEuler{}, 0.5, 2) - 0.5625 / 1.5625) <= 4 * eps);
}

TEST_CASE("a small defect is not hidden by large entries of D") {
    // For the columns (h 1e12, h, 1, 0) and (h (1 + 1e-9), h, 0, 1): h 1e-9 beside h (2 + 1e-9).
    CHECK(std::abs(defect<2>(Shears{}, 0.5, 1) - 5e-10) <= 1e-15);
}

TEST_CASE("a loss of momentum is seen at once and after many steps") {
    CHECK(defect<1>(LosingPendulum{}, 0.1, 1) > 0.9e-9);
    CHECK(defect<1>(LosingPendulum{}, 0.1, 1) < 1e-9 + 4 * eps);
    CHECK(defect<1>(LosingPendulum{}, 0.1, 1000) > 1e-9);
}

TEST_CASE("a derivative that is no number is no small defect, and a failing step is none") {
    CHECK_FALSE(defect<1>(NotANumber{}, 0.1, 1) < 1);
    CHECK_FALSE(defect<2>(NotANumber{}, 0.1, 1) < 1);
    CHECK(defect<1>(Failing{}, 0.1, 1) == -1);
}
