// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/output_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr long most_times = 10'000'000;

Given part_of(const Given& text, const std::string& part) {
    return std::make_shared<const Source>(Source{text->name, part});
}

long count_of(const Given& text, std::size_t begin) {
    const char* const first = text->text.data() + begin;
    const char* const last = text->text.data() + text->text.size();
    long count = 0;
    const auto [end, error] = std::from_chars(first, last, count);
    if (error == std::errc{} && end == last && 1 <= count && count <= most_times) return count;
    throw InputError(fmt::format("a whole number from 1 to {} is wanted here", most_times),
                     Place{text, {begin, text->text.size()}}, "it is how many times there are");
}

double time_of(const SceneTimes& scene, const Given& text) {
    return nearest_value(scene, expression_of_parameters(scene, "times", text));
}

}  // namespace

OutputTimes output_times(const Given& text) {
    const std::string& all = text->text;
    const std::size_t first = all.find(':'), second = all.find(':', first + 1);
    const bool is_right = first != std::string::npos && second != std::string::npos &&
                          all.find(':', second + 1) == std::string::npos;
    if (!is_right)
        throw InputError("FROM:TO:COUNT is wanted here", whole(text),
                         "for example --times 0:10:101 for a row at each tenth");
    return {part_of(text, all.substr(0, first)),
            part_of(text, all.substr(first + 1, second - first - 1)), count_of(text, second + 1)};
}

Steps steps_to_output(Steps steps, const std::optional<OutputTimes>& times) {
    if (!times || steps.left == 0) return steps;
    return {steps.size, steps.count + 1};
}

std::vector<double> values_of(const OutputTimes& times, const SceneTimes& scene, double step,
                              double end) {
    const double from = time_of(scene, times.from), to = time_of(scene, times.to);
    // NOTE: the end of the run is rounded.
    const double most = std::abs(end) * (1 + 1e-14);
    if (from * step < 0)
        throw InputError("the run begins at t = 0", whole(times.from), "rows are on its way");
    if ((to - from) * step < 0)
        throw InputError("these times lead against the steps", whole(times.to),
                         "they go on as the run does");
    if (std::abs(to) > most)
        throw InputError(fmt::format("the run ends at t = {:.10g}", end), whole(times.to),
                         "give a later --until, or none");
    std::vector<double> result;
    const auto gaps = static_cast<long double>(std::max(1L, times.count - 1));
    const auto first = static_cast<long double>(from), last = static_cast<long double>(to);
    for (long k = 0; k < times.count; ++k) {
        const auto part = static_cast<long double>(k) / gaps;
        const auto time = static_cast<double>(first + part * (last - first));
        result.push_back(std::abs(time) > std::abs(end) ? end : time);
    }
    return result;
}

}  // namespace hvi::gen
