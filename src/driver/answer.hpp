// Answers of a driver to the program that has started it: lines of a key and a value.
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace hvi::driver {

/// Appends the shortest decimal that reads back as the same double.
inline void append(std::string& text, double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    text.append(buffer, result.ptr);
}

/// Writes a line to standard output, at once.
inline void say(std::string_view key, std::string_view value) {
    std::printf("%.*s %.*s\n", static_cast<int>(key.size()), key.data(),
                static_cast<int>(value.size()), value.data());
    std::fflush(stdout);
}

inline void say(std::string_view key, double value) {
    std::string text;
    append(text, value);
    say(key, text);
}

inline void say(std::string_view key, std::int64_t value) { say(key, std::to_string(value)); }

/// Reads a double; false where the text is none.
[[nodiscard]] inline bool read(std::string_view text, double& value) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

[[nodiscard]] inline bool read(std::string_view text, std::int64_t& value) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

}  // namespace hvi::driver
