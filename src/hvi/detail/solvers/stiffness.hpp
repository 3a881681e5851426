// The stiffness of the equations of the stages.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Sets hGK = h G K, with the matrix G of second derivatives of U and the matrix K of T.
///
/// NOTE: row k of G K is K times row k of G, as K is symmetric. The factors of h^2 G K go one by
/// one, as h^2 may be too large or too small where h^2 G K is not: with H = s H_0 and h = h_0/s.
template <class Coupled, class Scalar>
void set_hGK(const Coupled& coupled, const SquareMatrix<Scalar>& G, SquareMatrix<Scalar>& hGK) {
    std::decay_t<decltype(coupled.s.at.q)> row{}, product{};
    for (std::size_t k = 0; k < G.size(); ++k) {
        for (std::size_t l = 0; l < G.size(); ++l) { at(row, l) = coupled.s.h * G(k, l); }
        coupled.system.inverse_mass(row, product);
        for (std::size_t l = 0; l < G.size(); ++l) { hGK(k, l) = at(product, l); }
    }
}

}  // namespace hvi::detail
