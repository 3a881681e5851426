// A picture of linear stability.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/methods/stability.hpp"

namespace hvi::gen {

/// Draws half the trace of the oscillator map over z = h omega in (0, until), with the stable
/// intervals shaded. The SVG document needs no other file and no font but the reader's own. Equal
/// methods give equal bytes. Precondition: no free parameter. NOTE: the program writes this small
/// picture itself, so that `check --plot` works on machines without gnuplot.
[[nodiscard]] std::string stability_svg(const std::string& name, const OscillatorMap& map,
                                        const LinearStability& stability);

}  // namespace hvi::gen
