// The stage equations of a step with rotations, as the solvers of the runtime take them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <tuple>

#include <hvi/detail/groups/chart_stages.hpp>

namespace hvi::detail {

/// Equations of all stages of a System, which offers gradient(q, p, dHdq, dHdp) and, for Newton's
/// method, d2Hdq2, d2Hdqdp and d2Hdp2. Derivatives by rotations are by turns of the body. `Clocks`:
/// the clock whose times these functions take behind q and p, or none.
template <class System, class AllStages, class... Clocks>
class CoupledCharts {
public:
    using Stages = AllStages;
    using Table = typename Stages::Scalar[Stages::count][Stages::count];

    Stages& s;
    const Table& m;
    const Table& mt;

    static constexpr bool separable = false;
    static constexpr bool has_q = true;
    static constexpr bool has_p = true;

    CoupledCharts(const System& system, Stages& stages, const Table& table_m, const Table& table_mt,
                  const Clocks&... clocks)
        : s(stages), m(table_m), mt(table_mt), system_(system), clocks_(clocks...) {}

    void momenta() {
        s.balance(s.turns());
        s.momenta(m, mt);
    }
    void positions() { s.positions(m); }
    void slopes() {
        s.slopes([&](std::size_t i, const auto& q, const auto& p, auto& dHdq, auto& dHdp) {
            with_time(i, [&](const auto&... t) { system_.gradient(q, p, t..., dHdq, dHdp); });
        });
    }

    /// Sets all slopes to zero.
    void begin_without_slopes() { s.begin_without_slopes(m, mt); }
    /// Moves the stages by the slopes, and by pi_1 as it is.
    void move() {
        s.momenta(m, mt);
        s.positions(m);
    }

    void nudge(const typename Stages::Scalar& factor) { s.nudge(factor); }

    /// Adds second derivatives at stage i to matrices of zeros.
    template <class Matrix>
    void second_derivatives(std::size_t i, Matrix& Hqq, Matrix& Hqp, Matrix& Hpp) const {
        const auto& q = s.position(i);
        const auto& p = s.slopes_of_stage(i).momentum;
        with_time(i, [&](const auto&... t) {
            system_.d2Hdq2(q, p, t..., Hqq);
            system_.d2Hdqdp(q, p, t..., Hqp);
            system_.d2Hdp2(q, p, t..., Hpp);
        });
    }

    [[nodiscard]] auto size_q(std::size_t k) const { return s.size_q(k); }
    [[nodiscard]] auto size_p(std::size_t k) const { return s.size_p(k); }

protected:
    /// Calls f with the clock, or without it where there is none.
    template <class F>
    [[gnu::always_inline]] void with_clock(F f) const {
        std::apply(f, clocks_);
    }

    const System& system_;

private:
    /// Calls f with the time of stage i, or without it where there is no clock.
    template <class F>
    void with_time(std::size_t i, F f) const {
        std::apply([&]([[maybe_unused]] const auto&... clocks) { f(clocks.t[i]...); }, clocks_);
    }

    std::tuple<const Clocks&...> clocks_;
};

}  // namespace hvi::detail
