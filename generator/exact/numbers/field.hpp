// The ground floor: a field of exact numbers in which "is it zero?" is a decision.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/exact/numbers/ball.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/exact/numbers/multivariate.hpp"
#include "generator/exact/numbers/rational_value.hpp"
#include "generator/expr/expression.hpp"

namespace hvi::gen {

class Field;

/// Exponents of the algebraic generators, without trailing zeros.
using Monomial = std::vector<unsigned>;

/// An element of a Field in normal form: a polynomial in the algebraic generators, each of degree
/// less than that of its relation, over one denominator. Its coefficients and the denominator are
/// polynomials over Z in the transcendental generators, without a divisor that they all share, and
/// the denominator has leading sign 1. Zero has no terms, and nothing else is zero. Arithmetic
/// throws TooLarge where it would take more than the field's budget.
class Element {
public:
    using Terms = std::map<Monomial, IntegerMultivariate>;  ///< none is zero

    Element() = default;  ///< zero
    explicit Element(const Rational& rational, Field* field = nullptr);
    /// Returns a copy of a rational. NOTE: no constructor, as 0 would be a null pointer.
    [[nodiscard]] static Element copy_of(const fmpq* rational, Field* field = nullptr);
    /// Returns the transcendental generator x_index.
    [[nodiscard]] static Element variable(std::size_t index, Field* field);
    /// Returns a product of powers of algebraic generators, reduced.
    [[nodiscard]] static Element product(const Monomial& monomial, Field* field);
    /// Returns the sum of the numerator's terms over the denominator. Precondition: the terms are
    /// reduced, and the denominator is not zero.
    [[nodiscard]] static Element quotient(Terms numerator, IntegerMultivariate denominator,
                                          Field* field);

    [[nodiscard]] bool is_zero() const { return numerator_.empty(); }
    [[nodiscard]] bool is_rational() const;
    [[nodiscard]] bool is_integer(long value) const;  ///< whether it equals this one
    [[nodiscard]] Rational rational() const;          ///< precondition: is_rational()
    void copy_to(fmpq* rational) const;               ///< precondition: is_rational()

    [[nodiscard]] Field* field() const { return field_; }
    [[nodiscard]] const Terms& numerator() const { return numerator_; }
    [[nodiscard]] const IntegerMultivariate& denominator() const { return denominator_; }

    friend Element operator+(const Element& left, const Element& right);
    friend Element operator-(const Element& left, const Element& right);
    friend Element operator*(const Element& left, const Element& right);
    friend Element operator-(const Element& argument);

    /// Returns the number of terms of numerator and denominator.
    [[nodiscard]] std::size_t term_count() const;

    /// Returns the number of algebraic generators below and including the last one that occurs.
    [[nodiscard]] std::size_t level() const;

    /// Returns the coefficients of this element as a polynomial in algebraic generator number
    /// `index`, lowest first. Precondition: level() <= index + 1.
    [[nodiscard]] std::vector<Element> coefficients(std::size_t index) const;

private:
    Field* field_ = nullptr;  ///< null for a rational that has met no field yet
    Terms numerator_;
    IntegerMultivariate denominator_{1};
};

/// Returns 1/argument, by norms down the tower. Precondition: not zero.
[[nodiscard]] Element inverse(const Element& argument);

[[nodiscard]] Element power(const Element& base, unsigned exponent);

/// A generator over Q that satisfies no algebraic relation: pi, exp(1), cos(w), a parameter. Number
/// i of a field is the variable x_i of its polynomials.
struct Transcendental {
    Expression form;                       ///< its written form
    bool is_parameter = false;             ///< whether it, or a part of it, has no value
    std::function<Ball(Precision)> value;  ///< empty with is_parameter
    std::optional<Element> exponent;       ///< x, where the generator is exp(x)
    std::optional<Element> angle;          ///< x, where the generator is cos(x)
    long prime = 0;                        ///< p, where the generator is log(p)
};

/// A generator g with a monic relation g^degree = reduced over g and the generators below it:
/// sqrt(2); sin(w) with sin(w)^2 = 1 - cos(w)^2; cos(pi/14), of degree 6.
struct Algebraic {
    enum class Kind { root, sine, cosine };

    Kind kind = Kind::root;
    unsigned degree = 2;
    Element reduced;         ///< g^degree, of lower degree in g
    long denominator = 1;    ///< n of cos(pi/n)
    std::size_t cosine = 0;  ///< for a sine: the number of its transcendental generator cos(x)
    Expression form;         ///< written form of a root or sine
    bool is_parameter = false;
    std::function<Ball(Precision)> value;  ///< empty with is_parameter
};

/// Multiples of a unit met so far: their least common denominator, and the size of the largest.
struct Multiples {
    Integer denominator = 1;
    Rational largest;
};

/// Arguments met so far, by function and unit: exp(1/2) and exp(1/3) are powers of one generator
/// exp(1/6). A Field is made for one table; an argument that does not fit throws TooCoarse, and the
/// work starts again with the finer table.
using Denominators = std::map<std::string, Multiples>;
struct TooCoarse {
    Denominators finer;
};

/// The generators, in the order in which they were met.
class Field {
public:
    /// Limit of algebraic generators. More would make the arithmetic of the normal form too slow to
    /// be of use: values that need another one are left to enclosures.
    static constexpr std::size_t most_generators = 8;

    explicit Field(Denominators denominators) : denominators_(std::move(denominators)) {}
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;

    [[nodiscard]] const std::vector<Transcendental>& transcendentals() const {
        return transcendentals_;
    }
    [[nodiscard]] const Algebraic& algebraic(std::size_t index) const {
        return algebraics_.at(index);
    }
    [[nodiscard]] std::size_t algebraic_count() const { return algebraics_.size(); }
    [[nodiscard]] Budget& budget() { return budget_; }

    [[nodiscard]] Element pi();
    [[nodiscard]] Element parameter(const std::string& name);

    /// Returns the non-negative square root. Throws MathError for a negative argument. Empty when
    /// the sign of the argument has no meaning (free parameters) or the tower would grow too high.
    [[nodiscard]] std::optional<Element> sqrt(const Element& argument);

    /// Returns a root of an element that has none in the field, also with free parameters, where
    /// its sign has no meaning. Empty where there is one, and when the tower would grow too high.
    [[nodiscard]] std::optional<Element> new_root(const Element& argument);

    /// Return the value; empty where the field has no exact place for it, and an enclosure serves
    /// instead.
    [[nodiscard]] std::optional<Element> exp(const Element& argument);
    [[nodiscard]] std::optional<Element> log(const Element& argument);
    struct CosSin {
        Element cos, sin;
    };
    [[nodiscard]] std::optional<CosSin> cos_sin(const Element& argument);

    /// Returns the free parameters, sorted by name.
    [[nodiscard]] std::vector<std::string> parameters() const;

private:
    /// A product rational * unit, the unit of leading sign 1 and integer content 1.
    struct Part {
        Rational factor;
        Element unit;
        std::string key;  ///< the unit's text
    };
    /// Returns the parts of an argument, whose units are linearly independent over Q; empty where
    /// sums in denominators hide whether they are.
    [[nodiscard]] std::optional<std::vector<Part>> split(const Element& argument);
    [[nodiscard]] std::optional<long> prime_of_logarithm(const Element& unit) const;
    [[nodiscard]] std::optional<Element> prime_power(long prime, const Rational& exponent);
    struct Multiple {
        long times;
        Integer denominator;  ///< factor = times / denominator
    };
    /// Returns the multiple; empty where `largest`, or an earlier multiple, would be too high a
    /// power.
    [[nodiscard]] std::optional<Multiple> multiple(const std::string& key, const Rational& factor,
                                                   const Rational& largest);
    [[nodiscard]] std::optional<CosSin> cos_sin_of_pi(const Rational& half_turns);
    [[nodiscard]] std::optional<CosSin> constructible(long denominator);
    [[nodiscard]] std::optional<CosSin> cyclotomic(const Rational& half_turns);
    [[nodiscard]] std::optional<CosSin> cos_sin_of_part(const Part& part);

    /// Returns a generator; empty when there are as many as there are variables, less one for pi.
    [[nodiscard]] std::optional<Element> transcendental(const std::string& key,
                                                        Transcendental generator);
    [[nodiscard]] Element adjoin(Algebraic generator);
    [[nodiscard]] std::optional<Element> adjoin_root(const Element& argument);

    Budget budget_;
    Denominators denominators_;
    std::vector<Transcendental> transcendentals_;
    std::vector<Algebraic> algebraics_;
    std::map<std::string, std::size_t> by_key_;  ///< index into transcendentals_
    std::map<std::string, CosSin> angles_;       ///< generators cos and sin, by the angle's text
};

/// Returns the root (of either sign) of `argument` in the field that the first `level` algebraic
/// generators span; empty where it is no square there. Exact: adjoining the root of a non-square
/// doubles the degree.
[[nodiscard]] std::optional<Element> root_in_field(const Element& argument, std::size_t level);

/// A root sqrt(argument) = factor * sqrt(radicand), the radicand with coprime integer coefficients
/// times a square-free integer. Precondition: not zero.
struct Simplified {
    Rational factor;
    Element radicand;
};
[[nodiscard]] Simplified simplified_root(const Element& argument);

/// Returns whether a free parameter occurs.
[[nodiscard]] bool has_parameters(const Element& argument);

/// Returns an enclosure. Precondition: no free parameter.
[[nodiscard]] Ball enclosure(const Element& argument, Precision bits);

/// Returns the proved sign: zero by the normal form, else by an enclosure. Empty where the
/// enclosures do not decide. Precondition: no free parameter.
[[nodiscard]] std::optional<int> sign(const Element& argument);

/// Returns the shortest of a few ways to write an element (see closed_form.cpp).
[[nodiscard]] Expression closed_form(const Element& argument);

/// Returns a rational function of a parameter as a paper prints it. Numerator and denominator are
/// written out by falling powers of the parameter, with integer coefficients that have no common
/// divisor, and the leading one below positive. A polynomial is written by rising powers, term by
/// term.
[[nodiscard]] Expression expanded_form(const Element& argument, const std::string& parameter);

/// Returns the sign of the first coefficient in a fixed order: one of x and -x has 1 and the other
/// -1, also with free parameters. Precondition: not zero.
[[nodiscard]] int leading_sign(const Element& argument);

}  // namespace hvi::gen
