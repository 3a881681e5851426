// Lines of comma-separated values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/read/number_file.hpp"

namespace hvi::gen {

/// The lines of a CSV file that count, one after the other: neither blank lines nor those that
/// begin with #.
class CsvLines {
public:
    /// The place of a line in its file.
    struct Position {
        std::int64_t byte = 0;
        std::int64_t number = 1;  ///< the first line has the number 1
    };

    /// Precondition: `stream` is at the beginning of the file.
    CsvLines(NumberFile file, std::ifstream stream);

    /// Moves to the next line. Returns false at the end of the file. Throws InputError for a line
    /// of more than a megabyte.
    [[nodiscard]] bool next();

    /// Goes back, or on, to a line: next() moves to it, or to the first one behind it that counts.
    void go_to(Position position);

    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] Position position() const { return here_; }

    /// Returns the line as a source with its number in the name.
    [[nodiscard]] std::shared_ptr<const Source> source() const;

private:
    NumberFile file_;
    std::ifstream stream_;
    std::string line_;
    std::string_view text_;
    Position here_, behind_;
};

/// Returns the ranges of the cells between commas, without blanks at their ends.
[[nodiscard]] std::vector<Range> cells(std::string_view line);

}  // namespace hvi::gen
