// Square roots in the tower: found where they exist, adjoined where they do not.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <utility>

#include "generator/exact/numbers/field.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Returns an integer as square * rest, as far as trial division by small primes finds squares in
/// it.
std::pair<Integer, Integer> split_square(Integer integer) {
    Integer root = 1;
    for (long prime = 2; prime < 1000; ++prime) {
        const Integer square = prime * prime;
        if (integer < square) break;
        while (integer.is_multiple_of(square)) {
            integer /= square;
            root *= prime;
        }
    }
    if (fmpz_is_square(integer.get()) == 0) return {root, integer};
    Integer rest;
    fmpz_sqrt(rest.get(), integer.get());
    return {root * rest, 1};
}

/// Returns the positive rational r for which argument / r has coprime integer coefficients
/// throughout.
Rational content(const Element& argument) {
    Rational numerator;
    for (const auto& [monomial, coefficient] : argument.numerator()) {
        numerator = gcd(numerator, Rational(coefficient.content()));
    }
    return numerator / Rational(argument.denominator().content());
}

Element generator(Field& field, std::size_t index) {
    Monomial monomial(index + 1);
    monomial[index] = 1;
    return Element::product(monomial, &field);
}

Element quotient(const Element& numerator, const Element& denominator) {
    return numerator * inverse(denominator);
}

/// Returns x or -x, whichever is not negative.
std::optional<Element> positive(const Element& root) {
    if (has_parameters(root)) return std::nullopt;
    const auto root_sign = sign(root);
    if (!root_sign) return std::nullopt;
    return *root_sign < 0 ? -root : root;
}

}  // namespace

std::optional<Element> root_in_field(const Element& argument, std::size_t level) {
    if (argument.is_zero()) return argument;
    if (level == 0) {
        if (argument.level() != 0) return std::nullopt;
        // A quotient in lowest terms is a square when both parts are.
        const auto above = argument.numerator().begin()->second.square_root();
        const auto below = argument.denominator().square_root();
        if (!above || !below) { return std::nullopt; }
        return Element::quotient({{{}, *above}}, *below, argument.field());
    }
    Field& field = *argument.field();
    const Algebraic& top = field.algebraic(level - 1);
    const std::vector<Element> parts = argument.level() < level ? std::vector<Element>{argument}
                                                                : argument.coefficients(level - 1);
    const Element& a = parts.front();
    if (argument.level() < level) {
        if (auto root = root_in_field(a, level - 1)) return root;
        if (top.degree != 2) return std::nullopt;
        // a = (r g)^2 with g^2 = n
        auto root = root_in_field(quotient(a, top.reduced), level - 1);
        return root ? std::optional(*root * generator(field, level - 1)) : std::nullopt;
    }
    if (top.degree != 2) return std::nullopt;
    // a + b g = (u + v g)^2 with g^2 = n: the norm a^2 - n b^2 is a square r^2, and u^2 = (a +-
    // r)/2.
    const Element& b = parts.at(1);
    const auto norm_root = root_in_field(a * a - top.reduced * b * b, level - 1);
    if (!norm_root) return std::nullopt;
    const Element half(Rational(1) / 2);
    for (const Element& square : {(a + *norm_root) * half, (a - *norm_root) * half}) {
        const auto u = root_in_field(square, level - 1);
        if (!u || u->is_zero()) continue;
        return *u + quotient(b * half, *u) * generator(field, level - 1);
    }
    return std::nullopt;
}

Simplified simplified_root(const Element& argument) {
    // argument = (u/v) d with d primitive; u v = s^2 t: the root is s/v sqrt(t d).
    const Rational scale = content(argument);
    const auto [s, t] = split_square(scale.numerator() * scale.denominator());
    return {Rational(s) / scale.denominator(), argument * Element(t / scale)};
}

std::optional<Element> Field::sqrt(const Element& given) {
    if (given.is_zero()) return given;
    Element argument = given + Element(0, this);
    if (!hvi::gen::has_parameters(argument)) {
        const auto argument_sign = sign(argument);
        if (!argument_sign) return std::nullopt;
        if (*argument_sign < 0) throw MathError("the square root of a negative number is not real");
    }
    if (const auto root = root_in_field(argument, algebraics_.size())) return positive(*root);
    if (hvi::gen::has_parameters(argument)) return std::nullopt;

    // sqrt(a + b g) = sqrt((a+r)/2) +- sqrt((a-r)/2) where r^2 = a^2 - b^2 g^2 exists:
    // sqrt(2+sqrt(3)) is sqrt(6)/2 + sqrt(2)/2, which needs simpler generators.
    if (const std::size_t level = argument.level();
        level != 0 && algebraics_[level - 1].degree == 2) {
        const auto parts = argument.coefficients(level - 1);
        const Element norm =
            parts[0] * parts[0] - algebraics_[level - 1].reduced * parts[1] * parts[1];
        if (const auto r = root_in_field(norm, level - 1)) {
            const Element half(Rational(1) / 2);
            const auto outer = sqrt((parts[0] + *r) * half);
            const auto inner = sqrt((parts[0] - *r) * half);
            if (!outer || !inner) return std::nullopt;
            const Element same_sign = *outer + *inner;
            return (same_sign * same_sign - argument).is_zero() ? positive(same_sign)
                                                                : positive(*outer - *inner);
        }
    }
    return adjoin_root(argument);
}

std::optional<Element> Field::new_root(const Element& argument) {
    const bool is_known = root_in_field(argument, algebraics_.size()).has_value();
    return is_known ? std::nullopt : adjoin_root(argument);
}

std::optional<Element> Field::adjoin_root(const Element& argument) {
    if (algebraics_.size() >= most_generators) return std::nullopt;
    const auto [factor, radicand] = simplified_root(argument);
    Algebraic generator;
    generator.reduced = radicand;
    generator.form = Expression::call("sqrt", {closed_form(radicand)});
    generator.is_parameter = hvi::gen::has_parameters(radicand);
    generator.value = [radicand = radicand](Precision bits) {
        Ball root = enclosure(radicand, bits);
        arb_sqrtpos(root.get(), root.get(), bits);
        return root;
    };
    return adjoin(std::move(generator)) * Element(factor);
}

}  // namespace hvi::gen
