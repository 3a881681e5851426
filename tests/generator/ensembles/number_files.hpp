// Files of rows of numbers for tests.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include "generator/ensembles/number_rows.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/read/scratch.hpp"

namespace hvi::gen {

/// Files in a directory that is gone at the end of the test.
class NumberFiles {
public:
    [[nodiscard]] std::string path(const std::string& name) const { return scratch_.path / name; }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }

    [[nodiscard]] std::unique_ptr<NumberRows> rows(const std::string& name) const {
        return number_rows(given("--initial", path(name)));
    }

    /// Writes the file, and returns why it is refused.
    [[nodiscard]] Refusal refused(const std::string& name, const std::string& bytes) const {
        write(name, bytes);
        return refusal([&] { return rows(name); });
    }

private:
    Scratch scratch_;
};

/// Returns the bytes of a number, the lowest one first.
inline std::string low_bytes_first(std::uint64_t value, int bytes) {
    std::string result;
    for (int i = 0; i < bytes; ++i) result += static_cast<char>(value >> (8 * i) & 0xff);
    return result;
}

/// Returns an NPY file of version 1, as numpy's documentation describes it.
inline std::string npy_file(const std::string& type, const std::string& shape,
                            const std::string& data) {
    const std::string head =
        "{'descr': " + type + ", 'fortran_order': False, 'shape': " + shape + ", }\n";
    return "\x93NUMPY\x01" + std::string(1, '\0') + low_bytes_first(head.size(), 2) + head + data;
}

}  // namespace hvi::gen
