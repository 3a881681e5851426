// Pictures by gnuplot.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace hvi::gen {

/// The SVG that gnuplot makes of a script, a command on each line, which sets neither terminal nor
/// output and may read files in the directory. Width and height are in pixels. Throws
/// EnvironmentError where gnuplot is missing, refuses the script or writes no whole picture, and
/// Interruption.
[[nodiscard]] std::string gnuplot_svg(const std::string& script, int width, int height,
                                      const std::filesystem::path& directory);

/// A text in single quotes, as scripts have it, in which nothing but a quote means something else.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

/// A text in single quotes that is shown as it is, with _ ^ { } @ & ~ \ which would be markup, but
/// for numbers with an exponent, which show a power of ten.
[[nodiscard]] std::string gnuplot_label(const std::string& text);

}  // namespace hvi::gen
