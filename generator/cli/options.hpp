// The requests of the command line, as plain data.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "generator/cli/command_line.hpp"
#include "generator/cli/output_times.hpp"
#include "generator/options/choices.hpp"
#include "generator/options/wishes.hpp"

namespace hvi::gen {

/// METHOD, as text: exactly one of `name`, `file`, and `basis` with `nodes` and perhaps `weights`.
struct MethodOptions {
    Given name, basis, nodes, weights, file;
    std::vector<Given> parameters;  ///< `w=2`
};

struct TableauOptions {
    using Format = TableauFormat;

    MethodOptions method;
    Format format = Format::text;
    int digits = 50;  ///< digits of `decimal`
    std::optional<std::filesystem::path> output;
};

/// A Hamiltonian, as text: `scene`, or `hamiltonian` with both names or none.
struct SystemOptions {
    Given scene;  ///< a scene's name, or a file
    Given hamiltonian, coordinates, momenta;
    UnrollWish sums = {};                   ///< the choice for sums of a scene
    std::optional<SplitChoice> split = {};  ///< parts of H in place of those of the scene
};

struct CheckOptions {
    using Format = CertificateFormat;

    MethodOptions method;  ///< only its parameters where there is a `tableau`
    std::optional<std::filesystem::path> tableau;  ///< a file in place of a method
    Wish<int> sweeps = {};  ///< counted ones of the steps that are checked; 0: to round-off
    int max_order = 8;
    Format format = Format::text;
    std::optional<SystemOptions> system;  ///< the system whose conserved quantities are checked
    bool symmetries = true;               ///< whether to look for them
    Given plot;                           ///< the file of an SVG of trace/2
    std::optional<std::filesystem::path> output;
};

struct StepperOptions {
    MethodOptions method;                 ///< empty where the scene is to name it
    std::optional<SystemOptions> system;  ///< empty for a class of the user
    StepperWishes wishes;
    std::optional<double> accuracy;  ///< in place of a method
    double budget = 60;              ///< seconds to look for a method
    Given until;                     ///< the end of these runs, in place of the scene's
    bool explain = false;  ///< report on standard error what is solved and what is left out
    std::optional<Wish<Stage>> dump = {};  ///< the record of this stage in place of the header
    std::optional<std::filesystem::path> output;
};

/// Checkpoints of a run.
struct CheckpointOptions {
    Given file;                ///< the file for them; null for none
    std::optional<int> every;  ///< steps between checkpoints
    std::optional<double> minutes;
    Given resume;  ///< the file of the checkpoint to resume from

    [[nodiscard]] bool any() const { return file || resume; }
};

struct RunOptions {
    MethodOptions method;              ///< empty where the scene is to name it
    SystemOptions system;              ///< a scene
    StepperWishes wishes;              ///< solver, lanes and composition alone
    std::optional<double> accuracy;    ///< in place of a method and a step
    double budget = 60;                ///< seconds to look for method and step
    Given step, until;                 ///< in place of the scene's
    std::optional<OutputTimes> times;  ///< times of rows of the table
    std::optional<int> every;          ///< steps between rows
    TableFormat format = TableFormat::csv;
    TableNumbers numbers = TableNumbers::doubles;
    Given columns;                   ///< columns of the table, in place of the usual ones
    Given reduce;                    ///< functions of columns, over all steps
    bool symmetries = true;          ///< whether to look for them
    std::optional<Place> interpret;  ///< without a compiler
    CheckpointOptions checkpoints;
    bool tangent = false;         ///< the derivative of the flow
    Given sensitivity = nullptr;  ///< parameters that the end is differentiated by
    std::optional<Exponents> lyapunov;
    bool megno = false, sali = false;
    bool shadow = false;  ///< the modified Hamiltonian
    Given frequencies;    ///< columns to be analysed
    std::set<RunFile> files;
    std::optional<std::filesystem::path> output;  ///< a directory
};

/// The launcher of a study's workers.
enum class Launcher { processes, slurm, mpi };

struct EnsembleOptions {
    MethodOptions method;  ///< empty where the scene is to name it
    SystemOptions system;  ///< a scene
    StepperWishes wishes;  ///< solver, sums and composition alone
    Given step, until;     ///< in place of the scene's
    Given columns;         ///< columns at the end, beside the state
    Given reduce;          ///< functions of columns, over all steps
    bool megno = false;
    Given initial;                   ///< a file of starts and parameters
    std::vector<Given> vary;         ///< `a=0:1:11`
    std::vector<Given> random;       ///< `x=normal(0, 1e-3)`
    int samples = 1, seed = 1;       ///< of random values
    std::optional<int> chunk;        ///< rows that a worker takes at once
    std::optional<Place> interpret;  ///< without a compiler
    std::optional<Place> cuda;       ///< on a GPU
    Launcher launcher = Launcher::processes;
    std::optional<int> workers;                   ///< processes of this machine, or tasks of Slurm
    Given map;                                    ///< columns of a picture
    std::optional<std::filesystem::path> output;  ///< a directory
    std::vector<std::string> words;               ///< the words of the command line
};

struct CollectOptions {
    std::filesystem::path study;                  ///< its directory
    std::optional<std::filesystem::path> output;  ///< a file
};

struct ModuleOptions {
    MethodOptions method;  ///< empty where the scene is to name it
    SystemOptions system;  ///< a scene
    StepperWishes wishes;  ///< solver, lanes, sums and composition alone
    Given name;            ///< the prefix of functions and files, in place of the scene's name
    Language language = Language::c;
    std::filesystem::path output = ".";  ///< a directory
};

struct ReportOptions {
    std::vector<Given> scenes;   ///< names or files
    MethodOptions method;        ///< empty where `methods` are all
    Given methods;               ///< names between commas
    Given steps;                 ///< sizes between commas; chosen where there are none
    Given until;                 ///< the end, in place of the scenes'
    std::optional<Place> peers;  ///< the option that asks for integrators of other libraries too
    std::optional<Place> edges;  ///< the option that asks for some of these items by name
    UnrollWish sums = {};        ///< the choice for sums of the scenes
    bool symmetries = true;      ///< whether to look for them
    int sweeps = 0;              ///< counted ones of methods that are measured with these too
    std::set<ReportItem> items;  ///< work only where there are scenes
    std::optional<std::filesystem::path> output;  ///< a directory
};

struct SchemeOptions {
    using Format = EquationsFormat;

    MethodOptions method;  ///< its parameters are those of the Hamiltonian as well
    SystemOptions system;
    bool generating = false;    ///< print the generating function of type II too
    bool lagrangian = false;    ///< the equations (4.14) in place of (4.18)
    std::optional<int> series;  ///< terms of the discrete Hamiltonians to print
    Format format = Format::text;
    std::optional<std::filesystem::path> output;
};

struct SymmetriesOptions {
    using Format = CertificateFormat;

    SystemOptions system;
    std::vector<Given> parameters;  ///< `mu=2`
    Format format = Format::text;
    std::optional<std::filesystem::path> output;
};

struct ShowOptions {
    Given scene;  ///< a scene's name, or a file
    std::optional<std::filesystem::path> output;
};

struct ListOptions {
    Topic topic = Topic::all;
    std::optional<SystemOptions> system;  ///< the scene of Topic::splits
};

/// The request about compiled programs in the cache.
struct CacheOptions {
    bool clear = false;  ///< remove them
};

/// The request for a script that completes words in a shell.
struct CompletionsOptions {
    Shell shell;
    std::optional<std::filesystem::path> output;
};

struct ManualOptions {
    std::optional<std::filesystem::path> output;
};

/// `--help` or `--version`: the text to print.
struct Information {
    std::string text;
};

using Request = std::variant<TableauOptions, CheckOptions, StepperOptions, SchemeOptions,
                             RunOptions, EnsembleOptions, CollectOptions, ModuleOptions,
                             ReportOptions, SymmetriesOptions, ShowOptions, ListOptions,
                             CacheOptions, CompletionsOptions, ManualOptions, Information>;

/// Reads the command line. Throws InputError with a caret in it, or in the value at fault.
[[nodiscard]] Request parse(const CommandLine& line);

}  // namespace hvi::gen
