// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/driven_stepper.hpp"

#include <cstddef>
#include <new>
#include <utility>

namespace hvi::gen {

DrivenStepper::DrivenStepper(std::unique_ptr<NumberStepper> stepper)
    : stepper_(std::move(stepper)), sizes_(stepper_->sizes()) {}

std::vector<double> DrivenStepper::numbers(const State& x) {
    std::vector<double> all(x.q);
    all.insert(all.end(), x.p.begin(), x.p.end());
    all.insert(all.end(), x.time.begin(), x.time.end());
    return all;
}

void DrivenStepper::set(State& x, const std::vector<double>& numbers) const {
    const auto q = numbers.begin(), p = q + static_cast<std::ptrdiff_t>(sizes_.coordinates),
               t = p + static_cast<std::ptrdiff_t>(sizes_.momenta);
    x.q.assign(q, p);
    x.p.assign(p, t);
    x.time.assign(t, numbers.end());
}

DrivenStepper::State DrivenStepper::initial() const {
    std::vector<double> all(sizes_.coordinates + sizes_.momenta + (sizes_.has_time ? 1 : 0));
    stepper_->begin(all.data());
    State x;
    set(x, all);
    return x;
}

template <class Take>
Run DrivenStepper::advanced(State& x, Take take) {
    std::vector<double> all = numbers(x);
    const detail::DrivenCounts before = stepper_->counts();
    const int code = take(all.data());
    if (code == detail::driven_out_of_memory) throw std::bad_alloc();
    if (code == detail::driven_solver_is_apart) throw detail::SolverIsApart();
    const detail::DrivenCounts after = stepper_->counts();
    Run run;
    run.steps = after.steps - before.steps;
    run.iterations = after.iterations - before.iterations;
    run.status = Status(static_cast<Status::Code>(code), static_cast<int>(run.iterations));
    set(x, all);
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

std::vector<std::string> DrivenStepper::conserved() const {
    std::vector<std::string> names(sizes_.invariants, "invariant");
    if (!sizes_.has_time) names.insert(names.begin(), "energy");
    return names;
}

void DrivenStepper::values(const State& x, double* out) const {
    const std::vector<double> all = numbers(x);
    if (!sizes_.has_time) *out++ = stepper_->energy(all.data());
    stepper_->invariants(all.data(), out);
}

}  // namespace hvi::gen
