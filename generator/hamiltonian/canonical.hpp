// Whether a motion with a jump is symplectic.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/hamiltonian/zero.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// What is known of a jump (q, p) -> (Q, P) where g(q, p, t) = 0. The motion with it is symplectic
/// where it keeps the form dp^dq - dH^dt on the surface:
///
///     (dP^dQ - dp^dq - d(H(Q, P, t) - H)^dt) ^ dg = 0 where g = 0.
///
/// So it is for a ball that a wall reflects, though (q, p) -> (q, -p) alone is not symplectic.
struct CanonicalFinding {
    Vanishing holds = Vanishing::proved;
    std::string fault = {};  ///< what it is not, or is not seen to be
};

/// For the values that parameters have. Throws as Algebra does. Precondition: H has no rotations.
[[nodiscard]] CanonicalFinding canonical(const Hamiltonian& hamiltonian,
                                         const std::vector<Parameter>& parameters,
                                         const SceneEvent& event);

}  // namespace hvi::gen
