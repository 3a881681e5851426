// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/stages/clock.hpp>
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
using Indices = std::vector<std::size_t>;

bool are_powers_of_two(const std::vector<StageValue>& values) {
    for (const StageValue& value : values)
        if (!is_power_of_two(value.weight)) return false;
    return true;
}

/// Tables of the step for the stage equations.
struct PairTables {
    explicit PairTables(const Step& step)
        : b_q(weights_of(step.momenta)),
          b_p(weights_of(step.positions)),
          times(times_of(step)),
          rounds_weights(!are_powers_of_two(step.positions) || !are_powers_of_two(step.momenta)) {
        const RoundedCoefficients& rounded = std::get<PairStep>(step.form).coefficients;
        const DoubleMatrix m = as_doubles(rounded.m);
        const DoubleMatrix mt = step.partner == Partner::same ? m : as_doubles(rounded.mt);
        for (std::size_t i = 0; i < m.size(); ++i) of_positions.emplace_back(step.m[i], m[i]);
        for (std::size_t j = 0; j < step.momenta.size(); ++j) {
            NumberVector exact;
            for (std::size_t i = 0; i < step.positions.size(); ++i)
                exact.push_back(Number(1) - step.m[i][j]);
            of_momenta.emplace_back(exact, mt[j]);
        }
    }

    Doubles b_q, b_p, times;
    bool rounds_weights;                                ///< whether h b_j are not exact products
    std::vector<WeightedSum> of_positions, of_momenta;  ///< sum_j m_ij Lq_j, sum_i mt_ji Lp_i
};

/// Stages as in hvi::detail::Stages, of any number.
struct PairVectors : detail::StepMemory<Vector> {
    PairVectors(std::size_t positions, std::size_t momenta, std::size_t dimension)
        : Q(positions), Lp(positions), P(momenta), Lq(momenta), hb_q(momenta), hb_p(positions) {
        for (DoubleMatrix* vectors : {&Q, &Lp, &P, &Lq})
            for (Vector& vector : *vectors) vector.resize(dimension);
    }

    void weigh(const PairTables& tables) {
        if (!tables.rounds_weights) {
            for (std::size_t j = 0; j < hb_q.size(); ++j) hb_q[j] = h * tables.b_q[j];
            for (std::size_t i = 0; i < hb_p.size(); ++i) hb_p[i] = h * tables.b_p[i];
            return;
        }
        if (h == weighed_) return;
        detail::set_weights_of_step(h, tables.b_q.data(), hb_q.size(), hb_q.data());
        detail::set_weights_of_step(h, tables.b_p.data(), hb_p.size(), hb_p.data());
        weighed_ = h;
    }

    void set_Lq(std::size_t j, const Vector& velocity) {
        for (std::size_t k = 0; k < n; ++k) Lq[j][k] = hb_q[j] * velocity[k];
    }
    void set_Lp(std::size_t i, const Vector& gradient) {
        for (std::size_t k = 0; k < n; ++k) Lp[i][k] = -hb_p[i] * gradient[k];
    }

    [[nodiscard]] double moved_q(const WeightedSum& sum, std::size_t k) const {
        return detail::moved(at.q[k], remainder.q[k] + sum.at(Lq, k));
    }
    [[nodiscard]] double moved_p(const WeightedSum& sum, std::size_t k) const {
        return detail::moved(at.p[k], remainder.p[k] + sum.at(Lp, k));
    }

    DoubleMatrix Q, Lp, P, Lq;
    Doubles hb_q, hb_p;

private:
    double weighed_ = 0;
};

/// The present step: places where slopes are evaluated.
struct PairsAtWork {
    const Step& step;
    const PairTables& tables;
    const InterpretedSystem& system;
    const detail::StepClock<double>& clock;
    PairVectors& s;
    Vector& by_q;  ///< where both gradients are evaluated at once
    Vector& by_p;

    [[nodiscard]] double time(std::size_t i) const {
        return tables.times.empty() ? 0 : clock.at(tables.times[i]);
    }

    /// Returns the point at which the force of stage i is evaluated. NOTE: the ends of a separable
    /// step are the state.
    [[nodiscard]] InterpretedSystem::Point point_of_force(std::size_t i) const {
        const bool is_state =
            step.is_separable() && step.positions[i].place != StageValue::Place::inner;
        return {is_state ? &s.at.q : &s.Q[i], step.is_separable() ? nullptr : &s.P[i], time(i)};
    }
    [[nodiscard]] InterpretedSystem::Point point_of_velocity(std::size_t j) const {
        const bool is_state =
            step.is_separable() && step.momenta[j].place != StageValue::Place::inner;
        return {step.is_separable() ? nullptr : &s.Q[j], is_state ? &s.at.p : &s.P[j],
                step.is_separable() ? 0 : time(j)};
    }
    [[nodiscard]] InterpretedSystem::Point start() const { return {&s.at.q, &s.at.p, clock.start}; }
};

/// Stages that a block solves for.
struct BlockIndices {
    explicit BlockIndices(const Block& block)
        : Q(block.of(Kind::Q)),
          P(block.of(Kind::P)),
          Lq(block.of(Kind::Lq)),
          Lp(block.of(Kind::Lp)) {}

    Indices Q, P, Lq, Lp;
};

/// Common part of the stage equations of a block; see templates/parts/coupled.hpp.in.
template <bool is_separable, bool of_q, bool of_p>
struct CoupledBlock {
    const PairsAtWork& work;
    const BlockIndices& unknown;
    PairVectors& s;

    static constexpr bool separable = is_separable;
    static constexpr bool has_q = of_q;
    static constexpr bool has_p = of_p;

    void momenta() {
        const bool is_measured = !separable || unknown.Q.empty();
        for (std::size_t k = 0; k < s.n && has_p; ++k) {
            double change = 0;
            for (const std::size_t j : unknown.P) {
                const double value = s.moved_p(work.tables.of_momenta[j], k);
                change += detail::abs(value - s.P[j][k]);
                s.P[j][k] = value;
            }
            if (is_measured) s.change.p[k] = change;
        }
    }

    void positions() {
        for (std::size_t k = 0; k < s.n && has_q; ++k) {
            double change = 0;
            for (const std::size_t i : unknown.Q) {
                const double value = s.moved_q(work.tables.of_positions[i], k);
                change += detail::abs(value - s.Q[i][k]);
                s.Q[i][k] = value;
            }
            s.change.q[k] = change;
        }
    }

    void nudge(double factor) {
        for (const std::size_t j : unknown.Lq)
            for (double& number : s.Lq[j]) number *= factor;
        for (const std::size_t i : unknown.Lp)
            for (double& number : s.Lp[i]) number *= factor;
    }

    [[nodiscard]] double size_q(std::size_t k) const {
        return size(unknown.Q, s.at.q[k], s.Q, unknown.Lq, s.Lq, k);
    }
    [[nodiscard]] double size_p(std::size_t k) const {
        return size(unknown.P, s.at.p[k], s.P, unknown.Lp, s.Lp, k);
    }

private:
    [[nodiscard]] static double size(const Indices& values, double at, const DoubleMatrix& of,
                                     const Indices& slopes, const DoubleMatrix& of_slopes,
                                     std::size_t k) {
        if (values.empty()) return 0;
        double sum = detail::abs(at);
        for (const std::size_t i : values) sum += detail::abs(of[i][k]);
        for (const std::size_t i : slopes) sum += detail::abs(of_slopes[i][k]);
        return sum;
    }
};

/// Slopes evaluated one by one.
template <bool is_separable, bool of_q, bool of_p>
struct BlockOneByOne : CoupledBlock<is_separable, of_q, of_p> {
    void velocities() {
        for (const std::size_t j : this->unknown.Lq) {
            this->work.system.dHdp(this->work.point_of_velocity(j), this->s.slope);
            this->s.set_Lq(j, this->s.slope);
        }
    }
    void forces() {
        for (const std::size_t i : this->unknown.Lp) {
            this->work.system.dHdq(this->work.point_of_force(i), this->s.slope);
            this->s.set_Lp(i, this->s.slope);
        }
    }
};

/// Both slopes of a stage evaluated at once.
struct BlockJointly : CoupledBlock<false, true, true> {
    void slopes() {
        for (const std::size_t i : unknown.Lq) {
            work.system.gradient({&s.Q[i], &s.P[i], work.time(i)}, work.by_q, work.by_p);
            s.set_Lp(i, work.by_q);
            s.set_Lq(i, work.by_p);
        }
    }
};

/// A block with its solver.
struct SolvedBlock {
    BlockIndices unknown;
    StageSolver solver;
};

Status solve(SolvedBlock& block, const PairsAtWork& work) {
    if (work.step.slopes == Slopes::joint)
        return block.solver.solve(BlockJointly{{work, block.unknown, work.s}});
    const bool has_q = !block.unknown.Q.empty(), has_p = !block.unknown.P.empty();
    const auto with = [&](auto separable, auto of_q, auto of_p) {
        using Coupled = BlockOneByOne<separable.value, of_q.value, of_p.value>;
        return block.solver.solve(Coupled{{work, block.unknown, work.s}});
    };
    const std::true_type yes;
    const std::false_type no;
    if (work.step.is_separable())
        return has_q && has_p ? with(yes, yes, yes)
               : has_q        ? with(yes, yes, no)
                              : with(yes, no, yes);
    return has_q && has_p ? with(no, yes, yes) : has_q ? with(no, yes, no) : with(no, no, yes);
}

/// Steps with stages of positions and momenta; see emit/steps/pair_form.cpp.
class PairSteps : public InterpretedStep {
public:
    PairSteps(const Step& step, InterpretedSystem system)
        : step_(step),
          tables_(step),
          system_(std::move(system)),
          s_(step.positions.size(), step.momenta.size(), dimension()),
          force_(dimension()),
          velocity_(dimension()),
          by_q_(dimension()),
          by_p_(dimension()) {
        const std::optional<Iteration>& iteration = std::get<PairStep>(step.form).iteration;
        if (!iteration) return;
        starting_.emplace(*iteration);
        for (const Block& block : step.blocks)
            if (block.coupled) blocks_.push_back({BlockIndices(block), StageSolver(*iteration)});
    }

    [[nodiscard]] Status take(InterpretedState& x, double h) override {
        if (h == 0) return {};
        const bool has_time = !tables_.times.empty();
        if (has_time) {
            if (!clock_.begin(x.t, h)) s_.forget();
            if (!clock_.ends()) return Status(Status::Code::not_finite);
        }
        Status status = s_.begin(x, h);
        if (!status.ok()) return status;
        s_.weigh(tables_);
        begin_kept();
        if (starting_) predict();
        int iterations = 0;
        status = go_through_blocks(iterations);
        if (!status.ok()) return status;
        if (!q_is_done_) end_q();
        if (!p_is_done_) end_p();
        status = s_.end(x, iterations);
        return has_time ? clock_.end(x.t, status) : status;
    }

    void reset() override { s_.forget(); }

    [[nodiscard]] const InterpretedSystem& system() const override { return system_; }

private:
    using Place = StageValue::Place;

    [[nodiscard]] std::size_t dimension() const { return system_.program().coordinates(); }
    [[nodiscard]] PairsAtWork work() { return {step_, tables_, system_, clock_, s_, by_q_, by_p_}; }

    void begin_kept() {
        if (s_.continues) return;
        if (step_.kept.force) system_.dHdq(work().start(), force_);
        if (step_.kept.velocity) system_.dHdp(work().start(), velocity_);
    }

    Status go_through_blocks(int& iterations) {
        q_is_done_ = p_is_done_ = false;
        auto solved = blocks_.begin();
        for (const Block& block : step_.blocks) {
            const StageNode& node = block.nodes.front();
            if (block.coupled) {
                const Status status = solve(*solved++, work());
                if (!status.ok()) return status;
                iterations += status.iterations;
            } else if (node.kind == Kind::Q || node.kind == Kind::P) {
                evaluate_stage(node);
            } else {
                evaluate_slope(node);
            }
        }
        return {};
    }

    void evaluate_stage(const StageNode& node) {
        const bool is_q = node.kind == Kind::Q;
        const std::size_t i = node.index;
        Vector& to = is_q ? s_.Q[i] : s_.P[i];
        switch ((is_q ? step_.positions : step_.momenta)[i].place) {
        case Place::start:
            if (!step_.is_separable()) to = is_q ? s_.at.q : s_.at.p;
            return;
        case Place::end: return is_q ? end_q() : end_p();
        case Place::inner: break;
        }
        for (std::size_t k = 0; k < s_.n; ++k)
            to[k] = is_q ? s_.moved_q(tables_.of_positions[i], k)
                         : s_.moved_p(tables_.of_momenta[i], k);
    }

    void evaluate_slope(const StageNode& node) {
        const bool is_force = node.kind == Kind::Lp;
        const std::size_t i = node.index;
        const Place place = (is_force ? step_.positions : step_.momenta)[i].place;
        const bool is_kept =
            (is_force ? step_.kept.force : step_.kept.velocity) && place != Place::inner;
        Vector& slope = !is_kept ? s_.slope : is_force ? force_ : velocity_;
        if (!is_kept || place == Place::end) {
            const PairsAtWork at = work();
            InterpretedSystem::Point point =
                is_force ? at.point_of_force(i) : at.point_of_velocity(i);
            if (is_kept) point = {&s_.at.q, &s_.at.p, at.time(i)};
            is_force ? system_.dHdq(point, slope) : system_.dHdp(point, slope);
        }
        is_force ? s_.set_Lp(i, slope) : s_.set_Lq(i, slope);
    }

    void end_q() {
        for (std::size_t k = 0; k < s_.n; ++k)
            s_.add(s_.at.q[k], s_.remainder.q[k], sum_of(s_.Lq, k));
        q_is_done_ = true;
    }
    void end_p() {
        for (std::size_t k = 0; k < s_.n; ++k)
            s_.add(s_.at.p[k], s_.remainder.p[k], sum_of(s_.Lp, k));
        p_is_done_ = true;
    }

    [[nodiscard]] static double sum_of(const DoubleMatrix& slopes, std::size_t k) {
        double sum = slopes.front()[k];
        for (std::size_t i = 1; i < slopes.size(); ++i) sum += slopes[i][k];
        return sum;
    }

    // ---- starting values ----

    /// Returns the stages with starting values. NOTE: for separable H slopes of p are enough.
    [[nodiscard]] Indices predicted(Kind kind) const {
        Indices all;
        if (kind == Kind::Lq && step_.is_separable()) return all;
        for (const SolvedBlock& block : blocks_) {
            const Indices& more = kind == Kind::Lq ? block.unknown.Lq : block.unknown.Lp;
            all.insert(all.end(), more.begin(), more.end());
        }
        return all;
    }

    void predict() {
        const Indices Lq = predicted(Kind::Lq), Lp = predicted(Kind::Lp);
        if (starting_->are_known(s_.goes_on)) {
            if (!Lq.empty()) starting_->extrapolate(s_.Lq, before_q_, Lq);
            if (!Lp.empty()) starting_->extrapolate(s_.Lp, before_p_, Lp);
            return;
        }
        starting_->remember(s_.goes_on);
        starting_->remember(s_.Lq, before_q_);
        starting_->remember(s_.Lp, before_p_);
        begin_at_start(Lq, Lp);
    }

    void begin_at_start(const Indices& Lq, const Indices& Lp) {
        const InterpretedSystem::Point start = work().start();
        if (step_.slopes == Slopes::joint) {
            system_.gradient(start, by_q_, by_p_);
            for (const std::size_t i : Lp) s_.set_Lp(i, by_q_);
            for (const std::size_t j : Lq) s_.set_Lq(j, by_p_);
            return;
        }
        if (!Lq.empty()) system_.dHdp(start, s_.slope);
        for (const std::size_t j : Lq) s_.set_Lq(j, s_.slope);
        if (Lp.empty()) return;
        if (!step_.kept.force) system_.dHdq(start, s_.slope);
        for (const std::size_t i : Lp) s_.set_Lp(i, step_.kept.force ? force_ : s_.slope);
    }

    const Step& step_;
    PairTables tables_;
    InterpretedSystem system_;
    PairVectors s_;
    std::deque<SolvedBlock> blocks_;
    std::optional<StartingSlopes> starting_;
    StartingSlopes::Before before_q_, before_p_;
    Vector force_, velocity_;  ///< slopes at the end of the last step
    Vector by_q_, by_p_;
    bool q_is_done_ = false, p_is_done_ = false;
    detail::StepClock<double> clock_;
};

}  // namespace

std::unique_ptr<InterpretedStep> pair_step(const Step& step, InterpretedSystem system) {
    return std::make_unique<PairSteps>(step, std::move(system));
}

}  // namespace hvi::gen
