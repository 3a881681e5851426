// A chain of soft and stiff springs in steps that are small, and large, against the stiff ones.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "generator/edges/edges.hpp"
#include "generator/edges/sweep.hpp"

namespace hvi::gen {

namespace {

constexpr const char* chain_scene = "fpu";
constexpr double chain_step = 1.0 / 32;  // h; omega = z/h is then exact
constexpr long chain_steps = 256;
constexpr std::size_t springs = 3;

/// Bounds for omega > 9.6. Soft springs have the energy xi^4/4, where xi is their elongation. The
/// energy at the start is at most 2.04; while the energy of a soft spring is at most twice this,
/// |xi| <= 2.01, and the forces of two of them on a stiff spring are at most 2 |xi|^3 < 17. As each
/// x and d is an end of two soft springs, which depend on four coordinates, these add at most 2 4 3
/// xi^2 < 98 to the squares of frequencies.
constexpr double most_force = 17, most_added = 98;

/// A bound of this addition for omega < 9.6: the energy is at most 5.5, then |xi| <= 2.17.
constexpr double most_soft = 114;

/// The largest z at which steps resolve the stiff springs as well as the soft ones.
constexpr double resolved_until = 0.3;

/// One run, from omega d = p = 1 in the first stiff spring, or d = 1 where that is less.
struct Motion : Advance {
    double start = 0;         ///< |(omega d, p)| of the stiff spring that moves
    double largest = 0;       ///< omega |d| or |p| of a stiff spring
    double energy_error = 0;  ///< relative
};

Motion motion(const EdgeProgram& program, double z) {
    const double omega = z / chain_step, d = 1 / std::max(omega, 1.0);
    const Heard heard = program.ask("advance", chain_step, chain_steps,
                                    {1, 0, 0, d, 0, 0, 1, 0, 0, 1, 0, 0}, {omega});
    Motion result{Advance(heard), 0, 0, 0};
    if (!heard.failure.empty()) return result;
    const Answers& answers = heard.answers;
    const std::vector<double> largest = answers.numbers("largest");
    for (std::size_t i = springs; i < 2 * springs; ++i)
        result.largest =
            std::max({result.largest, omega * largest.at(i), largest.at(i + 2 * springs)});
    result.start = std::hypot(omega * d, 1);
    const double energy =
        1 + std::pow(omega * d, 2) / 2 + (std::pow(1 - d, 4) + std::pow(1 + d, 4)) / 4;
    result.energy_error = answers.number("energy_error") / energy;
    return result;
}

enum class FateOfChain {
    resolved,  ///< the energy is nearly conserved
    bounded,   ///< the stiff springs stay within a bound
    growing,   ///< the stiff springs leave every bound
    either,    ///< the theory does not decide
    refused,   ///< fixed points do not contract
};

struct Expected {
    FateOfChain fate;
    bool may_stop;   ///< fixed points contract little
    double measure;  ///< the bound, or the size that is reached
};

/// Returns h times a frequency whose square is omega^2 + added.
double with(double added, double z) { return std::sqrt(z * z + added * chain_step * chain_step); }

/// Whether there is a pole or an end of an interval of stability from z = low to high.
bool changes(const LinearStability& stability, double low, double high) {
    const auto is_between = [&](const Number& z) {
        const double value = z.nearest_double();
        return value > 0 && low <= value && value <= high;
    };
    return std::any_of(stability.poles.begin(), stability.poles.end(), is_between) ||
           std::any_of(stability.stable.begin(), stability.stable.end(), [&](const auto& interval) {
               return is_between(interval.low) || is_between(interval.high);
           });
}

/// Expects the energy to be kept. For methods of order one the modified H differs from H by at most
/// h omega H/2.
Expected by_energy(const KnownOscillator& known, double z) {
    const double fastest = with(most_soft, z);
    if (changes(known.stability, 0, fastest)) return {FateOfChain::either, true, 0};
    return {FateOfChain::resolved, false, fastest};
}

/// Expects the fate of the stiff springs by the linear map, alone and with the possible addition of
/// the soft ones.
Expected by_map(const KnownOscillator& known, double z) {
    const Oscillation alone = oscillation(known, z),
                      half = oscillation(known, with(most_added / 2, z)),
                      all = oscillation(known, with(most_added, z));
    if (changes(known.stability, z, with(most_added, z)) || alone.is_stable != all.is_stable)
        return {FateOfChain::either, true, 0};
    if (alone.is_stable) {
        const double time = static_cast<double>(chain_steps) * chain_step;
        const double pushed = time * response(known.stages, z) * most_force;
        return {FateOfChain::bounded, false, alone.bound * (std::sqrt(2.0) + pushed)};
    }
    // NOTE: half of the digits, as for the oscillator; and up to d = 0.1, where the soft springs
    // have not changed yet.
    const double rate = std::min({alone.growth, half.growth, all.growth});
    const double digits = std::min(20.0, static_cast<double>(chain_steps) * rate / 2);
    return {FateOfChain::growing, true, std::min(std::pow(10, digits), 0.1 * z / chain_step)};
}

/// NOTE: bounds are wider than for the oscillator, whose contraction is equal in every step.
Expected expected(const KnownOscillator& known, const Form& form, double z) {
    Expected result = z <= resolved_until ? by_energy(known, z) : by_map(known, z);
    if (form.solver != Solver::fixed_point) return result;
    if (z * z * known.contraction > 2) return {FateOfChain::refused, false, 0};
    if (std::pow(with(most_added, z), 2) * known.contraction > 0.7) result.may_stop = true;
    return result;
}

bool agrees(const Expected& expected, const Motion& seen) {
    if (!seen.ok() && !seen.is_stopped()) return false;
    if (expected.fate == FateOfChain::refused) return seen.is_refused();
    if (expected.fate == FateOfChain::either) return true;
    if (!seen.ok()) return expected.may_stop;
    if (expected.fate == FateOfChain::resolved) return seen.energy_error <= expected.measure;
    return expected.fate == FateOfChain::bounded ? seen.largest <= expected.measure
                                                 : seen.largest >= expected.measure;
}

std::string text(const Expected& expected) {
    const std::string stop = expected.may_stop ? ", or stopped" : "";
    switch (expected.fate) {
    case FateOfChain::resolved:
        return fmt::format("H off by at most {:.2g}{}", expected.measure, stop);
    case FateOfChain::bounded: return fmt::format("at most {:.3g}{}", expected.measure, stop);
    case FateOfChain::growing: return fmt::format("at least {:.3g}{}", expected.measure, stop);
    case FateOfChain::either: return "anything that ends well";
    case FateOfChain::refused: return "refused, the state untouched";
    }
    return {};
}

std::string text(const Motion& seen) {
    if (!seen.failure.empty()) return seen.failure;
    return fmt::format("{} after {} steps{}, up to {:.3g}, H off by {:.2g}", seen.status,
                       seen.steps, seen.untouched || seen.ok() ? "" : ", the state changed",
                       seen.largest, seen.energy_error);
}

/// Returns the number of points with each expected fate.
std::string text(std::map<FateOfChain, int> tally) {
    return fmt::format("H kept at {}, bounded at {}, growing or stopped at {}, either at {}{}",
                       tally[FateOfChain::resolved], tally[FateOfChain::bounded],
                       tally[FateOfChain::growing], tally[FateOfChain::either],
                       tally[FateOfChain::refused] > 0
                           ? fmt::format(", refused at {}", tally[FateOfChain::refused])
                           : "");
}

EdgeCheck sweep_of_chain(const KnownOscillator& known, const Form& form, Sweeps& sweeps) {
    std::map<FateOfChain, int> tally;
    EdgeCheck check = sweeps.sweep(
        known.method, form.name, fmt::format("{} steps of {}", chain_steps, chain_step),
        [&](double z) {
            const Expected wanted = expected(known, form, z);
            const Motion seen = motion(form.program, z);
            ++tally[wanted.fate];
            return SweepPoint{
                seen.largest / seen.start, seen.ok() ? seen.iterations : 0,
                agrees(wanted, seen) ? "" : fmt::format("not {}: {}", text(wanted), text(seen))};
        });
    check.expected = text(tally);
    return check;
}

}  // namespace

EdgeChapter chain(Builds& builds, const std::vector<ExactMethod>& methods) {
    EdgeChapter chapter{
        "chain",
        "Soft and stiff springs",
        "The chain of Fermi, Pasta, Ulam and Tsingou in steps that resolve its soft springs, over "
        "z = h omega of its stiff ones. Up to z = 0.3 these are resolved too, and the energy has "
        "to stay within h times the largest frequency of its value. Beyond, the stiff springs are "
        "oscillators "
        "on which the soft ones act with a force of at most 17, as long as their energy is not "
        "above twice that at the start: so (omega d, p) is bounded, or grows, as the exact map of "
        "the method for the oscillator says, and by what such a force adds in that time. Where "
        "what the soft springs add to omega^2 makes the map stable or unstable, nothing is "
        "expected but an end. Fixed points may fail where they contract by less than 0.7, and "
        "have to fail where they expand by 2. Growth is that of omega |d| or |p|, cut off at "
        "1e20 in the pictures.",
        {},
        {}};
    Sweeps sweeps(chain_scene, "Soft and stiff springs");
    const auto check = [&](const KnownOscillator& known, const Form& form) {
        chapter.checks.push_back(sweep_of_chain(known, form, sweeps));
    };
    for_each_form(builds, methods, chain_scene, chapter.name, check);
    chapter.pictures = sweeps.pictures();
    return chapter;
}

}  // namespace hvi::gen
