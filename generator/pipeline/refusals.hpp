// Refusals of wishes that are not built, with a reason and what would help.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"
#include "generator/options/wishes.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// Returns the first wish that loops do not have, as its option, `--dense`; or nothing.
[[nodiscard]] std::string wish_without_loops(const StepperWishes& wishes);

/// Throws InputError at `place`, that of H, for a wish that systems of any size do not have.
void check_wishes_of_any_size(const StepperWishes& wishes, const Place& place);

/// Throws NoLoops at `place`, that of H, where a step may need Newton's method and the system has
/// no second derivatives for it.
void check_newton(const System& system, const Step& step, const Place& place);

/// Returns the reason why no sweeps are counted in a step; empty where they can be.
[[nodiscard]] std::string obstacle_to_sweeps(const Step& step);

/// Throws InputError where --lanes gpu is wished for and the system calls a function that no device
/// has. Precondition: the system is written out.
void check_functions_on_device(const System& system, const StepperWishes& wishes);

/// Throws InputError, or MathError for a Lagrangian, where steps of a splitting cannot be flows of
/// parts of H; NoLoops where sums stay loops. `place`: that of H.
void check_splitting(const System& system, const Method& method, const StepperWishes& wishes,
                     const Place& place);

/// Throws InputError for a step that was planned otherwise than wished for, or that its container
/// does not have. `place` is that of H.
void check_step(const Step& step, const Method& method, const StepperWishes& wishes,
                const Place& place);

}  // namespace hvi::gen
