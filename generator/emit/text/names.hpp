// Names of classes and files.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// Returns `Gauss2` for `gauss:2`, `StormerVerlet` for `stormer-verlet`, and `Stepper` for a method
/// without name. Names that check_class_name() refuses get the ending `Stepper`: `SystemStepper`
/// for `system`.
[[nodiscard]] std::string class_name(std::string_view method);

/// Returns `gauss_2.hpp` for `gauss:2`, `stormer_verlet.hpp` for `stormer-verlet`, and
/// `stepper.hpp` for a method without name.
[[nodiscard]] std::string file_name(std::string_view method);

/// Returns `fpu_chain` for `fpu-chain`: the prefix of functions and files of the C module of a
/// scene.
[[nodiscard]] std::string module_name(std::string_view scene);

/// Throws InputError, pointing at `place`, unless `name` may begin the names of functions of C: an
/// identifier, not reserved, and neither a header of C nor a prefix of C's own functions.
void check_module_name(std::string_view name, const std::optional<Place>& place);

/// Throws InputError, pointing at `place`, unless `name` may be the name of a class in C++: an
/// identifier, no keyword, not reserved, no macro, and none of the names that the header itself
/// uses.
void check_class_name(std::string_view name, const std::optional<Place>& place);

/// Throws InputError, pointing at `place`, unless member_name() of `name` may be a function that a
/// stepper has besides its own. Tables and variables in functions of the header give way to it; see
/// with_other_tables().
void check_function_name(std::string_view name, const std::optional<Place>& place);

/// Returns the text of a header in which a table with the name of a user's function gets another
/// name: the table `b` becomes `b_`, and the function `b(x)` stays.
[[nodiscard]] std::string with_other_tables(const std::string& text, std::string_view name);

/// Throws InputError, pointing at `place`, unless `name` may be the name of a function of the
/// user's own, outside of namespaces: no keyword, not reserved, and no macro such as errno. NOTE:
/// names in capitals are allowed, as LJ is a good name; the user's header has to know its macros.
void check_own_function_name(std::string_view name, const std::optional<Place>& place);

/// Returns a name of the user as the name of a struct's member: `mu` for `mu`, `class_` for
/// `class`, `GM_` for `GM`.
[[nodiscard]] std::string member_name(std::string_view name);

}  // namespace hvi::gen
