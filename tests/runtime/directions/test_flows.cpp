// Directions that flows of parts of H carry along, beside closed forms and differences in 113 bits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

#include <catch2/catch.hpp>
#include <directions/flow_disturbed.hpp>
#include <directions/flow_general.hpp>
#include <directions/flow_henon.hpp>
#include <directions/flow_kerr.hpp>
#include <directions/flow_kicked.hpp>
#include <directions/flow_molecule.hpp>
#include <directions/flow_orbit.hpp>
#include <directions/flow_oscillator.hpp>
#include <directions/flow_planet.hpp>
#include <directions/flow_ring.hpp>
#include <directions/plain_henon.hpp>
#include <directions/plain_kicked.hpp>
#include <directions/plain_molecule.hpp>
#include <directions/plain_orbit.hpp>
#include <directions/plain_ring.hpp>
#include <directions/wide_disturbed.hpp>
#include <directions/wide_flow_molecule.hpp>
#include <directions/wide_flow_orbit.hpp>
#include <directions/wide_henon.hpp>
#include <directions/wide_kicked.hpp>
#include <directions/wide_molecule.hpp>
#include <directions/wide_orbit.hpp>
#include <directions/wide_planet.hpp>
#include <directions/wide_ring.hpp>
#include <hvi/detail/numbers/math.hpp>

namespace {

using namespace hvi::generated;
using hvi::math::Widest;

template <class Stepper>
constexpr std::size_t variables = 2 * std::tuple_size_v<typename Stepper::Vector>;

/// Component of a state: q, then p.
template <class State>
auto& component(State& x, std::size_t k) {
    return k < x.q.size() ? x.q[k] : x.p[k - x.q.size()];
}

template <class Stepper>
using Columns = std::vector<typename Stepper::State>;

/// The columns of a derivative that is the identity.
template <class Stepper>
Columns<Stepper> units() {
    Columns<Stepper> all(variables<Stepper>);
    for (std::size_t k = 0; k < all.size(); ++k) { component(all[k], k) = 1; }
    return all;
}

template <class Stepper>
Columns<Stepper> columns_after(double h, int steps) {
    using Scalar = typename Stepper::Scalar;
    Stepper stepper;
    typename Stepper::State x = Stepper::initial();
    Columns<Stepper> D = units<Stepper>();
    for (int step = 0; step < steps; ++step) {
        REQUIRE(stepper.step(x, D, static_cast<Scalar>(h)).ok());
    }
    return D;
}

using Matrix = std::vector<std::vector<double>>;  // rows

/// The largest difference from a matrix, over its largest entry.
template <class Stepper>
double difference(const Columns<Stepper>& D, const Matrix& expected) {
    double largest = 0, error = 0;
    for (std::size_t row = 0; row < D.size(); ++row) {
        for (std::size_t k = 0; k < D.size(); ++k) {
            largest = std::max(largest, std::abs(expected[row][k]));
            const double found = static_cast<double>(component(D[k], row));
            error = std::max(error, std::abs(found - expected[row][k]));
        }
    }
    return error / largest;
}

// ---- flows in closed form ----

TEST_CASE("directions of an oscillator turn as it does") {
    const double a = 2, b = 3, h = 0.3, w = std::sqrt(a * b), t = 20 * h;
    const Matrix expected{{std::cos(w * t), b / w * std::sin(w * t)},
                          {-a / w * std::sin(w * t), std::cos(w * t)}};
    CHECK(difference<FlowOscillator>(columns_after<FlowOscillator>(h, 20), expected) < 1e-14);
    CHECK(difference<BasicFlowOscillator<float>>(columns_after<BasicFlowOscillator<float>>(h, 20),
                                                 expected) < 1e-5);
    CHECK(difference<BasicFlowOscillator<long double>>(
              columns_after<BasicFlowOscillator<long double>>(h, 20), expected) < 1e-15);
}

TEST_CASE("directions of a frequency that depends on the state are sheared") {
    // H = g (2 I)^3/6 - I for I = (q^2 + p^2)/2: z turns by the angle a = H'(I) t, and D is
    // R(a) + H''(I) t R'(a) z z^T.
    const double g = 0.7, h = 0.2, t = 15 * h, q = 1, p = 1.0 / 3, I = (q * q + p * p) / 2;
    const double a = (4 * g * I * I - 1) * t, rate = 8 * g * I * t;
    const double cos = std::cos(a), sin = std::sin(a);
    const double dq = -sin * q + cos * p, dp = -cos * q - sin * p;
    const Matrix expected{{cos + rate * dq * q, sin + rate * dq * p},
                          {-sin + rate * dp * q, cos + rate * dp * p}};
    CHECK(difference<FlowKerr>(columns_after<FlowKerr>(h, 15), expected) < 1e-14);
    CHECK(difference<BasicFlowKerr<long double>>(columns_after<BasicFlowKerr<long double>>(h, 15),
                                                 expected) < 1e-15);
}

TEST_CASE("directions of a quadratic form are moved by its matrix, without what is linear") {
    // exp(t J S), as its series.
    const double S[4][4] = {{1, 0.5, 0.125, -1},
                            {0.5, -0.75, 0.625, 0.25},
                            {0.125, 0.625, 1.5, -0.25},
                            {-1, 0.25, -0.25, 0.5}};
    const double h = 0.1, t = 8 * h;
    Matrix expected(4, std::vector<double>(4)), term = expected;
    for (std::size_t i = 0; i < 4; ++i) { expected[i][i] = term[i][i] = 1; }
    for (int n = 1; n < 40; ++n) {
        Matrix next(4, std::vector<double>(4));
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t k = 0; k < 4; ++k) {
                    const double slope = i < 2 ? S[i + 2][k] : -S[i - 2][k];
                    next[i][j] += slope * term[k][j] * t / n;
                }
                expected[i][j] += next[i][j];
            }
        }
        term = next;
    }
    CHECK(difference<FlowGeneral>(columns_after<FlowGeneral>(h, 8), expected) < 1e-14);
}

TEST_CASE("directions of a revolution about the sun") {
    // Neighbours have the periods 2 pi (-2 H)^(-3/2): D = I - 6 pi f dH^T, f the motion.
    const double pi = std::acos(-1.0), x = 0.4, v = 2;
    const std::array<double, 4> f{0, v, -1 / (x * x), 0}, slope{1 / (x * x), 0, 0, v};
    Matrix expected(4, std::vector<double>(4));
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            expected[i][k] = (i == k ? 1.0 : 0.0) - 6 * pi * f[i] * slope[k];
        }
    }
    CHECK(difference<FlowOrbit>(columns_after<FlowOrbit>(2 * pi / 7, 7), expected) < 1e-13);
    // A step of a whole revolution and a bit, of which the revolution is left out.
    CHECK(difference<FlowOrbit>(columns_after<FlowOrbit>(2 * pi, 1), expected) < 1e-12);
    CHECK(difference<BasicFlowOrbit<long double>>(
              columns_after<BasicFlowOrbit<long double>>(2 * pi / 7, 7), expected) < 1e-14);
}

// ---- differences in 113 bits ----

/// Whether the widest numbers have 113 bits. NOTE: with clang they are long doubles.
constexpr bool are_wide = !std::is_same_v<Widest, long double>;

/// Returns a bound on errors where differences are those of long doubles.
constexpr double bound(double in_113_bits, double in_64_bits) {
    return are_wide ? in_113_bits : in_64_bits;
}

/// The derivative of steps by differences of the stepper `Wide`, which err by 1e-20; of long
/// doubles by 1e-10.
template <class Wide>
Matrix by_differences(double h, int steps) {
    constexpr std::size_t n = variables<Wide>;
    const auto end = [&](std::size_t k, Widest change) {
        Wide stepper;
        typename Wide::State x = Wide::initial();
        component(x, k) += change;
        for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(x, Widest(h)).ok()); }
        return x;
    };
    const Widest small = Widest(are_wide ? 1e-10 : 1e-7);
    Matrix result(n, std::vector<double>(n));
    for (std::size_t k = 0; k < n; ++k) {
        auto above = end(k, small), below = end(k, -small);
        for (std::size_t row = 0; row < n; ++row) {
            const Widest change = component(above, row) - component(below, row);
            result[row][k] = static_cast<double>(change / (2 * small));
        }
    }
    return result;
}

template <class Stepper, class Wide>
double error_of(double h, int steps) {
    return difference<Stepper>(columns_after<Stepper>(h, steps), by_differences<Wide>(h, steps));
}

TEST_CASE("directions are carried by the derivative of all flows of a step") {
    CHECK(error_of<FlowHenon, BasicWideHenon<Widest>>(0.1, 100) < bound(1e-13, 1e-9));
    CHECK(error_of<FlowOrbit, BasicWideOrbit<Widest>>(0.3, 20) < bound(1e-12, 1e-9));
    CHECK(error_of<FlowRing, BasicWideRing<Widest>>(0.05, 20) < bound(1e-13, 1e-9));
    CHECK(error_of<FlowDisturbed, BasicWideDisturbed<Widest>>(0.1, 20) < bound(1e-13, 1e-9));
    CHECK(error_of<FlowMolecule, BasicWideMolecule<Widest>>(0.05, 20) < bound(1e-12, 1e-9));
    CHECK(error_of<FlowKicked, BasicWideKicked<Widest>>(0.05, 40) < bound(1e-12, 1e-9));
    CHECK(error_of<FlowPlanet, BasicWidePlanet<Widest>>(0.05, 5) < bound(1e-11, 1e-9));
}

// ---- what a derivative of symplectic steps is ----

/// The largest entry of D^T J D - J over the square of the largest of D.
template <class Stepper>
double defect(double h, int steps) {
    const Columns<Stepper> D = columns_after<Stepper>(h, steps);
    const std::size_t n = D.size() / 2;
    double largest = 1, error = 0;
    for (std::size_t a = 0; a < 2 * n; ++a) {
        for (std::size_t b = 0; b < 2 * n; ++b) {
            largest = std::max(largest, std::abs(static_cast<double>(component(D[a], b))));
            typename Stepper::Scalar form = b == a + n ? -1 : a == b + n ? 1 : 0;
            for (std::size_t k = 0; k < n; ++k) {
                form += D[a].q[k] * D[b].p[k] - D[a].p[k] * D[b].q[k];
            }
            error = std::max(error, std::abs(static_cast<double>(form)));
        }
    }
    return error / (largest * largest);
}

TEST_CASE("the derivative of flows is symplectic to round-off") {
    CHECK(defect<FlowHenon>(0.1, 10'000) < 1e-13);
    CHECK(defect<FlowOrbit>(0.1, 1000) < 1e-13);
    CHECK(defect<FlowRing>(0.05, 500) < 1e-13);
    CHECK(defect<FlowGeneral>(0.1, 100) < 1e-13);
    CHECK(defect<FlowMolecule>(0.05, 100) < 1e-13);
    CHECK(defect<BasicWideFlowOrbit<Widest>>(0.1, 100) < bound(1e-30, 1e-15));
    CHECK(defect<BasicWideFlowMolecule<Widest>>(0.05, 20) < bound(1e-30, 1e-15));
}

/// How far the rows that covectors pulled back give differ from those of D, over its largest entry.
template <class Stepper>
double difference_of_rows(double h, int steps) {
    Stepper stepper;
    Columns<Stepper> x{Stepper::initial()}, D = units<Stepper>();
    for (int step = 0; step < steps; ++step) {
        x.push_back(x.back());
        REQUIRE(stepper.step(x.back(), D, h).ok());
    }
    Matrix rows(D.size(), std::vector<double>(D.size()));
    for (std::size_t row = 0; row < D.size(); ++row) {
        typename Stepper::State lambda{};
        component(lambda, row) = 1;
        for (std::size_t step = x.size() - 1; step-- > 0;) {
            REQUIRE(stepper.pull_back(x[step], lambda, h).ok());
        }
        for (std::size_t k = 0; k < D.size(); ++k) { rows[row][k] = component(lambda, k); }
    }
    return difference<Stepper>(D, rows);
}

TEST_CASE("covectors are pulled back through flows by the transposed derivative") {
    CHECK(difference_of_rows<FlowKerr>(0.2, 51) < 1e-13);
    CHECK(difference_of_rows<FlowGeneral>(0.1, 31) < 1e-13);
    CHECK(difference_of_rows<FlowHenon>(0.1, 201) < 1e-13);
    CHECK(difference_of_rows<FlowOrbit>(0.3, 21) < 1e-12);
    CHECK(difference_of_rows<FlowRing>(0.05, 41) < 1e-13);
    CHECK(difference_of_rows<FlowDisturbed>(0.1, 41) < 1e-13);
    CHECK(difference_of_rows<FlowMolecule>(0.05, 21) < 1e-12);
    CHECK(difference_of_rows<FlowKicked>(0.05, 21) < 1e-12);
}

// ---- states beside directions ----

template <class Stepper, class Plain>
void have_same_bits(double h, int steps) {
    Stepper with, without;
    Plain plain;
    typename Stepper::State x = Stepper::initial(), y = x;
    typename Plain::State z = Plain::initial();
    Columns<Stepper> D = units<Stepper>();
    for (int step = 0; step < steps; ++step) {
        REQUIRE(with.step(x, D, h).ok());
        REQUIRE(without.step(y, h).ok());
        REQUIRE(plain.step(z, h).ok());
    }
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
    CHECK(x.q == z.q);
    CHECK(x.p == z.p);
}

/// Checks that steps in a row, whose ends are one flow, have the bits of those without directions.
template <class Stepper, class Plain>
void have_same_bits_in_a_row(double h, int steps) {
    Stepper stepper;
    Plain plain;
    typename Stepper::State x = Stepper::initial();
    typename Plain::State y = Plain::initial();
    Columns<Stepper> D = units<Stepper>();
    REQUIRE(stepper.step(x, D, h).ok());
    REQUIRE(plain.step(y, h).ok());
    REQUIRE(stepper.advance(x, h, steps).ok());
    REQUIRE(plain.advance(y, h, steps).ok());
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
}

TEST_CASE("flows move a state with the bits of a stepper without directions") {
    have_same_bits<FlowOrbit, PlainOrbit>(0.1, 100);
    have_same_bits<FlowHenon, PlainHenon>(0.1, 100);
    have_same_bits<FlowRing, PlainRing>(0.05, 100);
    have_same_bits<FlowMolecule, PlainMolecule>(0.05, 100);
    have_same_bits<FlowKicked, PlainKicked>(0.05, 100);
    have_same_bits_in_a_row<FlowHenon, PlainHenon>(0.1, 100);
    have_same_bits_in_a_row<FlowRing, PlainRing>(0.05, 100);
}

TEST_CASE("flows carry any number of directions, each as if alone") {
    const double h = 0.1;
    for (const std::size_t count : {0U, 1U, 2U, 4U, 5U, 6U, 7U, 12U, 15U}) {
        FlowHenon stepper, alone;
        FlowHenon::State x = FlowHenon::initial(), y = x;
        Columns<FlowHenon> D(count), one(1);
        one[0].q[0] = 1;
        for (std::size_t k = 0; k < count; ++k) { D[k].q[0] = static_cast<double>(k + 1); }
        for (int step = 0; step < 20; ++step) {
            REQUIRE(stepper.step(x, D, h).ok());
            REQUIRE(alone.step(y, one, h).ok());
        }
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t i = 0; i < variables<FlowHenon>; ++i) {
                const double expected = static_cast<double>(k + 1) * component(one[0], i);
                CHECK(component(D[k], i) == Approx(expected).epsilon(1e-13).margin(1e-13));
            }
        }
    }
}

TEST_CASE("directions of flows that stay behind for a while, or of another state, begin there") {
    const double h = 0.1;
    FlowHenon stepper, fresh;
    FlowHenon::State x = FlowHenon::initial();
    Columns<FlowHenon> D = units<FlowHenon>();
    for (int step = 0; step < 5; ++step) { REQUIRE(stepper.step(x, D, h).ok()); }
    REQUIRE(stepper.step(x, h).ok());
    x.q[0] += 0.125;
    D[1].p[0] = 2;
    FlowHenon::State y = x;
    Columns<FlowHenon> E = D;
    REQUIRE(stepper.step(x, D, -h).ok());
    REQUIRE(fresh.step(y, E, -h).ok());
    CHECK(x.q == y.q);
    for (std::size_t k = 0; k < D.size(); ++k) {
        CHECK(D[k].q == E[k].q);
        CHECK(D[k].p == E[k].p);
    }
}

TEST_CASE("parameters of flows that carry directions are those of the stepper") {
    FlowOscillator::Parameters stiff;
    stiff.a = 8;
    FlowOscillator stepper(stiff);
    FlowOscillator::State x = FlowOscillator::initial(stiff);
    Columns<FlowOscillator> D = units<FlowOscillator>();
    REQUIRE(stepper.step(x, D, 0.5).ok());
    const double w = std::sqrt(24.0);
    CHECK(D[0].q[0] == Approx(std::cos(w / 2)).epsilon(1e-14));
    CHECK(D[0].p[0] == Approx(-8 / w * std::sin(w / 2)).epsilon(1e-14));
}

TEST_CASE("flows that fail leave directions and covectors as they are") {
    const double infinity = std::numeric_limits<double>::infinity();
    FlowOrbit stepper;
    FlowOrbit::State x = FlowOrbit::initial();
    Columns<FlowOrbit> D = units<FlowOrbit>();
    REQUIRE(stepper.step(x, D, 0.1).ok());
    FlowOrbit::State lambda = D[1];
    const auto x_before = x;
    auto D_before = D;
    CHECK(stepper.step(x, D, infinity).code() == hvi::Status::Code::not_finite);
    CHECK(stepper.pull_back(x, lambda, infinity).code() == hvi::Status::Code::not_finite);
    D[2].p[0] = D_before[2].p[0] = infinity;
    CHECK(stepper.step(x, D, 0.1).code() == hvi::Status::Code::not_finite);
    CHECK(x.q == x_before.q);
    CHECK(x.p == x_before.p);
    for (std::size_t k = 0; k < D.size(); ++k) {
        CHECK(D[k].q == D_before[k].q);
        CHECK(D[k].p == D_before[k].p);
    }
    CHECK(lambda.q == D[1].q);
    CHECK(stepper.step(x, D, 0).ok());
    CHECK(D[0].q == D_before[0].q);
    D[2].p[0] = 1;
    CHECK(stepper.step(x, D, 0.1).ok());
}

}  // namespace
