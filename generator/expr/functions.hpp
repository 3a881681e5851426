// The functions that an expression may call.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace hvi::gen {

/// The domain on which a function of one argument has a real value.
enum class RealDomain { everywhere, positive, not_negative, up_to_one, within_one, from_one };

/// The set in the complex plane where a function is not analytic, poles apart.
enum class Cuts { nowhere, not_positive, real_up_to_one, real_beyond_one, imaginary_beyond_one };

enum class Parity { neither, even, odd };

/// The header of src/hvi/detail/numbers that has a function.
enum class Runtime { math, more_math, small_turns };

/// Kinds of functions.
enum class Nature {
    analytic,
    kink,    ///< one argument, not smooth at 0
    choice,  ///< two of its arguments are compared; not smooth where they are equal
    list     ///< only in the lists of a method: roots and bspline
};

/// A function with its name in texts; see functions.def. A choice `if(a < b, x, y)` is the function
/// `if<` of a, b, x and y; one between a <= b and b < a is `if<=`. Shears of turns by an angle 2x
/// are `tan<` and `sin2<`, which are tan x and sin 2x for |x| <= 1/2.
struct Function {
    std::string_view name;
    std::size_t arguments;
    std::string_view latex;
    Nature nature = Nature::analytic;
    RealDomain domain = RealDomain::everywhere;
    Cuts cuts = Cuts::nowhere;
    Parity parity = Parity::neither;
    Runtime runtime = Runtime::more_math;
    /// The derivative in terms of x and the value y, or of a and b; the selection of a choice.
    std::string_view derivative = "";
    std::string_view by_second = "";  ///< the derivative by b of a function of two arguments

    [[nodiscard]] bool is_smooth() const {
        return nature != Nature::kink && nature != Nature::choice;
    }
};

/// Whether the name is `if<` or `if<=`.
[[nodiscard]] bool is_if(std::string_view name);

/// Whether no text can call a function by its name.
[[nodiscard]] bool is_hidden(std::string_view name);

/// Returns all functions, the common ones first: the order in which messages list them.
[[nodiscard]] std::span<const Function> functions();

/// Whether a function, `roots` or `bspline`, is for the lists of a method alone.
[[nodiscard]] bool is_of_lists(std::string_view name);

/// Whether the word names a function in texts: a function's name, or `if`.
[[nodiscard]] bool is_function(std::string_view word);

/// Whether a function chooses from its arguments; no function of the user's own does.
[[nodiscard]] bool is_choice(std::string_view name);

/// Whether a function has neither a kink nor a jump, nor chooses. Functions of the user's own are
/// assumed to be smooth.
[[nodiscard]] bool is_smooth(std::string_view name);

/// Returns the function with this name, or null.
[[nodiscard]] const Function* find_function(std::string_view name);

}  // namespace hvi::gen
