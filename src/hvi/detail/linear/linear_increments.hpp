// The step of a quadratic Hamiltonian as a matrix-vector product.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_LINEAR_INCREMENTS_HPP
#define HVI_LINEAR_INCREMENTS_HPP

#include <array>
#include <cstddef>
#include <optional>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/linear/linear_curve.hpp>
#include <hvi/detail/linear/linear_stages.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/step_memory.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// x' = x + (D x + r) for x = (q, p): one step of a quadratic H with n degrees of freedom.
///
/// D = R - 1 has twice the digits, so that R is symplectic to twice the digits. x is summed up with
/// compensation. Rounded entries of R, or of D, would let the energy drift.
template <class Scalar, std::size_t n>
class LinearIncrements {
public:
    Status status;                 ///< not ok: there is no map
    Increments<Scalar, n> rows{};  ///< (D r)

    LinearIncrements() = default;

    /// Computes the step from the coefficients of LinearStages and the weights of Lq and of Lp.
    /// Precondition: H.qp is zero, or r is s.
    template <std::size_t r, std::size_t s>
    LinearIncrements(Scalar h, const Quadratic<Scalar, n>& H, const Scalar (&m)[r][s],
                     const Scalar (&mt)[s][r], const Scalar (&b_q)[s], const Scalar (&b_p)[r])
        : status(Status::Code::not_finite) {
        set(h, [&] {
            LinearStages<Scalar, n, r, s> stages(H, m, mt);
            return stages.increments(weights_of_step(h, b_q), weights_of_step(h, b_p));
        });
    }

    /// Computes the step from the tables of LinearCurve and its weights b.
    template <std::size_t r, std::size_t s>
    LinearIncrements(Scalar h, const Quadratic<Scalar, n>& H, const Scalar (&X)[r][s],
                     const Scalar (&A)[r][s], const Scalar (&D)[r][s], const Scalar (&B)[s],
                     const Scalar (&b)[r])
        : status(Status::Code::not_finite) {
        set(h, [&] {
            LinearCurve<Scalar, n, r, s> curve(H, X, A, D);
            return curve.increments(weights_of_step(h, b), B);
        });
    }

    /// Computes the steps of sizes gamma h in a row. Every second one is a step of the adjoint, in
    /// which A and D change places. Where the method is its own adjoint, both are the same step.
    template <std::size_t r, std::size_t s, std::size_t k>
    LinearIncrements(Scalar h, const Quadratic<Scalar, n>& H, const Scalar (&X)[r][s],
                     const Scalar (&A)[r][s], const Scalar (&D)[r][s], const Scalar (&B)[s],
                     const Scalar (&b)[r], const Scalar (&gamma)[k])
        : status(Status::Code::not_finite) {
        if (!is_finite(h)) { return; }
        const auto parts = weights_of_step(h, gamma);
        for (std::size_t i = 0; i < k; ++i) {
            const bool is_adjoint = i % 2 == 1;
            const LinearIncrements part(parts[i], H, X, is_adjoint ? D : A, is_adjoint ? A : D, B,
                                        b);
            status = part.status;
            if (!status.ok()) { return; }
            append(part.rows);
        }
    }

    /// Takes the step from s.at and its remainder. Preconditions: the status is ok, s has begun.
    ///
    /// NOTE: a long step is a function of its own, so that compilers inline the shears beside it
    /// instead.
    template <class Vector>
    void add_to(StepMemory<Vector>& s) const {
        if constexpr (n == 1) {
            add_rows(s);
        } else {
            add_rows_apart(s);
        }
    }

private:
    using Number = Pair<Scalar>;

    /// Sets the rows; `solve` returns them, or nothing.
    template <class Solve>
    void set(Scalar h, Solve solve) {
        if (!is_finite(h)) { return; }
        if (!sums_are_exact<Scalar>()) {
            status = Status(Status::Code::unsafe_arithmetic);
            return;
        }
        const auto found = solve();
        if (!found) {
            status = Status(Status::Code::singular);
        } else if (are_finite(*found)) {
            rows = *found;
            status = Status();
        }
    }

    /// Sets D to (1 + E) (1 + D) - 1 = D + E + E D, and the offsets accordingly.
    void append(const Increments<Scalar, n>& E) {
        Increments<Scalar, n> both = rows;
        for (std::size_t i = 0; i < 2 * n; ++i) {
            for (std::size_t j = 0; j <= 2 * n; ++j) {
                both[i][j] = both[i][j] + E[i][j];
                for (std::size_t l = 0; l < 2 * n; ++l) {
                    both[i][j] = both[i][j] + E[i][l] * rows[l][j];
                }
            }
        }
        rows = both;
    }

    template <class Vector>
#if defined(__GNUC__)
    [[gnu::noinline]]
#endif
    void
    add_rows_apart(StepMemory<Vector>& s) const {
        add_rows(s);
    }

    template <class Vector>
    void add_rows(StepMemory<Vector>& s) const {
        std::array<Scalar, 2 * n> x, e;
        for (std::size_t j = 0; j < n; ++j) {
            x[j] = at(s.at.q, j);
            x[n + j] = at(s.at.p, j);
            e[j] = at(s.remainder.q, j);
            e[n + j] = at(s.remainder.p, j);
        }
        for (std::size_t i = 0; i < n; ++i) {
            add(rows[i], x, e, at(s.at.q, i), at(s.remainder.q, i));
            add(rows[n + i], x, e, at(s.at.p, i), at(s.remainder.p, i));
        }
    }

    /// Advances one component of x and its remainder: (x, e) += row (x, e, 1).
    ///
    /// NOTE: rounded products do no harm; rounded sums do. Adding the small terms to the increment
    /// first made the energy drift, by 2e-13 in 10^6 steps, and rounded sums by 1e-12.
    static void add(const std::array<Number, 2 * n + 1>& row, const std::array<Scalar, 2 * n>& x,
                    const std::array<Scalar, 2 * n>& e, Scalar& value, Scalar& cut_off) {
        Scalar increment = row[2 * n].hi;
        Scalar small = row[2 * n].lo;
        for (std::size_t j = 0; j < 2 * n; ++j) {
            const Sum<Scalar> sum = two_sum(increment, row[j].hi * x[j]);
            increment = sum.value;
            small += sum.remainder + (row[j].lo * x[j] + row[j].hi * e[j]);
        }
        const Sum<Scalar> sum = two_sum(value, increment);
        const Sum<Scalar> all = two_sum(sum.value, sum.remainder + (cut_off + small));
        value = all.value;
        cut_off = all.remainder;
    }

    [[nodiscard]] static bool are_finite(const Increments<Scalar, n>& D) {
        for (const auto& row : D) {
            for (const Number& entry : row) {
                if (!is_finite(entry.hi)) { return false; }
            }
        }
        return true;
    }
};

}  // namespace hvi::detail

#endif  // HVI_LINEAR_INCREMENTS_HPP
