// A compiled module that takes many rows of a study at once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include <hvi/detail/module/row_functions.hpp>

namespace hvi::gen {

/// Loads the module of a library, which stays loaded until the process ends. Throws
/// std::runtime_error where the file is no module of this version.
[[nodiscard]] const detail::RowFunctions& loaded_rows(const std::string& library);

/// Takes all rows, with so many parameters each; `directory` is that of the scene. Throws
/// std::bad_alloc, and EnvironmentError with the module's message, as where there is no GPU.
///
/// NOTE: a GPU serves the process that first called for it, and none that is forked from that.
void take_rows(const detail::RowFunctions& call, const std::string& directory,
               std::size_t parameters, const detail::EnsembleRows& rows);

}  // namespace hvi::gen
