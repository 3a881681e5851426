// Steps of any size from any state, and their outcome.
// SPDX-License-Identifier: MIT
//
// `Problem` names its Stepper and has static members. stepper(values) makes one with these values
// of its parameters, or with those of the scene where there are none. initial() is the state of the
// scene.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// The words `H STEPS STATE... VALUES...` that commands on edges have in common. Without STATE it
/// is the state of the scene.
template <class Problem>
struct EdgeWords {
    using Stepper = typename Problem::Stepper;
    using State = typename Stepper::State;

    double h = 0;
    std::int64_t steps = 0;
    State x = Problem::initial();
    std::vector<double> values;

    /// Reads the words. Returns false where they have another form.
    [[nodiscard]] bool read(const std::vector<std::string_view>& words) {
        std::vector<double> state = detail::numbers<Stepper>(x);
        if (words.size() < 2 || !driver::read(words[0], h) || !driver::read(words[1], steps)) {
            return false;
        }
        for (std::size_t i = 2; i < words.size(); ++i) {
            double value = 0;
            if (!driver::read(words[i], value)) { return false; }
            if (i - 2 < state.size()) {
                state[i - 2] = value;
            } else {
                values.push_back(value);
            }
        }
        detail::read_numbers<Stepper>(x, state.data());
        return steps >= 0 && (words.size() == 2 || words.size() >= 2 + state.size());
    }
};

/// Returns whether both hold the same bits, also of zeros and NaN.
[[nodiscard]] inline bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
    return std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

template <class Problem>
class EdgeSteps {
public:
    using Stepper = typename Problem::Stepper;
    using State = typename EdgeWords<Problem>::State;

    explicit EdgeSteps(const EdgeWords<Problem>& words)
        : stepper_(Problem::stepper(words.values)),
          x_(words.x),
          largest_(detail::numbers<Stepper>(x_).size()),
          energy_(stepper_.energy(x_)) {}

    /// Takes steps until one fails.
    void take(double h, std::int64_t steps) {
        for (std::int64_t i = 0; i < steps && status_.ok(); ++i) {
            const std::vector<double> before = detail::numbers<Stepper>(x_);
            status_ = stepper_.step(x_, h);
            const std::vector<double> now = detail::numbers<Stepper>(x_);
            is_untouched_ = same_bits(before, now);
            iterations_ += status_.iterations;
            taken_ += status_.ok() ? 1 : 0;
            energy_error_ = std::fmax(energy_error_, std::abs(stepper_.energy(x_) - energy_));
            for (std::size_t k = 0; k < now.size(); ++k) {
                largest_[k] = std::fmax(largest_[k], std::abs(now[k]));
            }
        }
    }

    void tell() const {
        say("status", status_.ok() ? "ok" : status_.message());
        say("steps", taken_);
        say("iterations", iterations_);
        say("untouched", static_cast<std::int64_t>(is_untouched_));
        say("energy_error", energy_error_);
        tell("largest", largest_);
        tell("end", detail::numbers<Stepper>(x_));
    }

private:
    static void tell(std::string_view key, const std::vector<double>& all) {
        for (const double number : all) { say(key, number); }
    }

    Stepper stepper_;
    State x_;
    std::vector<double> largest_;  ///< largest size of each number of the state
    double energy_;                ///< at the start
    double energy_error_ = 0;      ///< largest error after a step
    Status status_;
    bool is_untouched_ = true;  ///< whether the last step has left the state alone
    std::int64_t taken_ = 0, iterations_ = 0;
};

/// The command `advance H STEPS STATE... VALUES...`: takes the steps and writes their outcome.
template <class Problem>
int advance(const std::vector<std::string_view>& words) {
    EdgeWords<Problem> edge;
    if (!edge.read(words)) { return 2; }
    EdgeSteps<Problem> steps(edge);
    steps.take(edge.h, edge.steps);
    steps.tell();
    return 0;
}

/// The command `return H STEPS STATE... VALUES...`: takes so many steps, and as many of size -H.
template <class Problem>
int there_and_back(const std::vector<std::string_view>& words) {
    EdgeWords<Problem> edge;
    if (!edge.read(words)) { return 2; }
    EdgeSteps<Problem> steps(edge);
    steps.take(edge.h, edge.steps);
    steps.take(-edge.h, edge.steps);
    steps.tell();
    return 0;
}

/// The command `start`: writes the first state of the scene.
template <class Problem>
int start(const std::vector<std::string_view>& words) {
    if (!words.empty()) { return 2; }
    const auto x = Problem::initial();
    for (const double number : detail::numbers<typename Problem::Stepper>(x)) {
        say("start", number);
    }
    return 0;
}

}  // namespace hvi::driver
