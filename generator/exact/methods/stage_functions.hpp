// Functions on the stages of a method, in coordinates.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

/// What (4.18) does with functions g on the stages, which have s coordinates in some basis. Sums
/// and products of these matrices that do not depend on the basis are the same as with the
/// tableau's own, for which a coordinate is a value g(c_i).
struct StageFunctions {
    NumberMatrix A, A_tilde;
    NumberVector one;   ///< the function that is 1 on every stage
    NumberVector b;     ///< b.g = sum_i b_i g(c_i)
    NumberMatrix gram;  ///< g^T gram h = sum_i b_i g(c_i) h(c_i)

    [[nodiscard]] std::size_t count() const { return b.size(); }
};

/// The basis is 1, x, ..., x^(s-1) where there is a `node_polynomial`: all is rational then,
/// whatever the nodes are. Else the values on the stages are the coordinates.
[[nodiscard]] StageFunctions stage_functions(const Tableau& tableau);

/// How many terms the normal forms of A and A~ have, as what arithmetic with them costs.
[[nodiscard]] std::size_t term_count(const StageFunctions& stages);

}  // namespace hvi::gen
