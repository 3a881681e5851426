// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/tree_conditions.hpp"

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen::conditions {

Number to_number(const RationalPolynomial& constant) {
    fmpq_t value;
    fmpq_init(value);
    fmpq_poly_get_coeff_fmpq(value, constant.get(), 0);
    Number result = number(Element::copy_of(value), nullptr);
    fmpq_clear(value);
    return result;
}

Number sum_of(NumberVector terms) {
    if (terms.empty()) { return Number(0); }
    for (; terms.size() > 1; terms.resize((terms.size() + 1) / 2)) {
        for (std::size_t i = 0; 2 * i + 1 < terms.size(); ++i) {
            terms[i] = terms[2 * i] + terms[2 * i + 1];
        }
        if (terms.size() % 2 == 1) { terms[terms.size() / 2] = terms.back(); }
    }
    return terms.front();
}

}  // namespace hvi::gen::conditions
