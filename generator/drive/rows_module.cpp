// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/rows_module.hpp"

#include <new>

#include "generator/drive/library.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

const detail::RowFunctions& loaded_rows(const std::string& library) {
    return *static_cast<const detail::RowFunctions*>(
        functions_of_library(library, "hvi_rows", detail::rows_version));
}

void take_rows(const detail::RowFunctions& call, const std::string& directory,
               std::size_t parameters, const detail::EnsembleRows& rows) {
    constexpr std::size_t most_of_message = 4096;
    std::string message(most_of_message, '\0');
    switch (call.take(directory.c_str(), parameters, rows, message.data(), message.size())) {
    case detail::DrivenAnswer::ok: return;
    case detail::DrivenAnswer::out_of_memory: throw std::bad_alloc();
    case detail::DrivenAnswer::failed: break;
    }
    throw EnvironmentError(message.c_str());
}

}  // namespace hvi::gen
