// Checks that the energy does not drift over very many steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/edges/edges.hpp"
#include "generator/edges/energy_shifts.hpp"
#include "generator/edges/rounded_tableau.hpp"
#include "generator/support/bar.hpp"

namespace hvi::gen {

namespace {

constexpr double most = 0.75;  // between 1/2 of a random walk and 1 of a drift
constexpr std::size_t fewest_windows = 7;

/// A stepper with its run.
struct Runner {
    std::string method;
    LongRun run;
    bool is_iterated;
    EdgeProgram program;
};

/// Returns the slope of log y over log x in the longer two thirds of the windows, by least squares.
double exponent(const std::vector<std::pair<double, double>>& all) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const std::size_t first = all.size() / 3;
    const auto n = static_cast<double>(all.size() - first);
    for (std::size_t i = first; i < all.size(); ++i) {
        const double u = std::log(all[i].first), v = std::log(all[i].second);
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

std::string text(const LongRun& run) {
    return fmt::format("{} runs of {} steps of {}", run.starts, run.steps, run.h);
}

EdgeCheck check(const Runner& runner, const EnergyShifts& found) {
    EdgeCheck check{runner.method,
                    runner.run.scene,
                    text(runner.run) + (runner.is_iterated ? ", iterated" : ""),
                    fmt::format("an exponent below {}", most),
                    found.failure,
                    false};
    if (!found.failure.empty()) return check;
    const auto shifts = above_zero(found);
    if (shifts.size() < fewest_windows) {
        check.seen = "the energy does not move";
        check.agrees = true;
        return check;
    }
    const double slope = exponent(shifts);
    check.seen = fmt::format("{:.2f}; at the end {:.1e}", slope, shifts.back().second);
    check.agrees = slope < most;
    return check;
}

CurvesPicture picture(const std::string& title) {
    return {title, "steps n", "change of the mean energy", true, true, {}};
}

// ---- results without compensation and without corrections ----

constexpr const char* compared_scene = "kepler";

/// The method with the most implicit stages that is no composition, and a naive stepper, written as
/// one would first write it.
struct Comparison {
    std::string method;
    Tableau tableau;
    EdgeProgram program, naive;
};

EdgeCheck compared(const Comparison& comparison, const LongRun& run, const std::string& what,
                   double end, const EnergyShifts& found, CurvesPicture& picture) {
    EdgeCheck check{
        comparison.method,       run.scene,
        text(run) + ", " + what, fmt::format("at the end more than the {:.1e} of the stepper", end),
        found.failure,           false};
    picture.curves.push_back({what, above_zero(found)});
    if (!found.failure.empty()) return check;
    const double other = found.of_windows.back().second;
    check.seen = fmt::format("{:.1e}", other);
    check.agrees = other > end;
    return check;
}

/// NOTE: where rounding each entry keeps b_i a~_ij + b_j a_ji = b_i b_j, rounding does no harm, and
/// nothing is compared. Where h and h b_i have few digits, as for 1/20 and 1/40, rounded products
/// with them are biased themselves.
void compare(const Comparison& comparison, EdgeChapter& chapter) {
    const LongRun run{compared_scene, 1L << 19, 0.0469, 4};
    const RoundedTableau rounded = rounded_entries(comparison.tableau);
    CurvesPicture drawn =
        picture(fmt::format("{}, {}: what it would be without", compared_scene, comparison.method));
    const EnergyShifts whole = energy_shifts(comparison.program, "energy", run);
    if (whole.of_windows.empty()) return;  // NOTE: the check before says why.
    drawn.curves.push_back({"as generated", above_zero(whole)});
    const double end = whole.of_windows.back().second;
    const auto add = [&](const std::string& what, const EnergyShifts& found) {
        chapter.checks.push_back(compared(comparison, run, what, end, found, drawn));
    };
    add("sums not compensated", energy_shifts(comparison.program, "forgetful-energy", run));
    if (!rounded.is_symplectic)
        add("entries rounded one by one",
            energy_shifts(comparison.naive, "energy", run, rounded.words));
    add("entries rounded one by one, sums not compensated",
        energy_shifts(comparison.naive, "forgetful-energy", run, rounded.words));
    chapter.pictures.push_back(std::move(drawn));
}

std::optional<Comparison> comparison(Builds& builds, const std::vector<ExactMethod>& methods) {
    std::optional<Comparison> best;
    const Scene scene = edge_scene(compared_scene);
    for (const ExactMethod& method : methods) {
        if (method.composition) continue;
        const auto* const tableau = std::get_if<Tableau>(&method.base);
        if (tableau == nullptr) continue;
        EdgeProgram program(builds, method, scene);
        if (program.is_explicit() || (best && best->tableau.stages() >= tableau->stages()))
            continue;
        best = Comparison{method.name(), *tableau, program, EdgeProgram::naive(builds, scene)};
    }
    return best;
}

/// Shortens a run of a method of several parts to about as many parts as steps were asked for.
/// NOTE: windows are powers of two.
LongRun shorter(LongRun run, std::size_t parts) {
    for (; parts > 1; parts = (parts + 1) / 2) run.steps /= 2;
    return run;
}

std::vector<Runner> runners(Builds& builds, const std::vector<ExactMethod>& methods,
                            const LongRun& run, Solver solver) {
    std::vector<Runner> result;
    const bool is_iterated = solver != Solver::automatic;
    for (const ExactMethod& method : methods) {
        EdgeProgram program(builds, method, edge_scene(run.scene), solver);
        if (is_iterated && program.is_explicit()) continue;  // there is nothing to iterate
        result.push_back(
            {method.name(), shorter(run, method.parts()), is_iterated, std::move(program)});
    }
    return result;
}

}  // namespace

EdgeChapter long_runs(Builds& builds, const std::vector<ExactMethod>& methods) {
    EdgeChapter chapter{
        "long",
        "Long runs",
        "In windows of n to 2n steps, how far the mean energy of the second half is from that of "
        "the first. The means are weighted so that the oscillation of the energy, which each "
        "method has and in which a drift would hide, falls out of them where the windows are long; "
        "what remains grows like n^(1/2) in a random walk of rounding errors, and like n in a "
        "drift. The exponent is fitted to the longer two thirds of the windows, over several runs "
        "from states that "
        "differ by one per cent; at the end is the last of the values it is fitted to: a drift "
        "that is still smaller by then is not seen. Compositions take fewer steps, as each is "
        "several. At last, what a stepper that is no composition would lose without "
        "compensated sums, and with entries of the tableau that are rounded each for itself, which "
        "breaks b_i a~_ij + b_j a_ji = b_i b_j in the last bits.",
        {},
        {}};
    const std::vector<std::vector<Runner>> kinds{
        runners(builds, methods, {"harmonic-oscillator", 1L << 27, 0.125, 4}, Solver::automatic),
        runners(builds, methods, {"harmonic-oscillator", 1L << 19, 0.125, 8}, Solver::fixed_point),
        runners(builds, methods, {"kepler", 1L << 20, 0.05, 8}, Solver::automatic)};
    const std::optional<Comparison> without = comparison(builds, methods);
    Bar bar;
    double done = 0;
    const double all = static_cast<double>(methods.size() * kinds.size() + 1);
    for (const std::vector<Runner>& kind : kinds) {
        if (kind.empty()) continue;
        CurvesPicture drawn =
            picture(kind.front().run.scene + (kind.front().is_iterated ? ", iterated" : ""));
        for (const Runner& runner : kind) {
            bar.show(done++ / all,
                     fmt::format("long runs: {}, {}", runner.run.scene, runner.method));
            const EnergyShifts found = energy_shifts(runner.program, "energy", runner.run);
            chapter.checks.push_back(check(runner, found));
            drawn.curves.push_back({runner.method, above_zero(found)});
        }
        chapter.pictures.push_back(std::move(drawn));
    }
    if (without) compare(*without, chapter);
    return chapter;
}

}  // namespace hvi::gen
