// The stages of a step of a quadratic Hamiltonian, solved for all states at once.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_LINEAR_STAGES_HPP
#define HVI_LINEAR_STAGES_HPP

#include <array>
#include <cstddef>
#include <optional>

#include <hvi/detail/linear/linear_system.hpp>
#include <hvi/detail/numbers/pair.hpp>

namespace hvi::detail {

/// H = q^T qq q/2 + q^T qp p + p^T pp p/2 + by_q q + by_p p; qq and pp are symmetric.
template <class Scalar, std::size_t n>
struct Quadratic {
    using Vector = std::array<Scalar, n>;
    using Matrix = std::array<Vector, n>;

    Matrix qq{}, qp{}, pp{};
    Vector by_q{}, by_p{};
};

/// R - 1, and r as the last column, of the map x' = R x + r for x = (q, p).
template <class Scalar, std::size_t n>
using Increments = std::array<std::array<Pair<Scalar>, 2 * n + 1>, 2 * n>;

/// Equations (4.18) with m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, linear in Lq = h b dH/dp and in Lp
/// = -h b dH/dq. Each unknown has a column of the system. Its solution has a column for each
/// component of the state and one for r.
template <class Scalar, std::size_t n, std::size_t r, std::size_t s>
class LinearStages {
public:
    using Table = Scalar[r][s];
    using Partner = Scalar[s][r];

    /// Keeps references to the tables. Precondition: H.qp is 0, or there are as many positions as
    /// momenta.
    LinearStages(const Quadratic<Scalar, n>& H, const Table& m, const Partner& mt)
        : H_(H), m_(m), mt_(mt) {}

    /// Returns R - 1 and r, with h b_j of the Lq_j in `hb_q` and h b_i of the Lp_i in `hb_p`; empty
    /// where the equations are singular or not finite.
    [[nodiscard]] std::optional<Increments<Scalar, n>>
    increments(const std::array<Scalar, s>& hb_q, const std::array<Scalar, r>& hb_p) {
        system_ = {};
        for (std::size_t k = 0; k < n; ++k) {
            Slope velocity{{}, H_.pp[k], H_.by_p[k]};
            for (std::size_t l = 0; l < n; ++l) { velocity.by_q[l] = H_.qp[l][k]; }
            const Slope force{H_.qq[k], H_.qp[k], H_.by_q[k]};
            for (std::size_t j = 0; j < s; ++j) { set(j * n + k, hb_q[j], velocity, j); }
            for (std::size_t i = 0; i < r; ++i) { set((s + i) * n + k, -hb_p[i], force, i); }
        }
        if (!system_.solve()) { return std::nullopt; }
        return sums();
    }

private:
    using Number = Pair<Scalar>;
    static constexpr std::size_t N = n * (r + s);

    /// A component of a derivative of H: by_q Q + by_p P + at_origin.
    struct Slope {
        std::array<Scalar, n> by_q, by_p;
        Scalar at_origin;
    };

    [[nodiscard]] static Number product(Scalar x, Scalar y) { return Number{x} * Number{y}; }

    /// Sets the equation of an unknown: it equals `weight` times the slope at Q_i, P_i.
    void set(std::size_t unknown, Scalar weight, const Slope& slope, std::size_t i) {
        auto& row = system_.rows[unknown];
        for (std::size_t l = 0; l < n; ++l) {
            const Number by_q = product(weight, slope.by_q[l]);
            const Number by_p = product(weight, slope.by_p[l]);
            for (std::size_t j = 0; j < s && slope.by_q[l] != 0; ++j) {
                row[j * n + l] = -(by_q * Number{m_[i][j]});
            }
            for (std::size_t j = 0; j < r && slope.by_p[l] != 0; ++j) {
                row[(s + j) * n + l] = -(by_p * Number{mt_[i][j]});
            }
            row[N + l] = by_q;
            row[N + n + l] = by_p;
        }
        row[unknown] = row[unknown] + Number{Scalar(1)};
        row[N + 2 * n] = product(weight, slope.at_origin);
    }

    /// Returns the sums of Lq, and of Lp.
    [[nodiscard]] Increments<Scalar, n> sums() const {
        Increments<Scalar, n> result{};
        for (std::size_t k = 0; k < N; ++k) {
            auto& row = result[k < s * n ? k % n : n + k % n];
            for (std::size_t j = 0; j <= 2 * n; ++j) { row[j] = row[j] + system_.rows[k][N + j]; }
        }
        return result;
    }

    const Quadratic<Scalar, n>& H_;
    const Table& m_;
    const Partner& mt_;
    LinearSystem<Scalar, N, 2 * n + 1> system_;
};

}  // namespace hvi::detail

#endif  // HVI_LINEAR_STAGES_HPP
