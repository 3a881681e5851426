// The modified Hamiltonian of a method along its steps: the shadow of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace hvi::gen {

/// Steps along which the modified Hamiltonian is measured.
struct ShadowWishes {
    double h = 0;
    std::int64_t steps = 0;
    std::size_t degrees = 0;  ///< degrees of freedom of H, whose variables come first

    /// Steps on each side of the place of a measurement. NOTE: with 12 of them differences err by
    /// some 1e-8 (w h)^24 for a motion of frequency w. For pendulums and orbits at 100 steps a
    /// period the error was 1e-11 with 8, and 1e-14 with 12. More steps changed only the last
    /// digits, which rounding of 1e-16/h determines.
    static constexpr int reach = 12;
    [[nodiscard]] static constexpr std::int64_t fewest_steps() { return 2 * reach; }
};

/// Takes the steps of DrivenProblem, whose states are those of with_homogeneous_extension().
/// Reports the modified Hamiltonian at the first place, its largest change, its change at the last
/// place, and the error of differences, estimated by those over fewer steps. Returns the exit
/// status 0 also where a step failed.
[[nodiscard]] int take_shadow(const ShadowWishes& wishes);

}  // namespace hvi::gen
