// The stage equations of directions where those of the motion are of positions alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/directions/cells.hpp>
#include <hvi/detail/directions/direction_state.hpp>
#include <hvi/detail/lanes/velocity_lanes.hpp>

namespace hvi::detail {

/// The equations of VelocityLanes, differentiated:
///
///     Lp_i = -h b_i d2H/dq2(Q_i) dQ_i,    W_i = h K Lp_i,
///     dQ_i = dq + (e_q + c_i w + sum_j n_ij W_j),    w = h K dp.
template <class Cells, std::size_t dimension>
struct PositionsOfDirections : DirectionState<Cells, dimension> {
    using typename DirectionState<Cells, dimension>::Rows;
    using Lane = typename Cells::Lane;
    using Cell = typename Cells::Cell;
    using Number = typename Cells::Number;
    template <class Scalar, std::size_t stages>
    using Table = VelocityTable<Scalar, stages>;
    static constexpr std::size_t unknown_rows = 1;

    std::array<Rows, unknown_rows> slopes{};  ///< Lp
    Rows Q{}, W{};
    std::array<typename Cells::Kept, dimension> w{};

    /// Sets what sweeps begin with.
    template <class Step>
    void begin(const Step& step) {
        std::array<Number, dimension> scaled, way;
        for (std::size_t k = 0; k < dimension; ++k) {
            scaled[k] = step.h * (Number(this->p[k]) + Number(this->e_p[k]));
        }
        step.system.inverse_mass(scaled, way);
        for (std::size_t k = 0; k < dimension; ++k) { Cells::store(way[k], w[k]); }
    }

    /// Replaces the slopes by those at the stages to which they lead. Returns by how much these
    /// changed, relative to their size.
    template <class Step>
    [[gnu::always_inline]] Number sweep(const Step& step) {
        drift(step);
        Lane change(0), size(0);
        for (std::size_t k = 0; k < dimension; ++k) {
            const Number cut_off(this->e_q[k]), w_k(w[k]), q_k(this->q[k]);
            Cell start;
            for (std::size_t i = 0; i < Cells::parts; ++i) {
                start[i] = Lane(cut_off) + Cells::factor(step.table.c, i) * Lane(w_k);
            }
            const Cell way = Cells::product(step.table.n, W, k, start);
            for (std::size_t i = 0; i < Cells::parts; ++i) {
                const Lane next = Lane(q_k) + way[i];
                change = change + abs(next - Lane(Q[i][k]));
                size = size + abs(next);
                next.store(Q[i][k]);
            }
        }
        for (std::size_t i = 0; i < Cells::parts; ++i) {
            auto out = write<Lane>(slopes[0][i], -Cells::factor(step.hb_p, i));
            step.system.along_q(Cells::kept(step.kept, i), read<Lane>(Q[i]), out);
        }
        return relative<Cells>(change, size);
    }

    /// Moves the directions to the end of the step.
    template <class Step>
    void advance(const Step& step) {
        drift(step);
        for (std::size_t k = 0; k < dimension; ++k) {
            Cell of_q, of_p;
            for (std::size_t i = 0; i < Cells::parts; ++i) {
                of_q[i] = Cells::factor(step.table.left, i) * Lane(W[i][k]);
                of_p[i] = Lane(slopes[0][i][k]);
            }
            this->move(k, Number(w[k]) + Cells::sum(of_q), Cells::sum(of_p));
        }
    }

private:
    template <class Step>
    [[gnu::always_inline]] void drift(const Step& step) {
        for (std::size_t i = 0; i < Cells::parts; ++i) {
            auto out = write<Lane>(W[i], Lane(step.h));
            step.system.inverse_mass(read<Lane>(slopes[0][i]), out);
        }
    }
};

}  // namespace hvi::detail
