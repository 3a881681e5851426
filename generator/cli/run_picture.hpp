// The picture of a run: what it shows, and which numbers of the run that takes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "generator/draw/trajectory.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// One name with one index: a chain, a string.
struct Chain {
    NameBox places;
};

/// One name with two indices: a sheet, a field in the plane.
struct Sheet {
    NameBox places;
};

/// Several names with one index, the same for all: x[i], y[i], ... of body i.
struct Bodies {
    NameBox x, y;
};

/// Coordinates that a picture shows as what they are, and the table that it takes.
struct PictureTable {
    std::variant<Chain, Sheet, Bodies> coordinates;
    TableWishes table;
};

/// The table of a picture beside that of the run, which has a row in `every` steps; no file is
/// named. Nothing where the coordinates are none of these, or are written out, each with a name of
/// its own.
[[nodiscard]] std::optional<PictureTable> picture_table(const std::vector<NameBox>& coordinates,
                                                        const Steps& steps, std::int64_t every);

/// Tables that a run writes.
struct RunTables {
    TableWishes own;
    std::optional<PictureTable> of_picture;
    std::optional<TableWishes> plain = {};  ///< as `own` has it, where that is no CSV
};

/// The picture of a run. Without a table of its own it shows what the table of the run has.
[[nodiscard]] TrajectoryPicture picture(const RunSubject& subject, const Steps& asked,
                                        const Simulation& run, const RunTables& tables);

}  // namespace hvi::gen
