// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/entire.hpp"

#include <arb_poly.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "generator/exact/number_value.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Arb's polynomials, as power series, with value semantics.
class BallSeries {
public:
    BallSeries() { arb_poly_init(series_); }
    BallSeries(const BallSeries& other) : BallSeries() { arb_poly_set(series_, other.series_); }
    BallSeries& operator=(BallSeries other) noexcept {
        arb_poly_swap(series_, other.series_);
        return *this;
    }
    ~BallSeries() { arb_poly_clear(series_); }

    [[nodiscard]] arb_poly_struct* get() { return series_; }
    [[nodiscard]] const arb_poly_struct* get() const { return series_; }

    [[nodiscard]] Ball coefficient(std::size_t index) const {
        Ball result;
        arb_poly_get_coeff_arb(result.get(), series_, static_cast<slong>(index));
        return result;
    }

private:
    arb_poly_t series_;
};

Ball absolute(Ball ball) {
    arb_abs(ball.get(), ball.get());
    return ball;
}

/// A function with its constants enclosed once.
class EnclosedFunction {
public:
    /// With `majorant` every term of every series is made positive.
    EnclosedFunction(const EntireFunction& function, const EntireGenerators& generators,
                     Precision bits, bool majorant = false)
        : bits_(bits), majorant_(majorant) {
        for (const Phase& phase : generators.phases) {
            phases_.emplace_back(phase.kind, part(enclosure(phase.rate, bits)));
        }
        std::vector<Ball> constants;
        for (const Number& constant : generators.constants) {
            constants.push_back(enclosure(constant, bits));
        }
        const std::size_t variables = 1 + 2 * phases_.size();
        most_.resize(variables);
        for (const EntireFunction::Term& term : function.terms) {
            Ball coefficient = enclosure(term.coefficient, bits);
            for (std::size_t k = 0; k < constants.size(); ++k) {
                Ball power;
                arb_pow_ui(power.get(), constants[k].get(), term.powers[variables + k], bits);
                arb_mul(coefficient.get(), coefficient.get(), power.get(), bits);
            }
            const auto end = term.powers.begin() + static_cast<long>(variables);
            const std::vector<unsigned> powers(term.powers.begin(), end);
            Ball& sum = terms_[powers];
            arb_add(sum.get(), sum.get(), part(coefficient).get(), bits);
            for (std::size_t v = 0; v < variables; ++v) {
                most_[v] = std::max(most_[v], powers[v]);
            }
        }
    }

    /// The power series at `point`, which is not negative for a majorant.
    [[nodiscard]] BallSeries at(const Ball& point, std::size_t length) const {
        const auto count = static_cast<slong>(length);
        const std::vector<std::vector<BallSeries>> powers = powers_at(point, count);
        BallSeries sum;
        for (const auto& [exponents, coefficient] : terms_) {
            BallSeries product;
            arb_poly_set_arb(product.get(), coefficient.get());
            for (std::size_t v = 0; v < exponents.size(); ++v) {
                if (exponents[v] == 0) { continue; }
                const BallSeries& power = powers[v][exponents[v] - 1];
                arb_poly_mullow(product.get(), product.get(), power.get(), count, bits_);
            }
            arb_poly_add(sum.get(), sum.get(), product.get(), bits_);
        }
        return sum;
    }

private:
    [[nodiscard]] Ball part(const Ball& ball) const { return majorant_ ? absolute(ball) : ball; }

    /// scale * (point + t).
    [[nodiscard]] BallSeries line(const Ball& scale, const Ball& point) const {
        Ball constant;
        arb_mul(constant.get(), scale.get(), point.get(), bits_);
        BallSeries result;
        arb_poly_set_coeff_arb(result.get(), 0, constant.get());
        arb_poly_set_coeff_arb(result.get(), 1, scale.get());
        return result;
    }

    /// Of w and of each x and y, from the first to the largest that occurs.
    [[nodiscard]] std::vector<std::vector<BallSeries>> powers_at(const Ball& point,
                                                                 slong count) const {
        Ball one;
        arb_one(one.get());
        std::vector<BallSeries> variables{line(one, point)};
        for (const auto& [kind, rate] : phases_) {
            const BallSeries argument = line(rate, point);
            BallSeries& x = variables.emplace_back();
            BallSeries y;
            if (kind == Phase::Kind::exponential) {
                arb_poly_exp_series(x.get(), argument.get(), count, bits_);
                arb_poly_one(y.get());
            } else if (majorant_) {
                arb_poly_sinh_cosh_series(x.get(), y.get(), argument.get(), count, bits_);
            } else {
                arb_poly_sin_cos_series(x.get(), y.get(), argument.get(), count, bits_);
            }
            variables.push_back(std::move(y));
        }
        std::vector<std::vector<BallSeries>> powers(variables.size());
        for (std::size_t v = 0; v < variables.size(); ++v) {
            for (unsigned k = 0; k < most_[v]; ++k) {
                BallSeries power = variables[v];
                if (k > 0) {
                    arb_poly_mullow(power.get(), power.get(), powers[v].back().get(), count, bits_);
                }
                powers[v].push_back(std::move(power));
            }
        }
        return powers;
    }

    Precision bits_;
    bool majorant_;
    std::vector<std::pair<Phase::Kind, Ball>> phases_;
    std::map<std::vector<unsigned>, Ball> terms_;  ///< coefficients of powers of w, x and y
    std::vector<unsigned> most_;
};

// ---- exactly, at w = 0 ----

using NumberSeries = std::vector<Number>;

NumberSeries product(const NumberSeries& a, const NumberSeries& b) {
    NumberSeries result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (is_exactly(a[i], 0)) { continue; }
        for (std::size_t j = 0; i + j < b.size(); ++j) {
            if (is_exactly(b[j], 0)) { continue; }
            result[i + j] = result[i + j] + a[i] * b[j];
        }
    }
    return result;
}

/// rate^n/n!, with the signs and the gaps of sin (first = 1) and cos (first = 0), or of exp.
NumberSeries phase_series(const Phase& phase, std::size_t first, std::size_t length) {
    NumberSeries result(length);
    Number term(1);
    for (std::size_t n = 0; n < length; ++n) {
        if (n > 0) { term = term * phase.rate / Number(static_cast<long>(n)); }
        if (phase.kind == Phase::Kind::exponential) {
            result[n] = term;
        } else if (n % 2 == first) {
            result[n] = (n / 2) % 2 == 0 ? term : -term;
        }
    }
    return result;
}

/// Of w and of the x and y of phases.
std::vector<NumberSeries> exact_series_of(const EntireGenerators& generators, std::size_t length) {
    NumberSeries w(length);
    if (length > 1) { w[1] = Number(1); }
    std::vector<NumberSeries> result{std::move(w)};
    for (const Phase& phase : generators.phases) {
        result.push_back(phase_series(phase, 1, length));
        if (phase.kind == Phase::Kind::angle) {
            result.push_back(phase_series(phase, 0, length));
        } else {
            result.push_back(NumberSeries(length));
            result.back().front() = Number(1);
        }
    }
    return result;
}

/// The function as a polynomial in w and in the phases, with constants for coefficients.
std::map<std::vector<unsigned>, Number> without_constants(const EntireFunction& function,
                                                          const EntireGenerators& generators) {
    const std::size_t variables = 1 + 2 * generators.phases.size();
    std::map<std::vector<unsigned>, Number> result;
    for (const EntireFunction::Term& term : function.terms) {
        Number coefficient = term.coefficient;
        for (std::size_t k = 0; k < generators.constants.size(); ++k) {
            for (unsigned n = 0; n < term.powers[variables + k]; ++n) {
                coefficient = coefficient * generators.constants[k];
            }
        }
        const auto end = term.powers.begin() + static_cast<long>(variables);
        Number& sum = result[{term.powers.begin(), end}];
        sum = sum + coefficient;
    }
    return result;
}

/// Whether the first coefficients of the series are zero, by normal forms.
bool vanishes(const EntireFunction& function, const EntireGenerators& generators,
              std::size_t order) {
    if (order == 0) { return true; }
    const std::vector<NumberSeries> variables = exact_series_of(generators, order);
    std::vector<std::vector<NumberSeries>> powers_of(variables.size());
    NumberSeries sum(order);
    for (const auto& [powers, coefficient] : without_constants(function, generators)) {
        NumberSeries summand(order);
        summand.front() = coefficient;
        for (std::size_t v = 0; v < powers.size(); ++v) {
            auto& known = powers_of[v];
            if (known.empty()) { known.push_back(variables[v]); }
            while (known.size() < powers[v]) {
                known.push_back(product(known.back(), known.front()));
            }
            if (powers[v] > 0) { summand = product(summand, known[powers[v] - 1]); }
        }
        for (std::size_t j = 0; j < order; ++j) { sum[j] = sum[j] + summand[j]; }
    }
    return std::all_of(sum.begin(), sum.end(), [](const Number& c) { return c.is_zero(); });
}

// ---- series or formula ----

/// As many coefficients as the bounds look at one by one, and with how many bits.
constexpr std::size_t longest = 64;
constexpr Precision near_zero_bits = 512;

/// One function near w = 0, and the sum of the absolute values of its terms.
class NearZero {
public:
    NearZero(const EntireFunction& function, const EntireGenerators& generators)
        : sum_of_sizes_(function, generators, near_zero_bits, true) {
        const Ball zero;
        coefficients_ = EnclosedFunction(function, generators, near_zero_bits).at(zero, longest);
        majorant_ = sum_of_sizes_.at(zero, longest);
        while (order_ < longest && coefficients_.coefficient(order_).sign() == 0) { ++order_; }
        half_leading_ = absolute(coefficients_.coefficient(order_));
        arb_mul_2exp_si(half_leading_.get(), half_leading_.get(), -1);
    }

    /// Of the first coefficient that is proved not to be zero.
    [[nodiscard]] unsigned order() const { return order_; }

    /// |f| >= |leading w^order|/2 for |w| <= 2^at: no zero but w = 0, and a bound from below.
    [[nodiscard]] bool is_dominated(int at) const {
        Ball rest = majorant_from(longest, at);
        for (std::size_t j = order_ + 1; j < longest; ++j) {
            add(rest, absolute(coefficients_.coefficient(j)), j, at);
        }
        return is_below(rest, 0, at);
    }

    /// Few digits are lost where the terms are added as they are written, at w = 2^at.
    [[nodiscard]] bool is_good_as_written(int at) const {
        return is_below(majorant_from(0, at), SeriesPlan::lost_bits, at);
    }

    /// Few digits are lost to the coefficients of the series, of which those below are known zeros.
    [[nodiscard]] bool is_good_as_series(int at) const {
        return is_below(majorant_from(order_, at), SeriesPlan::lost_bits, at);
    }

    /// How many coefficients of the series are needed, where no more than `longest` are.
    [[nodiscard]] std::optional<std::size_t> needed(int at) const {
        constexpr int remainder = -118;
        for (std::size_t length = order_ + 1; length <= longest; ++length) {
            if (is_below(majorant_from(length, at), remainder, at)) { return length; }
        }
        return std::nullopt;
    }

private:
    static void add(Ball& sum, const Ball& coefficient, std::size_t power, int at) {
        Ball term = coefficient;
        arb_mul_2exp_si(term.get(), term.get(), at * static_cast<slong>(power));
        arb_add(sum.get(), sum.get(), term.get(), near_zero_bits);
    }

    /// The sum at w = 2^at without what the first coefficients give.
    [[nodiscard]] Ball majorant_from(std::size_t first, int at) const {
        Ball point;
        arb_one(point.get());
        arb_mul_2exp_si(point.get(), point.get(), at);
        Ball rest = sum_of_sizes_.at(point, 1).coefficient(0);
        for (std::size_t j = 0; j < first; ++j) {
            Ball coefficient = majorant_.coefficient(j);
            arb_neg(coefficient.get(), coefficient.get());
            add(rest, coefficient, j, at);
        }
        return rest;
    }

    /// Whether it is below 2^exponent |leading w^order|/2 at w = 2^at.
    [[nodiscard]] bool is_below(const Ball& sum, int exponent, int at) const {
        Ball bound = half_leading_;
        arb_mul_2exp_si(bound.get(), bound.get(), exponent + at * static_cast<slong>(order_));
        return arb_lt(sum.get(), bound.get()) != 0;
    }

    EnclosedFunction sum_of_sizes_;
    unsigned order_ = 0;
    Ball half_leading_;
    BallSeries coefficients_;
    BallSeries majorant_;
};

// ---- zeros ----

class ZeroSearch {
public:
    ZeroSearch(const EntireFunction& function, const EntireGenerators& generators)
        : function_(function, generators, bits) {}

    void search(double low, double high) {
        constexpr double narrowest = 1e-9;
        const double middle = low + 0.4871 * (high - low);  // NOTE: hardly ever a zero itself
        const BallSeries whole = function_.at(interval(low, high), 2);
        const Ball slope = whole.coefficient(1);
        if (mean_value(middle, interval(low - middle, high - middle), slope).sign() != 0) {
            return;
        }
        if (slope.sign() != 0) {
            const int at_low = sign(low);
            const int at_high = sign(high);
            if (at_low * at_high > 0) { return; }
            if (at_low * at_high < 0) { return found(bisected(low, high, at_low)); }
        }
        if (high - low < narrowest) { return found(middle); }
        search(low, middle);
        search(middle, high);
    }

    [[nodiscard]] std::vector<double> zeros() && { return std::move(zeros_); }

private:
    static constexpr Precision bits = 192;

    static Ball interval(double low, double high) {
        arf_t a, b;
        arf_init(a);
        arf_init(b);
        arf_set_d(a, low);
        arf_set_d(b, high);
        Ball result;
        arb_set_interval_arf(result.get(), a, b, bits);
        arf_clear(a);
        arf_clear(b);
        return result;
    }

    [[nodiscard]] Ball value(double w) const {
        return function_.at(interval(w, w), 1).coefficient(0);
    }

    [[nodiscard]] int sign(double w) const { return value(w).sign(); }

    [[nodiscard]] Ball mean_value(double middle, const Ball& offset, const Ball& slope) const {
        Ball result = value(middle);
        arb_addmul(result.get(), offset.get(), slope.get(), bits);
        return result;
    }

    [[nodiscard]] double bisected(double low, double high, int at_low) const {
        for (int step = 0; step < 50; ++step) {
            const double middle = (low + high) / 2;
            (sign(middle) == at_low ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    void found(double zero) {
        constexpr double same = 1e-7;
        if (zeros_.empty() || zero - zeros_.back() > same) { zeros_.push_back(zero); }
    }

    EnclosedFunction function_;
    std::vector<double> zeros_;
};

}  // namespace

unsigned order_at_zero(const EntireFunction& function, const EntireGenerators& generators) {
    constexpr unsigned most = 60;
    const unsigned order = NearZero(function, generators).order();
    if (order > most || !vanishes(function, generators, order)) {
        throw MathError("cannot decide how a coefficient behaves where the parameter is 0");
    }
    return order;
}

SeriesPlan series_plan(const std::vector<EntireFunction>& functions,
                       const EntireGenerators& generators) {
    constexpr int smallest = -24;
    constexpr int largest = 3;
    std::vector<NearZero> near_zero;
    for (const EntireFunction& function : functions) {
        near_zero.emplace_back(function, generators);
    }
    const auto all = [&](auto&& holds) {
        return std::all_of(near_zero.begin(), near_zero.end(), holds);
    };
    for (int at = smallest; at <= largest; ++at) {
        // NOTE: a sum of powers of w with positive coefficients, divided by a power of w, is a
        // convex function of log(w): its bounds at w = 2^at and 2^(at+1) hold between them.
        const bool good = all([&](const NearZero& f) {
            return f.is_good_as_written(at) && f.is_good_as_written(at + 1);
        });
        if (!good) { continue; }
        SeriesPlan plan{at, 1};
        const bool possible = all([&](const NearZero& f) {
            const auto length = f.needed(at);
            plan.length = std::max(plan.length, length.value_or(longest));
            return length && f.is_dominated(at + 1) && f.is_good_as_series(at);
        });
        if (possible) { return plan; }
        break;
    }
    throw MathError(
        "no way is found to evaluate the coefficients for small values of the parameter");
}

std::vector<double> real_zeros(const EntireFunction& function, const EntireGenerators& generators,
                               double most) {
    // NOTE: near 0 intervals say little of a function that vanishes there; its series does.
    constexpr int smallest = -60;
    const NearZero near_zero(function, generators);
    int at = std::ilogb(most);
    while (at > smallest && !near_zero.is_dominated(at)) { --at; }
    const double least = std::ldexp(1.0, at);
    ZeroSearch search(function, generators);
    search.search(-most, -least);
    search.search(least, most);
    return std::move(search).zeros();
}

}  // namespace hvi::gen
