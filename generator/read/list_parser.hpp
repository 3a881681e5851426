// A list of expressions and of families with their sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/read/expression_parser.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

class ListParser final : private ExpressionParser {
public:
    using ExpressionParser::ExpressionParser;

    /// Reads at least one item.
    [[nodiscard]] std::vector<Item> items();

private:
    [[nodiscard]] bool is_list() const override { return true; }
    [[nodiscard]] Item item();
    [[nodiscard]] std::optional<Family> family();
    /// Returns the digits of a size.
    [[nodiscard]] Range size_behind(std::size_t colon, const std::string& family) const;
};

}  // namespace hvi::gen
