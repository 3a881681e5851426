// What options with a few possible values choose between; their names stand in option_table.cpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/table_columns.hpp"

namespace hvi::gen {

enum class TableauFormat { text, json, latex, markdown, csv };
enum class CertificateFormat { text, json };
enum class EquationsFormat { text, json, latex };

/// What `list` prints.
enum class Topic { all, bases, nodes, methods, scenes, functions };

/// Lyapunov exponents of a run.
enum class Exponents { largest, spectrum };

/// What a run leaves.
enum class RunFile { table, picture, summary };

/// Files that a report is written to, and parts that it is made of.
enum class ReportItem {
    html,
    json,
    csv,
    svg,
    work,  ///< error against run time
    rejections,
    stiff,
    extreme,
    long_runs,
    time,
    symplecticity,
};

/// The records on the way to a header, in the order in which they are made.
enum class Stage {
    method,   ///< as it was read
    tableau,  ///< its exact coefficients
    system,   ///< H, its derivatives and the rest of a scene, as a graph
    step,     ///< what is solved, evaluated and kept, and why
};

/// Languages that a module is called from.
enum class Language { c, python };

enum class Shell { bash, zsh, fish };

}  // namespace hvi::gen
