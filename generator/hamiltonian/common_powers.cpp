// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "generator/hamiltonian/relations.hpp"
#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

/// Terms that one is ready to write for a common denominator.
constexpr double most_terms = 6'000;

/// An exponent as a whole number and what is left: in [0, 1) where it is a number.
struct SplitExponent {
    ex rest;
    long whole = 0;
};

SplitExponent split(const ex& exponent) {
    ex number = 0;
    if (GiNaC::is_a<numeric>(exponent)) number = exponent;
    if (GiNaC::is_a<GiNaC::add>(exponent))
        for (const ex& term : exponent)
            if (GiNaC::is_a<numeric>(term)) number += term;
    const auto& value = GiNaC::ex_to<numeric>(number);
    const long whole = std::lround(std::floor(value.to_double()));
    return {(exponent - whole).expand(), whole};
}

std::optional<SplitExponent> exponent_of(const FunctionMonomial& monomial, std::size_t base) {
    spend_work(0.1);
    for (const auto& [number, exponent] : monomial.powers)
        if (number == base) return split(exponent);
    return {};
}

/// The monomial with another exponent of the base.
FunctionMonomial with_exponent(FunctionMonomial monomial, std::size_t base, const ex& exponent) {
    auto& powers = monomial.powers;
    powers.erase(std::remove_if(powers.begin(), powers.end(),
                                [&](const auto& power) { return power.first == base; }),
                 powers.end());
    if (exponent.is_zero()) return monomial;
    const auto position = std::find_if(powers.begin(), powers.end(),
                                       [&](const auto& power) { return power.first > base; });
    powers.emplace(position, base, exponent);
    return monomial;
}

using Lowest = std::map<ex, long, GiNaC::ex_is_less>;  ///< whole part, by what is left

class CommonPowers {
public:
    CommonPowers(Monomials& monomials, std::vector<MonomialSum>& functions, std::size_t base)
        : monomials_(monomials), functions_(functions), base_(base) {
        for (const MonomialSum& function : functions)
            for (const auto& [monomial, coefficient] : function)
                if (const auto exponent = exponent_of(monomial, base)) {
                    const auto [position, is_new] =
                        lowest_.try_emplace(exponent->rest, exponent->whole);
                    if (!is_new) position->second = std::min(position->second, exponent->whole);
                }
        const auto whole = lowest_.find(0);
        if (whole != lowest_.end()) whole->second = std::min(whole->second, 0L);
    }

    /// Whether all terms are; where only some can be, those that have the base.
    [[nodiscard]] bool bring() {
        if (lowest_.empty()) return true;
        const double terms = size({}), all = size(true), some = size(false);
        if (!needs_rewriting(true)) return true;
        if (all <= std::max(most_terms, 2 * terms)) return rewrite(true);
        if (needs_rewriting(false) && some <= std::max(most_terms, 2 * terms))
            static_cast<void>(rewrite(false));
        return false;
    }

private:
    /// How often the sum is multiplied out in a term.
    [[nodiscard]] long above(const FunctionMonomial& monomial, bool all) const {
        const auto exponent = exponent_of(monomial, base_);
        if (exponent) return exponent->whole - lowest_.at(exponent->rest);
        const auto whole = lowest_.find(0);
        return all && whole != lowest_.end() ? -whole->second : 0;
    }

    [[nodiscard]] bool needs_rewriting(bool all) const {
        for (const MonomialSum& function : functions_)
            for (const auto& [monomial, coefficient] : function)
                if (above(monomial, all) > 0) return true;
        return false;
    }

    /// How many terms there would be at most; without `all` how many there are.
    [[nodiscard]] double size(std::optional<bool> all) const {
        const double terms = static_cast<double>(monomials_.bases()[base_].sum->size());
        double sum = 0;
        for (const MonomialSum& function : functions_)
            for (const auto& [monomial, coefficient] : function)
                sum += all ? std::pow(terms, static_cast<double>(above(monomial, *all))) : 1;
        return sum;
    }

    /// Whether none was too long. NOTE: each function stays what it is, however it is written.
    [[nodiscard]] bool rewrite(bool all) try {
        for (MonomialSum& function : functions_) {
            MonomialSum result;
            for (const auto& [monomial, coefficient] : function) {
                const long k = above(monomial, all);
                const auto exponent = exponent_of(monomial, base_);
                const ex rest = exponent ? exponent->rest : ex(0);
                const bool stays = !exponent && k == 0;
                const ex lowest = stays ? ex(0) : rest + lowest_.at(rest);
                MonomialSum factor;
                add(factor, with_exponent(monomial, base_, lowest), coefficient);
                for (const auto& [product, c] : monomials_.product(factor, power(k)))
                    add(result, product, c);
            }
            function = std::move(result);
        }
        return true;
    } catch (const TooManyTerms&) { return false; }

    [[nodiscard]] const MonomialSum& power(long exponent) {
        const auto [position, is_new] = powers_.try_emplace(exponent);
        const MonomialSum sum = *monomials_.bases()[base_].sum;
        if (is_new) position->second = monomials_.power(sum, static_cast<unsigned>(exponent));
        return position->second;
    }

    Monomials& monomials_;
    std::vector<MonomialSum>& functions_;
    std::size_t base_;
    Lowest lowest_;
    std::map<long, MonomialSum> powers_;
};

/// The sums of which something may have to be multiplied out.
std::set<std::size_t> with_several_powers(const Monomials& monomials,
                                          const std::vector<MonomialSum>& functions) {
    std::map<std::size_t, ex> first;
    std::set<std::size_t> result;
    for (const MonomialSum& function : functions)
        for (const auto& [monomial, coefficient] : function)
            for (const auto& [base, exponent] : monomial.powers) {
                spend_work(0.1);
                if (!monomials.bases()[base].sum) continue;
                const auto [position, is_new] = first.try_emplace(base, exponent);
                if (exponent.info(GiNaC::info_flags::integer) ||
                    (!is_new && !position->second.is_equal(exponent)))
                    result.insert(base);
            }
    return result;
}

}  // namespace

/// NOTE: what a sum is made of has lower numbers.
bool bring_to_common_powers(Monomials& monomials, std::vector<MonomialSum>& functions) {
    bool all = true;
    std::set<std::size_t> todo = with_several_powers(monomials, functions);
    for (std::size_t base = monomials.bases().size(); base-- > 0;) {
        if (todo.count(base) == 0) continue;
        all = CommonPowers(monomials, functions, base).bring() && all;
        todo = with_several_powers(monomials, functions);
    }
    return all;
}

}  // namespace hvi::gen
