// Bodies that attract each other in pairs, found in H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A pair of bodies that attract each other: -k d, where d is one over their distance.
struct AttractingPair {
    std::size_t first = 0, second = 0;
    Scaled strength;         ///< k
    Node inverse = 0;        ///< 1/|q - q'| in H
    bool is_linear = false;  ///< whether H is linear in d
};

/// Bodies of H = p^T K p/2 + U(q), where K has one number for each body.
struct AttractingBodies {
    std::vector<std::vector<std::size_t>> coordinates;  ///< of each body, axis by axis
    std::vector<Scaled> inverse_masses;
    std::vector<AttractingPair> pairs;
};

/// Returns the bodies of H = p^T K p/2 + U(q), in the order of their coordinates. Throws MathError
/// at `place`, that of H, where a coordinate has no mass of its own, or is of no body that is
/// attracted. Preconditions: the system is written out, and a Hamiltonian.
[[nodiscard]] AttractingBodies attracting_bodies(System& system, const Place& place);

}  // namespace hvi::gen
