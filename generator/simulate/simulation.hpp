// Runs of a scene: compiled, and started as a program of its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/drive/frequencies.hpp"
#include "generator/drive/trajectory.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/pipeline/stepper.hpp"
#include "generator/program/builds.hpp"
#include "generator/program/cache.hpp"
#include "generator/read/table_columns.hpp"
#include "generator/scene/step_count.hpp"
#include "generator/simulate/answers.hpp"

namespace hvi::gen {

/// A quantity that the exact motion conserves, over a run.
struct Conserved {
    std::string name;  ///< `energy`, or an invariant's name
    double start = 0;
    double largest = 0;  ///< the largest departure from the start; NaN or infinite where it is lost
    double last = 0;     ///< the departure at the end, with its sign
    double drift = 0;    ///< the slope of the departures over the run, by least squares, a step
};

/// The status of a run that an interruption has stopped.
inline constexpr const char* interrupted_run = "interrupted";

/// The terms of a column of a run; none where it could not be analysed.
struct ColumnFrequencies {
    std::string name;
    std::vector<FrequencyTerm> terms;
};

/// The outcome of a run.
struct Simulation {
    std::string status;            ///< `ok`, or why it stopped early
    std::int64_t steps = 0;        ///< steps that were taken
    std::int64_t rows = 0;         ///< rows of the first table, without the names
    std::int64_t iterations = 0;   ///< iterations of the solver
    std::int64_t evaluations = 0;  ///< evaluations of dH/dq
    double seconds_of_step = 0;    ///< without observers; 0 where no step was taken
    double t = 0;                  ///< the time at the end
    double rest = 0;               ///< the short step to the event or scaled time that ended it
    std::vector<Conserved> conserved;
    double energy_of_motion = 0;  ///< mean size of H(q, p) - H(q, 0); 0 where it is not known
    std::vector<std::int64_t> events = {};  ///< the number of occurrences of each
    std::string unfit = {};                 ///< a variable that starts with no finite number

    std::vector<double> reduced = {};  ///< reductions in the wished order

    std::optional<std::string> stopped_by = {};  ///< the event that ended the run
    std::vector<ColumnFrequencies> frequencies = {};

    [[nodiscard]] bool ok() const { return status == "ok"; }
};

/// A module that is being compiled, and its data.
struct ModuleBuild {
    Build build;
    Library library;  ///< lacks its file yet

    /// Throws as the Build does.
    [[nodiscard]] Target target() const {
        Library whole = library;
        whole.file = built(build);
        return whole;
    }

    /// Begins to compile the solvers that its steps seldom call, and waits for everything: for runs
    /// that are timed. Throws as target() does.
    void begin_all() const {
        if (library.solvers) library.solvers->begin();
    }
    void wait_for_all() const {
        static_cast<void>(built(build));
        if (library.solvers) library.solvers->compile();
    }
};

/// A module for a scene and a method as text, and its data.
struct SimulationProgram {
    ProgramText text;
    std::optional<ProgramText> solvers;  ///< solvers that its steps seldom call
    Library library;                     ///< lacks its file yet

    /// Begins to compile. Throws as Builds do. Precondition: `builds` lives longer.
    [[nodiscard]] ModuleBuild order(Builds& builds) const;
};

/// The subject of a run, for any kind of stepper.
struct RunSubject {
    std::string scene, description;
    std::string method;  ///< its name; may be empty
    std::string title;   ///< the name, or METHOD
    char function_letter = 'H';
    std::vector<NameBox> coordinates, momenta;  ///< time and its momentum are left out
    std::vector<std::string> conserved;         ///< the energy, where H has no time, and invariants
    WholeNumbers sizes;
};

/// Returns the subject of a stepper's runs. Precondition: the stepper is made as
/// simulation_wishes() ask. Throws InputError where a parameter of the method is left without a
/// value.
[[nodiscard]] RunSubject run_subject(const SceneStepper& stepper);

/// Returns the names of conserved quantities: the energy, where H does not depend on time, and
/// invariants.
[[nodiscard]] std::vector<std::string> conserved_names(const System& system);

/// Returns the possible columns of a run's table: coordinates, momenta, and conserved quantities.
[[nodiscard]] std::vector<NameBox> column_names(const RunSubject& subject);

/// Makes a program of a template with the hole `header` and these other holes. It includes the
/// header of a stepper, and with it headers of the user.
[[nodiscard]] ProgramText program_around(const SceneStepper& stepper, std::string_view main,
                                         const Holes& holes,
                                         const std::vector<std::string>& libraries = {});

/// Returns the wishes for steppers of simulations.
[[nodiscard]] StepperWishes simulation_wishes(Solver solver,
                                              std::optional<Composition> composition = {});

/// Returns the program that run_simulation() starts. Precondition: `stepper` is made as wished for,
/// and checked.
[[nodiscard]] SimulationProgram simulation_program(const SceneStepper& stepper);

/// The use of a scene by a compiled program.
struct Driver {
    std::string header;                       ///< a header of src/driver that defines `main`
    std::string main;                         ///< the name of a function below hvi::driver
    std::vector<std::string> libraries = {};  ///< libraries to link
};

/// Returns the program of another driver around the stepper.
[[nodiscard]] ProgramText driver_program(const SceneStepper& stepper, const Driver& driver);

/// Returns the program of find_reference(). Its numbers are the widest that exist, or, with
/// functions of the user's own, long double. For vectors of any size it is the program of
/// write_reference() and write_start(). Precondition: a `stepper` of arrays is made with float128.
[[nodiscard]] ProgramText reference_program(const SceneStepper& stepper);

/// A solution at its end, with more digits than a double has.
struct ReferenceSolution {
    int bits = 0;               ///< bits of the numbers in which it was computed
    double error = 0;           ///< the relative move of the end when steps were halved
    std::vector<double> state;  ///< coordinates, then momenta; empty where no run came to the end
};

/// Halves steps, from `count` steps on, until the end moves by no more than `wanted`, or for
/// `seconds`. Throws as ask() does.
[[nodiscard]] ReferenceSolution find_reference(const Target& program, double until,
                                               std::int64_t count, double wanted, double seconds);

/// Facts about a solution whose end is in a file.
struct WrittenReference {
    int bits = 0;
    double error = 0;
};

/// Finds a reference as find_reference() does, but writes its end into `file`, and begins with
/// steps as large as the time asks for. Returns nothing where there is none. Throws as ask() does.
[[nodiscard]] std::optional<WrittenReference> write_reference(const Target& program,
                                                              const std::filesystem::path& file,
                                                              double until, std::int64_t count,
                                                              double wanted, double seconds);

/// Writes the start of the scene into the file. Throws as ask() does.
void write_start(const Target& program, const std::filesystem::path& file);

/// Returns why a run with events ended early; nothing where it did not. Throws EnvironmentError
/// where the named event is none of `events`.
[[nodiscard]] std::string fault_of_event(const Answers& answers,
                                         const std::vector<DrivenEvent>& events);

/// Runs the program, which writes at least one table. `on_progress` gets the finished part of the
/// run. Throws as ask() does.
[[nodiscard]] Simulation run_simulation(const Target& program, const RunSubject& subject,
                                        const TrajectoryWishes& wishes,
                                        const std::function<void(double)>& on_progress);

/// The end of the last good step of a run.
struct EndOfRun {
    std::vector<double> state;     ///< coordinates and momenta
    std::vector<double> velocity;  ///< their derivatives there, to some digits; empty after a last
                                   ///< step to the wished time
};

/// The end of the last good step, relative to a reference that the program has read.
struct DistanceOfEnd {
    double relative = 0;
};

/// The end of a run, and its cost.
struct Measurement {
    std::string status;              ///< the status of a Simulation
    std::int64_t steps = 0;          ///< steps that were taken
    std::int64_t iterations = 0;     ///< iterations of the solver
    std::int64_t evaluations = 0;    ///< evaluations of dH/dq
    std::vector<double> departures;  ///< the largest, for each conserved quantity
    std::vector<double> drifts;      ///< likewise; see Conserved
    std::variant<EndOfRun, DistanceOfEnd> end;
    double seconds = 0;  ///< the median of repetitions; 0 where none was timed
    double spread = 0;   ///< the middle half of these, as a part of the median; NaN for one alone

    [[nodiscard]] bool ok() const { return status == "ok"; }
};

/// Reads a measurement from the output of a driver. Throws EnvironmentError where that is no
/// answer.
[[nodiscard]] Measurement measurement(const Answers& answers);

/// Runs the compiled program once, and again for timing over so many seconds, at least three times;
/// never for 0. Throws as ask() does.
[[nodiscard]] Measurement measure(const Target& program, const Steps& steps, double seconds);

/// Measures a scene of any size. Its end is compared with the reference in a file, at the time
/// `until`.
[[nodiscard]] Measurement measure(const Target& program, const Steps& steps, double seconds,
                                  double until, const std::filesystem::path& reference);

/// Returns the seconds of a step of this size for a scene of any size, measured over at most
/// steps.count steps; 0 where none can be taken. Throws as ask() does.
[[nodiscard]] double pace(const Target& program, const Steps& steps);

/// The largest departures of conserved quantities, in parts of a run.
struct DepartureSamples {
    std::vector<double> times;                    ///< ends of the parts
    std::vector<std::vector<double>> departures;  ///< in each part, of each conserved quantity
};

/// Reads departures from the output of a driver. Throws EnvironmentError where that is no answer.
[[nodiscard]] DepartureSamples departure_samples(const Answers& answers);

/// Samples the departures of a run in equal parts. Throws as ask() does.
[[nodiscard]] DepartureSamples sample_departures(const Target& program, const Steps& steps,
                                                 std::int64_t samples);

}  // namespace hvi::gen
