// Errors of passages of the pericentre in Kepler's problem. Their exact ends are known.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/edges/program.hpp"
#include "generator/exact/methods/composed_method.hpp"

namespace hvi::gen {

/// The passage from true anomaly -pi/2 to pi/2 on the ellipse with half axis 1, mu = 1: from the
/// point (0, -l) beside the centre to (0, l), where l = 1 - e^2. The motion is near the pericentre
/// all the time, and in units of l and l^(3/2) nearly equal for all e near 1.
class Passage {
public:
    /// Precondition: 0 < e < 1.
    explicit Passage(double e);

    /// Return (x, y, px, py).
    [[nodiscard]] std::vector<double> begin() const;
    [[nodiscard]] std::vector<double> end() const;
    [[nodiscard]] double time() const { return time_; }

    /// Returns the largest component of `state` - end(), in units of l and l^(-1/2).
    [[nodiscard]] double error(const std::vector<double>& state) const;

private:
    double e_, l_, time_;
};

/// Returns a bound of round-off for a passage of `steps` steps with `parts` parts each. In these
/// units the row sums of the derivative of the exact flow between two points of a passage are at
/// most 15 for e from 1/2 on (14.3 at e = 1/2, 13.8 as e -> 1). Each part is allowed four units of
/// rounding.
[[nodiscard]] double passage_rounding(long steps, std::size_t parts);

/// The errors of N = 4, 8, ... steps of a passage, up to round-off.
struct Refinement {
    std::size_t parts = 1;     ///< parts of a step
    std::string failure = {};  ///< the failure of a run, or a status; else empty
    std::vector<std::pair<double, double>> errors = {};  ///< by N
};

/// Refines the passage from `start` with these `values` of parameters. `relative` converts an end
/// to the state that error() takes. Steps that are too large may be refused.
[[nodiscard]] Refinement
refined(const Passage& passage, const EdgeProgram& program, std::size_t parts,
        const std::vector<double>& start, const std::vector<double>& values,
        const std::function<std::vector<double>(const std::vector<double>&)>& relative);

/// The order of a method for a quadratic T.
struct KnownOrder {
    int order = 0;
    bool is_at_least = false;  ///< higher orders were not checked
};

/// Returns the order by the exact conditions, up to 8. For a composition, returns the order of the
/// literature where that is higher.
[[nodiscard]] KnownOrder known_order(const ExactMethod& method);

/// Checks that the errors fall like N^-order.
[[nodiscard]] EdgeCheck order_check(const std::string& method, const KnownOrder& known,
                                    const std::string& scene, const std::string& what,
                                    const Refinement& refinement);

}  // namespace hvi::gen
