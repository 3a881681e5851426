// A compiled module, and a stepper of it as src/driver takes steppers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <hvi/detail/module/driven_functions.hpp>
#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

namespace hvi::gen {

/// Words that make steppers of a module.
struct ModuleStart {
    std::string path;       ///< of the library
    std::string solvers;    ///< path of the library of its solvers; or empty
    std::string directory;  ///< of the scene, whose files are found from there
    std::vector<double> parameters;
};

/// A module that is loaded. It stays so until the process ends.
class Module {
public:
    /// Throws std::runtime_error where the file is no module of this version.
    explicit Module(ModuleStart start);

    [[nodiscard]] const detail::DrivenFunctions& call() const { return *call_; }
    [[nodiscard]] const ModuleStart& start() const { return start_; }

private:
    ModuleStart start_;
    const detail::DrivenFunctions* call_;
};

class ModuleStepper {
public:
    using Scalar = double;
    struct State : hvi::State<std::vector<double>> {
        std::vector<double> time = {};  ///< one number where H depends on it
    };

    /// Throws std::bad_alloc, and std::runtime_error with what the module says. Precondition: the
    /// module outlives it.
    explicit ModuleStepper(const Module& module);

    [[nodiscard]] State initial() const;

    [[nodiscard]] Status step(State& x, double h) { return advance(x, h, 1).status; }
    /// Throws std::bad_alloc, and SolverIsApart.
    [[nodiscard]] Run advance(State& x, double h, std::int64_t steps);
    /// Takes steps as advance() does, and looks after each at what is conserved().
    [[nodiscard]] Run follow(State& x, double h, std::int64_t steps,
                             std::vector<detail::Departure>& departures);
    [[nodiscard]] std::int64_t evaluations() const;

    /// Names of what a run is to keep: the energy, where H does not depend on the time, and the
    /// invariants of the scene, whose names do not matter here.
    [[nodiscard]] std::vector<std::string> conserved() const;
    /// Writes their values.
    void values(const State& x, double* out) const;

private:
    struct Destroy {
        void (*destroy)(void*);
        void operator()(void* stepper) const { destroy(stepper); }
    };

    /// Advances the state by take(numbers).
    template <class Take>
    [[nodiscard]] Run advanced(State& x, Take take);
    [[nodiscard]] static std::vector<double> numbers(const State& x);
    void set(State& x, const std::vector<double>& numbers) const;

    const detail::DrivenFunctions* call_;
    std::unique_ptr<void, Destroy> stepper_;
    detail::DrivenSizes sizes_{};
};

}  // namespace hvi::gen
