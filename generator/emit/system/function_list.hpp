// A growing list of functions of the class System: arguments and bodies of each kind.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/emit/system/class_function.hpp"
#include "generator/ir/step.hpp"
#include "generator/plan/evaluations.hpp"

namespace hvi::gen {

/// Variables that a function takes as arguments.
struct Takes {
    bool q = true, p = true, time = false;
};

inline constexpr Takes no_variables{false, false};

/// Derivatives of sums, to be added up.
struct Scatter {
    using Arrays = std::vector<std::pair<std::string, bool>>;  ///< whether each is an argument
    std::string name, each;  ///< of the function, and of those for one sum before their number
    bool by_q;               ///< derivatives by q; else by conjugates
    Arrays arrays;
    bool has_time;  ///< whether the time is an argument
    std::string doc = {};
};

/// Numbers of functions of single sums: their place among all sums, or among the sums that have
/// such derivatives.
enum class Numbers { of_all, of_these };

[[nodiscard]] bool uses_any(const Kernel& kernel, const std::vector<Node>& nodes);

/// Returns the names `out[0]`, `out[1]`, ...
[[nodiscard]] std::vector<std::string> components(std::string_view letter, std::size_t count);

/// A list to which functions are added one by one.
class FunctionList {
public:
    FunctionList(const System& system, const Step& step) : system_(system), step_(step) {}

    /// Adds a function of variables, and of `others`.
    SystemFunction& add(std::string name, Takes takes, FunctionBody body,
                        std::vector<Argument> others = {}, std::string doc = "");

    /// Adds code that takes lanes where a step has lanes.
    SystemFunction& add_of_lanes(std::string name, Takes takes, StraightCode code,
                                 std::vector<Argument> others);

    /// Adds code with a result for each degree of freedom, of lanes where a step has lanes.
    SystemFunction& add_slope(std::string name, Takes takes, const Kernel& kernel);

    /// Adds code with the entries of a matrix, where there is a block of them.
    void add_block(std::string name, Takes takes, const std::optional<BlockKernel>& block);

    /// Adds a function of sums, after one function for each sum that has such derivatives.
    SystemFunction& add_scattered(const Scatter& scatter, const std::vector<SystemSum>& sums,
                                  Numbers numbers);

    /// Returns an argument of add_of_lanes(), `Values& out` or `Vector& out`.
    [[nodiscard]] std::string reference(const std::string& name) const {
        return (step_.has_lanes() ? "Values& " : "Vector& ") + name;
    }

    [[nodiscard]] std::vector<SystemFunction> all() && { return std::move(functions_); }

private:
    [[nodiscard]] std::vector<Argument> variables(Takes takes, const FunctionBody& body) const;
    void add_derivatives(const DerivativesOfSum& derivatives);

    const System& system_;
    const Step& step_;
    std::vector<SystemFunction> functions_;
};

}  // namespace hvi::gen
