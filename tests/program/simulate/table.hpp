// The table of a run, read again.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace hvi::test {

/// The numbers of a row.
inline std::vector<double> numbers_of(const std::string& row) {
    std::vector<double> numbers;
    std::istringstream stream(row);
    for (std::string cell; std::getline(stream, cell, ',');) numbers.push_back(std::stod(cell));
    return numbers;
}

}  // namespace hvi::test
