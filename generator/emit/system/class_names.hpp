// Names of the class System in C++: of parameters, constants and members, of elements and sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/emit/system/kernel_code.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Values that are made of parameters: numbers, or of a type `Constant` that the class is given,
/// which is a number or has one for each trajectory. On a device they are numbers, and constants
/// stand in functions.
enum class Constants { are_numbers, are_of_template, are_of_device };

/// Names of values that evaluations are given. Constants are k1, k2, ..., and values made of
/// parameters are c1_, c2_, ..., which the constructor computes; sizes are members, `N_`.
class ClassNames {
public:
    ClassNames(const System& system, Constants constants);

    /// Gives an input of the constructor a name.
    void add_input(Node node, std::string name) { inputs_[node] = std::move(name); }

    /// Returns the names of all values that a kernel is given; `locals` has the names of variables.
    /// Names values that have no name yet.
    [[nodiscard]] NodeNames given(const Kernel& kernel, const NodeNames& locals);

    /// Returns the names with each member converted to the type `value`, unless it is a number.
    [[nodiscard]] NodeNames converted(NodeNames names, std::string_view value) const;

    /// Returns the names with each member and each constant converted to the type `value`.
    [[nodiscard]] NodeNames all_converted(NodeNames names, std::string_view value) const;

    /// Returns names for a kernel of the constructor, where parameters stand for members.
    [[nodiscard]] NodeNames given_inputs(const Kernel& kernel);

    /// Returns whether the constructor reads one of its inputs.
    [[nodiscard]] bool uses_inputs() const;

    /// Writes `c1_ = ...;`, with functions of the namespace `library`.
    void write_setup(Writer& writer, std::string_view library);

    /// Writes `c1_.set(lane, one.c1_);`.
    void write_copy_to_lane(Writer& writer) const;

    /// Returns whether a value is made of parameters.
    [[nodiscard]] bool has_members() const { return !members_.empty(); }

    /// Writes the members and constants.
    void write_data(Writer& writer) const;

    // ---- sums with loops ----

    /// Returns the name of an index, `i`; where the code has that name already, `i_1`.
    [[nodiscard]] std::string index(const std::string& name) const;

    /// Returns a whole number of sizes and indices, in parentheses where a factor needs them.
    [[nodiscard]] std::string whole(const AffineForm& form) const;

    /// Returns how many values an index takes: `hvi::detail::count_of(1, N_)`.
    [[nodiscard]] std::string count(const LoopRange& range) const;

    /// Returns how many elements a family has.
    [[nodiscard]] std::string count(const SystemFamily& family) const;

    /// Returns the place of an element among those of its kind: `x_at_ + i`.
    [[nodiscard]] std::string place(const Access& access) const;

    /// Returns the place with these indices, each in parentheses where it is a sum.
    [[nodiscard]] static std::string place(const SystemFamily& family,
                                           const std::vector<std::string>& indices);

    /// Returns the array that an element is in: `q`, `p`, or that of a table.
    [[nodiscard]] std::string array(const Access& access) const;

private:
    /// Returns the computation of the members.
    [[nodiscard]] Kernel setup() const;
    void name_constants(const Kernel& kernel);

    const System& system_;
    const Graph& graph_;
    Constants constants_of_;
    NodeNames inputs_;  ///< names of parameters and sizes, in the constructor
    NodeNames names_;   ///< names of constants and members
    std::vector<Node> members_, constants_;
};

/// Returns a whole number of sizes and indices in C++, in parentheses where a factor needs them;
/// `called` gives the names of sizes and indices.
[[nodiscard]] std::string
whole_number(const AffineForm& form, const std::function<std::string(const std::string&)>& called);

/// Returns names of variables as components of vectors, `q[0]`, and of the time.
[[nodiscard]] NodeNames variable_names(const System& system);

/// Returns the member of Parameters; with an underscore it is the member of System.
[[nodiscard]] std::string member_of(const std::string& name);

}  // namespace hvi::gen
