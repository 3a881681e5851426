// The formats of files of rows.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/ensembles/number_rows.hpp"

namespace hvi::gen {

/// The bytes that an HDF5 file begins with.
constexpr std::string_view hdf5_magic = "\x89HDF\r\n\x1a\n";

// Each opens a file of its format; `stream` is at the beginning.

[[nodiscard]] std::unique_ptr<NumberRows> csv_number_rows(const NumberFile& file,
                                                          std::ifstream stream);
[[nodiscard]] std::unique_ptr<NumberRows> npy_number_rows(const NumberFile& file,
                                                          std::ifstream stream);
[[nodiscard]] std::unique_ptr<NumberRows> hdf5_number_rows(const NumberFile& file);

/// Throws InputError where a name is empty, or comes twice, and where there is none.
void check_names(const NumberFile& file, const std::vector<std::string>& names);

/// Throws InputError: what was there when the file was opened is not there any more.
[[noreturn]] void refuse_changed(const NumberFile& file);

}  // namespace hvi::gen
