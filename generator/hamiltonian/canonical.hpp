// Decides whether a motion with a jump is symplectic.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/hamiltonian/zero.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// The result for a jump (q, p) -> (Q, P) where g(q, p, t) = 0. The motion with the jump is
/// symplectic if it keeps the form dp^dq - dH^dt on the surface:
///
///     (dP^dQ - dp^dq - d(H(Q, P, t) - H)^dt) ^ dg = 0 where g = 0.
///
/// This holds for a ball that a wall reflects, though (q, p) -> (q, -p) alone is not symplectic.
struct CanonicalFinding {
    Vanishing holds = Vanishing::proved;
    std::string fault = {};  ///< the condition that fails, or is not seen to hold
};

/// Decides it for the values of the parameters. Throws as Algebra does. Precondition: H has no
/// rotations.
[[nodiscard]] CanonicalFinding canonical(const Hamiltonian& hamiltonian,
                                         const std::vector<Parameter>& parameters,
                                         const SceneEvent& event);

}  // namespace hvi::gen
