// A method, or a composition of it, by one name; and what is known of it beforehand.
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

    /// `gauss:4`, or METHOD where it has no name.
    [[nodiscard]] std::string name() const {
        return method.name.empty() ? method.origin : composed_name(method.name, composition);
    }
    /// How many steps of the method make a step.
    [[nodiscard]] std::size_t parts() const { return composition ? composition->steps.size() : 1; }
};

/// By its name: `gauss:4`, or `stormer-verlet-yoshida:6`. Throws what named_method() and
/// named_composition() do.
[[nodiscard]] ComposedMethod composed_method(const std::shared_ptr<const Source>& name);

/// A method, or a composition of it, whose coefficients are derived.
struct ExactMethod : ComposedMethod {
    DerivedMethod base;
};

/// Throws what derive_any() and check_composition() do.
[[nodiscard]] ExactMethod exact_method(ComposedMethod method);

/// The order of a composition of a method of this one: at least that of both, and even, as what
/// compositions make is its own adjoint. That of the method where there is none.
[[nodiscard]] int composed_order(int of_method, const std::optional<Composition>& composition);

/// Whether a step with -h leads back, as for every composition.
[[nodiscard]] bool is_symmetric(const ExactMethod& method);

/// The stages of (4.18), with m_ij = a_ij / b_j.
struct WeightedStages {
    NumberMatrix m;
    NumberVector b;
};
[[nodiscard]] WeightedStages weighted_stages(const ButcherPair& pair);

/// Those of the steps in a row, as of one.
[[nodiscard]] WeightedStages composed(const WeightedStages& method, const Composition& composition);

[[nodiscard]] PartitionedMethod partitioned_method(const WeightedStages& stages);

}  // namespace hvi::gen
