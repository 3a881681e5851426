// Small steps of fast parts, beside a loop by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>

#include "flows/molecule_gauss.hpp"
#include "flows/molecule_kahan_li.hpp"
#include "flows/molecule_odd.hpp"
#include "flows/molecule_strang.hpp"

namespace {

using hvi::generated::MoleculeGauss;
using hvi::generated::MoleculeKahanLi;
using hvi::generated::MoleculeOdd;
using hvi::generated::MoleculeStrang;

using Real = long double;

/// The scene molecule.toml by hand, in more digits.
struct MoleculeByHand {
    std::array<Real, 3> x, y, u, v;
    Real k;

    explicit MoleculeByHand(Real stiffness)
        : x{-1, 0, 0.8L}, y{0, 0.2L, -0.5L}, u{0.1L, 0, -0.2L}, v{0, 0.5L, -0.25L}, k(stiffness) {}

    /// Adds forces along the line between two atoms; `force` is positive where they repel.
    template <class Force>
    void kick_pair(std::size_t i, std::size_t j, Real time, Force force) {
        const Real dx = x[j] - x[i], dy = y[j] - y[i];
        const Real r = std::sqrt(dx * dx + dy * dy);
        const Real along = time * force(r) / r;
        u[i] -= along * dx;
        v[i] -= along * dy;
        u[j] += along * dx;
        v[j] += along * dy;
    }
    void slow(Real time) {
        kick_pair(0, 2, time, [](Real r) { return 1 / (r * r); });
        for (std::size_t i = 0; i < 3; ++i) {
            u[i] -= time * x[i] / 5;
            v[i] -= time * 2 * y[i] / 5;
        }
    }
    void bonds(Real time) {
        kick_pair(0, 1, time, [&](Real r) { return -k * (r - 1); });
        kick_pair(1, 2, time, [&](Real r) { return -k * (r - 1); });
    }
    void drift(Real time) {
        constexpr std::array<Real, 3> mass{1, 2, 1};
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] += time * u[i] / mass[i];
            y[i] += time * v[i] / mass[i];
        }
    }
    /// Takes small steps of velocity Verlet, and a kick by the slow force in their middle.
    void step(Real h, int small_steps) {
        const Real half = h / small_steps / 2;
        for (int n = 0; n < 2 * small_steps; ++n) {
            if (n == small_steps) { slow(h); }
            if (n % 2 == 0) { bonds(half); }
            drift(half);
            if (n % 2 == 1) { bonds(half); }
        }
    }

    template <class State>
    [[nodiscard]] double distance_to(const State& state) const {
        Real largest = 0;
        const auto compare = [&](const std::array<Real, 3>& mine, const auto& its,
                                 std::size_t first) {
            for (std::size_t i = 0; i < 3; ++i) {
                largest = std::max(largest, std::abs(mine[i] - static_cast<Real>(its[first + i])));
            }
        };
        compare(x, state.q, 0);
        compare(y, state.q, 3);
        compare(u, state.p, 0);
        compare(v, state.p, 3);
        return static_cast<double>(largest);
    }
};

template <class Stepper>
typename Stepper::Parameters stiffness(double k) {
    typename Stepper::Parameters parameters;
    parameters.k = k;
    return parameters;
}

template <class Stepper>
auto molecule_after(double until, int steps, double k) {
    const auto parameters = stiffness<Stepper>(k);
    Stepper stepper(parameters);
    auto x = Stepper::initial(parameters);
    for (int n = 0; n < steps; ++n) { REQUIRE(stepper.step(x, until / steps).ok()); }
    return x;
}

template <class Left, class Right>
double molecules_apart(const Left& left, const Right& right) {
    double largest = 0;
    for (std::size_t k = 0; k < left.q.size(); ++k) {
        largest =
            std::max({largest, std::abs(left.q[k] - right.q[k]), std::abs(left.p[k] - right.p[k])});
    }
    return largest;
}

/// Returns the order that the error shows between two numbers of steps, of an easy molecule.
template <class Stepper>
double order_of_molecule(int steps) {
    constexpr double k = 40, until = 2;
    const auto reference = molecule_after<MoleculeGauss>(until, 400, k);
    const double coarse = molecules_apart(molecule_after<Stepper>(until, steps, k), reference);
    const double fine = molecules_apart(molecule_after<Stepper>(until, 2 * steps, k), reference);
    return std::log2(coarse / fine);
}

}  // namespace

TEST_CASE("a step with small steps is that of a loop by hand") {
    constexpr double h = 0.0625;
    MoleculeByHand six(400), five(400);
    MoleculeStrang even;
    MoleculeOdd odd;
    auto x = MoleculeStrang::initial();
    auto y = MoleculeOdd::initial();
    for (int n = 0; n < 160; ++n) {
        REQUIRE(even.step(x, h).ok());
        REQUIRE(odd.step(y, h).ok());
        six.step(static_cast<Real>(h), 6);
        five.step(static_cast<Real>(h), 5);
    }
    CHECK(six.distance_to(x) < 1e-12);
    CHECK(five.distance_to(y) < 1e-12);
    CHECK(five.distance_to(x) > 1e-3);
}

TEST_CASE("small steps keep the orders of strang and of its compositions") {
    CHECK(order_of_molecule<MoleculeStrang>(40) == Approx(2).margin(0.05));
    CHECK(order_of_molecule<MoleculeKahanLi>(20) == Approx(8).margin(0.5));
}

TEST_CASE("small steps lead back") {
    MoleculeStrang stepper;
    auto x = MoleculeStrang::initial();
    const auto start = x;
    for (int n = 0; n < 300; ++n) { REQUIRE(stepper.step(x, 0.05).ok()); }
    CHECK(molecules_apart(x, start) > 0.1);
    for (int n = 0; n < 300; ++n) { REQUIRE(stepper.step(x, -0.05).ok()); }
    CHECK(molecules_apart(x, start) < 1e-11);
}

TEST_CASE("the energy of stiff bonds does not drift in small steps") {
    MoleculeStrang stepper;
    auto x = MoleculeStrang::initial();
    const double energy = stepper.energy(x);
    double early = 0, late = 0;
    for (int n = 0; n < 40'000; ++n) {
        REQUIRE(stepper.step(x, 0.05).ok());
        double& largest = n < 20'000 ? early : late;
        largest = std::max(largest, std::abs(stepper.energy(x) - energy));
    }
    CHECK(early < 0.05 * energy);
    CHECK(late < 1.2 * early);
}
