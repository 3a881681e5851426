// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/number.hpp"

#include "generator/exact/numbers/number_value.hpp"
#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

/// Returns the field that two numbers share.
std::shared_ptr<Field> common_field(const Number& left, const Number& right) {
    return left.value().field ? left.value().field : right.value().field;
}

using BallOperation = void (*)(arb_t, const arb_t, const arb_t, slong);

/// Returns the result of an operation by enclosures. NOTE: numbers with free parameters have no
/// enclosures.
Number combine(const Number& left, const Number& right, BallOperation operation) {
    if (left.has_parameters() || right.has_parameters()) {
        throw InputError("a free parameter beside a number without closed form is not built yet",
                         {}, "give the parameter a value with --param");
    }
    return number(Real([left, right, operation](Precision bits) {
        Ball result = enclosure(left, bits);
        const Ball other = enclosure(right, bits);
        operation(result.get(), result.get(), other.get(), bits);
        return result;
    }));
}

/// Returns the result of `exact`; where that is too large, the result by enclosures. Numbers with
/// free parameters do not have these: throws TooLarge.
template <class Exact>
Number within_budget(const Number& left, const Number& right, Exact exact,
                     BallOperation operation) {
    constexpr std::size_t most_terms = 4000;  // nobody reads longer ones
    std::shared_ptr<Field> field = common_field(left, right);
    const auto has_parameters = [&] { return !field->parameters().empty(); };
    try {
        Element result = exact();
        if (field == nullptr || result.term_count() <= most_terms || has_parameters()) {
            return number(std::move(result), std::move(field));
        }
    } catch (const TooLarge&) {
        if (has_parameters()) { throw; }
    }
    return combine(left, right, operation);
}

}  // namespace

bool is_exactly(const Number& number, long integer) {
    const Element* const element = number.value().element();
    return element != nullptr && element->is_integer(integer);
}

Number::Number(long value) : Number(number(Element(value), nullptr)) {}

Number number(Element element, std::shared_ptr<Field> field) {
    return Number(std::make_shared<const Number::Value>(std::move(element), std::move(field)));
}

Number number(Real real) {
    return Number(std::make_shared<const Number::Value>(std::move(real), nullptr));
}

Ball enclosure(const Number& number, Precision bits) {
    spend_work(static_cast<double>(bits) / first_precision);
    return number.value().enclosure(bits);
}

Number operator+(const Number& left, const Number& right) {
    const Element* const a = left.value().element();
    const Element* const b = right.value().element();
    if (a != nullptr && b != nullptr) {
        return within_budget(
            left, right, [&] { return *a + *b; }, arb_add);
    }
    if (is_exactly(left, 0)) return right;
    if (is_exactly(right, 0)) return left;
    return combine(left, right, arb_add);
}

Number operator-(const Number& argument) {
    if (const Element* element = argument.value().element()) {
        return number(-*element, argument.value().field);
    }
    return number(Real([argument](Precision bits) {
        Ball result = enclosure(argument, bits);
        arb_neg(result.get(), result.get());
        return result;
    }));
}

Number operator-(const Number& left, const Number& right) {
    if (&left.value() == &right.value()) return Number(0);
    return left + -right;
}

Number operator*(const Number& left, const Number& right) {
    const Element* const a = left.value().element();
    const Element* const b = right.value().element();
    if (a != nullptr && b != nullptr) {
        return within_budget(
            left, right, [&] { return *a * *b; }, arb_mul);
    }
    if (is_exactly(left, 0) || is_exactly(right, 0)) return Number(0);
    if (is_exactly(left, 1)) return right;
    if (is_exactly(right, 1)) return left;
    return combine(left, right, arb_mul);
}

Number operator/(const Number& left, const Number& right) {
    if (right.is_zero()) throw MathError("division by zero");
    if (&left.value() == &right.value()) return Number(1);
    const Element* const a = left.value().element();
    const Element* const b = right.value().element();
    if (a != nullptr && b != nullptr) {
        return within_budget(
            left, right, [&] { return *a * right.value().inverse(); }, arb_div);
    }
    if (is_exactly(left, 0)) return Number(0);
    if (is_exactly(right, 1)) return left;
    return combine(left, right, arb_div);
}

bool Number::has_parameters() const {
    const Element* const element = value().element();
    return element != nullptr && hvi::gen::has_parameters(*element);
}

bool Number::is_zero() const {
    const Element* const element = value().element();
    if (element != nullptr && (element->is_rational() || hvi::gen::has_parameters(*element))) {
        return element->is_zero();
    }
    return sign() == 0;
}

bool Number::is_one() const { return (*this - Number(1)).is_zero(); }

std::optional<bool> Number::known_zero() const {
    constexpr Precision bits = 512;
    if (value().element() != nullptr) { return is_zero(); }
    if (enclosure(*this, bits).sign() != 0) { return false; }
    return std::nullopt;
}

int Number::sign() const {
    const Element* const element = value().element();
    if (element != nullptr && element->is_zero()) return 0;
    return refine(*this, "whether a number is zero", [](const Ball& ball) {
        return ball.sign() == 0 ? std::nullopt : std::optional(ball.sign());
    });
}

std::optional<Expression> Number::closed_form() const {
    return value().element() == nullptr ? std::nullopt : std::optional(value().closed_form());
}

std::optional<Expression> Number::expanded_form(const std::string& parameter) const {
    const Element* const element = value().element();
    if (element == nullptr) { return std::nullopt; }
    return hvi::gen::expanded_form(*element, parameter);
}

}  // namespace hvi::gen
