// The flow of a function of the variables.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/ir/part.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

/// A flow, in words and as changes of variables, by their order.
struct Flow {
    std::string kind;
    std::vector<Moved> moved;
    std::optional<UsualFlow> usual = {};
    std::vector<RuntimeValues> in_each_flow = {};
    std::vector<FormMoved> forms = {};
};

/// Returns the operations of a flow, but for those of compensated sums.
[[nodiscard]] OperationCounts counts_of_flow(const Graph& graph, const HamiltonianPart& part);

/// Returns how many numbers a flow moves.
[[nodiscard]] std::size_t numbers_moved(const HamiltonianPart& part);

}  // namespace hvi::gen
