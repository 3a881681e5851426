// Starting values as parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A system that begins at parameters of its own, which are the last ones, and their correctly
/// rounded values.
struct StartParameters {
    System system;
    std::vector<double> values;
};

/// Makes parameters of the starting values that depend on parameters only. Makes none where one of
/// their values cannot be computed here, or where there are thousands. NOTE: only a compiler knows
/// values of the user's own functions, and thousands are too many words for a command line.
[[nodiscard]] StartParameters with_start_parameters(System system);

/// A starting value that depends on parameters only.
struct StartValue {
    std::string variable;  ///< begins there; empty where sums stay loops
    Scaled value;

    /// Returns the double nearest to the value; empty where it has none, or where it cannot be
    /// computed here. Parameters have no symbols but pi and e.
    [[nodiscard]] std::optional<double>
    number(const Graph& graph, const std::map<std::string, Expression>& parameters) const;
};

/// Returns the values of which with_start_parameters() makes parameters, in its order.
[[nodiscard]] std::vector<StartValue> start_values(const System& system);

/// Returns the derivative of the initial values of (q, p) by a parameter; empty where one of them
/// is not known here. Preconditions: those of with_sensitivity().
[[nodiscard]] std::optional<std::vector<double>> start_by_parameter(const System& system,
                                                                    const std::string& parameter);

}  // namespace hvi::gen
