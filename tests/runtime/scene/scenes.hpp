// The ten scenes that come with hvi, as C++, and what tests do with any of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include <hvi/detail/linear/linear_stages.hpp>
#include <scene/double_pendulum.hpp>
#include <scene/fpu.hpp>
#include <scene/harmonic_oscillator.hpp>
#include <scene/henon_heiles.hpp>
#include <scene/kepler.hpp>
#include <scene/nonseparable.hpp>
#include <scene/outer_solar_system.hpp>
#include <scene/pendulum.hpp>
#include <scene/point_vortices.hpp>
#include <scene/qp.hpp>

namespace scenes {

/// Calls `use.template operator()<Stepper>()` for each, with the method of its [run].
template <class Use>
void for_each(Use use) {
    using namespace hvi::generated;
    use.template operator()<DoublePendulum>();
    use.template operator()<Fpu>();
    use.template operator()<HarmonicOscillator>();
    use.template operator()<HenonHeiles>();
    use.template operator()<Kepler>();
    use.template operator()<Nonseparable>();
    use.template operator()<OuterSolarSystem>();
    use.template operator()<Pendulum>();
    use.template operator()<PointVortices>();
    use.template operator()<Qp>();
}

template <class Vector>
double distance(const Vector& a, const Vector& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) { sum += std::abs(a[k] - b[k]); }
    return sum;
}

template <class State>
double distance_of_states(const State& a, const State& b) {
    return distance(a.q, b.q) + distance(a.p, b.p);
}

template <class State>
bool same_bits(const State& a, const State& b) {
    return std::memcmp(&a, &b, sizeof(State)) == 0;
}

/// dH/dq and dH/dp of a system of either kind.
template <class System, class Vector>
void gradient(const System& system, const Vector& q, const Vector& p, Vector& dq, Vector& dp) {
    using Quadratic = hvi::detail::Quadratic<double, std::tuple_size_v<Vector>>;
    if constexpr (requires(Quadratic & H) { system.quadratic(H); }) {
        Quadratic H;
        system.quadratic(H);
        dq = H.by_q;
        dp = H.by_p;
        for (std::size_t i = 0; i < dq.size(); ++i) {
            for (std::size_t j = 0; j < dq.size(); ++j) {
                dq[i] += H.qq[i][j] * q[j] + H.qp[i][j] * p[j];
                dp[i] += H.qp[j][i] * q[j] + H.pp[i][j] * p[j];
            }
        }
    } else if constexpr (requires { system.dHdq(q, dq); }) {
        system.dHdq(q, dq);
        system.dHdp(p, dp);
    } else if constexpr (requires { system.gradient(q, p, dq, dp); }) {
        system.gradient(q, p, dq, dp);
    } else {
        system.dHdq(q, p, dq);
        system.dHdp(q, p, dp);
    }
}

}  // namespace scenes
