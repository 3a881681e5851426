// The two sides of mechanics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// The function that defines a system.
enum class Side {
    hamiltonian,  ///< H(q, p)
    lagrangian,   ///< L(q, v)
};

}  // namespace hvi::gen
