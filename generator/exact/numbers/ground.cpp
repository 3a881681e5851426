// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/ground.hpp"

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

using ArbFunction = void (*)(arb_t, const arb_t, slong);

Number by_enclosure(const Number& argument, const char* name, ArbFunction function) {
    if (argument.has_parameters()) {
        throw InputError(std::string(name) +
                             " of an expression with a free parameter in this place "
                             "is not built yet",
                         {}, "give the parameter a value with --param");
    }
    return number(Real([argument, function](Precision bits) {
        Ball result = enclosure(argument, bits);
        function(result.get(), result.get(), bits);
        return result;
    }));
}

/// Returns the result of `work` in the field; empty where that is too large.
template <class Work>
auto within_budget(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const TooLarge&) { return std::nullopt; }
}

}  // namespace

Number Ground::exact(Element element) const { return number(std::move(element), field_); }

Number Ground::rational(const std::string& numerator, const std::string& denominator) const {
    return exact(Element(Rational::read(numerator) / Rational::read(denominator)));
}

Number Ground::pi() const { return exact(field_->pi()); }

Number Ground::parameter(const std::string& name) const {
    const auto known = values_.find(name);
    return known != values_.end() ? known->second : exact(field_->parameter(name));
}

void Ground::set_parameter(const std::string& name, Number value) {
    values_.insert_or_assign(name, std::move(value));
}

Number Ground::sqrt(const Number& argument) const {
    if (const Element* element = argument.value().element()) {
        const auto root = within_budget([&] { return field_->sqrt(*element); });
        if (root) return exact(*root);
    } else if (argument.sign() < 0) {
        throw MathError("the square root of a negative number is not real");
    }
    return by_enclosure(argument, "sqrt", arb_sqrtpos);
}

std::optional<Number> Ground::either_root(const Number& square) const {
    const Element* const element = square.value().element();
    if (element == nullptr) { return std::nullopt; }
    const bool has_sign = !square.has_parameters();
    if (has_sign && square.sign() < 0) { return std::nullopt; }
    const auto root = within_budget([&] {
        return has_sign ? field_->sqrt(*element)
                        : root_in_field(*element, field_->algebraic_count());
    });
    return root ? std::optional(exact(*root)) : std::nullopt;
}

std::optional<Number> Ground::new_root(const Number& square) const {
    const Element* const element = square.value().element();
    if (element == nullptr) { return std::nullopt; }
    const auto root = within_budget([&] { return field_->new_root(*element); });
    return root ? std::optional(exact(*root)) : std::nullopt;
}

Number Ground::exp(const Number& argument) const {
    if (const Element* element = argument.value().element()) {
        const auto value = within_budget([&] { return field_->exp(*element); });
        if (value) return exact(*value);
    }
    return by_enclosure(argument, "exp", arb_exp);
}

Number Ground::log(const Number& argument) const {
    if (!argument.has_parameters() && argument.sign() <= 0) {
        throw MathError("the logarithm of a number that is not positive is not real");
    }
    if (const Element* element = argument.value().element()) {
        if (const auto value = field_->log(*element)) return exact(*value);
    }
    return by_enclosure(argument, "log", arb_log);
}

Number Ground::cos(const Number& argument) const {
    if (const Element* element = argument.value().element()) {
        const auto value = within_budget([&] { return field_->cos_sin(*element); });
        if (value) return exact(value->cos);
    }
    return by_enclosure(argument, "cos", arb_cos);
}

Number Ground::sin(const Number& argument) const {
    if (const Element* element = argument.value().element()) {
        const auto value = within_budget([&] { return field_->cos_sin(*element); });
        if (value) return exact(value->sin);
    }
    return by_enclosure(argument, "sin", arb_sin);
}

Number power(const Number& base, unsigned exponent) {
    Number result(1);
    Number square = base;
    for (; exponent != 0; exponent /= 2) {
        if (exponent % 2 == 1) result = result * square;
        if (exponent > 1) square = square * square;
    }
    return result;
}

int canonical_sign(const Number& number) {
    const Element* const element = number.value().element();
    return element != nullptr ? leading_sign(*element) : number.sign();
}

}  // namespace hvi::gen
