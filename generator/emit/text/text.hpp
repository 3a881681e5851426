// Pieces of generated text: lines, wrapping, numbers, templates.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

constexpr std::size_t page_width = 100;

/// Lines of generated text, indented by four blanks for each open brace.
class Writer {
public:
    /// `depth`: number of open braces where the text will be inserted.
    explicit Writer(std::size_t depth) : base_(depth) {}

    /// Writes one statement. Where it is too long for the page it is broken before binary + and -,
    /// else at blanks, and goes on four columns further in. A comment behind it that does not fit
    /// stands above it.
    template <class... Arguments>
    Writer& line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        write(fmt::format(format, std::forward<Arguments>(arguments)...));
        return *this;
    }

    /// Writes a line that ends in an opening brace.
    template <class... Arguments>
    Writer& open(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        line(format, std::forward<Arguments>(arguments)...);
        ++depth_;
        return *this;
    }
    Writer& close(std::string_view text = "}");

    Writer& blank();

    /// Inserts the lines of another writer, which knew their depth; or nothing.
    Writer& insert(std::string_view lines);

    /// Writes a comment, broken to the page; lines but the first go on `hang` columns further in. A
    /// backslash at the end of a line, which would join the next line to it, is left out.
    Writer& comment(std::string_view text, std::string_view mark = "// ", std::size_t hang = 0);

    /// Returns the text without a newline at the end.
    [[nodiscard]] std::string str() const;

private:
    void write(std::string_view statement);
    [[nodiscard]] std::size_t indentation() const { return 4 * depth_; }
    [[nodiscard]] std::size_t room() const { return page_width - 4 * base_ - indentation(); }

    std::string text_;
    std::size_t base_;
    std::size_t depth_ = 0;
};

/// Returns the exact value as text, or its first digits where it has no closed form.
[[nodiscard]] std::string exact_text(const Number& number);

/// Return the number as C++ writes it: the shortest decimal that reads back as the same double or
/// float. Every compiler rounds it correctly, and it can be compared with the exact value by eye.
[[nodiscard]] std::string literal(double value);
[[nodiscard]] std::string literal(float value);

/// Returns a text as C++ writes it, in quotes.
[[nodiscard]] std::string text_literal(std::string_view text);

using Holes = std::map<std::string_view, std::string>;

/// Returns the embedded template with each `@hole@` filled. A value of several lines keeps the
/// indentation of a hole that stands alone on its line; an empty one takes the line away. The
/// template opens with lines `//@` that list its holes. Holes that are unknown, not filled or not
/// used break an invariant.
[[nodiscard]] std::string fill(std::string_view template_name, const Holes& holes);

/// Returns the filled template as a part of another text: without the newline at its end.
[[nodiscard]] std::string fill_part(std::string_view template_name, const Holes& holes);

}  // namespace hvi::gen
