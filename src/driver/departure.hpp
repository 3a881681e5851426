// Invariants of a run, and how far they depart from their start.
// SPDX-License-Identifier: MIT
//
// `Problem` names its Stepper and has static members. stepper() and initial() make a stepper and
// its first state. invariants() is a list of names, and values(stepper, x, out) writes their
// values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/module/departure.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/integrate.hpp>

namespace hvi::driver {

/// Whether a stepper compares the invariants itself, which is quicker.
template <class Stepper, class = void>
struct Follows : std::false_type {};
template <class Stepper>
struct Follows<Stepper, std::void_t<decltype(std::declval<Stepper&>().follow(
                            std::declval<typename Stepper::State&>(), 0.0, std::int64_t(1),
                            std::declval<std::vector<detail::Departure>&>()))>> : std::true_type {};

/// The invariants of `Problem` over a run.
template <class Problem>
class Invariants {
public:
    /// Precondition: `x` is the start of the run.
    template <class Stepper, class State>
    Invariants(const Stepper& stepper, const State& x)
        : values_(Problem::invariants().size()), departures_(values_.size()) {
        compute(stepper, x);
        for (std::size_t i = 0; i < values_.size(); ++i) { departures_[i].start = values_[i]; }
    }

    /// Takes steps until one fails, and looks at the state after each.
    template <class Stepper, class State>
    Run take(Stepper& stepper, State& x, double h, std::int64_t steps) {
        Run run;
        if constexpr (Follows<Stepper>::value) {
            run = stepper.follow(x, h, steps, departures_);
            compute(stepper, x);
        } else {
            while (run.steps < steps && run.ok()) {
                run.status = stepper.step(x, h);
                run.iterations += run.status.iterations;
                if (!run.ok()) { break; }
                ++run.steps;
                see(stepper, x);
            }
        }
        return run;
    }

    template <class Stepper, class State>
    void see(const Stepper& stepper, const State& x) {
        compute(stepper, x);
        for (std::size_t i = 0; i < values_.size(); ++i) { departures_[i].see(values_[i]); }
    }

    /// Goes on from earlier departures; `x` is the state that they were last compared at.
    template <class Stepper, class State>
    void resume(const Stepper& stepper, const State& x,
                const std::vector<detail::Departure>& departures) {
        compute(stepper, x);
        departures_ = departures;
    }

    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    [[nodiscard]] const std::vector<detail::Departure>& departures() const { return departures_; }

private:
    /// Computes the values at x. NOTE: 0 is added, so that none of them is -0.
    template <class Stepper, class State>
    void compute(const Stepper& stepper, const State& x) {
        Problem::values(stepper, x, values_.data());
        for (double& value : values_) { value += 0.0; }
    }

    std::vector<double> values_;
    std::vector<detail::Departure> departures_;
};

/// Size of the energy of motion: the mean of |H(q, p) - H(q, 0)| over places of a run where both
/// are finite. It is 0 without an energy, the first of the invariants.
template <class Problem>
class EnergyOfMotion {
public:
    /// Adds a place. Precondition: the invariants are those at x.
    template <class Stepper>
    void see(const Stepper& stepper, const typename Stepper::State& x,
             const Invariants<Problem>& invariants) {
        if (!is_there_) { return; }
        std::vector<double> at_rest = detail::numbers<Stepper>(x);
        const auto momenta = static_cast<std::ptrdiff_t>(detail::flat<Stepper>(x).q.size());
        std::fill(at_rest.begin() + momenta, at_rest.end(), 0.0);
        auto y = x;
        detail::read_numbers<Stepper>(y, at_rest.data());
        const double energy = invariants.values()[0];
        std::vector<double> values(invariants.values().size());
        Problem::values(stepper, y, values.data());
        const double size = std::abs(energy - values[0]);
        if (!std::isfinite(size)) { return; }
        sum_ += size;
        ++count_;
    }

    [[nodiscard]] double mean() const {
        return count_ == 0 ? 0 : sum_ / static_cast<double>(count_);
    }

    [[nodiscard]] double sum() const { return sum_; }
    [[nodiscard]] std::int64_t count() const { return count_; }
    /// Goes on from an earlier sum.
    void resume(double sum, std::int64_t count) {
        sum_ = sum;
        count_ = count;
    }

private:
    bool is_there_ = !Problem::invariants().empty() &&
                     std::string_view(*Problem::invariants().begin()) == "energy";
    double sum_ = 0;
    std::int64_t count_ = 0;
};

}  // namespace hvi::driver
