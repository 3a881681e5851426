// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/one_step_method.hpp"

#include <algorithm>

#include "generator/exact/numbers/number_text.hpp"
#include "generator/ir/equal.hpp"

namespace hvi::gen {
namespace {

bool is_square(const NumberMatrix& table, std::size_t size) {
    return table.size() == size &&
           std::all_of(table.begin(), table.end(),
                       [&](const NumberVector& row) { return row.size() == size; });
}

void verify(const Composition& composition) {
    const NumberVector& steps = composition.steps;
    HVI_CHECK(!steps.empty());
    Number sum(0);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        HVI_CHECK(equal(steps[i], steps[steps.size() - 1 - i]));
        sum = sum + steps[i];
    }
    HVI_CHECK(equal(sum, 1));
}

}  // namespace

std::string dump(const OneStepMethod& method) {
    std::string result;
    if (method.composition) {
        result = "composition: " + method.composition->name + "\n";
        for (const Number& gamma : method.composition->steps) {
            result += "gamma: " + dump(gamma) + "\n";
        }
        if (method.composition->with_adjoint) { result += "every second step: of the adjoint\n"; }
    }
    return result + dump(method.tableau);
}

void verify(const OneStepMethod& method) {
    const Tableau& tableau = method.tableau;
    const std::size_t s = tableau.stages();
    HVI_CHECK(s > 0 && tableau.c.size() == s && tableau.c_tilde.size() == s);
    HVI_CHECK(is_square(tableau.A, s) && is_square(tableau.A_tilde, s));
    if (!method.composition) { return; }
    HVI_CHECK(tableau.parameters.empty());
    verify(*method.composition);
}

bool operator==(const OneStepMethod& left, const OneStepMethod& right) {
    return dump(left) == dump(right);
}

}  // namespace hvi::gen
