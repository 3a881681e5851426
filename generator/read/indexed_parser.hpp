// Names with indices, `x[i+1]`, and sums over an index, `sum(i=1..3, x[i])`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/read/expression_parser.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

class IndexedParser final : public ExpressionParser {
public:
    explicit IndexedParser(std::shared_ptr<const Source> source, Range part, OwnArguments own = {})
        : ExpressionParser(std::move(source), part, Indices::allowed, std::move(own)) {}

    /// Reads a list of names, which is the whole text.
    [[nodiscard]] std::vector<Name> names();

    /// Reads one name, which is the whole text.
    [[nodiscard]] RuleName rule_name();

private:
    [[nodiscard]] Expression name(const Token& name) override;
    [[nodiscard]] Expression element(const Token& name);
    [[nodiscard]] Expression modulo(const Token& name);
    [[nodiscard]] Expression sum_over_indices(const Token& name);
    [[nodiscard]] bool is_next_index() const;
    [[nodiscard]] Expression one_sum(const Token& name);
    [[nodiscard]] std::string index_name();
    [[nodiscard]] Expression index();
    void take_close_index();
    [[nodiscard]] Name one_name();
    [[nodiscard]] IndexBounds bounds();

    std::set<std::string> indices_of_sums_;  ///< indices of the sums around this place
    int indices_deep_ = 0;                   ///< the number of indices around this place
};

}  // namespace hvi::gen
