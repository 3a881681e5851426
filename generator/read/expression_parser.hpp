// A recursive-descent reader; each function reads one line of the grammar in parse.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/read/token_reader.hpp"

namespace hvi::gen {

class ExpressionParser : protected TokenReader {
public:
    /// `own`: the user's own functions that the expression may call.
    explicit ExpressionParser(std::shared_ptr<const Source> source, Range part,
                              Indices indices = Indices::refused, OwnArguments own = {})
        : TokenReader(std::move(source), part, indices), own_(std::move(own)) {}
    virtual ~ExpressionParser() = default;

    /// Reads one expression, which is the whole text.
    [[nodiscard]] Expression lone_expression();

protected:
    [[nodiscard]] Expression sum();
    /// Reads an expression that begins with `name`, which is already taken.
    [[nodiscard]] virtual Expression name(const Token& name);

    [[nodiscard]] bool is_own(const std::string& function) const {
        return own_.count(function) != 0;
    }

    /// Whether messages may offer a function that can stand in lists only.
    [[nodiscard]] virtual bool is_list() const { return false; }

private:
    /// Reads a sum, or one side of a comparison.
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
    void check_argument_count(const Expression& call) const;

    OwnArguments own_;
    int nesting_ = 0;
};

}  // namespace hvi::gen
