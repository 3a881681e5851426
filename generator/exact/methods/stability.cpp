// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/stability.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/polynomial_in_square.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// A z at which stability may change.
struct SpecialPoint {
    enum class Kind { pole, identity, jordan_block };
    Kind kind;
    Number z;
    int half_trace = 0;  ///< 1 or -1, except at a pole
};

/// Zeros of half_trace - 1 and half_trace + 1 and of D, and the signs between them.
class SpecialPoints {
public:
    SpecialPoints(const OscillatorMap& map, long until) : until_(until) {
        const NumberPolynomial trace = arithmetic_.sum(even(map.m11), Number(1), even(map.m22));
        const NumberPolynomial D = even(map.D);
        minus_one_ = arithmetic_.sum(trace, Number(-2), D);
        plus_one_ = arithmetic_.sum(trace, Number(2), D);
        const NumberPolynomial poles = arithmetic_.squarefree(D);
        append(poles, SpecialPoint::Kind::pole, 0);
        append_ends(map, minus_one_, poles, 1);
        append_ends(map, plus_one_, poles, -1);
        std::sort(points_.begin(), points_.end(),
                  [](const SpecialPoint& a, const SpecialPoint& b) { return is_less(a.z, b.z); });
    }

    [[nodiscard]] std::size_t size() const { return points_.size(); }
    [[nodiscard]] const SpecialPoint& operator[](std::size_t i) const { return points_[i]; }
    [[nodiscard]] bool proved() const { return arithmetic_.proved(); }

    /// Returns whether |half_trace| < 1, that is (half_trace - 1) (half_trace + 1) < 0, on the open
    /// interval before point i, or after the last one.
    [[nodiscard]] bool is_stable_before(std::size_t i) const {
        if (minus_one_.empty() || plus_one_.empty()) { return false; }
        const Ball z = between(i == 0 ? Number(0) : points_[i - 1].z,
                               i == points_.size() ? Number(until_) : points_[i].z);
        return sign_at(minus_one_, z) * sign_at(plus_one_, z) < 0;
    }

private:
    void append(const NumberPolynomial& polynomial, SpecialPoint::Kind kind, int half_trace) {
        for (const Number& z : roots_in_square(polynomial, until_)) {
            points_.push_back({kind, z, half_trace});
        }
    }

    /// Appends the roots of half_trace -+ 1; the map is +-I where m12, m21 and m11 - m22 vanish as
    /// well.
    void append_ends(const OscillatorMap& map, NumberPolynomial difference,
                     const NumberPolynomial& poles, int half_trace) {
        while (!difference.empty() && arithmetic_.is_zero(difference.front())) {
            difference.erase(difference.begin());
        }
        if (difference.empty()) { return; }
        const NumberPolynomial ends =
            arithmetic_.without(arithmetic_.squarefree(difference), poles);
        // NOTE: m12 and m21 first: where a method has no such point they are coprime, which is the
        // quickest to see.
        NumberPolynomial identity = arithmetic_.gcd(odd(map.m12), odd(map.m21));
        const NumberPolynomial asymmetry =
            arithmetic_.sum(even(map.m11), Number(-1), even(map.m22));
        for (const NumberPolynomial& other : {asymmetry, ends}) {
            if (identity.size() != 1) { identity = arithmetic_.gcd(identity, other); }
        }
        append(identity, SpecialPoint::Kind::identity, half_trace);
        append(identity.size() > 1 ? arithmetic_.divide(ends, identity).quotient : ends,
               SpecialPoint::Kind::jordan_block, half_trace);
    }

    long until_;
    PolynomialArithmetic arithmetic_;
    NumberPolynomial minus_one_, plus_one_;  ///< 2 D (half_trace -+ 1)
    std::vector<SpecialPoint> points_;
};

/// Returns whether each of the intervals between points is stable.
std::vector<bool> stable_gaps(const SpecialPoints& points) {
    std::vector<bool> result;
    for (std::size_t i = 0; i <= points.size(); ++i) {
        result.push_back(points.is_stable_before(i));
    }
    return result;
}

/// Returns the stable intervals. NOTE: a point with +-I that is unstable on both sides is an
/// interval of one point.
std::vector<StabilityInterval> stable_intervals(const SpecialPoints& points,
                                                const std::vector<bool>& gaps, long until) {
    std::vector<StabilityInterval> result;
    std::optional<StabilityInterval> current;
    if (gaps.front()) { current = {Number(0), {}}; }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Number& z = points[i].z;
        const bool is_identity = points[i].kind == SpecialPoint::Kind::identity;
        const bool goes_on = gaps[i + 1];
        if (is_identity && !current) { current = {z, {}, true}; }
        if (current && !(is_identity && goes_on)) {
            current->high = z;
            current->high_included = is_identity;
            result.push_back(*std::exchange(current, std::nullopt));
        }
        if (goes_on && !current) { current = {z, {}}; }
    }
    if (current) {
        current->high = Number(until);
        result.push_back(*current);
    }
    return result;
}

std::vector<TouchingPoint> touching_points(const SpecialPoints& points,
                                           const std::vector<bool>& gaps) {
    std::vector<TouchingPoint> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SpecialPoint& point = points[i];
        if (point.kind == SpecialPoint::Kind::pole || !gaps[i] || !gaps[i + 1]) { continue; }
        result.push_back({point.z, point.half_trace, point.kind == SpecialPoint::Kind::identity});
    }
    return result;
}

/// Returns the limit. The leading coefficient of (half_trace - 1) (half_trace + 1) decides on large
/// z.
LimitOfHalfTrace limit(const PolynomialQuotient& half_trace, PolynomialArithmetic& arithmetic) {
    const auto& [above, below] = half_trace;
    LimitOfHalfTrace result;
    const NumberPolynomial minus_one = arithmetic.sum(above, Number(-1), below);
    const NumberPolynomial plus_one = arithmetic.sum(above, Number(1), below);
    result.is_stable = !minus_one.empty() && !plus_one.empty() &&
                       minus_one.back().sign() * plus_one.back().sign() < 0;
    if (above.size() < below.size()) {
        result.value = Number(0);
        return result;
    }
    const Number ratio = above.back() / below.back();
    result.sign = ratio.sign();
    if (above.size() == below.size()) { result.value = ratio; }
    return result;
}

/// Polynomials in t that the map consists of; m12 and m21 without a factor z.
struct Parts {
    NumberPolynomial m11, m12, m21, m22, D;
};

/// Returns the parts, by enclosures where products of exact coefficients would take minutes.
Parts parts(const OscillatorMap& map) {
    constexpr std::size_t most_terms = 200;
    Parts result{even(map.m11), odd(map.m12), odd(map.m21), even(map.m22), even(map.D)};
    const bool rational = over_rationals(result.D) && over_rationals(result.m11);
    const NumberMatrix all{result.m11, result.m12, result.m21, result.m22, result.D};
    if (rational || term_count(all) <= most_terms) { return result; }
    return {without_closed_form(result.m11), without_closed_form(result.m12),
            without_closed_form(result.m21), without_closed_form(result.m22),
            without_closed_form(result.D)};
}

/// Places where both eigenvalues lie inside the unit circle: for the determinant d and the trace s,
/// 1 - d > 0, 1 + d - s > 0 and 1 + d + s > 0 (Jury's conditions), here times D^2 > 0.
class Contraction {
public:
    Contraction(const OscillatorMap& whole, long until) : until_(until) {
        const auto [m11, m12, m21, m22, D] = parts(whole);
        const NumberPolynomial trace = arithmetic_.sum(m11, Number(1), m22);
        const NumberPolynomial determinant =
            arithmetic_.sum(product(m11, m22), Number(-1), shifted(product(m12, m21)));
        const NumberPolynomial square = product(D, D);
        const NumberPolynomial sum = arithmetic_.sum(square, Number(1), determinant);
        conditions_ = {arithmetic_.sum(square, Number(-1), determinant),
                       arithmetic_.sum(sum, Number(-1), product(D, trace)),
                       arithmetic_.sum(sum, Number(1), product(D, trace))};
        append_points(D);
    }

    [[nodiscard]] bool proved() const { return arithmetic_.proved(); }
    [[nodiscard]] const NumberVector& poles() const { return poles_; }

    [[nodiscard]] std::vector<StabilityInterval> intervals() const {
        std::vector<StabilityInterval> result;
        for (std::size_t i = 0; i <= points_.size(); ++i) {
            const Number low = i == 0 ? Number(0) : points_[i - 1];
            const Number high = i == points_.size() ? Number(until_) : points_[i];
            const Ball z = between(low, high);
            const bool contracts = std::all_of(
                conditions_.begin(), conditions_.end(), [&](const NumberPolynomial& condition) {
                    return !condition.empty() && sign_at(condition, z) > 0;
                });
            if (contracts) { result.push_back({low, high}); }
        }
        return result;
    }

    /// Returns whether the map contracts for all z from some point on.
    [[nodiscard]] bool contracts_at_infinity() const {
        return std::all_of(conditions_.begin(), conditions_.end(),
                           [](const NumberPolynomial& condition) {
                               return !condition.empty() && condition.back().sign() > 0;
                           });
    }

private:
    /// Appends the zeros of the conditions and of D, each once.
    void append_points(const NumberPolynomial& D) {
        std::vector<NumberPolynomial> seen{arithmetic_.squarefree(D)};
        for (NumberPolynomial factor : conditions_) {
            while (!factor.empty() && arithmetic_.is_zero(factor.front())) {
                factor.erase(factor.begin());
            }
            if (factor.empty()) { continue; }
            factor = arithmetic_.squarefree(factor);
            for (const NumberPolynomial& other : seen) {
                factor = arithmetic_.without(factor, other);
            }
            seen.push_back(factor);
        }
        poles_ = roots_in_square(seen.front(), until_);
        for (const NumberPolynomial& factor : seen) {
            const NumberVector roots = roots_in_square(factor, until_);
            points_.insert(points_.end(), roots.begin(), roots.end());
        }
        std::sort(points_.begin(), points_.end(), is_less);
    }

    long until_;
    PolynomialArithmetic arithmetic_;
    std::vector<NumberPolynomial> conditions_;
    NumberVector poles_, points_;
};

LinearStability contraction(const OscillatorMap& map, long until) {
    const Contraction found(map, until);
    PolynomialArithmetic arithmetic;
    LinearStability result;
    result.until = until;
    result.stable = found.intervals();
    result.poles = found.poles();
    result.at_infinity = limit(map.half_trace, arithmetic);
    result.at_infinity.is_stable = found.contracts_at_infinity();
    result.proved = map.proved && found.proved() && arithmetic.proved();
    return result;
}

}  // namespace

LinearStability linear_stability(const OscillatorMap& map, long until) {
    const Progress::Stage stage("finding the intervals of stability");
    if (!map.determinant_one.holds) { return contraction(map, until); }
    const SpecialPoints points(map, until);
    const std::vector<bool> gaps = stable_gaps(points);
    PolynomialArithmetic arithmetic;
    LinearStability result;
    result.until = until;
    result.stable = stable_intervals(points, gaps, until);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].kind == SpecialPoint::Kind::pole) { result.poles.push_back(points[i].z); }
    }
    result.touching = touching_points(points, gaps);
    result.at_infinity = limit(map.half_trace, arithmetic);
    result.proved = map.proved && points.proved() && arithmetic.proved();
    return result;
}

}  // namespace hvi::gen
