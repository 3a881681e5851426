// What the text of a module says of its stepper, whoever drives it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/text/text.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A parameter of a module in the three places where its text has it.
struct ModuleParameter {
    std::string reading;      ///< the statement that gives it a value
    std::string name;         ///< and its ranges, as an initialiser
    std::string description;  ///< with its default
};

/// Parameters in their order: sizes, numbers, lists.
[[nodiscard]] std::vector<ModuleParameter> module_parameters(const System& system);

/// The double that is nearest to a number. Precondition: it has one, as numbers in headers have.
[[nodiscard]] double value_of_number(const Expression& number);

/// Values of sizes, then of parameters, in their order.
[[nodiscard]] std::vector<double> values_of_numbers(const System& system);

/// Whether a module of the system takes sizes.
[[nodiscard]] bool has_sizes(const System& system);

/// `{"q", {{1, parameters.N}}},`
[[nodiscard]] std::string named_numbers(const SystemFamily& family);

/// `m[1..N]`
[[nodiscard]] std::string with_ranges(const SystemFamily& family);

/// A header as a part of another file, which is not included. Precondition: it includes itself
/// once.
[[nodiscard]] std::string without_once(const std::string& header);

/// The holes of a template for its stepper; `text` is that of its class.
[[nodiscard]] Holes stepper_holes(const System& system, const std::string& class_name,
                                  const std::string& text);

}  // namespace hvi::gen
