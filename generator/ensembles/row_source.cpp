// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/row_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr std::int64_t most_rows = 1'000'000'000'000'000, rows_in_block = 1024;

std::string text_of(const Law& law) {
    if (const auto* normal = std::get_if<Normal>(&law.kind))
        return fmt::format("{} normal {} {}\n", law.name, normal->mean, normal->deviation);
    const auto& uniform = std::get<Uniform>(law.kind);
    return fmt::format("{} uniform {} {}\n", law.name, uniform.from, uniform.to);
}

}  // namespace

RowSource::RowSource(const RowSources& sources) : sources_(sources) {
    const auto multiply = [&](std::int64_t by, const Place& place) {
        if (count_ > most_rows / by) throw InputError("these are more than 10^15 rows", place);
        count_ *= by;
    };
    if (sources_.file) {
        file_ = number_rows(sources_.file);
        for (const std::string& name : file_->names())
            names_.push_back({name, whole(sources_.file)});
        multiply(file_->count(), whole(sources_.file));
    }
    for (const Grid& grid : sources_.grids) {
        names_.push_back({grid.name, grid.place});
        multiply(grid.count, grid.place);
    }
    for (const Law& law : sources_.laws) names_.push_back({law.name, law.place});
    if (!sources_.laws.empty()) multiply(sources_.samples, sources_.laws.front().place);
}

std::string RowSource::key() const {
    std::string text = file_ ? "file " + file_->digest() + "\n" : "";
    for (const Grid& grid : sources_.grids)
        text += fmt::format("{} {} {}\n", grid.name, grid.ends, grid.count);
    for (const Law& law : sources_.laws) text += text_of(law);
    return text + fmt::format("samples {} seed {}\n", sources_.samples, sources_.seed);
}

std::vector<double> RowSource::at(std::int64_t row) {
    std::int64_t rest = sources_.laws.empty() ? row : row / sources_.samples;
    std::vector<double> of_grids;
    for (auto grid = sources_.grids.rbegin(); grid != sources_.grids.rend(); ++grid) {
        of_grids.push_back(grid->at(rest % grid->count));
        rest /= grid->count;
    }
    std::vector<double> values = row_of_file(rest);
    values.insert(values.end(), of_grids.rbegin(), of_grids.rend());
    for (std::uint32_t k = 0; k < sources_.laws.size(); ++k)
        values.push_back(sample(sources_.laws[k], sources_.seed, row, k));
    return values;
}

std::vector<double> RowSource::row_of_file(std::int64_t row) {
    if (!file_) return {};
    const std::int64_t first = row / rows_in_block * rows_in_block;
    if (first != first_in_block_) {
        block_ = file_->rows(first, std::min(rows_in_block, file_->count() - first));
        first_in_block_ = first;
    }
    const auto count = static_cast<std::ptrdiff_t>(file_->names().size());
    const auto begin = block_.begin() + (row - first) * count;
    return {begin, begin + count};
}

}  // namespace hvi::gen
