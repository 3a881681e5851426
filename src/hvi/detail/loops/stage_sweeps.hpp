// Sweeps of a step of positions over a system of any size.
// SPDX-License-Identifier: MIT
//
// NOTE: loops over vectors are not vectorised, as a compiler that sees a dozen of vectors must
// assume that some may be the same. So the loops are written over pointers.
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/sites.hpp>
#include <hvi/detail/stages/velocity_stages.hpp>

namespace hvi::detail {

/// Sets Q_i = q + (e_q + c_i w + sum_j n_ij W_j) of the stages that are solved for, and the
/// changes; see VelocityStages.
template <class Vector, std::size_t stages, std::size_t count>
void move_stages(VelocityStages<Vector, stages>& s, const ScalarOf<Vector> (&n)[stages][stages],
                 const std::array<std::size_t, count>& unknown) {
    using Scalar = ScalarOf<Vector>;
    std::array<const Scalar*, stages> from{};
    std::array<const Scalar*, count> drifted{};
    std::array<Scalar*, count> to{};
    for (std::size_t j = 0; j < stages; ++j) { from[j] = s.W[j].data(); }
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = s.Q[unknown[i]].data();
        drifted[i] = s.drifted[unknown[i]].data();
    }
    const Scalar* const q = s.at.q.data();
    Scalar* const changed = s.change.q.data();
    along<Scalar, 8>(0, static_cast<Place>(s.n), [&](auto stretch, Place k) HVI_INLINED {
        using S = decltype(stretch);
        using V = ValueOf<S>;
        V W[stages];
        for (std::size_t j = 0; j < stages; ++j) { W[j] = S::load(from[j] + k); }
        V change = Scalar(0);
        for (std::size_t i = 0; i < count; ++i) {
            V sum = S::load(drifted[i] + k);
            for (std::size_t j = 0; j < stages; ++j) { sum = sum + V(n[unknown[i]][j]) * W[j]; }
            const V place = S::load(q + k) + sum;
            change = change + abs(place - S::load(to[i] + k));
            S::store(place, to[i] + k);
        }
        S::store(change, changed + k);
    });
}

/// Multiplies x by the factor.
template <class Vector, class Scalar>
void scale(Vector& x, const Scalar& factor) {
    Scalar* const to = x.data();
    along<Scalar, 8>(0, static_cast<Place>(x.size()), [&](auto stretch, Place k) HVI_INLINED {
        using S = decltype(stretch);
        S::store(ValueOf<S>(factor) * S::load(to + k), to + k);
    });
}

/// Sets Lp_j = -h b_j dH/dq(Q_j) and W_j = h K Lp_j on a lattice, in one sweep.
template <class System, class Vector, std::size_t stages>
void kick_stage(const System& system, VelocityStages<Vector, stages>& s, std::size_t j) {
    using Scalar = ScalarOf<Vector>;
    const Sites<System::dimension> sites = system.sites();
    const Place count = sites.count();
    const Vector& Q = s.Q[j];
    const Scalar* const factors = s.factors().all().data();
    Scalar *const Lp = s.Lp[j].data(), *const W = s.W[j].data();
    const auto finish = [&](auto& force, Place e, const Site<System::dimension>& k) {
        using V = std::decay_t<decltype(force[0])>;
        V path[System::components];
        for (V& each : force) { each = V(-s.hb[j]) * each; }
        store(force, count, Lp + e);
        load(factors + e, count, path);
        for (std::size_t i = 0; i < System::components; ++i) { force[i] = path[i] * force[i]; }
        if constexpr (System::has_diagonal_mass) {
            store(force, count, W + e);
        } else {
            system.velocity(force, e, k, path);
            store(path, count, W + e);
        }
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
