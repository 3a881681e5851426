// JSON with the place of every word, and numbers as they are written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "generator/support/error.hpp"

namespace hvi::gen {

struct JsonMember;

/// A value of JSON and where it stands in the file.
struct JsonValue {
    enum class Kind { null, boolean, number, text, array, object };

    Kind kind = Kind::null;
    std::string text;                 ///< a text without quotes and escapes, a number as written
    std::vector<JsonValue> items;     ///< items of an array
    std::vector<JsonMember> members;  ///< members of an object, in the order of the file
    Range range;

    [[nodiscard]] bool is(Kind other) const { return kind == other; }
    /// Returns the value of a member, or null.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
};

/// A member of an object.
struct JsonMember {
    std::string key;
    Range range;  ///< the range of the key
    JsonValue value;
};

/// A JSON file that knows the place of each of its words.
class JsonFile {
public:
    /// Limits of a file: its deepest nesting, and its number of values. NOTE: an entry of a tableau
    /// takes four values, so that the five matrices of 64 stages that `tableau` writes take 82
    /// thousand.
    static constexpr std::size_t most_depth = 32;
    static constexpr std::size_t most_values = 300'000;

    /// Throws InputError with the line of the file for text that is no JSON (RFC 8259) in UTF-8
    /// without a byte order mark, for two members of one name in an object, and beyond the limits.
    explicit JsonFile(Source file);

    [[nodiscard]] const JsonValue& root() const { return root_; }
    [[nodiscard]] const std::string& name() const { return file_.name; }

    /// Returns a place in the file, under the name `FILE:LINE`.
    [[nodiscard]] Place place(Range range) const;

    /// Returns a text that stands at this place, under the name `FILE:LINE`.
    [[nodiscard]] std::shared_ptr<const Source> source(Range range, std::string text) const;

private:
    [[nodiscard]] std::size_t line_of(std::size_t byte) const;

    Source file_;
    std::vector<std::size_t> lines_;  ///< the byte at which each line begins
    JsonValue root_;
};

}  // namespace hvi::gen
