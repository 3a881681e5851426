// The curve of a step of a quadratic Hamiltonian, solved for all states at once.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_LINEAR_CURVE_HPP
#define HVI_LINEAR_CURVE_HPP

#include <array>
#include <cstddef>
#include <optional>

#include <hvi/detail/linear/linear_stages.hpp>
#include <hvi/detail/linear/linear_system.hpp>
#include <hvi/detail/numbers/pair.hpp>

namespace hvi::detail {

/// The general Galerkin form (4.6) for W_j = h V_j and Y_i = P_i - p,
///
///     Q_i = q + sum_j A_ij W_j,    sum_j X_ij W_j = h b_i dH/dp(Q_i, P_i),
///     sum_i X_ij Y_i = sum_i D_ij Lp_i,    Lp_i = -h b_i dH/dq(Q_i, P_i),
///
/// The equations are linear in W and Y. Each unknown has a column of the system. Its solution has a
/// column for each component of the state and one for r. The step is symplectic when A_ij + D_ij ==
/// B_j and B_j is the sum of the X_ij over i, however these were rounded; see Curve.
template <class Scalar, std::size_t n, std::size_t nodes, std::size_t functions>
class LinearCurve {
public:
    using Table = Scalar[nodes][functions];

    /// Keeps references to the tables.
    LinearCurve(const Quadratic<Scalar, n>& H, const Table& X, const Table& A, const Table& D)
        : H_(H), X_(X), A_(A), D_(D) {}

    /// Returns R - 1 and r, with hb_i = h b_i; empty where the equations are singular or not
    /// finite.
    [[nodiscard]] std::optional<Increments<Scalar, n>>
    increments(const std::array<Scalar, nodes>& hb, const Scalar (&B)[functions]) {
        system_ = {};
        for (std::size_t i = 0; i < nodes; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                force_[i][k] = slope(-hb[i], H_.qq[k], H_.qp[k], H_.by_q[k], i);
                set_velocity(i, k, hb[i]);
            }
        }
        for (std::size_t j = 0; j < functions; ++j) {
            for (std::size_t k = 0; k < n; ++k) { set_momentum(j, k); }
        }
        if (!system_.solve()) { return std::nullopt; }
        return sums(B);
    }

private:
    using Number = Pair<Scalar>;
    using Vector = std::array<Scalar, n>;
    static constexpr std::size_t N = n * (functions + nodes);
    /// A linear function of W, Y, (q, p) and 1.
    using Row = std::array<Number, N + 2 * n + 1>;

    [[nodiscard]] static std::size_t place_of_W(std::size_t j, std::size_t k) { return j * n + k; }
    [[nodiscard]] static std::size_t place_of_Y(std::size_t i, std::size_t k) {
        return (functions + i) * n + k;
    }

    /// Returns weight times by_q Q_i + by_p P_i + at_origin, a component of a derivative of H.
    [[nodiscard]] Row slope(Scalar weight, const Vector& by_q, const Vector& by_p, Scalar at_origin,
                            std::size_t i) const {
        Row row{};
        for (std::size_t l = 0; l < n; ++l) {
            const Number of_q = Number{weight} * Number{by_q[l]};
            for (std::size_t j = 0; j < functions && by_q[l] != 0; ++j) {
                row[place_of_W(j, l)] = of_q * Number{A_[i][j]};
            }
            row[N + l] = of_q;
            row[N + n + l] = row[place_of_Y(i, l)] = Number{weight} * Number{by_p[l]};
        }
        row[N + 2 * n] = Number{weight} * Number{at_origin};
        return row;
    }

    /// Sets the equation at node i.
    void set_velocity(std::size_t i, std::size_t k, Scalar weight) {
        Vector by_q{};
        for (std::size_t l = 0; l < n; ++l) { by_q[l] = H_.qp[l][k]; }
        Row& row = system_.rows[place_of_Y(i, k)];
        row = moved_left(slope(weight, by_q, H_.pp[k], H_.by_p[k], i));
        for (std::size_t j = 0; j < functions; ++j) {
            Number& entry = row[place_of_W(j, k)];
            entry = entry + Number{X_[i][j]};
        }
    }

    /// Sets the equation of function j.
    void set_momentum(std::size_t j, std::size_t k) {
        Row& row = system_.rows[place_of_W(j, k)];
        for (std::size_t i = 0; i < nodes; ++i) {
            for (std::size_t m = 0; m < row.size(); ++m) {
                row[m] = row[m] + Number{D_[i][j]} * force_[i][k][m];
            }
        }
        row = moved_left(row);
        for (std::size_t i = 0; i < nodes; ++i) {
            Number& entry = row[place_of_Y(i, k)];
            entry = entry + Number{X_[i][j]};
        }
    }

    /// Returns a row of the system: the part of the unknowns is moved to the left side.
    [[nodiscard]] static Row moved_left(Row row) {
        for (std::size_t m = 0; m < N; ++m) { row[m] = -row[m]; }
        return row;
    }

    /// Returns sum_j B_j W_j, and sum_i Lp_i.
    [[nodiscard]] Increments<Scalar, n> sums(const Scalar (&B)[functions]) const {
        Increments<Scalar, n> result{};
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t m = 0; m <= 2 * n; ++m) {
                Number way, kick;
                for (std::size_t j = 0; j < functions; ++j) {
                    way = way + Number{B[j]} * system_.rows[place_of_W(j, k)][N + m];
                }
                for (std::size_t i = 0; i < nodes; ++i) { kick = kick + value(force_[i][k], m); }
                result[k][m] = way;
                result[n + k][m] = kick;
            }
        }
        return result;
    }

    /// Returns the coefficient of component m of (q, p, 1) in the row, with the solution inserted.
    [[nodiscard]] Number value(const Row& row, std::size_t m) const {
        Number sum = row[N + m];
        for (std::size_t u = 0; u < N; ++u) {
            if (row[u].hi != 0) { sum = sum + row[u] * system_.rows[u][N + m]; }
        }
        return sum;
    }

    const Quadratic<Scalar, n>& H_;
    const Table &X_, &A_, &D_;
    std::array<std::array<Row, n>, nodes> force_{};  ///< Lp_i
    LinearSystem<Scalar, N, 2 * n + 1> system_;
};

}  // namespace hvi::detail

#endif  // HVI_LINEAR_CURVE_HPP
