// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/list_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace hvi::gen {

namespace {

bool is_word_char(char c) { return is_name_char(c) || c == '-'; }

/// Returns the first position from `from` on whose character is not accepted.
std::size_t behind(std::string_view text, std::size_t from, bool (*accepts)(char)) {
    while (from < text.size() && accepts(text[from])) ++from;
    return from;
}

long size_or_largest(const std::string& digits) {
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    const bool fits = digits.size() - first <= std::numeric_limits<long>::digits10;
    return fits ? std::stol(digits) : std::numeric_limits<long>::max();
}

}  // namespace

std::vector<Item> ListParser::items() {
    std::vector<Item> items;
    do {
        if (!items.empty()) take();
        if (next_is(Kind::comma)) fail(next().range, "an item is missing before this comma");
        if (next_is(Kind::end)) fail(previous().range, "an item is missing after this comma");
        items.push_back(item());
    } while (next_is(Kind::comma));
    if (next_is(Kind::close)) fail(next().range, "there is no `(` for this `)`");
    return items;
}

Item ListParser::item() {
    if (std::optional<Family> found = family()) {
        const Range range = found->range;
        return {std::move(*found), range};
    }
    Expression expression = sum();
    const Range range = expression.range;
    return {std::move(expression), range};
}

/// Reads a family. A word with dashes names one only when a colon follows: `radau-left:2` does, but
/// `a-b` is a difference.
std::optional<Family> ListParser::family() {
    if (!next_is(Kind::name)) return {};
    const std::size_t begin = next().range.begin;
    const Range word{begin, behind(text(), begin, is_word_char)};
    const std::size_t colon = behind(text(), word.end, is_blank);
    if (text().substr(colon, 1) != ":") return {};
    const Range size = size_behind(colon, text(word));
    take_elsewhere({Kind::number, size});
    return Family{text(word), size_or_largest(text(size)), {word.begin, size.end}};
}

Range ListParser::size_behind(std::size_t colon, const std::string& family) const {
    const std::string_view all = text();
    Range size{behind(all, colon + 1, is_blank), std::min(all.find(',', colon), all.size())};
    while (size.end > size.begin && is_blank(all[size.end - 1])) --size.end;
    const std::string digits = size.begin < size.end ? text(size) : "";
    if (digits.empty())
        fail({colon, colon + 1}, "a number is missing after the colon",
             fmt::format("write `{}:3`", family));
    if (!std::all_of(digits.begin(), digits.end(), is_digit))
        fail(size, fmt::format("`{}` is no size of a family", digits),
             fmt::format("a size is a positive whole number, as in `{}:3`", family));
    return size;
}

}  // namespace hvi::gen
