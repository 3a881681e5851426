// An exact method that takes a step: a step is planned from it, and a header is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/methods/composition.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// A tableau or a Galerkin rule, or a composition: several steps of it in a row.
struct OneStepMethod {
    DerivedMethod base;
    std::optional<Composition> composition = {};
    std::optional<Place> place = {};  ///< its place in a text, for errors

    [[nodiscard]] const Provenance& provenance() const {
        return std::visit([](const auto& method) -> const Provenance& { return method.provenance; },
                          base);
    }
    /// Returns `stormer-verlet-yoshida:6`; empty where the method has no name.
    [[nodiscard]] std::string name() const { return composed_name(provenance().name, composition); }
    /// Returns the name, or METHOD.
    [[nodiscard]] std::string title() const {
        return name().empty() ? provenance().origin : name();
    }
};

/// Returns stable text, for people and tests: the steps of a composition, and all numbers.
[[nodiscard]] std::string dump(const OneStepMethod& method);

/// Stops the program (HVI_CHECK) where the record contradicts itself: tables that do not fit, steps
/// of a composition that are no palindrome or whose sum is not 1.
void verify(const OneStepMethod& method);

/// Returns whether the texts are equal.
[[nodiscard]] bool operator==(const OneStepMethod& left, const OneStepMethod& right);

}  // namespace hvi::gen
