// The resolvent of a matrix, by polynomials.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

/// The product (I + t B)^-1 V = sum_k numerator[k] t^k / sum_k determinant[k] t^k.
struct Resolvent {
    NumberVector determinant;             ///< det(I + t B), lowest power first
    std::vector<NumberMatrix> numerator;  ///< adj(I + t B) V
};

/// Returns the resolvent by the method of Faddeev and Leverrier, which divides by integers only:
/// adj(I + t B) = sum_k N_k t^k and det(I + t B) = sum_k e_k t^k satisfy (I + t B) sum_k N_k t^k =
/// sum_k e_k t^k, and k e_k = tr(B N_(k-1)). Throws MathError when the normal forms of the entries
/// of an N_k have more than `most_terms` terms together.
[[nodiscard]] Resolvent resolvent(const NumberMatrix& B, const NumberMatrix& V,
                                  std::size_t most_terms);

}  // namespace hvi::gen
