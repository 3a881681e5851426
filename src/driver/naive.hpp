// A step as one would write it down at first, for comparison.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp. Its Stepper is one for Equations.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <driver/edge_main.hpp>
#include <driver/equations.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/state.hpp>

namespace hvi::driver::naive {

/// The partitioned Runge-Kutta method of a tableau, with each entry rounded to a double for itself.
/// The stages are iterated to a fixed point, until they change no more, or no less than before.
template <class Problem>
class Stepper {
public:
    using State = typename Problem::Stepper::State;

    /// `words`: the number of stages s, A, A~ and b. Without words there are no stages.
    explicit Stepper(const std::vector<double>& words)
        : s_(words.empty() ? 0 : static_cast<std::size_t>(words.front())) {
        if (words.empty()) { return; }
        auto word = words.begin() + 1;
        for (auto* entries : {&A_, &A_tilde_}) {
            entries->assign(word, word + static_cast<std::ptrdiff_t>(s_ * s_));
            word += static_cast<std::ptrdiff_t>(s_ * s_);
        }
        b_.assign(word, word + static_cast<std::ptrdiff_t>(s_));
        slopes_.resize(s_);
    }

    [[nodiscard]] Status step(State& x, double h) {
        Values y = joined(x);
        const int iterations = solve(y, h);
        if (iterations == most) { return Status(Status::Code::not_converged, iterations); }
        for (std::size_t k = 0; k < 2 * n; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < s_; ++i) { sum += b_[i] * slopes_[i][k]; }
            const auto next = two_sum(y[k], h * sum + remainder_[k]);
            y[k] = next.value;
            remainder_[k] = next.remainder;
        }
        std::copy(y.begin(), y.begin() + n, x.q.begin());
        std::copy(y.begin() + n, y.end(), x.p.begin());
        return Status(Status::Code::ok, iterations);
    }

    /// Forgets what rounding has cut off.
    void reset() { remainder_.fill(0); }

    [[nodiscard]] double energy(const State& x) const { return energies_.energy(x); }

private:
    using Values = typename Equations<Problem>::Values;
    static constexpr std::size_t n = Equations<Problem>::n;
    static constexpr int most = 200;

    static Values joined(const State& x) {
        Values y{};
        std::copy(x.q.begin(), x.q.end(), y.begin());
        std::copy(x.p.begin(), x.p.end(), y.begin() + n);
        return y;
    }

    int solve(const Values& y, double h) {
        Values first{};
        equations_.slope(y.data(), first.data(), 0);
        std::fill(slopes_.begin(), slopes_.end(), first);
        double before = HUGE_VAL;
        for (int iteration = 1; iteration < most; ++iteration) {
            const double change = sweep(y, h);
            if (change == 0 || (change >= before && change < 1e-10)) { return iteration; }
            before = change;
        }
        return most;
    }

    /// Sweeps once over the stages. Returns the largest change of a slope.
    double sweep(const Values& y, double h) {
        std::vector<Values> stages(s_);
        for (std::size_t i = 0; i < s_; ++i) {
            for (std::size_t k = 0; k < 2 * n; ++k) {
                const auto& A = k < n ? A_ : A_tilde_;
                double sum = 0;
                for (std::size_t j = 0; j < s_; ++j) { sum += A[s_ * i + j] * slopes_[j][k]; }
                stages[i][k] = y[k] + (remainder_[k] + h * sum);
            }
        }
        double change = 0;
        for (std::size_t i = 0; i < s_; ++i) {
            Values slope{};
            equations_.slope(stages[i].data(), slope.data(), 0);
            for (std::size_t k = 0; k < 2 * n; ++k) {
                change = std::fmax(change, std::abs(slope[k] - slopes_[i][k]));
            }
            slopes_[i] = slope;
        }
        return change;
    }

    std::size_t s_;
    std::vector<double> A_, A_tilde_, b_;
    std::vector<Values> slopes_;
    Values remainder_{};
    Equations<Problem> equations_;
    typename Problem::Stepper energies_ = Problem::stepper();
};

/// A problem of edge_main(), with the words of the stepper in place of values of parameters.
template <class Problem>
struct Edge {
    using Stepper = naive::Stepper<Problem>;

    static Stepper stepper(const std::vector<double>& words) { return Stepper(words); }
    static typename Stepper::State initial() { return Problem::initial(); }
};

template <class Problem>
int main(int argc, char** argv) {
    return edge_main<Edge<Problem>>(argc, argv);
}

}  // namespace hvi::driver::naive
