// What things of a system with loops are called in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/emit/system/given_names.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Names of elements and of whole numbers too; sizes are members of System, `N_`.
class LoopNames : public GivenNames {
public:
    explicit LoopNames(const System& system);

    /// `i`; of an index that is called like something else in the code, `i_1`.
    [[nodiscard]] std::string index(const std::string& name) const;

    /// A whole number of sizes and indices, as a factor of another where it is one.
    [[nodiscard]] std::string whole(const AffineForm& form) const;

    /// `hvi::detail::count_of(1, N_)`: how many values an index takes.
    [[nodiscard]] std::string count(const LoopRange& range) const;

    /// How many elements a family has.
    [[nodiscard]] std::string count(const SystemFamily& family) const;

    /// `x_at_ + i`: the place of an element among those of its kind.
    [[nodiscard]] std::string place(const Access& access) const;

    /// The array that it is in: `q`, `p`, or that of a table.
    [[nodiscard]] std::string array(const Access& access) const;

private:
    const System& system_;
};

/// The member of Parameters, or of System with an underscore.
[[nodiscard]] std::string member_of(const std::string& name);

}  // namespace hvi::gen
