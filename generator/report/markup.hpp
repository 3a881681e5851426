// Texts and pictures as parts of a page.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::gen {

/// A text in HTML.
[[nodiscard]] std::string escaped(const std::string& text);

/// An SVG from its first element on: what stands before belongs to a file of its own.
[[nodiscard]] std::string inlined(const std::string& svg);

}  // namespace hvi::gen
