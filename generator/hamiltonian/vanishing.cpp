// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/vanishing.hpp"

#include <arb_mat.h>

#include <memory>
#include <string>
#include <vector>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

namespace {

/// Returns a point with a different number for each symbol, all in (0, 2): few roots and logarithms
/// fail there.
SymbolValues point(const Algebra& algebra, std::size_t number) {
    SymbolValues values;
    std::size_t above = 29 + 17 * number;
    const auto place = [&](const GiNaC::symbol& symbol) {
        above = (above * 37 + 11) % 193 + 1;
        values[symbol.get_name()] =
            ball_of_rational(std::to_string(above) + "/97", first_precision);
    };
    for (const GiNaC::symbol& symbol : algebra.parameters()) place(symbol);
    for (const GiNaC::symbol& symbol : algebra.variables()) place(symbol);
    return values;
}

constexpr std::size_t points = 4;  ///< points that are tried

bool is_refuted(const Algebra& algebra, const Expression& expression) {
    for (std::size_t number = 0; number < points; ++number) {
        try {
            const Ball value = value_at(expression, point(algebra, number), nullptr);
            if (arb_is_finite(value.get()) != 0 && arb_contains_zero(value.get()) == 0) return true;
        } catch (const MathError&) {}  // it has no value there
    }
    return false;
}

/// Throws MathError where an entry has no value.
bool is_regular_at(const SymbolValues& values, const std::vector<Expression>& entries, slong n) {
    arb_mat_t matrix;
    arb_mat_init(matrix, n, n);
    const std::unique_ptr<arb_mat_struct, void (*)(arb_mat_t)> owner(matrix, &arb_mat_clear);
    for (slong k = 0; k < n * n; ++k)
        arb_set(arb_mat_entry(matrix, k / n, k % n),
                value_at(entries[static_cast<std::size_t>(k)], values, nullptr).get());
    Ball determinant;
    arb_mat_det(determinant.get(), matrix, first_precision);
    return arb_is_finite(determinant.get()) != 0 && arb_contains_zero(determinant.get()) == 0;
}

}  // namespace

bool is_surely_regular(const Algebra& algebra, const GiNaC::matrix& matrix) {
    std::vector<Expression> entries;
    for (unsigned i = 0; i < matrix.rows(); ++i)
        for (unsigned j = 0; j < matrix.rows(); ++j)
            entries.push_back(algebra.written(matrix(i, j)));
    for (std::size_t number = 0; number < points; ++number) {
        try {
            if (is_regular_at(point(algebra, number), entries, matrix.rows())) return true;
        } catch (const MathError&) {}  // it has no value there
    }
    return false;
}

bool is_surely_not_zero(const Algebra& algebra, const GiNaC::ex& expression) {
    return is_refuted(algebra, algebra.written(expression));
}

Vanishing vanishing(const Algebra& algebra, const GiNaC::ex& expression) {
    if (expression.is_zero()) return Vanishing::proved;
    const Expression written = algebra.written(expression);
    if (is_refuted(algebra, written)) return Vanishing::refuted;
    const bool proved = normal_form(expression).is_zero() || is_proved_zero(written);
    return proved ? Vanishing::proved : Vanishing::unknown;
}

}  // namespace hvi::gen
