// The tokens of a mathematical text, taken one by one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "generator/expr/expression.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

/// The base of readers of a grammar.
class TokenReader {
protected:
    using Kind = Token::Kind;

    /// Throws InputError for a text that is empty, and for one of more than 64 KiB.
    TokenReader(std::shared_ptr<const Source> source, Range part, Indices indices);

    [[nodiscard]] const Token& next() const { return next_; }          ///< not yet taken
    [[nodiscard]] const Token& previous() const { return previous_; }  ///< taken last
    [[nodiscard]] bool next_is(Kind kind) const { return next_.is(kind); }
    /// Whether the token behind the next one is of this kind.
    [[nodiscard]] bool next_is_followed_by(Kind kind) const;

    Token take();
    /// Takes the next token, which must be of this kind; otherwise the error says `what`.
    Token take(Kind kind, const char* what);
    /// Takes the `)` of `open`. Precondition: all inside is read, so that only `)` or the end can
    /// follow.
    void take_close(const Token& open);
    /// Takes a token that stands elsewhere in the text, and goes on behind it.
    void take_elsewhere(const Token& token);

    /// Returns the source's text up to the end of the part.
    [[nodiscard]] std::string_view text() const { return lexer_.text(); }
    [[nodiscard]] std::string text(Range range) const { return lexer_.text(range); }
    [[nodiscard]] Place place(Range range) const { return {lexer_.source(), range}; }

    /// Returns the expression with the range from `begin` to the end of the token taken last.
    [[nodiscard]] Expression located(Expression expression, std::size_t begin) const;

    [[noreturn]] void fail(Range range, std::string what, std::string help = {}) const;

private:
    Lexer lexer_;
    Token next_;
    Token previous_;
};

}  // namespace hvi::gen
