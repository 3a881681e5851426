// Arithmetic of field elements in their normal form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/exact/field.hpp"
#include "generator/exact/minors.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

Field* common_field(const Element& left, const Element& right) {
    HVI_CHECK(left.field() == nullptr || right.field() == nullptr || left.field() == right.field());
    return left.field() != nullptr ? left.field() : right.field();
}

unsigned exponent(const Monomial& monomial, std::size_t index) {
    return index < monomial.size() ? monomial[index] : 0;
}

Monomial with_exponent(Monomial monomial, std::size_t index, unsigned value) {
    if (index >= monomial.size()) monomial.resize(index + 1);
    monomial[index] = value;
    while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
    return monomial;
}

Monomial product(const Monomial& left, const Monomial& right) {
    Monomial result(std::max(left.size(), right.size()));
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = exponent(left, i) + exponent(right, i);
    }
    return result;
}

/// The last generator whose relation applies to the monomial, if there is one.
std::optional<std::size_t> reducible(const Monomial& monomial, const Field* field) {
    for (std::size_t i = monomial.size(); i-- > 0;) {
        if (monomial[i] >= field->algebraic(i).degree) return i;
    }
    return std::nullopt;
}

}  // namespace

Element::Element(const RationalFunction& coefficient, Field* field) : field_(field) {
    add_term({}, coefficient);
}

Element Element::term(const Monomial& monomial, const RationalFunction& coefficient, Field* field) {
    Element result;
    result.field_ = field;
    if (const auto index = reducible(monomial, field)) {
        const Algebraic& generator = field->algebraic(*index);
        const unsigned left_over = monomial[*index] - generator.degree;
        return term(with_exponent(monomial, *index, left_over), coefficient, field) *
               generator.reduced;
    }
    result.add_term(monomial, coefficient);
    return result;
}

void Element::add_term(const Monomial& monomial, const RationalFunction& coefficient) {
    const auto [position, is_new] = terms_.try_emplace(monomial, coefficient);
    if (!is_new) position->second = position->second + coefficient;
    if (position->second.is_zero()) terms_.erase(position);
}

bool Element::is_rational() const {
    return is_zero() || (terms_.size() == 1 && terms_.begin()->first.empty() &&
                         terms_.begin()->second.is_rational());
}

GiNaC::numeric Element::rational() const {
    HVI_CHECK(is_rational());
    return is_zero() ? GiNaC::numeric(0) : terms_.begin()->second.rational();
}

Element operator+(const Element& left, const Element& right) {
    Element result = left;
    result.field_ = common_field(left, right);
    for (const auto& [monomial, coefficient] : right.terms_) result.add_term(monomial, coefficient);
    return result;
}

Element operator-(const Element& argument) {
    Element result = argument;
    for (auto& [monomial, coefficient] : result.terms_) coefficient = -coefficient;
    return result;
}

Element operator-(const Element& left, const Element& right) { return left + -right; }

Element operator*(const Element& left, const Element& right) {
    Element result;
    result.field_ = common_field(left, right);
    for (const auto& [left_monomial, left_coefficient] : left.terms_) {
        for (const auto& [right_monomial, right_coefficient] : right.terms_) {
            const Element part = Element::term(product(left_monomial, right_monomial),
                                               left_coefficient * right_coefficient, result.field_);
            for (const auto& [monomial, coefficient] : part.terms_) {
                result.add_term(monomial, coefficient);
            }
        }
    }
    return result;
}

Element power(const Element& base, unsigned exponent) {
    Element result(1);
    Element square = base;
    for (; exponent != 0; exponent /= 2) {
        if (exponent % 2 == 1) result = result * square;
        if (exponent > 1) square = square * square;
    }
    return result;
}

std::size_t Element::level() const {
    std::size_t result = 0;
    for (const auto& [monomial, coefficient] : terms_) result = std::max(result, monomial.size());
    return result;
}

std::vector<Element> Element::coefficients(std::size_t index) const {
    std::vector<Element> result(field_ == nullptr ? 1 : field_->algebraic(index).degree);
    for (const auto& [monomial, coefficient] : terms_) {
        Element& target = result.at(exponent(monomial, index));
        target.field_ = field_;
        target.add_term(with_exponent(monomial, index, 0), coefficient);
    }
    return result;
}

namespace {

/// g^index, g the algebraic generator below `level`.
Element generator_power(Field* field, std::size_t level, std::size_t index) {
    return Element::term(with_exponent({}, level - 1, static_cast<unsigned>(index)), 1, field);
}

}  // namespace

Element inverse(const Element& argument) {
    HVI_CHECK(!argument.is_zero());
    const std::size_t level = argument.level();
    Field* const field = argument.field();
    if (level == 0) return Element(argument.terms().begin()->second.inverse(), field);
    // Multiplication by the argument is a matrix over the field below its last generator g; the
    // inverse solves that matrix times it = 1. NOTE: without a division but the last: Euclid's
    // algorithm divides at each step, and its coefficients swell.
    const unsigned degree = field->algebraic(level - 1).degree;
    SquareMatrix<Element> multiplication(degree, std::vector<Element>(degree));
    for (unsigned k = 0; k < degree; ++k) {
        const auto column = (argument * generator_power(field, level, k)).coefficients(level - 1);
        for (unsigned i = 0; i < degree; ++i) multiplication[i][k] = column[i];
    }
    const auto [adjugate, norm] = by_minors(multiplication);
    if (norm.is_zero()) {
        throw MathError("cannot decide whether a number is zero", {},
                        "it is a divisor of zero in the algebraic normal form");
    }
    Element result;
    for (unsigned k = 0; k < degree; ++k) {
        result = result + adjugate[k][0] * generator_power(field, level, k);
    }
    return result * inverse(norm);
}

bool has_parameters(const Element& argument) {
    if (argument.field() == nullptr) return false;
    for (const auto& [monomial, coefficient] : argument.terms()) {
        for (std::size_t i = 0; i < monomial.size(); ++i) {
            if (monomial[i] != 0 && argument.field()->algebraic(i).is_parameter) return true;
        }
        const auto& generators = argument.field()->transcendentals();
        for (std::size_t i = 0; i < generators.size(); ++i) {
            if (generators[i].is_parameter && coefficient.contains(i)) return true;
        }
    }
    return false;
}

}  // namespace hvi::gen
