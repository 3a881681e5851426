// A number that identifies a text.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hvi::gen {

/// The digest of a text that comes in parts.
class Digest {
public:
    void add(std::string_view part);

    /// Returns the digest of all parts so far, as digest() has it.
    [[nodiscard]] std::string text() const;

private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// Returns sixteen hexadecimal digits, by FNV-1a. NOTE: it detects damage, but is no protection
/// against deceit.
[[nodiscard]] std::string digest(std::string_view text);

}  // namespace hvi::gen
