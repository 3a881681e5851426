// Functions of tau that have exact integrals: sums of tau^k exp(a tau) {1, cos(b tau), sin(b tau)}.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/ground.hpp"
#include "generator/exact/number.hpp"

namespace hvi::gen {

/// coefficient * tau^power * exp(rate tau) * wave(frequency tau).
struct ExactTerm {
    enum class Wave { none, cos, sin };

    Number coefficient;
    unsigned power = 0;
    Number rate;
    Wave wave = Wave::none;
    Number frequency;  ///< not zero and of canonical sign 1, or zero without a wave
};

/// A function of tau as a sum of terms that differ in more than their coefficient, none of them
/// zero: the terms are linearly independent as functions.
class ExactFunction {
public:
    ExactFunction() = default;  ///< zero
    explicit ExactFunction(const Number& constant);
    [[nodiscard]] static ExactFunction tau();
    [[nodiscard]] static ExactFunction exponential(const Number& rate);
    [[nodiscard]] static ExactFunction cosine(const Number& frequency);
    [[nodiscard]] static ExactFunction sine(const Number& frequency);

    friend ExactFunction operator+(const ExactFunction& left, const ExactFunction& right);
    friend ExactFunction operator*(const ExactFunction& left, const ExactFunction& right);

    [[nodiscard]] const std::vector<ExactTerm>& terms() const { return terms_; }
    [[nodiscard]] bool is_polynomial() const;
    [[nodiscard]] std::optional<Number> constant() const;  ///< its value, when it is constant

    /// The value at tau = point.
    [[nodiscard]] Number at(const Number& point, const Ground& ground) const;

    /// The integral over [0, end]: tau^k exp(z tau) with z = a + i b, by parts.
    [[nodiscard]] Number integral(const Number& end, const Ground& ground) const;

private:
    void add(const ExactTerm& term);

    std::vector<ExactTerm> terms_;
};

/// Whether two terms are multiples of each other.
[[nodiscard]] bool same_shape(const ExactTerm& left, const ExactTerm& right);

}  // namespace hvi::gen
