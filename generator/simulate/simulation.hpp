// A scene that is run: compiled, and started as a program of its own.
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

/// A quantity that the exact motion keeps, over a run.
struct Conserved {
    std::string name;  ///< `energy`, or that of an invariant
    double start = 0;
    double largest = 0;  ///< the largest departure from the start; NaN or infinite where it is lost
    double last = 0;     ///< the departure at the end, with its sign
};

/// The status of a run that an interruption has stopped.
inline constexpr const char* interrupted_run = "interrupted";

/// The terms that a column of a run is made of: none where it could not be analysed.
struct ColumnFrequencies {
    std::string name;
    std::vector<FrequencyTerm> terms;
};

/// What became of a run.
struct Simulation {
    std::string status;            ///< `ok`, or why it stopped early
    std::int64_t steps = 0;        ///< taken
    std::int64_t rows = 0;         ///< of the first table, without the names
    std::int64_t iterations = 0;   ///< of the solver
    std::int64_t evaluations = 0;  ///< of dH/dq
    double seconds_of_step = 0;    ///< where nobody looks on; 0 where no step was taken
    double t = 0;                  ///< at the end
    double rest = 0;               ///< the short step to the event or scaled time that ended it
    std::vector<Conserved> conserved;
    double energy_of_motion = 0;  ///< mean size of H(q, p) - H(q, 0); 0 where it is not known
    std::vector<std::int64_t> events = {};  ///< how many there were of each
    std::string unfit = {};  ///< a variable that begins with no finite number, where that ended it

    std::vector<double> reduced = {};  ///< as wished for, in this order

    std::optional<std::string> stopped_by = {};  ///< the event that has ended it
    std::vector<ColumnFrequencies> frequencies = {};

    [[nodiscard]] bool ok() const { return status == "ok"; }
};

/// A module that is being compiled, and the data that go to it.
struct ModuleBuild {
    Build build;
    Library library;  ///< without its file

    /// Throws what the Build does.
    [[nodiscard]] Target target() const {
        Library whole = library;
        whole.file = built(build);
        return whole;
    }

    /// Begins to compile the solvers that its steps seldom call, and waits for all there is: for
    /// runs that are timed. Throws as above.
    void begin_all() const {
        if (library.solvers) library.solvers->begin();
    }
    void wait_for_all() const {
        static_cast<void>(built(build));
        if (library.solvers) library.solvers->compile();
    }
};

/// A module for a scene and a method as text, and the data that go to it.
struct SimulationProgram {
    ProgramText text;
    std::optional<ProgramText> solvers;  ///< that its steps seldom call
    Library library;                     ///< without its file

    /// Throws as Builds do. Precondition: they live longer.
    [[nodiscard]] ModuleBuild order(Builds& builds) const;
};

/// What a run is of, whatever its stepper looks like.
struct RunSubject {
    std::string scene, description;
    std::string method;  ///< its name; may be empty
    std::string title;   ///< the name, or METHOD
    char function_letter = 'H';
    std::vector<NameBox> coordinates, momenta;  ///< without time and its momentum
    std::vector<std::string> conserved;         ///< the energy, where H has no time, and invariants
    WholeNumbers sizes;
};

/// Precondition: the stepper is made as simulation_wishes() are. Throws InputError where a
/// parameter of the method is left without a value.
[[nodiscard]] RunSubject run_subject(const SceneStepper& stepper);

/// The names of what a run keeps: the energy, where H does not depend on the time, and invariants.
[[nodiscard]] std::vector<std::string> conserved_names(const System& system);

/// What can be a column of the table of a run: coordinates, momenta, and what it keeps.
[[nodiscard]] std::vector<NameBox> column_names(const RunSubject& subject);

/// A program made of a template with the hole `header`, and of these others, that includes the
/// header of a stepper, and with it headers of the user.
[[nodiscard]] ProgramText program_around(const SceneStepper& stepper, std::string_view main,
                                         const Holes& holes,
                                         const std::vector<std::string>& libraries = {});

/// What steppers of simulations are to have.
[[nodiscard]] StepperWishes simulation_wishes(Solver solver,
                                              std::optional<Composition> composition = {});

/// The program that run_simulation() starts. Precondition: `stepper` is made as wished for, and
/// checked.
[[nodiscard]] SimulationProgram simulation_program(const SceneStepper& stepper);

/// What a compiled program does with a scene.
struct Driver {
    std::string header;                       ///< of src/driver, which has
    std::string main;                         ///< this function, below hvi::driver
    std::vector<std::string> libraries = {};  ///< that it is linked with
};

/// The program of another driver around the stepper.
[[nodiscard]] ProgramText driver_program(const SceneStepper& stepper, const Driver& driver);

/// The program of find_reference(), in the widest numbers that there are, or, with functions of the
/// user's own, in long double; of vectors of any size that of write_reference() and write_start().
/// Precondition: of arrays `stepper` is made with float128.
[[nodiscard]] ProgramText reference_program(const SceneStepper& stepper);

/// A solution in more digits than a double has, at its end.
struct ReferenceSolution {
    int bits = 0;               ///< of the numbers it was computed in
    double error = 0;           ///< how far halving the steps moved the end, relatively
    std::vector<double> state;  ///< coordinates, then momenta; empty where no run came to the end
};

/// Halves steps, of which there are so many at first, until the end moves by no more than `wanted`,
/// or for so many seconds. Throws as ask() does.
[[nodiscard]] ReferenceSolution find_reference(const Target& program, double until,
                                               std::int64_t count, double wanted, double seconds);

/// What is known of a solution whose end is in a file.
struct WrittenReference {
    int bits = 0;
    double error = 0;
};

/// As find_reference() does, but that the end is written into a file, where there is one, and that
/// the steps at first are as large as the time asks for. Throws as ask() does.
[[nodiscard]] std::optional<WrittenReference> write_reference(const Target& program,
                                                              const std::filesystem::path& file,
                                                              double until, std::int64_t count,
                                                              double wanted, double seconds);

/// Writes where the scene begins into the file. Throws as ask() does.
void write_start(const Target& program, const std::filesystem::path& file);

/// Why a run with events ended early; nothing where it did not. Throws EnvironmentError where the
/// event that is named is none of these.
[[nodiscard]] std::string fault_of_event(const Answers& answers,
                                         const std::vector<DrivenEvent>& events);

/// Runs it, which writes the tables, at least one. `on_progress` gets the part of it that is done.
/// Throws as ask() does.
[[nodiscard]] Simulation run_simulation(const Target& program, const RunSubject& subject,
                                        const TrajectoryWishes& wishes,
                                        const std::function<void(double)>& on_progress);

/// Where the last good step of a run ended.
struct EndOfRun {
    std::vector<double> state;     ///< coordinates and momenta
    std::vector<double> velocity;  ///< their derivatives there, to some digits; empty where the
                                   ///< last step was made to end at the time that was wished for
};

/// The same, relative to a reference that the program has looked at.
struct DistanceOfEnd {
    double relative = 0;
};

/// Where a run ends and what it costs.
struct Measurement {
    std::string status;              ///< as of a Simulation
    std::int64_t steps = 0;          ///< taken
    std::int64_t iterations = 0;     ///< of the solver
    std::int64_t evaluations = 0;    ///< of dH/dq
    std::vector<double> departures;  ///< the largest, of what is conserved
    std::variant<EndOfRun, DistanceOfEnd> end;
    double seconds = 0;  ///< the median of repetitions; 0 where none was timed
    double spread = 0;   ///< the middle half of these, as a part of the median; NaN of one alone

    [[nodiscard]] bool ok() const { return status == "ok"; }
};

/// As a driver has said it. Throws EnvironmentError where that is no answer.
[[nodiscard]] Measurement measurement(const Answers& answers);

/// Runs the compiled program once, and again for timing over so many seconds, at least three times;
/// never for 0. Throws as ask() does.
[[nodiscard]] Measurement measure(const Target& program, const Steps& steps, double seconds);

/// The same of a scene of any size, whose end is compared with that in a file, of the time `until`.
[[nodiscard]] Measurement measure(const Target& program, const Steps& steps, double seconds,
                                  double until, const std::filesystem::path& reference);

/// Seconds of a step of that size of a scene of any size, over so many steps at most; 0 where none
/// can be taken. Throws as ask() does.
[[nodiscard]] double pace(const Target& program, const Steps& steps);

/// The largest departures of what is conserved, in parts of a run.
struct DepartureSamples {
    std::vector<double> times;                    ///< where the parts end
    std::vector<std::vector<double>> departures;  ///< in each part, of all that is conserved
};

/// As a driver has said them. Throws EnvironmentError where that is no answer.
[[nodiscard]] DepartureSamples departure_samples(const Answers& answers);

/// Ends where the run does. Throws as ask() does.
[[nodiscard]] DepartureSamples sample_departures(const Target& program, const Steps& steps,
                                                 std::int64_t samples);

}  // namespace hvi::gen
