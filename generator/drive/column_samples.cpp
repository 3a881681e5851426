// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/column_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <driver/answer.hpp>

#include "generator/drive/frequencies.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_of_column = 1U << 18U, most_in_all = 1U << 24U;
constexpr std::size_t most_terms = 10;

}  // namespace

ColumnSamples::ColumnSamples(const TrajectoryWishes& wishes)
    : has_times_(!wishes.tables.front().times.empty()) {
    for_each_column(wishes.analysed,
                    [&](const std::string&, std::size_t number) { numbers_.push_back(number); });
    columns_.resize(numbers_.size());
    const std::vector<double>& times = wishes.tables.front().times;
    const std::int64_t last =
        has_times_ ? static_cast<std::int64_t>(times.size()) - 1 : wishes.steps;
    const std::size_t most =
        std::min(most_of_column, most_in_all / std::max<std::size_t>(1, numbers_.size()));
    every_ = last / static_cast<std::int64_t>(most) + 1;
    if (has_times_) first_ = times.front();
    const double distance = has_times_ ? (times.back() - times.front()) /
                                             static_cast<double>(std::max<std::int64_t>(1, last))
                                       : wishes.h;
    step_ = static_cast<double>(every_) * distance;
    if (numbers_.empty()) every_ = std::numeric_limits<std::int64_t>::max();
}

void ColumnSamples::add(const Rows::Value& value) {
    for (std::size_t k = 0; k < numbers_.size(); ++k) columns_[k].push_back(value(numbers_[k]));
}

void ColumnSamples::tell() const {
    for (const std::vector<double>& values : columns_) tell(values);
}

void ColumnSamples::tell(const std::vector<double>& values) const {
    const bool are_finite = std::all_of(values.begin(), values.end(),
                                        [](double value) { return std::isfinite(value); });
    std::vector<FrequencyTerm> terms;
    if (are_finite && values.size() >= fewest_samples)
        terms = frequencies({first_, step_, values}, most_terms);
    driver::say("terms", static_cast<std::int64_t>(terms.size()));
    for (const FrequencyTerm& term : terms) {
        driver::say("frequency", term.frequency);
        driver::say("amplitude", term.amplitude);
        driver::say("phase", term.phase);
        driver::say("uncertainty", term.uncertainty);
    }
}

}  // namespace hvi::gen
