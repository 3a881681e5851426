// Whether the energy drifts over very many steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/edges/edges.hpp"
#include "generator/edges/program.hpp"
#include "generator/support/bar.hpp"

namespace hvi::gen {

namespace {

constexpr double most = 0.75;  // between 1/2 of a random walk and 1 of a drift
constexpr std::size_t longest_windows = 7;

/// Runs from several states of a scene.
struct LongRun {
    std::string scene;
    Solver solver;
    long steps;
    double h;
    std::size_t starts;
};

/// Of n steps, the root of the mean square, over the runs, of the change of the mean energy.
using Shifts = std::vector<std::pair<double, double>>;

/// The start of run i, a little away from that of the scene.
std::vector<double> moved(std::vector<double> start, std::size_t i) {
    for (double& x : start) x *= 1 + 0.01 * static_cast<double>(i);
    return start;
}

/// The slope of log y over log x in the longest windows, by least squares.
double exponent(const Shifts& all) {
    const Shifts shifts(all.end() - static_cast<std::ptrdiff_t>(longest_windows), all.end());
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(shifts.size());
    for (const auto& [steps, shift] : shifts) {
        const double u = std::log(steps), v = std::log(shift);
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

/// Empty, and why in `failure`, where one of them stops early.
Shifts shifts(const EdgeProgram& program, const LongRun& run, std::string& failure) {
    const std::vector<double> start = program.ask({"start"}).answers.numbers("start");
    Shifts result;
    for (std::size_t i = 0; i < run.starts; ++i) {
        const Heard heard = program.ask("energy", run.h, run.steps, moved(start, i));
        failure = heard.failure;
        if (failure.empty() && heard.answers.text("status") != "ok")
            failure = heard.answers.text("status");
        if (!failure.empty()) return {};
        const auto windows = heard.answers.numbers("window"),
                   shift = heard.answers.numbers("shift");
        result.resize(windows.size());
        for (std::size_t k = 0; k < windows.size(); ++k) {
            result[k].first = windows[k];
            result[k].second += shift[k] * shift[k];
        }
    }
    for (auto& [steps, sum] : result) sum = std::sqrt(sum / static_cast<double>(run.starts));
    return result;
}

/// Without what was not there at all.
Shifts above_zero(const Shifts& shifts) {
    Shifts result;
    for (const auto& point : shifts)
        if (point.second > 0) result.push_back(point);
    return result;
}

EdgeCheck check(const std::string& method, const LongRun& run, const Shifts& all,
                const std::string& failure) {
    const std::string form = run.solver == Solver::automatic ? "" : ", iterated";
    EdgeCheck check{method,
                    run.scene,
                    fmt::format("{} runs of {} steps of {}{}", run.starts, run.steps, run.h, form),
                    fmt::format("an exponent below {}", most),
                    failure,
                    false};
    if (!failure.empty()) return check;
    const Shifts shifts = above_zero(all);
    if (shifts.size() < longest_windows) {
        check.seen = "the energy does not move";
        check.agrees = true;
        return check;
    }
    const double slope = exponent(shifts);
    check.seen = fmt::format("{:.2f}; at the end {:.1e}", slope, shifts.back().second);
    check.agrees = slope < most;
    return check;
}

}  // namespace

EdgeChapter long_runs(const Compiler& compiler, const std::vector<Method>& methods) {
    const std::vector<LongRun> runs{
        {"harmonic-oscillator", Solver::automatic, 1L << 23, 0.125, 8},
        {"harmonic-oscillator", Solver::fixed_point, 1L << 19, 0.125, 8},
        {"kepler", Solver::automatic, 1L << 20, 0.05, 8}};
    EdgeChapter chapter{
        "long",
        "Long runs",
        "In windows of n to 2n steps, how far the mean energy of the second half is from that of "
        "the first. The means are weighted so that the oscillation of the energy, which each "
        "method has and in which a drift would hide, falls out of them where the windows are long; "
        "what remains grows like n^(1/2) in a random walk of rounding errors, and like n in a "
        "drift. The exponent is fitted to the longest windows, over several runs from states that "
        "differ by one per cent; at the end is the last of the values it is fitted to: a drift "
        "that is "
        "still smaller by then is not seen.",
        {},
        {}};
    Bar bar;
    double done = 0;
    const double all = static_cast<double>(methods.size() * runs.size());
    for (const LongRun& run : runs) {
        const bool iterated = run.solver != Solver::automatic;
        CurvesPicture picture{run.scene + (iterated ? ", iterated" : ""),
                              "steps n",
                              "change of the mean energy",
                              true,
                              true,
                              {}};
        for (const Method& method : methods) {
            bar.show(done++ / all, "long runs: " + run.scene);
            const EdgeProgram program(compiler, method, edge_scene(run.scene), run.solver);
            const std::string name = method.name;
            if (iterated && program.is_explicit()) continue;
            std::string failure;
            const Shifts found = shifts(program, run, failure);
            chapter.checks.push_back(check(name, run, found, failure));
            picture.curves.push_back({name, above_zero(found)});
        }
        chapter.pictures.push_back(std::move(picture));
    }
    return chapter;
}

}  // namespace hvi::gen
