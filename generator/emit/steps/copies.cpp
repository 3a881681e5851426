// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/copies.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string_view>

#include "generator/emit/text/embedded.hpp"

namespace hvi::gen {

namespace {

/// Returns the text of a header without what it includes of hvi. What its doc comments tell users
/// under a heading, `/// # Use`, with an example, stays in the runtime.
std::string copy_of(std::string_view name) {
    std::string text;
    std::istringstream file{std::string(embedded_template(fmt::format("hvi/{}.hpp", name)))};
    bool is_for_users = false;
    for (std::string line; std::getline(file, line);) {
        is_for_users = line.rfind(is_for_users ? "///" : "/// # ", 0) == 0;
        const bool is_included = line.rfind("#include <hvi/", 0) == 0;
        if (!is_for_users && !is_included) { text += line + '\n'; }
    }
    return text;
}

}  // namespace

std::string copies_of(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) { text += (text.empty() ? "" : "\n") + copy_of(name); }
    return text;
}

}  // namespace hvi::gen
