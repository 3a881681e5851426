// Functions of tau: sums of tau^k exp(a tau) {1, cos(b tau), sin(b tau)} and of such terms times a
// further factor.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "generator/exact/numbers/ground.hpp"
#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

struct Factor;  ///< in factor.hpp
using FactorPointer = std::shared_ptr<const Factor>;

/// A term coefficient * tau^power * exp(rate tau) * wave(frequency tau) * factor(tau), from `step`
/// on.
struct ExactTerm {
    enum class Wave { none, cos, sin };

    Number coefficient;
    unsigned power = 0;
    Number rate = 0;
    Wave wave = Wave::none;
    Number frequency = 0;             ///< not zero and of canonical sign 1, or zero without a wave
    std::optional<Number> step = {};  ///< a rational: the term is 0 for smaller tau
    FactorPointer factor = {};        ///< null for 1

    /// Returns whether it is coefficient * tau^power.
    [[nodiscard]] bool is_monomial() const;
};

/// A function of tau as a sum of terms that differ in more than their coefficient, none of them
/// zero. The terms are linearly independent as functions, as far as `is_independent` holds for
/// their factors (see factor.hpp).
class ExactFunction {
public:
    ExactFunction() = default;  ///< zero
    explicit ExactFunction(const Number& constant);
    explicit ExactFunction(
        const std::vector<Number>& coefficients);  ///< a polynomial, lowest first
    explicit ExactFunction(const ExactTerm& term);
    explicit ExactFunction(FactorPointer factor);
    [[nodiscard]] static ExactFunction tau();
    [[nodiscard]] static ExactFunction exponential(const Number& rate);
    [[nodiscard]] static ExactFunction cosine(const Number& frequency);
    [[nodiscard]] static ExactFunction sine(const Number& frequency);
    /// Returns the function that is 0 before a rational, and 1 from there on.
    [[nodiscard]] static ExactFunction step(const Number& from);

    friend ExactFunction operator+(const ExactFunction& left, const ExactFunction& right);
    friend ExactFunction operator*(const ExactFunction& left, const ExactFunction& right);

    [[nodiscard]] const std::vector<ExactTerm>& terms() const { return terms_; }
    [[nodiscard]] bool is_polynomial() const;
    [[nodiscard]] bool has_steps() const;
    [[nodiscard]] bool has_parameters() const;
    [[nodiscard]] std::optional<Number> constant() const;  ///< value, when it is constant

    /// Returns the coefficients of a polynomial, lowest first, without zeros at the end.
    /// Precondition: is_polynomial().
    [[nodiscard]] std::vector<Number> coefficients() const;

    /// Returns the function without steps that equals this one at a point and to the right of it.
    [[nodiscard]] ExactFunction piece_at(const Number& point) const;

    /// Returns the value at tau = point. Throws MathError where it is infinite.
    [[nodiscard]] Number at(const Number& point, const Ground& ground) const;

    /// Returns the integral over [0, end]: exact where a closed form is known, else enclosed.
    /// Throws MathError where no enclosure is found.
    [[nodiscard]] Number integral(const Number& end, const Ground& ground) const;

private:
    void add(const ExactTerm& term);
    void add_normal(const ExactTerm& term);

    std::vector<ExactTerm> terms_;
};

/// Returns whether two terms are multiples of each other.
[[nodiscard]] bool same_shape(const ExactTerm& left, const ExactTerm& right);

/// Returns whether two functions are known to be the same.
[[nodiscard]] bool known_same(const ExactFunction& left, const ExactFunction& right);

}  // namespace hvi::gen
