// A step that is computed as its header says, without a compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <hvi/state.hpp>

#include "generator/interpret/system_program.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Positions, momenta and the time, which stays 0 where H does not depend on it.
struct InterpretedState : hvi::State<std::vector<double>> {
    double t = 0;
};

/// A step, and its memory from one step to the next.
class InterpretedStep {
public:
    InterpretedStep() = default;
    virtual ~InterpretedStep() = default;
    InterpretedStep(const InterpretedStep&) = delete;
    InterpretedStep& operator=(const InterpretedStep&) = delete;

    /// Advances x by a step of size h. Unless the status is ok, x has kept its bits. Precondition:
    /// vectors have the size of the system.
    [[nodiscard]] virtual Status take(InterpretedState& x, double h) = 0;

    /// Forgets the memory of steps.
    virtual void reset() = 0;

    [[nodiscard]] virtual const InterpretedSystem& system() const = 0;
};

/// Returns the kicks and drifts of a step that solves nothing. Precondition: its form is an
/// ExplicitStep, of a method without a free parameter.
[[nodiscard]] std::unique_ptr<InterpretedStep> explicit_step(const Step& step,
                                                             InterpretedSystem system);

/// Returns a step that solves for positions of stages, without their momenta. Preconditions: the
/// form is a VelocityStep without lanes, of a single step, whose solver needs no derivatives; the
/// step lives longer.
[[nodiscard]] std::unique_ptr<InterpretedStep> velocity_step(const Step& step,
                                                             InterpretedSystem system);

/// Returns a step with stages of positions and momenta. Preconditions: those of velocity_step(),
/// for a PairStep.
[[nodiscard]] std::unique_ptr<InterpretedStep> pair_step(const Step& step,
                                                         InterpretedSystem system);

}  // namespace hvi::gen
