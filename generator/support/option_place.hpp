// Where a caret points to the value of an option.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// The place that is the whole of an option's value.
[[nodiscard]] inline Place option_place(std::string option, std::string value) {
    const std::size_t size = value.size();
    return {std::make_shared<const Source>(Source{std::move(option), std::move(value)}), {0, size}};
}

}  // namespace hvi::gen
