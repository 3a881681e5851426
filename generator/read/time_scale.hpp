// Names of scales of time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// Scales dt/ds that `[time] scale` can name, where s is the variable of the steps.
enum class TimeScale {
    expression,   ///< a function of the variables, the parameters and the time
    logarithmic,  ///< for H = T(p) + U(q), which becomes log(T + e) - log(-U)
    arclength,    ///< 1/sqrt(|H_q|^2 + |H_p|^2)
    potential,    ///< 1/(-U), for H = T(p) + U(q)
    distance,     ///< r^(3/2) of the closest bodies, (sum of r^-3 over pairs)^(-1/2)
};

/// The words that name scales, as text for messages.
inline constexpr const char* names_of_scales = "logarithmic, arclength, potential, distance";

}  // namespace hvi::gen
