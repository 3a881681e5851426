// Explicit methods on lattices of any size: kicks and drifts, in place.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <hvi/detail/loops/site_chunks.hpp>
#include <hvi/detail/loops/site_copies.hpp>
#include <hvi/detail/loops/site_sums.hpp>
#include <hvi/detail/loops/site_sweeps.hpp>
#include <hvi/detail/loops/sites.hpp>
#include <hvi/detail/loops/team.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// A kick is p -= h weight dU/dq, a drift q += h weight dT/dp.
template <class Scalar>
struct Move {
    enum Kind { kick, drift };
    Kind kind;
    Scalar weight;
};

/// A method for H = T(p) + U(q) on sites, as `System` has it (sites.hpp): the moves of a step, one
/// after the other. Slopes at the same point are evaluated once, and a kick and the drift after it
/// are one sweep over the state. `Sums` is PlainSums or CompensatedSums, whose remainders live
/// within one advance().
///
/// The state has the same bits on any number of threads (0: as many as there are processors). With
/// plain sums the bits also do not depend on how the steps are divided among calls. Only larger
/// lattices use more than one thread. Memory: a copy of q and p; with compensated sums three
/// copies.
template <class System, template <class> class Sums = PlainSums>
class SiteMoves {
public:
    using Scalar = typename System::Scalar;

    explicit SiteMoves(std::vector<Move<Scalar>> moves, unsigned threads = 1)
        : moves_(std::move(moves)), team_(threads) {}

    /// Takes steps of size h. A step that leads to a number that is not finite ends the run, and x
    /// is then the state after the last good step. `Vector` has size(), and its numbers stand in a
    /// row. Throws std::bad_alloc, before anything is done.
    template <class Vector>
    [[nodiscard]] Run advance(const System& system, State<Vector>& x, Scalar h,
                              std::int64_t steps) {
        const SiteChunks<System> chunks(system.sites());
        const Place size = static_cast<Place>(System::components) * chunks.sites().count();
        if (static_cast<Place>(x.q.size()) != size || static_cast<Place>(x.p.size()) != size) {
            return {Status(Status::Code::dimension_mismatch)};
        }
        if (size == 0 || h == 0) { return {Status(), std::max<std::int64_t>(0, steps)}; }
        if (!is_finite(h)) { return {Status(Status::Code::not_finite)}; }
        if (!Sums<Scalar>::are_exact()) { return {Status(Status::Code::unsafe_arithmetic)}; }

        remainders_.assign(2 * Sums<Scalar>::vectors * static_cast<std::size_t>(size), Scalar(0));
        Scalar* remainders = remainders_.data();
        Scalar* of_p = remainders + Sums<Scalar>::vectors * static_cast<std::size_t>(size);
        const SiteState<Scalar, Sums<Scalar>> state{&x.q[0], &x.p[0], Sums<Scalar>(remainders),
                                                    Sums<Scalar>(of_p)};
        std::vector<Scalar*> vectors{state.q, state.p};
        if (!remainders_.empty()) {
            vectors.push_back(remainders);
            vectors.push_back(of_p);
        }
        SiteCopies<Scalar> before(std::move(vectors), System::components, chunks.sites().count(),
                                  copies_);
        return advance(Lattice{system, chunks, state}, before, h, steps);
    }

private:
    /// Number of steps between two looks at the numbers.
    static constexpr std::int64_t block = 256;

    struct Lattice {
        const System& system;
        const SiteChunks<System>& chunks;
        SiteState<Scalar, Sums<Scalar>> x;
    };

    /// NOTE: in sums in place a number that is not finite stays so. So a block of steps has gone
    /// well where its end is finite. A block that has not is taken again, step by step.
    [[nodiscard]] Run advance(const Lattice& lattice, SiteCopies<Scalar>& before, Scalar h,
                              std::int64_t steps) {
        Run run;
        std::int64_t tried = block;
        while (run.steps < steps) {
            tried = std::min(tried, steps - run.steps);
            if (take(lattice, before, h, tried)) {
                run.steps += tried;
                continue;
            }
            before.restore();
            if (tried == 1) {
                run.status = Status(Status::Code::not_finite);
                return run;
            }
            tried = 1;
        }
        return run;
    }

    /// Takes `steps` steps, and returns whether all numbers are finite then. Moves of one kind that
    /// follow one another become one, also across steps. NOTE: what is kept is copied in the first
    /// sweep and looked at in the last, so that steps one by one do not pass over the state for
    /// that.
    [[nodiscard]] bool take(const Lattice& lattice, SiteCopies<Scalar>& before, Scalar h,
                            std::int64_t steps) {
        MoveFactors<Scalar> kicks, drifts;
        bool is_first = true;
        const auto sweep = [&](bool is_last) {
            const bool finite =
                this->sweep(lattice, kicks, drifts, before, Part{is_first, is_last});
            is_first = false;
            kicks = drifts = {};
            return finite;
        };
        for (std::int64_t step = 0; step < steps; ++step) {
            for (const Move<Scalar>& move : moves_) {
                if (move.kind == Move<Scalar>::kick) {
                    if (!drifts.is_empty() || kicks.is_full()) { sweep(false); }
                    kicks.push(-(h * move.weight));
                } else {
                    if (drifts.is_full()) { sweep(false); }
                    drifts.push(h * move.weight);
                }
            }
        }
        return sweep(true);
    }

    /// Part of a sweep in the steps between two looks at the numbers.
    struct Part {
        bool is_first, is_last;
    };

    /// Sweeps over the lattice: kicks, and then drifts. Returns false where a number is looked at
    /// that is not finite.
    bool sweep(const Lattice& lattice, const MoveFactors<Scalar>& kicks,
               const MoveFactors<Scalar>& drifts, SiteCopies<Scalar>& before, Part part) {
        const SiteChunks<System>& chunks = lattice.chunks;
        const SiteSweeps<System, Sums<Scalar>> on(lattice.system, chunks, lattice.x, kicks, drifts);
        std::atomic<bool> all_finite{true};
        const auto keep = [&](Place at, Place sites) { before.keep(at, sites); };
        const auto look = [&](Place at, Place sites) {
            if (!before.finite(at, sites)) { all_finite = false; }
        };
        if (part.is_first) { for_each_outside_of_cores(chunks, keep); }
        if (!kicks.is_empty()) {
            on.kick_edges();
            for_each_seam(chunks, [&](Units seam) { on.kick(seam); });
        }
        team_.run(static_cast<std::size_t>(chunks.count()), [&](std::size_t i) {
            const Units core = chunks.core(static_cast<Place>(i));
            if (part.is_first) { for_each_row(chunks, core, keep); }
            if (drifts.is_empty()) {
                on.kick(core);
            } else if (kicks.is_empty()) {
                on.drift(core);
            } else {
                on.kick_and_drift(core);
            }
            if (part.is_last) { for_each_row(chunks, core, look); }
        });
        if (!drifts.is_empty()) {
            on.drift_edges();
            for_each_seam(chunks, [&](Units seam) { on.drift(seam); });
        }
        if (part.is_last) { for_each_outside_of_cores(chunks, look); }
        return all_finite;
    }

    /// Calls f(at, sites) for each row of sites that the units consist of.
    template <class F>
    static void for_each_row(const SiteChunks<System>& chunks, Units units, F f) {
        chunks.for_each_part(units, [&](const auto& row) { f(row.at, row.count); });
    }

    template <class F>
    void for_each_outside_of_cores(const SiteChunks<System>& chunks, F f) {
        chunks.sites().for_each_edge([&](Place e, const auto&) { f(e, 1); });
        for_each_seam(chunks, [&](Units seam) { for_each_row(chunks, seam, f); });
    }

    /// Calls f for each seam. NOTE: the seams of a chain are a few sites, for which no thread is
    /// called.
    template <class F>
    void for_each_seam(const SiteChunks<System>& chunks, F f) {
        const Place count = chunks.count();
        if constexpr (System::dimension == 1) {
            for (Place i = 1; i < count; ++i) { f(chunks.seam(i)); }
        } else {
            team_.run(static_cast<std::size_t>(count),
                      [&](std::size_t i) { f(chunks.seam(static_cast<Place>(i))); });
        }
    }

    std::vector<Move<Scalar>> moves_;
    Team team_;
    std::vector<Scalar> copies_, remainders_;
};

}  // namespace hvi::detail
