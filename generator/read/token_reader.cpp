// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/token_reader.hpp"

#include <utility>

namespace hvi::gen {

namespace {

constexpr std::size_t longest_text = 64 * 1024;

}  // namespace

TokenReader::TokenReader(std::shared_ptr<const Source> source, Range part, Indices indices)
    : lexer_(std::move(source), part, indices) {
    if (part.end - part.begin > longest_text)
        fail({part.begin, part.begin}, "the text is longer than 64 KiB");
    next_ = lexer_.next();
    previous_ = {Kind::end, {part.begin, part.begin}};
    if (next_.is(Kind::end)) fail(part, "the text is empty");
}

bool TokenReader::next_is_followed_by(Kind kind) const {
    Lexer ahead = lexer_;
    return ahead.next().is(kind);
}

Token TokenReader::take() {
    previous_ = next_;
    next_ = lexer_.next();
    return previous_;
}

Token TokenReader::take(Kind kind, const char* what) {
    if (!next_is(kind)) fail(next_.range, what);
    return take();
}

void TokenReader::take_close(const Token& open) {
    if (!next_is(Kind::close)) fail(open.range, "this `(` is never closed");
    take();
}

void TokenReader::take_elsewhere(const Token& token) {
    previous_ = token;
    lexer_.move_to(token.range.end);
    next_ = lexer_.next();
}

Expression TokenReader::located(Expression expression, std::size_t begin) const {
    expression.range = {begin, previous_.range.end};
    return expression;
}

void TokenReader::fail(Range range, std::string what, std::string help) const {
    throw InputError(std::move(what), place(range), std::move(help));
}

}  // namespace hvi::gen
