// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>
#include <utility>

#include "generator/ensembles/option_parts.hpp"
#include "generator/read/token.hpp"
#include "generator/scene/step_count.hpp"

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

GridValues::GridValues(std::string from, std::string to, std::int64_t count, SceneTimes scene)
    : from_(std::move(from)), to_(std::move(to)), count_(count), scene_(std::move(scene)) {
    constexpr std::int64_t most_kept = 1'000'000;
    if (count_ <= most_kept) kept_.resize(static_cast<std::size_t>(count_));
}

double GridValues::at(std::int64_t k) const {
    const auto place = static_cast<std::size_t>(k);
    if (kept_.empty()) return value(k);
    if (!kept_[place]) kept_[place] = value(k);
    return *kept_[place];
}

double GridValues::value(std::int64_t k) const {
    const std::string text = fmt::format("({})+(({})-({}))*{}/{}", from_, to_, from_, k,
                                         std::max<std::int64_t>(count_ - 1, 1));
    return nearest_value(
        scene_, expression_of_parameters(scene_, "grid",
                                         std::make_shared<const Source>(Source{"grid", text})));
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
    const Range from{named.rest.begin, first}, to{first + 1, second};
    const std::int64_t count = count_of_values(text, {second + 1, all.size()});
    for (const Range end : {from, to}) static_cast<void>(value_of_part(text, end, scene));
    const auto part = [&](Range range) { return all.substr(range.begin, range.end - range.begin); };
    return {named.name, part(from) + ":" + part(to), count,
            std::make_shared<const GridValues>(part(from), part(to), count, scene), named.place};
}

}  // namespace hvi::gen
