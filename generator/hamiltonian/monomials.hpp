// Functions of variables as sums of coefficients times monomials, so that linear relations among
// them are linear equations for numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/hamiltonian/algebra.hpp"

namespace hvi::gen {

/// A product of powers of bases, exp(a), and cos(f) or sin(f). The sums a and f have no constant
/// term and are known by their numbers; 0 is the empty sum.
struct FunctionMonomial {
    std::vector<std::pair<std::size_t, GiNaC::ex>> powers;  ///< by base; no exponent is zero
    std::size_t exponential = 0;                            ///< a
    std::size_t phase = 0;                                  ///< f
    bool is_sine = false;

    [[nodiscard]] bool is_one() const {
        return powers.empty() && exponential == 0 && phase == 0 && !is_sine;
    }
};

/// NOTE: this order depends on addresses in memory. Results must not depend on it.
struct MonomialOrder {
    bool operator()(const FunctionMonomial& a, const FunctionMonomial& b) const;
};

/// A sum of monomials with coefficients. Coefficients have no variables, and none is seen to be
/// zero.
using MonomialSum = std::map<FunctionMonomial, GiNaC::ex, MonomialOrder>;

struct MonomialSumOrder {
    bool operator()(const MonomialSum& a, const MonomialSum& b) const;
};

/// The base of a power: a variable, a sum in a denominator or under a root, or a function of which
/// only the name is known.
struct MonomialBase {
    std::optional<GiNaC::symbol> variable;
    std::optional<MonomialSum> sum;
    std::string function;
    std::vector<std::size_t> arguments;  ///< numbers of the function's arguments
};

/// A sum has more terms than one can use.
struct TooManyTerms {};

/// Reads functions, and remembers the parts of their monomials. The variables are those of H or L
/// and the time; parameters without a value are coefficients, in general position.
///
/// A product of sines and cosines becomes a sum of them, hyperbolic functions exponentials, and
/// products of exponentials one: sin^2 + cos^2 and exp(q) exp(-q) are 1.
class Monomials {
public:
    explicit Monomials(const Algebra& algebra);

    /// Returns nothing where the sum has too many terms.
    [[nodiscard]] std::optional<MonomialSum> sum(const GiNaC::ex& function);

    /// Returns a function of which only the name is known.
    [[nodiscard]] MonomialSum unknown(const std::string& name);

    /// Returns the sum times a variable: 0 .. n-1 in the algebra's order.
    [[nodiscard]] static MonomialSum times_variable(const MonomialSum& sum, std::size_t variable);

    /// Returns the product. Throws TooManyTerms, as power() does.
    [[nodiscard]] MonomialSum product(const MonomialSum& a, const MonomialSum& b);
    /// Precondition: the exponent is not negative.
    [[nodiscard]] MonomialSum power(const MonomialSum& base, unsigned exponent);

    [[nodiscard]] const Algebra& algebra() const { return algebra_; }
    [[nodiscard]] const std::vector<MonomialBase>& bases() const { return bases_; }
    [[nodiscard]] const std::vector<MonomialSum>& arguments() const { return arguments_; }

private:
    [[nodiscard]] bool varies(const GiNaC::ex& expression) const;
    [[nodiscard]] MonomialSum read(const GiNaC::ex& expression);
    [[nodiscard]] MonomialSum read_product(const GiNaC::ex& expression);
    [[nodiscard]] MonomialSum read_power(const GiNaC::ex& base, const GiNaC::ex& exponent);
    [[nodiscard]] MonomialSum read_function(const GiNaC::function& function);
    [[nodiscard]] MonomialSum raised(const MonomialSum& base, const GiNaC::ex& exponent);
    [[nodiscard]] MonomialSum exponential(MonomialSum argument);
    [[nodiscard]] MonomialSum wave(MonomialSum argument, bool is_sine);
    [[nodiscard]] MonomialSum product(const FunctionMonomial& a, const FunctionMonomial& b);
    [[nodiscard]] MonomialSum opaque(MonomialBase base, const GiNaC::ex& exponent);
    [[nodiscard]] std::size_t number_of(const MonomialSum& argument);
    void check_size(const MonomialSum& sum) const;

    const Algebra& algebra_;
    std::vector<MonomialBase> bases_;
    std::map<std::string, std::size_t> functions_;  ///< by name and numbers of arguments
    std::map<MonomialSum, std::size_t, MonomialSumOrder> sums_;
    std::vector<MonomialSum> arguments_;
    std::map<MonomialSum, std::size_t, MonomialSumOrder> argument_numbers_;
};

/// Adds coefficient * monomial.
void add(MonomialSum& sum, const FunctionMonomial& monomial, const GiNaC::ex& coefficient);

}  // namespace hvi::gen
