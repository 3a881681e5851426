// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/directions.hpp"

#include <algorithm>
#include <cmath>

#include "generator/drive/driven_problem.hpp"

namespace hvi::gen {

double product_of(const DirectionVector& v, const DirectionVector& w) {
    double sum = 0;
    for (std::size_t k = 0; k < v.size(); ++k) sum += v[k] * w[k];
    return sum;
}

/// NOTE: scaled, as squares of what grows may be beyond doubles.
double norm_of(const DirectionVector& v) {
    double largest = 0;
    for (const double value : v) largest = std::max(largest, std::abs(value));
    if (largest == 0 || !std::isfinite(largest)) return largest;
    double sum = 0;
    for (const double value : v) sum += (value / largest) * (value / largest);
    return largest * std::sqrt(sum);
}

double symplectic_form(const DrivenStepper::State& x, const DirectionVector& v,
                       const DirectionVector& w) {
    const std::size_t n = v.size() / 2, rotations = (x.q.size() - x.p.size()) / 6;
    double form = 0;
    for (std::size_t k = 0; k < n; ++k) form += v[k] * w[n + k] - v[n + k] * w[k];
    for (std::size_t r = n - 3 * rotations; r < n; r += 3)
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = r + (a + 1) % 3, c = r + (a + 2) % 3;
            form += x.p[r + a] * (v[b] * w[c] - v[c] * w[b]);
        }
    return form;
}

DirectionVector DirectionsAtOneTime::without_time(const DirectionVector& v) const {
    const double part = v[n_ - 1] / motion_[n_ - 1];
    DirectionVector result = v;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] -= motion_[k] * part;
    return of_q_and_p(result);
}

/// NOTE: the motion is g (dH/dp, 1, -dH/dq, -dH/dt), where g is how fast the time goes.
DirectionVector DirectionsAtOneTime::with_time(const DirectionVector& v) const {
    const std::size_t n = n_ - 1;
    DirectionVector result(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n));
    result.push_back(0);
    result.insert(result.end(), v.begin() + static_cast<std::ptrdiff_t>(n), v.end());
    double change = 0;
    for (std::size_t k = 0; k < n; ++k) change += motion_[k] * v[n + k] - motion_[n_ + k] * v[k];
    result.push_back(-change / motion_[n]);
    return result;
}

DirectionVector DirectionsAtOneTime::of_q_and_p(const DirectionVector& v) {
    DirectionVector result = v;
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(v.size() / 2 - 1));
    result.pop_back();
    return result;
}

DirectionVector direction_of(const DrivenStepper::State& x) {
    const auto n = static_cast<std::ptrdiff_t>(x.q.size() / 2);
    DirectionVector v(x.q.begin() + n, x.q.end());
    v.insert(v.end(), x.p.begin(), x.p.begin() + n);
    return v;
}

namespace {

/// Directions that share the stages of a step, which carries them.
class DirectionsTogether : public MovedDirections {
public:
    DirectionsTogether(DrivenStepper stepper, std::size_t count)
        : stepper_(std::move(stepper)), x_(stepper_.initial()), count_(count) {
        numbers_.resize(count * size());
    }

    Status step(double h) override { return stepper_.carry(x_, numbers_, count_, h); }

    std::vector<DirectionVector> all() const override {
        std::vector<DirectionVector> result;
        const auto step = static_cast<std::ptrdiff_t>(size());
        for (auto next = numbers_.begin(); next != numbers_.end(); next += step)
            result.emplace_back(next, next + step);
        return result;
    }

    void set(const std::vector<DirectionVector>& all) override {
        numbers_.clear();
        for (const DirectionVector& v : all) numbers_.insert(numbers_.end(), v.begin(), v.end());
    }

    DrivenStepper::State state() const override { return {{x_.q, x_.p}}; }

private:
    [[nodiscard]] std::size_t size() const { return 2 * x_.p.size(); }

    DrivenStepper stepper_;
    DrivenStepper::State x_;
    std::vector<double> numbers_;
    std::size_t count_;
};

/// Directions that have a stepper of their own each, for states (q, dq), (dp, p). All go along the
/// motion of the first: where rounding makes another one of it, as stages are solved for, the
/// others are put back.
class DirectionsApart : public MovedDirections {
public:
    explicit DirectionsApart(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            steppers_.push_back(DrivenProblem::stepper());
            states_.push_back(steppers_.back().initial());
        }
    }

    Status step(double h) override {
        const auto n = static_cast<std::ptrdiff_t>(degrees());
        for (std::size_t k = 0; k < states_.size(); ++k) {
            DrivenStepper::State& x = states_[k];
            const Status status = steppers_[k].step(x, h);
            if (!status.ok()) return status;
            if (k == 0) continue;
            const DrivenStepper::State& first = states_.front();
            std::copy(first.q.begin(), first.q.begin() + n, x.q.begin());
            std::copy(first.p.begin() + n, first.p.end(), x.p.begin() + n);
        }
        return {};
    }

    std::vector<DirectionVector> all() const override {
        std::vector<DirectionVector> result;
        for (const DrivenStepper::State& x : states_) result.push_back(direction_of(x));
        return result;
    }

    void set(const std::vector<DirectionVector>& all) override {
        const auto n = static_cast<std::ptrdiff_t>(degrees());
        for (std::size_t k = 0; k < all.size(); ++k) {
            DrivenStepper::State& x = states_[k];
            std::copy(all[k].begin(), all[k].begin() + n, x.q.begin() + n);
            std::copy(all[k].begin() + n, all[k].end(), x.p.begin());
        }
    }

    DrivenStepper::State state() const override {
        const auto n = static_cast<std::ptrdiff_t>(degrees());
        const DrivenStepper::State& both = states_.front();
        DrivenStepper::State x;
        x.q.assign(both.q.begin(), both.q.begin() + n);
        x.p.assign(both.p.begin() + n, both.p.end());
        return x;
    }

private:
    /// Half the numbers of a direction.
    [[nodiscard]] std::size_t degrees() const { return states_.front().q.size() / 2; }

    std::vector<DrivenStepper> steppers_;
    std::vector<DrivenStepper::State> states_;
};

std::unique_ptr<MovedDirections> moved(std::size_t count) {
    DrivenStepper stepper = DrivenProblem::stepper();
    if (stepper.carries_directions())
        return std::make_unique<DirectionsTogether>(std::move(stepper), count);
    return std::make_unique<DirectionsApart>(count);
}

}  // namespace

std::size_t degrees_of_problem() {
    const DrivenStepper stepper = DrivenProblem::stepper();
    const std::size_t degrees = stepper.initial().p.size();
    return stepper.carries_directions() ? degrees : degrees / 2;
}

Directions::Directions(std::size_t count, FindMotion motion)
    : moved_(moved(count)), motion_(std::move(motion)) {}

Directions::Directions(const std::vector<DirectionVector>& start, FindMotion motion)
    : Directions(start.size(), std::move(motion)) {
    set(start);
}

std::vector<DirectionVector> Directions::all() const {
    std::vector<DirectionVector> result = carried();
    if (!motion_) return result;
    const DirectionsAtOneTime at_one_time(motion_(state()));
    for (DirectionVector& v : result) v = at_one_time.without_time(v);
    return result;
}

void Directions::set(const std::vector<DirectionVector>& all) {
    if (!motion_) return moved_->set(all);
    std::vector<DirectionVector> whole = all;
    const DirectionsAtOneTime at_one_time(motion_(state()));
    for (DirectionVector& v : whole) v = at_one_time.with_time(v);
    moved_->set(whole);
}

std::vector<double> orthonormalize(std::vector<DirectionVector>& all) {
    std::vector<double> norms;
    for (std::size_t k = 0; k < all.size(); ++k) {
        DirectionVector& v = all[k];
        for (int pass = 0; pass < 2; ++pass)
            for (std::size_t j = 0; j < k; ++j) {
                const double part = product_of(all[j], v);
                for (std::size_t i = 0; i < v.size(); ++i) v[i] -= part * all[j][i];
            }
        norms.push_back(norm_of(v));
        for (double& value : v) value /= norms.back();
    }
    return norms;
}

}  // namespace hvi::gen
