// Names for what evaluations are given besides variables: constants, and members that the
// constructor of System computes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "generator/emit/system/kernel_code.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

/// Constants are k1, k2, ..., and what is made of parameters is c1_, c2_, ...
class GivenNames {
public:
    /// `inputs`: names of parameters and sizes in the constructor.
    GivenNames(const Graph& graph, NodeNames inputs) : graph_(graph), inputs_(std::move(inputs)) {}

    /// The names of all that a kernel is given; `locals` has those of variables. Names what has
    /// none yet.
    [[nodiscard]] NodeNames given(const Kernel& kernel, const NodeNames& locals);

    /// Names for a kernel of the constructor, where parameters stand for members.
    [[nodiscard]] NodeNames given_inputs(const Kernel& kernel);

    /// Whether the constructor looks at one of its inputs.
    [[nodiscard]] bool uses_inputs() const;

    /// `c1_ = ...;`, with functions of the namespace `library`.
    void write_setup(Writer& writer, std::string_view library);

    /// The members and constants.
    void write_data(Writer& writer) const;

    [[nodiscard]] const std::vector<Node>& members() const { return members_; }

private:
    /// The computation of the members.
    [[nodiscard]] Kernel setup() const;
    void name_constants(const Kernel& kernel);

    const Graph& graph_;
    NodeNames inputs_;
    NodeNames names_;  ///< of constants and members
    std::vector<Node> members_, constants_;
};

}  // namespace hvi::gen
