// What of a header depends on where H comes from: a class of the user, or a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

/// Pieces of text; see the templates of headers.
struct SystemPart {
    std::string include;     ///< of the standard library
    std::string purpose;     ///< doc comment of the class
    std::string head;        ///< `template <...>`
    std::string class_name;  ///< of the template
    std::string condition;   ///< a static_assert
    std::string types;       ///< public ones up to Vector and Scalar, and the scene's System
    std::string state;       ///< type of the state
    std::string construct;   ///< constructors, and members that are not of every stepper
    std::string alias;       ///< what follows the class; may be empty
};

[[nodiscard]] SystemPart system_part(const OneStepMethod& method, const Step& step,
                                     const EmitOptions& options);

/// The lines that include headers with functions of the user's own.
[[nodiscard]] std::string own_includes(const std::vector<std::string>& headers);

/// The holes of the templates of headers that are called as these pieces are, but for `state`; the
/// one for `class_name` is `name`.
[[nodiscard]] Holes holes_of(const SystemPart& part);

}  // namespace hvi::gen
