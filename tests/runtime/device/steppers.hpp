// Steppers of threads, each with that of one trajectory of the same method and H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <type_traits>
#include <vector>

#include <device/adjoint_euler_chain.hpp>
#include <device/blanes_moan_henon_heiles.hpp>
#include <device/euler_henon_heiles.hpp>
#include <device/gauss_2_double_pendulum.hpp>
#include <device/gauss_2_driven.hpp>
#include <device/gauss_2_henon_heiles.hpp>
#include <device/gauss_3_nonseparable.hpp>
#include <device/gauss_4_kepler.hpp>
#include <device/kahan_li_kepler.hpp>
#include <device/kahan_li_pushed.hpp>
#include <device/lanes/gauss_2_driven.hpp>
#include <device/lanes/gauss_3_nonseparable.hpp>
#include <device/midpoint_pendulum.hpp>
#include <device/one/adjoint_euler_chain.hpp>
#include <device/one/blanes_moan_henon_heiles.hpp>
#include <device/one/euler_henon_heiles.hpp>
#include <device/one/gauss_2_double_pendulum.hpp>
#include <device/one/gauss_2_henon_heiles.hpp>
#include <device/one/gauss_4_kepler.hpp>
#include <device/one/kahan_li_kepler.hpp>
#include <device/one/kahan_li_pushed.hpp>
#include <device/one/midpoint_pendulum.hpp>
#include <device/one/verlet_functions.hpp>
#include <device/one/verlet_kepler.hpp>
#include <device/one/verlet_pendulum.hpp>
#include <device/one/verlet_swing.hpp>
#include <device/verlet_functions.hpp>
#include <device/verlet_kepler.hpp>
#include <device/verlet_pendulum.hpp>
#include <device/verlet_swing.hpp>
#include <hvi/device.hpp>
#include <hvi/ensemble.hpp>

namespace device_test {

namespace made = hvi::generated;

template <class ThreadStepper, class OneStepper>
struct Pair {
    using Threads = ThreadStepper;
    using One = OneStepper;
};

using VerletPendulum = Pair<made::VerletPendulumThreads, made::VerletPendulumAlone>;
using EulerHenonHeiles = Pair<made::EulerHenonHeilesThreads, made::EulerHenonHeilesAlone>;
using VerletKepler = Pair<made::VerletKeplerThreads, made::VerletKeplerAlone>;
using KahanLiKepler = Pair<made::KahanLiKeplerThreads, made::KahanLiKeplerAlone>;
using BlanesMoanHenonHeiles =
    Pair<made::BlanesMoanHenonHeilesThreads, made::BlanesMoanHenonHeilesAlone>;
using AdjointEulerChain = Pair<made::AdjointEulerChainThreads, made::AdjointEulerChainAlone>;
using VerletSwing = Pair<made::VerletSwingThreads, made::VerletSwingAlone>;
using KahanLiPushed = Pair<made::KahanLiPushedThreads, made::KahanLiPushedAlone>;
using VerletFunctions = Pair<made::VerletFunctionsThreads, made::VerletFunctionsAlone>;

using MidpointPendulum = Pair<made::MidpointPendulumThreads, made::MidpointPendulumAlone>;
using Gauss4Kepler = Pair<made::Gauss4KeplerThreads, made::Gauss4KeplerAlone>;
using Gauss2HenonHeiles = Pair<made::Gauss2HenonHeilesThreads, made::Gauss2HenonHeilesAlone>;
using Gauss2DoublePendulum =
    Pair<made::Gauss2DoublePendulumThreads, made::Gauss2DoublePendulumAlone>;
using Gauss3Nonseparable = Pair<made::Gauss3NonseparableThreads, made::Gauss3NonseparableLanes>;
using Gauss2Driven = Pair<made::Gauss2DrivenThreads, made::Gauss2DrivenLanes>;

#define HVI_PAIRS_WITHOUT_FUNCTIONS                                                                \
    device_test::EulerHenonHeiles, device_test::VerletKepler, device_test::KahanLiKepler,          \
        device_test::BlanesMoanHenonHeiles, device_test::AdjointEulerChain
#define HVI_PAIRS_WITH_FUNCTIONS                                                                   \
    device_test::VerletPendulum, device_test::VerletSwing, device_test::KahanLiPushed,             \
        device_test::VerletFunctions

#define HVI_PAIRS_OF_STAGES                                                                        \
    device_test::MidpointPendulum, device_test::Gauss4Kepler, device_test::Gauss2HenonHeiles,      \
        device_test::Gauss2DoublePendulum
#define HVI_PAIRS_WITH_LANES device_test::Gauss3Nonseparable, device_test::Gauss2Driven
#define HVI_ALL_PAIRS                                                                              \
    HVI_PAIRS_WITHOUT_FUNCTIONS, HVI_PAIRS_WITH_FUNCTIONS, HVI_PAIRS_OF_STAGES, HVI_PAIRS_WITH_LANES

template <class State, class = void>
struct HasTime : std::false_type {};
template <class State>
struct HasTime<State, std::void_t<decltype(State::t)>> : std::true_type {};

/// Where the scene begins, each component moved by up to a tenth, and the time by up to 1.
template <class Stepper>
std::vector<typename Stepper::State> starts(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> by(-0.1, 0.1);
    std::vector<typename Stepper::State> result(count, Stepper::initial());
    using Number = typename Stepper::Scalar;
    for (auto& x : result) {
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            x.q[k] += static_cast<Number>(by(random));
            x.p[k] += static_cast<Number>(by(random));
        }
        if constexpr (HasTime<typename Stepper::State>::value) {
            x.t = static_cast<Number>(10 * by(random));
        }
    }
    return result;
}

/// The parameters of the scene for each trajectory.
template <class Stepper>
std::vector<typename Stepper::Parameters> parameters(std::size_t count) {
    return std::vector<typename Stepper::Parameters>(count);
}

/// Returns whether both have the same bits in q, p and the time, and ended alike.
template <class State>
bool same_bits(const State& x, const State& y) {
    if constexpr (HasTime<State>::value) {
        if (std::memcmp(&x.t, &y.t, sizeof x.t) != 0) { return false; }
    }
    return std::memcmp(&x.q, &y.q, sizeof x.q) == 0 && std::memcmp(&x.p, &y.p, sizeof x.p) == 0 &&
           x.status == y.status && x.steps == y.steps;
}

/// Returns the state of a thread as one of a trajectory.
template <class One, class State>
typename One::State alone(const State& x) {
    typename One::State result;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        result.q[k] = x.q[k];
        result.p[k] = x.p[k];
    }
    if constexpr (HasTime<State>::value) { result.t = x.t; }
    return result;
}

/// Returns the largest difference of components, in units of the rounding of the largest.
template <class State, class OneState>
double distance(const State& x, const OneState& y) {
    double largest = 0, difference = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        largest = std::fmax(largest, std::fmax(std::abs(y.q[k]), std::abs(y.p[k])));
        difference = std::fmax(difference, std::abs(x.q[k] - y.q[k]));
        difference = std::fmax(difference, std::abs(x.p[k] - y.p[k]));
    }
    if constexpr (HasTime<State>::value) {
        if (x.t != y.t) { return HUGE_VAL; }
    }
    return difference / (largest * 0x1p-52);
}

}  // namespace device_test
