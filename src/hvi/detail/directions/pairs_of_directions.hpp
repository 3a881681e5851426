// The stage equations of directions where those of the motion are of positions and momenta.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/directions/cells.hpp>
#include <hvi/detail/directions/direction_state.hpp>

namespace hvi::detail {

template <class Scalar, std::size_t stages>
struct PairTables {
    const LaneMatrix<Scalar, stages>& m;
    const LaneMatrix<Scalar, stages>& mt;
};

/// The equations of StageLanes, differentiated:
///
///     dQ_i = dq + (e_q + sum_j m_ij Lq_j),    dP_i = dp + (e_p + sum_j mt_ij Lp_j),
///     Lq_j = h b_j (row by p of d2H) (dQ_j, dP_j),    Lp_j = -h b_j (row by q of d2H) (dQ_j,
///     dP_j).
template <class Cells, std::size_t dimension>
struct PairsOfDirections : DirectionState<Cells, dimension> {
    using typename DirectionState<Cells, dimension>::Rows;
    using Lane = typename Cells::Lane;
    using Cell = typename Cells::Cell;
    using Number = typename Cells::Number;
    template <class Scalar, std::size_t stages>
    using Table = PairTables<Scalar, stages>;
    static constexpr std::size_t unknown_rows = 2;

    std::array<Rows, unknown_rows> slopes{};  ///< Lq, Lp
    Rows Q{}, P{};

    template <class Step>
    void begin(const Step&) {}

    /// See PositionsOfDirections.
    template <class Step>
    [[gnu::always_inline]] Number sweep(const Step& step) {
        const Number of_q = stages(step.table.m, slopes[0], this->q, this->e_q, Q);
        const Number of_p = stages(step.table.mt, slopes[1], this->p, this->e_p, P);
        for (std::size_t i = 0; i < Cells::parts; ++i) {
            auto by_q = write<Lane>(slopes[1][i], -Cells::factor(step.hb_p, i));
            auto by_p = write<Lane>(slopes[0][i], Cells::factor(step.hb_q, i));
            step.system.along(Cells::kept(step.kept, i), read<Lane>(Q[i]), read<Lane>(P[i]), by_q,
                              by_p);
        }
        return of_q + of_p;
    }

    template <class Step>
    void advance(const Step&) {
        for (std::size_t k = 0; k < dimension; ++k) {
            Cell of_q, of_p;
            for (std::size_t i = 0; i < Cells::parts; ++i) {
                of_q[i] = Lane(slopes[0][i][k]);
                of_p[i] = Lane(slopes[1][i][k]);
            }
            this->move(k, Cells::sum(of_q), Cells::sum(of_p));
        }
    }

private:
    template <class Matrix, class Vector>
    [[gnu::always_inline]] static Number stages(const Matrix& matrix, const Rows& L,
                                                const Vector& start, const Vector& cut_off,
                                                Rows& values) {
        Lane change(0), size(0);
        for (std::size_t k = 0; k < dimension; ++k) {
            const Number x(start[k]), e(cut_off[k]);
            Cell way;
            for (Lane& part : way) { part = Lane(e); }
            way = Cells::product(matrix, L, k, way);
            for (std::size_t i = 0; i < Cells::parts; ++i) {
                const Lane next = Lane(x) + way[i];
                change = change + abs(next - Lane(values[i][k]));
                size = size + abs(next);
                next.store(values[i][k]);
            }
        }
        return relative<Cells>(change, size);
    }
};

}  // namespace hvi::detail
