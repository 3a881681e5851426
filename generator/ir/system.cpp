// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/system.hpp"

#include <algorithm>

namespace hvi::gen {

bool has_linear_part(const Structure& quadratic) {
    const auto is_not_zero = [](const Scaled& slope) { return !slope.is_zero(); };
    return std::any_of(quadratic.by_q.begin(), quadratic.by_q.end(), is_not_zero) ||
           std::any_of(quadratic.by_p.begin(), quadratic.by_p.end(), is_not_zero);
}

bool is_degenerate(const Hessian& hessian) {
    return std::any_of(hessian.conjugates.begin(), hessian.conjugates.end(), [](const auto& row) {
        return std::all_of(row.begin(), row.end(), [](const Scaled& a) { return a.is_zero(); });
    });
}

std::vector<std::size_t> System::cyclic_coordinates() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < flat_coordinates(); ++i) {
        if (by_q[i].is_zero()) { result.push_back(i); }
    }
    return result;
}

bool operator==(const System& left, const System& right) { return dump(left) == dump(right); }

}  // namespace hvi::gen
