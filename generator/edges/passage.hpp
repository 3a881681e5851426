// Passages of the pericentre of Kepler's problem, whose ends are known, and their errors.
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

/// From true anomaly -pi/2 to pi/2 on the ellipse with half axis 1, mu = 1: from the point
/// (0, -l) beside the centre to (0, l), where l = 1 - e^2. The motion is near the pericentre all
/// the time, and in units of l and l^(3/2) nearly the same for all e near 1.
class Passage {
public:
    /// Precondition: 0 < e < 1.
    explicit Passage(double e);

    /// (x, y, px, py)
    [[nodiscard]] std::vector<double> begin() const;
    [[nodiscard]] std::vector<double> end() const;
    [[nodiscard]] double time() const { return time_; }

    /// The largest of the components of `state` - end(), in units of l and l^(-1/2).
    [[nodiscard]] double error(const std::vector<double>& state) const;

private:
    double e_, l_, time_;
};

/// What round-off may do to a passage of so many steps, with so many parts each. In these units no
/// sum over a row of the derivative of the exact flow between two points of a passage is above 15
/// for e from 1/2 on (14.3 at e = 1/2, 13.8 as e -> 1), and a part is given four units of rounding.
[[nodiscard]] double passage_rounding(long steps, std::size_t parts);

/// The errors of N = 4, 8, ... steps of a passage, up to round-off.
struct Refinement {
    std::size_t parts = 1;                               ///< of a step
    std::string failure = {};                            ///< of a run, or a status; else empty
    std::vector<std::pair<double, double>> errors = {};  ///< by N
};

/// From `start` with these `values` of parameters; `relative` makes of the end what error()
/// takes. Steps that are too large may be refused.
[[nodiscard]] Refinement
refined(const Passage& passage, const EdgeProgram& program, std::size_t parts,
        const std::vector<double>& start, const std::vector<double>& values,
        const std::function<std::vector<double>(const std::vector<double>&)>& relative);

/// The order of a method for a quadratic T.
struct KnownOrder {
    int order = 0;
    bool is_at_least = false;  ///< no more was looked for
};

/// By its exact conditions, up to 8; of a composition it is that of the literature where this is
/// more.
[[nodiscard]] KnownOrder known_order(const ExactMethod& method);

/// The case that they fall like N^-order.
[[nodiscard]] EdgeCheck order_check(const std::string& method, const KnownOrder& known,
                                    const std::string& scene, const std::string& what,
                                    const Refinement& refinement);

}  // namespace hvi::gen
