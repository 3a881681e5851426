// Names of scales of the time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// Which dt/ds `[time] scale` names, where the steps are of s.
enum class TimeScale {
    expression,   ///< one of the variables, the parameters and the time
    logarithmic,  ///< of T(p) + U(q): H becomes log(T + e) - log(-U)
    arclength,    ///< 1/sqrt(|H_q|^2 + |H_p|^2)
    potential,    ///< 1/(-U), of T(p) + U(q)
    distance,     ///< r^(3/2) of the closest bodies, (sum of r^-3 over pairs)^(-1/2)
};

/// The names of scales by a word, as text for messages.
inline constexpr const char* names_of_scales = "logarithmic, arclength, potential, distance";

}  // namespace hvi::gen
