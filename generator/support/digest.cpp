// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/digest.hpp"

#include <charconv>
#include <cstddef>
#include <cstdint>

namespace hvi::gen {

std::string digest(std::string_view text) {
    std::uint64_t value = 0xcbf29ce484222325U;
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    constexpr std::size_t digits = 16;
    char buffer[digits];
    const auto result = std::to_chars(buffer, buffer + digits, value, 16);
    const std::string written(buffer, result.ptr);
    return std::string(digits - written.size(), '0') + written;
}

}  // namespace hvi::gen
