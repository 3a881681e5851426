// Ground of one derivation: its field, its parameters, and the elementary functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "generator/exact/numbers/field.hpp"
#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Exact constants and functions of numbers. Where the field has no place for a value, the result
/// is a number that is known by its enclosures.
class Ground {
public:
    explicit Ground(std::shared_ptr<Field> field) : field_(std::move(field)) {}

    [[nodiscard]] Number rational(const std::string& numerator,
                                  const std::string& denominator) const;
    [[nodiscard]] Number pi() const;

    /// Returns the value given to a parameter, or the free symbol.
    [[nodiscard]] Number parameter(const std::string& name) const;
    void set_parameter(const std::string& name, Number value);
    [[nodiscard]] std::vector<std::string> free_parameters() const { return field_->parameters(); }

    /// Functions throw MathError where they are not real, and InputError where a free parameter
    /// stands in a place that the exact arithmetic does not reach yet.
    [[nodiscard]] Number sqrt(const Number& argument) const;
    /// Returns a number of either sign whose square is `square`, where one has an exact place in
    /// the field: w for w^2. It serves even functions.
    [[nodiscard]] std::optional<Number> either_root(const Number& square) const;
    /// Returns a number whose square is `square`, a function of free parameters without a known
    /// sign: a generator of the field. Empty where one of the two roots is in the field already, as
    /// q is for q^2, and where the field has no place for more.
    [[nodiscard]] std::optional<Number> new_root(const Number& square) const;
    [[nodiscard]] Number exp(const Number& argument) const;
    [[nodiscard]] Number log(const Number& argument) const;
    [[nodiscard]] Number cos(const Number& argument) const;
    [[nodiscard]] Number sin(const Number& argument) const;

private:
    [[nodiscard]] Number exact(Element element) const;

    std::shared_ptr<Field> field_;
    std::map<std::string, Number> values_;
};

/// Runs `work` with a ground on a field of its own, again until that field's table of denominators
/// fits (see Denominators).
template <class Work>
auto on_new_ground(Work work) {
    for (Denominators denominators;;) {
        try {
            return work(Ground(std::make_shared<Field>(denominators)));
        } catch (const TooCoarse& answer) { denominators = answer.finer; }
    }
}

/// Returns base^exponent by repeated squaring. Precondition: exponent >= 0.
[[nodiscard]] Number power(const Number& base, unsigned exponent);

/// Returns -1 or 1, equal for equal numbers and opposite for opposite ones. Precondition: not zero.
[[nodiscard]] int canonical_sign(const Number& number);

}  // namespace hvi::gen
