// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/tangents.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <driver/answer.hpp>

#include "generator/drive/directions.hpp"
#include "generator/drive/driven_problem.hpp"
#include "generator/drive/progress_of_steps.hpp"

namespace hvi::gen {

namespace {

/// Returns the numbers of a direction: a scaled time and its momentum do not count.
std::size_t numbers_of(const TangentWishes& wishes) {
    return 2 * (degrees_of_problem() - (wishes.motion ? 1 : 0));
}

/// Returns the time after steps: their number times h, or the scaled time.
double time_of(const Directions& directions, const TangentWishes& wishes, std::int64_t steps) {
    return wishes.motion ? directions.state().q.back() : wishes.h * static_cast<double>(steps);
}

/// Returns a direction in which no component is small, so that it contains each mode.
DirectionVector usual_direction(std::size_t numbers, double seed) {
    DirectionVector v;
    for (std::size_t k = 1; k <= numbers; ++k) {
        const double part = seed * static_cast<double>(k);
        v.push_back(0.5 + (part - std::floor(part)));
    }
    const double norm = norm_of(v);
    for (double& value : v) value /= norm;
    return v;
}

std::vector<DirectionVector> all_units(std::size_t numbers) {
    std::vector<DirectionVector> result(numbers, DirectionVector(numbers));
    for (std::size_t k = 0; k < numbers; ++k) result[k][k] = 1;
    return result;
}

/// Takes the steps of the directions until one fails, and calls see(taken) after each whole step.
template <class See>
Status moved(Directions& directions, const TangentWishes& wishes, See see) {
    for (std::int64_t taken = 1; taken <= wishes.steps; ++taken) {
        if (const Status status = directions.step(wishes.h); !status.ok()) return status;
        see(taken);
    }
    return wishes.rest == 0 ? Status() : directions.step(wishes.rest);
}

/// Whether a status is ok. Reports it where it is not.
bool is_good(const Status& status) {
    if (!status.ok()) driver::say("fault", status.message());
    return status.ok();
}

/// Takes the steps of the directions, and calls see(taken) after each whole step. Returns false
/// where a step fails.
template <class See>
bool take(Directions& directions, const TangentWishes& wishes, ProgressOfSteps progress, See see) {
    return is_good(moved(directions, wishes, [&](std::int64_t taken) {
        see(taken);
        progress.tell(taken);
    }));
}

/// The growth of one direction: ln |v| at each step, and MEGNO, in the form of a sum over steps
/// (P. M. Cincotta, C. M. Giordano & C. Simo, Physica D 182, 2003, 151-178):
///
///     Y_n = (2/n) sum_k k ln(|v_k|/|v_k-1|), and its mean over the steps,
///
/// or with times t_k in the place of k.
class Growth {
public:
    explicit Growth(Directions& directions) : directions_(directions) {}

    /// Takes the growth at a time, which may be counted in steps.
    void see(double time) {
        const double norm = norm_of(directions_.all().front());
        const double by = std::log(norm / before_);
        before_ = norm;
        sum_ += by;
        weighted_ += time * by;
        of_megno_ += 2 * weighted_ / time * (time - time_);
        mean_ = of_megno_ / time;
        time_ = time;
        if (norm > 0x1p200 || norm < 0x1p-200) rescale(norm);
    }

    [[nodiscard]] double logarithm() const { return sum_; }
    [[nodiscard]] double megno() const { return mean_; }

private:
    /// Scales by a power of two, so that nothing is rounded.
    void rescale(double norm) {
        std::vector<DirectionVector> all = directions_.all();
        const int exponent = std::ilogb(norm);
        for (double& value : all.front()) value = std::scalbn(value, -exponent);
        directions_.set(all);
        before_ = std::scalbn(norm, -exponent);
    }

    Directions& directions_;
    double before_ = 1, sum_ = 0, weighted_ = 0, of_megno_ = 0, mean_ = 0, time_ = 0;
};

bool tell_largest(const TangentWishes& wishes, ProgressOfSteps progress) {
    const LargestGrowth growth =
        largest_growth(wishes, [&](std::int64_t taken) { progress.tell(taken); });
    if (!is_good(growth.status)) return false;
    driver::say("lyapunov", growth.lyapunov);
    driver::say("megno", growth.megno);
    return true;
}

/// Reports all exponents, from directions that are made orthonormal at regular steps (G. Benettin
/// et al., Meccanica 15, 1980, 9-30).
bool tell_spectrum(const TangentWishes& wishes, ProgressOfSteps progress) {
    constexpr std::int64_t between = 10;
    const std::size_t count = numbers_of(wishes);
    Directions directions(all_units(count), wishes.motion);
    std::vector<double> sums(count);
    double time = 0;
    const auto see = [&](std::int64_t step) {
        if (step % between != 0 && step != wishes.steps) return;
        std::vector<DirectionVector> all = directions.all();
        const std::vector<double> norms = orthonormalize(all);
        for (std::size_t k = 0; k < count; ++k) sums[k] += std::log(norms[k]);
        directions.set(all);
        time = time_of(directions, wishes, step);
    };
    if (!take(directions, wishes, progress, see)) return false;
    for (const double sum : sums) driver::say("exponent", sum / std::abs(time));
    return true;
}

/// Reports the smaller of |v + w| and |v - w| for two directions of norm 1 (Ch. Skokos, J. Phys. A
/// 34, 2001, 10029-10043).
bool tell_sali(const TangentWishes& wishes, ProgressOfSteps progress) {
    constexpr double silver = 0.4142135623730951;
    const std::size_t numbers = numbers_of(wishes);
    std::vector<DirectionVector> start{growing_direction(numbers),
                                       usual_direction(numbers, silver)};
    for (std::size_t k = 0; k < numbers; k += 2) start[1][k] = -start[1][k];
    Directions directions(start, wishes.motion);
    double index = 0;
    const auto see = [&](std::int64_t) {
        std::vector<DirectionVector> all = directions.all();
        for (DirectionVector& v : all) {
            const double norm = norm_of(v);
            for (double& value : v) value /= norm;
        }
        DirectionVector sum = all[0], difference = all[0];
        for (std::size_t k = 0; k < numbers; ++k) {
            sum[k] += all[1][k];
            difference[k] -= all[1][k];
        }
        index = std::min(norm_of(sum), norm_of(difference));
        directions.set(all);
    };
    if (!take(directions, wishes, progress, see)) return false;
    driver::say("sali", index);
    return true;
}

/// Returns how much the symplectic form of the units at `start` changes on their way to the columns
/// of D at `end`: the largest entry of D^T J D - J, over the square of the largest of D. It is 0
/// but for rounding.
double symplecticity_error(const DrivenStepper::State& start, const DrivenStepper::State& end,
                           const std::vector<DirectionVector>& columns) {
    const std::vector<DirectionVector> units = all_units(columns.size());
    double largest = 1, error = 0;
    for (const DirectionVector& v : columns)
        for (const double value : v) largest = std::max(largest, std::abs(value));
    for (std::size_t a = 0; a < columns.size(); ++a)
        for (std::size_t b = a + 1; b < columns.size(); ++b) {
            const double change = symplectic_form(end, columns[a], columns[b]) -
                                  symplectic_form(start, units[a], units[b]);
            error = std::max(error, std::abs(change));
        }
    return error / (largest * largest);
}

/// Reports a square matrix row by row.
void tell_rows(const char* name, const std::vector<DirectionVector>& columns) {
    for (std::size_t row = 0; row < columns.size(); ++row)
        for (const DirectionVector& column : columns) driver::say(name, column[row]);
}

/// Reports the derivatives of an event's time, and row by row the derivatives of its state.
void tell_event(const EventDerivative& of) {
    for (const double entry : of.time) driver::say("event_time", entry);
    tell_rows("event_state", of.state);
}

/// Returns the derivative of an event. In scaled time the derivative of its time is a row of that
/// of its state.
std::optional<EventDerivative> derivative_of(const EventCrossing& crossing,
                                             const Directions& directions,
                                             const TangentWishes& wishes) {
    std::optional<EventDerivative> result = event_derivative(crossing, directions.carried());
    if (!result || !wishes.motion) return result;
    for (std::size_t k = 0; k < result->state.size(); ++k) {
        DirectionVector& column = result->state[k];
        result->time[k] = column[column.size() / 2 - 1];
        column = DirectionsAtOneTime::of_q_and_p(column);
    }
    return result;
}

/// Whether the surface of an event does not move with time.
bool stays(const EventCrossing& crossing, const TangentWishes& wishes) {
    const std::vector<double>& by = crossing.by_state;
    return crossing.by_time == 0 && (!wishes.motion || by[by.size() / 2 - 1] == 0);
}

bool tell_matrix(const TangentWishes& wishes, ProgressOfSteps progress) {
    Directions directions(all_units(numbers_of(wishes)), wishes.motion);
    const DrivenStepper::State start = directions.state();
    if (!take(directions, wishes, progress, [](std::int64_t) {})) return false;
    const std::vector<DirectionVector> columns = directions.all();
    tell_rows("entry", columns);
    driver::say("form", symplecticity_error(start, directions.state(), columns));
    if (!wishes.crossing) return true;
    const EventCrossing crossing = wishes.crossing(directions.state(), wishes.t);
    if (const auto of = derivative_of(crossing, directions, wishes)) tell_event(*of);
    if (stays(crossing, wishes)) driver::say("surface", "stays");
    return true;
}

bool tell_own(const TangentWishes& wishes, ProgressOfSteps progress) {
    Directions directions(1, wishes.motion);
    if (!wishes.start.empty()) directions.set({wishes.start});
    if (!take(directions, wishes, progress, [](std::int64_t) {})) return false;
    const DirectionVector own = directions.all().front();
    for (const double component : own) driver::say("component", component);
    return true;
}

}  // namespace

DirectionVector growing_direction(std::size_t numbers) {
    constexpr double golden = 0.6180339887498949;
    return usual_direction(numbers, golden);
}

LargestGrowth largest_growth(const TangentWishes& wishes,
                             const std::function<void(std::int64_t)>& see) {
    Directions directions({growing_direction(numbers_of(wishes))}, wishes.motion);
    Growth growth(directions);
    double time = 0;
    const Status status = moved(directions, wishes, [&](std::int64_t step) {
        time = time_of(directions, wishes, step);
        growth.see(wishes.motion ? time : static_cast<double>(step));
        see(step);
    });
    return {status, growth.logarithm() / std::abs(time), growth.megno()};
}

int take_tangents(const TangentWishes& wishes) {
    using Tell = bool (*)(const TangentWishes&, ProgressOfSteps);
    std::vector<Tell> all;
    if (wishes.largest) all.push_back(tell_largest);
    if (wishes.spectrum) all.push_back(tell_spectrum);
    if (wishes.sali) all.push_back(tell_sali);
    if (wishes.matrix) all.push_back(tell_matrix);
    if (wishes.own) all.push_back(tell_own);
    const auto count = static_cast<double>(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto done = static_cast<double>(k);
        if (!all[k](wishes, {wishes.steps, done / count, (done + 1) / count})) break;
    }
    return 0;
}

}  // namespace hvi::gen
