// Names of classes and files.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// `gauss:2` -> `Gauss2`, `stormer-verlet` -> `StormerVerlet`; `Stepper` for a method without name.
/// What check_class_name() refuses ends in `Stepper`: `system` -> `SystemStepper`.
[[nodiscard]] std::string class_name(std::string_view method);

/// `gauss:2` -> `gauss_2.hpp`, `stormer-verlet` -> `stormer_verlet.hpp`, `stepper.hpp`.
[[nodiscard]] std::string file_name(std::string_view method);

/// `fpu-chain` -> `fpu_chain`: what functions and files of the C module of a scene begin with.
[[nodiscard]] std::string module_name(std::string_view scene);

/// Throws InputError, pointing at `place`, unless `name` may begin the names of functions of C: an
/// identifier, not reserved, and neither a header of C nor what its own functions begin with.
void check_module_name(std::string_view name, const std::optional<Place>& place);

/// Throws InputError, pointing at `place`, unless `name` may be the name of a class in C++: an
/// identifier, no keyword, not reserved, no macro, and none of the names that the header itself
/// uses.
void check_class_name(std::string_view name, const std::optional<Place>& place);

/// Throws InputError, pointing at `place`, unless member_name() of `name` may be a function that a
/// stepper has besides its own. Tables and variables in functions of the header give way to it; see
/// with_other_tables().
void check_function_name(std::string_view name, const std::optional<Place>& place);

/// The text of a header in which tables of ours that are called as a function of the user, which
/// has this name, are called otherwise: `b` as a table is `b_`, and `b(x)` stays.
[[nodiscard]] std::string with_other_tables(const std::string& text, std::string_view name);

/// Throws InputError, pointing at `place`, unless `name` may be the name of a function of the
/// user's own, outside of namespaces: no keyword, not reserved, and no macro such as errno. NOTE:
/// of names in capitals their header has to know: LJ is a good name.
void check_own_function_name(std::string_view name, const std::optional<Place>& place);

/// `mu` -> `mu`, `class` -> `class_`, `GM` -> `GM_`: a name of the user as that of a member of a
/// struct.
[[nodiscard]] std::string member_name(std::string_view name);

}  // namespace hvi::gen
