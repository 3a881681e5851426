// Flow of two bodies: the orbit of one about the other, by universal variables.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_TWO_BODIES_HPP
#define HVI_TWO_BODIES_HPP

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <hvi/detail/lanes/registers.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

// The letters are those of Wisdom & Hernandez (MNRAS 453, 2015) and Rein & Tamayo (MNRAS 452,
// 2015):
//
//     beta = 2 mu/r0 - v0^2, eta = q0.v0, zeta = mu - beta r0,
//     r0 s + eta G2 + zeta G3 = time, r = r0 + eta G1 + zeta G2,
//
// where G_k = s^k c_k(beta s^2) with Stumpff's functions c_k. They hold for ellipses, parabolas and
// hyperbolas, also about a body that repels.

/// Changes of positions and velocities along an orbit: q' = q + (f - 1) q + g v and
/// v' = v + f_rate q + (g_rate - 1) v, where g = time + g_less_time.
template <class Number, std::size_t n>
struct OrbitChanges {
    std::array<Number, n> f_less_1, g_less_time, f_rate, g_rate_less_1;
};

namespace two_bodies {

/// Unit of time: the power of 2 above a time, with the sign of the time. So neither numbers in this
/// unit nor changes out of it are rounded, whatever the scales.
template <class Number>
struct TimeUnit {
    Number unit, time;  ///< the unit, and the time in this unit: from 1/2 to 1

    explicit TimeUnit(Number of) {
        // NOTE: where long double is narrower, it has the exponents all the same.
        using Standard = std::conditional_t<is_standard<Number>, Number, long double>;
        int exponent = 0;
        const Standard rounded = static_cast<Standard>(of);
        const Standard mantissa = std::frexp(rounded, &exponent);
        unit = mantissa == 0 ? Number(1) : static_cast<Number>(rounded / std::abs(mantissa));
        time = of / unit;
    }
};

/// mu, eta, beta and zeta of an orbit whose first distance is the unit of length.
template <class Part>
struct UnitOrbit {
    Part mu, eta, beta, zeta;
};

/// Returns the orbit of r2 = q.q, rv = q.v, v2 = v.v and mu. Where mu is 0 it is one that stays.
template <class Part>
[[nodiscard, gnu::always_inline]] inline UnitOrbit<Part>
unit_orbit(const Part& r2, const Part& rv, const Part& v2, const Part& mu, const Part& unit) {
    using math::sqrt;
    const auto is_free = mu == Part(0);
    const Part inverse = Part(1) / sqrt(r2);
    const Part tempo = unit * inverse;
    // NOTE: 0 times a number that is not finite is NaN.
    const Part unit_mu = select(is_free, mu * r2, mu * inverse * tempo * tempo);
    const Part eta = select(is_free, mu * rv, rv * inverse * tempo);
    const Part speed2 = select(is_free, mu * v2, v2 * tempo * tempo);
    return {unit_mu, eta, unit_mu + (unit_mu - speed2), speed2 - unit_mu};
}

// ---- Stumpff's functions ----

/// Returns how many terms of 1 - x 2!/4! + x^2 2!/6! - ... give it to round-off for |x| <= 1.
template <class Number>
[[nodiscard]] constexpr std::size_t count_stumpff_terms() {
    std::size_t count = 1;
    for (Number term = 1; term > epsilon<Number> / 64; ++count) {
        term /= static_cast<Number>((2 * count + 1) * (2 * count + 2));
    }
    return count;
}
template <class Number>
inline constexpr std::size_t stumpff_terms = count_stumpff_terms<Number>();

/// Returns the coefficients 1/k!, -1/(k + 2)!, 1/(k + 4)!, ... of c_k.
template <class Number, std::size_t k>
[[nodiscard]] constexpr std::array<Number, stumpff_terms<Number>> stumpff_series() {
    std::array<Number, stumpff_terms<Number>> series{};
    Number factorial = 1;
    for (std::size_t i = 2; i <= k; ++i) { factorial *= static_cast<Number>(i); }
    for (std::size_t i = 0; i < series.size(); ++i) {
        series[i] = 1 / factorial;
        factorial *= -static_cast<Number>((k + 2 * i + 1) * (k + 2 * i + 2));
    }
    return series;
}
template <class Number, std::size_t k>
inline constexpr auto stumpff_coefficients = stumpff_series<Number, k>();

/// The remainder of 1/3!, which rounding cuts off. NOTE: products with powers of two are exact, and
/// so are these differences.
template <class Number>
inline constexpr Number rest_of_sixth = ((1 - 8 * (Number(1) / 6)) + 2 * (Number(1) / 6)) / 6;

/// Returns the series of c_k from the term of x^from on, divided by x^from, every `by`th term.
template <class Number, std::size_t k, std::size_t from, std::size_t by, class Part>
[[nodiscard, gnu::always_inline]] inline Part stumpff_tail(const Part& power) {
    constexpr auto& series = stumpff_coefficients<Number, k>;
    constexpr std::size_t last = from + (series.size() - 1 - from) / by * by;
    Part sum(series[last]);
    for (std::size_t i = last; i > from; i -= by) { sum = sum * power + Part(series[i - by]); }
    return sum;
}

/// c_2 and c_3 of one argument, less 1/2 and less 1/6 as rounded.
template <class Part>
struct Stumpff {
    Part c2_less, c3_less;
};

/// Returns c_2(x) and c_3(x) for |x| <= 1.
///
/// NOTE: a coefficient that is the same in each step has an error that is the same, by which the
/// energy would drift. So the first ones are followed by what rounding cuts off from them.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline Stumpff<Part> stumpff_near_0(const Part& x) {
    constexpr Number lost = rest_of_sixth<Number>;
    const Part square = x * x;
    const Part tail2 =
        stumpff_tail<Number, 2, 2, 2>(square) + x * stumpff_tail<Number, 2, 3, 2>(square);
    const Part tail3 =
        stumpff_tail<Number, 3, 2, 2>(square) + x * stumpff_tail<Number, 3, 3, 2>(square);
    const Part next2 = (x * tail2 - Part(lost / 4)) + Part(stumpff_coefficients<Number, 2>[1]);
    const Part next3 = x * tail3 + Part(stumpff_coefficients<Number, 3>[1]);
    return {x * next2, x * next3 + Part(lost)};
}

/// Limit on how often arguments are quartered. Beyond it G_k overflow.
inline constexpr std::size_t most_quarterings = 16;

/// Arguments quartered until they are at most 1, and where they were, each time.
template <class Part>
struct Quarters {
    Part y;
    std::array<typename MaskOf<Part>::type, most_quarterings> is_quartered;
    std::size_t count = 0;

    explicit Quarters(const Part& x) : y(x) {}
};

template <class Number, class Part>
[[gnu::noinline]] void quarter(Quarters<Part>& x) {
    const Part one(1), quarter(Number(1) / 4);
    for (; x.count < most_quarterings && any(one < abs(x.y)); ++x.count) {
        x.is_quartered[x.count] = one < abs(x.y);
        x.y = select(x.is_quartered[x.count], quarter * x.y, x.y);
    }
}

/// Returns c_2(x) and c_3(x) from those of the quarters, which are `near`.
template <class Number, class Part>
[[nodiscard, gnu::noinline]] Stumpff<Part>
stumpff_of_quarters(const Part& x, const Quarters<Part>& quarters, const Stumpff<Part>& near) {
    using Mask = typename MaskOf<Part>::type;
    const Part one(1), half(Number(1) / 2), quarter(Number(1) / 4);
    const Part sixth(stumpff_coefficients<Number, 3>[0]);
    Part y = quarters.y, c2 = half + near.c2_less, c3 = sixth + near.c3_less;
    for (std::size_t k = quarters.count; k > 0; --k) {
        const Mask& mask = quarters.is_quartered[k - 1];
        const Part c0 = one - y * c2, c1 = one - y * c3;
        c3 = select(mask, quarter * (c2 + c0 * c3), c3);
        c2 = select(mask, half * (c1 * c1), c2);
        y = select(mask, Part(4) * y, y);
    }
    const Mask is_near = abs(x) <= one;
    return {select(is_near, near.c2_less, c2 - half), select(is_near, near.c3_less, c3 - sixth)};
}

/// Returns c_2(x) and c_3(x).
///
/// NOTE: the series stand in one place, so that compilers fuse their products and sums alike
/// whether other orbits need quarters or not.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline Stumpff<Part> stumpff(const Part& x) {
    Quarters<Part> quarters(x);
    if (any(Part(1) < abs(x))) { quarter<Number>(quarters); }
    const Stumpff<Part> near = stumpff_near_0<Number>(quarters.y);
    return quarters.count > 0 ? stumpff_of_quarters<Number>(x, quarters, near) : near;
}

// ---- Kepler's equation ----

/// A place s on an orbit, what holds there, and how far away the place of a time is. G_k are
/// followed by the parts of G_k that their first terms s, s^2/2 and s^3/6 leave.
template <class Part>
struct Place {
    Part s, square, cube;
    Part G0, G1, G2, G1_less, G2_less, G3_less;
    Part r, r_less_1, inverse;  ///< distance, and 1/r
    Part r_rate, r_bend;        ///< derivatives of r by s
    Part time_left;
    Part rest;   ///< the place of the time is s + rest, to order 6 in what is left
    Part order;  ///< square of what the order is in
};

/// Returns d for e = d + a d^2 + b d^3 - beta (a d^4/12 + b d^5/20), to order e^5.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline Part inverse_series(const Part& e, const Part& a,
                                                             const Part& b, const Part& beta) {
    const Part a2 = a * a;
    const Part third = Part(2) * a2 - b;
    const Part fourth = a * (Part(5) * (b - a2) + Part(Number(1) / 12) * beta);
    const Part fifth = Part(7) * a2 * (third - b) + Part(3) * b * b +
                       beta * (Part(Number(1) / 20) * b - Part(Number(1) / 2) * a2);
    const Part e2 = e * e;
    return e + e2 * ((third * e - a) + e2 * (fourth + fifth * e));
}

/// Returns the place at s, where `time` is sought.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline Place<Part> place_at(const UnitOrbit<Part>& orbit,
                                                              const Part& s, const Part& time) {
    const Part half(Number(1) / 2), sixth(stumpff_coefficients<Number, 3>[0]);
    Place<Part> at;
    at.s = s;
    at.square = s * s;
    at.cube = s * at.square;
    const Part x = orbit.beta * at.square;
    const Stumpff<Part> c = stumpff<Number>(x);
    at.G0 = Part(1) - x * (half + c.c2_less);
    at.G1_less = -(s * (x * (sixth + c.c3_less)));
    at.G2_less = at.square * c.c2_less;
    at.G3_less = at.cube * c.c3_less;
    at.G1 = s + at.G1_less;
    at.G2 = half * at.square + at.G2_less;
    const Part G3 = sixth * at.cube + at.G3_less;
    at.r_less_1 = orbit.eta * at.G1 + orbit.zeta * at.G2;
    at.r = Part(1) + at.r_less_1;
    at.inverse = Part(1) / at.r;
    at.r_rate = orbit.eta * at.G0 + orbit.zeta * at.G1;
    at.r_bend = orbit.zeta * at.G0 - orbit.beta * orbit.eta * at.G1;
    at.time_left = (time - s) - (orbit.eta * at.G2 + orbit.zeta * G3);
    const Part e = at.time_left * at.inverse;
    const Part a = half * at.r_rate * at.inverse;
    const Part b = Part(Number(1) / 6) * at.r_bend * at.inverse;
    at.rest = inverse_series<Number>(e, a, b, orbit.beta);
    at.order = (e * e) * (a * a + abs(b));
    return at;
}

/// Returns where the rest is so small that the orders from the sixth on are round-off.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline auto is_near(const Place<Part>& at) {
    constexpr Number small = power_of_two<Number>(-bits<Number> / 5 - 1);
    return abs(at.rest) <= Part(small) * abs(at.s) && at.order <= Part(small * small);
}

/// The four changes of one orbit, or of several.
template <class Part>
struct PartOfChanges {
    Part f_less_1, g_less_time, f_rate, g_rate_less_1;
};

/// Returns the changes from the beginning of an orbit to the place of the time.
///
/// NOTE: the rest moves G_k and r by the functions g_k of the rest, not s, which would be rounded.
/// It is added to what G_k have beyond their first terms: where it is added to G_k as rounded, the
/// energy walks a quarter further. On a circle G_k and r are the same in each step, and so would be
/// the errors of rounding them: they are rounded with mu only, and what rounding cuts off from r is
/// taken from the numerator.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline PartOfChanges<Part>
changes_to(const UnitOrbit<Part>& orbit, const Place<Part>& at, const Part& unit) {
    const Part half(Number(1) / 2), sixth(stumpff_coefficients<Number, 3>[0]);
    const Part d = at.rest, d2 = d * d, x = orbit.beta * d2;
    const Part g1 = d - d * (x * sixth);
    const Part g2 = d2 * (half - x * Part(Number(1) / 24));
    const Part g3 = d * d2 * sixth;
    const Part more1 = at.G1_less + (at.G0 * g1 - orbit.beta * at.G1 * g2);
    const Part more2 = at.G2_less + (at.G1 * g1 + at.G0 * g2);
    const Part more3 = at.G3_less + (at.G2 * d + (at.G1 * g2 + at.G0 * g3));
    const Part r_less_1 = at.r_less_1 + (at.r_rate * g1 + at.r_bend * g2);
    const Part r = Part(1) + r_less_1;
    const Part lost = ((Part(1) - r) + r_less_1) * at.inverse;
    const Part first1 = orbit.mu * at.s, first2 = orbit.mu * (half * at.square);
    const Part second1 = orbit.mu * more1, second2 = orbit.mu * more2;
    const Part f_rate = (first1 + (second1 - first1 * lost)) / r;
    const Part g_rate = (first2 + (second2 - first2 * lost)) / r;
    const Part g = orbit.mu * at.cube * sixth + orbit.mu * more3;
    return {-(first2 + second2), -(g * unit), -(f_rate / unit), -g_rate};
}

// ---- any orbit, one by one ----

/// Returns the orbit on the way back: after the time it is where `orbit` is before the beginning.
template <class Number>
[[nodiscard]] UnitOrbit<Number> backwards(UnitOrbit<Number> orbit) {
    orbit.eta = -orbit.eta;
    return orbit;
}

/// Returns the integer that is nearest to x >= 0.
template <class Number>
[[nodiscard]] Number nearest_integer(Number x) {
    constexpr Number whole = 1 / power_of_two<Number>(1 - bits<Number>);
    return x < whole ? (x + whole) - whole : x;
}

/// Returns the time that whole periods take, the nearest to a time; 0 where there is no period.
template <class Number>
[[nodiscard]] Number time_of_periods(const UnitOrbit<Number>& orbit, Number time) {
    // NOTE: 2 pi in doubles, of which wider numbers take three.
    constexpr Number two_pi =
        static_cast<Number>(6.283185307179586) +
        (static_cast<Number>(2.4492935982947064e-16) + static_cast<Number>(-5.989539619436679e-33));
    // NOTE: infinite or NaN where there is none.
    const Number period = two_pi * orbit.mu / (orbit.beta * math::sqrt(orbit.beta));
    return is_finite(period) ? nearest_integer(time / period) * period : Number(0);
}

/// Returns the step from a place by the method of Laguerre and Conway, which finds the solution
/// from nearly everywhere.
template <class Number>
[[nodiscard]] Number laguerre_step(const Place<Number>& at) {
    return 5 * at.time_left /
           (at.r + math::sqrt(abs(16 * at.r * at.r + 20 * at.time_left * at.r_rate)));
}

/// Returns whether a place is before that of the time. Places where G_k overflow are beyond.
template <class Number>
[[nodiscard]] bool is_before(const Place<Number>& at) {
    return at.time_left > 0 && is_finite(at.time_left);
}

/// Returns the place of a time >= 0. Time grows with s, so that halving an interval gets there
/// where Laguerre's steps do not.
template <class Number>
[[nodiscard]] Place<Number> place_between(const UnitOrbit<Number>& orbit, Number time) {
    constexpr int most = 64 * bits<Number>;
    Number low = 0, high = time;
    Place<Number> at = place_at<Number>(orbit, high, time);
    int k = 0;
    for (; k < most && is_before(at) && !is_near<Number>(at); ++k) {
        low = high;
        high += high;
        at = place_at<Number>(orbit, high, time);
    }
    Number step = high - low;
    for (; k < most && !is_near<Number>(at); ++k) {
        (is_before(at) ? low : high) = at.s;
        const Number last = step;
        step = laguerre_step(at);
        Number next = at.s + step;
        if (!(low < next && next < high && abs(step) <= abs(last) / 2)) {
            step = (high - low) / 2;
            next = low + step;
        }
        if (!(low < next && next < high)) { break; }
        at = place_at<Number>(orbit, next, time);
    }
    if (!is_near<Number>(at)) { at.rest = 0; }
    return at;
}

/// Returns an orbit that passes the other body, where rounding has made it end there: eta differs
/// by round-off. On a hyperbola r is a sum of exp(-k s) and exp(k s), and where a fast body falls
/// nearly straight into the other one the factor of the second is round-off, of any sign.
template <class Number>
[[nodiscard]] UnitOrbit<Number> passing(UnitOrbit<Number> orbit) {
    if (orbit.beta < 0) {
        constexpr Number most = 1 - 64 * epsilon<Number>;
        const Number lowest = -most * orbit.zeta / math::sqrt(-orbit.beta);
        orbit.eta = orbit.eta < lowest ? lowest : orbit.eta;
    }
    return orbit;
}

/// Returns the changes of any orbit, after whole periods have been left out; NaN where numbers are
/// not finite.
template <class Number>
[[nodiscard, gnu::noinline]] PartOfChanges<Number>
changes_one_by_one(UnitOrbit<Number> orbit, const TimeUnit<Number>& scale) {
    const Number sum = orbit.mu + orbit.eta + orbit.beta + orbit.zeta + scale.time + scale.unit;
    if (!is_finite(sum)) {
        const Number nan = sum - sum;
        return {nan, nan, nan, nan};
    }
    const Number left_out = time_of_periods(orbit, scale.time);
    Number time = scale.time - left_out, unit = scale.unit;
    if (time < 0) {
        orbit = backwards(orbit);
        time = -time;
        unit = -unit;
    }
    orbit = passing(orbit);
    PartOfChanges<Number> changes = changes_to<Number>(orbit, place_between(orbit, time), unit);
    changes.g_less_time -= left_out * scale.unit;
    return changes;
}

// ---- usual orbits, side by side ----

/// Returns x with a third of its digits, so that its square and its cube are exact.
template <class Number, class Part>
[[nodiscard, gnu::always_inline]] inline Part with_few_digits(const Part& x) {
    // NOTE: the product is exact, so that it does not matter whether it is fused with the sums.
    constexpr Number power = 1 / power_of_two<Number>(bits<Number> / 3 - bits<Number>);
    const Part large = Part(power) * x;
    return (large + x) - large;
}

/// Returns the changes of orbits, and sets `is_found` to where they are. `scale`: a TimeUnit of all
/// of them, or of each.
///
/// NOTE: what is found stays, whatever the others need. Places have few digits: where their squares
/// and cubes are rounded, the energy drifts (e = 0.6, P/20: by 3e-19 of it a step).
template <class Number, class Part, class Scale, class Mask>
[[nodiscard, gnu::always_inline]] inline PartOfChanges<Part>
usual_changes(const UnitOrbit<Part>& orbit, const Scale& scale, Mask& is_found) {
    constexpr int most = 6;
    const Part time(scale.time), far(8);  // nearly half a turn
    Part s = inverse_series<Number>(time, Part(Number(1) / 2) * orbit.eta,
                                    Part(Number(1) / 6) * orbit.zeta, orbit.beta);
    Mask is_usual = abs(orbit.beta * s * s) <= far;
    for (int k = 1;; ++k) {
        s = with_few_digits<Number>(select(is_usual, s, Part(0)));
        const Place<Part> at = place_at<Number>(orbit, s, time);
        is_found = is_usual && is_near<Number>(at);
        if (k == most || all(is_found || !is_usual)) {
            return changes_to<Number>(orbit, at, Part(scale.unit));
        }
        s = select(is_found, s, s + at.rest);
        is_usual = is_usual && abs(orbit.beta * s * s) <= far;
    }
}

/// Returns how many orbits are computed at once, of n.
template <class Number>
[[nodiscard]] constexpr std::size_t orbits_at_once(std::size_t n) {
    std::size_t width = 1;
    for (std::size_t wider = 2; wider <= widest; wider *= 2) {
        const bool is_there = (wider == 2 && has_register<Number, 2>) ||
                              (wider == 4 && has_register<Number, 4>) ||
                              (wider == 8 && has_register<Number, 8>);
        if (is_there && width < n) { width = wider; }
    }
    return width;
}

/// Returns `width` numbers from the place `first` on, and the last one again where there are fewer.
template <std::size_t width, class Number, std::size_t n, std::size_t... i>
[[nodiscard, gnu::always_inline]] inline auto
part_of(const std::array<Number, n>& numbers, std::size_t first, std::index_sequence<i...>) {
    using Part = typename Register<Number, width>::Type;
    if constexpr (width == 1) {
        return numbers[first];
    } else {
        const auto place = [first](std::size_t k) { return first + k < n ? first + k : n - 1; };
        return Part(typename Part::Vector{numbers[place(i)]...});
    }
}

/// Sets numbers from the place `first` on, as many as there are.
template <std::size_t width, class Number, std::size_t n, class Part>
[[gnu::always_inline]] inline void set_part(std::array<Number, n>& numbers, std::size_t first,
                                            const Part& part) {
    if constexpr (width == 1) {
        numbers[first] = part;
    } else {
        for (std::size_t i = 0; i < width && first + i < n; ++i) {
            numbers[first + i] = part.vector[i];
        }
    }
}

/// Returns whether a mask is set at place k.
template <class Mask>
[[nodiscard]] inline bool is_set(const Mask& mask, std::size_t k) {
    if constexpr (std::is_same_v<Mask, bool>) {
        return mask;
    } else {
        return mask.bits[k] != 0;
    }
}

template <std::size_t width, class Number, std::size_t n, class Part>
[[gnu::always_inline]] inline void set_changes(OrbitChanges<Number, n>& changes, std::size_t first,
                                               const PartOfChanges<Part>& part) {
    set_part<width>(changes.f_less_1, first, part.f_less_1);
    set_part<width>(changes.g_less_time, first, part.g_less_time);
    set_part<width>(changes.f_rate, first, part.f_rate);
    set_part<width>(changes.g_rate_less_1, first, part.g_rate_less_1);
}

}  // namespace two_bodies

/// Returns the changes along n orbits that do not depend on each other: q'' = -mu q/|q|^3, where
/// r2 = q.q, rv = q.v and v2 = v.v.
///
/// mu may be of any sign; where it is 0 all changes are 0. The time may be of any sign, and long:
/// whole periods are left out. The changes are, to round-off, those of an orbit whose r2, rv, v2,
/// mu and time differ from the given ones by round-off. A body that falls straight into the other
/// one comes back from there, as on ever thinner ellipses; at the other one the rates have no
/// limit. Where numbers are not finite, or overflow, changes are NaN.
///
/// The changes of an orbit do not depend on the orbits beside it, up to what the compiler makes of
/// products and sums in registers and out of them: where it fuses none, not by a bit. With -time
/// and -rv for time and rv, g and f_rate change their signs, and nothing else.
template <class Number, std::size_t n>
[[nodiscard]] OrbitChanges<Number, n>
orbit_changes(const std::array<Number, n>& r2, const std::array<Number, n>& rv,
              const std::array<Number, n>& v2, const std::array<Number, n>& mu, Number time) {
    namespace flow = two_bodies;
    constexpr std::size_t width = flow::orbits_at_once<Number>(n);
    using Part = typename Register<Number, width>::Type;
    constexpr auto places = std::make_index_sequence<width>();
    const flow::TimeUnit<Number> scale(time);
    OrbitChanges<Number, n> changes;
    for (std::size_t first = 0; first < n; first += width) {
        const auto part = [&](const auto& all) { return flow::part_of<width>(all, first, places); };
        const auto orbit =
            flow::unit_orbit<Part>(part(r2), part(rv), part(v2), part(mu), Part(scale.unit));
        typename MaskOf<Part>::type is_found;
        const auto usual = flow::usual_changes<Number>(orbit, scale, is_found);
        flow::set_changes<width>(changes, first, usual);
        if (all(is_found)) { continue; }
        for (std::size_t k = first; k < n && k < first + width; ++k) {
            if (flow::is_set(is_found, k - first)) { continue; }
            const auto alone = flow::unit_orbit<Number>(r2[k], rv[k], v2[k], mu[k], scale.unit);
            flow::set_changes<1>(changes, k, flow::changes_one_by_one(alone, scale));
        }
    }
    return changes;
}

/// Changes of orbits for one kind of numbers.
template <class Number>
struct OrbitValues {
    template <std::size_t n>
    [[nodiscard]] static std::array<Number, 4 * n> of(const std::array<Number, 4 * n + 1>& given) {
        const auto part = [&](std::size_t kind) {
            std::array<Number, n> numbers;
            for (std::size_t j = 0; j < n; ++j) { numbers[j] = given[kind * n + j]; }
            return numbers;
        };
        const OrbitChanges<Number, n> changes =
            orbit_changes(part(0), part(1), part(2), part(3), given[4 * n]);
        std::array<Number, 4 * n> values;
        std::size_t place = 0;
        for (const auto* kind :
             {&changes.f_less_1, &changes.g_less_time, &changes.f_rate, &changes.g_rate_less_1}) {
            for (const Number& value : *kind) { values[place++] = value; }
        }
        return values;
    }
};

/// Returns the changes of n orbits, kind by kind, from their r2, then rv, v2 and mu, and the time.
template <std::size_t n, class Number>
[[nodiscard]] std::array<Number, 4 * n> orbit_values(const std::array<Number, 4 * n + 1>& given) {
    return OrbitValues<Number>::template of<n>(given);
}

}  // namespace hvi::detail

#endif  // HVI_TWO_BODIES_HPP
