// The part of a module's text about its stepper, for all drivers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/text/text.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A parameter of a module, as text for three places.
struct ModuleParameter {
    std::string reading;      ///< the statement that gives it a value
    std::string name;         ///< its name and ranges, as an initialiser
    std::string description;  ///< its meaning and default
};

/// Returns the parameters in their order: sizes, numbers, lists.
[[nodiscard]] std::vector<ModuleParameter> module_parameters(const System& system);

/// Returns the double nearest to a number. Precondition: it has one, as numbers in headers have.
[[nodiscard]] double value_of_number(const Expression& number);

/// Returns the values of sizes, then of parameters, in their order.
[[nodiscard]] std::vector<double> values_of_numbers(const System& system);

/// Whether a module of the system takes sizes.
[[nodiscard]] bool has_sizes(const System& system);

/// Returns `{"q", {{1, parameters.N}}},`.
[[nodiscard]] std::string named_numbers(const SystemFamily& family);

/// Returns `m[1..N]`.
[[nodiscard]] std::string with_ranges(const SystemFamily& family);

/// Returns a header as a part of another file, which does not include it. Precondition: it includes
/// itself once.
[[nodiscard]] std::string without_once(const std::string& header);

/// Returns the holes of a template for its stepper; `text` is the text of its class.
[[nodiscard]] Holes stepper_holes(const System& system, const std::string& class_name,
                                  const std::string& text);

}  // namespace hvi::gen
