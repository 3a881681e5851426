// Sweeps of a step of positions over a system of any size.
// SPDX-License-Identifier: MIT
//
// NOTE: written as loops over vectors they are not computed side by side, as a compiler that sees a
// dozen of vectors takes it that some may be the same.
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/sites.hpp>
#include <hvi/detail/stages/velocity_stages.hpp>

namespace hvi::detail {

/// Q_i = q + (e_q + (c_i hv + sum_j n_ij W_j)) of the stages that are solved for, and what that
/// changes; see VelocityStages.
template <class Vector, std::size_t stages, std::size_t count>
void move_stages(VelocityStages<Vector, stages>& s, const ScalarOf<Vector> (&c)[stages],
                 const ScalarOf<Vector> (&n)[stages][stages],
                 const std::array<std::size_t, count>& unknown) {
    using Scalar = ScalarOf<Vector>;
    std::array<const Scalar*, stages> from{};
    std::array<Scalar*, count> to{};
    for (std::size_t j = 0; j < stages; ++j) { from[j] = s.W[j].data(); }
    for (std::size_t i = 0; i < count; ++i) { to[i] = s.Q[unknown[i]].data(); }
    const Scalar *const q = s.at.q.data(), *const e_q = s.remainder.q.data(),
                        *const hv = s.free_path.data();
    Scalar* const changed = s.change.q.data();
    along<Scalar, 8>(0, static_cast<Place>(s.n), [&](auto stretch, Place k) HVI_INLINED {
        using S = decltype(stretch);
        using V = ValueOf<S>;
        V W[stages];
        for (std::size_t j = 0; j < stages; ++j) { W[j] = S::load(from[j] + k); }
        V change = Scalar(0);
        for (std::size_t i = 0; i < count; ++i) {
            V sum = V(c[unknown[i]]) * S::load(hv + k);
            for (std::size_t j = 0; j < stages; ++j) { sum = sum + V(n[unknown[i]][j]) * W[j]; }
            const V place = S::load(q + k) + (S::load(e_q + k) + sum);
            change = change + abs(place - S::load(to[i] + k));
            S::store(place, to[i] + k);
        }
        S::store(change, changed + k);
    });
}

/// x *= factor.
template <class Vector, class Scalar>
void scale(Vector& x, const Scalar& factor) {
    Scalar* const to = x.data();
    along<Scalar, 8>(0, static_cast<Place>(x.size()), [&](auto stretch, Place k) HVI_INLINED {
        using S = decltype(stretch);
        S::store(ValueOf<S>(factor) * S::load(to + k), to + k);
    });
}

/// Lp = -hb dH/dq(Q) and W = h K Lp on a lattice, in one sweep.
template <class System, class Vector, class Scalar>
void kick_stage(const System& system, const Vector& Q, const Scalar& hb, const Scalar& h,
                Vector& Lp, Vector& W) {
    const Sites<System::dimension> sites = system.sites();
    const Place count = sites.count();
    const auto finish = [&](auto& force, Place e, const Site<System::dimension>& k) {
        using V = std::decay_t<decltype(force[0])>;
        V velocity[System::components];
        for (V& each : force) { each = V(-hb) * each; }
        system.velocity(force, e, k, velocity);
        for (V& each : velocity) { each = V(h) * each; }
        store(force, count, Lp.data() + e);
        store(velocity, count, W.data() + e);
    };
    sites.for_each_edge([&](Place e, const Site<System::dimension>& k) {
        Scalar force[System::components];
        system.force_at_edge(Q.data(), e, k, force);
        finish(force, e, k);
    });
    for (Place row = 0; row < sites.inside_rows(); ++row) {
        for_each_stretch<Scalar>(sites.inside_row(row),
                                 [&](auto stretch, Place e, const Site<System::dimension>& k) {
                                     ValueOf<decltype(stretch)> force[System::components];
                                     system.force(Q.data(), e, k, force);
                                     finish(force, e, k);
                                 });
    }
}

}  // namespace hvi::detail
