// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/rational_rule.hpp"

#include <algorithm>

namespace hvi::gen {

RationalMatrix moments(const RationalPolynomial& P, std::size_t size) {
    RationalMatrix H(size, size);
    RationalPolynomial power(1);
    for (std::size_t k = 0; k + 1 < 2 * size; ++k) {
        fmpq_poly_rem(power.get(), power.get(), P.get());
        fmpq_t moment;
        fmpq_init(moment);
        fmpq_set_str(moment, power.integral_over_unit_interval().c_str(), 10);
        for (std::size_t m = k < size ? 0 : k - size + 1; m <= std::min(k, size - 1); ++m) {
            fmpq_set(H.entry(m, k - m), moment);
        }
        fmpq_clear(moment);
        power = power * RationalPolynomial::variable();
    }
    return H;
}

}  // namespace hvi::gen
