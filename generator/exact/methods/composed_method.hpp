// A method, or a composition of it, by one name; and its known properties.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "generator/exact/methods/composition.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

struct ComposedMethod {
    Method method;
    std::optional<Composition> composition = {};

    /// Returns `gauss:4`, or METHOD where it has no name.
    [[nodiscard]] std::string name() const {
        return method.name.empty() ? method.origin : composed_name(method.name, composition);
    }
    /// Returns how many steps of the method make a step.
    [[nodiscard]] std::size_t parts() const { return composition ? composition->steps.size() : 1; }
};

/// Returns a method by its name: `gauss:4`, or `stormer-verlet-yoshida:6`. Throws as named_method()
/// and named_composition() do.
[[nodiscard]] ComposedMethod composed_method(const std::shared_ptr<const Source>& name);

/// A method, or a composition of it, whose coefficients are derived.
struct ExactMethod : ComposedMethod {
    DerivedMethod base;
};

/// Derives a method. Throws as derive_any() and check_composition() do.
[[nodiscard]] ExactMethod exact_method(ComposedMethod method);

/// Returns the order of a composition of a method of this order: at least the larger of both
/// orders, and even, as a composition is its own adjoint. Without a composition it is the order of
/// the method.
[[nodiscard]] int composed_order(int of_method, const std::optional<Composition>& composition);

/// Returns whether a step with -h leads back, as for every composition.
[[nodiscard]] bool is_symmetric(const ExactMethod& method);

/// Stages of (4.18), with m_ij = a_ij / b_j.
struct WeightedStages {
    NumberMatrix m;
    NumberVector b;
};
[[nodiscard]] WeightedStages weighted_stages(const ButcherPair& pair);

/// Returns the stages of the steps in a row, as of one step.
[[nodiscard]] WeightedStages composed(const WeightedStages& method, const Composition& composition);

[[nodiscard]] PartitionedMethod partitioned_method(const WeightedStages& stages);

}  // namespace hvi::gen
