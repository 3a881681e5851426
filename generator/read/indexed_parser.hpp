// Names with indices, `x[i+1]`, and sums over an index, `sum(i=1..3, x[i])`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/read/expression_parser.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

class IndexedParser final : public ExpressionParser {
public:
    explicit IndexedParser(std::shared_ptr<const Source> source, Range part)
        : ExpressionParser(std::move(source), part, Indices::allowed) {}

    /// Reads a list of names, which is the whole text.
    [[nodiscard]] std::vector<Name> names();

private:
    [[nodiscard]] Expression name(const Token& name) override;
    [[nodiscard]] Expression indexed_name(const Token& name);
    [[nodiscard]] Expression sum_over_index(const Token& name);
    [[nodiscard]] std::string index_of_sum();
    [[nodiscard]] long whole_number();
    [[nodiscard]] long whole_number(const Expression& expression) const;
    void take_close_index();
    void append_names(std::vector<Name>& names);

    std::map<std::string, long> indices_of_sums_;
};

}  // namespace hvi::gen
