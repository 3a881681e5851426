// Numbers that gnuplot reads from memory.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hvi::gen {

/// A file in memory with doubles in binary form. It is gone with the object.
class PlottedNumbers {
public:
    /// Throws EnvironmentError where memory is short.
    explicit PlottedNumbers(const std::vector<double>& numbers);
    ~PlottedNumbers();
    PlottedNumbers(const PlottedNumbers&) = delete;
    PlottedNumbers& operator=(const PlottedNumbers&) = delete;

    /// Returns the path for a script, in quotes.
    [[nodiscard]] std::string quoted_path() const;

private:
    int descriptor_;
};

}  // namespace hvi::gen
