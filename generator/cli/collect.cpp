// `hvi-gen collect`: one table of the rows of a study.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <system_error>

#include "generator/cli/commands.hpp"
#include "generator/drive/row_file.hpp"
#include "generator/ensembles/study_rows.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

/// Returns the format that the ending of a file's name asks for.
TableFormat format_of(const fs::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".csv") return TableFormat::csv;
    if (ending == ".npy") return TableFormat::npy;
    if (ending == ".h5" || ending == ".hdf5") return TableFormat::hdf5;
    throw InputError(fmt::format("`{}` ends with none of .csv, .npy and .h5", file.string()));
}

TableHead head_with_notes(const Study& study) {
    TableHead head = head_of(study);
    head.notes = {{"title", study.title}, {"command", study.command}, {"key", study.key}};
    return head;
}

}  // namespace

void run(const CollectOptions& options) {
    const Study study = study_in(options.study);
    const fs::path file = options.output.value_or(options.study / "rows.csv");
    const TableFormat format = format_of(file);
    check_format(format);
    const fs::path directory = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const fs::path growing = new_file(directory);
    const auto fail = [&] {
        std::error_code ignored;
        fs::remove(growing, ignored);
    };
    try {
        if (format == TableFormat::hdf5) fs::remove(growing);
        const auto table = row_file(format, growing, head_with_notes(study));
        for_each_row(study, [&](const std::vector<double>& row) { table->row(row); });
        if (!table->close()) throw EnvironmentError("cannot write " + file.string());
        fs::rename(growing, file);
    } catch (const fs::filesystem_error& error) {
        fail();
        throw EnvironmentError("cannot write " + file.string() + ": " + error.code().message());
    } catch (...) {
        fail();
        throw;
    }
    if (const std::size_t missing = missing_chunks(study).size(); missing > 0)
        throw MathError(
            fmt::format("{} of {} chunks are missing in this table", missing, study.chunks()), {},
            "they are computed by: " + study.command);
}

}  // namespace hvi::gen
