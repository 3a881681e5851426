// H as a sum of parts whose flows are known.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns the name of a part that is found: A, B, ..., Z, then P27, P28, ...
[[nodiscard]] std::string name_of_part(std::size_t k);

/// The ways in which terms of H become parts.
enum class FoundParts {
    by_terms,           ///< each in the first part that still has a known flow with it
    without_matrices,   ///< as by terms, but none becomes part of a form that is moved by a matrix
    kinetic_potential,  ///< T(p), then U(q)
};

/// Lets the time go on with the first part that does not depend on it. Where all parts do, a last
/// one is added that moves the time alone. NOTE: in the extended system the time is a coordinate,
/// and H + E the Hamiltonian, where E is the momentum of the time. So E is a term of one part, and
/// the flows of the others leave the time where it is.
void set_clock(const Graph& graph, HamiltonianParts& parts);

/// Returns the system with the parts that its scene names, or else with parts that are found
/// among the terms of H, in their order. Throws
/// InputError for parts whose sum is not H, with the difference, and MathError for a part whose
/// flow is not known. Preconditions: the system is that of the scene, which is written out, a
/// Hamiltonian, and not in scaled time; H = T(p) + U(q) if these are to be found.
[[nodiscard]] System with_parts(System system, const WrittenOutScene& scene,
                                FoundParts found = FoundParts::by_terms);

}  // namespace hvi::gen
