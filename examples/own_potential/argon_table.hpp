// The energy of two argon atoms as a table.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

/// In units of the depth of the well, at 0.90, 0.92, 0.94, ... diameters of an atom. NOTE: computed
/// by 4 (r^-12 - r^-6), so that the example can check what becomes of it.
inline constexpr std::array<double, 36> argon_table{
    6.6361190,  4.2826324,  2.6065726,  1.4182389,  0.5819049,  0.0000000,  -0.3979128, -0.6628699,
    -0.8319647, -0.9322235, -0.9833724, -0.9998241, -0.9921098, -0.9679176, -0.9328481, -0.8909653,
    -0.8452019, -0.7976564, -0.7498120, -0.7026995, -0.6570169, -0.6132184, -0.5715810, -0.5322530,
    -0.4952910, -0.4606869, -0.4283876, -0.3983102, -0.3703523, -0.3444008, -0.3203366, -0.2980396,
    -0.2773910, -0.2582756, -0.2405828, -0.2242077,
};
