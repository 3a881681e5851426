// The parts of a header that a scene with loops decides: H and its derivatives for any sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/ir/loop_system.hpp"
#include "generator/ir/step.hpp"
#include "generator/lower/loop_hessian.hpp"
#include "generator/lower/site_force.hpp"

namespace hvi::gen {

/// A system with loops, its sites where it is a lattice, and what else a step needs of it.
struct LoopCode {
    const LoopSystem& system;
    const std::optional<SiteSystem>& sites;
    const std::optional<LoopHessian>& hessian;  ///< where Newton's method may be called for
    bool evaluations = false;                   ///< of dH/dq are counted

    /// Whether something is scattered: added where it belongs, one summand after the other.
    [[nodiscard]] bool scatters() const {
        return !sites || (hessian && !hessian->products.empty());
    }
};

/// `struct Parameters`, with sizes, numbers and tables of the scene as defaults.
[[nodiscard]] std::string loop_parameters_text(const LoopSystem& system);

/// `struct System`: what a stepper needs of H, with loops where the scene has sums.
[[nodiscard]] std::string loop_system_text(const LoopCode& code, const Step& step);

/// `static State initial(...)`, the energy and the invariants, as members of a stepper.
[[nodiscard]] std::string loop_members_text(const LoopCode& code);

}  // namespace hvi::gen
