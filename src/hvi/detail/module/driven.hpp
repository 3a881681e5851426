// A module that hvi-gen compiles and drives itself: as little as its steps need.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include <hvi/detail/module/answered.hpp>
#include <hvi/detail/module/carried.hpp>
#include <hvi/detail/module/driven_functions.hpp>
#include <hvi/detail/module/instance.hpp>

namespace hvi::detail {

/// An instance whose steps may carry directions along. Those of dual numbers do by another
/// specialisation: <driver/carried_in_duals.hpp>.
template <class Problem, class = void>
class DrivenInstance : public Instance<Problem> {
public:
    static constexpr bool carries_directions = false;
    using Instance<Problem>::Instance;
};

template <class Problem>
class DrivenInstance<Problem, std::enable_if_t<CarriesDirections<typename Problem::Stepper>::value>>
    : public Instance<Problem> {
public:
    static constexpr bool carries_directions = true;
    using Scalar = typename Problem::Stepper::Scalar;
    using Instance<Problem>::Instance;

    /// See CarriedNumbers.
    Run carry(double* directions, std::size_t count, double h) {
        return this->step_by([&](auto& stepper, auto& x) {
            return carried_.step(stepper, x, directions, count, static_cast<Scalar>(h));
        });
    }

    void reset() {
        Instance<Problem>::reset();
        carried_.forget();
    }

private:
    CarriedNumbers<typename Problem::Stepper> carried_;
};

/// Functions of a driven module. `Problem` is as in instance.hpp.
template <class Problem>
class Driven {
public:
    [[nodiscard]] static constexpr DrivenFunctions functions() {
        return {driven_version, take_solvers, create,     destroy, sizes,  counts,    begin,
                take,           follow,       carry_of(), reset,   energy, invariants};
    }

private:
    using Of = DrivenInstance<Problem>;
    using Carry = int (*)(void*, double*, double*, std::size_t, double);

    static const Of& of(const void* instance) { return *static_cast<const Of*>(instance); }

    static void take_solvers(FindSolver find) { LoadedSolvers<>::find = find; }

    static DrivenAnswer create(const char* directory, unsigned threads, const double* values,
                               std::size_t count, void** made, char* message, std::size_t room) {
        const auto make = [&] {
            *made = new Of(with_numbers<Problem>(Problem::parameters(directory), values, count),
                           threads);
        };
        return answered(make, message, room);
    }

    static void destroy(void* instance) { delete static_cast<Of*>(instance); }

    static DrivenSizes sizes(const void* instance) {
        return {of(instance).coordinates(), of(instance).momenta(), Of::has_time,
                Problem::invariant_count};
    }

    static DrivenCounts counts(const void* instance) {
        return {of(instance).steps(), of(instance).iterations(),
                static_cast<std::int64_t>(of(instance).stepper().evaluations())};
    }

    static void begin(const void* instance, double* state) { of(instance).begin(state); }

    static int take(void* instance, double* state, double h, std::int64_t steps) {
        return advance(instance, state, [&](Of& stepper) { return stepper.take(h, steps); });
    }

    static int follow(void* instance, double* state, double h, std::int64_t steps,
                      Departure* departures) {
        return advance(instance, state, [&](Of& stepper) {
            Run run;
            for (std::int64_t k = 0; k < steps && run.ok(); ++k) {
                run = stepper.take_one(h);
                if (run.ok()) { see(stepper, departures); }
            }
            return run;
        });
    }

    static constexpr Carry carry_of() {
        if constexpr (Of::carries_directions) {
            return carry;
        } else {
            return nullptr;
        }
    }

    static int carry(void* instance, double* state, double* directions, std::size_t count,
                     double h) {
        return advance(instance, state,
                       [&](Of& stepper) { return stepper.carry(directions, count, h); });
    }

    static void reset(void* instance) { static_cast<Of*>(instance)->reset(); }

    /// Takes the steps of f(stepper) from `state`: the code of its status.
    template <class F>
    static int advance(void* instance, double* state, F&& f) {
        Of& stepper = *static_cast<Of*>(instance);
        try {
            stepper.read(state);
            const Run run = f(stepper);
            stepper.write(state);
            return static_cast<int>(run.status.code());
        } catch (const std::bad_alloc&) {
            return driven_out_of_memory;
        } catch (const SolverIsApart&) { return driven_solver_is_apart; }
    }

    static void see(const Of& at, Departure* departures) {
        if constexpr (!Of::has_time) {
            departures++->see(static_cast<double>(at.stepper().energy(at.state())));
        }
        if constexpr (Problem::invariant_count > 0) {
            double values[Problem::invariant_count];
            Problem::values(at.stepper(), at.state(), values);
            for (const double value : values) { departures++->see(value); }
        }
    }

    static double energy(const void* instance, const double* state) {
        return of(instance).at(state, [](const auto& stepper, const auto& x) {
            return static_cast<double>(stepper.energy(x));
        });
    }

    static void invariants(const void* instance, const double* state, double* values) {
        of(instance).at(state, [&](const auto& stepper, const auto& x) {
            Problem::values(stepper, x, values);
        });
    }
};

}  // namespace hvi::detail
