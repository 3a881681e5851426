// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/gnuplot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <string_view>

#include "generator/support/child.hpp"
#include "generator/support/error.hpp"
#include "generator/support/powers.hpp"
#include "generator/support/progress.hpp"
#include "generator/support/ticks.hpp"

namespace hvi::gen {

namespace {

constexpr const char* help_on_gnuplot =
    "install gnuplot (of Debian gnuplot-nox is enough), or leave the pictures out with --only";

/// The words that start gnuplot with a script. NOTE: each command is an argument, as one argument
/// of all could be longer than Linux allows.
std::vector<std::string> words_for(const std::string& script) {
    std::vector<std::string> words{"gnuplot", "-d"};
    std::istringstream commands(script);
    for (std::string command; std::getline(commands, command);) {
        if (command.empty()) continue;
        words.emplace_back("-e");
        words.push_back(command);
    }
    return words;
}

/// A text in which nothing is markup.
std::string without_markup(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) plain += '\\';
        plain += c;
    }
    return plain;
}

std::string power(const PowerOfTen& number) {
    return fmt::format("{}10^{{{}}}", number.factor.empty() ? "" : number.factor + "\u00d7",
                       number.exponent);
}

}  // namespace

std::string gnuplot_svg(const std::string& script, int width, int height,
                        const std::filesystem::path& directory) {
    const Progress::Stage stage("drawing");
    const std::string terminal =
        fmt::format("set terminal svg size {},{} dynamic font 'sans-serif,14' background 'white'\n"
                    "set encoding utf8\n",
                    width, height);
    ChildResult drawn;
    try {
        drawn = run_child(words_for(terminal + script), directory);
    } catch (const EnvironmentError& error) {
        throw EnvironmentError(error.what(), help_on_gnuplot);
    }
    if (!drawn.ok()) throw EnvironmentError("gnuplot failed: " + drawn.errors, help_on_gnuplot);
    if (drawn.output.find("</svg>") == std::string::npos)
        throw EnvironmentError("gnuplot wrote no whole picture" +
                                   (drawn.errors.empty() ? "" : ": " + drawn.errors),
                               help_on_gnuplot);
    return std::move(drawn.output);
}

std::string gnuplot_array(const std::string& name, const std::vector<double>& numbers) {
    std::string list;
    for (const double number : numbers)
        list += fmt::format("{}{:.6g}", list.empty() ? "" : ",", number);
    return fmt::format("array {}[{}] = [{}]\n", name, numbers.size(), list);
}

std::string gnuplot_ticks(double end, double most) {
    constexpr double shortest = 1e-300, wide = 1e4;
    const double length = std::abs(end);
    if (length >= wide) most *= 2.0 / 3;
    return "set xtics " +
           (length < shortest ? "autofreq"
                              : fmt::format("{:.1g}", distance_of_ticks(length, most))) +
           "\n";
}

std::string gnuplot_quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
    return quoted + "'";
}

std::string gnuplot_label(const std::string& text) {
    return gnuplot_quoted(with_powers(text, without_markup, power));
}

}  // namespace hvi::gen
