// The functions that an expression may call.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace hvi::gen {

/// Where a function of one argument has a real value.
enum class RealDomain { everywhere, positive, not_negative, up_to_one, within_one, from_one };

/// Where in the complex plane it is not analytic, poles apart.
enum class Cuts { nowhere, not_positive, real_up_to_one, real_beyond_one, imaginary_beyond_one };

enum class Parity { neither, even, odd };

/// A function by its name in texts; see functions.def.
struct Function {
    std::string_view name;
    std::size_t arguments;
    std::string_view latex;
    RealDomain domain = RealDomain::everywhere;
    Cuts cuts = Cuts::nowhere;
    Parity parity = Parity::neither;
    std::string_view derivative = "";  ///< of x and of the value y; empty for those of lists
};

/// All functions, the common ones first: the order in which messages list them.
[[nodiscard]] std::span<const Function> functions();

/// Whether a function, `roots` or `bspline`, is for the lists of a method alone.
[[nodiscard]] bool is_of_lists(std::string_view name);

/// The function of that name, or null.
[[nodiscard]] const Function* find_function(std::string_view name);

}  // namespace hvi::gen
