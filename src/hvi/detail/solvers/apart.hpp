// Solvers in a library of their own, which is loaded when a step calls for them.
// SPDX-License-Identifier: MIT
//
// NOTE: compiling Newton's method takes longer than all the rest of a stepper, and most runs never
// call it. So hvi-gen compiles its modules in two parts: the steps, with Apart in place of a policy
// NAME, and, when the steps ask for them, the solvers, with Alone in place of
// hvi::AutomaticOfLanes<NAME>. Both parts are made of one text, so that types of the same names
// have the same layout.
#pragma once

#include <cstring>
#include <type_traits>
#include <typeinfo>
#include <utility>

#include <hvi/detail/module/loaded_solvers.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Type of a function that both parts know. Its name is that of this type.
template <class Newton, class Coupled>
struct NewtonCall {
    using Function = Status (*)(Newton&, Coupled&);
    static Status call(Newton& newton, Coupled& coupled) { return newton.solve(coupled); }
};
template <bool keeps_factors, class Sweeps, class Coupled, class Corrections>
struct CorrectionsCall {
    using Terms = typename Sweeps::Terms;
    using Function = Status (*)(Sweeps&, Coupled&, Corrections&, const Terms&);
    static Status call(Sweeps& sweeps, Coupled& coupled, Corrections& corrections,
                       const Terms& terms) {
        return sweeps.template solve<keeps_factors>(coupled, corrections, terms);
    }
};

// ---- the steps ----

/// Returns the function of the loaded library. Throws SolverIsApart where none is loaded.
template <class Call>
[[nodiscard]] typename Call::Function loaded() {
    const FindSolver find = LoadedSolvers<>::find;
    const AnyFunction function = find == nullptr ? nullptr : find(typeid(Call).name());
    if (function == nullptr) { throw SolverIsApart(); }
    return reinterpret_cast<typename Call::Function>(function);
}

/// The policy `Newton` as steps have it whose solvers are in a library of their own.
template <class Newton>
struct Apart {
    template <class Vector>
    class Iteration {
    public:
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled& coupled) {
            return loaded<NewtonCall<Of, Coupled>>()(newton_, coupled);
        }

    private:
        using Of = typename Newton::template Iteration<Vector>;
        Of newton_;
    };

    template <class Vector>
    class Corrected : public Newton::template Corrected<Vector> {
    public:
        template <bool keeps_factors, class Coupled, class Corrections>
        [[nodiscard]] Status
        solve(Coupled& coupled, Corrections& corrections,
              const typename Newton::template Corrected<Vector>::Terms& terms) {
            using Of = typename Newton::template Corrected<Vector>;
            Of& sweeps = *this;
            return loaded<CorrectionsCall<keeps_factors, Of, Coupled, Corrections>>()(
                sweeps, coupled, corrections, terms);
        }
    };
};

// ---- the solvers ----

/// A function that a library of solvers has. All are made before the library is loaded.
class KnownSolver {
public:
    KnownSolver(const char* name, AnyFunction function)
        : name_(name), function_(function), next_(first()) {
        first() = this;
    }

    [[nodiscard]] static AnyFunction find(const char* name) {
        for (const KnownSolver* solver = first(); solver != nullptr; solver = solver->next_) {
            if (std::strcmp(solver->name_, name) == 0) { return solver->function_; }
        }
        return nullptr;
    }

private:
    static const KnownSolver*& first() {
        static const KnownSolver* solver = nullptr;
        return solver;
    }

    const char* name_;
    AnyFunction function_;
    const KnownSolver* next_;
};

template <class Call>
struct Known {
    static const KnownSolver solver;
};
template <class Call>
const KnownSolver Known<Call>::solver(typeid(Call).name(),
                                      reinterpret_cast<AnyFunction>(&Call::call));

template <class Coupled, class = void>
struct HasCorrections : std::false_type {};
template <class Coupled>
struct HasCorrections<Coupled, std::void_t<decltype(std::declval<Coupled&>().corrections)>>
    : std::true_type {};

template <class Coupled, class = void>
struct HasLinearPart : std::false_type {};
template <class Coupled>
struct HasLinearPart<Coupled, std::void_t<decltype(std::declval<Coupled&>().linear)>>
    : std::true_type {};

/// A solver policy that solves nothing: it makes the library have the functions that Apart<Newton>
/// calls.
template <class Newton>
struct Alone {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    struct Iteration {
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled) {
            know<NewtonCall<typename Newton::template Iteration<Vector>, Coupled>>();
            if constexpr (HasCorrections<Coupled>::value) {
                using Corrections = std::decay_t<decltype(std::declval<Coupled&>().corrections)>;
                know<CorrectionsCall<true, typename Newton::template Corrected<Vector>, Coupled,
                                     Corrections>>();
            }
            if constexpr (HasLinearPart<Coupled>::value) {
                using Linear = std::decay_t<decltype(std::declval<Coupled&>().linear)>;
                know<CorrectionsCall<false, typename Newton::template Corrected<Vector>, Coupled,
                                     Linear>>();
            }
            return {};
        }

    private:
        template <class Call>
        static void know() {
            static_cast<void>(&Known<Call>::solver);
        }
    };
};

}  // namespace hvi::detail
