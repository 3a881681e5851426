// Reading a whole file that the user named.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <memory>
#include <string_view>
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

std::string quoted_file_name(const std::string& path) {
    std::string name = std::filesystem::path(path).filename().string();
    const auto is_plain = [](char c) {
        return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
               std::string_view("._-+:").find(c) != std::string_view::npos;
    };
    if (std::all_of(name.begin(), name.end(), is_plain)) return name;
    std::replace_if(
        name.begin(), name.end(), [&](char c) { return !is_plain(c) && c != ' '; }, '?');
    return "\"" + name + "\"";
}

}  // namespace hvi::gen
