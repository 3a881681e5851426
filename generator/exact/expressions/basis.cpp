// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/expressions/basis.hpp"

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/expressions/spline.hpp"

namespace hvi::gen {

namespace {

/// Returns one of 1, tau, tau^2, ...
Expression monomial(long index) {
    if (index == 0) return Expression::integer(1);
    const Expression tau = Expression::symbol("tau");
    return index == 1 ? tau : Expression::power(tau, Expression::integer(index));
}

/// Returns one of 1, cos(pi*tau), sin(pi*tau), cos(2*pi*tau), ...
Expression trigonometric(long index) {
    if (index == 0) return Expression::integer(1);
    std::vector<Expression> angle{Expression::symbol("pi"), Expression::symbol("tau")};
    const long wave = (index + 1) / 2;
    if (wave > 1) angle.insert(angle.begin(), Expression::integer(wave));
    return Expression::call(index % 2 == 1 ? "cos" : "sin",
                            {Expression::product(std::move(angle))});
}

}  // namespace

std::vector<BasisFunction> basis_functions(const List& list, const std::vector<Number>& nodes,
                                           const Ground& ground) {
    const Setting setting{domain_of(nodes), spline_counts(list)};
    std::vector<BasisFunction> result;
    const auto append = [&](const Expression& form, const Item& item) {
        result.push_back(
            {form, evaluate_function(form, list.source, ground, setting), list.place(item.range)});
    };
    for (const Item& item : list.items) {
        if (const Family* family = std::get_if<Family>(&item.what)) {
            HVI_CHECK(family->name == "monomials" || family->name == "trig");
            for (long i = 0; i < family->size; ++i) {
                append(family->name == "trig" ? trigonometric(i) : monomial(i), item);
            }
        } else {
            append(std::get<Expression>(item.what), item);
        }
    }
    return result;
}

}  // namespace hvi::gen
