// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/driven_stepper.hpp"

#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>

namespace hvi::gen {

DrivenStepper::DrivenStepper(MakeStepper make)
    : make_(std::move(make)),
      stepper_(make_()),
      sizes_(stepper_->sizes()),
      numbers_(sizes_.coordinates + sizes_.momenta + (sizes_.has_time ? 1 : 0)) {}

double* DrivenStepper::in_a_row(const State& x) const {
    auto next = std::copy(x.q.begin(), x.q.end(), numbers_.begin());
    next = std::copy(x.p.begin(), x.p.end(), next);
    std::copy(x.time.begin(), x.time.end(), next);
    return numbers_.data();
}

void DrivenStepper::set(State& x, const std::vector<double>& numbers) const {
    const auto q = numbers.begin(), p = q + static_cast<std::ptrdiff_t>(sizes_.coordinates),
               t = p + static_cast<std::ptrdiff_t>(sizes_.momenta);
    x.q.assign(q, p);
    x.p.assign(p, t);
    x.time.assign(t, numbers.end());
}

DrivenStepper::State DrivenStepper::initial() const {
    stepper_->begin(numbers_.data());
    State x;
    set(x, numbers_);
    return x;
}

template <class Take>
Run DrivenStepper::advanced(State& x, Take take) {
    double* const all = in_a_row(x);
    const detail::DrivenCounts before = stepper_->counts();
    const int code = take(all);
    if (code == detail::driven_out_of_memory) throw std::bad_alloc();
    if (code == detail::driven_solver_is_apart) throw detail::SolverIsApart();
    const detail::DrivenCounts after = stepper_->counts();
    Run run;
    run.steps = after.steps - before.steps;
    run.iterations = after.iterations - before.iterations;
    run.status = Status(static_cast<Status::Code>(code), static_cast<int>(run.iterations));
    set(x, numbers_);
    return run;
}

Run DrivenStepper::advance(State& x, double h, std::int64_t steps) {
    return advanced(x, [&](double* all) { return stepper_->take(all, h, steps); });
}

Run DrivenStepper::follow(State& x, double h, std::int64_t steps,
                          std::vector<detail::Departure>& departures) {
    return advanced(
        x, [&](double* all) { return stepper_->follow(all, h, steps, departures.data()); });
}

Status DrivenStepper::carry(State& x, std::vector<double>& directions, std::size_t count,
                            double h) {
    const auto take = [&](double* all) {
        return stepper_->carrier()->carry(all, directions.data(), count, h);
    };
    return advanced(x, take).status;
}

std::vector<std::string> DrivenStepper::conserved() const {
    std::vector<std::string> names(sizes_.invariants, "invariant");
    if (!sizes_.has_time) names.insert(names.begin(), "energy");
    return names;
}

void DrivenStepper::values(const State& x, double* out) const {
    const double* const all = in_a_row(x);
    if (!sizes_.has_time) *out++ = stepper_->energy(all);
    stepper_->invariants(all, out);
}

}  // namespace hvi::gen
