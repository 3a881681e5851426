// A module that takes many rows of an ensemble at once, each as a thread of a GPU, or as a turn of
// a loop on the host.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <unordered_map>
#include <utility>
#include <vector>

#include <hvi/detail/device/memory.hpp>
#include <hvi/detail/device/row_steps.hpp>
#include <hvi/detail/module/answered.hpp>
#include <hvi/detail/module/row_functions.hpp>
#include <hvi/detail/trajectories/has_time.hpp>

namespace hvi::device {

/// Functions of such a module. `Problem` is as in <hvi/detail/module/instance.hpp>, and its Stepper
/// is one that `hvi-gen stepper --lanes gpu --energy` writes; `On` is a device as in memory.hpp.
template <class Problem, class On = Device>
class DeviceRows {
public:
    using Stepper = typename Problem::Stepper;
    using Parameters = typename Stepper::Parameters;
    using State = typename Stepper::State;
    using Steps = typename Stepper::Steps;
    using EnsembleRows = detail::EnsembleRows;

    static constexpr bool has_time = detail::HasTime<State>::value;
    static constexpr std::size_t dimension = decltype(State::q)::size();
    static constexpr std::size_t conserved = Problem::invariant_count + (has_time ? 0 : 1);

    [[nodiscard]] static constexpr detail::RowFunctions functions() {
        return {
            detail::rows_version, {dimension, dimension, has_time, Problem::invariant_count}, take};
    }

private:
    /// Bytes of a device that rows take together at most, unless one needs more.
    static constexpr std::size_t most_bytes = std::size_t{1} << 30;
    /// Steps of a row between two looks for the end of the work, and those of all rows together;
    /// but never fewer than pay for the copies around them. NOTE: that a card takes all of these in
    /// some seconds is an estimate.
    static constexpr std::int64_t most_steps = 4096, least_steps = 128;
    static constexpr std::int64_t most_steps_of_all = std::int64_t{1} << 28;

    static detail::DrivenAnswer take(const char* directory, std::size_t parameters,
                                     const EnsembleRows& rows, char* message, std::size_t room) {
        const auto take = [&] {
            On::check();
            take_all(Problem::parameters(directory), parameters, rows);
        };
        return detail::answered(take, message, room);
    }

    /// Takes as many rows at a time as the device has room for.
    static void take_all(const Parameters& defaults, std::size_t parameters,
                         const EnsembleRows& rows) {
        std::size_t at_once = std::max<std::size_t>(most_bytes / bytes_of_row, 1);
        for (std::size_t first = 0; first < rows.count;) {
            const std::size_t count = std::min(at_once, rows.count - first);
            try {
                Part part(starts_of(defaults, parameters, rows, first, count), rows, first);
                part.take();
                part.end();
                first += count;
            } catch (const std::bad_alloc&) {
                if (count == 1) { throw; }
                at_once = (count + 1) / 2;
            }
        }
    }

    // ---- before the first step ----

    static constexpr std::size_t bytes_of_row = sizeof(RowStart<Stepper>) + sizeof(Steps) +
                                                sizeof(State) + sizeof(LargestDeparture) +
                                                sizeof(std::uint32_t);

    /// Rows before they begin, and sizes of steps, each once.
    struct Starts {
        std::vector<RowStart<Stepper>> rows;
        std::vector<Steps> sizes;
    };

    [[nodiscard]] static Starts starts_of(const Parameters& defaults, std::size_t parameters,
                                          const EnsembleRows& rows, std::size_t first,
                                          std::size_t count) {
        Starts starts;
        starts.rows.reserve(count);
        std::unordered_map<double, std::uint32_t> places;
        for (std::size_t i = first; i < first + count; ++i) {
            const auto [found, is_new] =
                places.emplace(rows.h[i], static_cast<std::uint32_t>(starts.sizes.size()));
            if (is_new) {
                starts.sizes.push_back(Steps(static_cast<typename Stepper::Scalar>(rows.h[i])));
            }
            const double* const numbers = rows.parameters + i * parameters;
            starts.rows.push_back({detail::with_numbers<Problem>(defaults, numbers, parameters),
                                   rows.steps[i], found->second});
        }
        return starts;
    }

    // ---- on the device ----

    /// Rows that the device has at a time, from the `first` on.
    class Part {
    public:
        Part(Starts starts, const EnsembleRows& rows, std::size_t first)
            : rows_(rows),
              first_(first),
              starts_(std::move(starts)),
              starts_there_(starts_.rows),
              sizes_there_(starts_.sizes),
              states_there_(count()),
              energies_there_(looks_at_energy() ? count() : 0),
              which_there_(count()),
              found_there_(1) {}

        /// Takes rows to their ends, or until somebody asks for the end. NOTE: rows that have come
        /// to theirs leave the list, so that no thread waits for one that has nothing to do.
        void take() {
            const RowArrays<Stepper> arrays = {
                starts_there_.data(), sizes_there_.data(), states_there_.data(),
                looks_at_energy() ? energies_there_.data() : nullptr};
            On::for_each(count(), BeginRow<Stepper>{arrays});
            for (std::size_t going = list(arrays); going > 0 && !rows_.is_stopped();
                 going = list(arrays)) {
                const std::int64_t share = most_steps_of_all / static_cast<std::int64_t>(going);
                const std::int64_t steps = std::clamp(share, least_steps, most_steps);
                On::for_each(going, AdvanceRow<Stepper>{arrays, which_there_.data(), steps});
            }
        }

        /// Writes the ends of rows.
        void end() const {
            std::vector<State> states(count());
            states_there_.read(states.data(), count());
            std::vector<LargestDeparture> energies(looks_at_energy() ? count() : 0);
            energies_there_.read(energies.data(), energies.size());
            for (std::size_t k = 0; k < count(); ++k) {
                end(first_ + k, starts_.rows[k], states[k]);
                if (rows_.energy_errors == nullptr) { continue; }
                // NOTE: the energy is not conserved where it depends on the time.
                rows_.energy_errors[first_ + k] = looks_at_energy() ? energies[k].largest : 0;
            }
        }

    private:
        template <class T>
        using Array = typename On::template Array<T>;

        [[nodiscard]] std::size_t count() const { return starts_.rows.size(); }
        [[nodiscard]] bool looks_at_energy() const {
            return rows_.energy_errors != nullptr && !has_time;
        }

        /// Lists the rows whose steps go on, and returns how many there are.
        [[nodiscard]] std::size_t list(const RowArrays<Stepper>& arrays) {
            found_there_.set(0, 0);
            On::for_each(count(),
                         ListRow<Stepper>{arrays, which_there_.data(), found_there_.data()});
            std::uint32_t found = 0;
            found_there_.read(&found, 1);
            return found;
        }

        /// Writes the end of row i.
        void end(std::size_t i, const RowStart<Stepper>& start, const State& x) const {
            double* out = rows_.states + i * (2 * dimension + (has_time ? 1 : 0));
            for (std::size_t k = 0; k < dimension; ++k) {
                out[k] = static_cast<double>(x.q[k]);
                out[dimension + k] = static_cast<double>(x.p[k]);
            }
            if constexpr (has_time) { out[2 * dimension] = static_cast<double>(x.t); }
            rows_.taken[i] = x.steps;
            const bool goes_on = x.status == Status::Code::ok && x.steps < start.steps;
            rows_.statuses[i] = goes_on ? detail::row_not_finished : static_cast<int>(x.status);
            if (rows_.conserved == nullptr) { return; }
            const Stepper stepper(start.parameters);
            double* values = rows_.conserved + i * conserved;
            if constexpr (!has_time) { *values++ = static_cast<double>(stepper.energy(x)); }
            Problem::values(stepper, x, values);
        }

        const EnsembleRows& rows_;
        std::size_t first_;
        Starts starts_;
        Array<RowStart<Stepper>> starts_there_;
        Array<Steps> sizes_there_;
        Array<State> states_there_;
        Array<LargestDeparture> energies_there_;
        Array<std::uint32_t> which_there_;  ///< a list of rows
        Array<std::uint32_t> found_there_;  ///< one number: how many it has
    };
};

}  // namespace hvi::device
