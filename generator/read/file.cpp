// Reading a whole file that the user named.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string what) {
    const auto source = std::make_shared<const Source>(Source{"file", path.string()});
    throw InputError(std::move(what), Place{source, {0, source->text.size()}});
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t limit) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        fail(path, "this is a directory where a file is wanted");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        fail(path, fmt::format("cannot open the file: {}", std::generic_category().message(errno)));
    std::string text(limit + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) fail(path, "cannot read the file");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > limit) fail(path, fmt::format("the file has more than {} KiB", limit / 1024));
    return text;
}

}  // namespace hvi::gen
