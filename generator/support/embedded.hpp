// Files that are part of the program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// A file as it stood when the program was built.
struct EmbeddedFile {
    std::string_view name;  ///< without its folders
    std::string_view text;
};

}  // namespace hvi::gen
