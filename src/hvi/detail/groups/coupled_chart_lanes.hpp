// The stage equations of a step with rotations whose stages are lanes.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/groups/chart_lanes.hpp>
#include <hvi/detail/groups/coupled_charts.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>

namespace hvi::detail {

/// CoupledCharts of stages side by side: one evaluation of the gradient serves all of them.
template <class System, class AllStages, class... Clocks>
class CoupledChartLanes : public CoupledCharts<System, AllStages, Clocks...> {
    using Base = CoupledCharts<System, AllStages, Clocks...>;

public:
    using typename Base::Stages;
    using Lane = typename Stages::Lane;
    using Base::s;

    const typename Stages::Table& lanes;

    CoupledChartLanes(const System& system, Stages& stages, const typename Base::Table& table_m,
                      const typename Base::Table& table_mt,
                      const typename Stages::Table& table_of_lanes, const Clocks&... clocks)
        : Base(system, stages, table_m, table_mt, clocks...), lanes(table_of_lanes) {}

    [[gnu::always_inline]] void momenta() {
        s.balance(s.turns());
        s.momenta(lanes);
    }
    [[gnu::always_inline]] void positions() { s.positions(lanes); }
    [[gnu::always_inline]] void slopes() {
        s.slopes([&](const auto& q, const auto& p, auto& dHdq, auto& dHdp)
                     __attribute__((always_inline)) {
                         this->with_clock([&](const auto&... clock) __attribute__((always_inline)) {
                             this->system_.gradient(q, p, Lane(lane_row(clock.t))..., dHdq, dHdp);
                         });
                     });
    }

    void begin_without_slopes() { s.begin_without_slopes(lanes); }
    void move() {
        s.momenta(lanes);
        s.positions(lanes);
    }
};

}  // namespace hvi::detail
