// Where the tests find this checkout, and what is built of it. NOTE: functions, which a file of
// their own defines, so that no other object file differs from one checkout to the next.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::test {

/// The path of a file of the checkout: `tests/generator/exact/reference.json`.
[[nodiscard]] std::string in_checkout(const std::string& file);

/// The path of the program hvi-gen.
[[nodiscard]] std::string hvi_gen_program();

}  // namespace hvi::test
