// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace hvi::gen {

namespace {

constexpr std::size_t most_places = 400;   ///< of a chain
constexpr std::size_t most_in_line = 200;  ///< of a sheet, in each direction
constexpr std::size_t most_bodies = 8;
constexpr std::int64_t most_image_rows = 400, most_track_rows = 2000;

std::size_t length(const IndexRange& range) {
    return static_cast<std::size_t>(range.last - range.first + 1);
}

bool same(const IndexRange& a, const IndexRange& b) {
    return a.first == b.first && a.last == b.last;
}

/// At most so many values of an index, evenly spaced.
ShownIndex shown(const IndexRange& range, std::size_t most) {
    const std::size_t stride = (length(range) + most - 1) / most;
    return {range.first, static_cast<long>(stride), (length(range) - 1) / stride + 1};
}

/// NOTE: in the table such columns have the names of neighbours.
IndexRange columns_of(const ShownIndex& index) {
    return {index.first, index.first + static_cast<long>(index.count) - 1};
}

std::size_t stride(const ShownIndex& index) { return static_cast<std::size_t>(index.stride); }

// ---- the tables ----

/// A multiple of `every` such that there are at most so many rows: what steps are seen one by one
/// does not depend on the picture.
std::int64_t row_in(const Steps& steps, std::int64_t every, std::int64_t most) {
    const std::int64_t rows = steps.count / every;
    return every * std::max<std::int64_t>(1, (rows + most - 1) / most);
}

TableWishes table_of(const Chain& chain, const Steps& steps, std::int64_t every) {
    const ShownIndex index = shown(chain.places.ranges[0], most_places);
    return {row_in(steps, every, most_image_rows),
            {{{chain.places.stem, {columns_of(index)}}, 0, {stride(index)}}},
            {}};
}

TableWishes table_of(const Sheet& sheet, const Steps& steps, std::int64_t) {
    const ShownIndex first = shown(sheet.places.ranges[0], most_in_line),
                     second = shown(sheet.places.ranges[1], most_in_line);
    return {std::max<std::int64_t>(1, steps.count),
            {{{sheet.places.stem, {columns_of(first), columns_of(second)}},
              0,
              {stride(first) * length(sheet.places.ranges[1]), stride(second)}}},
            {}};
}

std::size_t shown_bodies(const Bodies& bodies) {
    return std::min(most_bodies, length(bodies.x.ranges[0]));
}

TableWishes table_of(const Bodies& bodies, const Steps& steps, std::int64_t every) {
    TableWishes table{row_in(steps, every, most_track_rows), {}, {}};
    const long first = bodies.x.ranges[0].first;
    const IndexRange range{first, first + static_cast<long>(shown_bodies(bodies)) - 1};
    table.columns.push_back({{bodies.x.stem, {range}}, 0, {1}});
    table.columns.push_back({{bodies.y.stem, {range}}, length(bodies.x.ranges[0]), {1}});
    return table;
}

// ---- the view ----

/// Columns with these names, at most 64. The first column of the table is the time.
std::vector<TableColumn> shown(const std::vector<NameBox>& names,
                               const std::vector<ColumnBox>& columns) {
    constexpr std::size_t most = 64;
    std::vector<TableColumn> result;
    for (const std::string& name : names_in(names, columns)) {
        if (result.size() == most) break;
        if (const auto before = columns_before(columns, name))
            result.push_back({*before + 2, name});
    }
    return result;
}

View view_of(const Chain& chain, const TableWishes& table, const Simulation& run, double step) {
    const std::int64_t rows = run.steps / table.every + 1;
    if (rows < 2) return TableCurves{};
    return PlacesInTime{table.file, chain.places.stem, shown(chain.places.ranges[0], most_places),
                        static_cast<std::size_t>(rows), static_cast<double>(table.every) * step};
}

View view_of(const Sheet& sheet, const TableWishes& table, const Simulation& run, double) {
    if (run.steps == 0) return TableCurves{};
    return FieldAtEnds{table.file, sheet.places.stem, shown(sheet.places.ranges[0], most_in_line),
                       shown(sheet.places.ranges[1], most_in_line)};
}

View view_of(const Bodies& bodies, const TableWishes& table, const Simulation&, double) {
    return TableCurves{table.file, curves_of(shown({bodies.x, bodies.y}, table.columns), {})};
}

using Coordinates = std::variant<Chain, Sheet, Bodies>;

std::optional<Coordinates> coordinates_of(const std::vector<NameBox>& names) {
    const auto has_indices = [](const NameBox& box, std::size_t count) {
        return box.ranges.size() == count &&
               std::all_of(box.ranges.begin(), box.ranges.end(),
                           [](const IndexRange& range) { return length(range) > 1; });
    };
    if (names.size() == 1 && has_indices(names[0], 1)) return Chain{names[0]};
    if (names.size() == 1 && has_indices(names[0], 2)) return Sheet{names[0]};
    const bool are_bodies =
        names.size() > 1 && std::all_of(names.begin(), names.end(), [&](const NameBox& box) {
            return has_indices(box, 1) && same(box.ranges[0], names[0].ranges[0]);
        });
    if (are_bodies) return Bodies{names[0], names[1]};
    return {};
}

}  // namespace

std::optional<PictureTable> picture_table(const std::vector<NameBox>& coordinates,
                                          const Steps& steps, std::int64_t every) {
    const auto what = coordinates_of(coordinates);
    if (!what) return {};
    return {
        {*what, std::visit([&](const auto& each) { return table_of(each, steps, every); }, *what)}};
}

TrajectoryPicture picture(const RunSubject& subject, const Steps& asked, const Simulation& run,
                          const RunTables& tables) {
    const auto positions = shown(subject.coordinates, tables.own.columns);
    const auto momenta = shown(subject.momenta, tables.own.columns);
    TrajectoryPicture picture;
    picture.title = subject.scene + ", " + subject.method + (run.ok() ? "" : " (incomplete)");
    picture.until = static_cast<double>(run.steps) * asked.size;
    picture.table = tables.own.file;
    // NOTE: from what begins as no number nothing departs.
    for (const Conserved& kept : run.conserved)
        for (const TableColumn& column : shown({name_box(kept.name)}, tables.own.columns))
            if (std::isfinite(kept.start)) picture.kept.push_back({column, kept.start});
    picture.columns = positions.empty() ? momenta : positions;
    picture.title_of_columns = positions.empty() ? "momenta" : "positions";
    picture.view = TableCurves{tables.own.file, curves_of(positions, momenta)};
    if (const auto& special = tables.of_picture)
        picture.view = std::visit(
            [&](const auto& each) { return view_of(each, special->table, run, asked.size); },
            special->coordinates);
    return picture;
}

}  // namespace hvi::gen
