// Steppers of ensembles, each with that of one trajectory of the same method and H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <type_traits>
#include <vector>

#include <ensemble/adjoint_euler_pendulum.hpp>
#include <ensemble/blanes_moan_henon_heiles.hpp>
#include <ensemble/euler_pendulum.hpp>
#include <ensemble/gauss_2_double_pendulum.hpp>
#include <ensemble/gauss_2_quartic.hpp>
#include <ensemble/gauss_2_quartic_swing.hpp>
#include <ensemble/gauss_3_growing.hpp>
#include <ensemble/gauss_3_growing_root.hpp>
#include <ensemble/gauss_3_joined.hpp>
#include <ensemble/gauss_3_nonseparable.hpp>
#include <ensemble/gauss_3_swing.hpp>
#include <ensemble/gauss_3_weighed.hpp>
#include <ensemble/gauss_4_kepler.hpp>
#include <ensemble/gauss_5_pushed.hpp>
#include <ensemble/gauss_8_henon_heiles.hpp>
#include <ensemble/kahan_li_free.hpp>
#include <ensemble/kahan_li_kepler.hpp>
#include <ensemble/kahan_li_pushed.hpp>
#include <ensemble/midpoint_pendulum.hpp>
#include <ensemble/one/adjoint_euler_pendulum.hpp>
#include <ensemble/one/blanes_moan_henon_heiles.hpp>
#include <ensemble/one/euler_pendulum.hpp>
#include <ensemble/one/gauss_2_double_pendulum.hpp>
#include <ensemble/one/gauss_2_quartic.hpp>
#include <ensemble/one/gauss_2_quartic_swing.hpp>
#include <ensemble/one/gauss_3_growing.hpp>
#include <ensemble/one/gauss_3_growing_root.hpp>
#include <ensemble/one/gauss_3_joined.hpp>
#include <ensemble/one/gauss_3_nonseparable.hpp>
#include <ensemble/one/gauss_3_swing.hpp>
#include <ensemble/one/gauss_3_weighed.hpp>
#include <ensemble/one/gauss_4_kepler.hpp>
#include <ensemble/one/gauss_5_pushed.hpp>
#include <ensemble/one/gauss_8_henon_heiles.hpp>
#include <ensemble/one/kahan_li_kepler.hpp>
#include <ensemble/one/kahan_li_pushed.hpp>
#include <ensemble/one/midpoint_pendulum.hpp>
#include <ensemble/one/split_henon_heiles.hpp>
#include <ensemble/one/split_molecule.hpp>
#include <ensemble/one/split_ring.hpp>
#include <ensemble/one/split_trap.hpp>
#include <ensemble/one/verlet_kepler.hpp>
#include <ensemble/one/verlet_pendulum.hpp>
#include <ensemble/one/verlet_swing.hpp>
#include <ensemble/one/yoshida_6_chain.hpp>
#include <ensemble/split_henon_heiles.hpp>
#include <ensemble/split_molecule.hpp>
#include <ensemble/split_ring.hpp>
#include <ensemble/split_trap.hpp>
#include <ensemble/verlet_kepler.hpp>
#include <ensemble/verlet_pendulum.hpp>
#include <ensemble/verlet_swing.hpp>
#include <ensemble/yoshida_6_chain.hpp>
#include <hvi/ensemble.hpp>

namespace ensemble_test {

template <class EnsembleStepper, class OneStepper>
struct Pair {
    using Many = EnsembleStepper;
    using One = OneStepper;
};

namespace made = hvi::generated;

using VerletPendulum = Pair<made::VerletPendulums, made::VerletPendulum>;
using EulerPendulum = Pair<made::EulerPendulums, made::EulerPendulum>;
using VerletKepler = Pair<made::VerletKeplers, made::VerletKepler>;
using BlanesMoanHenonHeiles = Pair<made::BlanesMoanHenonHeileses, made::BlanesMoanHenonHeiles>;
using AdjointEulerPendulum = Pair<made::AdjointEulerPendulums, made::AdjointEulerPendulum>;
using KahanLiKepler = Pair<made::KahanLiKeplers, made::KahanLiKepler>;
using Yoshida6Chain = Pair<made::Yoshida6Chains, made::Yoshida6Chain>;
using MidpointPendulum = Pair<made::MidpointPendulums, made::MidpointPendulum>;
using Gauss2Quartic = Pair<made::Gauss2Quartics, made::Gauss2Quartic>;
using Gauss2DoublePendulum = Pair<made::Gauss2DoublePendulums, made::Gauss2DoublePendulum>;
using Gauss3Nonseparable = Pair<made::Gauss3Nonseparables, made::Gauss3Nonseparable>;
using Gauss4Kepler = Pair<made::Gauss4Keplers, made::Gauss4Kepler>;
using Gauss8HenonHeiles = Pair<made::Gauss8HenonHeileses, made::Gauss8HenonHeiles>;
using Gauss3Weighed = Pair<made::Gauss3Weigheds, made::Gauss3Weighed>;
using Gauss3Joined = Pair<made::Gauss3Joineds, made::Gauss3Joined>;
using VerletSwing = Pair<made::VerletSwings, made::VerletSwing>;
using KahanLiPushed = Pair<made::KahanLiPusheds, made::KahanLiPushed>;
using Gauss3Swing = Pair<made::Gauss3Swings, made::Gauss3Swing>;
using Gauss5Pushed = Pair<made::Gauss5Pusheds, made::Gauss5Pushed>;
using Gauss2QuarticSwing = Pair<made::Gauss2QuarticSwings, made::Gauss2QuarticSwing>;
using Gauss3Growing = Pair<made::Gauss3Growings, made::Gauss3Growing>;
using Gauss3GrowingRoot = Pair<made::Gauss3GrowingRoots, made::Gauss3GrowingRoot>;
using SplitHenonHeiles = Pair<made::SplitHenonHeileses, made::SplitHenonHeiles>;
using SplitRing = Pair<made::SplitRings, made::SplitRing>;
using SplitMolecule = Pair<made::SplitMolecules, made::SplitMolecule>;
using SplitTrap = Pair<made::SplitTraps, made::SplitTrap>;

#define HVI_EXPLICIT_PAIRS                                                                         \
    ensemble_test::VerletPendulum, ensemble_test::EulerPendulum, ensemble_test::VerletKepler,      \
        ensemble_test::BlanesMoanHenonHeiles, ensemble_test::AdjointEulerPendulum,                 \
        ensemble_test::KahanLiKepler, ensemble_test::Yoshida6Chain, ensemble_test::VerletSwing,    \
        ensemble_test::KahanLiPushed, ensemble_test::SplitHenonHeiles, ensemble_test::SplitRing,   \
        ensemble_test::SplitMolecule, ensemble_test::SplitTrap
#define HVI_IMPLICIT_PAIRS                                                                         \
    ensemble_test::MidpointPendulum, ensemble_test::Gauss2Quartic,                                 \
        ensemble_test::Gauss2DoublePendulum, ensemble_test::Gauss3Nonseparable,                    \
        ensemble_test::Gauss4Kepler, ensemble_test::Gauss8HenonHeiles, ensemble_test::Gauss3Swing, \
        ensemble_test::Gauss5Pushed, ensemble_test::Gauss2QuarticSwing,                            \
        ensemble_test::Gauss3Growing, ensemble_test::Gauss3GrowingRoot,                            \
        ensemble_test::Gauss3Weighed, ensemble_test::Gauss3Joined
#define HVI_TIMED_PAIRS                                                                            \
    ensemble_test::VerletSwing, ensemble_test::KahanLiPushed, ensemble_test::Gauss3Swing,          \
        ensemble_test::Gauss5Pushed, ensemble_test::Gauss2QuarticSwing,                            \
        ensemble_test::Gauss3Growing, ensemble_test::Gauss3GrowingRoot

template <class Stepper>
constexpr std::size_t dimension = std::tuple_size<typename Stepper::Vector>::value;

template <class State>
constexpr bool has_time = std::is_base_of_v<hvi::TimedState<decltype(State::q)>, State>;

/// Where the scene begins, each component moved by up to a tenth, and the time by up to 1.
template <class Stepper>
std::vector<typename Stepper::Trajectory> starts(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> by(-0.1, 0.1);
    std::vector<typename Stepper::Trajectory> result(count, Stepper::initial());
    for (auto& x : result) {
        for (std::size_t k = 0; k < dimension<Stepper>; ++k) {
            x.q[k] += by(random);
            x.p[k] += by(random);
        }
        if constexpr (has_time<typename Stepper::Trajectory>) { x.t = 10 * by(random); }
    }
    return result;
}

/// Returns the largest difference of components, in units of the rounding of the largest; infinite
/// unless both have equal times, bit for bit.
template <class State>
double distance(const State& x, const State& y) {
    double largest = 0, difference = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        largest = std::fmax(largest, std::fmax(std::abs(x.q[k]), std::abs(x.p[k])));
        difference = std::fmax(difference, std::abs(x.q[k] - y.q[k]));
        difference = std::fmax(difference, std::abs(x.p[k] - y.p[k]));
    }
    if constexpr (has_time<State>) {
        if (x.t != y.t) { return HUGE_VAL; }
    }
    return difference / (largest * 0x1p-52);
}

template <class State>
bool same_bits(const State& x, const State& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
}

}  // namespace ensemble_test
