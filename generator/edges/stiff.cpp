// The harmonic oscillator in steps that are small, and large, against its period.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/edges/edges.hpp"
#include "generator/edges/sweep.hpp"

namespace hvi::gen {

namespace {

constexpr const char* oscillator_scene = "harmonic-oscillator";
constexpr double oscillator_step = 1.0 / 16;  // h; omega = z/h is then exact

/// One run from (omega q, p) = (1, 1/2).
struct Orbit : Advance {
    double growth = 0;  ///< the largest |(omega q, p)| relative to the start, or nearly so
};

Orbit orbit(const EdgeProgram& program, double z, long steps) {
    const double omega = z / oscillator_step;
    const Heard heard = program.ask("advance", oscillator_step, steps, {1 / omega, 0.5}, {omega});
    Orbit result{Advance(heard), 0};
    if (!heard.failure.empty()) return result;
    const std::vector<double> largest = heard.answers.numbers("largest");
    result.growth = std::max(omega * largest.at(0), largest.at(1)) / std::hypot(1, 0.5);
    return result;
}

bool is_bounded(const Orbit& orbit, const Oscillation& expected) {
    constexpr double rounding = 1.001;
    return orbit.ok() && orbit.growth <= rounding * expected.bound;
}

/// Whether an orbit grows. Half of the digits of the growth are asked for, as a part of the start
/// lies along the other eigenvector; and at most 1e100, as numbers that are too large end the run
/// with a status.
bool grows(const Orbit& orbit, const Oscillation& expected, long steps) {
    const double digits = std::min(100.0, static_cast<double>(steps) * expected.growth / 2);
    return orbit.failure.empty() && (orbit.ok() || orbit.untouched) &&
           std::log10(orbit.growth) >= digits;
}

/// The expected fate of an orbit.
enum class FateOfOrbit {
    as_map,   ///< bounded or growing as the exact map is
    either,   ///< the map, or a stop where 200 iterations hardly contract
    refused,  ///< fixed points do not contract
};

FateOfOrbit fate(const KnownOscillator& known, const Form& form, double z) {
    if (form.solver != Solver::fixed_point) return FateOfOrbit::as_map;
    const double factor = z * z * known.contraction;
    return factor < 0.7    ? FateOfOrbit::as_map
           : factor < 1.01 ? FateOfOrbit::either
                           : FateOfOrbit::refused;
}

bool agrees(FateOfOrbit fate, const Orbit& orbit, const Oscillation& expected, long steps) {
    if (fate == FateOfOrbit::refused) return orbit.is_refused();
    if (fate == FateOfOrbit::either && orbit.is_stopped()) return true;
    return expected.is_stable ? is_bounded(orbit, expected) : grows(orbit, expected, steps);
}

std::string text(const Orbit& orbit) {
    if (!orbit.failure.empty()) return orbit.failure;
    const std::string grown =
        fmt::format("grows to {:.3g} times in {} steps", orbit.growth, orbit.steps);
    if (orbit.is_refused()) return orbit.status + ", the state untouched";
    return orbit.ok() ? grown
                      : grown + ", then: " + orbit.status +
                            (orbit.untouched ? "" : ", and the state is changed");
}

std::string text(FateOfOrbit fate, const Oscillation& expected) {
    if (fate == FateOfOrbit::refused) return "refused, the state untouched";
    const std::string map =
        expected.is_stable ? fmt::format("at most {:.3g} times", expected.bound)
                           : fmt::format("10^({:.3g} n) times in n steps, or so", expected.growth);
    return fate == FateOfOrbit::either ? map + ", or stopped" : map;
}

// ---- from 1e-3 to 1e4 ----

/// Numbers of points with each expected fate.
struct Tally {
    int bounded = 0, growing = 0, either = 0, refused = 0;

    void expect(FateOfOrbit fate, const Oscillation& map) {
        ++(fate == FateOfOrbit::refused  ? refused
           : fate == FateOfOrbit::either ? either
           : map.is_stable               ? bounded
                                         : growing);
    }
    [[nodiscard]] std::string text() const {
        std::string text = fmt::format("bounded at {}, growing at {}", bounded, growing);
        if (either > 0) text += fmt::format(", that or stopped at {}", either);
        if (refused > 0) text += fmt::format(", refused at {}", refused);
        return text;
    }
};

EdgeCheck sweep_of_oscillator(const KnownOscillator& known, const Form& form, Sweeps& sweeps) {
    constexpr long steps = 1000;
    Tally tally;
    EdgeCheck check =
        sweeps.sweep(known.method, form.name, fmt::format("{} steps", steps), [&](double z) {
            const Oscillation map = oscillation(known, z);
            const FateOfOrbit expected = fate(known, form, z);
            const Orbit found = orbit(form.program, z, steps);
            tally.expect(expected, map);
            return SweepPoint{found.growth, found.ok() ? found.iterations : 0,
                              agrees(expected, found, map, steps)
                                  ? ""
                                  : fmt::format("not {}: {}", text(expected, map), text(found))};
        });
    check.expected = tally.text();
    return check;
}

// ---- at the ends of the intervals, and at poles ----

EdgeCheck beside(const KnownOscillator& known, const Form& form, double z,
                 const std::string& where) {
    constexpr long steps = 100'000;
    const Oscillation map = oscillation(known, z);
    const FateOfOrbit expected = fate(known, form, z);
    const Orbit found = orbit(form.program, z, steps);
    return {known.method,
            oscillator_scene,
            fmt::format("{}: z = {:.9g}, {}", form.name, z, where),
            text(expected, map),
            text(found),
            agrees(expected, found, map, steps)};
}

EdgeCheck at_pole(const KnownOscillator& known, const Form& form, double z) {
    const Orbit found = orbit(form.program, z, 1);
    return {known.method,
            oscillator_scene,
            fmt::format("{}: z = {:.17g}, the double nearest to a pole", form.name, z),
            "a status and the state untouched, or more than 1e6 times",
            text(found),
            found.is_refused() || (found.ok() && found.growth > 1e6)};
}

std::vector<EdgeCheck> at_ends(const KnownOscillator& known, const Form& form) {
    constexpr double aside = 1e-6;
    const LinearStability& stability = known.stability;
    std::vector<double> ends;
    for (const StabilityInterval& interval : stability.stable)
        for (const Number* end : {&interval.low, &interval.high}) {
            const double z = end->nearest_double();
            if (z > 0 && z < static_cast<double>(stability.until)) ends.push_back(z);
        }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<EdgeCheck> checks;
    for (const double z : ends) {
        const std::string end = fmt::format("the end {:.9g}", z);
        checks.push_back(beside(known, form, z * (1 - aside), "below " + end));
        checks.push_back(beside(known, form, z * (1 + aside), "above " + end));
    }
    for (const Number& pole : stability.poles)
        checks.push_back(at_pole(known, form, pole.nearest_double()));
    return checks;
}

}  // namespace

EdgeChapter stiff(Builds& builds, const std::vector<ExactMethod>& methods) {
    EdgeChapter chapter{
        "stiff",
        "Stiff",
        "The harmonic oscillator over z = h omega, in three forms: as is, which is a matrix "
        "computed "
        "once or explicit; iterated with fixed points; and with Newton's method. The orbit is "
        "bounded or grows as the exact map of the method says: below 20 by the certified intervals "
        "of stability (hvi-gen check), and beyond by half its trace, exactly at this z. How far it "
        "may go where it is stable, and how fast it grows where it is not, follow from that map "
        "too. Fixed points contract where z^2 times the spectral radius of A A~ is less than 1: "
        "they have to converge below 0.7, and to be refused above 1.01; the steps of a composition "
        "are iterated one by one, and the largest decides. Growth is that of "
        "|(omega q, p)|, cut off at 1e20 in the pictures.",
        {},
        {}};
    Sweeps sweeps(oscillator_scene, "Harmonic oscillator");
    const auto check = [&](const KnownOscillator& known, const Form& form) {
        chapter.checks.push_back(sweep_of_oscillator(known, form, sweeps));
        for (EdgeCheck& at_end : at_ends(known, form)) chapter.checks.push_back(std::move(at_end));
    };
    for_each_form(builds, methods, oscillator_scene, chapter.name, check);
    chapter.pictures = sweeps.pictures();
    return chapter;
}

}  // namespace hvi::gen
