// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/tangents.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace hvi::gen {

namespace {

using Polynomial = IntegerMultivariate;

/// Returns 1 + sign t^2: the numerator of cos = (1 - t^2)/(1 + t^2), and its denominator.
Polynomial one_and_square(long sign, std::size_t t) {
    Polynomial result = Polynomial(sign) * power(Polynomial::variable(t), 2);
    result += Polynomial(1);
    return result;
}

/// A polynomial in cosines, which are variables, and in sines, which stand in monomials.
class InTangents {
public:
    explicit InTangents(const std::vector<std::size_t>& angles) : angles_(angles) {}

    void add(const Monomial& monomial, const Polynomial& coefficient, const Field* field) {
        Monomial constants = monomial;
        std::map<std::size_t, unsigned> sines;  // by the variable of the angle
        for (std::size_t i = 0; i < monomial.size(); ++i) {
            const Algebraic& generator = field->algebraic(i);
            if (!generator.is_parameter) { continue; }
            sines[generator.cosine] = std::exchange(constants[i], 0);
        }
        while (!constants.empty() && constants.back() == 0) { constants.pop_back(); }
        for (Polynomial::Term& term : coefficient.terms()) {
            terms_.push_back({constants, std::move(term), sines});
        }
    }

    /// Returns how often 1 + t^2 stands below.
    [[nodiscard]] unsigned degree(std::size_t t) const {
        unsigned degree = 0;
        for (const Summand& summand : terms_) { degree = std::max(degree, summand.degree(t)); }
        return degree;
    }

    /// Returns the numerator.
    [[nodiscard]] Element::Terms numerator() const {
        Element::Terms result;
        for (const Summand& summand : terms_) {
            Polynomial::Term term = summand.term;
            Polynomial product(1);
            for (const std::size_t t : angles_) {
                const unsigned cosines = std::exchange(term.powers[t], 0);
                const unsigned sines = summand.sines_of(t);
                const Polynomial sine = Polynomial(2) * Polynomial::variable(t);
                product = product * power(one_and_square(-1, t), cosines) * power(sine, sines) *
                          power(secant_squared(t), degree(t) - cosines - sines);
            }
            result[summand.constants] += Polynomial::of(term) * product;
        }
        std::erase_if(result, [](const auto& entry) { return entry.second.is_zero(); });
        return result;
    }

private:
    struct Summand {
        Monomial constants;
        Polynomial::Term term;
        std::map<std::size_t, unsigned> sines;

        [[nodiscard]] unsigned sines_of(std::size_t t) const {
            const auto found = sines.find(t);
            return found == sines.end() ? 0 : found->second;
        }
        [[nodiscard]] unsigned degree(std::size_t t) const { return term.powers[t] + sines_of(t); }
    };

    const std::vector<std::size_t>& angles_;
    std::vector<Summand> terms_;
};

}  // namespace

IntegerMultivariate secant_squared(std::size_t t) { return one_and_square(1, t); }

Element in_tangents(const Element& element, const std::vector<std::size_t>& angles) {
    InTangents above(angles);
    for (const auto& [monomial, coefficient] : element.numerator()) {
        above.add(monomial, coefficient, element.field());
    }
    InTangents below(angles);
    below.add({}, element.denominator(), element.field());
    Element::Terms numerator = above.numerator();
    Polynomial denominator = below.numerator().at({});
    for (const std::size_t t : angles) {
        for (auto& [constants, polynomial] : numerator) {
            polynomial = polynomial * power(secant_squared(t), below.degree(t));
        }
        denominator = denominator * power(secant_squared(t), above.degree(t));
    }
    return Element::quotient(std::move(numerator), std::move(denominator), element.field());
}

unsigned without_secants(Element::Terms& polynomials, std::size_t t) {
    for (unsigned count = 0;; ++count) {
        Element::Terms quotients;
        for (const auto& [constants, polynomial] : polynomials) {
            const auto quotient = polynomial.divided_by(secant_squared(t));
            if (!quotient) { return count; }
            quotients[constants] = *quotient;
        }
        polynomials = std::move(quotients);
    }
}

}  // namespace hvi::gen
