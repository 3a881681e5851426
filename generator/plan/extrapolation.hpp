// Extrapolation of slopes from the last steps to the next one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

/// Nodes and their weights.
struct Quadrature {
    NumberVector c, b;
};

/// A polynomial near to the slopes of the last steps, by least squares. It goes through them where
/// its degree is one less than their number.
struct SlopePolynomial {
    NumberVector sizes;  ///< sizes of these steps, the last one first; the next one has size 1
    std::size_t degree = 0;

    [[nodiscard]] bool is_through_all(const Quadrature& rule) const {
        return degree + 1 == sizes.size() * rule.c.size();
    }
};

/// Returns the c_j of earlier steps in the time of the next one, those of the last step first.
[[nodiscard]] NumberVector nodes_behind(const Quadrature& rule, const NumberVector& sizes);

/// Returns the N of each of the steps, that of the last one first: L_i = h b_i f_i of the next step
/// is the sum of N_ij L_j over the stages and the steps. Precondition: the nodes of the steps are
/// distinct.
[[nodiscard]] std::vector<NumberMatrix> extrapolation(const Quadrature& rule,
                                                      const SlopePolynomial& polynomial);

/// Returns the N, computed in doubles: for steps in a row the exact N would have numbers of
/// hundreds of digits, of which a header takes the first sixteen.
[[nodiscard]] std::vector<NumberMatrix> extrapolation_in_doubles(const Quadrature& rule,
                                                                 const SlopePolynomial& polynomial);

/// Returns how much the N may magnify rounding: the largest sum of |N_ij| over j and the steps.
/// Computed in doubles, since for many stages the exact N is costly and then of no use.
[[nodiscard]] double magnification(const Quadrature& rule, const SlopePolynomial& polynomial);

}  // namespace hvi::gen
