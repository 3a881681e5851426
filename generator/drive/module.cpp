// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/module.hpp"

#include <dlfcn.h>

#include <cstddef>
#include <new>
#include <stdexcept>
#include <utility>

namespace hvi::gen {

namespace {

void* made(const Module& module) {
    constexpr std::size_t most_of_message = 4096;
    // NOTE: as many as there are processors.
    constexpr unsigned threads = 0;
    const std::vector<double>& parameters = module.start().parameters;
    void* stepper = nullptr;
    std::string message(most_of_message, '\0');
    switch (module.call().create(module.start().directory.c_str(), threads, parameters.data(),
                                 parameters.size(), &stepper, message.data(), message.size())) {
    case detail::DrivenAnswer::ok: return stepper;
    case detail::DrivenAnswer::out_of_memory: throw std::bad_alloc();
    case detail::DrivenAnswer::failed: break;
    }
    throw std::runtime_error(message.c_str());
}

/// The functions of a library of this version, which stays loaded.
template <class Functions>
const Functions* functions(const std::string& path, const char* symbol) {
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(::dlerror());
    const auto* const found = static_cast<const Functions*>(::dlsym(library, symbol));
    if (found == nullptr || found->version != detail::driven_version)
        throw std::runtime_error(path + " is no module of this version of hvi");
    return found;
}

}  // namespace

Module::Module(ModuleStart start)
    : start_(std::move(start)),
      call_(functions<detail::DrivenFunctions>(start_.path, "hvi_scene")) {
    if (start_.solvers.empty()) return;
    call_->take_solvers(functions<detail::SolverFunctions>(start_.solvers, "hvi_solvers")->find);
}

ModuleStepper::ModuleStepper(const Module& module)
    : call_(&module.call()),
      stepper_(made(module), Destroy{call_->destroy}),
      sizes_(call_->sizes(stepper_.get())) {}

std::vector<double> ModuleStepper::numbers(const State& x) {
    std::vector<double> all(x.q);
    all.insert(all.end(), x.p.begin(), x.p.end());
    all.insert(all.end(), x.time.begin(), x.time.end());
    return all;
}

void ModuleStepper::set(State& x, const std::vector<double>& numbers) const {
    const auto q = numbers.begin(), p = q + static_cast<std::ptrdiff_t>(sizes_.coordinates),
               t = p + static_cast<std::ptrdiff_t>(sizes_.momenta);
    x.q.assign(q, p);
    x.p.assign(p, t);
    x.time.assign(t, numbers.end());
}

ModuleStepper::State ModuleStepper::initial() const {
    std::vector<double> all(sizes_.coordinates + sizes_.momenta + (sizes_.has_time ? 1 : 0));
    call_->begin(stepper_.get(), all.data());
    State x;
    set(x, all);
    return x;
}

template <class Take>
Run ModuleStepper::advanced(State& x, Take take) {
    std::vector<double> all = numbers(x);
    const detail::DrivenCounts before = call_->counts(stepper_.get());
    const int code = take(all.data());
    if (code == detail::driven_out_of_memory) throw std::bad_alloc();
    if (code == detail::driven_solver_is_apart) throw detail::SolverIsApart();
    const detail::DrivenCounts after = call_->counts(stepper_.get());
    Run run;
    run.steps = after.steps - before.steps;
    run.iterations = after.iterations - before.iterations;
    run.status = Status(static_cast<Status::Code>(code), static_cast<int>(run.iterations));
    set(x, all);
    return run;
}

Run ModuleStepper::advance(State& x, double h, std::int64_t steps) {
    return advanced(x, [&](double* all) { return call_->take(stepper_.get(), all, h, steps); });
}

Run ModuleStepper::follow(State& x, double h, std::int64_t steps,
                          std::vector<detail::Departure>& departures) {
    return advanced(x, [&](double* all) {
        return call_->follow(stepper_.get(), all, h, steps, departures.data());
    });
}

std::int64_t ModuleStepper::evaluations() const {
    return call_->counts(stepper_.get()).evaluations;
}

std::vector<std::string> ModuleStepper::conserved() const {
    std::vector<std::string> names(sizes_.invariants, "invariant");
    if (!sizes_.has_time) names.insert(names.begin(), "energy");
    return names;
}

void ModuleStepper::values(const State& x, double* out) const {
    const std::vector<double> all = numbers(x);
    if (!sizes_.has_time) *out++ = call_->energy(stepper_.get(), all.data());
    call_->invariants(stepper_.get(), all.data(), out);
}

}  // namespace hvi::gen
