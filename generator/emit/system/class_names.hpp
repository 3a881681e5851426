// Names of the class System in C++: of parameters, constants and members, of elements and sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/system/kernel_code.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Names that evaluations are given. Constants are k1, k2, ..., and what is made of parameters is
/// c1_, c2_, ..., which the constructor computes; sizes are members, `N_`.
class ClassNames {
public:
    explicit ClassNames(const System& system);

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

    // ---- sums with loops ----

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

    /// The place with these indices, each in parentheses where it is a sum.
    [[nodiscard]] static std::string place(const SystemFamily& family,
                                           const std::vector<std::string>& indices);

    /// The array that it is in: `q`, `p`, or that of a table.
    [[nodiscard]] std::string array(const Access& access) const;

private:
    /// The computation of the members.
    [[nodiscard]] Kernel setup() const;
    void name_constants(const Kernel& kernel);

    const System& system_;
    const Graph& graph_;
    NodeNames inputs_;  ///< of parameters and sizes, in the constructor
    NodeNames names_;   ///< of constants and members
    std::vector<Node> members_, constants_;
};

/// A whole number of sizes and indices in C++, as a factor of another where it is one; `called`
/// gives the names of these.
[[nodiscard]] std::string
whole_number(const AffineForm& form, const std::function<std::string(const std::string&)>& called);

/// Names of variables that are numbers of vectors, `q[0]`, and of the time.
[[nodiscard]] NodeNames variable_names(const System& system);

/// The member of Parameters, or of System with an underscore.
[[nodiscard]] std::string member_of(const std::string& name);

}  // namespace hvi::gen
