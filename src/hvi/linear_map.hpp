// The step of a quadratic Hamiltonian of one degree of freedom as one linear map.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_LINEAR_MAP_HPP
#define HVI_LINEAR_MAP_HPP

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/arithmetic.hpp>
#include <hvi/pair.hpp>
#include <hvi/scalar.hpp>
#include <hvi/state.hpp>
#include <hvi/weights.hpp>

namespace hvi::detail {

/// H = qq q^2/2 + qp q p + pp p^2/2 + by_q q + by_p p.
template <class Scalar>
struct Quadratic {
    Scalar qq, qp, pp, by_q, by_p;
};

/// The solution of N linear equations with several right sides, in numbers of twice the digits.
template <class Scalar, std::size_t N, std::size_t columns>
class LinearSystem {
public:
    using Number = Pair<Scalar>;

    std::array<std::array<Number, N + columns>, N> rows{};  ///< the matrix, then the right sides

    /// Replaces the right sides by the solutions (Gauss with row pivots); false where the matrix is
    /// singular, or not finite.
    [[nodiscard]] bool solve() {
        for (std::size_t k = 0; k < N; ++k) {
            std::size_t pivot = k;
            for (std::size_t i = k + 1; i < N; ++i) {
                if (abs(rows[i][k].hi) > abs(rows[pivot][k].hi)) { pivot = i; }
            }
            std::swap(rows[k], rows[pivot]);
            if (rows[k][k].hi == 0 || !is_finite(rows[k][k].hi)) { return false; }
            for (std::size_t i = 0; i < N; ++i) {
                if (i != k) { eliminate(k, i); }
            }
        }
        for (std::size_t k = 0; k < N; ++k) {
            for (std::size_t j = N; j < N + columns; ++j) { rows[k][j] = rows[k][j] / rows[k][k]; }
        }
        return true;
    }

private:
    void eliminate(std::size_t k, std::size_t i) {
        const Number factor = rows[i][k] / rows[k][k];
        for (std::size_t j = k; j < N + columns; ++j) {
            rows[i][j] = rows[i][j] - factor * rows[k][j];
        }
    }
};

/// x' = R x + r for x = (q, p): one step of (4.18) with m_ij = a_ij/b_j and mt_ij = a~_ij/b_j.
///
/// R is a product of shears, p += A q, q += B p, p += C q, each of which is symplectic whatever A,
/// B and C were rounded to: the energy does not drift, as it does with rounded entries of R, whose
/// determinant is not 1. The last shear of a step and the first of the next one are one. Where B is
/// zero, as for H = q p, or R is nearly -1, there are no such shears, and x is multiplied by R.
/// `shifted`: r is not zero.
template <class Scalar, bool shifted>
class LinearMap {
public:
    Status status;  ///< where it is not ok there is no map

    LinearMap() = default;

    /// Where H.qp is not 0 there are as many positions as momenta.
    template <std::size_t r, std::size_t s>
    LinearMap(Scalar h, const Quadratic<Scalar>& H, const Scalar (&m)[r][s],
              const Scalar (&mt)[s][r], const Scalar (&b_q)[s], const Scalar (&b_p)[r]) {
        status = Status(Status::Code::not_finite);
        if (!is_finite(h)) { return; }
        if (!sums_are_exact<Scalar>()) {
            status = Status(Status::Code::unsafe_arithmetic);
            return;
        }
        LinearSystem<Scalar, r + s, 3> system;  // of Lq, Lp for (q, p) = (1, 0), (0, 1), and for r
        const auto hb_q = weights_of_step(h, b_q);
        const auto hb_p = weights_of_step(h, b_p);
        for (std::size_t j = 0; j < s; ++j) {  // Lq_j = h b_j dH/dp(Q_j, P_j)
            auto& row = system.rows[j];
            for (std::size_t k = 0; k < s && H.qp != 0; ++k) {
                row[k] = -(product(hb_q[j], H.qp) * Number{m[j][k]});
            }
            for (std::size_t i = 0; i < r; ++i) {
                row[s + i] = -(product(hb_q[j], H.pp) * Number{mt[j][i]});
            }
            row[j] = row[j] + Number{Scalar(1)};
            row[r + s] = product(hb_q[j], H.qp);
            row[r + s + 1] = product(hb_q[j], H.pp);
            row[r + s + 2] = product(hb_q[j], H.by_p);
        }
        for (std::size_t i = 0; i < r; ++i) {  // Lp_i = -h b_i dH/dq(Q_i, P_i)
            auto& row = system.rows[s + i];
            for (std::size_t k = 0; k < s; ++k) {
                row[k] = product(hb_p[i], H.qq) * Number{m[i][k]};
            }
            for (std::size_t k = 0; k < r && H.qp != 0; ++k) {
                row[s + k] = product(hb_p[i], H.qp) * Number{mt[i][k]};
            }
            row[s + i] = row[s + i] + Number{Scalar(1)};
            row[r + s] = -product(hb_p[i], H.qq);
            row[r + s + 1] = -product(hb_p[i], H.qp);
            row[r + s + 2] = -product(hb_p[i], H.by_q);
        }
        if (system.solve()) {
            set(increments(system, s));
        } else {
            status = Status(Status::Code::singular);
        }
    }

    /// What the last step would have left in `middle`, had it ended at x.
    [[nodiscard]] Scalar middle_before(Scalar q, Scalar p) const {
        if constexpr (shifted) { return p - after_ - C_ * q; }
        return p - C_ * q;
    }

    /// Where a step ends, and the momentum between its shears.
    struct End {
        Scalar q, p, middle;
    };

    /// `middle`: that of the last step.
    [[nodiscard]] End next(Scalar q, Scalar p, Scalar middle) const {
        if (!is_sheared_) {
            return {R_[0][0] * q + (R_[0][1] * p + r_[0]), R_[1][0] * q + (R_[1][1] * p + r_[1]),
                    middle};
        }
        Scalar next_middle = CA_ * q + middle;
        if constexpr (shifted) { next_middle += between_; }
        const Scalar next_q = B_ * next_middle + q;
        Scalar next_p = C_ * next_q + next_middle;
        if constexpr (shifted) { next_p += after_; }
        return {next_q, next_p, next_middle};
    }

private:
    using Number = Pair<Scalar>;
    using Increments = std::array<std::array<Number, 3>, 2>;  // R - 1 and r

    [[nodiscard]] static Number product(Scalar x, Scalar y) { return Number{x} * Number{y}; }

    /// The sums of Lq and of Lp.
    template <std::size_t N>
    [[nodiscard]] static Increments increments(const LinearSystem<Scalar, N, 3>& system,
                                               std::size_t s) {
        Increments sums{};
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t k = 0; k < N; ++k) {
                Number& sum = sums[k < s ? 0 : 1][column];
                sum = sum + system.rows[k][N + column];
            }
        }
        return sums;
    }

    void set(const Increments& D) {
        for (const auto& row : D) {
            for (const Number& entry : row) {
                if (!is_finite(entry.hi)) { return; }
            }
        }
        const Number one{Scalar(1)};
        R_ = {{{(D[0][0] + one).hi, D[0][1].hi}, {D[1][0].hi, (D[1][1] + one).hi}}};
        r_ = {D[0][2].hi, D[1][2].hi};
        is_sheared_ = set_shears(D);
        status = Status();
    }

    /// False where the shears would lose digits: A and C are large against the frequency
    /// sqrt(|c/b|) of R = (a b; c d).
    [[nodiscard]] bool set_shears(const Increments& D) {
        const Number& b = D[0][1];
        if (b.hi == 0) { return false; }
        const Number A = D[0][0] / b;
        const Number C = D[1][1] / b;
        constexpr Scalar most = 1024;
        const Scalar frequency = std::sqrt(abs(D[1][0].hi / b.hi));
        if (!(abs(A.hi) <= most * frequency && abs(C.hi) <= most * frequency)) { return false; }
        B_ = b.hi;
        C_ = C.hi;
        CA_ = (A + C).hi;
        // The offset r as a shift of p before q moves, and one after it.
        const Number before = D[0][2] / b;
        between_ = (D[1][2] - C * D[0][2]).hi;
        after_ = (D[1][2] - before - C * D[0][2]).hi;
        return true;
    }

    std::array<std::array<Scalar, 2>, 2> R_{};
    std::array<Scalar, 2> r_{};
    Scalar B_ = 0, C_ = 0, CA_ = 0, between_ = 0, after_ = 0;
    bool is_sheared_ = false;
};

}  // namespace hvi::detail

#endif  // HVI_LINEAR_MAP_HPP
