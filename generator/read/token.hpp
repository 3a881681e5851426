// The words of a mathematical text.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// A word of a mathematical text. The kind `end` follows the last word.
struct Token {
    enum class Kind {
        number,
        name,
        plus,
        minus,
        times,
        over,
        power,
        open,
        close,
        comma,
        less,
        less_or_equal,
        greater,
        greater_or_equal,
        open_index,   ///< `[`, and the kinds below, in texts with indices only
        close_index,  ///< `]`
        equals,       ///< `=`
        to,           ///< `..`
        end
    };

    Kind kind = Kind::end;
    Range range;

    [[nodiscard]] bool is(Kind other) const { return kind == other; }

    /// Whether an unsigned operand can start with this token.
    [[nodiscard]] bool starts_operand() const {
        return is(Kind::number) || is(Kind::name) || is(Kind::open);
    }

    /// Whether the token is `<`, `<=`, `>` or `>=`.
    [[nodiscard]] bool compares() const {
        return Kind::less <= kind && kind <= Kind::greater_or_equal;
    }
};

/// Whether names can have indices, `x[i+1]`, and sums run over them.
enum class Indices { refused, allowed };

/// Cuts a part of a source into tokens, one at a time, from left to right.
class Lexer {
public:
    /// Reads `part` of the source's text. Precondition: `part` lies within it.
    Lexer(std::shared_ptr<const Source> source, Range part, Indices indices);

    /// Returns the next token. Throws InputError at a character that no token starts with.
    [[nodiscard]] Token next();

    /// Goes on reading at this byte of the source.
    void move_to(std::size_t position) { position_ = position; }

    [[nodiscard]] const std::shared_ptr<const Source>& source() const { return source_; }

    /// Returns the source's text up to the end of the part.
    [[nodiscard]] std::string_view text() const { return text_; }

    [[nodiscard]] std::string text(Range range) const {
        return std::string(text_.substr(range.begin, range.end - range.begin));
    }

private:
    [[nodiscard]] Token number();
    [[nodiscard]] Token name();
    [[nodiscard]] Token sign();
    [[nodiscard]] Token comparison(Token::Kind alone, Token::Kind with_equality) const;
    [[nodiscard]] Token sign_of_index();
    [[noreturn]] void refuse_character() const;

    std::shared_ptr<const Source> source_;
    std::string_view text_;
    std::size_t position_;
    Indices indices_;
};

[[nodiscard]] bool is_digit(char c);
[[nodiscard]] bool is_blank(char c);       ///< space, tab or line end
[[nodiscard]] bool is_name_start(char c);  ///< a letter or `_`
[[nodiscard]] bool is_name_char(char c);   ///< a letter, a digit or `_`

/// Returns the part of a text without the blanks around it; empty when it is all blank.
[[nodiscard]] Range trimmed(std::string_view text, Range range);

}  // namespace hvi::gen
