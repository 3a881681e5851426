// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/drive.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <driver/departures.hpp>
#include <driver/guarded.hpp>
#include <driver/large_measure.hpp>
#include <driver/measure.hpp>
#include <driver/trajectory.hpp>

#include "generator/drive/driven_stepper.hpp"
#include "generator/drive/module.hpp"
#include "generator/drive/words.hpp"

namespace hvi::gen {

namespace {

/// The steppers that the process is started for. NOTE: drivers ask a type, not an object.
MakeStepper make_of_process;

/// These as a Problem of src/driver/departure.hpp.
struct DrivenProblem {
    using Stepper = DrivenStepper;

    static Stepper stepper() { return Stepper(make_of_process()); }
    static Stepper::State initial() { return stepper().initial(); }
    static const std::vector<std::string>& invariants() {
        static const std::vector<std::string> names = stepper().conserved();
        return names;
    }
    static void values(const Stepper& stepper, const Stepper::State& x, double* out) {
        stepper.values(x, out);
    }
};

/// The start of a module, and the words after it; empty where these are none.
struct Line {
    ModuleStart start;
    std::vector<std::string_view> command;
};

std::optional<Line> read_line(const std::vector<std::string_view>& words) {
    constexpr std::size_t before_parameters = 4;
    std::int64_t count = 0;
    if (words.size() < before_parameters || !driver::read(words[3], count) || count < 0) return {};
    const std::size_t end = before_parameters + static_cast<std::size_t>(count);
    if (words.size() <= end) return {};
    const std::string solvers(words[1] == no_solvers ? "" : words[1]);
    Line line{{std::string(words[0]), solvers, std::string(words[2]), {}}, {}};
    for (std::size_t k = before_parameters; k < end; ++k)
        if (!driver::read(words[k], line.start.parameters.emplace_back())) return {};
    line.command.assign(words.begin() + static_cast<std::ptrdiff_t>(end), words.end());
    return line;
}

int run(std::string_view command, const std::vector<std::string_view>& words) {
    if (command == "trajectory") return driver::trajectory<DrivenProblem>(words);
    if (command == "measure") return driver::measure<DrivenProblem>(words);
    if (command == "departures") return driver::departures<DrivenProblem>(words);
    return 2;
}

/// Runs a command that looks at invariants where rows are written.
int run_by_rows(std::string_view command, const std::vector<std::string_view>& words) {
    if (command == "trajectory")
        return driver::trajectory<DrivenProblem, driver::Watch::rows>(words);
    if (command == "measure") return driver::large_measure<DrivenProblem>(words);
    if (command == "departures") return driver::large_departures<DrivenProblem>(words);
    if (command == "pace") return driver::large_pace<DrivenProblem>(words);
    return 2;
}

/// Runs work(), which throws as drivers do: its exit status.
template <class Work>
int status_of(Work work) {
    try {
        return driver::guarded(work);
    } catch (const detail::SolverIsApart&) { return solver_is_apart; }
}

int run(std::vector<std::string_view> words) {
    const bool by_rows = words.front() == rows_word;
    if (by_rows) words.erase(words.begin());
    if (words.empty()) return 2;
    const std::string_view command = words.front();
    words.erase(words.begin());
    return by_rows ? run_by_rows(command, words) : run(command, words);
}

}  // namespace

int drive(const std::vector<std::string_view>& words) {
    std::optional<Line> line = read_line(words);
    if (!line) return 2;
    return status_of([&] {
        make_of_process = loaded_module(std::move(line->start));
        return run(line->command);
    });
}

int drive(const MakeStepper& make, const std::vector<std::string_view>& command) {
    return status_of([&] {
        make_of_process = make;
        return run(command);
    });
}

}  // namespace hvi::gen
