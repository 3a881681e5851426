// `hvi-gen report --edges`: stiff and extreme cases.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"
#include "generator/program/compiler.hpp"

namespace hvi::gen {

/// Writes edges.html and edges.json into the directory of the options. Throws MathError, after
/// that, where something is not as expected. Precondition: interruptions are held.
void report_edges(const ReportOptions& options, const Compiler& compiler);

}  // namespace hvi::gen
