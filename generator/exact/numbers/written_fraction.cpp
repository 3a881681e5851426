// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/written_fraction.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Sorts terms: by degree, then by their powers of the generators, pi and parameters first, in the
/// order of the generators' texts. NOTE: one number has one text. So the order is not that in which
/// a derivation met the generators, and exponentials do not count in the degree, since exp(1/2) may
/// be the third power of exp(1/6).
class TermOrder {
public:
    explicit TermOrder(const Field* field) : field_(field) {
        if (field == nullptr) { return; }
        std::map<std::tuple<bool, std::string>, std::size_t> transcendentals;
        for (std::size_t i = 0; i < field->transcendentals().size(); ++i) {
            const Expression& form = field->transcendentals()[i].form;
            transcendentals.emplace(
                std::tuple(form.kind != Expression::Kind::symbol, to_text(form)), i);
        }
        for (const auto& [key, index] : transcendentals) { transcendentals_.push_back(index); }
        std::map<std::tuple<Algebraic::Kind, std::size_t, std::string>, std::size_t> algebraics;
        for (std::size_t i = 0; i < field->algebraic_count(); ++i) {
            const std::string text = to_text(field->algebraic(i).form);
            algebraics.emplace(std::tuple(field->algebraic(i).kind, text.size(), text), i);
        }
        for (const auto& [key, index] : algebraics) { algebraics_.push_back(index); }
    }

    void sort(std::vector<WrittenTerm>& terms) const {
        std::vector<std::pair<Key, WrittenTerm>> keyed;
        for (WrittenTerm& term : terms) {
            Key key = key_of(term);
            keyed.emplace_back(std::move(key), std::move(term));
        }
        std::sort(keyed.begin(), keyed.end(),
                  [](const auto& left, const auto& right) { return left.first < right.first; });
        terms.clear();
        for (auto& [key, term] : keyed) { terms.push_back(std::move(term)); }
    }

private:
    using Key = std::tuple<int, std::vector<int>, std::vector<unsigned>>;

    [[nodiscard]] Key key_of(const WrittenTerm& term) const {
        int degree = 0;
        std::vector<int> powers;
        for (const std::size_t i : transcendentals_) {
            if (!field_->transcendentals()[i].exponent) { degree -= term.powers[i]; }
            powers.push_back(-term.powers[i]);
        }
        std::vector<unsigned> monomial;
        for (const std::size_t i : algebraics_) {
            monomial.push_back(i < term.monomial.size() ? term.monomial[i] : 0);
        }
        return {degree, powers, monomial};
    }

    const Field* field_;
    std::vector<std::size_t> transcendentals_, algebraics_;
};

void append_polynomial(std::vector<WrittenTerm>& terms, const IntegerMultivariate& polynomial,
                       const Monomial& monomial, const Field* field) {
    const std::size_t count = field == nullptr ? 0 : field->transcendentals().size();
    for (IntegerMultivariate::Term term : polynomial.terms()) {
        term.powers.resize(count);
        terms.push_back(
            {std::move(term.coefficient), {term.powers.begin(), term.powers.end()}, monomial});
    }
}

/// Returns powers of a cosine generator g = cos(pi/n) as cosines of multiple angles, g^k = 2^(1-k)
/// (cos(k pi/n) + k cos((k-2) pi/n) + ...): from here on an exponent k of g stands for cos(k pi/n).
std::vector<WrittenTerm> with_multiple_angles(const std::vector<WrittenTerm>& terms,
                                              std::size_t index) {
    std::map<std::pair<std::vector<int>, Monomial>, Rational> sums;
    for (const WrittenTerm& term : terms) {
        const unsigned k = index < term.monomial.size() ? term.monomial[index] : 0;
        for (unsigned j = 0; 2 * j <= k; ++j) {
            Monomial monomial = term.monomial;
            if (k != 0) monomial[index] = k - 2 * j;
            while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
            Integer share;
            fmpz_bin_uiui(share.get(), k, j);
            if (2 * j != k) share *= 2;
            sums[{term.powers, monomial}] += term.coefficient * share / power(Rational(2), k);
        }
    }
    std::vector<WrittenTerm> result;
    for (const auto& [key, coefficient] : sums) {
        if (!coefficient.is_zero()) result.push_back({coefficient, key.first, key.second});
    }
    return result;
}

/// Makes the coefficients coprime integers, and the first one below positive.
void make_primitive(WrittenFraction& fraction) {
    Rational divisor;
    for (const auto* side : {&fraction.numerator, &fraction.denominator}) {
        for (const WrittenTerm& term : *side) divisor = gcd(divisor, term.coefficient);
    }
    if (is_negative(fraction.denominator.front())) divisor = -divisor;
    for (auto* side : {&fraction.numerator, &fraction.denominator}) {
        for (WrittenTerm& term : *side) term.coefficient /= divisor;
    }
}

}  // namespace

WrittenFraction written_fraction(const Element& argument) {
    HVI_CHECK(!argument.is_zero());
    WrittenFraction result;
    append_polynomial(result.denominator, argument.denominator(), {}, argument.field());
    for (const auto& [monomial, coefficient] : argument.numerator()) {
        append_polynomial(result.numerator, coefficient, monomial, argument.field());
    }
    for (std::size_t i = 0; i < argument.level(); ++i) {
        if (argument.field()->algebraic(i).kind == Algebraic::Kind::cosine) {
            result.numerator = with_multiple_angles(result.numerator, i);
        }
    }
    const TermOrder order(argument.field());
    order.sort(result.numerator);
    order.sort(result.denominator);
    make_primitive(result);
    return result;
}

void negate(std::vector<WrittenTerm>& terms) {
    for (WrittenTerm& term : terms) term.coefficient = -term.coefficient;
}

bool is_negative(const WrittenTerm& term) { return term.coefficient.sign() < 0; }

}  // namespace hvi::gen
