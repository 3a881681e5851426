// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <memory>
#include <utility>
#include <variant>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/free_path.hpp>
#include <hvi/detail/stages/moved.hpp>
#include <hvi/detail/stages/step_memory.hpp>

#include "generator/interpret/interpreted_step.hpp"
#include "generator/interpret/stage_solver.hpp"
#include "generator/interpret/starting_slopes.hpp"
#include "generator/interpret/tables.hpp"

namespace hvi::gen {

namespace {

using Vector = InterpretedSystem::Vector;
using Kind = StageNode::Kind;

/// The system in the form that PathFactors takes.
template <bool is_diagonal>
struct WithMass : InterpretedSystem {
    explicit WithMass(InterpretedSystem system) : InterpretedSystem(std::move(system)) {}
    static constexpr bool has_diagonal_mass = is_diagonal;
};

/// Returns hvi::detail::exact_sum for a number of terms that a compiler does not know.
template <class F>
detail::Pair<double> exact_sum(const F& f, std::size_t first, std::size_t count) {
    if (count == 1) return {f(first), 0.0};
    const detail::Pair<double> left = exact_sum(f, first, count / 2);
    const detail::Pair<double> right = exact_sum(f, first + count / 2, count - count / 2);
    const Sum<double> both = two_sum(left.hi, right.hi);
    return {both.value, both.remainder + (left.lo + right.lo)};
}

/// Stages as in hvi::detail::VelocityStages, of any number.
template <bool is_diagonal>
struct VelocityVectors : detail::StepMemory<Vector> {
    using System = WithMass<is_diagonal>;

    VelocityVectors(const System& of, std::size_t stages)
        : system(of), Q(stages), Lp(stages), W(stages), drifted(stages), hb(stages) {
        const std::size_t dimension = of.program().coordinates();
        for (DoubleMatrix* vectors : {&Q, &Lp, &W, &drifted})
            for (Vector& vector : *vectors) vector.resize(dimension);
        free_path.resize(dimension);
        rest_of_path.resize(dimension);
    }

    void weigh(const Doubles& b) {
        if (h == weighed_) return;
        detail::set_weights_of_step(h, b.data(), b.size(), hb.data());
        factors_.set(system, n, h);
        weighed_ = h;
    }

    void drift_freely(const Doubles& c) {
        factors_.scale(system, at.p, remainder.p, free_path, rest_of_path);
        for (std::size_t i = 0; i < c.size(); ++i)
            for (std::size_t k = 0; k < n; ++k)
                drifted[i][k] = (remainder.q[k] + c[i] * rest_of_path[k]) + c[i] * free_path[k];
    }

    /// Sets Lp_j = -h b_j dH/dq, and W_j.
    void kick(std::size_t j, const Vector& gradient) {
        for (std::size_t k = 0; k < n; ++k) Lp[j][k] = -hb[j] * gradient[k];
        Vector& to = is_diagonal ? W[j] : factors_.scratch();
        for (std::size_t k = 0; k < n; ++k) to[k] = factors_[k] * Lp[j][k];
        if (!is_diagonal) system.inverse_mass(to, W[j]);
    }

    void end_q(const WeightedSum& by_forces) {
        for (std::size_t k = 0; k < n; ++k)
            detail::move_far<double>(at.q[k], remainder.q[k], free_path[k],
                                     rest_of_path[k] + by_forces.at(W, k));
    }

    void end_p() {
        const auto kick_of = [&](std::size_t k) {
            return exact_sum(
                [&](std::size_t j) { return is_diagonal ? W[j][k] : factors_[k] * Lp[j][k]; }, 0,
                W.size());
        };
        const auto force_of = [&](std::size_t k) {
            return exact_sum([&](std::size_t j) { return Lp[j][k]; }, 0, Lp.size());
        };
        factors_.kick(at.p, remainder.p, kick_of, force_of);
    }

    const System& system;
    DoubleMatrix Q, Lp, W, drifted;
    Vector free_path, rest_of_path;
    Doubles hb;

private:
    detail::PathFactors<Vector> factors_;
    double weighed_ = 0;
};

/// Tables of the step for the stage equations.
struct VelocityTables {
    explicit VelocityTables(const Step& step)
        : form(std::get<VelocityStep>(step.form)),
          b(weights_of(step.positions)),
          c(as_doubles(form.rounded.c)),
          times(times_of(step)) {
        const DoubleMatrix n = as_doubles(form.rounded.n);
        NumberVector left;
        Doubles left_in_doubles;
        for (std::size_t i = 0; i < n.size(); ++i) {
            by_stages.emplace_back(form.form.n[i], n[i]);
            left.push_back(Number(1) - form.form.c[i]);
            left_in_doubles.push_back(1 - c[i]);
        }
        at_end = std::make_unique<WeightedSum>(left, left_in_doubles);
    }

    const VelocityStep& form;
    Doubles b, c, times;
    std::vector<WeightedSum> by_stages;   ///< sum_j n_ij W_j
    std::unique_ptr<WeightedSum> at_end;  ///< sum_j (1 - c_j) W_j
};

/// Stage equations, as solvers take them; see templates/parts/coupled_positions.hpp.in.
template <bool is_diagonal>
struct CoupledPositions {
    const VelocityTables& tables;
    const std::vector<std::size_t>& Q;
    const std::vector<std::size_t>& Lp;
    const detail::StepClock<double>& clock;
    VelocityVectors<is_diagonal>& s;

    static constexpr bool separable = true;
    static constexpr bool has_q = true;
    static constexpr bool has_p = false;

    void momenta() {}
    void velocities() {}

    [[nodiscard]] double position(std::size_t i, std::size_t k) const {
        return detail::moved(s.at.q[k], tables.by_stages[i].from(s.drifted[i][k], s.W, k));
    }

    void positions() {
        for (std::size_t k = 0; k < s.n; ++k) {
            double change = 0;
            for (const std::size_t i : Q) {
                const double value = position(i, k);
                change += detail::abs(value - s.Q[i][k]);
                s.Q[i][k] = value;
            }
            s.change.q[k] = change;
        }
    }

    void forces() {
        for (const std::size_t i : Lp) {
            s.system.dHdq({.q = &s.Q[i], .t = time(i)}, s.slope);
            s.kick(i, s.slope);
        }
    }

    [[nodiscard]] double time(std::size_t i) const {
        return tables.times.empty() ? 0 : clock.at(tables.times[i]);
    }

    [[nodiscard]] double size_q(std::size_t k) const {
        double size = detail::abs(s.at.q[k]) + detail::abs(s.free_path[k]);
        for (const std::size_t i : Q) size += detail::abs(s.Q[i][k]);
        for (const std::size_t i : Q) size += detail::abs(s.W[i][k]);
        return size;
    }
};

/// Steps with stages of positions; see emit/steps/velocity_form.cpp.
template <bool is_diagonal>
class PositionSteps : public InterpretedStep {
public:
    PositionSteps(const Step& step, InterpretedSystem system)
        : step_(step),
          tables_(step),
          system_(std::move(system)),
          s_(system_, step.positions.size()),
          solver_(tables_.form.iteration),
          starting_(tables_.form.iteration),
          force_(system_.program().coordinates()) {
        for (const Block& block : step.blocks) {
            if (!block.coupled) continue;
            unknown_Q_ = block.of(Kind::Q);
            unknown_Lp_ = block.of(Kind::Lp);
        }
    }

    [[nodiscard]] Status take(InterpretedState& x, double h) override {
        if (h == 0) return {};
        if (has_time()) {
            if (!clock_.begin(x.t, h)) s_.forget();
            if (!clock_.ends()) return Status(Status::Code::not_finite);
        }
        Status status = s_.begin(x, h);
        if (!status.ok()) return status;
        s_.weigh(tables_.b);
        s_.drift_freely(tables_.c);
        if (step_.kept.force && !s_.continues) force_at(s_.at.q, clock_.start, force_);
        predict();
        bool q_is_done = false;
        for (const Block& block : step_.blocks) {
            const StageNode& node = block.nodes.front();
            if (block.coupled) {
                status = solver_.solve(coupled());
                if (!status.ok()) return status;
            } else if (node.kind == Kind::Q) {
                q_is_done = evaluate_position(node.index) || q_is_done;
            } else {
                evaluate_force(node.index);
            }
        }
        if (!q_is_done) s_.end_q(*tables_.at_end);
        s_.end_p();
        status = s_.end(x, status.iterations);
        return has_time() ? clock_.end(x.t, status) : status;
    }

    void reset() override { s_.forget(); }

    [[nodiscard]] const InterpretedSystem& system() const override { return system_; }

private:
    using Place = StageValue::Place;

    [[nodiscard]] bool has_time() const { return !tables_.times.empty(); }
    [[nodiscard]] CoupledPositions<is_diagonal> coupled() {
        return {tables_, unknown_Q_, unknown_Lp_, clock_, s_};
    }
    void force_at(const Vector& q, double t, Vector& out) { system_.dHdq({.q = &q, .t = t}, out); }

    void predict() {
        if (starting_.are_known(s_.goes_on))
            return starting_.extrapolate(s_.W, before_, unknown_Lp_);
        starting_.remember(s_.goes_on);
        starting_.remember(s_.W, before_);
        if (!step_.kept.force) force_at(s_.at.q, clock_.start, s_.slope);
        for (const std::size_t i : unknown_Lp_) s_.kick(i, step_.kept.force ? force_ : s_.slope);
    }

    /// Returns whether it was the position at the end of the step.
    bool evaluate_position(std::size_t i) {
        const Place place = step_.positions[i].place;
        if (place == Place::start) return false;
        if (place == Place::end) {
            s_.end_q(*tables_.at_end);
            return true;
        }
        for (std::size_t k = 0; k < s_.n; ++k) s_.Q[i][k] = coupled().position(i, k);
        return false;
    }

    void evaluate_force(std::size_t i) {
        const Place place = step_.positions[i].place;
        const bool is_kept = step_.kept.force && place != Place::inner;
        Vector& slope = is_kept ? force_ : s_.slope;
        if (!is_kept || place == Place::end)
            force_at(place == Place::inner ? s_.Q[i] : s_.at.q, coupled().time(i), slope);
        s_.kick(i, slope);
    }

    const Step& step_;
    VelocityTables tables_;
    WithMass<is_diagonal> system_;
    VelocityVectors<is_diagonal> s_;
    StageSolver solver_;
    StartingSlopes starting_;
    StartingSlopes::Before before_;
    std::vector<std::size_t> unknown_Q_, unknown_Lp_;
    Vector force_;  ///< dH/dq at the end of the last step
    detail::StepClock<double> clock_;
};

}  // namespace

std::unique_ptr<InterpretedStep> velocity_step(const Step& step, InterpretedSystem system) {
    if (std::get<VelocityStep>(step.form).has_diagonal_mass)
        return std::make_unique<PositionSteps<true>>(step, std::move(system));
    return std::make_unique<PositionSteps<false>>(step, std::move(system));
}

}  // namespace hvi::gen
