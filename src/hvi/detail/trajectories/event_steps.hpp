// Steps with events and states at given times.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/bracket.hpp>
#include <hvi/detail/trajectories/event.hpp>
#include <hvi/detail/trajectories/short_steps.hpp>

namespace hvi::detail {

template <class Scalar>
[[nodiscard]] int sign_of(Scalar value) {
    return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

/// Looks for events and output times within each step. Places within a step are parts of it, from 0
/// to 1.
template <class Stepper>
class EventSteps {
public:
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;
    using Output = std::function<void(const State&, Scalar)>;
    using TimeOf = std::function<Scalar(const State&)>;

    /// `stepper` takes the short steps; it is a copy of the one that takes steps.
    EventSteps(std::vector<Event<Stepper>> events, Stepper stepper)
        : events_(std::move(events)), cursors_(events_.size()), stretch_(std::move(stepper)) {}

    /// Chooses the times at which output(x, t) is called, in the order of the run.
    void output_at(std::vector<Scalar> times, Output output) {
        times_ = std::move(times);
        output_ = std::move(output);
    }

    /// Chooses a function for the time of a state, where it is not a multiple of h. Precondition:
    /// the time grows with the steps.
    void take_time_from(TimeOf time) { time_of_ = std::move(time); }

    [[nodiscard]] bool has_output() const { return next_time_ < times_.size(); }
    [[nodiscard]] Scalar next_output() const { return times_[next_time_]; }

    /// Begins at a state; h is the size of the steps that follow.
    void begin(const State& x, Scalar t, Scalar h) {
        h_ = h;
        while (has_output() && is_before(next_output(), t)) { ++next_time_; }
        while (has_output() && next_output() == t) { give(x); }
        for (std::size_t i = 0; i < events_.size(); ++i) {
            cursors_[i] = {};
            look_from(i, x, t);
            cursors_[i].sign = sign_of(cursors_[i].at_from);
        }
    }

    /// Memory of the search for one event between two steps.
    struct Memory {
        int sign = 0;                 ///< sign of the function behind the last step
        Scalar value = 0, slope = 0;  ///< of the function there
        std::optional<Scalar> last = {}, before_last = {};  ///< times of events that counted
    };

    [[nodiscard]] std::vector<Memory> memory() const {
        std::vector<Memory> all;
        for (const Cursor& each : cursors_) {
            all.push_back({each.sign, each.at_from, each.slope, each.last, each.before_last});
        }
        return all;
    }

    /// Resumes the search between two steps, where output at times up to t has been given.
    void resume(Scalar t, Scalar h, const std::vector<Memory>& memory) {
        h_ = h;
        while (has_output() && !is_before(t, next_output())) { ++next_time_; }
        for (std::size_t i = 0; i < events_.size() && i < memory.size(); ++i) {
            cursors_[i] = {};
            cursors_[i].sign = memory[i].sign;
            cursors_[i].at_from = memory[i].value;
            cursors_[i].slope = memory[i].slope;
            cursors_[i].last = memory[i].last;
            cursors_[i].before_last = memory[i].before_last;
        }
    }

    /// Takes a step to the time `next`, or to the event that ends the run, and adds it to the
    /// result. Where it fails x keeps its bits.
    void take(Stepper& stepper, State& x, Scalar h, Scalar next, EventRun<Scalar>& result) {
        h_ = h;
        stretch_.from = x;
        stretch_.t = result.t;
        stretch_.span = h;
        result.run.status = stepper.step(x, h);
        result.run.iterations += result.run.status.iterations;
        if (result.run.ok()) {
            has_jumped_ = false;
            stretch_.to = x;
            stretch_.t_end = time_of_ ? time_of_(x) : next;
            if (time_of_ && !is_before(stretch_.t, stretch_.t_end)) {
                end(Ending::time_stands, 0, result);
            } else {
                pass(x, result);
            }
            if (!result.ok() && result.ending != Ending::accumulation) {
                x = has_jumped_ ? start_ : stretch_.from;
            }
        } else {
            result.ending = Ending::failed_step;
        }
        if (result.ending == Ending::all_steps) {
            result.t = stretch_.t_end;
            ++result.run.steps;
        }
    }

    /// Counts events that are just at the end of the run.
    void finish(State& x, Scalar h, EventRun<Scalar>& result) {
        h_ = h;
        for (std::size_t i = 0; i < events_.size(); ++i) {
            Cursor& cursor = cursors_[i];
            const bool is_there = sign_of(cursor.at_from) == 0 && cursor.sign != 0;
            if (!is_there || events_[i].is_kink) { continue; }
            const int after = sign_after(i, x, result.t);
            if (after != -cursor.sign || !fits(i, after) || !has_cooled(i, result.t)) { continue; }
            State y = x;
            const After act = acted(i, y, result.t);
            if (act == After::go_on) { continue; }
            x = y;
            if (act == After::stop) { return end(Ending::event, i, result); }
        }
    }

private:
    static constexpr int most_in_step = 1000;

    /// Progress of the search for one event within a stretch.
    struct Cursor {
        Scalar from = 0;  ///< where the search goes on
        int sign = 0;     ///< sign of the function behind that; 0 where it is not known
        Scalar at_from = 0, slope = 0;     ///< value there, and slope where it is given
        Scalar at_end = 0, end_slope = 0;  ///< value and slope at the end of the stretch
        std::optional<Scalar> last = {}, before_last = {};  ///< times of events that counted
    };

    /// The next change of a sign.
    struct Crossing {
        Scalar part;
        int sign;           ///< sign behind it
        bool counts;        ///< whether it counts as an event
        Scalar before = 0;  ///< a part just before a kink
    };

    [[nodiscard]] bool is_before(Scalar left, Scalar right) const {
        return h_ < 0 ? left > right : left < right;
    }

    void end(Ending ending, std::size_t event, EventRun<Scalar>& result) const {
        result.ending = ending;
        result.event = event;
    }

    // ---- functions of events ----

    [[nodiscard]] Scalar value(std::size_t i, const State& x, Scalar t) const {
        const Scalar value = events_[i].zero(x, t), period = events_[i].period;
        return period > 0 ? value - period * std::round(value / period) : value;
    }
    [[nodiscard]] Scalar slope(std::size_t i, const State& x, Scalar t) const {
        return events_[i].slope ? events_[i].slope(x, t) : Scalar(0);
    }

    /// Returns the sign of the function a little behind a state where it may be zero but for
    /// rounding: 1e-8 of a step changes it by more.
    [[nodiscard]] int sign_after(std::size_t i, const State& x, Scalar t) {
        const Scalar h = h_ * Scalar(0x1p-26);
        if (events_[i].slope) {
            const int sign = sign_of(value(i, x, t) + h * slope(i, x, t));
            if (sign != 0) { return sign; }
        }
        State y = x;
        if (!stretch_.short_step(y, h).ok()) { return 0; }
        return sign_of(value(i, y, time_of_ ? time_of_(y) : t + h));
    }

    [[nodiscard]] bool fits(std::size_t i, int sign) const {
        const Direction direction = events_[i].direction;
        return direction == Direction::both || (direction == Direction::up) == (sign > 0);
    }
    [[nodiscard]] bool has_cooled(std::size_t i, Scalar t) const {
        const std::optional<Scalar>& last = cursors_[i].last;
        return !last || std::abs(t - *last) >= events_[i].cooldown;
    }
    After acted(std::size_t i, State& x, Scalar t) {
        cursors_[i].before_last = cursors_[i].last;
        cursors_[i].last = t;
        return events_[i].act ? events_[i].act(x, t) : After::go_on;
    }

    /// Returns the value at an event, with the sign that the function has behind it. NOTE: the
    /// function is zero but for rounding there, and the next change of sign is not there.
    [[nodiscard]] static Scalar behind(int sign, Scalar value) {
        if (sign_of(value) == sign) { return value; }
        return static_cast<Scalar>(sign) * std::numeric_limits<Scalar>::min();
    }

    // ---- places in a stretch ----

    [[nodiscard]] Scalar time_at(Scalar part, const State& x) const {
        return time_of_ ? time_of_(x) : stretch_.time_at(part);
    }

    /// Returns f(x, t) at a part of the stretch; NaN where a short step fails.
    template <class Function>
    [[nodiscard]] Scalar value_at(Scalar part, Function f) {
        const Status status = stretch_.at(part, within_);
        if (!status.ok()) {
            failure_ = status;
            return std::numeric_limits<Scalar>::quiet_NaN();
        }
        return f(within_, time_at(part, within_));
    }

    /// Returns the part of the stretch in which the time changes by some units in its last place.
    [[nodiscard]] Scalar tolerance() const {
        const Scalar t = std::max(std::abs(stretch_.t), std::abs(stretch_.t_end));
        const Scalar length = std::abs(stretch_.t_end - stretch_.t);
        constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
        return length > 0 ? std::max(epsilon * t / length, epsilon) : Scalar(1);
    }

    // ---- the search ----

    void look_from(std::size_t i, const State& x, Scalar t) {
        cursors_[i].from = 0;
        cursors_[i].at_from = value(i, x, t);
        cursors_[i].slope = slope(i, x, t);
    }

    /// Looks at the end of a new stretch.
    void look_at_end() {
        for (std::size_t i = 0; i < events_.size(); ++i) {
            Cursor& cursor = cursors_[i];
            if (cursor.sign == 0) { cursor.sign = sign_after(i, stretch_.from, stretch_.t); }
            const bool is_point = stretch_.span == 0;
            cursor.at_end = is_point ? cursor.at_from : value(i, stretch_.to, stretch_.t_end);
            cursor.end_slope = is_point ? cursor.slope : slope(i, stretch_.to, stretch_.t_end);
        }
    }

    /// Returns the place where a function that turns towards zero and back has passed it; empty
    /// where it has not.
    [[nodiscard]] std::optional<Bracket<Scalar>> beyond(std::size_t i) {
        const Cursor& cursor = cursors_[i];
        const Scalar forward = static_cast<Scalar>(h_ < 0 ? -cursor.sign : cursor.sign);
        const Scalar slope_from = forward * cursor.slope, slope_end = forward * cursor.end_slope;
        if (!(slope_from < 0 && slope_end > 0)) { return {}; }
        Scalar passed = 0;
        const auto slope_or_stop = [&](const State& x, Scalar t) {
            passed = value(i, x, t);
            return sign_of(passed) == -cursor.sign ? Scalar(0) : forward * slope(i, x, t);
        };
        const Scalar enough = Scalar(1) / 1000000;
        const Bracket<Scalar> turn =
            narrowed<Scalar>({cursor.from, 1, slope_from, slope_end}, enough,
                             [&](Scalar part) { return value_at(part, slope_or_stop); });
        if (sign_of(passed) != -cursor.sign) { return {}; }
        return Bracket<Scalar>{cursor.from, turn.a, cursor.at_from, passed};
    }

    /// Returns both ends of a part of the stretch in which the sign changes.
    [[nodiscard]] std::optional<Bracket<Scalar>> bracket(std::size_t i) {
        const Cursor& cursor = cursors_[i];
        if (sign_of(cursor.at_end) == -cursor.sign) {
            return Bracket<Scalar>{cursor.from, 1, cursor.at_from, cursor.at_end};
        }
        return beyond(i);
    }

    /// Returns the next change of sign of a function; empty where there is none.
    [[nodiscard]] std::optional<Crossing> crossing(std::size_t i) {
        const Cursor& cursor = cursors_[i];
        if (cursor.sign == 0) { return {}; }
        if (events_[i].is_kink && is_all_but_zero(cursor.at_end, cursor.at_from)) {
            return kink(i, 1, 1);
        }
        const std::optional<Bracket<Scalar>> both = bracket(i);
        if (!both) { return {}; }
        const int sign = -cursor.sign;
        const Scalar period = events_[i].period;
        const bool is_jump = period > 0 && std::abs(both->at_b - both->at_a) > period / 2;
        if (is_jump || !fits(i, sign)) { return Crossing{both->b, sign, false}; }
        // NOTE: behind an event the function is zero but for rounding.
        if (sign_of(both->at_a) != cursor.sign) { return counted(i, both->a); }
        const Bracket<Scalar> root = narrowed(*both, tolerance(), [&](Scalar part) {
            return value_at(part, [&](const State& x, Scalar t) { return value(i, x, t); });
        });
        const bool a_is_before = sign_of(root.at_a) == cursor.sign;
        if (events_[i].is_kink) {
            // NOTE: where one end is a zero the other one may be far away.
            if (root.at_a == 0) { return kink(i, root.a, root.a); }
            if (root.at_b == 0) { return kink(i, root.b, root.b); }
            return kink(i, a_is_before ? root.a : root.b, a_is_before ? root.b : root.a);
        }
        return counted(i, a_is_before ? root.b : root.a);
    }

    /// Returns whether a step ends at a kink, up to rounding, so that the next one would begin
    /// there.
    [[nodiscard]] static bool is_all_but_zero(Scalar at_end, Scalar at_from) {
        constexpr Scalar little = 256 * std::numeric_limits<Scalar>::epsilon();
        return std::abs(at_end) <= little * std::abs(at_from);
    }

    /// Returns a kink between two parts at which the function has its signs in full.
    [[nodiscard]] Crossing kink(std::size_t i, Scalar before, Scalar behind) {
        const int sign = cursors_[i].sign;
        constexpr Scalar little_more = Scalar(1) / 1'000'000'000;
        before = with_sign(i, sign, before, cursors_[i].from);
        return {with_sign(i, -sign, behind, 1 + little_more), -sign, true, before};
    }

    /// Returns a part near this one, on the way to `end`, at which the function is not zero.
    [[nodiscard]] Scalar with_sign(std::size_t i, int sign, Scalar part, Scalar end) {
        const auto value_here = [&](const State& x, Scalar t) { return value(i, x, t); };
        for (Scalar by = tolerance(); sign_of(value_at(part, value_here)) != sign; by *= 2) {
            if (part == end || !failure_.ok()) { break; }
            part = end < part ? std::max(end, part - by) : std::min(end, part + by);
        }
        return part;
    }

    [[nodiscard]] Crossing counted(std::size_t i, Scalar part) {
        const Scalar t = value_at(part, [](const State&, Scalar time) { return time; });
        return {part, -cursors_[i].sign, has_cooled(i, t)};
    }

    /// Returns the first of all changes of sign, with the number of its event.
    [[nodiscard]] std::optional<std::pair<std::size_t, Crossing>> first() const {
        std::optional<std::pair<std::size_t, Crossing>> result;
        for (std::size_t i = 0; i < events_.size(); ++i) {
            if (found_[i] && (!result || found_[i]->part < result->second.part)) {
                result.emplace(i, *found_[i]);
            }
        }
        return result;
    }

    void find_all() {
        found_.clear();
        for (std::size_t i = 0; i < events_.size(); ++i) { found_.push_back(crossing(i)); }
    }

    /// Goes from event to event until the end of the step.
    void pass(State& x, EventRun<Scalar>& result) {
        failure_ = Status();
        look_at_end();
        find_all();
        for (int count = 0; count < most_in_step; ++count) {
            if (!is_sound(result)) { return; }
            const auto next = first();
            give_until(next ? next->second.part : Scalar(1));
            if (!is_sound(result)) { return; }
            if (!next) { return close(x); }
            meet(next->first, next->second, x, result);
            if (result.ending != Ending::all_steps) { return; }
        }
        end_here(first() ? first()->first : 0, x, result);
    }

    /// Ends a run where the stretch begins, as an event comes again and again.
    void end_here(std::size_t i, State& x, EventRun<Scalar>& result) const {
        x = stretch_.from;
        result.t = stretch_.t;
        end(Ending::accumulation, i, result);
    }

    /// Returns whether an event that jumps comes again so soon that a ball, say, has come to rest.
    [[nodiscard]] bool accumulates(std::size_t i, Scalar t) const {
        const std::optional<Scalar>& before = cursors_[i].before_last;
        return before && std::abs(t - *before) < std::abs(h_) * Scalar(0x1p-20);
    }

    /// Returns whether short steps went well, and functions are numbers.
    [[nodiscard]] bool is_sound(EventRun<Scalar>& result) const {
        if (!failure_.ok()) {
            result.run.status = failure_;
            end(Ending::failed_step, 0, result);
            return false;
        }
        for (std::size_t i = 0; i < events_.size(); ++i) {
            if (!std::isnan(cursors_[i].at_end) && !std::isnan(cursors_[i].at_from)) { continue; }
            end(Ending::undefined, i, result);
            return false;
        }
        return true;
    }

    void close(State& x) {
        if (has_jumped_) { x = stretch_.to; }
        for (std::size_t i = 0; i < events_.size(); ++i) {
            Cursor& cursor = cursors_[i];
            cursor.from = 0;
            cursor.at_from = cursor.at_end;
            cursor.slope = cursor.end_slope;
            if (const int sign = sign_of(cursor.at_end); sign != 0) { cursor.sign = sign; }
        }
    }

    /// Handles a change of sign.
    void meet(std::size_t i, const Crossing& met, State& x, EventRun<Scalar>& result) {
        Cursor& cursor = cursors_[i];
        if (events_[i].is_kink) { return pass_kink(i, met); }
        if (met.counts) {
            failure_ = stretch_.at(met.part, within_);
            if (!failure_.ok()) { return; }
            const Scalar t = time_at(met.part, within_);
            before_ = within_;
            const After act = acted(i, within_, t);
            if (act == After::stop) {
                x = within_;
                result.t = t;
                result.rest = met.part * stretch_.span;
                return end(Ending::event, i, result);
            }
            if (act == After::jump) {
                jump(i, met.part, t);
                return accumulates(i, t) ? end_here(i, x, result) : void();
            }
        }
        cursor.from = met.part;
        cursor.sign = met.sign;
        cursor.at_from = value_at(met.part, [&](const State& y, Scalar t) {
            cursor.slope = slope(i, y, t);
            return behind(met.sign, value(i, y, t));
        });
        found_[i] = crossing(i);
    }

    /// Goes on behind a kink. NOTE: the state is the one just before the kink, except for values
    /// that the kink depends on: a step ends with H before the kink, and the next one begins with H
    /// behind it.
    void pass_kink(std::size_t i, const Crossing& met) {
        State behind{};
        failure_ = stretch_.at(met.part, behind);
        if (failure_.ok()) { failure_ = stretch_.at(met.before, before_); }
        if (!failure_.ok()) { return; }
        const Scalar t = time_at(met.part, behind);
        within_ = before_;
        within_.q = behind.q;
        if (sign_of(value(i, within_, t)) != met.sign) {
            within_.q = before_.q;
            within_.p = behind.p;
        }
        if (sign_of(value(i, within_, t)) != met.sign) { within_ = behind; }
        jump(i, met.part, t);
    }

    /// Goes on from another state, in a stretch from there to the end of the step. NOTE: a function
    /// that the jump does not change keeps its sign, so that a second event of the same time is not
    /// lost.
    void jump(std::size_t jumped, Scalar part, Scalar t) {
        const State& after = within_;
        for (std::size_t i = 0; i < events_.size(); ++i) {
            const Scalar old = value(i, before_, t);
            const std::optional<Crossing>& passed = found_[i];
            if (passed && passed->part < part) { cursors_[i].sign = passed->sign; }
            look_from(i, after, t);
            if (i == jumped) {
                cursors_[i].sign = sign_after(i, after, t);
                cursors_[i].at_from = behind(cursors_[i].sign, cursors_[i].at_from);
            } else if (cursors_[i].at_from != old) {
                cursors_[i].sign = sign_of(cursors_[i].at_from);
            }
        }
        // NOTE: the rest of the step may be no more than rounding.
        stretch_.span *= 1 - part > 4 * tolerance() ? 1 - part : 0;
        if (!has_jumped_) { start_ = stretch_.from; }
        has_jumped_ = true;
        stretch_.from = after;
        stretch_.t = t;
        stretch_.to = after;
        if (stretch_.span != 0) { failure_ = stretch_.short_step(stretch_.to, stretch_.span); }
        if (time_of_) { stretch_.t_end = time_of_(stretch_.to); }
        if (!failure_.ok()) { return; }
        look_at_end();
        find_all();
    }

    // ---- output ----

    void give(const State& x) { output_(x, times_[next_time_++]); }

    /// Gives the states at output times up to a part of the stretch.
    void give_until(Scalar part) {
        if (!has_output()) { return; }
        const Scalar t = value_at(part, [](const State&, Scalar time) { return time; });
        while (has_output() && !is_before(t, next_output()) && failure_.ok()) {
            failure_ = stretch_.at(part_of(next_output()), within_);
            if (failure_.ok()) { give(within_); }
        }
    }

    /// Returns the part of the stretch at a given time.
    [[nodiscard]] Scalar part_of(Scalar time) {
        const Scalar length = stretch_.t_end - stretch_.t;
        if (time == stretch_.t_end) { return 1; }
        if (time == stretch_.t || length == 0) { return 0; }
        if (!time_of_) { return std::clamp((time - stretch_.t) / length, Scalar(0), Scalar(1)); }
        return narrowed<Scalar>({0, 1, stretch_.t - time, stretch_.t_end - time}, tolerance(),
                                [&](Scalar part) {
                                    return value_at(
                                        part, [&](const State&, Scalar t) { return t - time; });
                                })
            .best();
    }

    std::vector<Event<Stepper>> events_;
    std::vector<Cursor> cursors_;
    std::vector<std::optional<Crossing>> found_;  ///< next change of sign of each event
    std::vector<Scalar> times_;
    std::size_t next_time_ = 0;
    Output output_;
    TimeOf time_of_;
    ShortSteps<Stepper> stretch_;
    Scalar h_ = 0;
    State start_{}, within_{}, before_{};
    bool has_jumped_ = false;  ///< within this step; it began at start_
    Status failure_;  ///< of a short step
};

}  // namespace hvi::detail
