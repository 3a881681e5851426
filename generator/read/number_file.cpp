// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/number_file.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace hvi::gen {

void refuse(const NumberFile& file, const std::string& fault, std::string help) {
    throw InputError(fmt::format("{}: {}", file.path.filename().string(), fault), file.place,
                     std::move(help));
}

std::ifstream opened(const NumberFile& file, std::string help_on_missing) {
    if (file.path.native().find('\0') != std::string::npos)
        throw InputError("a path has no character with code 0", file.place);
    std::error_code ignored;
    const auto status = std::filesystem::status(file.path, ignored);
    if (status.type() == std::filesystem::file_type::not_found)
        refuse(file, "there is no such file", std::move(help_on_missing));
    if (status.type() != std::filesystem::file_type::regular)
        refuse(file, "this is no regular file");
    std::ifstream stream(file.path, std::ios::binary);
    if (!stream) refuse(file, "the file cannot be read");
    return stream;
}

}  // namespace hvi::gen
