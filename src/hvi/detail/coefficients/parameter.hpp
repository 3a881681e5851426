// Coefficients of a method at one value of its parameter, right to the last place also where
// numerator and denominator vanish together.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_PARAMETER_HPP
#define HVI_PARAMETER_HPP

#include <algorithm>
#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/series.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Two functions of the parameter w: x = sin(rate w) and y = cos(rate w), or x and y with x/y =
/// exp(rate w), the larger of which is 1.
struct Phase {
    enum class Kind { angle, exponential };
    Kind kind;
    Expansion rate;
};

/// A coefficient times powers of the variables: of w, then of x and y of each phase, then of the
/// constants.
template <std::size_t variables>
struct Term {
    double coefficient;
    std::array<unsigned char, variables> powers;
};

/// The sum of the next `terms` terms. At w = 0 it vanishes to exactly this order.
struct EntireFunction {
    enum class Role {
        numerator,
        pole,    ///< where it vanishes, there is no method
        weight,  ///< where it vanishes, a weight vanishes
    };
    Role role;
    std::size_t terms;
    int order;
};

/// Functions of a method at one w, which hvi-gen writes down as
///
///     struct Functions {
///         static constexpr std::array<Phase, P> phases;
///         static constexpr std::array<Expansion, K> constants;
///         static constexpr std::array<Term<1 + 2 * P + K>, T> terms;
///         static constexpr std::array<EntireFunction, F> functions;
///         static constexpr std::size_t length;     // of the power series at w = 0
///         static constexpr double switch_point;    // up to this |w| the series are taken
///         static constexpr Status::Code at_zero;   // ok, or what is wrong at w = 0
///     };
///
/// NOTE: as an exponential function is homogeneous in x and y, it neither overflows nor becomes 0
/// far out.
template <class Functions, class Scalar>
class AtParameter {
public:
    using Number = Pair<Work<Scalar>>;

    explicit AtParameter(Scalar w) : w_{static_cast<Work<Scalar>>(w)} {
        const Work<Scalar> size = abs(w_.hi);
        if (!is_finite(size)) {
            code_ = Status::Code::not_finite;
        } else if (size > largest) {
            code_ = Status::Code::parameter_too_large;
        } else if (is_near_zero()) {
            expand_at_zero();
            if (size <= nearest) { code_ = Functions::at_zero; }
        } else {
            expand_at_parameter(nearest * larger(Work<Scalar>(1), size));
        }
    }

    /// Returns the status. Unless it is ok, quotient() has no meaning.
    [[nodiscard]] Status status() const { return Status(code_); }

    /// Returns functions[numerator] / (divisor functions[0]^exponents[0] functions[1]^exponents[1]
    /// ...)
    template <std::size_t n>
    [[nodiscard]] Number quotient(std::size_t numerator, double divisor,
                                  const std::array<unsigned char, n>& exponents) const {
        static_assert(n <= function_count);
        Number denominator{static_cast<Work<Scalar>>(divisor)};
        int order = Functions::functions[numerator].order;
        const EntireFunction* function = Functions::functions.data();
        const Number* value = values_.data();
        for (const unsigned char exponent : exponents) {
            denominator = denominator * power(*value++, exponent);
            order -= function++->order * exponent;
        }
        const Number quotient = values_[numerator] / denominator;
        if (!is_near_zero()) { return quotient; }
        return order < 0 ? quotient / power(w_, -order) : quotient * power(w_, order);
    }

private:
    static constexpr std::size_t variables =
        1 + 2 * Functions::phases.size() + Functions::constants.size();
    static constexpr std::size_t function_count = Functions::functions.size();
    /// Returns 2^20, or less where angles would be larger than sin_cos() takes: 2^22.
    [[nodiscard]] static constexpr Work<Scalar> largest_parameter() {
        Work<Scalar> most = 4;
        for (const Phase& phase : Functions::phases) {
            const auto rate = static_cast<Work<Scalar>>(phase.rate[0]);
            most = std::max(most, rate < 0 ? -rate : rate);
        }
        return 1 / (power_of_two<Work<Scalar>>(-22) * most);
    }
    static constexpr Work<Scalar> largest = largest_parameter();
    /// Distance of a zero, relative to w where |w| > 1, below which it counts as a zero at w.
    static constexpr Work<Scalar> nearest = power_of_two<Work<Scalar>>(-20);

    /// Returns where the powers of each variable begin in a list of all powers that occur, without
    /// power 0; and the length of the list.
    [[nodiscard]] static constexpr std::array<std::size_t, variables + 1> places_of_powers() {
        std::array<std::size_t, variables + 1> begin{};
        for (std::size_t v = 0; v < variables; ++v) {
            std::size_t most = 0;
            for (const auto& term : Functions::terms) {
                most = std::max(most, std::size_t{term.powers[v]});
            }
            begin[v + 1] = begin[v] + most;
        }
        return begin;
    }
    static constexpr std::array<std::size_t, variables + 1> places = places_of_powers();

    /// Values of the functions, one after the other, from series of the variables.
    template <std::size_t n>
    class Expanded {
    public:
        using Variable = Series<Number, n>;

        explicit Expanded(const std::array<Variable, variables>& variable) {
            for (std::size_t v = 0; v < variables; ++v) {
                for (std::size_t place = places[v]; place < places[v + 1]; ++place) {
                    powers_[place] =
                        place == places[v] ? variable[v] : powers_[place - 1] * variable[v];
                }
            }
        }

        [[nodiscard]] Variable next(std::size_t terms) {
            Variable sum;
            for (; terms > 0; --terms) { sum = sum + product(*term_++); }
            return sum;
        }

    private:
        [[nodiscard]] Variable product(const Term<variables>& term) const {
            Variable result(Number{static_cast<Work<Scalar>>(term.coefficient)});
            for (std::size_t v = 0; v < variables; ++v) {
                if (term.powers[v] == 0) { continue; }
                result = result * powers_[places[v] + term.powers[v] - 1];
            }
            return result;
        }

        std::array<Variable, places[variables]> powers_;
        const Term<variables>* term_ = Functions::terms.data();
    };

    [[nodiscard]] bool is_near_zero() const {
        return abs(w_.hi) <= static_cast<Work<Scalar>>(Functions::switch_point);
    }

    /// Returns the series of w and of the constants. NOTE: the phases remain to be filled in.
    template <std::size_t n>
    [[nodiscard]] static std::array<Series<Number, n>, variables> start(const Number& w) {
        std::array<Series<Number, n>, variables> variable{};
        variable[0][0] = w;
        variable[0][1] = Number{1};
        std::size_t v = 1 + 2 * Functions::phases.size();
        for (const Expansion& constant : Functions::constants) {
            variable[v++][0] = to_pair<Work<Scalar>>(constant);
        }
        return variable;
    }

    void expand_at_zero() {
        auto variable = start<Functions::length>(Number{});
        std::size_t v = 1;
        for (const Phase& phase : Functions::phases) {
            auto& x = variable[v++];
            auto& y = variable[v++];
            const bool is_angle = phase.kind == Phase::Kind::angle;
            const Number rate = to_pair<Work<Scalar>>(phase.rate);
            y[0] = Number{1};
            if (!is_angle) { x[0] = y[0]; }
            Number term{1};
            for (std::size_t j = 1; j < Functions::length; ++j) {
                term = term * rate / Number{static_cast<Work<Scalar>>(j)};
                auto& sum = is_angle && j % 2 == 0 ? y : x;
                sum[j] = is_angle && j % 4 >= 2 ? -term : term;
            }
        }
        Expanded<Functions::length> expanded(variable);
        Number* value = values_.data();
        for (const EntireFunction& function : Functions::functions) {
            *value++ = expanded.next(function.terms)
                           .sum_from(static_cast<std::size_t>(function.order), w_);
        }
    }

    void expand_at_parameter(Work<Scalar> distance) {
        auto variable = start<2>(w_);
        std::size_t v = 1;
        for (const Phase& phase : Functions::phases) {
            auto& x = variable[v++];
            auto& y = variable[v++];
            const Number rate = to_pair<Work<Scalar>>(phase.rate);
            const Number argument = rate * w_;
            if (phase.kind == Phase::Kind::angle) {
                const auto [sin, cos] = sin_cos(argument);
                x[0] = sin;
                y[0] = cos;
                x[1] = rate * cos;
                y[1] = -(rate * sin);
            } else {
                const bool grows = argument.hi > 0;
                auto& small = grows ? y : x;
                (grows ? x : y)[0] = Number{1};
                small[0] = exp(grows ? -argument : argument);
                small[1] = (grows ? -rate : rate) * small[0];
            }
        }
        Expanded<2> expanded(variable);
        Number* value = values_.data();
        for (const EntireFunction& function : Functions::functions) {
            const auto series = expanded.next(function.terms);
            *value++ = series[0];
            if (function.role == EntireFunction::Role::numerator || code_ == Status::Code::pole) {
                continue;
            }
            // NOTE: not `<=`, so that a NaN, from an overflow, does not pass.
            if (!(abs(series[0].hi) > distance * abs(series[1].hi))) {
                code_ = function.role == EntireFunction::Role::pole ? Status::Code::pole
                                                                    : Status::Code::zero_weight;
            }
        }
    }

    Number w_;
    std::array<Number, function_count> values_{};
    Status::Code code_ = Status::Code::ok;
};

/// Rounds m and 1 - m so that they add up to 1 without rounding, as coefficients.hpp requires. The
/// larger one is rounded to Scalar, and the other one follows from it. Returns false where Scalar
/// has no such numbers, because m is huge or not a number.
template <class Scalar>
[[nodiscard]] bool round_complementary(const Pair<Work<Scalar>>& exact, Scalar& m, Scalar& mt) {
    const Pair<Work<Scalar>> rest = Pair<Work<Scalar>>{1} - exact;
    if (abs(exact.hi) > abs(rest.hi)) {
        m = to_scalar<Scalar>(exact);
        mt = 1 - m;
    } else {
        mt = to_scalar<Scalar>(rest);
        m = 1 - mt;
    }
    constexpr Scalar most = 1 / power_of_two<Scalar>(-bits<Scalar>);
    return abs(m) <= most && abs(mt) <= most;
}

}  // namespace hvi::detail

#endif  // HVI_PARAMETER_HPP
