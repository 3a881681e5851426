// Relative motions of bodies that attract each other in pairs: Kepler orbits that do not couple.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "generator/ir/part.hpp"
#include "generator/lower/flow.hpp"

namespace hvi::gen {

/// Kind of their flow, in words.
inline constexpr const char* name_of_orbits = "Kepler orbits";

/// A linear form: factors of the coordinates, zeros included.
using LinearForm = std::vector<Scaled>;

/// A potential -k/|Q| of a vector Q, whose components are linear forms of the coordinates.
struct Attraction {
    std::vector<LinearForm> components;
    Scaled strength;  ///< k; negative where bodies repel
};

/// The function p^T K p/2 - sum_j k_j/|Q_j|, up to a constant. Rows of K are linear forms of the
/// momenta; matrix and factors do not vary.
struct OrbitForm {
    std::vector<LinearForm> kinetic;  ///< K, symmetric
    std::vector<Attraction> attractions;
};

/// Returns the nodes that are 1/sqrt(S), with S, of those that a function is computed from.
[[nodiscard]] std::map<Node, Scaled> inverse_roots(const Graph& graph, const Scaled& function);

/// Returns 1/|Q| where 1/sqrt(S) is that up to a factor, which is its strength.
[[nodiscard]] std::optional<Attraction> attraction_of(Graph& graph, const Scaled& square,
                                                      const std::vector<Node>& q);

/// Returns the function in this form where it is one, which is proved.
[[nodiscard]] std::optional<OrbitForm> orbit_form_of(Graph& graph, const Scaled& function,
                                                     const std::vector<Node>& q,
                                                     const std::vector<Node>& p);

/// Returns whether it is proved that the vectors Q_j do not couple: for their components l as rows,
/// l K l'^T = 0 for different ones, and the components of one vector have one value l K l^T,
/// which is not 0.
[[nodiscard]] bool are_apart(Graph& graph, const OrbitForm& form);

/// Returns the flow of a form: each Q_j moves on a Kepler orbit, Q_j'' = -mu Q_j/|Q_j|^3 with mu =
/// k_j l K l^T, and all else freely. Precondition: the vectors do not couple.
[[nodiscard]] Flow flow_of_orbits(Graph& graph, const OrbitForm& form, const std::vector<Node>& q,
                                  const std::vector<Node>& p, Node duration);

}  // namespace hvi::gen
