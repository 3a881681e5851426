// A recursive-descent reader; each function reads one line of the grammar in parse.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/expr/functions.hpp"
#include "generator/read/token_reader.hpp"

namespace hvi::gen {

class ExpressionParser : protected TokenReader {
public:
    explicit ExpressionParser(std::shared_ptr<const Source> source, Range part,
                              Indices indices = Indices::refused)
        : TokenReader(std::move(source), part, indices) {}
    virtual ~ExpressionParser() = default;

    /// Reads one expression, which is the whole text.
    [[nodiscard]] Expression lone_expression();

protected:
    [[nodiscard]] Expression sum();
    /// What begins with this name, which is taken.
    [[nodiscard]] virtual Expression name(const Token& name);

    /// Whether a message may offer a function that can stand in lists only.
    [[nodiscard]] virtual bool is_list() const { return false; }

private:
    /// A sum, or one side of a comparison.
    [[nodiscard]] Expression side();
    [[nodiscard]] Expression product();
    [[nodiscard]] Expression signed_operand();
    [[nodiscard]] Expression power();
    [[nodiscard]] Expression operand();
    [[nodiscard]] Expression number();
    [[nodiscard]] Expression call(const Token& name);
    [[nodiscard]] Expression choice(const Token& name);
    [[nodiscard]] Token comparison();
    [[nodiscard]] Expression parenthesised();

    [[noreturn]] void fail_missing_operand() const;
    [[noreturn]] void fail_missing_operator() const;
    [[noreturn]] void fail_unknown_function(const Token& name) const;
    void check_argument_count(const Expression& call, const Function& function) const;

    int nesting_ = 0;
};

}  // namespace hvi::gen
