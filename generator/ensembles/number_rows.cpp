// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/number_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "generator/ensembles/number_formats.hpp"
#include "generator/read/npy_head.hpp"
#include "generator/support/digest.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

std::string digest_of(const NumberFile& file) {
    constexpr std::size_t block_size = 1024 * 1024;
    std::ifstream stream = opened(file);
    std::string block(block_size, '\0');
    Digest all;
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        all.add(std::string_view(block).substr(0, static_cast<std::size_t>(stream.gcount())));
    }
    return all.text();
}

/// Returns the first bytes, and goes back to the beginning.
std::string first_bytes(std::ifstream& stream, std::size_t count) {
    std::string bytes(count, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    stream.seekg(0);
    return bytes;
}

}  // namespace

NumberRows::NumberRows(const NumberFile& file, std::vector<std::string> names, std::int64_t count)
    : names_(std::move(names)), count_(count), digest_(digest_of(file)) {}

std::unique_ptr<NumberRows> number_rows(const Given& file) {
    const Progress::Stage stage("reading rows of numbers");
    const NumberFile named{file->text, whole(file)};
    std::ifstream stream = opened(named);
    const std::string begin = first_bytes(stream, hdf5_magic.size());
    if (begin == hdf5_magic) return hdf5_number_rows(named);
    if (begin.substr(0, npy_magic.size()) == npy_magic)
        return npy_number_rows(named, std::move(stream));
    return csv_number_rows(named, std::move(stream));
}

void check_names(const NumberFile& file, const std::vector<std::string>& names) {
    if (names.empty()) refuse(file, "there are no columns");
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.front().empty()) refuse(file, "a column has no name");
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) refuse(file, fmt::format("two columns have the name `{}`", *twice));
}

void refuse_changed(const NumberFile& file) {
    refuse(file, "the file has changed while it was read");
}

}  // namespace hvi::gen
