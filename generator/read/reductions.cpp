// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/reductions.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

struct ReductionName {
    std::string_view name;
    ReductionKind kind;
};

constexpr std::array reduction_names = {ReductionName{"min", ReductionKind::least},
                                        ReductionName{"max", ReductionKind::largest},
                                        ReductionName{"mean", ReductionKind::mean}};

/// Returns the ranges between the commas that stand outside brackets.
std::vector<Range> pieces(std::string_view text) {
    std::vector<Range> result;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t k = 0; k <= text.size(); ++k) {
        const char c = k < text.size() ? text[k] : ',';
        if (c == '(' || c == '[') ++depth;
        if (c == ')' || c == ']') --depth;
        if (k < text.size() && (c != ',' || depth > 0)) continue;
        result.push_back(trimmed(text, {begin, k}));
        begin = k + 1;
    }
    return result;
}

/// Returns the function that a word names.
const ReductionName& named(const std::string& word, const Place& place) {
    std::vector<std::string_view> names;
    for (const ReductionName& each : reduction_names) {
        if (each.name == word) return each;
        names.push_back(each.name);
    }
    throw InputError(fmt::format("there is no `{}` of a column", word), place,
                     did_you_mean(word, names, fmt::format("there are {}", listed(names))));
}

/// A function, and the columns in its brackets.
struct Piece {
    const ReductionName& function;
    Range columns;
};

Piece read_piece(const Given& list, Range range) {
    const std::string_view text = list->text;
    if (range.begin == range.end)
        throw InputError("an item is missing in this list", Place{list, range});
    const std::size_t open = text.substr(0, range.end).find('(', range.begin);
    if (open == std::string_view::npos)
        throw InputError("this is no function of a column", Place{list, range},
                         "write for example \"min(x), mean(energy)\"");
    const Range word = trimmed(text, {range.begin, open});
    const ReductionName& function =
        named(std::string(text.substr(word.begin, word.end - word.begin)), Place{list, word});
    if (text[range.end - 1] != ')')
        throw InputError("this `(` is never closed", Place{list, {open, open + 1}});
    const Range columns = trimmed(text, {open + 1, range.end - 1});
    if (text.substr(columns.begin, columns.end - columns.begin) == "t")
        throw InputError("the time `t` is no column to be looked at", Place{list, columns});
    return {function, columns};
}

}  // namespace

std::vector<Reduction> named_reductions(const Given& list, const std::vector<NameBox>& all,
                                        const WholeNumbers& sizes) {
    std::vector<Reduction> result;
    std::set<std::string> names;
    for (const Range& range : pieces(list->text)) {
        const Piece piece = read_piece(list, range);
        for_each_column(
            named_columns(list, piece.columns, all, sizes),
            [&](const std::string& column, std::size_t number) {
                std::string name = fmt::format("{}({})", piece.function.name, column);
                if (!names.insert(name).second)
                    throw InputError(fmt::format("`{}` is named twice", name), Place{list, range});
                result.push_back({std::move(name), piece.function.kind, number});
            });
    }
    return result;
}

}  // namespace hvi::gen
