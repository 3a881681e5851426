// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/tangents.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <driver/answer.hpp>

#include "generator/drive/directions.hpp"
#include "generator/drive/driven_problem.hpp"
#include "generator/drive/progress_of_steps.hpp"

namespace hvi::gen {

namespace {

/// A direction in which no component is small: there is some of each mode in it.
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

/// Takes the steps of the directions, and calls see(taken) after each whole one. False where one
/// fails.
template <class See>
bool take(Directions& directions, const TangentWishes& wishes, ProgressOfSteps progress, See see) {
    for (std::int64_t taken = 1; taken <= wishes.steps; ++taken) {
        if (const Status status = directions.step(wishes.h); !status.ok()) {
            driver::say("fault", status.message());
            return false;
        }
        see(taken);
        progress.tell(taken);
    }
    if (wishes.rest == 0) return true;
    const Status status = directions.step(wishes.rest);
    if (!status.ok()) driver::say("fault", status.message());
    return status.ok();
}

/// The growth of one direction: ln |v| at each step, and MEGNO, in the form of a sum over steps
/// (P. M. Cincotta, C. M. Giordano & C. Simo, Physica D 182, 2003, 151-178):
///
///     Y_n = (2/n) sum_k k ln(|v_k|/|v_k-1|), and its mean over the steps.
class Growth {
public:
    explicit Growth(Directions& directions) : directions_(directions) {}

    void see(std::int64_t step) {
        const double norm = norm_of(directions_.direction(0));
        const double by = std::log(norm / before_);
        before_ = norm;
        sum_ += by;
        weighted_ += static_cast<double>(step) * by;
        const auto n = static_cast<double>(step);
        of_megno_ += 2 * weighted_ / n;
        mean_ = of_megno_ / n;
        if (norm > 0x1p200 || norm < 0x1p-200) rescale(norm);
    }

    [[nodiscard]] double logarithm() const { return sum_; }
    [[nodiscard]] double megno() const { return mean_; }

private:
    /// By a power of two, so that nothing is rounded.
    void rescale(double norm) {
        DirectionVector v = directions_.direction(0);
        const int exponent = std::ilogb(norm);
        for (double& value : v) value = std::scalbn(value, -exponent);
        directions_.set(0, v);
        before_ = std::scalbn(norm, -exponent);
    }

    Directions& directions_;
    double before_ = 1, sum_ = 0, weighted_ = 0, of_megno_ = 0, mean_ = 0;
};

bool tell_largest(const TangentWishes& wishes, ProgressOfSteps progress) {
    constexpr double golden = 0.6180339887498949;
    Directions directions({usual_direction(2 * degrees_of_problem(), golden)});
    Growth growth(directions);
    if (!take(directions, wishes, progress, [&](std::int64_t step) { growth.see(step); }))
        return false;
    const double time = wishes.h * static_cast<double>(wishes.steps);
    driver::say("lyapunov", growth.logarithm() / std::abs(time));
    driver::say("megno", growth.megno());
    return true;
}

/// All exponents, from directions that are made orthonormal after so many steps (G. Benettin et
/// al., Meccanica 15, 1980, 9-30).
bool tell_spectrum(const TangentWishes& wishes, ProgressOfSteps progress) {
    constexpr std::int64_t between = 10;
    const std::size_t count = 2 * degrees_of_problem();
    Directions directions(all_units(count));
    std::vector<double> sums(count);
    const auto see = [&](std::int64_t step) {
        if (step % between != 0 && step != wishes.steps) return;
        std::vector<DirectionVector> all;
        for (std::size_t k = 0; k < count; ++k) all.push_back(directions.direction(k));
        const std::vector<double> norms = orthonormalize(all);
        for (std::size_t k = 0; k < count; ++k) {
            sums[k] += std::log(norms[k]);
            directions.set(k, all[k]);
        }
    };
    if (!take(directions, wishes, progress, see)) return false;
    const double time = wishes.h * static_cast<double>(wishes.steps);
    for (const double sum : sums) driver::say("exponent", sum / std::abs(time));
    return true;
}

/// The smaller of |v + w| and |v - w| for two directions of norm 1 (Ch. Skokos, J. Phys. A 34,
/// 2001, 10029-10043).
bool tell_sali(const TangentWishes& wishes, ProgressOfSteps progress) {
    constexpr double golden = 0.6180339887498949, silver = 0.4142135623730951;
    const std::size_t numbers = 2 * degrees_of_problem();
    std::vector<DirectionVector> start{usual_direction(numbers, golden),
                                       usual_direction(numbers, silver)};
    for (std::size_t k = 0; k < numbers; k += 2) start[1][k] = -start[1][k];
    Directions directions(start);
    double index = 0;
    const auto see = [&](std::int64_t) {
        std::vector<DirectionVector> all{directions.direction(0), directions.direction(1)};
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
        directions.set(0, all[0]);
        directions.set(1, all[1]);
    };
    if (!take(directions, wishes, progress, see)) return false;
    driver::say("sali", index);
    return true;
}

/// The largest entry of D^T J D - J, over the square of the largest of D: 0 but for rounding.
double symplecticity_error(const std::vector<DirectionVector>& columns) {
    const std::size_t n = columns.size() / 2;
    double largest = 1, error = 0;
    for (const DirectionVector& v : columns)
        for (const double value : v) largest = std::max(largest, std::abs(value));
    for (std::size_t a = 0; a < columns.size(); ++a)
        for (std::size_t b = a + 1; b < columns.size(); ++b) {
            double form = b == a + n ? -1 : 0;
            for (std::size_t k = 0; k < n; ++k)
                form += columns[a][k] * columns[b][n + k] - columns[a][n + k] * columns[b][k];
            error = std::max(error, std::abs(form));
        }
    return error / (largest * largest);
}

/// The state itself, at the end of directions.
DrivenStepper::State end_of(const Directions& directions) {
    const DrivenStepper::State& both = directions.state();
    const auto n = static_cast<std::ptrdiff_t>(directions.degrees());
    DrivenStepper::State x;
    x.q.assign(both.q.begin(), both.q.begin() + n);
    x.p.assign(both.p.begin() + n, both.p.end());
    return x;
}

/// Row by row: the time of the event, then its state.
void tell_event(const EventDerivative& of) {
    for (const double entry : of.time) driver::say("event", entry);
    for (std::size_t row = 0; row < of.time.size(); ++row)
        for (const DirectionVector& column : of.state) driver::say("event", column[row]);
}

bool tell_matrix(const TangentWishes& wishes, ProgressOfSteps progress) {
    const std::size_t count = 2 * degrees_of_problem();
    Directions directions(all_units(count));
    if (!take(directions, wishes, progress, [](std::int64_t) {})) return false;
    std::vector<DirectionVector> columns;
    for (std::size_t k = 0; k < count; ++k) columns.push_back(directions.direction(k));
    for (std::size_t row = 0; row < count; ++row)
        for (const DirectionVector& column : columns) driver::say("entry", column[row]);
    driver::say("form", symplecticity_error(columns));
    if (!wishes.crossing) return true;
    const EventCrossing crossing = wishes.crossing(end_of(directions), wishes.t);
    if (const auto of = event_derivative(crossing, columns)) tell_event(*of);
    if (crossing.by_time == 0) driver::say("surface", "stays");
    return true;
}

bool tell_own(const TangentWishes& wishes, ProgressOfSteps progress) {
    Directions directions({direction_of(DrivenProblem::initial())});
    if (!take(directions, wishes, progress, [](std::int64_t) {})) return false;
    for (const double component : directions.direction(0)) driver::say("component", component);
    return true;
}

}  // namespace

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
