// SPDX-License-Identifier: GPL-2.0-or-later
#include <arb_mat.h>

#include <algorithm>
#include <memory>
#include <set>

#include "generator/exact/numbers/rational.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"
#include "generator/hamiltonian/vanishing.hpp"
#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

constexpr std::size_t most_roots = 60;      ///< roots that are compared with one another
constexpr std::size_t most_arguments = 60;  ///< arguments that are compared with one another
constexpr std::size_t most_at_points = 150;
constexpr slong bits_at_points = 512;

struct Used {
    std::set<std::size_t> bases, exponentials, phases;
    std::set<std::size_t> roots;  ///< bases with an exponent that is no whole number
};

Used used_in(const std::vector<MonomialSum>& functions) {
    Used used;
    for (const MonomialSum& function : functions)
        for (const auto& [monomial, coefficient] : function) {
            used.exponentials.insert(monomial.exponential);
            used.phases.insert(monomial.phase);
            for (const auto& [base, exponent] : monomial.powers) {
                used.bases.insert(base);
                if (!exponent.info(GiNaC::info_flags::integer)) used.roots.insert(base);
            }
        }
    used.exponentials.erase(0);
    used.phases.erase(0);
    return used;
}

/// Returns the sum as an expression, if it is a polynomial in the variables.
std::optional<ex> polynomial(const Monomials& monomials, const MonomialSum& sum) {
    ex result = 0;
    for (const auto& [monomial, coefficient] : sum) {
        if (monomial.exponential != 0 || monomial.phase != 0) return {};
        ex term = coefficient;
        for (const auto& [base, exponent] : monomial.powers) {
            const auto& variable = monomials.bases()[base].variable;
            if (!variable || !exponent.info(GiNaC::info_flags::nonnegint)) return {};
            term *= GiNaC::pow(*variable, exponent);
        }
        result += term;
    }
    return result;
}

bool has_rational_coefficients(const MonomialSum& sum) {
    return std::all_of(sum.begin(), sum.end(), [](const auto& term) {
        return term.second.info(GiNaC::info_flags::rational_function);
    });
}

/// Whether two polynomials have no factor in common.
bool are_coprime(const Monomials& monomials, const ex& a, const ex& b) {
    const ex common = common_divisor(normal_form(a).numer(), normal_form(b).numer());
    return std::none_of(monomials.bases().begin(), monomials.bases().end(), [&](const auto& base) {
        return base.variable && common.has(*base.variable);
    });
}

bool has_no_factor_twice(const Monomials& monomials, const ex& polynomial) {
    ex common = normal_form(polynomial).numer();
    const ex whole = common;
    for (const MonomialBase& base : monomials.bases())
        if (base.variable && whole.has(*base.variable))
            common = common_divisor(common, whole.diff(*base.variable));
    return std::none_of(monomials.bases().begin(), monomials.bases().end(), [&](const auto& base) {
        return base.variable && common.has(*base.variable);
    });
}

/// Whether a polynomial, multiplied out, is seen to be no product. NOTE: GiNaC's factorization does
/// not end in useful time from some length on.
bool is_prime(const ex& polynomial) {
    constexpr std::size_t most_terms = 100;
    if (!GiNaC::is_a<GiNaC::add>(polynomial) || polynomial.nops() > most_terms) return false;
    constexpr double units_of_pair = 10;
    const auto terms = static_cast<double>(polynomial.nops());
    spend_work(units_of_pair * terms * terms);
    return GiNaC::is_a<GiNaC::add>(GiNaC::factor(polynomial));
}

/// Whether none of the polynomials is a product, and none a multiple of another one: then none has
/// a factor twice, and no two have a common factor. NOTE: many bodies have so many distances that
/// greatest common divisors of all pairs take seconds.
bool are_different_primes(const std::vector<ex>& polynomials) {
    constexpr std::size_t most = 400;
    if (polynomials.size() > most) return false;
    std::vector<ex> primes;
    for (const ex& each : polynomials) {
        const ex expanded = each.expand();
        if (!GiNaC::is_a<GiNaC::symbol>(expanded) && !is_prime(normal_form(expanded).numer()))
            return false;
        primes.push_back(expanded);
    }
    for (std::size_t i = 0; i < primes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            spend_work();
            if ((primes[i] - primes[j]).is_zero() || (primes[i] + primes[j]).expand().is_zero())
                return false;
        }
    return true;
}

bool are_roots_independent(const Monomials& monomials, const Used& used) {
    std::vector<ex> under;
    for (const std::size_t base : used.roots) {
        const MonomialBase& of = monomials.bases()[base];
        if (of.variable) {
            under.push_back(*of.variable);
            continue;
        }
        if (!of.sum || !has_rational_coefficients(*of.sum)) return false;
        const auto P = polynomial(monomials, *of.sum);
        if (!P) return false;
        under.push_back(*P);
    }
    if (are_different_primes(under)) return true;
    if (under.size() > most_roots) return false;
    for (std::size_t i = 0; i < under.size(); ++i) {
        if (!has_no_factor_twice(monomials, under[i])) return false;
        for (std::size_t j = 0; j < i; ++j)
            if (!are_coprime(monomials, under[i], under[j])) return false;
    }
    return true;
}

/// Whether the exponents of each root differ by rational numbers only.
bool are_exponents_rational(const std::vector<MonomialSum>& functions) {
    for (const MonomialSum& function : functions)
        for (const auto& [monomial, coefficient] : function)
            for (const auto& [base, exponent] : monomial.powers)
                if (!exponent.info(GiNaC::info_flags::rational)) return false;
    return true;
}

/// Whether two arguments differ by more than a constant.
bool are_different(const Monomials& monomials, std::size_t a, std::size_t b, int sign) {
    MonomialSum difference = monomials.arguments()[a];
    for (const auto& [monomial, coefficient] : monomials.arguments()[b])
        add(difference, monomial, -sign * coefficient);
    return std::any_of(difference.begin(), difference.end(), [&](const auto& term) {
        return vanishing(monomials.algebra(), term.second) == Vanishing::refuted;
    });
}

/// Whether the phases differ, up to the sign, by more than a constant. NOTE: phases with rational
/// coefficients have one number where they are equal.
bool are_different(const Monomials& monomials, const std::set<std::size_t>& arguments,
                   bool up_to_sign) {
    std::vector<std::size_t> others;
    for (const std::size_t number : arguments) {
        const MonomialSum& argument = monomials.arguments()[number];
        if (!polynomial(monomials, argument)) return false;
        const bool is_plain = std::all_of(argument.begin(), argument.end(), [](const auto& term) {
            return term.second.info(GiNaC::info_flags::rational);
        });
        if (!is_plain) others.push_back(number);
    }
    if (others.size() > most_arguments) return false;
    for (const std::size_t a : others)
        for (const std::size_t b : arguments)
            if (a != b && (!are_different(monomials, a, b, 1) ||
                           (up_to_sign && !are_different(monomials, a, b, -1))))
                return false;
    return true;
}

/// Points with rational coordinates, alternately in (0, 2) and in (0, 2/5); each point is new.
class Points {
public:
    [[nodiscard]] SymbolValues next(const Algebra& algebra) {
        is_near_ = !is_near_;
        SymbolValues values = parameters_;
        const bool first = parameters_.empty();
        for (const GiNaC::symbol& symbol : algebra.parameters())
            if (symbol.get_name() == "t" || first) values[symbol.get_name()] = number();
        if (first) parameters_ = values;
        for (const GiNaC::symbol& symbol : algebra.variables())
            values[symbol.get_name()] = number();
        return values;
    }

private:
    [[nodiscard]] Ball number() {
        above_ = (above_ * 16807) % 2147483647;
        return ball_of_rational(std::to_string(above_ % 997 + 1) + (is_near_ ? "/2500" : "/500"),
                                bits_at_points);
    }

    std::uint64_t above_ = 20011;
    bool is_near_ = true;      ///< whether near the origin, where low powers count
    SymbolValues parameters_;  ///< equal at all points
};

}  // namespace

bool is_independent(const Monomials& monomials, const std::vector<MonomialSum>& functions) {
    const Used used = used_in(functions);
    const bool has_unknown =
        std::any_of(used.bases.begin(), used.bases.end(),
                    [&](std::size_t base) { return !monomials.bases()[base].function.empty(); });
    return !has_unknown && are_exponents_rational(functions) &&
           are_roots_independent(monomials, used) &&
           are_different(monomials, used.exponentials, false) &&
           are_different(monomials, used.phases, true);
}

bool are_independent_at_points(const Algebra& algebra, const Sampler& sampler,
                               const std::vector<std::size_t>& numbers) {
    const std::size_t n = numbers.size();
    if (n == 0) return true;
    if (n > most_at_points) return false;
    arb_mat_t matrix;
    arb_mat_init(matrix, slong(n), slong(n));
    const std::unique_ptr<arb_mat_struct, void (*)(arb_mat_t)> owner(matrix, &arb_mat_clear);
    Points points;
    std::size_t row = 0;
    for (std::size_t tried = 0; row < n && tried < 2 * n + 10; ++tried) {
        try {
            const std::vector<Ball> values = sampler(points.next(algebra));
            bool finite = true;
            for (std::size_t column = 0; column < n; ++column) {
                const Ball& value = values[numbers[column]];
                finite = finite && arb_is_finite(value.get()) != 0;
                arb_set(arb_mat_entry(matrix, slong(row), slong(column)), value.get());
            }
            if (finite) ++row;
        } catch (const MathError&) {}  // there is no value there
    }
    if (row < n) return false;
    constexpr double units_of_operation = 0.2;
    const auto size = static_cast<double>(n);
    spend_work(units_of_operation * size * size * size);
    // NOTE: this succeeds only where the matrix is proved to be regular.
    std::vector<slong> permutation(n);
    return arb_mat_lu(permutation.data(), matrix, matrix, bits_at_points) != 0;
}

}  // namespace hvi::gen
