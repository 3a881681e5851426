// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/conserved.hpp"

#include <algorithm>
#include <utility>

#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr std::size_t most_in_polynomial = 8;  ///< quantities whose products are compared

/// Returns the degree in the variables; nothing where the monomial is no product of them.
std::optional<long> degree(const Monomials& monomials, const FunctionMonomial& monomial) {
    if (monomial.exponential != 0 || monomial.phase != 0) return {};
    long sum = 0;
    for (const auto& [base, exponent] : monomial.powers) {
        const auto& variable = monomials.bases()[base].variable;
        if (!variable || variable->get_name() == "t" ||
            !exponent.info(GiNaC::info_flags::nonnegint) || exponent > 2)
            return {};
        sum += GiNaC::ex_to<GiNaC::numeric>(exponent).to_long();
    }
    return sum;
}

/// Functions under the motion of H, with its derivatives.
class Motion {
public:
    explicit Motion(const Hamiltonian& hamiltonian)
        : algebra_(hamiltonian), n_(hamiltonian.degrees_of_freedom()) {
        for (const symbol& variable : algebra_.variables())
            slopes_.push_back(algebra_.derivative(algebra_.function(), variable));
    }

    [[nodiscard]] ex read(const Quantity& quantity) {
        return algebra_.read(quantity.expression, quantity.source);
    }

    [[nodiscard]] bool is_energy(const ex& I) const { return I.is_equal(algebra_.function()); }

    [[nodiscard]] ex bracket(const ex& I) const {
        ex sum;
        for (std::size_t i = 0; i < n_; ++i)
            sum += algebra_.derivative(I, q(i)) * slopes_[n_ + i] -
                   algebra_.derivative(I, p(i)) * slopes_[i];
        return sum;
    }

    [[nodiscard]] Vanishing vanishes(const ex& expression) const {
        return vanishing_by_monomials(algebra_, expression);
    }

    /// NOTE: a bracket is usually shortest when it is multiplied out, if that is not too long.
    [[nodiscard]] Expression written(const ex& expression) const {
        return algebra_.written(multiplied_out(expression));
    }

    /// Returns the quadratic term of I; nothing unless the third derivatives vanish and the second
    /// have no variables.
    [[nodiscard]] std::optional<QuantityFinding::Quadratic> quadratic(const ex& I) const {
        Monomials monomials(algebra_);
        const auto sum = monomials.sum(I);
        if (!sum) return {};
        QuantityFinding::Quadratic result{true, false, true};
        for (const auto& [monomial, coefficient] : *sum) {
            const long of_term = degree(monomials, monomial).value_or(3);
            if (of_term > 2) return {};
            result.is_linear = result.is_linear && of_term < 2;
        }
        const auto block = [&](std::size_t begin, std::size_t slopes) {
            for (std::size_t i = 0; i < n_; ++i) {
                ex along;
                for (std::size_t j = 0; j < n_; ++j) {
                    const ex entry = I.diff(algebra_.variables()[begin + i])
                                         .diff(algebra_.variables()[begin + j])
                                         .expand();
                    result.has_squares = result.has_squares || !entry.is_zero();
                    along += entry * slopes_[slopes + j];
                }
                if (vanishes(along) != Vanishing::proved) result.squares_stay = false;
            }
        };
        block(0, n_);  // q^T R q changes by R H_p
        block(n_, 0);
        return result;
    }

    /// Whether each term is a momentum, a momentum times a coordinate, or a constant.
    [[nodiscard]] bool is_momentum_map(const ex& I) const {
        Monomials monomials(algebra_);
        const auto sum = monomials.sum(I);
        return sum && std::all_of(sum->begin(), sum->end(), [&](const auto& term) {
                   if (term.first.is_one()) return true;
                   if (degree(monomials, term.first).value_or(3) > 2) return false;
                   std::size_t momenta = 0;
                   for (const auto& [base, exponent] : term.first.powers)
                       if (base >= n_) momenta += exponent.is_equal(1) ? 1 : 2;
                   return momenta == 1;
               });
    }

    /// Returns the others whose products with one another, or which themselves, add up to I.
    [[nodiscard]] std::vector<std::size_t>
    made_of(const ex& I, const std::vector<std::pair<std::size_t, ex>>& others) const {
        if (others.size() > most_in_polynomial) return {};
        Monomials monomials(algebra_);
        std::vector<std::vector<std::size_t>> factors{{}};
        std::vector<ex> functions{1};
        for (std::size_t i = 0; i < others.size(); ++i) {
            factors.push_back({others[i].first});
            functions.push_back(others[i].second);
            for (std::size_t j = 0; j <= i; ++j) {
                factors.push_back({others[i].first, others[j].first});
                functions.push_back(others[i].second * others[j].second);
            }
        }
        functions.push_back(I);  // the last is free where it depends on the functions before it
        std::vector<MonomialSum> sums;
        for (const ex& function : functions) {
            auto sum = monomials.sum(function);
            if (!sum) return {};
            sums.push_back(*std::move(sum));
        }
        const Relations found = relations(monomials, std::move(sums), nullptr);
        if (found.basis.empty()) return {};
        const SparseVector& last = found.basis.back();
        if (last.rbegin()->first + 1 != functions.size()) return {};
        std::vector<std::size_t> result;
        for (const auto& [number, value] : last)
            if (number + 1 < functions.size())
                result.insert(result.end(), factors[number].begin(), factors[number].end());
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

private:
    [[nodiscard]] const symbol& q(std::size_t i) const { return algebra_.variables()[i]; }
    [[nodiscard]] const symbol& p(std::size_t i) const { return algebra_.variables()[n_ + i]; }

    Algebra algebra_;
    std::size_t n_;
    std::vector<ex> slopes_;
};

QuantityFinding finding(Motion& motion, const Quantity& quantity) {
    QuantityFinding result;
    const ex I = motion.read(quantity);
    const ex bracket = motion.bracket(I);
    result.conserved = motion.vanishes(bracket);
    // NOTE: derivatives do not see jumps.
    const bool may_jump = !where_it_may_jump(I).empty() && !motion.is_energy(I);
    if (may_jump && result.conserved == Vanishing::proved) result.conserved = Vanishing::unknown;
    result.bracket =
        result.conserved == Vanishing::proved ? Expression::integer(0) : motion.written(bracket);
    result.is_momentum_map = motion.is_momentum_map(I);
    if (result.conserved == Vanishing::proved) result.quadratic = motion.quadratic(I);
    return result;
}

}  // namespace

std::vector<QuantityFinding> findings(const Hamiltonian& hamiltonian,
                                      const std::vector<Quantity>& quantities) {
    const Progress::Stage stage("looking at invariants");
    Hamiltonian general = hamiltonian;
    general.parameters.clear();
    Motion with_symbols(general);
    std::optional<Motion> with_values;
    std::vector<QuantityFinding> result;
    std::vector<std::pair<std::size_t, ex>> kept;  ///< the quantities with parameters as symbols
    for (const Quantity& quantity : quantities) {
        QuantityFinding found = finding(with_symbols, quantity);
        const bool is_general = found.conserved == Vanishing::proved;
        if (!is_general && !hamiltonian.parameters.empty()) {
            if (!with_values) with_values.emplace(hamiltonian);
            QuantityFinding special = finding(*with_values, quantity);
            if (special.conserved == Vanishing::proved) found = std::move(special);
        }
        if (is_general) {
            const ex I = with_symbols.read(quantity);
            if (!found.quadratic || found.quadratic->has_squares)
                found.made_of = with_symbols.made_of(I, kept);
            else
                kept.emplace_back(result.size(), I);
        }
        result.push_back(std::move(found));
    }
    return result;
}

bool is_quadratic(const Lagrangian& lagrangian) {
    const Algebra algebra(lagrangian);
    Monomials monomials(algebra);
    const auto sum = monomials.sum(algebra.function());
    return sum && std::all_of(sum->begin(), sum->end(), [&](const auto& term) {
               return degree(monomials, term.first).value_or(3) <= 2;
           });
}

namespace {

bool are_proportional_in(Algebra algebra, const Quantity& first, const Quantity& second) {
    const ex a = algebra.read(first.expression, first.source);
    const ex b = algebra.read(second.expression, second.source);
    Monomials monomials(algebra);
    const auto x = monomials.sum(a), y = monomials.sum(b), one = monomials.sum(1);
    return x && y && one && !relations(monomials, {*one, *x, *y}, nullptr).basis.empty();
}

}  // namespace

bool are_proportional(const Hamiltonian& hamiltonian, const Quantity& first,
                      const Quantity& second) {
    return are_proportional_in(Algebra::with_entries(hamiltonian), first, second);
}

bool are_proportional(const Lagrangian& lagrangian, const Quantity& first, const Quantity& second) {
    return are_proportional_in(Algebra(lagrangian), first, second);
}

}  // namespace hvi::gen
