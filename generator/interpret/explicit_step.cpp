// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <utility>
#include <variant>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/step_sums.hpp>

#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/interpret/interpreted_step.hpp"
#include "generator/interpret/tables.hpp"

namespace hvi::gen {

namespace {

using Vector = InterpretedSystem::Vector;

/// Common part of both ways to sum: a kick takes dH/dq, a drift dH/dp.
class Moves : public InterpretedStep {
public:
    Moves(const Step& step, InterpretedSystem system)
        : system_(std::move(system)),
          moves_(moves(step)),
          b_p_(weights_of(step.positions)),
          b_q_(weights_of(step.momenta)),
          c_(times_of(step)),
          keeps_force_(step.kept.force),
          keeps_velocity_(step.kept.velocity),
          n_(system_.program().coordinates()),
          slope_(n_),
          force_(n_),
          velocity_(n_) {}

    [[nodiscard]] Status take(InterpretedState& x, double h) override {
        if (h == 0) return {};
        const bool has_time = !c_.empty();
        if (has_time) {
            if (!clock_.begin(x.t, h)) reset();
            if (!clock_.ends()) return Status(Status::Code::not_finite);
        }
        if (!detail::is_finite(h)) return Status(Status::Code::not_finite);
        const Status status = move(x, h);
        return status.ok() && has_time ? clock_.end(x.t, status) : status;
    }

    [[nodiscard]] const InterpretedSystem& system() const override { return system_; }

protected:
    [[nodiscard]] virtual Status move(InterpretedState& x, double h) = 0;

    [[nodiscard]] bool keeps(bool of_kick) const {
        return of_kick ? keeps_force_ : keeps_velocity_;
    }
    [[nodiscard]] const std::vector<Move>& all() const { return moves_; }
    [[nodiscard]] std::size_t dimension() const { return n_; }
    [[nodiscard]] const Vector& weights(bool of_kick) const { return of_kick ? b_p_ : b_q_; }

    /// Returns the slope of a move, evaluated at `at` unless it is known.
    [[nodiscard]] const Vector& slope(const Move& move, const Vector& at, bool is_known = false) {
        Vector& out = !keeps(move.kick) ? slope_ : move.kick ? force_ : velocity_;
        if (is_known) return out;
        if (!move.kick) {
            system_.dHdp(at, out);
        } else {
            system_.dHdq({.q = &at, .t = c_.empty() ? 0 : clock_.at(c_[move.index])}, out);
        }
        return out;
    }

private:
    InterpretedSystem system_;
    std::vector<Move> moves_;
    Vector b_p_, b_q_, c_;
    bool keeps_force_, keeps_velocity_;
    std::size_t n_;
    Vector slope_, force_, velocity_;
    detail::StepClock<double> clock_;
};

/// Sums rounded one by one; see PlainMoves of emit/steps/explicit.cpp.
class PlainSums : public Moves {
public:
    PlainSums(const Step& step, InterpretedSystem system)
        : Moves(step, std::move(system)), q_(dimension()), p_(dimension()), end_(dimension()) {}

    void reset() override { known_ = false; }

private:
    [[nodiscard]] Status move(InterpretedState& x, double h) override {
        bool kicked = false, drifted = false;
        const auto at = [&](bool of_kick) -> const Vector& {
            return of_kick ? (kicked ? p_ : x.p) : (drifted ? q_ : x.q);
        };
        for (const Move& move : all()) {
            const bool is_last = &move == &all().back();
            const Vector& from = at(!move.kick);
            const bool may_be_known = keeps(move.kick) && !(move.kick ? drifted : kicked);
            const bool is_known =
                may_be_known && known_ && detail::same_bits(move.kick ? q_ : p_, from);
            if (may_be_known) known_ = false;
            const Vector& slope = this->slope(move, from, is_known);
            Vector& to = is_last ? end_ : move.kick ? p_ : q_;
            add(at(move.kick), h * weights(move.kick)[move.index], slope, move.kick, to);
            (move.kick ? kicked : drifted) = true;
        }
        return end(x, all().back().kick);
    }

    [[nodiscard]] Status end(InterpretedState& x, bool is_kick) {
        const Vector& other = is_kick ? q_ : p_;
        if (!detail::finite(other, end_)) return Status(Status::Code::not_finite);
        known_ = keeps(true) || keeps(false);
        (is_kick ? x.q : x.p) = other;
        (is_kick ? x.p : x.q) = end_;
        return {};
    }

    static void add(const Vector& from, double weight, const Vector& slope, bool is_kick,
                    Vector& to) {
        for (std::size_t k = 0; k < to.size(); ++k)
            to[k] = is_kick ? from[k] - weight * slope[k] : from[k] + weight * slope[k];
    }

    Vector q_, p_, end_;
    bool known_ = false;  ///< whether the kept slope is that of q_, or of p_
};

/// Increments summed apart; see SummedMoves of emit/steps/explicit_moves.cpp.
class CompensatedSums : public Moves {
public:
    CompensatedSums(const Step& step, InterpretedSystem system)
        : Moves(step, std::move(system)),
          q_(dimension()),
          p_(dimension()),
          dq_(dimension()),
          dp_(dimension()),
          hb_p_(weights(true).size()),
          hb_q_(weights(false).size()) {}

    void reset() override { sums_.forget(); }

private:
    [[nodiscard]] Status move(InterpretedState& x, double h) override {
        if (!sums_.begin(x, dq_, dp_)) return Status(Status::Code::unsafe_arithmetic);
        weigh(h);
        bool kicked = false, drifted = false;
        const auto at = [&](bool of_kick) -> const Vector& {
            return of_kick ? (kicked ? p_ : x.p) : (drifted ? q_ : x.q);
        };
        for (const Move& move : all()) {
            const bool may_be_known = keeps(move.kick) && !(move.kick ? drifted : kicked);
            const bool is_known = may_be_known && known_ && sums_.continues();
            if (may_be_known) known_ = false;
            const Vector& slope = this->slope(move, at(!move.kick), is_known);
            add(at(move.kick), slope, move);
            (move.kick ? kicked : drifted) = true;
        }
        if (!sums_.end(x, dq_, dp_, q_, p_)) return Status(Status::Code::not_finite);
        known_ = keeps(true) || keeps(false);
        return {};
    }

    void weigh(double h) {
        if (h == weighed_) return;
        detail::set_weights_of_step(h, weights(true).data(), hb_p_.size(), hb_p_.data());
        detail::set_weights_of_step(h, weights(false).data(), hb_q_.size(), hb_q_.data());
        weighed_ = h;
    }

    void add(const Vector& from, const Vector& slope, const Move& move) {
        const double weight = (move.kick ? hb_p_ : hb_q_)[move.index];
        Vector& to = move.kick ? p_ : q_;
        Vector& change = move.kick ? dp_ : dq_;
        for (std::size_t k = 0; k < to.size(); ++k) {
            const double by = weight * slope[k];
            to[k] = move.kick ? from[k] - by : from[k] + by;
            change[k] = move.kick ? change[k] - by : change[k] + by;
        }
    }


    Vector q_, p_, dq_, dp_, hb_p_, hb_q_;
    double weighed_ = 0;
    detail::StepSums<Vector> sums_;
    bool known_ = false;  ///< whether a slope is kept
};

}  // namespace

std::unique_ptr<InterpretedStep> explicit_step(const Step& step, InterpretedSystem system) {
    if (std::get<ExplicitStep>(step.form).sums == Sums::compensated)
        return std::make_unique<CompensatedSums>(step, std::move(system));
    return std::make_unique<PlainSums>(step, std::move(system));
}

}  // namespace hvi::gen
