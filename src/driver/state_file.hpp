// A state in a file, for another program on the same machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <vector>

namespace hvi::driver {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Writes numbers as doubles. Returns false where they could not be written.
template <class Vector>
[[nodiscard]] bool write_numbers(std::FILE* file, const Vector& numbers) {
    const std::vector<double> rounded(numbers.begin(), numbers.end());
    return std::fwrite(rounded.data(), sizeof(double), rounded.size(), file) == rounded.size();
}

/// Writes coordinates, then momenta, as doubles. Returns false where they could not be written.
template <class State>
[[nodiscard]] bool write_state(const char* path, const State& x) {
    File file(std::fopen(path, "wb"));
    return file != nullptr && write_numbers(file.get(), x.q) && write_numbers(file.get(), x.p) &&
           std::fclose(file.release()) == 0;
}

/// Reads `count` numbers; fewer where the file has no more, or cannot be read.
[[nodiscard]] inline std::vector<double> numbers_in(const char* path, std::size_t count) {
    std::vector<double> numbers(count);
    const File file(std::fopen(path, "rb"));
    numbers.resize(file == nullptr ? 0
                                   : std::fread(numbers.data(), sizeof(double), count, file.get()));
    return numbers;
}

}  // namespace hvi::driver
