// Functions of functions: 1/f, f^r, exp(f), log(f), ... as functions of function.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/functions/domain.hpp"
#include "generator/exact/functions/factor.hpp"
#include "generator/exact/functions/signs.hpp"

namespace hvi::gen {

/// Compositions on a domain on which the results must be real and finite, except for integrable
/// singularities at its ends. Otherwise MathError is thrown with the place of the singularity.
/// InputError is thrown for functions that need the domain when it is not known, and when a free
/// parameter is left. Errors have no place in the text.
class FunctionComposition {
public:
    FunctionComposition(const std::optional<Domain>& domain, const Ground& ground)
        : domain_(domain), ground_(ground) {}

    /// Returns 1/divisor. Precondition: not zero.
    [[nodiscard]] ExactFunction reciprocal(const ExactFunction& divisor) const;

    /// Returns base^exponent. Precondition: the exponent is no integer.
    [[nodiscard]] ExactFunction root(const ExactFunction& base, const Ratio& exponent) const;

    /// Returns a function of one argument by its name, other than sqrt.
    [[nodiscard]] ExactFunction call(const std::string& name, const ExactFunction& argument) const;

    /// Refuses a function with a singularity at an end of the domain that is not integrable, or
    /// whose integral is not built yet.
    void check_integrable(const ExactFunction& function) const;

private:
    void check_ready(const ExactFunction& function) const;
    void check_no_zero(const ExactFunction& function, const char* what) const;
    [[nodiscard]] Signs positive(const ExactFunction& function, const std::string& what,
                                 bool infinite_at_zero) const;

    [[nodiscard]] ExactFunction exponential(const ExactFunction& argument) const;
    [[nodiscard]] ExactFunction wave(bool cosine, const ExactFunction& argument) const;
    [[nodiscard]] ExactFunction logarithm(const ExactFunction& argument) const;
    [[nodiscard]] ExactFunction tangent(const ExactFunction& argument) const;
    [[nodiscard]] ExactFunction cube_root(const ExactFunction& argument) const;
    [[nodiscard]] ExactFunction area_tangent(const ExactFunction& argument) const;
    [[nodiscard]] ExactFunction called(const std::string& name,
                                       const ExactFunction& argument) const;

    [[nodiscard]] std::optional<ExactFunction> simple_reciprocal(const ExactFunction& f) const;
    [[nodiscard]] std::optional<ExactFunction> rational_reciprocal(const ExactFunction& f) const;
    [[nodiscard]] std::optional<ExactFunction> simple_root(const ExactFunction& base,
                                                           const Ratio& exponent) const;
    [[nodiscard]] ExactFunction root_of_line(const NumberPolynomial& line,
                                             const Ratio& exponent) const;
    [[nodiscard]] std::optional<std::string> zero_of(const LinearPower& factor) const;
    struct Singularity;
    [[nodiscard]] std::optional<Singularity> singularity(const Factor& factor) const;

    const std::optional<Domain>& domain_;
    const Ground& ground_;
};

}  // namespace hvi::gen
