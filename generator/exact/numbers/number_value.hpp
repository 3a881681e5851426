// The inside of a Number: a field element, or a real number that is known by its enclosures alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <variant>

#include "generator/exact/numbers/ball.hpp"
#include "generator/exact/numbers/field.hpp"
#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// A real number without an exact place in the field: it can be enclosed to any precision. Sums and
/// products of such numbers are nodes of a graph.
class Real {
public:
    explicit Real(std::function<Ball(Precision)> enclose) : enclose_(std::move(enclose)) {}

    [[nodiscard]] Ball enclosure(Precision bits) const { return enclose_(bits); }

private:
    std::function<Ball(Precision)> enclose_;
};

struct Number::Value {
    Value(std::variant<Element, Real> value, std::shared_ptr<Field> ground)
        : what(std::move(value)), field(std::move(ground)) {}

    std::variant<Element, Real> what;
    std::shared_ptr<Field> field;  ///< keeps the element's generators alive; null for rationals

    [[nodiscard]] const Element* element() const { return std::get_if<Element>(&what); }

    /// Returns 1/x. NOTE: computed once, as a divisor often divides many numbers. Throws TooLarge
    /// as arithmetic of elements does. Precondition: an element, not zero.
    [[nodiscard]] const Element& inverse() const {
        if (inverse_is_too_large_) { throw TooLarge(); }
        if (!inverse_) {
            inverse_is_too_large_ = true;
            inverse_ = hvi::gen::inverse(*element());
            inverse_is_too_large_ = false;
        }
        return *inverse_;
    }

    /// Returns the closed form. NOTE: written once, as each format of an output and each comment of
    /// a header asks for it. Precondition: an element.
    [[nodiscard]] const Expression& closed_form() const {
        if (!closed_form_) { closed_form_ = hvi::gen::closed_form(*element()); }
        return *closed_form_;
    }

    /// Returns an enclosure. NOTE: remembered, as numbers share their parts, and are asked for a
    /// sign, for digits and for a double. Precondition: no free parameter.
    [[nodiscard]] Ball enclosure(Precision bits) const {
        return ball_.at(bits, [this](Precision wanted) {
            return element() != nullptr ? hvi::gen::enclosure(*element(), wanted)
                                        : std::get<Real>(what).enclosure(wanted);
        });
    }

private:
    mutable std::optional<Element> inverse_;
    mutable bool inverse_is_too_large_ = false;
    mutable std::optional<Expression> closed_form_;
    mutable TightestBall ball_;
};

[[nodiscard]] Number number(Element element, std::shared_ptr<Field> field);
[[nodiscard]] Number number(Real real);

/// Returns whether it is known to be this integer without any computation.
[[nodiscard]] bool is_exactly(const Number& number, long integer);

/// Returns an enclosure. Precondition: no free parameter.
[[nodiscard]] Ball enclosure(const Number& number, Precision bits);

/// Refines until `decide`, called with a ball, returns a value. Throws MathError "cannot decide
/// WHAT" when the last precision is not sufficient.
template <class Decide>
auto refine(const Number& number, const char* what, Decide decide) {
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        if (auto decision = decide(enclosure(number, bits))) return *decision;
    }
    throw MathError(std::string("cannot decide ") + what + " with " +
                    std::to_string(last_precision) + " bits");
}

}  // namespace hvi::gen
