// Kepler orbits as parts of H: alone, and of planets in coordinates of Jacobi or about the Sun.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>

#include "flows/orbit.hpp"
#include "flows/planets.hpp"
#include "flows/planets_8_4.hpp"
#include "flows/planets_gauss.hpp"
#include "flows/planets_sun.hpp"

namespace {

namespace made = hvi::generated;

/// Returns the state after steps of one size on an orbit that starts at (x, 0) with speed (0, v).
made::Orbit::State moved(double mu, double x, double v, double h, int steps) {
    made::Orbit::Parameters parameters;
    parameters.mu = mu;
    made::Orbit stepper(parameters);
    made::Orbit::State state;
    state.q = {x, 0};
    state.p = {0, v};
    for (int k = 0; k < steps; ++k) { REQUIRE(stepper.step(state, h).ok()); }
    return state;
}

template <class Stepper>
auto after(double until, int steps) {
    Stepper stepper;
    auto x = Stepper::initial();
    for (int k = 0; k < steps; ++k) { REQUIRE(stepper.step(x, until / steps).ok()); }
    return x;
}

template <class Left, class Right>
double distance(const Left& left, const Right& right) {
    double largest = 0;
    for (std::size_t k = 0; k < left.q.size(); ++k) {
        largest = std::max(largest, std::abs(left.q[k] - right.q[k]));
    }
    return largest;
}

}  // namespace

// NOTE: the places are from Kepler's and Barker's equations, solved in 40 digits.

TEST_CASE("a body alone stays on its orbit with steps of any size") {
    const auto ellipse = moved(1, 0.4, 2, 1.7, 37);
    CHECK(ellipse.q[0] == Approx(0.385726710705694569372469).margin(1e-11));
    CHECK(ellipse.q[1] == Approx(0.1346826831959195615127168).margin(1e-11));
    CHECK(ellipse.p[0] == Approx(-0.4120611822944845720722944).margin(1e-11));
    CHECK(ellipse.p[1] == Approx(1.930129476814333095071508).margin(1e-11));
    const auto hyperbola = moved(2, 1, std::sqrt(5.0), 0.73, 10);
    CHECK(hyperbola.q[0] == Approx(-4.851031861611951881084359).epsilon(1e-14));
    CHECK(hyperbola.q[1] == Approx(8.488131514948242037587933).epsilon(1e-14));
    const auto parabola = moved(2, 1, 2, 0.73, 10);
    CHECK(parabola.q[0] == Approx(-4.966044271719962119289146).epsilon(1e-14));
    CHECK(parabola.q[1] == Approx(4.885097449066891283436515).epsilon(1e-14));
}

TEST_CASE("an orbit goes back the way it came") {
    made::Orbit stepper;
    const auto start = made::Orbit::initial();
    auto x = start;
    for (int k = 0; k < 1000; ++k) { REQUIRE(stepper.step(x, 0.37).ok()); }
    for (int k = 0; k < 1000; ++k) { REQUIRE(stepper.step(x, -0.37).ok()); }
    CHECK(distance(x, start) < 5e-11);
}

TEST_CASE("a step that ends in a collision fails and leaves the state") {
    made::Orbit stepper;
    made::Orbit::State x;
    x.q = {0, 0};
    x.p = {0, 1};
    const auto before = x;
    CHECK_FALSE(stepper.step(x, 0.1).ok());
    CHECK(x.q == before.q);
    CHECK(x.p == before.p);
}

TEST_CASE("orbits of planets disturb each other with the order of the splitting") {
    const auto reference = after<made::PlanetsGauss>(20'000, 200);
    const auto error = [&](const auto& x) { return distance(x, reference); };
    const auto order = [](double coarse, double fine) { return std::log2(coarse / fine); };
    CHECK(order(error(after<made::Planets>(20'000, 200)),
                error(after<made::Planets>(20'000, 400))) == Approx(2).margin(0.1));
    CHECK(order(error(after<made::PlanetsSun>(20'000, 200)),
                error(after<made::PlanetsSun>(20'000, 400))) == Approx(2).margin(0.1));
    CHECK(error(after<made::Planets84>(20'000, 100)) < 1e-8);
    // NOTE: the mass of the planets is a thousandth, and the error of drifts and kicks is larger by
    // about as much.
    CHECK(error(after<made::Planets>(20'000, 200)) < 1e-4);
}

TEST_CASE("orbits of planets keep momenta to round-off, and the energy nearly") {
    const auto check = [](auto stepper, double tolerance) {
        using Stepper = decltype(stepper);
        auto x = Stepper::initial();
        const double energy = stepper.energy(x), spin = stepper.angular_momentum_z(x);
        const double momentum = stepper.momentum_x(x);
        double largest = 0;
        for (int k = 0; k < 5000; ++k) {
            REQUIRE(stepper.step(x, 100).ok());
            largest = std::max(largest, std::abs(stepper.energy(x) / energy - 1));
        }
        CHECK(largest < tolerance);
        CHECK(largest > tolerance / 100);
        CHECK(stepper.angular_momentum_z(x) == Approx(spin).epsilon(1e-13));
        CHECK(std::abs(stepper.momentum_x(x) - momentum) < 1e-19);
    };
    check(made::Planets{}, 1e-6);
    check(made::PlanetsSun{}, 1e-6);
    check(made::Planets84{}, 1e-11);
}
