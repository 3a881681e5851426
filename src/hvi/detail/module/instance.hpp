// A stepper with its parameters, whose states are numbers in a row: q, then p, then the time.
// SPDX-License-Identifier: MIT
//
// `Problem` names its Stepper and has static members: parameters(directory), the defaults, which
// may throw std::runtime_error; set(parameters, reader); stepper(parameters, threads); and
// values(stepper, x, out), which writes as many invariants as invariant_count says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <hvi/detail/module/parameters.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/detail/trajectories/has_time.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/integrate.hpp>

namespace hvi::detail {

/// A stepper with its parameters, and what it keeps from one step to the next.
template <class Problem>
class Instance {
public:
    using Stepper = typename Problem::Stepper;
    using State = typename Stepper::State;
    using Parameters = typename Stepper::Parameters;

    static constexpr bool has_time = HasTime<State>::value;

    Instance(Parameters values, unsigned threads)
        : parameters_(std::move(values)),
          stepper_(Problem::stepper(parameters_, threads)),
          x_(Stepper::initial(parameters_)) {}

    // NOTE: of sizes that lists do not fit there is no coordinate.
    [[nodiscard]] std::size_t coordinates() const { return flat<Stepper>(x_).q.size(); }
    [[nodiscard]] std::size_t momenta() const { return flat<Stepper>(x_).p.size(); }
    [[nodiscard]] std::size_t size() const {
        return coordinates() + momenta() + (has_time ? 1 : 0);
    }

    [[nodiscard]] const Parameters& parameters() const { return parameters_; }
    [[nodiscard]] const Stepper& stepper() const { return stepper_; }
    [[nodiscard]] const State& state() const { return x_; }
    [[nodiscard]] std::int64_t steps() const { return steps_; }
    [[nodiscard]] std::int64_t iterations() const { return iterations_; }

    void begin(double* numbers) const { write(Stepper::initial(parameters_), numbers); }
    void reset() { stepper_.reset(); }

    /// Takes the state that is written next.
    void read(const double* numbers) { read(numbers, x_); }
    void write(double* numbers) const { write(x_, numbers); }

    /// NOTE: not inlined, so that a step is compiled once: another copy of it may contract other
    /// products, and so round otherwise.
    [[gnu::noinline]] Run take(double h, std::int64_t steps) {
        const Run run = taken(static_cast<Scalar>(h), steps);
        steps_ += run.steps;
        iterations_ += run.iterations;
        return run;
    }

    /// NOTE: a compiler that sees the 1 makes a copy of take() for it.
    Run take_one(double h) {
        const volatile std::int64_t one = 1;
        return take(h, one);
    }

    /// Calls f(stepper, x) for a state. NOTE: x is not that of steps, so that several threads may
    /// ask for values at once.
    template <class F>
    auto at(const double* numbers, F&& f) const {
        State x = x_;
        read(numbers, x);
        return f(stepper_, x);
    }

private:
    using Scalar = typename Stepper::Scalar;

    /// NOTE: compilers keep in registers what is in no object that others may see: a small explicit
    /// step takes 9 ns in place of 13.
    Run taken(Scalar h, std::int64_t steps) {
        if constexpr (std::is_trivially_copyable_v<Stepper> &&
                      std::is_trivially_copyable_v<State>) {
            Stepper stepper = stepper_;
            State x = x_;
            const Run run = detail::take(stepper, x, h, steps);
            stepper_ = stepper;
            x_ = x;
            return run;
        } else {
            return detail::take(stepper_, x_, h, steps);
        }
    }

    static void read(const double* numbers, State& x) {
        [[maybe_unused]] const double* const end = read_numbers<Stepper>(x, numbers);
        if constexpr (has_time) { x.t = *end; }
    }

    static void write(const State& x, double* numbers) {
        [[maybe_unused]] double* const end = write_numbers<Stepper>(x, numbers);
        if constexpr (has_time) { *end = static_cast<double>(x.t); }
    }

    Parameters parameters_;
    Stepper stepper_;
    State x_;  ///< of the system's size, for steps
    std::int64_t steps_ = 0, iterations_ = 0;
};

}  // namespace hvi::detail
