// The output of a driver: see src/driver/answer.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "generator/drive/balance.hpp"
#include "generator/drive/eventful_run.hpp"
#include "generator/drive/number_stepper.hpp"
#include "generator/drive/shadow.hpp"
#include "generator/drive/tangents.hpp"
#include "generator/drive/trajectory.hpp"
#include "generator/program/builds.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Keys with their values in the order of the output. NOTE: a program's output comes from outside,
/// though it was compiled here: the compiler may be anything, and its output may have been
/// replaced. So all functions throw EnvironmentError where a line has no value, where a wanted key
/// is missing or is no number, and where the number of values is wrong.
class Answers {
public:
    /// `program` is the name in errors.
    explicit Answers(std::filesystem::path program) : program_(std::move(program)) {}

    void hear(std::string_view line);

    [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) != 0; }
    [[nodiscard]] const std::string& text(const std::string& key) const;
    [[nodiscard]] std::int64_t integer(const std::string& key) const;
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key) const;  ///< none is allowed
    [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const;

    /// Returns the error for a program whose output is `what` instead of an answer.
    [[nodiscard]] EnvironmentError unexpected(const std::string& what) const;

private:
    template <class Number>
    [[nodiscard]] Number read(const std::string& key, std::string_view text) const;

    std::filesystem::path program_;
    std::map<std::string, std::vector<std::string>> values_;
};

/// A compiled program.
struct Program {
    std::filesystem::path file;
};

/// A compiled library, which a copy of this process runs, and its data.
struct Library {
    std::filesystem::path file;
    std::filesystem::path directory;  ///< the scene's directory
    std::vector<double> parameters;
    bool looks_at_rows = false;  ///< for rows only: values of a state cost as much as a step
    std::shared_ptr<LateBuild> solvers = {};  ///< solvers that its steps seldom call; or none
};

/// Steppers without a compiler, which a copy of this process runs, and their data.
struct Interpreted {
    StepperFamily family;
    std::vector<double> parameters;
};

/// The target of a driver.
using Target = std::variant<Program, Library, Interpreted>;

/// Returns the error for steps that call for a solver which their target cannot get.
[[nodiscard]] EnvironmentError solver_is_missing();

/// Returns the steppers of a target for any parameters. Throws as loaded_module() does.
/// Precondition: the target is no Program.
[[nodiscard]] StepperFamily steppers_of(const Target& target);

/// Calls a compiled driver with these words, and reads its output; calls it again where solvers had
/// to be compiled for it. `on_progress` gets the finished part whenever the driver reports it.
/// Throws EnvironmentError where the driver did not end well, could not write `file`, or gave no
/// answer, and Interruption.
[[nodiscard]] Answers ask(const Target& target, const std::vector<std::string>& words,
                          const std::filesystem::path& file = {},
                          const std::function<void(double)>& on_progress = nullptr);

/// Has the target compute a trajectory, directions carried along, a modified Hamiltonian, a
/// balance, or the measured end of a run with events. Throws as above. Precondition: the target is
/// no Program.
[[nodiscard]] Answers ask(const Target& target, const TrajectoryWishes& wishes,
                          const std::function<void(double)>& on_progress = nullptr);
[[nodiscard]] Answers ask(const Target& target, const TangentWishes& wishes,
                          const std::function<void(double)>& on_progress = nullptr);
[[nodiscard]] Answers ask(const Target& target, const ShadowWishes& wishes,
                          const std::function<void(double)>& on_progress = nullptr);
[[nodiscard]] Answers ask(const Target& target, const BalanceWishes& wishes,
                          const std::function<void(double)>& on_progress = nullptr);
[[nodiscard]] Answers ask(const Target& target, const EventfulRunWishes& wishes);

}  // namespace hvi::gen
