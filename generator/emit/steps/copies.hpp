// Headers of the runtime as part of a header that needs the standard library alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hvi::gen {

/// Returns the texts of headers of the runtime, by their paths in src/hvi without the ending. They
/// include nothing of hvi: what one needs comes before it. Examples for users are left out.
[[nodiscard]] std::string copies_of(const std::vector<std::string>& names);

}  // namespace hvi::gen
