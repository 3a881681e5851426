// The examples in the docstrings of src/hvi, which tests/CMakeLists.txt makes a table of.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

namespace docstrings {

struct Example {
    const char* header;
    int (*main)();  ///< 0 where all is as the docstring says
};

/// Examples, one for each public header.
const std::vector<Example>& examples();

}  // namespace docstrings
