// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/shadow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <driver/answer.hpp>
#include <hvi/detail/module/departure.hpp>

#include "generator/drive/driven_problem.hpp"
#include "generator/drive/progress_of_steps.hpp"

namespace hvi::gen {

namespace {

constexpr int reach = ShadowWishes::reach;

/// Returns the weights of f(j) - f(-j), j = 1 to m, in the derivative at 0 of the polynomial of
/// degree 2m through f(-m) to f(m):
///
///     (-1)^(j+1) m!^2 / (j (m-j)! (m+j)!)
std::array<double, reach> weights_of_differences(int m) {
    std::array<double, reach> result{};
    double product = 1;  // m!^2 / ((m-j)! (m+j)!)
    for (int j = 1; j <= m; ++j) {
        product *= static_cast<double>(m - j + 1) / static_cast<double>(m + j);
        result[static_cast<std::size_t>(j - 1)] = (j % 2 == 1 ? product : -product) / j;
    }
    return result;
}

/// The last 2 reach + 1 states, and the growth of d - b in the step before each.
class Window {
public:
    explicit Window(const ShadowWishes& wishes) : n_(wishes.degrees), h_(wishes.h) {}

    void add(const DrivenStepper::State& x) {
        Place& place = places_[next_];
        next_ = (next_ + 1) % places_.size();
        place.q.assign(x.q.begin(), x.q.begin() + static_cast<std::ptrdiff_t>(n_));
        place.p.assign(x.p.begin(), x.p.begin() + static_cast<std::ptrdiff_t>(n_));
        place.growth = (x.q.size() > n_ + 1 ? x.q[n_ + 1] : 0) - x.p[n_];
    }

    /// Returns H~ in the middle. Precondition: there are 2 reach + 1 states.
    [[nodiscard]] double value(const std::array<double, reach>& weights) const {
        const Place& middle = at(0);
        double sum = 0, growth = 0;
        for (int j = 1; j <= reach; ++j) {
            const Place &ahead = at(j), &behind = at(-j);
            growth += ahead.growth + at(1 - j).growth;
            double twice = growth;
            for (std::size_t k = 0; k < n_; ++k)
                twice += middle.p[k] * (ahead.q[k] - behind.q[k]) -
                         middle.q[k] * (ahead.p[k] - behind.p[k]);
            sum += weights[static_cast<std::size_t>(j - 1)] * twice;
        }
        return sum / (2 * h_);
    }

private:
    struct Place {
        std::vector<double> q, p;
        double growth = 0;
    };

    /// Returns the place `j` steps after the middle.
    [[nodiscard]] const Place& at(int j) const {
        const auto after = static_cast<std::size_t>(reach + j);
        return places_[(next_ + after) % places_.size()];
    }

    std::size_t n_;
    double h_;
    std::array<Place, 2 * reach + 1> places_;
    std::size_t next_ = 0;  ///< the oldest place, once all are filled
};

/// Estimates the distance of a value by 2 reach steps from the limit of many steps. For each
/// frequency values approach the limit from one side, by parts that shrink as powers. NOTE: where
/// the parts hardly shrink, as rounding errors do, their number is unknown.
class ErrorOfDifferences {
public:
    /// Takes values by 2 reach steps, by two less, and by four less.
    void see(double value, double before, double before_that) {
        last_ = std::max(last_, std::abs(value - before));
        one_before_ = std::max(one_before_, std::abs(before - before_that));
    }

    [[nodiscard]] double value() const {
        constexpr double most = 0.95;
        const double ratio = last_ < most * one_before_ ? last_ / one_before_ : most;
        return last_ * std::max(1.0, ratio / (1 - ratio));
    }

private:
    double last_ = 0, one_before_ = 0;
};

/// Sets b and d to 0, on which nothing depends, so that rounding errors of their differences do not
/// grow with time.
void forget_growth(DrivenStepper::State& x, std::size_t n) {
    x.p[n] = 0;
    if (x.q.size() > n + 1) x.q[n + 1] = 0;
}

}  // namespace

int take_shadow(const ShadowWishes& wishes) {
    const auto weights = weights_of_differences(reach), fewer = weights_of_differences(reach - 1),
               fewest = weights_of_differences(reach - 2);
    DrivenStepper stepper = DrivenProblem::stepper();
    DrivenStepper::State x = stepper.initial();
    Window window(wishes);
    window.add(x);
    ProgressOfSteps progress(wishes.steps, 0, 1);
    detail::Departure departure;
    ErrorOfDifferences error;
    for (std::int64_t taken = 1; taken <= wishes.steps; ++taken) {
        forget_growth(x, wishes.degrees);
        if (const Status status = stepper.step(x, wishes.h); !status.ok()) {
            driver::say("fault", status.message());
            return 0;
        }
        window.add(x);
        progress.tell(taken);
        if (taken < ShadowWishes::fewest_steps()) continue;
        const double value = window.value(weights);
        if (taken == ShadowWishes::fewest_steps()) departure.start = value;
        departure.see(value);
        error.see(value, window.value(fewer), window.value(fewest));
    }
    driver::say("shadow", departure.start);
    driver::say("largest", departure.largest);
    driver::say("last", departure.last);
    driver::say("error", error.value());
    return 0;
}

}  // namespace hvi::gen
