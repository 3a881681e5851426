// A module that takes many rows of an ensemble, eight side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <hvi/detail/module/answered.hpp>
#include <hvi/detail/module/row_functions.hpp>
#include <hvi/detail/trajectories/has_time.hpp>
#include <hvi/detail/trajectories/side_by_side.hpp>

namespace hvi::detail {

/// Departures of the energies of eight trajectories; see Departure.
template <class Stepper>
class LaneDepartures {
public:
    using State = typename Stepper::State;
    using Lane = typename State::Lane;

    /// Begins anew in a lane, where the trajectory is now.
    void begin(std::size_t lane, const Stepper& stepper, const State& x) {
        typename Lane::Row now;
        stepper.energy(x).store(now);
        start_.set(lane, now[lane]);
        largest_.set(lane, 0);
    }

    /// Compares the energies with those at the starts. NOTE: a NaN counts as large.
    void see(const Stepper& stepper, const State& x) {
        const Lane size = abs(stepper.energy(x) - Lane(start_)), largest(largest_);
        select(size <= largest, largest, size).store(largest_);
    }

    [[nodiscard]] double largest(std::size_t lane) const {
        return static_cast<double>(largest_[lane]);
    }

private:
    typename Lane::Row start_{}, largest_{};
};

/// No direction.
template <class Stepper>
class NoGrowth {
public:
    static constexpr bool is_there = false;

    template <class State>
    void begin(std::size_t, const double*, const State&) {}
    template <class State>
    void see(const State&) {}
};

/// Functions of a module of rows. `Problem` is as in instance.hpp, and its Stepper advances eight
/// trajectories, of which it has the energy, unless H depends on the time, and the invariants.
/// `Growth` measures a direction that they carry along; see lane_growth.hpp.
template <class Problem, template <class> class Growth = NoGrowth>
class RowsInLanes {
public:
    [[nodiscard]] static constexpr RowFunctions functions() {
        return {rows_version, {coordinates, momenta, has_time, Problem::invariant_count}, take};
    }

private:
    using Stepper = typename Problem::Stepper;
    using State = typename Stepper::State;
    using One = typename Stepper::Trajectory;
    using Parameters = typename Stepper::Parameters;
    using Scalar = typename Stepper::Scalar;

    static constexpr std::size_t coordinates = fixed_size<typename State::Positions>();
    static constexpr std::size_t momenta = fixed_size<typename State::Momenta>();
    static constexpr bool has_time = HasTime<One>::value;
    static constexpr std::size_t numbers = coordinates + momenta + (has_time ? 1 : 0);
    static constexpr std::size_t conserved = Problem::invariant_count + (has_time ? 0 : 1);

    /// The source of lanes; see SideBySide.
    class Going {
    public:
        Going(const Parameters& usual, std::size_t count, const EnsembleRows& rows)
            : usual_(usual), count_(count), rows_(rows) {}

        std::int64_t begin(std::size_t lane, State& x, Stepper& stepper) {
            while (next_ < rows_.count && rows_.steps[next_] <= 0) { stay(next_++); }
            if (next_ == rows_.count) { return 0; }
            const std::size_t row = next_++;
            who_[lane] = row;
            const Parameters parameters = read(row);
            x.set(lane, Stepper::initial(parameters));
            stepper.set_parameters(lane, parameters);
            stepper.set_step(lane, static_cast<Scalar>(rows_.h[row]));
            growth_.begin(lane, rows_.direction, x);
            if constexpr (!has_time) {
                if (rows_.energy_errors != nullptr) { departures_.begin(lane, stepper, x); }
            }
            return rows_.steps[row];
        }

        bool see(const Stepper& stepper, State& x) {
            if constexpr (!has_time) {
                if (rows_.energy_errors != nullptr) { departures_.see(stepper, x); }
            }
            growth_.see(x);
            return true;
        }
        static constexpr bool ends(std::size_t) { return false; }

        void end(std::size_t lane, const State& x, std::int64_t steps) {
            const std::size_t row = who_[lane];
            write(row, x[lane], steps, x.status()[lane], departures_.largest(lane));
            if constexpr (Growth<Stepper>::is_there) {
                rows_.growths[2 * row] = growth_.logarithm(lane);
                rows_.growths[2 * row + 1] = growth_.megno(lane);
            }
        }

        [[nodiscard]] bool goes_on() const { return !rows_.is_stopped(); }

    private:
        [[nodiscard]] Parameters read(std::size_t row) const {
            return with_numbers<Problem>(usual_, rows_.parameters + row * count_, count_);
        }

        /// Ends a row that takes no steps.
        void stay(std::size_t row) { write(row, Stepper::initial(read(row)), 0, Status(), 0); }

        void write(std::size_t row, const One& x, std::int64_t steps, const Status& status,
                   double error) {
            double* out = rows_.states + row * numbers;
            const auto& at = State::Form::flat(x);
            for (const Scalar& value : at.q) { *out++ = static_cast<double>(value); }
            for (const Scalar& value : at.p) { *out++ = static_cast<double>(value); }
            if constexpr (has_time) { *out = static_cast<double>(x.t); }
            rows_.taken[row] = steps;
            rows_.statuses[row] = static_cast<int>(status.code());
            if (rows_.energy_errors != nullptr) { rows_.energy_errors[row] = error; }
            if (rows_.conserved == nullptr) { return; }
            const Stepper stepper(read(row));
            double* values = rows_.conserved + row * conserved;
            if constexpr (!has_time) { *values++ = static_cast<double>(stepper.energy(x)); }
            Problem::values(stepper, x, values);
        }

        const Parameters& usual_;
        std::size_t count_;
        const EnsembleRows& rows_;
        std::array<std::size_t, trajectories_at_once> who_{};
        std::size_t next_ = 0;
        LaneDepartures<Stepper> departures_;
        Growth<Stepper> growth_;
    };

    static DrivenAnswer take(const char* directory, std::size_t count, const EnsembleRows& rows,
                             char* message, std::size_t room) {
        const auto take_all = [&] {
            const Parameters usual = Problem::parameters(directory);
            for (std::size_t row = 0; row < rows.count; ++row) {
                rows.statuses[row] = row_not_finished;
            }
            Stepper stepper(usual);
            Going going(usual, count, rows);
            SideBySide<Stepper, Going>(stepper, going).run();
        };
        return answered(take_all, message, room);
    }
};

}  // namespace hvi::detail
