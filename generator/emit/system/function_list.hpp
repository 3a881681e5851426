// Functions of the class System as a list that grows: arguments and bodies of each kind.
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

/// Variables that a function has among its arguments.
struct Takes {
    bool q = true, p = true, time = false;
};

/// Derivatives of sums that are added up.
struct Scatter {
    std::string name, each;  ///< of the function, and of those for one sum up to their number
    std::vector<AccessSlope> SystemSum::*slopes;
    std::vector<std::pair<std::string, bool>> arrays;  ///< and whether each is an argument
    bool has_time;                                     ///< another argument
};

[[nodiscard]] bool uses_any(const Kernel& kernel, const std::vector<Node>& nodes);

/// Names `out[0]`, `out[1]`, ...
[[nodiscard]] std::vector<std::string> components(std::string_view letter, std::size_t count);

/// A list to which functions are added one by one.
class FunctionList {
public:
    FunctionList(const System& system, const Step& step) : system_(system), step_(step) {}

    /// Adds a function of variables, and of `others`.
    SystemFunction& add(std::string name, Takes takes, FunctionBody body,
                        std::vector<Argument> others = {});
    SystemFunction& add(SystemFunction function);

    /// Adds code that takes lanes where a step has some.
    SystemFunction& add_of_lanes(std::string name, Takes takes, StraightCode code,
                                 std::vector<Argument> others);

    /// Adds code with a result for each degree of freedom, of lanes where a step has some.
    SystemFunction& add_slope(std::string name, Takes takes, const Kernel& kernel);

    /// Adds code with the entries of a matrix, where these are there.
    void add_block(std::string name, Takes takes, const std::optional<BlockKernel>& block);

    /// Adds a function of sums, after one for each of them that has such derivatives.
    SystemFunction& add_scattered(const Scatter& scatter,
                                  const std::vector<const SystemSum*>& sums);

    /// Type of the vectors that add_of_lanes() takes.
    [[nodiscard]] std::string_view vector() const {
        return step_.has_lanes() ? "Values" : "Vector";
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
