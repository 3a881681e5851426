// The discrete Hamiltonian of a step and the discrete action of a run: what the paper says of their
// derivatives, by dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <tuple>

#include <catch2/catch.hpp>
#include <driver/dual.hpp>

// NOTE: behind dual.hpp, which says why.
#include <action/composed_curve_kepler.hpp>
#include <action/composed_curve_rooted.hpp>
#include <action/composed_lagrangian.hpp>
#include <action/composed_nonseparable.hpp>
#include <action/composed_rooted.hpp>
#include <action/curve_12_kepler.hpp>
#include <action/curve_12_nonseparable.hpp>
#include <action/curve_23_kepler.hpp>
#include <action/curve_23_nonseparable.hpp>
#include <action/curve_24_kepler.hpp>
#include <action/curve_24_nonseparable.hpp>
#include <action/curve_rooted.hpp>
#include <action/curve_shaken.hpp>
#include <action/euler_b_henon_heiles.hpp>
#include <action/euler_pendulum.hpp>
#include <action/fitted_driven.hpp>
#include <action/gauss_nonseparable.hpp>
#include <action/gauss_pendulum.hpp>
#include <action/gauss_shaken.hpp>
#include <action/lagrangian_23_double.hpp>
#include <action/lagrangian_double.hpp>
#include <action/lagrangian_rooted.hpp>
#include <action/lagrangian_spherical.hpp>
#include <action/lobatto_kepler.hpp>
#include <action/lobatto_nonseparable.hpp>
#include <action/midpoint_pendulum.hpp>
#include <action/newton_pendulum.hpp>
#include <action/radau_henon_heiles.hpp>
#include <action/trig3_vortices.hpp>
#include <action/verlet_driven.hpp>
#include <action/verlet_pendulum.hpp>
#include <action/yoshida_driven.hpp>
#include <action/yoshida_kepler.hpp>

using namespace hvi::generated;

namespace {

// ---- derivatives ----

/// sum_k a_k db_k, by one of the variables; `a` is the value of that.
template <class Vector>
double along(const Vector& a, const Vector& b, std::size_t variable) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) { sum += a[k].value * b[k].by[variable]; }
    return sum;
}

template <class Vector>
double dot(const Vector& a, const Vector& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) { sum += a[k].value * b[k].value; }
    return sum;
}

/// Steps from x, which is differentiated by its 2n components. (3.10): d H_d^+(q_l, p_{l+1}) is
/// p_l dq_l + q_{l+1} dp_{l+1}. The steps together have S_d^k as a function of q_0 and p_k, with
/// the derivatives p_0 and, (3.14), q_k. Last (3.12), where D S_d^k is q_k.
template <template <class...> class Basic, class State>
void check_derivatives(const State& start, double h, double bound) {
    constexpr std::size_t n = std::tuple_size_v<decltype(start.q)>;
    using Dual = hvi::driver::Dual<2 * n>;
    using Stepper = Basic<Dual>;
    Stepper stepper{typename Stepper::Parameters{}};
    typename Stepper::State x;
    for (std::size_t k = 0; k < n; ++k) {
        x.q[k] = hvi::driver::variable<2 * n>(start.q[k], k);
        x.p[k] = hvi::driver::variable<2 * n>(start.p[k], n + k);
    }
    if constexpr (requires { x.t; }) { x.t = start.t; }
    const typename Stepper::State first = x;
    double action = dot(x.p, x.q);
    for (int step = 0; step < 6; ++step) {
        const typename Stepper::State before = x;
        REQUIRE(stepper.step(x, step == 4 ? -h : h).ok());
        const Dual H = stepper.generating_function();
        const Dual S = stepper.action();
        for (std::size_t i = 0; i < 2 * n; ++i) {
            const double of_step = along(before.p, before.q, i) + along(x.q, x.p, i);
            CHECK(std::abs(H.by[i] - of_step) < bound);
            const double of_steps = along(first.p, first.q, i) + along(x.q, x.p, i);
            CHECK(std::abs(S.by[i] - of_steps) < bound);
        }
        CHECK(std::abs(S.value - action - (H.value - dot(before.p, before.q))) < bound);
        action = S.value;
    }
}

}  // namespace

TEST_CASE("(3.10), (3.12) and (3.14) by dual numbers: explicit methods") {
    check_derivatives<BasicEulerPendulum>(EulerPendulum::State{{0.7}, {0.4}}, 0.3, 1e-14);
    check_derivatives<BasicEulerBHenonHeiles>(EulerBHenonHeiles::State{{0.1, -0.2}, {0.3, 0.15}},
                                              0.2, 1e-14);
    check_derivatives<BasicVerletPendulum>(VerletPendulum::State{{0.7}, {0.4}}, 0.3, 1e-14);
    check_derivatives<BasicYoshidaKepler>(YoshidaKepler::initial(), 0.05, 1e-12);
}

TEST_CASE("(3.10), (3.12) and (3.14) by dual numbers: implicit methods") {
    check_derivatives<BasicMidpointPendulum>(MidpointPendulum::State{{0.7}, {0.4}}, 0.3, 1e-14);
    check_derivatives<BasicGaussPendulum>(GaussPendulum::State{{0.7}, {0.4}}, 0.5, 1e-14);
    check_derivatives<BasicNewtonPendulum>(NewtonPendulum::State{{0.7}, {0.4}}, 0.5, 1e-14);
    check_derivatives<BasicLobattoKepler>(LobattoKepler::initial(), 0.05, 1e-12);
    check_derivatives<BasicRadauHenonHeiles>(RadauHenonHeiles::State{{0.1, -0.2}, {0.3, 0.15}}, 0.2,
                                             1e-14);
}

TEST_CASE("(3.10), (3.12) and (3.14) by dual numbers: H is not T(p) + U(q)") {
    const GaussNonseparable::State start{{0.7}, {0.4}};
    check_derivatives<BasicGaussNonseparable>(start, 0.1, 1e-13);
    check_derivatives<BasicLobattoNonseparable>(start, 0.1, 1e-13);
    check_derivatives<BasicComposedNonseparable>(start, 0.05, 1e-13);
    check_derivatives<BasicTrig3Vortices>(Trig3Vortices::initial(), 0.1, 1e-13);
}

TEST_CASE("(3.10), (3.12) and (3.14) by dual numbers: H depends on the time") {
    const VerletDriven::State start{{{0.7}, {0.4}}, 0.3};
    check_derivatives<BasicVerletDriven>(start, 0.2, 1e-14);
    check_derivatives<BasicYoshidaDriven>(start, 0.2, 1e-14);
    check_derivatives<BasicGaussShaken>(start, 0.2, 1e-14);
    check_derivatives<BasicFittedDriven>(start, 0.2, 1e-14);
}

TEST_CASE("(3.10), (3.12) and (3.14) by dual numbers: more nodes than functions") {
    const Curve12Nonseparable::State start{{0.7}, {0.4}};
    check_derivatives<BasicCurve12Nonseparable>(start, 0.1, 1e-13);
    check_derivatives<BasicCurve23Nonseparable>(start, 0.1, 1e-13);
    check_derivatives<BasicCurve24Nonseparable>(start, 0.1, 1e-13);
    check_derivatives<BasicCurve12Kepler>(Curve12Kepler::initial(), 0.05, 1e-12);
    check_derivatives<BasicCurve23Kepler>(Curve23Kepler::initial(), 0.05, 1e-12);
    check_derivatives<BasicCurve24Kepler>(Curve24Kepler::initial(), 0.05, 1e-12);
    check_derivatives<BasicComposedCurveKepler>(ComposedCurveKepler::initial(), 0.05, 1e-12);
    const CurveShaken::State at_time{{{0.7}, {0.4}}, 0.3};
    check_derivatives<BasicCurveShaken>(at_time, 0.2, 1e-13);
    check_derivatives<BasicCurveRooted>(at_time, 0.1, 1e-13);
    check_derivatives<BasicComposedCurveRooted>(at_time, 0.1, 1e-13);
}

TEST_CASE("(3.10), (3.12) and (3.14) by dual numbers: Lagrangians") {
    const LagrangianDouble::State start{{0.7, -0.4}, {0.5, 1.5}};
    check_derivatives<BasicLagrangianDouble>(start, 0.05, 1e-12);
    check_derivatives<BasicLagrangian23Double>(start, 0.05, 1e-12);
    check_derivatives<BasicComposedLagrangian>(start, 0.05, 1e-12);
    check_derivatives<BasicLagrangianSpherical>(LagrangianSpherical::initial(), 0.05, 1e-12);
    const LagrangianRooted::State at_time{{{0.7}, {0.4}}, 0.3};
    check_derivatives<BasicLagrangianRooted>(at_time, 0.1, 1e-13);
    check_derivatives<BasicComposedRooted>(at_time, 0.1, 1e-13);
}
