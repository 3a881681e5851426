// A file of numbers that the user named.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen {

struct NumberFile {
    std::filesystem::path path;
    Place place;  ///< the place of its name in the user's text, for errors
};

/// Throws InputError at the place of the name; the message begins with the name of the file.
[[noreturn]] void refuse(const NumberFile& file, const std::string& fault, std::string help = {});

/// Opens the file. Throws InputError where there is none, with this help, where it is no regular
/// file, and where it cannot be read.
[[nodiscard]] std::ifstream opened(const NumberFile& file, std::string help_on_missing = {});

}  // namespace hvi::gen
