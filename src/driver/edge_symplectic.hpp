// How far the derivative of steps is from symplectic, by differences.
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>

#include <driver/answer.hpp>
#include <hvi/arithmetic.hpp>
#include <hvi/math.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// The map of so many steps, and its derivative D. `Stepper` computes in numbers with more digits
/// than double.
template <class Stepper>
class SymplecticDefect {
public:
    using Scalar = typename Stepper::Scalar;
    using State = typename Stepper::State;

    SymplecticDefect(Scalar h, std::int64_t steps) : h_(h), steps_(steps) {}

    /// The largest entry of D^T J D - J, divided by the square of the largest of D where that is
    /// above 1; empty where a step fails.
    [[nodiscard]] std::optional<Scalar> of(const State& x) const {
        std::array<Column, 2 * n> D;
        Scalar largest = 1;
        for (std::size_t j = 0; j < 2 * n; ++j) {
            const std::optional<Column> column = derivative(x, j);
            if (!column) { return {}; }
            D[j] = *column;
            for (const Scalar entry : D[j]) { largest = larger(largest, detail::abs(entry)); }
        }
        Scalar defect = 0;
        for (std::size_t i = 0; i < 2 * n; ++i) {
            for (std::size_t j = 0; j < 2 * n; ++j) {
                const Scalar J = i + n == j ? 1 : j + n == i ? -1 : 0;
                defect = larger(defect, detail::abs(product(D[i], D[j]) - J));
            }
        }
        return defect / (largest * largest);
    }

private:
    static constexpr std::size_t n = std::tuple_size_v<decltype(State::q)>;
    using Column = std::array<Scalar, 2 * n>;

    [[nodiscard]] static Scalar larger(Scalar a, Scalar b) { return a < b ? b : a; }

    /// u^T J v.
    [[nodiscard]] static Scalar product(const Column& u, const Column& v) {
        Scalar sum = 0;
        for (std::size_t k = 0; k < n; ++k) { sum += u[k] * v[k + n] - u[k + n] * v[k]; }
        return sum;
    }

    /// Where the steps lead to from x, moved by `shift` along component j.
    [[nodiscard]] std::optional<Column> end(State x, std::size_t j, Scalar shift) const {
        Stepper stepper{typename Stepper::Parameters{}};
        (j < n ? x.q[j] : x.p[j - n]) += shift;
        for (std::int64_t i = 0; i < steps_; ++i) {
            if (!stepper.step(x, h_).ok()) { return {}; }
        }
        Column column{};
        for (std::size_t k = 0; k < n; ++k) {
            column[k] = x.q[k];
            column[k + n] = x.p[k];
        }
        return column;
    }

    /// Column j of D: (8 (f(d) - f(-d)) - (f(2d) - f(-2d)))/12d, whose error is of order d^4.
    /// With d^4 about the distance of two numbers that is as small as the rounding of f lets be.
    [[nodiscard]] std::optional<Column> derivative(const State& x, std::size_t j) const {
        const Scalar d = math::sqrt(math::sqrt(detail::epsilon<Scalar>));
        const auto a = end(x, j, d), b = end(x, j, -d), c = end(x, j, 2 * d), e = end(x, j, -2 * d);
        if (!a || !b || !c || !e) { return {}; }
        Column column{};
        for (std::size_t k = 0; k < 2 * n; ++k) {
            column[k] = (8 * ((*a)[k] - (*b)[k]) - ((*c)[k] - (*e)[k])) / (12 * d);
        }
        return column;
    }

    Scalar h_;
    std::int64_t steps_;
};

/// The main() of a program that is called as `program H STEPS`, and ended by SIGALRM where it takes
/// longer than its limit.
template <class Stepper>
int edge_symplectic(int argc, char** argv) {
    constexpr unsigned limit = 120;  // seconds
    using Scalar = typename Stepper::Scalar;
    double h = 0;
    std::int64_t steps = 0;
    if (argc != 3 || !read(argv[1], h) || !read(argv[2], steps) || steps < 1) {
        std::fprintf(stderr, "usage: %s H STEPS\n", argv[0]);
        return 2;
    }
    ::alarm(limit);
    say("bits", static_cast<std::int64_t>(detail::bits<Scalar>));
    const auto defect = SymplecticDefect<Stepper>(Scalar(h), steps).of(Stepper::initial());
    if (defect) { say("defect", static_cast<double>(*defect)); }
    return 0;
}

}  // namespace hvi::driver
