// Trajectories of an ensemble that a module takes at once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <hvi/detail/module/row_functions.hpp>

#include "generator/drive/ensemble_row.hpp"

namespace hvi::gen {

/// The data of trajectories that go at once.
struct RowBatch {
    std::vector<double> numbers;  ///< parameters and starting values of each, one after the other
    std::vector<double> h;        ///< none is 0
    std::vector<std::int64_t> steps;

    [[nodiscard]] std::size_t size() const { return h.size(); }
    void add(const std::vector<double>& of_row, double size, std::int64_t count);
};

/// Takes their steps by the functions of a module; `directory` has the files of the scene. Returns
/// nothing for those that SIGTERM has cut off. Throws as take_rows() does. Precondition: nothing is
/// wished for but columns and, where the module carries a direction along, growth.
[[nodiscard]] std::vector<std::optional<RowEnd>> take_batch(const RowWishes& wishes,
                                                            const detail::RowFunctions& call,
                                                            const std::string& directory,
                                                            const RowBatch& batch);

}  // namespace hvi::gen
