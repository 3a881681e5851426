// The user's own functions in a scene, which a header of the user defines.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expr/own_functions.hpp"

namespace hvi::gen {

/// A function declared in [functions]. Its header defines the templates V(x), V_1(x) and V_11(x)
/// for one type of numbers: the function and its derivatives.
struct OwnFunction {
    std::string name;
    std::size_t arguments = 1;
    std::string header;  ///< its path from the scene
    Place place;         ///< the place of the name
};

/// A file that a program with the user's functions needs.
struct OwnHeader {
    std::string path;  ///< the path from the scene, as in `#include "..."`
    std::string text;
};

struct OwnFunctions {
    std::vector<OwnFunction> functions;  ///< in the order of the file
    std::vector<OwnHeader> headers;  ///< headers of the functions, and the files that they include

    /// Returns the functions that an expression may call.
    [[nodiscard]] OwnArguments arguments() const;
    /// Returns the headers of the functions, each once.
    [[nodiscard]] std::vector<std::string> includes() const;
};

constexpr std::size_t most_own_arguments = 4;

/// Throws InputError at `place` for a name that no function can have: a reserved one, and one that
/// looks like a derivative, V_1.
void check_own_name(const std::string& name, const Place& place);

/// Throws InputError at `place` for anything but a path below the scene of letters, digits and
/// `_-+.`.
void check_own_header(const std::string& path, const Place& place);

/// Adds the header with this path, and the existing files that it includes by name. Throws
/// InputError at `place` where the header does not exist, where a file is larger than 1 MiB, and
/// for more than 64 files.
void add_own_header(OwnFunctions& own, const std::filesystem::path& directory,
                    const std::string& path, const Place& place);

/// Throws InputError where `name` is that of a function, or of a derivative of one.
void check_apart(const OwnFunctions& own, std::string_view name, const Place& place);

/// Throws InputError for a call of an own function. `subject` is the expression's name in messages.
void refuse_own_functions(const Expression& expression, const std::shared_ptr<const Source>& source,
                          std::string_view subject);

}  // namespace hvi::gen
