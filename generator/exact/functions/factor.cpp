// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/factor.hpp"

#include <algorithm>

#include "generator/exact/functions/elementary.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/expr/functions.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

bool same_line(const LinearPower& left, const LinearPower& right) {
    return left.sign == right.sign && are_equal(left.offset, right.offset);
}

bool same_kind(const LinearPower& left, const LinearPower& right) {
    return left.exponent == right.exponent && left.logs == right.logs && same_line(left, right);
}

bool same_kind(const Pole& left, const Pole& right) {
    return left.order == right.order &&
           std::equal(left.polynomial.begin(), left.polynomial.end(), right.polynomial.begin(),
                      right.polynomial.end(), are_equal);
}

bool same_kind(const Power& left, const Power& right) {
    return left.exponent == right.exponent && known_same(left.base, right.base);
}

bool same_kind(const Call& left, const Call& right) {
    return left.name == right.name && known_same(left.argument, right.argument);
}

bool same_kind(const Product& left, const Product& right) {
    return std::is_permutation(
        left.factors.begin(), left.factors.end(), right.factors.begin(), right.factors.end(),
        [](const FactorPointer& a, const FactorPointer& b) { return a == b || same(*a, *b); });
}

/// Returns the coefficients of (x + y)^n by powers of y: binomial(n, j) x^(n-j).
std::vector<Number> binomial_coefficients(unsigned n, const Number& x) {
    std::vector<Number> result(n + 1);
    Number choose(1);
    for (unsigned j = 0; j <= n; ++j) {
        result[j] = choose * power(x, n - j);
        choose = choose * Number(static_cast<long>(n - j)) / Number(static_cast<long>(j) + 1);
    }
    return result;
}

ExactTerm with(const ExactTerm& term, const Number& coefficient, unsigned power,
               FactorPointer factor) {
    ExactTerm result = term;
    result.coefficient = term.coefficient * coefficient;
    result.power = power;
    result.factor = std::move(factor);
    return result;
}

/// Returns tau^k L^n multiplied out.
std::vector<ExactTerm> polynomial_terms(const ExactTerm& term, const LinearPower& factor) {
    std::vector<ExactTerm> result;
    unsigned j = 0;
    for (const Number& coefficient :
         binomial_coefficients(static_cast<unsigned>(factor.exponent.above), factor.offset)) {
        const Number sign(factor.sign < 0 && j % 2 == 1 ? -1 : 1);
        result.push_back(with(term, sign * coefficient, term.power + j, nullptr));
        ++j;
    }
    return result;
}

/// Returns the terms with tau^k = sign^k (L - offset)^k expanded.
std::vector<ExactTerm> normal_terms(const ExactTerm& term, const LinearPower& factor) {
    if (factor.is_polynomial()) return polynomial_terms(term, factor);
    if (term.power == 0) return {term};
    const Number sign(factor.sign < 0 && term.power % 2 == 1 ? -1 : 1);
    std::vector<ExactTerm> result;
    long j = 0;
    for (const Number& coefficient : binomial_coefficients(term.power, -factor.offset)) {
        LinearPower next = factor;
        next.exponent = factor.exponent + Ratio{j++, 1};
        const ExactTerm part = with(term, sign * coefficient, 0, make_factor(next));
        if (next.is_polynomial()) {
            for (const ExactTerm& monomial : polynomial_terms(part, next)) {
                result.push_back(monomial);
            }
        } else {
            result.push_back(part);
        }
    }
    return result;
}

/// Returns the terms with tau^k = sum_i r_i p^i, deg r_i < deg p, and so tau^k/p^order = sum_i
/// r_i/p^(order - i).
std::vector<ExactTerm> normal_terms(const ExactTerm& term, const Pole& factor) {
    if (term.power + 1 < factor.polynomial.size()) return {term};
    NumberPolynomial rest(term.power + 1);
    rest.back() = Number(1);
    std::vector<ExactTerm> result;
    for (unsigned order = factor.order;; --order) {
        const bool below = order > 0;
        Division step{{}, rest};
        if (below) step = divide(rest, factor.polynomial);
        const FactorPointer over = below ? make_factor(Pole{factor.polynomial, order}) : nullptr;
        for (std::size_t i = 0; i < step.remainder.size(); ++i) {
            result.push_back(with(term, step.remainder[i], static_cast<unsigned>(i), over));
        }
        rest = step.quotient;
        if (!below || rest.empty()) return result;
    }
}

}  // namespace

bool are_equal(const Number& left, const Number& right) { return (left - right).is_zero(); }

std::optional<Pole> as_pole(const Factor& factor) {
    if (const auto* pole = std::get_if<Pole>(&factor.what)) return *pole;
    const auto* linear = std::get_if<LinearPower>(&factor.what);
    if (linear == nullptr || linear->logs != 0 || !linear->exponent.is_integer()) return {};
    if (linear->exponent.above >= 0) return {};
    return Pole{linear->line(), static_cast<unsigned>(-linear->exponent.above)};
}

namespace {

/// Returns 1/(f g) = u/g + v/f for coprime f and g with u f + v g = 1.
std::optional<ExactFunction> partial_fractions(const FactorPointer& left,
                                               const FactorPointer& right) {
    const auto a = as_pole(*left);
    const auto b = as_pole(*right);
    if (!a || !b) return std::nullopt;
    const NumberPolynomial f = power_of(a->polynomial, a->order);
    const NumberPolynomial g = power_of(b->polynomial, b->order);
    const auto coefficients = bezout(f, g);
    if (!coefficients) return std::nullopt;
    return ExactFunction(coefficients->u) * ExactFunction(right) +
           ExactFunction(coefficients->v) * ExactFunction(left);
}

/// Returns the product of two factors where it has a simpler form than Product.
std::optional<ExactFunction> combined(const FactorPointer& left, const FactorPointer& right) {
    if (left->what.index() == right->what.index()) {
        if (const auto* a = std::get_if<LinearPower>(&left->what)) {
            const auto& b = std::get<LinearPower>(right->what);
            if (same_line(*a, b)) {
                return ExactFunction(make_factor(
                    LinearPower{a->offset, a->sign, a->exponent + b.exponent, a->logs + b.logs}));
            }
        }
        if (const auto* a = std::get_if<Pole>(&left->what)) {
            Pole b = std::get<Pole>(right->what);
            b.order = a->order;
            if (same_kind(*a, b)) {
                b.order += std::get<Pole>(right->what).order;
                return ExactFunction(make_factor(b));
            }
        }
        if (const auto* a = std::get_if<Power>(&left->what)) {
            const auto& b = std::get<Power>(right->what);
            if (known_same(a->base, b.base)) return power_of(a->base, a->exponent + b.exponent);
        }
        if (const auto* a = std::get_if<Call>(&left->what)) {
            const auto& b = std::get<Call>(right->what);
            if (a->name == "exp" && b.name == "exp") {
                return call_of("exp", a->argument + b.argument);
            }
        }
    }
    return partial_fractions(left, right);
}

std::vector<FactorPointer> parts(const FactorPointer& factor) {
    const auto* product = std::get_if<Product>(&factor->what);
    return product != nullptr ? product->factors : std::vector{factor};
}

}  // namespace

bool same(const Factor& left, const Factor& right) {
    if (left.what.index() != right.what.index()) return false;
    return std::visit(
        [&](const auto& kind) {
            return same_kind(kind, std::get<std::decay_t<decltype(kind)>>(right.what));
        },
        left.what);
}

bool is_independent(const Factor& factor) {
    const auto* pole = std::get_if<Pole>(&factor.what);
    return std::holds_alternative<LinearPower>(factor.what) ||
           (pole != nullptr && pole->polynomial.size() == 3);
}

std::vector<ExactTerm> normal_terms(const ExactTerm& term) {
    if (const auto* linear = std::get_if<LinearPower>(&term.factor->what)) {
        return normal_terms(term, *linear);
    }
    if (const auto* pole = std::get_if<Pole>(&term.factor->what)) {
        return normal_terms(term, *pole);
    }
    const auto* call = std::get_if<Call>(&term.factor->what);
    if (call != nullptr && call->name == "exp" && !term.rate.is_zero()) {
        // exp(rate tau) exp(g) = exp(rate tau + g) becomes one exponential, since one of two may be
        // huge where the other is tiny.
        const ExactFunction exponent =
            ExactFunction(NumberPolynomial{Number(0), term.rate}) + call->argument;
        ExactTerm result = with(term, Number(1), term.power, make_factor(Call{"exp", exponent}));
        result.rate = Number(0);
        return {result};
    }
    return {term};
}

ExactFunction product_of_factors(const FactorPointer& left, const FactorPointer& right) {
    std::vector<FactorPointer> known = parts(left);
    const std::vector<FactorPointer> more = parts(right);
    ExactFunction result{Number(1)};
    for (std::size_t next = 0; next < more.size(); ++next) {
        for (std::size_t i = 0; i < known.size(); ++i) {
            const auto together = combined(known[i], more[next]);
            if (!together) continue;
            // The combined factor may combine with the others, too.
            known.erase(known.begin() + static_cast<long>(i));
            ExactFunction product = *together;
            for (const FactorPointer& factor : known) product = product * ExactFunction(factor);
            for (++next; next < more.size(); ++next) product = product * ExactFunction(more[next]);
            return product;
        }
        known.push_back(more[next]);
    }
    return ExactFunction(make_factor(Product{std::move(known)}));
}

namespace {

/// Returns whether a function is written with the opposite sign: by its leading term, if that is
/// exact.
bool is_negative(const ExactFunction& function) {
    const auto& terms = function.terms();
    const auto leading = std::max_element(
        terms.begin(), terms.end(),
        [](const ExactTerm& left, const ExactTerm& right) { return left.power < right.power; });
    return leading != terms.end() && is_exact(leading->coefficient) &&
           canonical_sign(leading->coefficient) < 0;
}

}  // namespace

ExactFunction call_of(const std::string& name, const ExactFunction& argument) {
    const auto& terms = argument.terms();
    if (name == "exp") {
        if (terms.empty()) return ExactFunction(Number(1));
        const bool is_linear = terms.size() == 1 && terms[0].is_monomial() && terms[0].power == 1;
        if (is_linear) return ExactFunction::exponential(terms[0].coefficient);
    }
    const Parity parity = find_function(name)->parity;
    if (parity != Parity::neither && is_negative(argument)) {
        const ExactFunction opposite = ExactFunction(Number(-1)) * argument;
        return ExactFunction(Number(parity == Parity::even ? 1 : -1)) *
               ExactFunction(make_factor(Call{name, opposite}));
    }
    return ExactFunction(make_factor(Call{name, argument}));
}

ExactFunction power_of(const ExactFunction& base, const Ratio& exponent) {
    if (exponent.is_integer() && exponent.above >= 0) {
        ExactFunction result{Number(1)};
        for (long i = 0; i < exponent.above; ++i) result = result * base;
        return result;
    }
    return ExactFunction(make_factor(Power{base, exponent}));
}

LinearPower line_through(const NumberPolynomial& monic, const Number& inside) {
    const int sign = value_at(monic, inside).sign() < 0 ? -1 : 1;
    return {sign < 0 ? -monic[0] : monic[0], sign, {1, 1}, 0};
}

ExactFunction partial_fraction(const NumberPolynomial& polynomial, unsigned order,
                               const Number& inside) {
    if (polynomial.size() > 2) return ExactFunction(make_factor(Pole{polynomial, order}));
    LinearPower line = line_through(polynomial, inside);
    line.exponent = {-static_cast<long>(order), 1};
    const Number sign(line.sign < 0 && order % 2 == 1 ? -1 : 1);
    return ExactFunction(sign) * ExactFunction(make_factor(line));
}

namespace {

/// Returns the number, or its enclosures alone where it has functions other than square roots: a
/// function of such a number takes long to compute with in the field, and nobody reads it.
Number without_nesting(const Number& argument) {
    const auto form = argument.has_parameters() ? std::nullopt : argument.closed_form();
    if (!form) return argument;
    bool nested = false;
    walk(*form, [&](const Expression& part) {
        nested = nested || (part.kind == Expression::Kind::call && part.name != "sqrt");
        return !nested;
    });
    if (!nested) return argument;
    return number(Real([argument](Precision bits) { return enclosure(argument, bits); }));
}

Number value_of(const LinearPower& factor, const Number& point, const Ground& ground) {
    const Number line = value_at(factor.line(), point);
    if ((factor.logs > 0 || factor.exponent.above < 0) && line.is_zero()) {
        throw MathError(factor.logs > 0 ? "log(0) is not defined" : "division by zero");
    }
    Number result = power(line, factor.exponent, ground);
    if (factor.logs > 0) result = result * power(ground.log(line), factor.logs);
    return result;
}

Number value_of(const Pole& factor, const Number& point, const Ground& /*ground*/) {
    return Number(1) / power(value_at(factor.polynomial, point), factor.order);
}

Number value_of(const Power& factor, const Number& point, const Ground& ground) {
    const Number base = factor.base.at(point, ground);
    return power(factor.exponent.is_integer() ? base : without_nesting(base), factor.exponent,
                 ground);
}

Number value_of(const Call& factor, const Number& point, const Ground& ground) {
    return elementary(factor.name, without_nesting(factor.argument.at(point, ground)), ground);
}

Number value_of(const Product& product, const Number& point, const Ground& ground) {
    Number result(1);
    for (const FactorPointer& factor : product.factors) {
        result = result * value(*factor, point, ground);
    }
    return result;
}

}  // namespace

Number value(const Factor& factor, const Number& point, const Ground& ground) {
    return std::visit([&](const auto& kind) { return value_of(kind, point, ground); }, factor.what);
}

}  // namespace hvi::gen
