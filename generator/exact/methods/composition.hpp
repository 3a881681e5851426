// Compositions: methods of higher order, made of steps of a method of lower order in a row.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Steps of size gamma_1 h, gamma_2 h, ..., gamma_k h, where gamma_k+1-i = gamma_i and their sum is
/// 1 (Hairer, Lubich & Wanner, Geometric Numerical Integration, Sections II.4 and V.3).
struct Composition {
    std::string name;  ///< `yoshida:6`
    int order;         ///< order of the composition for a method of lower order
    /// Whether every second step is one of the adjoint. Then the method need not be its own
    /// adjoint.
    bool with_adjoint;
    NumberVector steps;  ///< gamma_1, ..., gamma_k: decimals of 50 digits and more
    Place place;         ///< place of the name, for errors
};

[[nodiscard]] std::vector<std::string_view> composition_names();

/// Returns `stormer-verlet-yoshida:6`; for a method without a name the name of the composition.
[[nodiscard]] std::string composed_name(const std::string& method,
                                        const std::optional<Composition>& composition);

/// Throws MathError where the method would have to be its own adjoint, and InputError where it has
/// a free parameter, or too many stages to plan all steps as one.
void check_composition(const Composition& composition, const DerivedMethod& method);

/// Returns a composition by its name. Throws InputError, with a name that may have been meant.
[[nodiscard]] Composition named_composition(const std::shared_ptr<const Source>& name);

}  // namespace hvi::gen
