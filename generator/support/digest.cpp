// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/digest.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace hvi::gen {

std::string digest(std::string_view text) {
    std::uint64_t value = 0xcbf29ce484222325U;
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return fmt::format("{:016x}", value);
}

}  // namespace hvi::gen
