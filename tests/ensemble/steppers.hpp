// Steppers of ensembles, each with that of one trajectory of the same method and H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

#include <ensemble/adjoint_euler_pendulum.hpp>
#include <ensemble/blanes_moan_henon_heiles.hpp>
#include <ensemble/euler_pendulum.hpp>
#include <ensemble/gauss_2_quartic.hpp>
#include <ensemble/gauss_2_double_pendulum.hpp>
#include <ensemble/gauss_3_nonseparable.hpp>
#include <ensemble/gauss_4_kepler.hpp>
#include <ensemble/gauss_8_henon_heiles.hpp>
#include <ensemble/kahan_li_free.hpp>
#include <ensemble/kahan_li_kepler.hpp>
#include <ensemble/midpoint_pendulum.hpp>
#include <ensemble/one/adjoint_euler_pendulum.hpp>
#include <ensemble/one/blanes_moan_henon_heiles.hpp>
#include <ensemble/one/euler_pendulum.hpp>
#include <ensemble/one/gauss_2_quartic.hpp>
#include <ensemble/one/gauss_2_double_pendulum.hpp>
#include <ensemble/one/gauss_3_nonseparable.hpp>
#include <ensemble/one/gauss_4_kepler.hpp>
#include <ensemble/one/gauss_8_henon_heiles.hpp>
#include <ensemble/one/kahan_li_kepler.hpp>
#include <ensemble/one/midpoint_pendulum.hpp>
#include <ensemble/one/verlet_kepler.hpp>
#include <ensemble/one/verlet_pendulum.hpp>
#include <ensemble/one/yoshida_6_chain.hpp>
#include <ensemble/verlet_kepler.hpp>
#include <ensemble/verlet_pendulum.hpp>
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

#define HVI_EXPLICIT_PAIRS                                                                         \
    ensemble_test::VerletPendulum, ensemble_test::EulerPendulum, ensemble_test::VerletKepler,      \
        ensemble_test::BlanesMoanHenonHeiles, ensemble_test::AdjointEulerPendulum,                 \
        ensemble_test::KahanLiKepler, ensemble_test::Yoshida6Chain
#define HVI_IMPLICIT_PAIRS                                                                         \
    ensemble_test::MidpointPendulum, ensemble_test::Gauss2Quartic,                                 \
        ensemble_test::Gauss2DoublePendulum, ensemble_test::Gauss3Nonseparable,                    \
        ensemble_test::Gauss4Kepler,                                                               \
        ensemble_test::Gauss8HenonHeiles

template <class Stepper>
constexpr std::size_t dimension = std::tuple_size<typename Stepper::Vector>::value;

/// Where the scene begins, each component moved by up to a tenth.
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
    }
    return result;
}

template <class State>
bool same_bits(const State& x, const State& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
}

}  // namespace ensemble_test
