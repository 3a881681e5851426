// Runs to a time of scenes whose steps alone do not lead there: with jumps, kinks, scaled time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/drive/eventful_run.hpp"
#include "generator/pipeline/lowered.hpp"
#include "generator/program/builds.hpp"
#include "generator/read/scene.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/study/contender.hpp"
#include "generator/study/work.hpp"

namespace hvi::gen {

/// Whether its time is scaled, an event of it jumps, or kinks end its steps.
[[nodiscard]] bool is_eventful(const Scene& scene);

/// Runs of such a scene until a time. Events that do not jump are left out, and none stops a run.
class EventfulRuns {
public:
    /// Throws as driven_events() does. Precondition: sums are written out.
    EventfulRuns(const LoweredScene& scene, double until);

    /// A run in steps of this size, of which scaled time takes so many at most.
    [[nodiscard]] Measurement measured(const Contender& contender, double h, double seconds,
                                       std::int64_t most = most_steps) const;

    /// The departures along the same run, in so many parts.
    [[nodiscard]] DepartureSamples departures(const Contender& contender, double h,
                                              std::int64_t parts) const;

    [[nodiscard]] StepVariable variable() const {
        return clock_ ? StepVariable::scaled_time : StepVariable::time;
    }

    /// The length of a run in what steps are of: the time, or scaled time to some per cent, as runs
    /// in steps of this size tell, or in smaller ones. These take so many seconds. Throws MathError
    /// where none comes to the end.
    [[nodiscard]] double length(const Contender& gauss_10, double h, double seconds) const;

    /// The state at the end: the exact one of the scene, or by gauss:10 in double. Of the last,
    /// steps are halved until the end moves by no more than `wanted` or by rounding, or for so many
    /// seconds; the scene's own are length / first_count. Throws MathError where no run comes to
    /// the end.
    [[nodiscard]] Reference reference(const Contender& gauss_10, double length,
                                      std::int64_t first_count, double wanted = 0,
                                      double seconds = 20) const;

private:
    static constexpr std::int64_t most_steps = 1'000'000'000;

    [[nodiscard]] EventfulRunWishes wishes(double h, std::int64_t most) const;

    Scene scene_;
    double until_;
    std::vector<DrivenEvent> events_;
    std::optional<ScaledClock> clock_;
};

/// The method that references are by.
[[nodiscard]] Contender eventful_reference_contender(Builds& builds, const LoweredScene& scene);

}  // namespace hvi::gen
