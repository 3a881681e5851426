// Kepler orbits of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/stages/two_bodies.hpp>

namespace hvi::detail {

/// Changes of orbits of trajectories side by side, each with a time of its own. NOTE: a register
/// has the same orbit of several trajectories, and what is not usual is sought one by one, so that
/// nothing depends on the neighbours.
template <class Number, std::size_t count, std::size_t most>
struct OrbitValues<Lanes<Number, count, most>> {
    using Lane = Lanes<Number, count, most>;

    template <std::size_t n>
    [[nodiscard]] static std::array<Lane, 4 * n> of(const std::array<Lane, 4 * n + 1>& given) {
        const Times times(given[4 * n]);
        std::array<Lane, 4 * n> values;
        for (std::size_t j = 0; j < n; ++j) {
            const Orbits orbits{row(given[j]), row(given[n + j]), row(given[2 * n + j]),
                                row(given[3 * n + j])};
            const Changes changes = changes_of(orbits, times);
            values[j] = changes.f_less_1;
            values[n + j] = changes.g_less_time;
            values[2 * n + j] = changes.f_rate;
            values[3 * n + j] = changes.g_rate_less_1;
        }
        return values;
    }

private:
    using Row = typename Lane::Row;
    static constexpr std::size_t width = register_width<Number, Row::places, most>();
    using Part = typename Register<Number, width>::Type;

    /// Times in units of their own; see TimeUnit.
    struct Times {
        Row unit, time;

        explicit Times(const Lane& of) {
            const Row all = row(of);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const two_bodies::TimeUnit<Number> scale(all[lane]);
                unit.set(lane, scale.unit);
                time.set(lane, scale.time);
            }
        }
    };
    struct PartOfTimes {
        Part unit, time;
    };
    struct Orbits {
        Row r2, rv, v2, mu;
    };
    struct Changes {
        Row f_less_1, g_less_time, f_rate, g_rate_less_1;
    };

    [[nodiscard]] static Row row(const Lane& lanes) {
        Row result;
        lanes.store(result);
        return result;
    }

    [[nodiscard]] static Changes changes_of(const Orbits& orbits, const Times& times) {
        Changes changes;
        for (std::size_t first = 0; first < Row::places; first += width) {
            set_part(changes, first, orbits, times);
        }
        return changes;
    }

    /// Sets the changes in a register. NOTE: in a call, so that the code is the same in each.
    [[gnu::noinline]] static void set_part(Changes& changes, std::size_t first,
                                           const Orbits& orbits, const Times& times) {
        namespace flow = two_bodies;
        const auto part = [first](const Row& all) -> Part {
            return Register<Number, width>::load(all.at + first);
        };
        const PartOfTimes scale{part(times.unit), part(times.time)};
        const auto orbit = flow::unit_orbit<Part>(part(orbits.r2), part(orbits.rv), part(orbits.v2),
                                                  part(orbits.mu), scale.unit);
        typename MaskOf<Part>::type is_found;
        const auto usual = flow::usual_changes<Number>(orbit, scale, is_found);
        const auto put = [first](const Part& values, Row& all) {
            Register<Number, width>::store(values, all.at + first);
        };
        put(usual.f_less_1, changes.f_less_1);
        put(usual.g_less_time, changes.g_less_time);
        put(usual.f_rate, changes.f_rate);
        put(usual.g_rate_less_1, changes.g_rate_less_1);
        if (all(is_found)) { return; }
        for (std::size_t k = first; k < first + width; ++k) {
            if (!flow::is_set(is_found, k - first)) { set_alone(changes, k, orbits, times); }
        }
    }

    /// Sets the changes of an orbit that is not usual.
    [[gnu::noinline]] static void set_alone(Changes& changes, std::size_t k, const Orbits& orbits,
                                            const Times& times) {
        namespace flow = two_bodies;
        flow::TimeUnit<Number> scale(1);
        scale.unit = times.unit.at[k];
        scale.time = times.time.at[k];
        const auto orbit = flow::unit_orbit<Number>(orbits.r2.at[k], orbits.rv.at[k],
                                                    orbits.v2.at[k], orbits.mu.at[k], scale.unit);
        const auto alone = flow::changes_one_by_one(orbit, scale);
        changes.f_less_1.at[k] = alone.f_less_1;
        changes.g_less_time.at[k] = alone.g_less_time;
        changes.f_rate.at[k] = alone.f_rate;
        changes.g_rate_less_1.at[k] = alone.g_rate_less_1;
    }
};

}  // namespace hvi::detail
