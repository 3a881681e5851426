// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <Random123/philox.h>
#include <boost/math/distributions/normal.hpp>

#include "generator/ensembles/option_parts.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr const char* example_of_law =
    "--random \"x=normal(0, 1e-3)\", mean and deviation, or \"x=uniform(-1, 1)\"";

/// Returns the ranges between commas outside of parentheses.
std::vector<Range> arguments_in(std::string_view text, Range part) {
    std::vector<Range> result;
    std::size_t begin = part.begin;
    int depth = 0;
    for (std::size_t at = part.begin; at < part.end; ++at) {
        if (text[at] == '(' || text[at] == '[') ++depth;
        if (text[at] == ')' || text[at] == ']') --depth;
        if (text[at] != ',' || depth > 0) continue;
        result.push_back({begin, at});
        begin = at + 1;
    }
    result.push_back({begin, part.end});
    return result;
}

/// A law as it is written: a word, and what stands in parentheses behind it.
struct WrittenLaw {
    std::string_view word;
    Range range;  ///< the range of the word
    Range inner;
};

WrittenLaw written_law(const Given& text, Range rest) {
    const std::string_view all = text->text;
    const Range whole_law = trimmed(all, rest);
    const std::size_t open = std::min(all.find('(', whole_law.begin), whole_law.end);
    if (open == whole_law.end || all[whole_law.end - 1] != ')')
        throw InputError("a law with two numbers is wanted here", Place{text, whole_law},
                         std::string("for example ") + example_of_law);
    const Range word = trimmed(all, {whole_law.begin, open});
    return {all.substr(word.begin, word.end - word.begin), word, {open + 1, whole_law.end - 1}};
}

Normal normal_law(double mean, double deviation, const Place& place) {
    if (deviation < 0) throw InputError("a standard deviation is not negative", place);
    return {mean, deviation};
}

Uniform uniform_law(double from, double to, const Place& place) {
    if (from > to)
        throw InputError("the second number is below the first one", place,
                         "the values lie between the two");
    return {from, to};
}

}  // namespace

Law law(const Given& text, const SceneTimes& scene) {
    const NamedPart named = named_part(text, "NAME=LAW", example_of_law);
    const WrittenLaw written = written_law(text, named.rest);
    const bool is_normal = written.word == "normal";
    if (!is_normal && written.word != "uniform")
        throw InputError(
            fmt::format("there is no law `{}`", written.word), Place{text, written.range},
            did_you_mean(written.word, {"normal", "uniform"},
                         "the laws are normal(MEAN, DEVIATION) and uniform(FROM, TO)"));
    const std::vector<Range> arguments = arguments_in(text->text, written.inner);
    if (arguments.size() != 2)
        throw InputError(
            fmt::format("`{}` has two numbers", written.word), Place{text, written.inner},
            is_normal ? "its mean and its standard deviation" : "the values lie between them");
    const double first = value_of_part(text, arguments[0], scene),
                 second = value_of_part(text, arguments[1], scene);
    const Place place{text, trimmed(text->text, arguments[1])};
    if (is_normal) return {named.name, normal_law(first, second, place), named.place};
    return {named.name, uniform_law(first, second, place), named.place};
}

// NOTE: with 53 bits the largest number would round to 1.
double between_0_and_1(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

double uniform_number(std::uint64_t seed, std::int64_t row, std::uint32_t number) {
    const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
    const auto wide_row = static_cast<std::uint64_t>(row);
    const r123::Philox4x32::ctr_type counter{{low(wide_row), low(wide_row >> 32), number, 0}};
    const r123::Philox4x32::key_type key{{low(seed), low(seed >> 32)}};
    const r123::Philox4x32::ctr_type words = r123::Philox4x32()(counter, key);
    return between_0_and_1(std::uint64_t{words[1]} << 32 | words[0]);
}

double quantile(const Law& law, double part) {
    if (const auto* normal = std::get_if<Normal>(&law.kind))
        return normal->mean +
               normal->deviation * boost::math::quantile(boost::math::normal(), part);
    const auto& uniform = std::get<Uniform>(law.kind);
    return std::lerp(uniform.from, uniform.to, part);
}

double sample(const Law& law, std::uint64_t seed, std::int64_t row, std::uint32_t number) {
    return quantile(law, uniform_number(seed, row, number));
}

}  // namespace hvi::gen
