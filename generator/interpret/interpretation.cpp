// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/interpretation.hpp"

#include <new>
#include <utility>
#include <variant>

#include "generator/interpret/interpreted_step.hpp"
#include "generator/module/driven.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// A scene and a method.
struct Interpretation {
    Step step;
    SystemProgram program;
};

std::unique_ptr<InterpretedStep> interpreted(const Step& step, InterpretedSystem system) {
    if (std::holds_alternative<VelocityStep>(step.form))
        return velocity_step(step, std::move(system));
    if (std::holds_alternative<PairStep>(step.form)) return pair_step(step, std::move(system));
    return explicit_step(step, std::move(system));
}

class InterpretedStepper : public NumberStepper {
public:
    InterpretedStepper(std::shared_ptr<const Interpretation> of, const std::vector<double>& numbers)
        : of_(std::move(of)),
          step_(interpreted(of_->step, InterpretedSystem(of_->program, numbers))) {}

    [[nodiscard]] detail::DrivenSizes sizes() const override {
        const std::size_t n = program().coordinates();
        return {n, program().momenta(), program().has_time(), program().values().size() - 1};
    }

    [[nodiscard]] detail::DrivenCounts counts() const override {
        return {steps_, iterations_, system().evaluations()};
    }

    void begin(double* state) const override {
        InterpretedState x;
        system().begin(x.q, x.p);
        write(x, state);
    }

    [[nodiscard]] int take(double* state, double h, std::int64_t steps) override {
        return advance(state, [&](InterpretedState& x) {
            Status status;
            for (std::int64_t k = 0; k < steps && status.ok(); ++k) status = taken(x, h);
            return status;
        });
    }

    [[nodiscard]] int follow(double* state, double h, std::int64_t steps,
                             detail::Departure* departures) override {
        return advance(state, [&](InterpretedState& x) {
            Status status;
            for (std::int64_t k = 0; k < steps && status.ok(); ++k) {
                status = taken(x, h);
                if (status.ok()) see(x, departures);
            }
            return status;
        });
    }

    void reset() override { step_->reset(); }

    [[nodiscard]] double energy(const double* state) const override {
        return value(program().values().front(), read(state));
    }

    void invariants(const double* state, double* values) const override {
        const InterpretedState x = read(state);
        const std::vector<std::string>& names = program().values();
        for (std::size_t k = 1; k < names.size(); ++k) *values++ = value(names[k], x);
    }

private:
    [[nodiscard]] const SystemProgram& program() const { return of_->program; }
    [[nodiscard]] const InterpretedSystem& system() const { return step_->system(); }

    [[nodiscard]] double value(const std::string& name, const InterpretedState& x) const {
        return system().value(name, {&x.q, &x.p, x.t});
    }

    /// Compares the values of a state with those at the start. NOTE: the energy is conserved where
    /// H does not depend on the time.
    void see(const InterpretedState& x, detail::Departure* departures) const {
        const std::vector<std::string>& names = program().values();
        for (std::size_t k = program().has_time() ? 1 : 0; k < names.size(); ++k)
            departures++->see(value(names[k], x));
    }

    Status taken(InterpretedState& x, double h) {
        const Status status = step_->take(x, h);
        iterations_ += status.iterations;
        if (status.ok()) ++steps_;
        return status;
    }

    template <class Take>
    int advance(double* state, Take take) {
        try {
            InterpretedState x = read(state);
            const Status status = take(x);
            write(x, state);
            return static_cast<int>(status.code());
        } catch (const std::bad_alloc&) { return detail::driven_out_of_memory; }
    }

    [[nodiscard]] InterpretedState read(const double* state) const {
        InterpretedState x;
        const double* const p = state + program().coordinates();
        const double* const end = p + program().momenta();
        x.q.assign(state, p);
        x.p.assign(p, end);
        if (program().has_time()) x.t = *end;
        return x;
    }

    void write(const InterpretedState& x, double* state) const {
        for (const double number : x.q) *state++ = number;
        for (const double number : x.p) *state++ = number;
        if (program().has_time()) *state = x.t;
    }

    std::shared_ptr<const Interpretation> of_;
    std::unique_ptr<InterpretedStep> step_;
    std::int64_t steps_ = 0, iterations_ = 0;
};

}  // namespace

namespace {

std::string obstacle_of(const ExplicitStep&) { return {}; }
std::string obstacle_of(const FlowStep&) { return "flows of parts are to come"; }
std::string obstacle_of(const TabulatedStep&) { return "steps of a linear map are to come"; }
std::string obstacle_of(const PairStep&) { return {}; }
std::string obstacle_of(const VelocityStep&) { return {}; }
std::string obstacle_of(const GalerkinStep&) { return "the general Galerkin form is to come"; }
std::string obstacle_of(const ChartStep&) { return "rotations are to come"; }

std::string obstacle_of(const Step& step) {
    if (step.from_parameter) return "methods with a free parameter are to come";
    if (step.layout != Layout::one) return "it takes no stages side by side";
    if (!step.in_a_row.empty()) return "compositions of steps that are solved for are to come";
    const Iteration* iteration = step.iteration();
    if (iteration != nullptr && iteration->solver != Solver::automatic && !iteration->only_sweeps())
        return "Newton's method is to come";
    return std::visit([](const auto& form) { return obstacle_of(form); }, step.form);
}

}  // namespace

std::string obstacle_to_interpretation(const SceneStepper& stepper) {
    const System& system = stepper.system;
    if (!stepper.own_headers.empty()) return "only a compiler knows functions of your own";
    if (!system.is_written_out()) return "its sums are loops";
    if (rotations_of(system) > 0) return "rotations are to come";
    if (system.side == Side::lagrangian || system.is_transformed) return "Lagrangians are to come";
    return obstacle_of(stepper.step);
}

StepperFamily interpretations(const SceneStepper& stepper) {
    HVI_CHECK(obstacle_to_interpretation(stepper).empty());
    const DrivenSystem driven = driven_system(stepper.system);
    const auto of = std::make_shared<const Interpretation>(
        Interpretation{stepper.step, SystemProgram(driven.system, stepper.members, stepper.step,
                                                   *stepper.evaluations)});
    return [of](std::vector<double> numbers) {
        return [of, numbers = std::move(numbers)] {
            return std::make_unique<InterpretedStepper>(of, numbers);
        };
    };
}

}  // namespace hvi::gen
