// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/digest.hpp"

#include <charconv>
#include <cstddef>

namespace hvi::gen {

void Digest::add(std::string_view part) {
    for (const char c : part) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
}

std::string Digest::text() const {
    constexpr std::size_t digits = 16;
    char buffer[digits];
    const auto result = std::to_chars(buffer, buffer + digits, value_, 16);
    const std::string written(buffer, result.ptr);
    return std::string(digits - written.size(), '0') + written;
}

std::string digest(std::string_view text) {
    Digest all;
    all.add(text);
    return all.text();
}

}  // namespace hvi::gen
