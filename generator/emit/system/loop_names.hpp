// What things of a system with loops are called in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/emit/system/kernel_code.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Names of inputs, and of what is computed once: sizes are members of System, `N_`,
/// so are constants, k1, and what is made of parameters, c1.
class LoopNames {
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

    /// The names of all that a kernel is given but accesses and indices of loops, which `locals`
    /// names.
    [[nodiscard]] NodeNames given(const Kernel& kernel, const NodeNames& locals);

    /// What computes members that are made of parameters, and the names that it is given.
    [[nodiscard]] Kernel setup() const;
    [[nodiscard]] NodeNames setup_names();

    [[nodiscard]] const std::vector<Node>& members() const { return members_; }
    [[nodiscard]] const std::vector<Node>& constants() const { return constants_; }

private:
    void name_constant(Node node);

    const System& system_;
    std::map<Node, std::string> inputs_;  ///< sizes and parameters
    NodeNames names_;                     ///< of constants and members
    std::vector<Node> members_, constants_;
};

/// The member of Parameters, or of System with an underscore.
[[nodiscard]] std::string member_of(const std::string& name);

}  // namespace hvi::gen
