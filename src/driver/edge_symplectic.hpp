// Distance of the derivative of steps from symplectic.
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include <driver/answer.hpp>
#include <driver/canonical.hpp>
#include <driver/dual.hpp>
#include <hvi/detail/linear/frozen_matrix.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// The derivative D of the map of several steps, by dual numbers with a part for each canonical
/// coordinate: the q, then the p; see CanonicalParts.
template <class Stepper>
class SymplecticDefect {
public:
    using State = typename Stepper::State;
    static constexpr std::size_t n = std::tuple_size_v<typename Stepper::Vector>;
    static_assert(std::is_same_v<typename Stepper::Scalar, Dual<2 * n>>);

    /// Returns the largest entry of D^T J D - J, relative to the largest value of the entry of
    /// |D|^T |J| |D| along the run. NaN where D is not finite; empty where a step fails.
    ///
    /// NOTE: a step with an error E of D changes D^T J D by E^T J D + D^T J E, whose size is that
    /// of |D|^T |J| |D|. Later steps, being symplectic, keep the change as it is: so an error does
    /// not go away where entries have been large. Entries are compared one by one, since those of D
    /// differ by masses and lengths, and a large entry would hide the error of a small one. But
    /// entries of rotations mix, and the largest of them counts.
    [[nodiscard]] std::optional<double> of(State x, double h, std::int64_t steps) {
        Stepper stepper{typename Stepper::Parameters{}};
        sizes_ = {};
        Canonical::begin(x);
        for (std::int64_t i = 0; i < steps; ++i) {
            look(x);
            if (!stepper.step(x, h).ok()) { return {}; }
        }
        look(x);
        const auto [q, p] = Canonical::of(x);
        double largest = 0;
        for (std::size_t i = 0; i < 2 * n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double defect = std::abs(products(q, p, i, j).sum + (i == j + n ? 1 : 0));
                const double part = defect == 0 ? 0 : defect / size(i, j);
                largest = part > largest || part != part ? part : largest;
            }
        }
        return largest;
    }

private:
    using Canonical = CanonicalParts<Stepper>;
    using Parts = typename Canonical::Parts;

    /// Entries i, j of D^T J D and of |D|^T |J| |D|, where J is (0 1; -1 0).
    struct Products {
        double sum = 0, size = 0;
    };

    [[nodiscard]] static Products products(const Parts& q, const Parts& p, std::size_t i,
                                           std::size_t j) {
        Products all;
        for (std::size_t k = 0; k < n; ++k) {
            const double a = q[k][i] * p[k][j];
            const double b = p[k][i] * q[k][j];
            all.sum += a - b;
            all.size += std::abs(a) + std::abs(b);
        }
        return all;
    }

    [[nodiscard]] double size(std::size_t i, std::size_t j) const {
        const auto [i_begin, i_end] = Canonical::mixed_with(i);
        const auto [j_begin, j_end] = Canonical::mixed_with(j);
        double largest = 0;
        for (std::size_t k = i_begin; k < i_end; ++k) {
            for (std::size_t l = j_begin; l < j_end; ++l) {
                largest = std::fmax(largest, sizes_[std::max(k, l)][std::min(k, l)]);
            }
        }
        return largest;
    }

    /// Records sizes that are larger than ever.
    void look(const State& x) {
        const auto [q, p] = Canonical::of(x);
        for (std::size_t i = 0; i < 2 * n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                sizes_[i][j] = std::fmax(sizes_[i][j], products(q, p, i, j).size);
            }
        }
    }

    std::array<std::array<double, 2 * n>, 2 * n> sizes_{};
};

/// Condition number of d2L/dv2 at the first state of the scene, by the sums of rows; 1 where the
/// scene has a Hamiltonian. (4.14) is solved for velocities whose momenta are right.
template <class Stepper, class = void>
struct Condition {
    static double number() { return 1; }
};
template <class Stepper>
struct Condition<Stepper, std::void_t<decltype(std::declval<const Stepper&>().velocity(
                              std::declval<const typename Stepper::State&>()))>> {
    static double number() {
        const typename Stepper::State x = Stepper::initial();
        const typename Stepper::System system{typename Stepper::Parameters{}};
        detail::FrozenMatrix<typename Stepper::Vector> M;
        const auto fill = [&](auto& out) {
            if constexpr (std::is_same_v<typename Stepper::State,
                                         State<typename Stepper::Vector>>) {
                system.d2Ldv2(x.q, x.p, out);
            } else {
                system.d2Ldv2(x.q, x.p, x.t, out);
            }
        };
        if (!M.compute(fill)) { return 1; }
        double size = 0, size_of_inverse = 0;
        for (std::size_t i = 0; i < x.q.size(); ++i) {
            auto unit = x.q;
            for (std::size_t k = 0; k < unit.size(); ++k) { unit[k] = k == i ? 1 : 0; }
            // NOTE: columns, which are the rows of a symmetric matrix.
            size = std::fmax(size, sum_of(M.times(unit)));
            size_of_inverse = std::fmax(size_of_inverse, sum_of(M.inverse_times(unit)));
        }
        return size * size_of_inverse;
    }

private:
    template <class Vector>
    static double sum_of(const Vector& v) {
        double sum = 0;
        for (const auto& component : v) { sum += std::abs(component.value); }
        return sum;
    }
};

/// The main() of a program that is called as `program H STEPS`, and ended by SIGALRM where it takes
/// longer than its limit.
template <class Stepper>
int edge_symplectic(int argc, char** argv) {
    constexpr unsigned limit = 120;  // seconds
    double h = 0;
    std::int64_t steps = 0;
    if (argc != 3 || !read(argv[1], h) || !read(argv[2], steps) || steps < 1) {
        std::fprintf(stderr, "usage: %s H STEPS\n", argv[0]);
        return 2;
    }
    ::alarm(limit);
    const auto defect = SymplecticDefect<Stepper>().of(Stepper::initial(), h, steps);
    if (defect) { say("defect", *defect); }
    say("condition", Condition<Stepper>::number());
    return 0;
}

}  // namespace hvi::driver
