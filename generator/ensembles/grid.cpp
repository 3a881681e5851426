// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/grid.hpp"

#include <charconv>
#include <cstddef>
#include <system_error>

#include "generator/ensembles/option_parts.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr const char* form_of_grid = "NAME=FROM:TO:COUNT";
constexpr const char* example_of_grid = "--vary x=0:1:101 for 101 values, 0 and 1 among them";

std::int64_t count_of_values(const Given& text, Range part) {
    constexpr std::int64_t most = 1'000'000'000;
    const Range digits = trimmed(text->text, part);
    const char* const last = text->text.data() + digits.end;
    std::int64_t count = 0;
    const auto [end, error] = std::from_chars(text->text.data() + digits.begin, last, count);
    if (error == std::errc{} && end == last && 1 <= count && count <= most) return count;
    throw InputError("a whole number from 1 to 10^9 is wanted here", Place{text, digits},
                     "it is how many values there are");
}

}  // namespace

double Grid::at(std::int64_t k) const {
    if (k == 0) return from;
    if (k == count - 1) return to;
    const auto first = static_cast<long double>(from), last = static_cast<long double>(to);
    const auto part = static_cast<long double>(k) / static_cast<long double>(count - 1);
    return static_cast<double>(first + part * (last - first));
}

Grid grid(const Given& text, const SceneTimes& scene) {
    const NamedPart named = named_part(text, form_of_grid, example_of_grid);
    const std::string& all = text->text;
    const std::size_t first = all.find(':', named.rest.begin), second = all.find(':', first + 1);
    const bool is_right = first != std::string::npos && second != std::string::npos &&
                          all.find(':', second + 1) == std::string::npos;
    if (!is_right)
        throw InputError("FROM:TO:COUNT is wanted here", Place{text, named.rest},
                         std::string("for example ") + example_of_grid);
    return {named.name, value_of_part(text, {named.rest.begin, first}, scene),
            value_of_part(text, {first + 1, second}, scene),
            count_of_values(text, {second + 1, all.size()}), named.place};
}

}  // namespace hvi::gen
