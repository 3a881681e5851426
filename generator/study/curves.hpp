// Work against error: what methods cost on a scene, and how far off they end.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hvi::gen {

/// One run of a method to the end, in steps of one size or of sizes that it chooses.
struct WorkPoint {
    double h = 0;          ///< the mean of them
    double tolerance = 0;  ///< by which they are chosen; 0 where they are equal
    std::int64_t steps = 0;
    double error = 0;  ///< distance of (q, p) from the reference, relative where that is not 0
    double energy_error = 0;  ///< the largest on the way; NaN where the energy is not conserved
    double drift = 0;         ///< of the energy a step, by least squares; NaN likewise
    double seconds = 0;       ///< the median of repetitions in the fastest round; 0: none was timed
    double spread = 0;  ///< the middle half of these, as a part of the median; NaN of one alone
    std::int64_t evaluations = 0;  ///< of dH/dq
    double iterations = 0;         ///< of the solver, a step
    std::string status;            ///< `ok`, or why the run stopped

    [[nodiscard]] bool ok() const { return status == "ok"; }
    /// Whether the middle half of its run times is wider than a quarter of their median.
    [[nodiscard]] bool is_noisy() const { return seconds > 0 && spread > 0.25; }
};

/// How what is conserved departs, over a run of one step size.
struct Departures {
    double h = 0;
    std::vector<double> times;
    std::vector<double> energy;      ///< the largest between two times; empty where it is not kept
    std::vector<double> invariants;  ///< likewise, the norm of the others' departures
    std::vector<double> largest;     ///< of the energy, where it is kept, and of each invariant
};

/// The verdict on a method and a conserved quantity, and what was measured.
struct KeptQuantity {
    std::string name;
    std::string expression;
    std::string verdict;  ///< `kept`, or what else
    std::string reason;
    double largest = 0;  ///< departure in the run of the departures; NaN where none was measured
};

struct WorkCurve {
    std::string name;               ///< of the method
    int order = 0;                  ///< 0 where it varies
    bool is_peer = false;           ///< of another library
    std::vector<WorkPoint> points;  ///< by rising number of steps, or falling tolerance
    Departures departures;
    std::vector<KeptQuantity> kept = {};
    int sweeps = 0;  ///< counted ones, of explicit steps; 0: there are none
};

/// The state that errors are measured against.
struct Reference {
    std::string kind;           ///< `exact`, of the scene; else the numbers it was computed in
    double error = 0;           ///< of itself, as an estimate; 0 for exact
    std::vector<double> state;  ///< coordinates, then momenta, at the end; empty of scenes of any
                                ///< size, whose programs compare the ends of their runs themselves
};

struct SceneReport {
    std::string name;
    std::string description;
    double until = 0;
    Reference reference;
    std::vector<WorkCurve> curves;
};

}  // namespace hvi::gen
