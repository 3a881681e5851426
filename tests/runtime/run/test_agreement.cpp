// Generated steppers against the table-driven one, which shares no code with them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/generated/adjoint_symplectic_euler.hpp>
#include <hvi/generated/adjoint_symplectic_euler_separable.hpp>
#include <hvi/generated/chebyshev_3.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/lobatto_3.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/stormer_verlet.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/generated/symplectic_euler.hpp>
#include <hvi/generated/symplectic_euler_separable.hpp>
#include <hvi/generated/trig3.hpp>
#include <hvi/generic_stepper.hpp>
#include <hvi/newton.hpp>

#include "printed_tableaux.hpp"
#include "systems.hpp"

using namespace hvi::generated;
using namespace printed;

namespace {

template <class System>
hvi::GenericStepper<double> generic(const hvi::Coefficients<double>& method, const System& system) {
    using Table = hvi::GenericStepper<double>::Vector;
    using Vector = typename System::Vector;
    const auto copy = [](const Table& from) {
        Vector to{};
        for (std::size_t k = 0; k < to.size(); ++k) { to[k] = from[k]; }
        return to;
    };
    return {method,
            [=](const Table& q, const Table& p, Table& out) {
                Vector slope{};
                system.dHdq(copy(q), copy(p), slope);
                out.assign(slope.begin(), slope.end());
            },
            [=](const Table& q, const Table& p, Table& out) {
                Vector slope{};
                system.dHdp(copy(q), copy(p), slope);
                out.assign(slope.begin(), slope.end());
            }};
}

/// Both step `steps` times; the difference is to stay within `bound` of the largest component.
template <class Stepper, class System>
void compare(Stepper stepper, const hvi::Coefficients<double>& method, const System& system,
             hvi::State<typename System::Vector> x, double h, int steps, double bound) {
    const hvi::GenericStepper<double> oracle = generic(method, system);
    hvi::GenericStepper<double>::State y{{x.q.begin(), x.q.end()}, {x.p.begin(), x.p.end()}};
    for (int i = 0; i < steps; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(oracle.step(y, h).ok());
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            REQUIRE(std::abs(x.q[k] - y.q[k]) <= bound * 0x1p-52);
            REQUIRE(std::abs(x.p[k] - y.p[k]) <= bound * 0x1p-52);
        }
    }
}

using Kepler = systems::AsGeneral<systems::Kepler>;
const hvi::State<systems::Two> orbit{{1.0, 0.2}, {0.1, 0.9}};
const hvi::State<systems::One> point{{0.7}, {-0.4}};

template <template <class, class> class Stepper>
void compare_general(const hvi::Coefficients<double>& method) {
    for (const double h : {0.1, -0.05}) {
        // One step to a few units in the last place, later ones to what the flow makes of them.
        compare(Stepper<systems::Product, hvi::FixedPoint>{}, method, systems::Product{}, point, h,
                1, 6);
        compare(Stepper<systems::Product, hvi::Newton>{}, method, systems::Product{}, point, h, 1,
                6);
        compare(Stepper<Kepler, hvi::FixedPoint>{}, method, Kepler{}, orbit, h, 1, 6);
        compare(Stepper<systems::Product, hvi::FixedPoint>{}, method, systems::Product{}, point, h,
                50, 300);
        compare(Stepper<systems::Product, hvi::Newton>{}, method, systems::Product{}, point, h, 50,
                300);
        compare(Stepper<Kepler, hvi::FixedPoint>{}, method, Kepler{}, orbit, h, 50, 300);
    }
}

template <class Stepper>
void compare_separable(const hvi::Coefficients<double>& method) {
    for (const double h : {0.1, -0.05}) {
        compare(Stepper{}, method, Kepler{}, orbit, h, 1, 6);
        compare(Stepper{}, method, Kepler{}, orbit, h, 50, 300);
    }
}

}  // namespace

TEST_CASE("symplectic Euler agrees with its table") {
    compare_general<SymplecticEuler>(euler);
    compare_separable<SymplecticEulerSeparable<systems::Kepler>>(euler);
}

TEST_CASE("the adjoint of symplectic Euler agrees with its table") {
    compare_general<AdjointSymplecticEuler>(adjoint_euler);
    compare_separable<AdjointSymplecticEulerSeparable<systems::Kepler>>(adjoint_euler);
}

TEST_CASE("Störmer-Verlet agrees with its table") {
    compare_general<StormerVerlet>(verlet);
    compare_separable<StormerVerletSeparable<systems::Kepler>>(verlet);
}

TEST_CASE("gauss:2 agrees with its table") {
    compare_general<Gauss2>(gauss);
    compare_separable<Gauss2Separable<systems::Kepler>>(gauss);
}

TEST_CASE("lobatto:3 agrees with its table") {
    compare_general<Lobatto3>(lobatto);
    compare_separable<Lobatto3Separable<systems::Kepler>>(lobatto);
}

TEST_CASE("chebyshev:3 agrees with its table") { compare_general<Chebyshev3>(cheby); }
TEST_CASE("trig3 agrees with its table") { compare_general<Trig3>(trig); }
