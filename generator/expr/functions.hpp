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

/// The header of src/hvi/detail/numbers that has a function.
enum class Runtime { math, more_math };

/// What a function is besides its value.
enum class Nature {
    analytic,
    kink,    ///< of one argument, not smooth at 0
    choice,  ///< of two of its arguments, not smooth where they change places
    list     ///< for the lists of a method alone: roots and bspline
};

/// A function by its name in texts; see functions.def. A choice `if(a < b, x, y)` is the function
/// `if<` of a, b, x and y; one between a <= b and b < a is `if<=`.
struct Function {
    std::string_view name;
    std::size_t arguments;
    std::string_view latex;
    Nature nature = Nature::analytic;
    RealDomain domain = RealDomain::everywhere;
    Cuts cuts = Cuts::nowhere;
    Parity parity = Parity::neither;
    Runtime runtime = Runtime::more_math;
    /// Of x and of the value y, or of a and b; of a choice what it chooses.
    std::string_view derivative = "";
    std::string_view by_second = "";  ///< the derivative by b, of a function of two

    [[nodiscard]] bool is_smooth() const {
        return nature != Nature::kink && nature != Nature::choice;
    }
};

/// Whether the name is `if<` or `if<=`.
[[nodiscard]] bool is_if(std::string_view name);

/// All functions, the common ones first: the order in which messages list them.
[[nodiscard]] std::span<const Function> functions();

/// Whether a function, `roots` or `bspline`, is for the lists of a method alone.
[[nodiscard]] bool is_of_lists(std::string_view name);

/// Whether the word is that of a function in texts: a name of them, or `if`.
[[nodiscard]] bool is_function(std::string_view word);

/// Whether a function of expressions chooses from its arguments; none of the user's own does.
[[nodiscard]] bool is_choice(std::string_view name);

/// Whether a function has neither a kink nor a jump, nor chooses; those of the user's own are taken
/// for smooth.
[[nodiscard]] bool is_smooth(std::string_view name);

/// The function of that name, or null.
[[nodiscard]] const Function* find_function(std::string_view name);

}  // namespace hvi::gen
