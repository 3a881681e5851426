// An entry in JSON, which several schemas share.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

using Json = nlohmann::ordered_json;

/// Returns {"exact": ..., "decimal": ..., "double": ...}, each of them text or null.
[[nodiscard]] Json entry_json(const Number& number, int digits);

}  // namespace hvi::gen
