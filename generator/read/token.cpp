// From characters to tokens.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/token.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hvi::gen {

namespace {

/// The replacement for a character that people take for mathematics.
struct Lookalike {
    std::string_view character;
    std::string_view help;
};

constexpr std::array<Lookalike, 15> lookalikes{{
    {"\u03c0", "write `pi`"},
    {"\u03c4", "write `tau`"},
    {"\u00d7", "write `*` for a product"},
    {"\u00b7", "write `*` for a product"},
    {"\u22c5", "write `*` for a product"},
    {"\u00f7", "write `/` for a quotient"},
    {"\u2212", "write `-`, the minus of a keyboard"},
    {"\u2013", "write `-`, the minus of a keyboard"},
    {"\u221a", "write `sqrt(...)`"},
    {"\u00b2", "write `^2`"},
    {"\u00b3", "write `^3`"},
    {";", "items are separated by commas"},
    {":", "a family stands alone, as in `gauss:3`"},
    {"[", "only round parentheses group"},
    {"{", "only round parentheses group"},
}};

/// Names of the Greek letters from alpha, U+03B1, on. Those from U+0391 on begin with a capital.
constexpr std::array<std::string_view, 25> greek_letters{
    "alpha", "beta",   "gamma",   "delta", "epsilon", "zeta",    "eta",   "theta", "iota",
    "kappa", "lambda", "mu",      "nu",    "xi",      "omicron", "pi",    "rho",   "sigma",
    "sigma", "tau",    "upsilon", "phi",   "chi",     "psi",     "omega",
};

/// Returns the name of a Greek letter in UTF-8; empty for other characters.
std::string greek_name(std::string_view character) {
    if (character.size() != 2) return "";
    const auto code = (static_cast<unsigned>(character[0]) & 0x1fU) << 6U |
                      (static_cast<unsigned>(character[1]) & 0x3fU);
    constexpr unsigned alpha = 0x3b1, capital_alpha = 0x391, letters = greek_letters.size();
    if (code >= alpha && code < alpha + letters) return std::string(greek_letters[code - alpha]);
    if (code < capital_alpha || code >= capital_alpha + letters) return "";
    std::string name(greek_letters[code - capital_alpha]);
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return name;
}

/// Returns the bytes of the UTF-8 character that `text` starts with; 1 when it is none.
std::size_t character_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t length = lead < 0xc2   ? 1
                               : lead < 0xe0 ? 2
                               : lead < 0xf0 ? 3
                               : lead < 0xf5 ? 4
                                             : 1;
    const auto tail = text.substr(1, length - 1);
    const bool valid =
        tail.size() == length - 1 && std::all_of(tail.begin(), tail.end(), [](char c) {
            return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
        });
    return valid ? length : 1;
}

/// Returns the character for messages: as it looks, or its bytes when it has no looks.
std::string shown(std::string_view character) {
    const auto byte = static_cast<unsigned char>(character.front());
    if (character.size() > 1 || (0x20 < byte && byte < 0x7f)) return fmt::format("`{}`", character);
    return fmt::format("with code 0x{:02x}", byte);
}

}  // namespace

bool is_digit(char c) { return '0' <= c && c <= '9'; }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_name_start(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }

bool is_name_char(char c) { return is_name_start(c) || is_digit(c); }

Range trimmed(std::string_view text, Range range) {
    while (range.begin < range.end && is_blank(text[range.begin])) ++range.begin;
    while (range.end > range.begin && is_blank(text[range.end - 1])) --range.end;
    return range;
}

Lexer::Lexer(std::shared_ptr<const Source> source, Range part, Indices indices)
    : source_(std::move(source)),
      text_(std::string_view(source_->text).substr(0, part.end)),
      position_(part.begin),
      indices_(indices) {
    HVI_CHECK(part.begin <= part.end && part.end <= source_->text.size());
}

Token Lexer::next() {
    while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
    if (position_ == text_.size()) return {Token::Kind::end, {position_, position_}};
    const char c = text_[position_];
    const bool point = c == '.' && position_ + 1 < text_.size() && is_digit(text_[position_ + 1]);
    Token token = is_digit(c) || point ? number() : is_name_start(c) ? name() : sign();
    position_ = token.range.end;
    return token;
}

/// Reads digits, a point with digits on one side at least, and an exponent: `1`, `.5`, `1.`,
/// `2e-3`.
Token Lexer::number() {
    std::size_t end = position_;
    const auto skip_digits = [&] {
        while (end < text_.size() && is_digit(text_[end])) ++end;
    };
    skip_digits();
    const bool is_range = indices_ == Indices::allowed && text_.substr(end, 2) == "..";
    if (end < text_.size() && text_[end] == '.' && !is_range) {
        ++end;
        skip_digits();
    }
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
        std::size_t digits = end + 1;
        if (digits < text_.size() && (text_[digits] == '+' || text_[digits] == '-')) ++digits;
        if (digits < text_.size() && is_digit(text_[digits])) {
            end = digits;
            skip_digits();
        }
    }
    return {Token::Kind::number, {position_, end}};
}

Token Lexer::name() {
    std::size_t end = position_ + 1;
    while (end < text_.size() && is_name_char(text_[end])) ++end;
    return {Token::Kind::name, {position_, end}};
}

Token Lexer::sign() {
    const Range range{position_, position_ + 1};
    switch (text_[position_]) {
    case '+': return {Token::Kind::plus, range};
    case '-': return {Token::Kind::minus, range};
    case '/': return {Token::Kind::over, range};
    case '^': return {Token::Kind::power, range};
    case '(': return {Token::Kind::open, range};
    case ')': return {Token::Kind::close, range};
    case ',': return {Token::Kind::comma, range};
    case '<': return comparison(Token::Kind::less, Token::Kind::less_or_equal);
    case '>': return comparison(Token::Kind::greater, Token::Kind::greater_or_equal);
    case '*':
        if (text_.substr(range.end, 1) == "*")
            throw InputError("`**` is no operator", Place{source_, {range.begin, range.end + 1}},
                             "write `^` for a power");
        return {Token::Kind::times, range};
    default: return sign_of_index();
    }
}

Token Lexer::comparison(Token::Kind alone, Token::Kind with_equality) const {
    const bool is_long = text_.substr(position_ + 1, 1) == "=";
    return {is_long ? with_equality : alone, {position_, position_ + (is_long ? 2 : 1)}};
}

Token Lexer::sign_of_index() {
    const Range range{position_, position_ + 1};
    if (indices_ == Indices::refused) { refuse_character(); }
    switch (text_[position_]) {
    case '[': return {Token::Kind::open_index, range};
    case ']': return {Token::Kind::close_index, range};
    case '=': return {Token::Kind::equals, range};
    case '.':
        if (text_.substr(range.end, 1) != ".") { refuse_character(); }
        return {Token::Kind::to, {range.begin, range.end + 1}};
    default: refuse_character();
    }
}

void Lexer::refuse_character() const {
    const std::string_view rest = text_.substr(position_);
    const std::string_view character = rest.substr(0, character_length(rest));
    const auto* known =
        std::find_if(lookalikes.begin(), lookalikes.end(),
                     [&](const Lookalike& entry) { return entry.character == character; });
    std::string help = known == lookalikes.end() ? "" : std::string(known->help);
    if (const std::string name = greek_name(character); help.empty() && !name.empty())
        help = fmt::format("write `{}`: names are made of the letters a to z", name);
    const bool behind_name = position_ > 0 && is_name_char(text_[position_ - 1]);
    if (character == "[" && behind_name) help = "names have an index in scenes and in H only";
    if (character == ":" && indices_ == Indices::allowed)
        help = "a range of indices is written `1..3`; all else is one number";
    throw InputError(fmt::format("the character {} cannot stand here", shown(character)),
                     Place{source_, {position_, position_ + character.size()}}, std::move(help));
}

}  // namespace hvi::gen
