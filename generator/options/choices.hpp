// Values of options with a few possible values; their names stand in option_table.cpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/table_columns.hpp"

namespace hvi::gen {

enum class TableauFormat { text, json, latex, markdown, csv };
enum class CertificateFormat { text, json };
enum class EquationsFormat { text, json, latex };

/// Topics of `list`.
enum class Topic { all, bases, nodes, methods, scenes, functions, splits };

/// Lyapunov exponents of a run.
enum class Exponents { largest, spectrum };

/// Files of a run.
enum class RunFile { table, picture, summary };

/// Files and parts of a report.
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
    method,   ///< the method as read
    tableau,  ///< its exact coefficients
    system,   ///< H, its derivatives and the rest of a scene, as a graph
    step,     ///< values to solve, evaluate and keep, with reasons
};

/// Languages that a module is called from.
enum class Language { c, python };

enum class Shell { bash, zsh, fish };

}  // namespace hvi::gen
