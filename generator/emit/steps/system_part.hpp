// Parts of a header that depend on the origin of H: a class of the user, or a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

/// Pieces of text; see the templates of headers.
struct SystemPart {
    std::string include;     ///< headers of the standard library
    std::string purpose;     ///< doc comment of the class
    std::string head;        ///< `template <...>`
    std::string class_name;  ///< name of the template
    std::string condition;   ///< a static_assert
    std::string types;       ///< public types up to Vector and Scalar, and the scene's System
    std::string state;       ///< type of the state
    std::string construct;   ///< constructors, and members that not every stepper has
    std::string alias;       ///< text after the class; may be empty
};

/// Texts for the numbers of bodies, which stand in a row in a step and in members of a state x.
namespace numbers_of_bodies {
inline constexpr std::string_view type = "hvi::detail::ChartState<Space>";
inline constexpr std::string_view taken = "hvi::detail::ChartState<Space> at = flat(x);";
inline constexpr std::string_view name = "at";
inline constexpr std::string_view put_back = "set(x, at);";
}  // namespace numbers_of_bodies

[[nodiscard]] SystemPart system_part(const OneStepMethod& method, const Step& step,
                                     const EmitOptions& options);

/// Returns the lines that include headers with functions of the user's own.
[[nodiscard]] std::string own_includes(const std::vector<std::string>& headers);

/// Returns the holes of the templates of headers, which have the names of these pieces, except for
/// `state`; the hole for `class_name` is `name`.
[[nodiscard]] Holes holes_of(const SystemPart& part);

}  // namespace hvi::gen
