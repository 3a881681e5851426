// Headers of steppers that carry directions along.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/steps/emit.hpp"

namespace hvi::gen {

/// A step that is planned, and the options of its header.
struct StepToEmit {
    const OneStepMethod& method;
    const Step& step;
    EmitOptions options;
};

/// How covectors are pulled back; see hvi::PullBack.
enum class PulledBack {
    step_back,  ///< the method is its own adjoint
    columns,
};

/// The header of the class that `stepper` names, whose steps carry directions themselves.
/// Precondition: they are Carries::directions.
[[nodiscard]] std::string emit_with_directions(const StepToEmit& stepper, PulledBack pulled_back);

/// The header of the class that `stepper` names, made of its own and of one for the motion together
/// with a direction. Precondition: `carrier` is of with_tangent() of the system of `stepper`.
[[nodiscard]] std::string emit_with_directions_apart(const StepToEmit& stepper,
                                                     const StepToEmit& carrier,
                                                     PulledBack pulled_back);

}  // namespace hvi::gen
