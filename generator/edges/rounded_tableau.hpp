// A tableau whose entries are rounded one by one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

struct RoundedTableau {
    std::vector<double> words;   ///< words for src/driver/naive.hpp
    bool is_symplectic = false;  ///< b_i a~_ij + b_j a_ji = b_i b_j still holds exactly
};

[[nodiscard]] RoundedTableau rounded_entries(const ButcherPair& pair);

}  // namespace hvi::gen
