// The functions that an expression may call.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace hvi::gen {

/// A function by its name in texts, how many arguments it takes, and its name in LaTeX.
struct Function {
    std::string_view name;
    std::size_t arguments;
    std::string_view latex;
};

/// All functions, the common ones first: the order in which messages list them.
[[nodiscard]] std::span<const Function> functions();

/// Whether a function, `roots` or `bspline`, is for the lists of a method alone.
[[nodiscard]] bool is_of_lists(std::string_view name);

/// The function of that name, or null.
[[nodiscard]] const Function* find_function(std::string_view name);

}  // namespace hvi::gen
