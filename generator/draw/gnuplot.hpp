// Pictures by gnuplot.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hvi::gen {

/// The SVG that gnuplot makes of a script, a command on each line, which sets neither terminal nor
/// output and may read files in the directory. Width and height are in pixels. Throws
/// EnvironmentError where gnuplot is missing, refuses the script or writes no whole picture, and
/// Interruption.
[[nodiscard]] std::string gnuplot_svg(const std::string& script, int width, int height,
                                      const std::filesystem::path& directory);

/// A command that makes an array of numbers, of which `plot NAME using (NAME[$1]):...` reads the
/// k-th. NOTE: gnuplot reads data of its own script only from its standard input or as blocks,
/// which need line ends.
[[nodiscard]] std::string gnuplot_array(const std::string& name,
                                        const std::vector<double>& numbers);

/// Sets at most so many ticks of an axis of x from 0 to `end`, fewer where their numbers are large.
/// NOTE: gnuplot's own numbers would overlap.
[[nodiscard]] std::string gnuplot_ticks(double end, double most = 6);

/// A text in single quotes, as scripts have it, in which nothing but a quote means something else.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

/// A text in single quotes that is shown as it is, with _ ^ { } @ & ~ \ which would be markup, but
/// for numbers with an exponent, which show a power of ten.
[[nodiscard]] std::string gnuplot_label(const std::string& text);

}  // namespace hvi::gen
