// The commands of hvi-gen. Each reads its input, calls the pipeline, and writes the result.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"

namespace hvi::gen {

void run(const TableauOptions& options);
void run(const CheckOptions& options);
void run(const StepperOptions& options);
void run(const SchemeOptions& options);
void run(const RunOptions& options);
void run(const EnsembleOptions& options);
void run(const CollectOptions& options);
void run(const ModuleOptions& options);
void run(const ReportOptions& options);
void run(const SymmetriesOptions& options);
void run(const ShowOptions& options);
void run(const ListOptions& options);
void run(const CacheOptions& options);
void run(const CompletionsOptions& options);
void run(const ManualOptions& options);
void run(const Information& information);

/// Writes to the file, or to standard output where none is named.
void write_result(const std::optional<std::filesystem::path>& file, std::string_view text);

}  // namespace hvi::gen
