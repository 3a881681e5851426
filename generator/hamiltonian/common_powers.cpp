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

/// The most terms that are written for a common denominator.
constexpr double most_terms = 6'000;

/// An exponent split into a whole number and a rest. A rest that is a number lies in [0, 1).
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

/// Returns the monomial with another exponent of the base.
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

using Lowest = std::map<ex, long, GiNaC::ex_is_less>;  ///< the lowest whole part for each rest

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

    /// Brings all terms to common powers; where that takes too many terms, only those that have the
    /// base. Returns whether all are.
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
    /// Returns the power of the sum that is multiplied out in a term.
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

    /// Returns an upper bound of the number of terms; without `all` the present number.
    [[nodiscard]] double size(std::optional<bool> all) const {
        const double terms = static_cast<double>(monomials_.bases()[base_].sum->size());
        double sum = 0;
        for (const MonomialSum& function : functions_)
            for (const auto& [monomial, coefficient] : function)
                sum += all ? std::pow(terms, static_cast<double>(above(monomial, *all))) : 1;
        return sum;
    }

    /// Returns whether no function was too long. NOTE: rewriting changes the form of a function,
    /// not its value.
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

/// Returns the sums that may have to be multiplied out.
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

/// NOTE: a sum has a higher number than the bases that it is made of.
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
