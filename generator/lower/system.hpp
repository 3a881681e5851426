// A Hamiltonian system as one graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/lower/graph.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// H(q, p), its variables, and the right sides of Hamilton's equations up to the sign. What they
/// have in common is one node.
struct SystemGraph {
    Graph graph;
    Symbols symbols;           ///< of variables and parameters, for more expressions of them
    std::optional<Node> time;  ///< the input t, where H depends on it
    std::vector<Node> q, p;    ///< inputs, in the order of the Hamiltonian's names
    Scaled hamiltonian;
    std::vector<Scaled> dHdq, dHdp;

    [[nodiscard]] std::size_t degrees_of_freedom() const { return q.size(); }
};

/// A parameter that has a value is replaced by it; `parameters` are the inputs among the others.
/// Throws InputError as lower() does. Preconditions: those of lower().
[[nodiscard]] SystemGraph system_graph(const Hamiltonian& hamiltonian,
                                       const std::vector<std::string>& parameters);

}  // namespace hvi::gen
