// Changes of variables that make up a flow.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/lower/flow.hpp"

namespace hvi::gen {

/// Changes under a flow over a time, in the order in which they are found.
class FlowChanges {
public:
    FlowChanges(Graph& graph, Node duration) : graph_(graph), tau_{{1, 1}, duration} {}

    [[nodiscard]] Graph& graph() const { return graph_; }
    [[nodiscard]] const Scaled& time() const { return tau_; }

    /// Returns a value times the time. NOTE: factors that do not vary, numbers among them, go with
    /// the time, and are one value that is computed when that changes.
    [[nodiscard]] Scaled over_time(const Scaled& value) const;

    /// Adds the change of a variable; one that is 0 is left out.
    void add(bool is_conjugate, std::size_t component, const Scaled& change);
    void add(RuntimeValues values) { in_each_flow_.push_back(std::move(values)); }
    void add(FormMoved form) { forms_.push_back(std::move(form)); }

    /// Returns the flow, with the changes by the order of the variables.
    [[nodiscard]] Flow flow(std::string kind) &&;

private:
    Graph& graph_;
    Scaled tau_;
    std::vector<Moved> moved_;
    std::vector<RuntimeValues> in_each_flow_;
    std::vector<FormMoved> forms_;
};

}  // namespace hvi::gen
