// Converts GiNaC's expressions to ours. Order and signs depend on the expression alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <iomanip>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/hamiltonian/algebra.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

struct Term;
using Terms = std::vector<Term>;  ///< the terms of a sum; sorted, none is zero

/// An exponent with a key; equal exponents have equal keys.
struct Exponent {
    ex value;
    Terms terms;
    std::string key;
};

/// A base of a power. The first digit of the key is its kind, in this order: numbers, parameters
/// and functions of them only, variables, sums, functions.
struct Base {
    std::string key;
    Expression expression;
    std::optional<long> degree;  ///< in the variables; empty where it is no polynomial in them
};

struct Factor {
    Base base;
    Exponent exponent;
};

/// A term: coefficient * product of the factors, which are sorted.
struct Term {
    numeric coefficient = 1;
    std::vector<Factor> factors;
};

bool has_variables(const Factor& factor) {
    const auto depends = [](const Terms& terms) {
        return std::any_of(terms.begin(), terms.end(), [](const Term& term) {
            return std::any_of(term.factors.begin(), term.factors.end(), has_variables);
        });
    };
    return factor.base.degree != 0 || depends(factor.exponent.terms);
}

/// Returns the degree in the variables, capped at `most`; empty where the term is no polynomial in
/// them.
std::optional<long> degree(const Term& term) {
    constexpr long most = 1'000'000'000;
    long sum = 0;
    for (const Factor& factor : term.factors) {
        if (!has_variables(factor)) { continue; }
        const ex& exponent = factor.exponent.value;
        if (!factor.base.degree || !exponent.info(GiNaC::info_flags::nonnegint)) { return {}; }
        if (GiNaC::ex_to<numeric>(exponent) > most) { return most; }
        sum = std::min(most, sum + *factor.base.degree * GiNaC::ex_to<numeric>(exponent).to_long());
    }
    return sum;
}

/// Returns the highest degree.
std::optional<long> degree(const Terms& terms) {
    std::optional<long> highest = 0;
    for (const Term& term : terms) {
        const auto here = degree(term);
        highest = here && highest ? std::optional(std::max(*here, *highest)) : std::nullopt;
    }
    return highest;
}

std::string key(const Term& term) {
    std::string text;
    for (const Factor& factor : term.factors) {
        text += factor.base.key + factor.exponent.key + " ";
    }
    return text;
}

std::string key(const Terms& terms) {
    std::ostringstream text;
    for (const Term& term : terms) { text << term.coefficient << " " << key(term) << "+"; }
    return text.str();
}

/// Orders terms: polynomials first, by degree; then by the bases with variables, then by the rest.
auto sort_key(const Term& term) {
    const auto polynomial = degree(term);
    std::string variables;
    for (const Factor& factor : term.factors) {
        if (has_variables(factor)) { variables += factor.base.key + factor.exponent.key + " "; }
    }
    return std::tuple(!polynomial, polynomial.value_or(0), variables, key(term));
}

/// Collects equal terms, and sorts. NOTE: try_emplace moves from a term only where it is new.
Terms collected(Terms terms) {
    std::map<decltype(sort_key(terms.front())), Term> sums;
    for (Term& term : terms) {
        const auto [position, is_new] = sums.try_emplace(sort_key(term), std::move(term));
        if (!is_new) { position->second.coefficient += term.coefficient; }
    }
    Terms result;
    for (auto& [key, term] : sums) {
        if (!term.coefficient.is_zero()) { result.push_back(std::move(term)); }
    }
    return result;
}

/// Whether a sum is better written with the opposite sign in front: its leading term is negative.
/// The leading term is the first of the highest degree where there are polynomials.
bool wants_other_sign(const Terms& terms) {
    if (terms.empty()) { return false; }
    const Term* leading = &terms.front();
    for (const Term& term : terms) {
        const auto here = degree(term);
        if (here && *here > degree(*leading).value_or(0)) { leading = &term; }
    }
    return leading->coefficient.is_negative();
}

void negate(Terms& terms) {
    for (Term& term : terms) { term.coefficient = -term.coefficient; }
}

/// Returns text that sorts higher powers first, for whole numbers up to 9999.
std::string falling(const numeric& exponent) {
    const bool small = exponent.is_nonneg_integer() && exponent < 10000;
    std::ostringstream text;
    text << "^";
    if (small) {
        text << std::setw(4) << std::setfill('0') << 9999 - exponent.to_int();
    } else {
        text << exponent;
    }
    return text.str();
}

Expression whole(const numeric& number) {
    std::ostringstream digits;
    digits << GiNaC::abs(number);
    return Expression::rational(digits.str(), "1");
}

Expression size_of(const numeric& number) {
    Expression result = whole(number.numer());
    result.denominator = whole(number.denom()).numerator;
    return result;
}

Expression sum(const Terms& terms);

Base sum_base(const Terms& terms) {
    const auto highest = degree(terms);
    return {(highest == 0 ? "1~(" : "3(") + key(terms) + ")", sum(terms), highest};
}

/// Whether a power with this exponent belongs to the denominator.
bool is_below(const Exponent& exponent) {
    return std::all_of(exponent.terms.begin(), exponent.terms.end(),
                       [](const Term& term) { return term.coefficient.is_negative(); });
}

/// Returns base^exponent, or its reciprocal in a denominator.
Expression raised(const Factor& factor) {
    Terms exponent = factor.exponent.terms;
    if (is_below(factor.exponent)) { negate(exponent); }
    const Expression written = sum(exponent);
    if (written == Expression::integer(1)) { return factor.base.expression; }
    if (written == Expression::rational("1", "2")) {
        return Expression::call("sqrt", {factor.base.expression});
    }
    return Expression::power(factor.base.expression, written);
}

/// Returns the term without its sign.
Expression size(const Term& term) {
    std::vector<Expression> above, below;
    if (!GiNaC::abs(term.coefficient).is_equal(1)) { above.push_back(size_of(term.coefficient)); }
    for (const Factor& factor : term.factors) {
        (is_below(factor.exponent) ? below : above).push_back(raised(factor));
    }
    if (!below.empty()) {
        above.push_back(Expression::reciprocal(Expression::product(std::move(below))));
    }
    return Expression::product(std::move(above));
}

/// Returns the sum. It begins with a minus sign only where it must: q^2-1, not -1+q^2.
Expression sum(const Terms& terms) {
    std::vector<Expression> summands;
    for (const Term& term : terms) {
        Expression summand = size(term);
        const bool negative = term.coefficient.is_negative();
        summands.push_back(negative ? Expression::negation(std::move(summand))
                                    : std::move(summand));
    }
    const auto positive = std::find_if(terms.begin(), terms.end(), [](const Term& term) {
        return !term.coefficient.is_negative();
    });
    if (positive != terms.end()) {
        const auto first = summands.begin() + (positive - terms.begin());
        std::rotate(summands.begin(), first, first + 1);
    }
    return Expression::sum(std::move(summands));
}

class Writer {
public:
    explicit Writer(const std::map<std::string, std::string>& ranks) : ranks_(ranks) {}

    [[nodiscard]] Terms terms(const ex& expression) const;

private:
    [[nodiscard]] Term term(const ex& expression) const;
    void multiply(Term& term, const ex& power) const;
    void multiply_sum(Term& term, const ex& base, const ex& exponent) const;
    void insert(Term& term, Base base, const ex& exponent) const;
    [[nodiscard]] Base base(const ex& expression) const;
    [[nodiscard]] Base call(const ex& function) const;
    [[nodiscard]] Exponent exponent(const ex& value) const;

    const std::map<std::string, std::string>& ranks_;
};

Terms Writer::terms(const ex& expression) const {
    Terms result;
    if (GiNaC::is_a<GiNaC::add>(expression)) {
        for (const ex& summand : expression) { result.push_back(term(summand)); }
    } else {
        result.push_back(term(expression));
    }
    return collected(std::move(result));
}

Term Writer::term(const ex& expression) const {
    Term result;
    if (GiNaC::is_a<GiNaC::mul>(expression)) {
        for (const ex& factor : expression) { multiply(result, factor); }
    } else {
        multiply(result, expression);
    }
    return result;
}

/// Multiplies a term by a power. NOTE: GiNaC evaluates a power of a number unless the exponent is a
/// fraction.
void Writer::multiply(Term& term, const ex& power) const {
    const bool is_power = GiNaC::is_a<GiNaC::power>(power);
    const ex under = is_power ? power.op(0) : power;
    const ex exponent = is_power ? power.op(1) : ex(1);
    const bool counts = exponent.info(GiNaC::info_flags::integer);
    if (GiNaC::is_a<numeric>(power)) {
        HVI_CHECK(power.info(GiNaC::info_flags::rational));
        term.coefficient *= GiNaC::ex_to<numeric>(power);
    } else if (counts && GiNaC::is_a<GiNaC::add>(under)) {
        multiply_sum(term, under, exponent);
    } else if (counts && GiNaC::is_the_function<GiNaC::exp_SERIAL>(under)) {
        const ex argument = under.op(0) * exponent;
        const bool whole = argument.info(GiNaC::info_flags::integer);
        insert(term, base(GiNaC::exp(whole ? ex(1) : argument)), whole ? argument : ex(1));
    } else {
        insert(term, base(under), exponent);
    }
}

/// Multiplies a term by a power of a sum. NOTE: GiNaC's sign of the sum under a power, or in a
/// product, changes from run to run.
void Writer::multiply_sum(Term& term, const ex& base, const ex& exponent) const {
    Terms summands = terms(base);
    if (wants_other_sign(summands)) {
        negate(summands);
        if (!exponent.info(GiNaC::info_flags::even)) { term.coefficient = -term.coefficient; }
    }
    insert(term, sum_base(summands), exponent);
}

/// Multiplies a term by a power, and writes an equal base once.
void Writer::insert(Term& term, Base base, const ex& value) const {
    const auto position =
        std::lower_bound(term.factors.begin(), term.factors.end(), base.key,
                         [](const Factor& a, const std::string& b) { return a.base.key < b; });
    if (position == term.factors.end() || position->base.key != base.key) {
        term.factors.insert(position, {std::move(base), exponent(value)});
        return;
    }
    position->exponent = exponent(position->exponent.value + value);
    if (position->exponent.value.is_zero()) { term.factors.erase(position); }
}

Base Writer::base(const ex& expression) const {
    if (GiNaC::is_a<GiNaC::symbol>(expression)) {
        const std::string& name = GiNaC::ex_to<GiNaC::symbol>(expression).get_name();
        const std::string& rank = ranks_.at(name);
        return {rank, Expression::symbol(name), rank.front() == '2' ? 1 : 0};
    }
    if (expression.is_equal(GiNaC::Pi)) { return {"0pi", Expression::symbol("pi"), 0}; }
    if (GiNaC::is_a<GiNaC::function>(expression)) { return call(expression); }
    const Terms summands = terms(expression);
    if (!GiNaC::is_a<numeric>(expression)) { return sum_base(summands); }
    return {"0" + key(summands), sum(summands), 0};
}

Base Writer::call(const ex& function) const {
    if (function.is_equal(GiNaC::exp(ex(1)))) { return {"0e", Expression::symbol("e"), 0}; }
    const std::string name = GiNaC::ex_to<GiNaC::function>(function).get_name();
    HVI_CHECK(find_function(name) != nullptr);
    bool varies = false;
    std::string keys;
    std::vector<Expression> arguments;
    for (const ex& argument : function) {
        const Terms summands = terms(argument);
        varies = varies || degree(summands) != 0;
        keys += (keys.empty() ? "" : ",") + key(summands);
        arguments.push_back(sum(summands));
    }
    return {(varies ? "4" : "1~") + name + "(" + keys + ")",
            Expression::call(name, std::move(arguments)),
            varies ? std::nullopt : std::optional(0L)};
}

Exponent Writer::exponent(const ex& value) const {
    if (GiNaC::is_a<numeric>(value)) {
        return {value, terms(value), falling(GiNaC::ex_to<numeric>(value))};
    }
    Terms summands = terms(value);
    std::string text = "^(" + key(summands) + ")";
    return {value, std::move(summands), std::move(text)};
}

}  // namespace

Expression Algebra::written(const ex& expression) const {
    return sum(Writer(ranks_).terms(expression));
}

}  // namespace hvi::gen
