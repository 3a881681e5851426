// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/functions/signs.hpp"

#include <flint/fmpq.h>

#include <cmath>

#include "generator/exact/functions/ball_function.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Precisions: bounds on intervals need few bits, signs at points more.
constexpr Precision interval_bits = 128;
constexpr Precision point_bits = 512;

/// Limits of the search for zeros: intervals of 2^-40 of the domain, and this many of them. A
/// double zero takes two intervals for each halving.
constexpr int most_halvings = 40;
constexpr int most_intervals = 20000;

/// Returns a double as a number, exactly.
Number exact_number(double value, const Ground& ground) {
    const int shift = 52;
    const auto above = static_cast<long>(std::ldexp(value, shift));
    return ground.rational(std::to_string(above), "1") / Number(1L << shift);
}

/// Returns the fraction with the smallest denominator in [left, right].
Number simplest_between(double left, double right, const Ground& ground) {
    fmpq_t low, high, middle;
    fmpq_init(low);
    fmpq_init(high);
    fmpq_init(middle);
    fmpq_set_si(low, static_cast<slong>(std::ldexp(left, 52)), 1UL << 52U);
    fmpq_set_si(high, static_cast<slong>(std::ldexp(right, 52)), 1UL << 52U);
    fmpq_simplest_between(middle, low, high);
    char* const text = fmpq_get_str(nullptr, 10, middle);
    const std::string fraction(text);
    flint_free(text);
    fmpq_clear(low);
    fmpq_clear(high);
    fmpq_clear(middle);
    const std::size_t bar = fraction.find('/');
    return ground.rational(fraction.substr(0, bar),
                           bar == std::string::npos ? "1" : fraction.substr(bar + 1));
}

/// The search for zeros of a function on a domain, in t of [0, 1] with tau = low + (high - low) t.
/// The ends of intervals are doubles of at most 40 bits: exact.
class Search {
public:
    Search(const ExactFunction& function, const Domain& domain, const Ground& ground)
        : function_(function),
          domain_(domain),
          ground_(ground),
          on_intervals_(compile(function, interval_bits)),
          at_points_(compile(function, point_bits)),
          low_(enclosure(domain.low, point_bits)),
          width_(enclosure(domain.high - domain.low, point_bits)) {}

    Signs run() {
        const Progress::Stage stage("looking for singularities of the basis");
        result_.zero_at_low = is_zero_at(Number(0));
        result_.zero_at_high = is_zero_at(Number(1));
        visit(0.0, 1.0, 0);
        return result_;
    }

private:
    [[nodiscard]] bool done() const { return result_.inner_zero || result_.undecided; }

    [[nodiscard]] Number tau(const Number& t) const {
        return domain_.low + (domain_.high - domain_.low) * t;
    }

    [[nodiscard]] Ball tau(double left, double right, Precision bits) const {
        Ball t;
        arf_t a, b;
        arf_init(a);
        arf_init(b);
        arf_set_d(a, left);
        arf_set_d(b, right);
        arb_set_interval_arf(t.get(), a, b, bits);
        arf_clear(a);
        arf_clear(b);
        arb_mul(t.get(), t.get(), width_.get(), bits);
        arb_add(t.get(), t.get(), low_.get(), bits);
        return t;
    }

    /// Returns whether the value at tau(t) is proved to be zero.
    ///
    /// NOTE: bounds come first, since an exact value brings new generators into the field.
    [[nodiscard]] bool is_zero_at(const Number& t) const {
        if (real_values(at_points_, enclosure(tau(t), point_bits)).sign() != 0) return false;
        try {
            return function_.at(tau(t), ground_).known_zero() == true;
        } catch (const Error&) { return false; }  // the function has no value there
    }

    /// Returns the sign at the point t; 0 when it is zero, empty when it is not known.
    [[nodiscard]] std::optional<int> sign_at(double t) const {
        if (t == 0.0 && result_.zero_at_low) return 0;
        if (t == 1.0 && result_.zero_at_high) return 0;
        if (const int sign = real_values(at_points_, tau(t, t, point_bits)).sign()) return sign;
        if (is_zero_at(exact_number(t, ground_))) return 0;
        return std::nullopt;
    }

    /// Returns whether bounds on the values, or on a value and the slope, exclude a zero.
    bool excluded(const Ball& interval, const Ball& middle, Ball& slope) const {
        const Jet jet = on_intervals_({ComplexBall(interval), one(), true}, false);
        Ball value;
        arb_set(value.get(), acb_realref(jet.value.get()));
        arb_set(slope.get(), acb_realref(jet.slope.get()));
        if (value.sign() != 0) return true;
        Ball step;
        arb_sub(step.get(), interval.get(), middle.get(), interval_bits);
        arb_mul(step.get(), step.get(), slope.get(), interval_bits);
        const Ball centre = real_values(on_intervals_, middle);
        arb_add(step.get(), step.get(), centre.get(), interval_bits);
        return step.sign() != 0;
    }

    static ComplexBall one() {
        ComplexBall result;
        acb_one(result.get());
        return result;
    }

    void visit(double left, double right, int halvings) {
        if (done()) return;
        const double middle = (left + right) / 2;
        Ball slope;
        ++intervals_;
        if (excluded(tau(left, right, interval_bits), tau(middle, middle, interval_bits), slope)) {
            return;
        }
        if (slope.sign() != 0 && decided_by_ends(left, right)) return;
        if (halvings == most_halvings || intervals_ > most_intervals) {
            give_up(left, right);
            return;
        }
        visit(left, middle, halvings + 1);
        visit(middle, right, halvings + 1);
    }

    /// Decides a monotonic function by the signs at the ends of an interval.
    bool decided_by_ends(double left, double right) {
        const auto a = sign_at(left);
        const auto b = sign_at(right);
        if (!a || !b) return false;
        if (*a == 0 && left != 0.0) {
            result_.inner_zero = at_tau(tau(exact_number(left, ground_)));
        } else if (*b == 0 && right != 1.0) {
            result_.inner_zero = at_tau(tau(exact_number(right, ground_)));
        } else if (*a * *b < 0) {
            result_.inner_zero = crossing(left, right, *a);
        }
        result_.changes = result_.inner_zero.has_value();
        return true;
    }

    /// Returns the place of a change of sign.
    std::string crossing(double left, double right, int sign_left) {
        while (right - left > std::ldexp(1.0, -most_halvings)) {
            const double middle = (left + right) / 2;
            const auto sign = sign_at(middle);
            if (!sign) break;
            if (*sign == 0) return at_tau(tau(exact_number(middle, ground_)));
            (*sign == sign_left ? left : right) = middle;
        }
        const Number simple = simplest_between(left, right, ground_);
        if (is_zero_at(simple)) return at_tau(tau(simple));
        return near(left, right);
    }

    [[nodiscard]] std::string near(double left, double right) const {
        return "near tau = " + tau(exact_number((left + right) / 2, ground_)).decimal(4);
    }

    /// Gives up on an interval. A double zero is found when its place is a simple fraction of the
    /// domain; a zero at an end may be of any order.
    void give_up(double left, double right) {
        const Number simple = simplest_between(left, right, ground_);
        const bool inner = simple.sign() > 0 && (Number(1) - simple).sign() > 0;
        if (inner && is_zero_at(simple)) {
            result_.inner_zero = at_tau(tau(simple));
        } else {
            result_.undecided = near(left, right);
        }
    }

    const ExactFunction& function_;
    const Domain& domain_;
    const Ground& ground_;
    BallFunction on_intervals_;
    BallFunction at_points_;
    Ball low_;
    Ball width_;
    Signs result_;
    int intervals_ = 0;
};

/// Returns the real roots of a part of a factorization.
NumberVector roots_of(const NumberPolynomial& part, const Ground& ground) {
    if (part.size() == 2) return {-part[0]};
    if (part.size() == 3) return {};
    const auto rational = over_rationals(part);
    HVI_CHECK(rational);
    return real_roots(*rational, ground);
}

Signs signs_of_polynomial(const Factorization& factors, const Domain& domain,
                          const Ground& ground) {
    Signs result;
    std::optional<Number> first;
    for (const auto& [part, multiplicity] : factors.parts) {
        for (const Number& root : roots_of(part, ground)) {
            const int low = (root - domain.low).sign();
            const int high = (domain.high - root).sign();
            if (low == 0) result.zero_at_low = true;
            if (high == 0) result.zero_at_high = true;
            if (low <= 0 || high <= 0) continue;
            if (first && (root - *first).sign() > 0) continue;
            first = root;
            result.changes = multiplicity % 2 == 1;
        }
    }
    if (first) result.inner_zero = at_tau(*first);
    return result;
}

}  // namespace

std::optional<std::string> Signs::zero(const Domain& domain) const {
    if (zero_at_low) return at_tau(domain.low);
    if (inner_zero) return inner_zero;
    return zero_at_high ? std::optional(at_tau(domain.high)) : std::nullopt;
}

Signs signs(const ExactFunction& function, const Domain& domain, const Ground& ground) {
    if (function.is_polynomial()) {
        const auto factors = factorize(function.coefficients(), ground);
        if (factors) return signs_of_polynomial(*factors, domain, ground);
    }
    return Search(function, domain, ground).run();
}

std::optional<std::string> negative_place(const ExactFunction& function, const Domain& domain) {
    const BallFunction values = compile(function, point_bits);
    // the ends, the middle, the quarters, ...
    for (long parts = 1; parts <= 64; parts *= 2) {
        for (long i = 0; i <= parts; ++i) {
            if (parts > 1 && i % 2 == 0) continue;
            const Number t = Number(i) / Number(parts);
            const Number point = domain.low + (domain.high - domain.low) * t;
            if (real_values(values, enclosure(point, point_bits)).sign() < 0) {
                return at_tau(point);
            }
        }
    }
    return std::nullopt;
}

}  // namespace hvi::gen
