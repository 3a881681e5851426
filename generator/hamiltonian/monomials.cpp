// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/monomials.hpp"

#include <algorithm>

#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

/// The most terms: more are a slip, or take too long.
constexpr std::size_t most_terms = 20'000;

/// The most terms of a power that is multiplied out.
constexpr double most_terms_of_power = 2000;

/// Returns an upper bound: the number of products of `exponent` terms.
double terms_of_power(std::size_t terms, unsigned exponent) {
    double count = 1;
    for (unsigned i = 1; i <= exponent; ++i)
        count *= (static_cast<double>(terms) - 1 + i) / static_cast<double>(i);
    return count;
}

/// Brings a coefficient to a normal form: equal functions of parameters become equal expressions,
/// as far as fractions of polynomials go.
ex canonical(const ex& coefficient) {
    if (GiNaC::is_a<numeric>(coefficient)) return coefficient;
    spend_on_normal_form(coefficient);
    const ex both = coefficient.numer_denom();
    return both.op(0).expand() / both.op(1).expand();
}

MonomialSum constant(const ex& value) {
    MonomialSum sum;
    add(sum, {}, value);
    return sum;
}

MonomialSum scaled(MonomialSum sum, const ex& factor) {
    if (factor.is_equal(1)) return sum;
    for (auto& [monomial, coefficient] : sum) coefficient *= factor;
    return sum;
}

MonomialSum plus(MonomialSum a, const MonomialSum& b, const ex& factor = 1) {
    for (const auto& [monomial, coefficient] : b) add(a, monomial, coefficient * factor);
    return a;
}

/// Takes the constant term out of the sum.
ex take_constant(MonomialSum& sum) {
    const auto position = sum.find({});
    if (position == sum.end()) return 0;
    ex value = position->second;
    sum.erase(position);
    return value;
}

bool is_integer(const ex& exponent) { return exponent.info(GiNaC::info_flags::integer); }

std::vector<std::pair<std::size_t, ex>> merged(const std::vector<std::pair<std::size_t, ex>>& a,
                                               const std::vector<std::pair<std::size_t, ex>>& b) {
    std::vector<std::pair<std::size_t, ex>> result;
    auto x = a.begin(), y = b.begin();
    while (x != a.end() || y != b.end()) {
        if (y == b.end() || (x != a.end() && x->first < y->first)) {
            result.push_back(*x++);
        } else if (x == a.end() || y->first < x->first) {
            result.push_back(*y++);
        } else {
            ex exponent = (x->second + y->second).expand();
            if (!exponent.is_zero()) result.emplace_back(x->first, std::move(exponent));
            ++x, ++y;
        }
    }
    return result;
}

}  // namespace

void add(MonomialSum& sum, const FunctionMonomial& monomial, const ex& coefficient) {
    spend_work();
    if (coefficient.is_zero()) return;
    const auto [position, is_new] = sum.try_emplace(monomial, coefficient);
    if (is_new) return;
    position->second += coefficient;
    if (!GiNaC::is_a<numeric>(position->second)) position->second = canonical(position->second);
    if (position->second.is_zero()) sum.erase(position);
}

bool MonomialOrder::operator()(const FunctionMonomial& a, const FunctionMonomial& b) const {
    if (a.exponential != b.exponential) return a.exponential < b.exponential;
    if (a.phase != b.phase) return a.phase < b.phase;
    if (a.is_sine != b.is_sine) return b.is_sine;
    if (a.powers.size() != b.powers.size()) return a.powers.size() < b.powers.size();
    for (std::size_t i = 0; i < a.powers.size(); ++i) {
        if (a.powers[i].first != b.powers[i].first) return a.powers[i].first < b.powers[i].first;
        const int order = a.powers[i].second.compare(b.powers[i].second);
        if (order != 0) return order < 0;
    }
    return false;
}

bool MonomialSumOrder::operator()(const MonomialSum& a, const MonomialSum& b) const {
    if (a.size() != b.size()) return a.size() < b.size();
    const MonomialOrder less;
    for (auto x = a.begin(), y = b.begin(); x != a.end(); ++x, ++y) {
        if (less(x->first, y->first)) return true;
        if (less(y->first, x->first)) return false;
        const int order = x->second.compare(y->second);
        if (order != 0) return order < 0;
    }
    return false;
}

Monomials::Monomials(const Algebra& algebra) : algebra_(algebra), arguments_(1) {
    argument_numbers_[{}] = 0;
    for (const GiNaC::symbol& symbol : algebra.variables())
        bases_.push_back({.variable = symbol, .sum = {}, .function = {}, .arguments = {}});
    for (const GiNaC::symbol& symbol : algebra.parameters())
        if (symbol.get_name() == "t")
            bases_.push_back({.variable = symbol, .sum = {}, .function = {}, .arguments = {}});
}

std::optional<MonomialSum> Monomials::sum(const ex& function) {
    try {
        return read(function);
    } catch (const TooManyTerms&) { return {}; }
}

MonomialSum Monomials::unknown(const std::string& name) {
    return opaque({.variable = {}, .sum = {}, .function = name, .arguments = {}}, 1);
}

MonomialSum Monomials::times_variable(const MonomialSum& sum, std::size_t variable) {
    spend_work(static_cast<double>(sum.size()));
    MonomialSum result;
    const std::vector<std::pair<std::size_t, ex>> factor{{variable, 1}};
    for (const auto& [monomial, coefficient] : sum) {
        FunctionMonomial shifted = monomial;
        shifted.powers = merged(monomial.powers, factor);
        result.emplace(std::move(shifted), coefficient);
    }
    return result;
}

void Monomials::check_size(const MonomialSum& sum) const {
    if (sum.size() > most_terms) throw TooManyTerms{};
}

bool Monomials::varies(const ex& expression) const {
    spend_work(0.1);
    if (GiNaC::is_a<GiNaC::symbol>(expression))
        return std::any_of(bases_.begin(), bases_.end(), [&](const MonomialBase& base) {
            return base.variable && base.variable->is_equal(GiNaC::ex_to<GiNaC::basic>(expression));
        });
    return std::any_of(expression.begin(), expression.end(),
                       [&](const ex& part) { return varies(part); });
}

MonomialSum Monomials::read(const ex& expression) {
    if (!varies(expression)) return constant(canonical(expression));
    if (GiNaC::is_a<GiNaC::add>(expression)) {
        MonomialSum sum;
        for (const ex& term : expression) sum = plus(std::move(sum), read(term));
        check_size(sum);
        return sum;
    }
    if (GiNaC::is_a<GiNaC::mul>(expression)) return read_product(expression);
    if (GiNaC::is_a<GiNaC::power>(expression))
        return read_power(expression.op(0), expression.op(1));
    if (GiNaC::is_a<GiNaC::function>(expression))
        return read_function(GiNaC::ex_to<GiNaC::function>(expression));
    for (std::size_t i = 0; i < bases_.size(); ++i)
        if (bases_[i].variable &&
            bases_[i].variable->is_equal(GiNaC::ex_to<GiNaC::basic>(expression))) {
            MonomialSum sum;
            add(sum, {.powers = {{i, 1}}, .exponential = 0, .phase = 0, .is_sine = false}, 1);
            return sum;
        }
    throw TooManyTerms{};  // nothing else has variables
}

MonomialSum Monomials::read_product(const ex& expression) {
    MonomialSum result = constant(1);
    for (const ex& factor : expression) result = product(result, read(factor));
    return result;
}

MonomialSum Monomials::read_power(const ex& base, const ex& exponent) {
    if (varies(exponent)) return exponential(product(read(exponent), read(GiNaC::log(base))));
    return raised(read(base), exponent);
}

MonomialSum Monomials::read_function(const GiNaC::function& function) {
    const std::string name = function.get_name();
    const auto argument = [&] { return read(function.op(0)); };
    const auto half_sum = [&](int sign) {
        const ex half = ex(1) / 2;
        return plus(scaled(exponential(argument()), half), exponential(scaled(argument(), -1)),
                    sign * half);
    };
    if (name == "exp") return exponential(argument());
    if (name == "sin") return wave(argument(), true);
    if (name == "cos") return wave(argument(), false);
    if (name == "tan") return product(wave(argument(), true), raised(wave(argument(), false), -1));
    if (name == "sinh") return half_sum(-1);
    if (name == "cosh") return half_sum(1);
    if (name == "tanh") return product(half_sum(-1), raised(half_sum(1), -1));
    // NOTE: if(a < b, x, y) is y, plus x - y where a < b.
    const bool is_choice = name == "if<" || name == "if<=";
    MonomialBase base{.variable = {}, .sum = {}, .function = name, .arguments = {}};
    if (is_choice) {
        base.arguments = {number_of(read(function.op(0))), number_of(read(function.op(1)))};
        const MonomialSum no = read(function.op(3));
        const MonomialSum difference = plus(read(function.op(2)), no, -1);
        return plus(product(opaque(std::move(base), 1), difference), no);
    }
    for (const ex& part : function) base.arguments.push_back(number_of(read(part)));
    return opaque(std::move(base), 1);
}

/// Returns exp(c + a): the constant c of the exponent becomes part of the coefficient.
MonomialSum Monomials::exponential(MonomialSum argument) {
    const ex factor = GiNaC::exp(take_constant(argument));
    MonomialSum result;
    add(result, {.powers = {}, .exponential = number_of(argument), .phase = 0, .is_sine = false},
        factor);
    return result;
}

/// Returns cos(c + f) = cos c cos f - sin c sin f. The phase f is signed so that its first
/// coefficient is positive if that is a number; otherwise f and -f are recognized as one by their
/// order.
MonomialSum Monomials::wave(MonomialSum argument, bool is_sine) {
    const ex constant_part = take_constant(argument);
    MonomialSum opposite;
    for (const auto& [monomial, coefficient] : argument)
        opposite.emplace(monomial, canonical(-coefficient));
    const bool turned = MonomialSumOrder()(opposite, argument);
    const std::size_t phase = number_of(turned ? opposite : argument);
    const ex c = GiNaC::cos(constant_part), s = GiNaC::sin(constant_part);
    const ex sign = turned ? -1 : 1;
    MonomialSum result;
    const FunctionMonomial cosine{.powers = {}, .exponential = 0, .phase = phase, .is_sine = false};
    const FunctionMonomial sine{.powers = {}, .exponential = 0, .phase = phase, .is_sine = true};
    add(result, cosine, is_sine ? s : c);
    if (phase != 0) add(result, sine, sign * (is_sine ? c : -s));
    return result;
}

/// Returns the product by cos a cos b = (cos(a-b) + cos(a+b))/2, and so on.
MonomialSum Monomials::product(const FunctionMonomial& a, const FunctionMonomial& b) {
    FunctionMonomial rest;
    rest.powers = merged(a.powers, b.powers);
    rest.exponential = a.exponential == 0 ? b.exponential
                       : b.exponential == 0
                           ? a.exponential
                           : number_of(plus(arguments_[a.exponential], arguments_[b.exponential]));
    MonomialSum result;
    if (a.phase == 0 || b.phase == 0) {
        rest.phase = std::max(a.phase, b.phase);
        rest.is_sine = a.is_sine || b.is_sine;
        add(result, rest, 1);
        return result;
    }
    const MonomialSum f = arguments_[a.phase], g = arguments_[b.phase];
    const bool is_sine = a.is_sine != b.is_sine;
    const auto both = [&](const MonomialSum& phase, const ex& factor) {
        for (const auto& [part, coefficient] : wave(phase, is_sine)) {
            FunctionMonomial whole = rest;
            whole.phase = part.phase;
            whole.is_sine = part.is_sine;
            add(result, whole, coefficient * factor);
        }
    };
    const ex half = ex(1) / 2;
    both(plus(f, g), a.is_sine && b.is_sine ? -half : half);
    both(plus(f, g, -1), !a.is_sine && b.is_sine ? -half : half);
    return result;
}

MonomialSum Monomials::product(const MonomialSum& a, const MonomialSum& b) {
    MonomialSum result;
    for (const auto& [x, s] : a)
        for (const auto& [y, t] : b) {
            for (const auto& [monomial, coefficient] : product(x, y))
                add(result, monomial, s * t * coefficient);
            check_size(result);
        }
    return result;
}

MonomialSum Monomials::power(const MonomialSum& base, unsigned exponent) {
    MonomialSum result = constant(1);
    for (unsigned i = 0; i < exponent; ++i) result = product(result, base);
    return result;
}

/// Raises a sum to a power. A single term c x^k exp(a) to a whole power is a single term, and so
/// are exponentials to any power. Powers below 1 of other sums are kept, up to a positive factor.
/// NOTE: the root of x^2 is not x.
MonomialSum Monomials::raised(const MonomialSum& base, const ex& exponent) {
    if (base.empty()) throw TooManyTerms{};  // a zero to a power that need not be positive
    if (exponent.info(GiNaC::info_flags::posint) && exponent < 200) {
        const auto times = static_cast<unsigned>(GiNaC::ex_to<numeric>(exponent).to_int());
        if (terms_of_power(base.size(), times) <= most_terms_of_power) return power(base, times);
    }
    const auto& [first, c] = *base.begin();
    const bool counts = is_integer(exponent);
    if (base.size() == 1 && first.phase == 0) {
        const bool one_variable = first.powers.size() == 1 && first.powers[0].second.is_equal(1) &&
                                  bases_[first.powers[0].first].variable;
        const bool splits = counts || ((first.powers.empty() || one_variable) &&
                                       c.info(GiNaC::info_flags::positive));
        if (splits) {
            FunctionMonomial raised_one;
            for (const auto& [number, power] : first.powers)
                raised_one.powers.emplace_back(number, (power * exponent).expand());
            raised_one.exponential = number_of(scaled(arguments_[first.exponential], exponent));
            MonomialSum result;
            add(result, raised_one, GiNaC::pow(c, exponent));
            return result;
        }
    }
    ex factor = counts ? c : ex(1);
    if (!counts && GiNaC::is_a<numeric>(c)) factor = GiNaC::abs(c);
    MonomialSum monic;
    for (const auto& [monomial, coefficient] : base)
        monic.emplace(monomial, canonical(coefficient / factor));
    const ex front = GiNaC::pow(factor, exponent);
    return scaled(opaque({.variable = {}, .sum = std::move(monic), .function = {}, .arguments = {}},
                         exponent),
                  front);
}

MonomialSum Monomials::opaque(MonomialBase base, const ex& exponent) {
    std::size_t number = bases_.size();
    if (base.sum) {
        number = sums_.try_emplace(*base.sum, number).first->second;
    } else {
        std::string key = base.function;
        for (const std::size_t argument : base.arguments) key += " " + std::to_string(argument);
        number = functions_.try_emplace(key, number).first->second;
    }
    if (number == bases_.size()) bases_.push_back(std::move(base));
    MonomialSum result;
    add(result, {.powers = {{number, exponent}}, .exponential = 0, .phase = 0, .is_sine = false},
        1);
    return result;
}

std::size_t Monomials::number_of(const MonomialSum& argument) {
    const auto [position, is_new] = argument_numbers_.try_emplace(argument, arguments_.size());
    if (is_new) arguments_.push_back(argument);
    return position->second;
}

}  // namespace hvi::gen
