// The flow of two bodies, beside its closed forms, more digits, and itself.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/two_product.hpp>
#include <hvi/detail/stages/two_bodies.hpp>

#include "tests/runtime/flows/two_body_orbits.hpp"

namespace {

using hvi::detail::epsilon;
using hvi::detail::orbit_changes;
using hvi::detail::OrbitChanges;
using hvi::math::Widest;

/// q.q, q.v, v.v, mu and time.
template <class Number>
using Orbit = std::array<Number, 5>;
template <class Number>
using Changes = std::array<Number, 4>;

template <class Number, std::size_t n>
Changes<Number> changes_of(const OrbitChanges<Number, n>& all, std::size_t k) {
    return {all.f_less_1[k], all.g_less_time[k], all.f_rate[k], all.g_rate_less_1[k]};
}

template <class Number>
Changes<Number> changes(const Orbit<Number>& of) {
    return changes_of(orbit_changes<Number, 1>({of[0]}, {of[1]}, {of[2]}, {of[3]}, of[4]), 0);
}

template <class Number>
Orbit<Number> in(const Orbit<double>& of) {
    Orbit<Number> result;
    for (std::size_t k = 0; k < 5; ++k) { result[k] = static_cast<Number>(of[k]); }
    return result;
}

/// Returns a decimal as a number: to a few units of its last place.
Widest number(const std::string& decimal) {
    const std::size_t end = decimal.find('e');
    Widest digits = 0;
    int exponent = end == std::string::npos ? 0 : std::stoi(decimal.substr(end + 1));
    bool is_fraction = false;
    for (const char c : decimal.substr(0, end)) {
        if (c == '.') { is_fraction = true; }
        if (c < '0' || c > '9') { continue; }
        digits = 10 * digits + static_cast<Widest>(c - '0');
        exponent -= is_fraction ? 1 : 0;
    }
    Widest power = 1;
    for (int k = 0; k < std::abs(exponent); ++k) { power *= 10; }
    const Widest size = exponent < 0 ? digits / power : digits * power;
    return decimal.front() == '-' ? -size : size;
}

/// Returns the largest error of changes, in units of what round-off of the orbit and of the changes
/// makes of them.
template <class Number>
double error(const Changes<Number>& found, const Changes<Widest>& exact,
             const Changes<double>& condition) {
    double largest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto distance =
            static_cast<double>(hvi::detail::abs(static_cast<Widest>(found[k]) - exact[k]) /
                                static_cast<Widest>(epsilon<Number>));
        const auto size = static_cast<double>(hvi::detail::abs(exact[k])) + condition[k];
        const double units = distance == 0 ? 0 : distance / size;
        largest = units <= largest ? largest : units;  // NOTE: NaN stays
    }
    return largest;
}

template <class Number>
void check_known(double most) {
    for (const two_bodies::Known& each : two_bodies::known) {
        Changes<Widest> exact;
        for (std::size_t k = 0; k < 4; ++k) { exact[k] = number(each.changes[k]); }
        CAPTURE(each.name);
        CHECK(error(changes(in<Number>(each.of)), exact, each.condition) <= most);
    }
}

/// Returns the changes of an orbit in the most digits.
Changes<Widest> exact_changes(const Orbit<double>& of) { return changes(in<Widest>(of)); }

/// Returns by how much changes change for relative changes of the numbers of an orbit.
Changes<double> condition(const Orbit<double>& of) {
    const Changes<Widest> exact = exact_changes(of);
    const Widest shift = hvi::math::sqrt(epsilon<Widest>) / 1024;
    Changes<double> sum{};
    for (std::size_t k = 0; k < 5; ++k) {
        Orbit<Widest> moved = in<Widest>(of);
        moved[k] *= 1 + shift;
        const Changes<Widest> there = changes(moved);
        for (std::size_t i = 0; i < 4; ++i) {
            sum[i] += static_cast<double>(hvi::detail::abs(there[i] - exact[i]) / shift);
        }
    }
    return sum;
}

/// Numbers without order, from 0 to 1 (Knuth's linear congruences).
class Shuffled {
public:
    double operator()() {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state_ >> 11U) * 0x1p-53;
    }
    double between(double low, double high) { return low + (high - low) * (*this)(); }

private:
    std::uint64_t state_ = 1;
};

/// Returns an orbit of eccentricity e, at any place on it, for a time in parts of its period.
Orbit<double> ellipse(Shuffled& any, double e, double periods) {
    const double a = any.between(0.5, 2), mu = any.between(0.5, 2), place = any.between(-3.2, 3.2);
    const double r = a * (1 - e * std::cos(place));
    return {r * r, std::sqrt(mu * a) * e * std::sin(place), mu * (2 / r - 1 / a), mu,
            6.283185307179586 * std::sqrt(a * a * a / mu) * periods};
}

/// Returns an orbit whose v.v is a multiple of that of a parabola.
Orbit<double> open_orbit(Shuffled& any, double multiple, double sign, double time) {
    const double r = any.between(0.5, 2), mu = any.between(0.5, 2);
    const double v2 = multiple * 2 * mu / r;
    return {r * r, r * std::sqrt(v2) * any.between(-0.95, 0.95), v2, sign * mu, time};
}

void check_beside_more_digits(const Orbit<double>& of) {
    CAPTURE(of);
    CHECK(error(changes(of), exact_changes(of), condition(of)) <= 4);
}

/// A body about another one, and the remainders of its sums.
struct Body {
    std::array<double, 3> q, v, rest_of_q{}, rest_of_v{};
};

double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <std::size_t n>
void move(std::array<Body, n>& bodies, const std::array<double, n>& mu, double time) {
    std::array<double, n> r2, rv, v2;
    for (std::size_t i = 0; i < n; ++i) {
        r2[i] = product(bodies[i].q, bodies[i].q);
        rv[i] = product(bodies[i].q, bodies[i].v);
        v2[i] = product(bodies[i].v, bodies[i].v);
    }
    const auto all = orbit_changes<double, n>(r2, rv, v2, mu, time);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            Body& body = bodies[i];
            const double q = body.q[k], v = body.v[k];
            const double dq = all.f_less_1[i] * q + (all.g_less_time[i] * v + time * v);
            const double dv = all.f_rate[i] * q + all.g_rate_less_1[i] * v;
            const auto to_q = hvi::two_sum(q, body.rest_of_q[k] + dq);
            const auto to_v = hvi::two_sum(v, body.rest_of_v[k] + dv);
            body.q[k] = to_q.value;
            body.v[k] = to_v.value;
            body.rest_of_q[k] = to_q.remainder;
            body.rest_of_v[k] = to_v.remainder;
        }
    }
}

/// Returns 1/a, of both sums.
double inverse_axis(const Body& body, double mu) {
    Widest r2 = 0, v2 = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Widest q = Widest(body.q[k]) + Widest(body.rest_of_q[k]);
        const Widest v = Widest(body.v[k]) + Widest(body.rest_of_v[k]);
        r2 += q * q;
        v2 += v * v;
    }
    // NOTE: less 1, which the axes are near to, so that digits are left.
    return static_cast<double>(2 / hvi::math::sqrt(r2) - v2 / Widest(mu) - 1);
}

/// Returns a body on an orbit of eccentricity e about mu = 1, with the axis 1.
Body body_on_ellipse(Shuffled& any, double e) {
    const double place = any.between(-3.2, 3.2), turn = any.between(-3.2, 3.2);
    const double b = std::sqrt(1 - e * e), x = std::cos(place) - e, y = b * std::sin(place);
    const double rate = 1 / (1 - e * std::cos(place));
    const double u = -rate * std::sin(place), w = rate * b * std::cos(place);
    const double c = std::cos(turn), s = std::sin(turn);
    return {{c * x - s * y, 0.8 * (s * x + c * y), 0.6 * (s * x + c * y)},
            {c * u - s * w, 0.8 * (s * u + c * w), 0.6 * (s * u + c * w)}};
}

/// Returns by how much 1/a moves in some steps, on the mean of orbits of eccentricity e.
double drift(double e, double h, int steps, int repeats) {
    Shuffled any;
    double sum = 0;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        std::array<Body, 8> bodies;
        std::array<double, 8> mu, before;
        const double time = h * any.between(0.9, 1.1);
        for (std::size_t i = 0; i < 8; ++i) {
            mu[i] = any.between(0.95, 1.05);
            bodies[i] = body_on_ellipse(any, e);
            before[i] = inverse_axis(bodies[i], mu[i]);
        }
        for (int k = 0; k < steps; ++k) { move(bodies, mu, time); }
        for (std::size_t i = 0; i < 8; ++i) { sum += inverse_axis(bodies[i], mu[i]) - before[i]; }
    }
    return sum / (8 * repeats);
}

/// Returns orbits of many kinds. Some are found at once, some in several places, and some not side
/// by side.
std::vector<Orbit<double>> many_kinds() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Orbit<double>> all{{1, 0.2, 1, 1, 0},   {1, -0.5, 2, 1, 0},
                                   {4, -3.9, 4, -1, 0}, {1e-4, 1e-3, 150, 1, 0},
                                   {1, 1, 2, 0, 0},     {1, 0.5, nan, 1, 0}};
    Shuffled any;
    for (int k = 0; k < 30; ++k) { all.push_back(ellipse(any, any.between(0, 0.8), 0)); }
    return all;
}

/// Checks n orbits side by side, from each on.
template <std::size_t n>
void check_side_by_side() {
    const std::vector<Orbit<double>> all = many_kinds();
    for (std::size_t first = 0; first < all.size(); ++first) {
        std::array<double, n> r2, rv, v2, mu;
        const auto of = [&](std::size_t k) { return all[(first + k) % all.size()]; };
        for (std::size_t k = 0; k < n; ++k) {
            r2[k] = of(k)[0];
            rv[k] = of(k)[1];
            v2[k] = of(k)[2];
            mu[k] = of(k)[3];
        }
        const auto together = orbit_changes<double, n>(r2, rv, v2, mu, 0.4);
        for (std::size_t k = 0; k < n; ++k) {
            const Changes<double> found = changes_of(together, k);
            const Changes<double> alone = changes<double>({r2[k], rv[k], v2[k], mu[k], 0.4});
            for (std::size_t i = 0; i < 4; ++i) {
                CAPTURE(n, first, k, i);
                if (std::isnan(v2[k])) {
                    CHECK(std::isnan(found[i]));
                } else if (hvi::detail::has_fused_instruction) {
                    CHECK(found[i] == Approx(alone[i]).epsilon(1e-11));
                } else {
                    CHECK(found[i] == alone[i]);
                }
            }
        }
    }
}

template <std::size_t... n>
void check_all_side_by_side(std::index_sequence<n...>) {
    (check_side_by_side<n + 1>(), ...);
}

}  // namespace

TEST_CASE("changes along known orbits are right to round-off, in all numbers") {
    check_known<float>(4);
    check_known<double>(4);
    check_known<long double>(4);
    check_known<Widest>(8);
}

TEST_CASE("changes are those in more digits, to round-off") {
    Shuffled any;
    for (const double e : {0.0, 1e-8, 0.05, 0.3, 0.6, 0.9, 0.99, 0.9999, 0.9999999}) {
        for (const double periods : {0.01, 0.05, -0.05, 0.3, -0.49, 0.51, 1.0, 7.9, -1e3}) {
            check_beside_more_digits(ellipse(any, e, periods));
        }
    }
    for (const double multiple : {0.999999, 1 - 1e-12, 1.0, 1 + 1e-12, 1.000001, 1.5, 50.0}) {
        for (const double time : {1e-3, 0.1, -0.5, 3.0, -20.0, 1e5}) {
            check_beside_more_digits(open_orbit(any, multiple, 1, time));
            check_beside_more_digits(open_orbit(any, multiple, -1, time));
        }
    }
}

TEST_CASE("nothing changes in no time, and where nothing attracts") {
    for (const Orbit<double>& of : {Orbit<double>{1, 0.5, 1, 1, 0},
                                    {1, 0.5, 1, -1, 0},
                                    {1, 0.5, 1, 0, 0},
                                    {1, 0.5, 1, 0, 3},
                                    {1, -1, 1, 0, 1},
                                    {1, -0.5, 7, 0, -1e10},
                                    {0, 0, 1, 0, 2}}) {
        for (const double change : changes(of)) { CHECK(change == 0); }
        for (const float change : changes(in<float>(of))) { CHECK(change == 0); }
    }
}

TEST_CASE("what is not finite makes all changes NaN") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double mu : {1.0, 0.0, -1.0}) {
        for (std::size_t k = 0; k < 5; ++k) {
            Orbit<double> of{1, 0.5, 1, mu, 0.3};
            of[k] = nan;
            CAPTURE(k, mu);
            for (const double change : changes(of)) { CHECK(std::isnan(change)); }
        }
    }
    for (const Orbit<double>& of :
         {Orbit<double>{1, 0.5, 1, 1, HUGE_VAL}, {0, 0, 1, 1, 1}, {-1, 0, 1, 1, 1}}) {
        for (const double change : changes(of)) { CHECK(std::isnan(change)); }
    }
}

TEST_CASE("a fast body that falls straight into a light one gets away") {
    // NOTE: whether it turns back or goes past is round-off.
    for (const double mu : {1e-3, -1e-3, 1e-8, -1e-8, 1e-10, -1e-10, 1e-14, 1e-20}) {
        for (const double time : {3.0, 1e3, 1e8}) {
            const Changes<double> of = changes<double>({1, -1, 1, mu, time});
            const double q = 1 + of[0] - (time + of[1]);
            CAPTURE(mu, time, q);
            CHECK(std::abs(std::abs(q) - (time - 1)) <= 0.1 * time);
        }
    }
}

TEST_CASE("the way back is the mirrored one, to the bit") {
    Shuffled any;
    for (const double periods : {0.05, 0.3, 2.2}) {
        for (const double e : {0.1, 0.7, 0.99}) {
            Orbit<double> of = ellipse(any, e, periods);
            const Changes<double> forth = changes(of);
            of[1] = -of[1];
            of[4] = -of[4];
            const Changes<double> back = changes(of);
            CHECK(back[0] == forth[0]);
            CHECK(back[1] == -forth[1]);
            CHECK(back[2] == -forth[2]);
            CHECK(back[3] == forth[3]);
        }
    }
}

TEST_CASE("a step and one back end where they began") {
    Shuffled any;
    for (const double e : {0.0, 0.3, 0.9}) {
        for (const double time : {0.3, 2.0, -7.0}) {
            std::array<Body, 3> bodies;
            for (Body& body : bodies) { body = body_on_ellipse(any, e); }
            const auto before = bodies;
            move<3>(bodies, {1, 1, 1}, time);
            move<3>(bodies, {1, 1, 1}, -time);
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    CAPTURE(e, time, i, k);
                    CHECK(std::abs(bodies[i].q[k] - before[i].q[k]) <= 1e-12);
                    CHECK(std::abs(bodies[i].v[k] - before[i].v[k]) <= 1e-12);
                }
            }
        }
    }
}

TEST_CASE("units of length and time that are powers of 2 change no bit") {
    Shuffled any;
    for (const auto& [length, time] :
         {std::array{480, 300}, {-480, -300}, {400, 500}, {-300, -100}}) {
        for (const Orbit<double>& of : {ellipse(any, 0.3, 0.04), ellipse(any, 0.97, 3.3),
                                        open_orbit(any, 2, 1, 5), open_orbit(any, 2, -1, 5)}) {
            const Changes<double> near = changes(of);
            const Changes<double> far = changes<double>(
                {std::ldexp(of[0], 2 * length), std::ldexp(of[1], 2 * length - time),
                 std::ldexp(of[2], 2 * (length - time)), std::ldexp(of[3], 3 * length - 2 * time),
                 std::ldexp(of[4], time)});
            CAPTURE(length, time);
            CHECK(far[0] == near[0]);
            CHECK(far[1] == std::ldexp(near[1], time));
            CHECK(far[2] == std::ldexp(near[2], -time));
            CHECK(far[3] == near[3]);
        }
    }
}

TEST_CASE("orbits side by side are those one by one") {
    check_all_side_by_side(std::make_index_sequence<9>());
}

TEST_CASE("the energy walks, and does not drift") {
    // NOTE: the means walk by 1e-15 and 3e-15 in so many steps. e = 0.5 drifts by 1e-13 where rests
    // of places are as small as their error.
    CHECK(std::abs(drift(0.05, 0.314, 20'000, 1)) <= 2e-14);
    CHECK(std::abs(drift(0.3, 0.0628, 20'000, 1)) <= 2e-14);
    CHECK(std::abs(drift(0.5, 0.314, 20'000, 4)) <= 2e-14);
}
