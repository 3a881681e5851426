// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/one_step_method.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/numbers/number_text.hpp"
#include "generator/ir/equal.hpp"

namespace hvi::gen {
namespace {

void verify(const Tableau& tableau) {
    const std::size_t s = tableau.stages();
    HVI_CHECK(s > 0 && tableau.c.size() == s && tableau.c_tilde.size() == s);
    HVI_CHECK(is_table(tableau.A, s, s) && is_table(tableau.A_tilde, s, s));
}

void verify(const GalerkinRule& rule) {
    const std::size_t s = rule.functions(), r = rule.nodes();
    HVI_CHECK(s > 0 && r > s && rule.b.size() == r);
    HVI_CHECK(is_table(rule.Psi, s, r) && is_table(rule.A_psi, r, s));
    HVI_CHECK(is_table(rule.gram, s, s) && is_table(rule.n, r, r));
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
    return result + std::visit([](const auto& base) { return dump(base); }, method.base);
}

void verify(const OneStepMethod& method) {
    std::visit(
        [&](const auto& base) {
            verify(base);
            HVI_CHECK(!method.composition || base.parameters.empty());
        },
        method.base);
    if (method.composition) { verify(*method.composition); }
}

bool operator==(const OneStepMethod& left, const OneStepMethod& right) {
    return dump(left) == dump(right);
}

}  // namespace hvi::gen
