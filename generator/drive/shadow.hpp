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
    std::size_t degrees = 0;  ///< of H, whose coordinates and momenta come first

    /// Steps on each side of the place of a measurement. NOTE: with 12 of them differences err by
    /// some 1e-8 (w h)^24 of a motion of the frequency w. With 8, pendulums and orbits at 100
    /// steps a period were off by 1e-11, with 12 by 1e-14; with more nothing changed but the last
    /// digits, which rounding makes of 1e-16/h.
    static constexpr int reach = 12;
    [[nodiscard]] static constexpr std::int64_t fewest_steps() { return 2 * reach; }
};

/// Takes the steps of DrivenProblem, whose states are those of with_homogeneous_extension(), and
/// says the modified Hamiltonian at the first place, its largest change, and its change at the last
/// place; and how large the error of differences is, as those over fewer steps tell. The status of
/// its end is 0 also where a step failed.
[[nodiscard]] int take_shadow(const ShadowWishes& wishes);

}  // namespace hvi::gen
