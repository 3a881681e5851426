// The head of an NPY file: what its numbers are.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/read/number_file.hpp"

namespace hvi::gen {

/// The bytes that an NPY file begins with.
constexpr std::string_view npy_magic = "\x93NUMPY";

/// Types of numbers that are read, all little-endian: '<f8', '<f4', '<i8', '<i4'.
enum class NpyType { f8, f4, i8, i4 };

/// A number in each element of an array.
struct NpyField {
    std::string name;
    NpyType type;
    std::size_t offset = 0;  ///< bytes of the element before it
};

struct NpyHead {
    bool has_names = false;            ///< the elements are records, each field with a name
    std::vector<NpyField> fields;      ///< of an array of numbers one field, without a name
    std::vector<std::size_t> extents;  ///< the shape of the array
    std::size_t count = 0;             ///< of elements, at least 1
    std::size_t size = 0;              ///< bytes of an element
    std::size_t begin = 0;             ///< bytes of the file before the first element
};

/// Reads the head of an NPY file (numpy.save), of any version. Throws InputError where it is none,
/// for numbers of another type, fields of several numbers, an array in Fortran's order, an empty
/// one, and one whose size is not that of the file. Precondition: `stream` is at the beginning.
[[nodiscard]] NpyHead npy_head(const NumberFile& file, std::ifstream& stream);

/// Returns the number that begins at a byte.
[[nodiscard]] std::variant<double, float, std::int64_t, std::int32_t> npy_value(NpyType type,
                                                                                const char* bytes);

}  // namespace hvi::gen
