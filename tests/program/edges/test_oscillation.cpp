// Known facts about compositions, beside the steps that they consist of.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/edges/oscillation.hpp"
#include "generator/edges/passage.hpp"
#include "generator/exact/methods/properties.hpp"

using namespace hvi::gen;

namespace {

ExactMethod method_named(const std::string& name) {
    return exact_method(composed_method(given("--methods", name)));
}

using Matrix = std::array<double, 4>;

Matrix product(const Matrix& a, const Matrix& b) {
    return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
            a[2] * b[1] + a[3] * b[3]};
}

double at(const NumberVector& polynomial, double z) {
    double value = 0;
    for (auto k = polynomial.rbegin(); k != polynomial.rend(); ++k)
        value = value * z + k->nearest_double();
    return value;
}

Matrix map_at(const OscillatorMap& map, double z) {
    const double D = at(map.D, z);
    return {at(map.m11, z) / D, at(map.m12, z) / D, at(map.m21, z) / D, at(map.m22, z) / D};
}

/// Returns the map of (omega q, p): kick, drift, kick.
Matrix verlet(double z) { return {1 - z * z / 2, z, -z + z * z * z / 4, 1 - z * z / 2}; }

}  // namespace

TEST_CASE("the map of a composition is that of its steps in a row") {
    struct Case {
        std::string method, adjoint, composition;
    };
    const std::vector<Case> cases{{"gauss:2", "gauss:2", "yoshida:4"},
                                  {"lobatto:3", "lobatto:3", "kahan-li:8"},
                                  {"trig3", "trig3", "suzuki:4"},
                                  {"symplectic-euler", "adjoint-symplectic-euler", "blanes-moan:6"},
                                  {"radau-left:2", "radau-right:2", "blanes-moan:6"}};
    for (const auto& [method, adjoint, composition] : cases) {
        const ExactMethod composed = method_named(method + "-" + composition);
        const OscillatorMap own = oscillator_map(std::get<Tableau>(method_named(method).base)),
                            other = oscillator_map(std::get<Tableau>(method_named(adjoint).base));
        const KnownOscillator known = known_oscillator(composed);
        CHECK(known.method == method + "-" + composition);
        CHECK(known.map.determinant_one.holds);
        for (const double z : {0.1, 0.7, 1.3}) {
            Matrix expected{1, 0, 0, 1};
            bool is_adjoint = false;
            for (const Number& gamma : composed.composition->steps) {
                expected =
                    product(map_at(is_adjoint ? other : own, gamma.nearest_double() * z), expected);
                is_adjoint = !is_adjoint;
            }
            const Matrix seen = map_at(known.map, z);
            INFO(known.method << " at " << z);
            for (std::size_t i = 0; i < 4; ++i)
                CHECK(seen.at(i) == Approx(expected.at(i)).margin(1e-11));
        }
    }
}

TEST_CASE("compositions are stable as far as the product of their steps") {
    // 1/(2 - 2^(1/3)), and what is left for the step in the middle.
    const double gamma = 1 / (2 - std::cbrt(2.0));
    const KnownOscillator known = known_oscillator(method_named("stormer-verlet-yoshida:4"));
    for (double z = 0.01; z < 4; z += 0.0173) {
        const Matrix R =
            product(verlet(gamma * z), product(verlet((1 - 2 * gamma) * z), verlet(gamma * z)));
        const double half_trace = (R[0] + R[3]) / 2;
        if (std::abs(std::abs(half_trace) - 1) < 1e-6) continue;
        INFO("z = " << z);
        CHECK(oscillation(known, z).is_stable == (std::abs(half_trace) < 1));
    }
    CHECK(known.contraction == 0);
    // rho(A A) = 1/12 of gauss:2, and the largest step is the one in the middle.
    CHECK(known_oscillator(method_named("gauss:2-yoshida:4")).contraction ==
          Approx(std::pow(1 - 2 * gamma, 2) / 12).epsilon(1e-3));
}

TEST_CASE("stages of compositions have the properties of the method") {
    for (const std::string name :
         {"stormer-verlet-yoshida:4", "midpoint-suzuki:4", "symplectic-euler-blanes-moan:6"}) {
        const PartitionedMethod stages = known_oscillator(method_named(name)).stages;
        INFO(name);
        CHECK(is_symplectic(stages).holds);
        CHECK(is_symmetric(stages).holds);
        CHECK(is_symmetric(method_named(name)));
    }
    CHECK_FALSE(is_symmetric(method_named("symplectic-euler")));
}

TEST_CASE("orders of compositions") {
    const auto order = [](const std::string& name) {
        return known_order(method_named(name)).order;
    };
    CHECK(order("stormer-verlet-yoshida:4") == 4);
    CHECK(order("stormer-verlet-kahan-li:8") == 8);
    CHECK(order("symplectic-euler-blanes-moan:6") == 6);
    CHECK(order("gauss:3-yoshida:4") == 6);
    CHECK(order("gauss:3") == 6);
    CHECK_FALSE(known_order(method_named("gauss:3-kahan-li:8")).is_at_least);
}
