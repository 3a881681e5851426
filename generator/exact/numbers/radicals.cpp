// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/radicals.hpp"

#include <utility>

namespace hvi::gen {

namespace {

std::size_t length(const Radicals& radicals) {
    std::size_t sum = radicals.factor.text().size();
    for (const Expression& radical : radicals.factors) sum += to_text(radical).size() + 1;
    return sum;
}

/// Multiplies by sqrt(radicand), squares taken out.
void append_root(Radicals& radicals, const Element& radicand) {
    const Simplified root = simplified_root(radicand);
    radicals.factor *= root.factor;
    if (root.radicand.is_integer(1)) return;
    radicals.factors.push_back(Expression::call("sqrt", {closed_form(root.radicand)}));
}

}  // namespace

Radicals radicals(const Monomial& monomial, const Field* field) {
    if (monomial.empty()) return {};
    Radicals separate;
    Element rational(1);
    Element all(1);
    for (std::size_t i = 0; i < monomial.size(); ++i) {
        if (monomial[i] == 0 || field->algebraic(i).kind != Algebraic::Kind::root) continue;
        const Algebraic& generator = field->algebraic(i);
        all = all * generator.reduced;
        if (generator.reduced.is_rational()) {
            rational = rational * generator.reduced;
        } else {
            separate.factors.push_back(generator.form);
        }
    }
    if (all.is_rational()) {
        Radicals single;
        append_root(single, all);
        return single;
    }
    std::vector<Expression> nested = std::move(separate.factors);
    separate.factors.clear();
    append_root(separate, rational);
    separate.factors.insert(separate.factors.end(), nested.begin(), nested.end());
    if (has_parameters(all)) return separate;
    Radicals single;
    append_root(single, all);
    return length(single) < length(separate) ? single : separate;
}

}  // namespace hvi::gen
