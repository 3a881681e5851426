// The knowledge about an expression that may be zero.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

enum class Vanishing { proved, refuted, unknown };

}  // namespace hvi::gen
