// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/affine_fields.hpp"

#include <algorithm>

#include "generator/hamiltonian/normal_form.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

/// The rows of C, with d behind each.
using AffineRows = std::map<std::size_t, SparseVector>;

AffineRows rows_of(const AffineUnknowns& unknowns, const SparseVector& field) {
    AffineRows rows;
    for (const auto& [number, value] : field) {
        if (number < unknowns.dimension()) {
            rows[number][unknowns.dimension()] = value;
        } else {
            const auto [row, column] = unknowns.entry(number);
            rows[row][column] = value;
        }
    }
    return rows;
}

/// Adds sign * C1 (C2 q + d2).
void add_product(SparseVector& sum, const AffineUnknowns& unknowns, const AffineRows& a,
                 const AffineRows& b, int sign) {
    const std::size_t n = unknowns.dimension();
    for (const auto& [row, entries] : a)
        for (const auto& [middle, value] : entries) {
            const auto other = b.find(middle);
            if (middle == n || other == b.end()) continue;
            for (const auto& [column, factor] : other->second) {
                const std::size_t at = column == n ? row : unknowns.number(row, column);
                sum[at] += sign * value * factor;
            }
        }
}

SparseVector without_zeros(SparseVector vector) {
    for (auto position = vector.begin(); position != vector.end();) {
        position->second = normal_form(position->second);
        position = position->second.is_zero() ? vector.erase(position) : std::next(position);
    }
    return vector;
}

bool has_numbers_alone(const SparseVector& field) {
    return std::all_of(field.begin(), field.end(),
                       [](const auto& entry) { return GiNaC::is_a<numeric>(entry.second); });
}

/// NOTE: the sign of a greatest common divisor changes from run to run.
bool wants_other_sign(const Algebra& algebra, const ex& value) {
    if (GiNaC::is_a<numeric>(value)) return GiNaC::ex_to<numeric>(value).is_negative();
    const Expression one = algebra.written(value), other = algebra.written((-value).expand());
    const bool is_negative = one.kind == Expression::Kind::negation;
    if (is_negative != (other.kind == Expression::Kind::negation)) return is_negative;
    return precedes(other, one);
}

}  // namespace

AffineUnknowns::AffineUnknowns(std::size_t n) : n_(n), numbers_(n * n) {
    const auto add = [&](std::size_t row, std::size_t column) {
        numbers_[row * n + column] = n + entries_.size();
        entries_.emplace_back(row, column);
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) add(i, j);
    for (std::size_t i = n; i-- > 0;) add(i, i);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) add(i, j);
}

SparseVector without_denominators(const Algebra& algebra, const SparseVector& field) {
    const bool is_rational = std::all_of(field.begin(), field.end(), [](const auto& entry) {
        return entry.second.info(GiNaC::info_flags::rational_function);
    });
    if (field.empty() || !is_rational) return field;
    ex multiple = 1, divisor = 0;
    for (const auto& [number, value] : field)
        multiple = GiNaC::lcm(multiple, normal_form(value).denom());
    for (const auto& [number, value] : field)
        divisor = common_divisor(divisor, normal_form(value * multiple));
    SparseVector result;
    for (const auto& [number, value] : field)
        result[number] = normal_form(value * multiple / divisor).expand();
    if (wants_other_sign(algebra, result.rbegin()->second))
        for (auto& [number, value] : result) value = (-value).expand();
    return result;
}

bool is_translation(const AffineUnknowns& unknowns, const SparseVector& field) {
    return field.empty() || field.rbegin()->first < unknowns.dimension();
}

SparseVector poisson_bracket(const AffineUnknowns& unknowns, const SparseVector& a,
                             const SparseVector& b) {
    const AffineRows first = rows_of(unknowns, a), second = rows_of(unknowns, b);
    SparseVector result;
    add_product(result, unknowns, first, second, 1);
    add_product(result, unknowns, second, first, -1);
    return without_zeros(std::move(result));
}

bool is_rotation(const AffineUnknowns& unknowns, const SparseVector& field) {
    if (!has_numbers_alone(field)) return false;
    const AffineRows once = rows_of(unknowns, field);
    const auto times = [&](const SparseVector& other) {
        SparseVector result;
        add_product(result, unknowns, once, rows_of(unknowns, other), 1);
        return without_zeros(std::move(result));
    };
    const SparseVector cube = times(times(field));
    if (cube.size() != field.size() || cube.empty()) return false;
    const ex factor = cube.begin()->second / field.begin()->second;
    return GiNaC::ex_to<numeric>(factor).is_negative() &&
           std::all_of(field.begin(), field.end(), [&](const auto& entry) {
               const auto other = cube.find(entry.first);
               return other != cube.end() && other->second.is_equal(factor * entry.second);
           });
}

}  // namespace hvi::gen
