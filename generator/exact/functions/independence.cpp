// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/independence.hpp"

#include <arb_mat.h>

#include <algorithm>

#include "generator/exact/functions/ball_function.hpp"
#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

bool proved_independent(const std::vector<ExactFunction>& functions) {
    constexpr Precision bits = 1024;
    const bool enclosed =
        std::none_of(functions.begin(), functions.end(),
                     [](const ExactFunction& function) { return function.has_parameters(); });
    if (!enclosed) return false;
    const auto n = static_cast<slong>(functions.size());
    arb_mat_t values;
    arb_mat_init(values, n, n);
    for (slong j = 0; j < n; ++j) {
        const Number point = Number(2 * j + 1) / Number(2 * n);
        for (slong i = 0; i < n; ++i) {
            const auto function =
                compile(functions[static_cast<std::size_t>(i)].piece_at(point), bits);
            const Ball value = real_values(function, enclosure(point, bits));
            arb_set(arb_mat_entry(values, i, j), value.get());
        }
    }
    Ball determinant;
    arb_mat_det(determinant.get(), values, bits);
    arb_mat_clear(values);
    return determinant.sign() != 0;
}

}  // namespace hvi::gen
