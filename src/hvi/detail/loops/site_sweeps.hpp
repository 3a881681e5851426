// Sweeps over a lattice that move a state in place.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/loops/site_chunks.hpp>
#include <hvi/detail/loops/sites.hpp>

namespace hvi::detail {

/// Factors of the slopes at one point, applied one after the other. Up to two: one of the end of a
/// step, and one of the start of the next.
template <class Scalar>
class MoveFactors {
public:
    [[nodiscard]] bool is_empty() const { return count_ == 0; }
    [[nodiscard]] bool is_full() const { return count_ == 2; }

    /// Precondition: !is_full().
    void push(const Scalar& factor) { (count_++ == 0 ? first_ : second_) = factor; }

    /// Adds factor * slope to x for each factor; x stands in place `at`. NOTE: not a loop, for
    /// which g++ keeps the factors in memory.
    template <class V, class Sums>
    HVI_INLINE_IN_LANES void move(V& x, const V& slope, const Sums& sums, Place at) const {
        if (count_ == 0) { return; }
        sums.add(x, V(first_) * slope, at);
        if (count_ == 2) { sums.add(x, V(second_) * slope, at); }
    }

private:
    Scalar first_ = 0, second_ = 0;
    int count_ = 0;
};

/// Pointers to the state, and the sums that round its changes.
template <class Scalar, class Sums>
struct SiteState {
    Scalar* q;
    Scalar* p;
    Sums sums_q, sums_p;
};

/// Kicks, p += b dU/dq, and drifts, q += b dT/dp, of parts of a lattice.
template <class System, class Sums>
class SiteSweeps {
public:
    using Scalar = typename System::Scalar;
    static constexpr std::size_t dimension = System::dimension;
    using Part = RowPart<dimension>;

    SiteSweeps(const System& system, const SiteChunks<System>& chunks,
               const SiteState<Scalar, Sums>& x, const MoveFactors<Scalar>& kicks,
               const MoveFactors<Scalar>& drifts)
        : system_(system),
          chunks_(chunks),
          count_(chunks.sites().count()),
          x_(x),
          kicks_(kicks),
          drifts_(drifts) {}

    void kick_edges() const {
        chunks_.sites().for_each_edge([&](Place e, const Site<dimension>& k) {
            Scalar force[components];
            system_.force_at_edge(x_.q, e, k, force);
            Scalar p[components];
            move_momenta(e, force, p);
        });
    }

    void drift_edges() const {
        chunks_.sites().for_each_edge(
            [&](Place e, const Site<dimension>& k) { drift<Scalar>(e, k); });
    }

    void kick(Units units) const {
        chunks_.for_each_part(units, [&](const Part& part) { kick(part); });
    }

    void drift(Units units) const {
        chunks_.for_each_part(units, [&](const Part& part) { drift(part); });
    }

    /// Kicks the units, and lets each drift as soon as no force elsewhere reads its positions any
    /// more.
    void kick_and_drift(Units units) const {
        const Place lag = dimension == 1 ? 0 : chunks_.reach();
        if (lag == 0) {
            chunks_.for_each_part(units, [&](const Part& part) { kick_and_drift(part); });
            return;
        }
        // A row drifts when the last row that reads it has been kicked.
        for (Place row = units.first; row < units.end + lag; ++row) {
            if (row < units.end) { kick(Units{row, row + 1}); }
            if (row - lag >= units.first && row - lag < units.end) {
                drift(Units{row - lag, row - lag + 1});
            }
        }
    }

private:
    static constexpr std::size_t components = System::components;
    using Wide = SiteLanes<Scalar, Sums::registers>;
    static constexpr Place width = Stretch<Wide>::count;

    template <class V>
    using Values = V[components];

    // ---- stretches ----

    /// Moves the momenta, and returns their new values in p.
    template <class V>
    HVI_INLINE_IN_LANES void move_momenta(Place e, const Values<V>& force, Values<V>& p) const {
        load(x_.p + e, count_, p);
        for (std::size_t c = 0; c < components; ++c) {
            kicks_.move(p[c], force[c], x_.sums_p, e + static_cast<Place>(c) * count_);
        }
        store(p, count_, x_.p + e);
    }

    template <class V>
    HVI_INLINE_IN_LANES void kick(Place e, const Site<dimension>& k, Values<V>& p) const {
        Values<V> force;
        system_.force(x_.q, e, k, force);
        move_momenta(e, force, p);
    }

    /// Moves positions that have been loaded; their remainders stand in memory.
    template <class V>
    HVI_INLINE_IN_LANES void move_positions(Place e, const Site<dimension>& k, const Values<V>& p,
                                            Values<V>& q) const {
        Values<V> velocity;
        system_.velocity(p, e, k, velocity);
        for (std::size_t c = 0; c < components; ++c) {
            drifts_.move(q[c], velocity[c], x_.sums_q, e + static_cast<Place>(c) * count_);
        }
    }

    template <class V>
    HVI_INLINE_IN_LANES void drift(Place e, const Site<dimension>& k) const {
        Values<V> p, q;
        load(x_.p + e, count_, p);
        load(x_.q + e, count_, q);
        move_positions(e, k, p, q);
        store(q, count_, x_.q + e);
    }

    // ---- parts of rows ----

    // NOTE: each function works on a copy, so that the compiler knows that no store changes it.

    void kick(const Part& part) const {
        const SiteSweeps on = *this;
        for_each_stretch<Scalar, Sums::registers>(
            part, [&](auto stretch, Place e, const Site<dimension>& k) {
                Values<ValueOf<decltype(stretch)>> p;
                on.kick(e, k, p);
            });
    }

    void drift(const Part& part) const {
        const SiteSweeps on = *this;
        for_each_stretch<Scalar, Sums::registers>(
            part, [&](auto stretch, Place e, const Site<dimension>& k) {
                on.template drift<ValueOf<decltype(stretch)>>(e, k);
            });
    }

    /// Kicks and drifts along a part of a row. The positions of a stretch stay in registers until
    /// the next stretch, which reads them last, has been kicked.
    void kick_and_drift(Part part) const {
        const SiteSweeps on = *this;
        if constexpr (System::reach[dimension - 1] <= width) {
            if (part.count >= width) {
                Values<Wide> last;
                on.kick_and_drift(part, last);
                for (part.skip(width); part.count >= width; part.skip(width)) {
                    Values<Wide> next;
                    on.kick_and_drift(part, next);
                    store(last, on.count_, on.x_.q + part.at - width);
                    for (std::size_t c = 0; c < components; ++c) { last[c] = next[c]; }
                }
                kick(part);
                store(last, count_, x_.q + part.at - width);
                drift(part);
                return;
            }
        }
        kick(part);
        drift(part);
    }

    HVI_INLINE_IN_LANES void kick_and_drift(const Part& part, Values<Wide>& q) const {
        Values<Wide> p;
        load(x_.q + part.at, count_, q);
        kick(part.at, part.k, p);
        move_positions(part.at, part.k, p, q);
    }

    const System& system_;
    const SiteChunks<System>& chunks_;
    Place count_;
    SiteState<Scalar, Sums> x_;
    MoveFactors<Scalar> kicks_, drifts_;
};

}  // namespace hvi::detail
