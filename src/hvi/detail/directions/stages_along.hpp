// Directions that an implicit step carries along, whose stages are those of the motion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/directions/cells.hpp>
#include <hvi/detail/directions/direct_solution.hpp>
#include <hvi/detail/directions/groups.hpp>
#include <hvi/detail/directions/pairs_of_directions.hpp>
#include <hvi/detail/directions/positions_of_directions.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// How slopes of the last two steps lead to starting values; none where there is no `last`.
template <class Matrix>
struct SlopesBefore {
    const Matrix* last = nullptr;
    const Matrix* before = nullptr;
};

/// The weights of the slopes of positions and of momenta.
template <class Scalar, std::size_t stages>
struct WeightsOfStages {
    const Scalar (&b_q)[stages];
    const Scalar (&b_p)[stages];
};

/// A step whose stages are known.
template <class System, class Table, class Kept, class Scalar, std::size_t stages>
struct KnownStages {
    const System& system;
    const Table& table;
    const Kept& kept;  ///< of each stage for second derivatives along directions
    LaneRow<Scalar, stages> hb_q, hb_p;
    Scalar h;
    bool goes_on;  ///< from the last step, which was as large
    SlopesBefore<LaneMatrix<Scalar, stages>> slopes_before;
};

/// Directions whose stage equations are solved side by side.
template <class Cells, template <class, std::size_t> class EquationsOf, std::size_t dimension,
          std::size_t stages>
class GroupOfDirections {
public:
    using Equations = EquationsOf<Cells, dimension>;
    static constexpr std::size_t width = Cells::directions;

    /// See DirectionState.
    template <class Iterator>
    void take(Iterator directions, std::size_t count) {
        has_slopes_ = equations_.take(directions, count) && has_slopes_;
    }
    template <class Iterator>
    void give(Iterator directions, std::size_t count) {
        equations_.give(directions, count);
    }

    /// Carries the directions along a step.
    template <class Step, class Direct>
    [[nodiscard]] Status carry(const Step& step, Direct& direct) {
        if (!equations_.is_finite()) { return Status(Status::Code::not_finite); }
        const bool goes_on = has_slopes_ && step.goes_on;
        has_slopes_ = false;
        equations_.begin(step);
        if (!direct.allows_sweeps() || !by_sweeps(step, goes_on)) {
            direct.note_failure();
            if (!direct.compute(step)) { return Status(Status::Code::singular); }
            solve_directly(step, direct);
        }
        equations_.advance(step);
        has_slopes_ = equations_.is_finite();
        return has_slopes_ ? Status() : Status(Status::Code::not_finite);
    }

    void forget() { has_slopes_ = has_before_ = false; }

private:
    using Number = typename Cells::Number;
    using Lane = typename Cells::Lane;
    using Scalar = ScalarOf<typename Cells::Row>;
    using Slopes = decltype(Equations::slopes);

    static constexpr int most_sweeps = 30;
    static constexpr Scalar slow = 32;
    static constexpr Scalar rounding = epsilon<Scalar> / 2;
    static constexpr Scalar noise = power_of_two<Scalar>(-(3 * bits<Scalar> + 3) / 4);

    /// Starting values: the polynomial through the slopes of the last two steps, or of one; else
    /// those of the last step, or none.
    template <class Step>
    void predict(const Step& step, bool goes_on) {
        const auto& [last, before] = step.slopes_before;
        const bool is_polynomial = goes_on && last != nullptr && (before == nullptr || has_before_);
        const Slopes slopes = equations_.slopes;
        if (!goes_on) { equations_.slopes = {}; }
        if (is_polynomial) {
            for (std::size_t a = 0; a < slopes.size(); ++a) {
                extrapolate(*last, before, slopes[a], before_[a], equations_.slopes[a]);
            }
        }
        if (goes_on && before != nullptr) { before_ = slopes; }
        has_before_ = goes_on;
    }

    template <class Matrix, class Rows>
    static void extrapolate(const Matrix& last, const Matrix* before, const Rows& slopes,
                            const Rows& slopes_before, Rows& out) {
        for (std::size_t k = 0; k < dimension; ++k) {
            typename Cells::Cell next{};
            for (Lane& part : next) { part = Lane(0); }
            next = Cells::product(last, slopes, k, next);
            if (before != nullptr) { next = Cells::product(*before, slopes_before, k, next); }
            for (std::size_t i = 0; i < Cells::parts; ++i) { next[i].store(out[i][k]); }
        }
    }

    /// Sweeps until the error of the slopes is one of rounding, as the changes so far tell. False
    /// where they do not contract, or slowly.
    template <class Step>
    [[nodiscard]] bool by_sweeps(const Step& step, bool goes_on) {
        predict(step, goes_on);
        equations_.sweep(step);
        Number before = equations_.sweep(step), smallest = before;
        int stalls = 0;
        for (int sweep = 2; sweep < most_sweeps; ++sweep) {
            const Number change = equations_.sweep(step);
            // NOTE: the slopes err by less than the next change of the stages, which is `change`
            // times the rate of the last two; and a rate that is very small need not last.
            if (Cells::all_of((change <= Number(rounding)) |
                              ((change * change <= Number(rounding) * before) &
                               (change <= Number(slow * rounding))))) {
                return true;
            }
            stalls = Cells::any_of(change < smallest) ? 0 : stalls + 1;
            if (stalls == 2) { return Cells::all_of(change <= Number(noise)); }
            smallest = Cells::smaller(change, smallest);
            before = change;
        }
        return false;
    }

    /// NOTE: twice, as one solution is good to the rounding of the first stages alone.
    template <class Step, class Direct>
    void solve_directly(const Step& step, const Direct& direct) {
        equations_.slopes = {};
        for (int times = 0; times < 3; ++times) {
            const Slopes before = equations_.slopes;
            equations_.sweep(step);
            for (std::size_t d = 0; d < width; ++d) { correct(before, direct, d); }
        }
    }

    template <class Direct>
    void correct(const Slopes& before, const Direct& direct, std::size_t d) {
        std::array<Scalar, Direct::unknowns> defect;
        for_unknowns<Equations, stages>([&](std::size_t a, std::size_t i, std::size_t k,
                                            std::size_t u) {
            defect[u] = Cells::get(equations_.slopes[a], i, k, d) - Cells::get(before[a], i, k, d);
        });
        direct.solve(defect.data());
        for_unknowns<Equations, stages>([&](std::size_t a, std::size_t i, std::size_t k,
                                            std::size_t u) {
            Cells::set(equations_.slopes[a], i, k, d, Cells::get(before[a], i, k, d) + defect[u]);
        });
    }

    Equations equations_;
    Slopes before_{};          ///< of the step before the last
    bool has_slopes_ = false;  ///< of a step that went well
    bool has_before_ = false;  ///< the last step went on from it
};

/// start + (cut_off + sum_j m_ij slopes_j), the matrix being columns.
template <class Vector, std::size_t stages>
[[nodiscard]] Vector stage_value(const Vector& start, const LaneMatrix<ScalarOf<Vector>, stages>& m,
                                 std::size_t i, const std::array<Vector, stages>& slopes,
                                 const Vector& cut_off) {
    Vector value = start;
    for (IndexOf<Vector> k = 0; k < start.size(); ++k) {
        ScalarOf<Vector> way = cut_off[k];
        for (std::size_t j = 0; j < stages; ++j) { way += m[j][i] * slopes[j][k]; }
        value[k] += way;
    }
    return value;
}

/// Any number of directions at a state: eight side by side, and a few that are left over one by
/// one. `most`: how many numbers go into a register, of stages in lanes.
template <template <class, std::size_t> class EquationsOf, class Vector, std::size_t stages,
          std::size_t kept_count, std::size_t most = widest>
class StagesAlong {
public:
    using Scalar = ScalarOf<Vector>;

    using Lane = Lanes<Scalar, stages, most>;
    using Table = typename EquationsOf<StagesInLanes<Scalar, stages, most>,
                                       fixed_size<Vector>()>::template Table<Scalar, stages>;

    /// Where the system writes what it keeps of each stage for second derivatives along directions.
    [[nodiscard]] LaneAccess<Lane> kept() { return write<Lane>(kept_, Lane(Scalar(1))); }

    /// Writes it for one stage after the other: keep(i, kept) computes that of stage i.
    template <class Keep>
    void keep(const Keep& keep) {
        for (std::size_t i = 0; i < stages; ++i) {
            std::array<Scalar, kept_count> of_stage;
            keep(i, of_stage);
            for (std::size_t k = 0; k < kept_count; ++k) { kept_[k].set(i, of_stage[k]); }
        }
    }

    /// Stage values as an argument of functions of the system.
    template <class Rows>
    [[nodiscard]] static LaneAccess<Lane> lanes(const Rows& rows) {
        return read<Lane>(rows);
    }

    /// The directions that the next steps carry, and where these are then; see Groups.
    template <class Directions>
    void take(const Directions& directions) {
        groups_.take(directions);
    }
    template <class Directions>
    void give(Directions& directions) {
        groups_.give(directions);
    }

    /// Carries all along a step, unless the status is not ok.
    template <class System, class Stages>
    [[nodiscard]] Status carry(const System& system, const Stages& s, const Table& table,
                               const WeightsOfStages<Scalar, stages>& b,
                               const SlopesBefore<LaneMatrix<Scalar, stages>>& before) {
        if (s.h != weighed_) {
            hb_q_ = lane_row(weights_of_step(s.h, b.b_q));
            hb_p_ = lane_row(weights_of_step(s.h, b.b_p));
            weighed_ = s.h;
        }
        const KnownStages<System, Table, decltype(kept_), Scalar, stages> step{
            system, table, kept_, hb_q_, hb_p_, s.h, s.goes_on, before};
        direct_.begin_step();
        Status status;
        groups_.each([&](auto& group, std::size_t, std::size_t) {
            status = group.carry(step, direct_);
            return status.ok();
        });
        return status;
    }

    void forget() { groups_.forget(); }

private:
    static constexpr std::size_t dimension = fixed_size<Vector>();
    using CellsOfOne = StagesInLanes<Scalar, stages, most>;
    using One = GroupOfDirections<CellsOfOne, EquationsOf, dimension, stages>;
    using Eight =
        GroupOfDirections<DirectionsInLanes<Scalar, stages>, EquationsOf, dimension, stages>;

    LaneRows<Scalar, stages, kept_count> kept_{};
    LaneRow<Scalar, stages> hb_q_{}, hb_p_{};
    Scalar weighed_ = 0;  ///< the step size of these
    /// The number of directions that cost as much one by one as eight side by side. NOTE: where
    /// there is little to compute, one waits for results, and eight wait no longer.
    static constexpr std::size_t few = stages * dimension < 16 ? 2 : 4;

    Groups<One, Eight, few> groups_;
    DirectSolution<typename One::Equations, CellsOfOne, stages> direct_;
};

}  // namespace hvi::detail
