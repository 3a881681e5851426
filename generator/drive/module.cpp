// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/module.hpp"

#include <cstddef>
#include <new>
#include <stdexcept>
#include <utility>

#include "generator/drive/library.hpp"

namespace hvi::gen {

namespace {

/// The functions of a library of this version, which stays loaded.
template <class Functions>
const Functions* functions(const std::string& path, const char* symbol) {
    return static_cast<const Functions*>(
        functions_of_library(path, symbol, detail::driven_version));
}

void* made(const detail::DrivenFunctions& call, const std::string& directory,
           const std::vector<double>& numbers) {
    constexpr std::size_t most_of_message = 4096;
    // NOTE: as many as there are processors.
    constexpr unsigned threads = 0;
    void* stepper = nullptr;
    std::string message(most_of_message, '\0');
    switch (call.create(directory.c_str(), threads, numbers.data(), numbers.size(), &stepper,
                        message.data(), message.size())) {
    case detail::DrivenAnswer::ok: return stepper;
    case detail::DrivenAnswer::out_of_memory: throw std::bad_alloc();
    case detail::DrivenAnswer::failed: break;
    }
    throw std::runtime_error(message.c_str());
}

/// A stepper of a library, by the functions of that.
class LoadedStepper : public NumberStepper, private DirectionCarrier {
public:
    LoadedStepper(const detail::DrivenFunctions& call, const std::string& directory,
                  const std::vector<double>& numbers)
        : call_(call), stepper_(made(call, directory, numbers)) {}
    ~LoadedStepper() override { call_.destroy(stepper_); }
    LoadedStepper(const LoadedStepper&) = delete;
    LoadedStepper& operator=(const LoadedStepper&) = delete;

    [[nodiscard]] detail::DrivenSizes sizes() const override { return call_.sizes(stepper_); }
    [[nodiscard]] detail::DrivenCounts counts() const override { return call_.counts(stepper_); }
    void begin(double* state) const override { call_.begin(stepper_, state); }
    [[nodiscard]] int take(double* state, double h, std::int64_t steps) override {
        return call_.take(stepper_, state, h, steps);
    }
    [[nodiscard]] int follow(double* state, double h, std::int64_t steps,
                             detail::Departure* departures) override {
        return call_.follow(stepper_, state, h, steps, departures);
    }
    [[nodiscard]] DirectionCarrier* carrier() override {
        return call_.carry == nullptr ? nullptr : this;
    }
    void reset() override { call_.reset(stepper_); }
    [[nodiscard]] double energy(const double* state) const override {
        return call_.energy(stepper_, state);
    }
    void invariants(const double* state, double* values) const override {
        call_.invariants(stepper_, state, values);
    }

private:
    [[nodiscard]] int carry(double* state, double* directions, std::size_t count,
                            double h) override {
        return call_.carry(stepper_, state, directions, count, h);
    }

    const detail::DrivenFunctions& call_;
    void* stepper_;
};

}  // namespace

MakeStepper loaded_module(ModuleStart start) {
    std::vector<double> numbers = start.parameters;
    return loaded_family(std::move(start))(std::move(numbers));
}

StepperFamily loaded_family(ModuleStart start) {
    const auto* const call = functions<detail::DrivenFunctions>(start.path, "hvi_scene");
    if (!start.solvers.empty())
        call->take_solvers(functions<detail::SolverFunctions>(start.solvers, "hvi_solvers")->find);
    return [call, directory = std::move(start.directory)](std::vector<double> numbers) {
        return [call, directory, numbers = std::move(numbers)] {
            return std::make_unique<LoadedStepper>(*call, directory, numbers);
        };
    };
}

}  // namespace hvi::gen
