// What a driver has said: see src/driver/answer.hpp.
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

/// Keys with their values in the order in which they were said. NOTE: what a program says comes
/// from outside, though it was compiled here: who knows what the compiler was, and what became of
/// its output. So all of these throw EnvironmentError where a line has no value, where what is
/// asked for was not said, or is no number, and where there are not as many.
class Answers {
public:
    /// Of a program, which errors speak of.
    explicit Answers(std::filesystem::path program) : program_(std::move(program)) {}

    void hear(std::string_view line);

    [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) != 0; }
    [[nodiscard]] const std::string& text(const std::string& key) const;
    [[nodiscard]] std::int64_t integer(const std::string& key) const;
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key) const;  ///< none is fine
    [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const;

    /// To be thrown: the program did not say what it should, but this.
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

/// A compiled library, which a copy of this process runs, and the data for it.
struct Library {
    std::filesystem::path file;
    std::filesystem::path directory;  ///< of the scene
    std::vector<double> parameters;
    bool looks_at_rows = false;  ///< alone: values of a state cost as much as a step does
    std::shared_ptr<LateBuild> solvers = {};  ///< that its steps seldom call; or none
};

/// Steppers without a compiler, which a copy of this process takes.
struct Interpreted {
    MakeStepper make;
};

/// What a driver drives.
using Target = std::variant<Program, Library, Interpreted>;

/// Calls a compiled driver with these words, once more where solvers had to be compiled for it, and
/// hears it out; `on_progress` gets the part that is done as often as the driver says. Throws
/// EnvironmentError where it did not end well, could not write `file`, or said what is no answer,
/// and Interruption.
[[nodiscard]] Answers ask(const Target& target, const std::vector<std::string>& words,
                          const std::filesystem::path& file = {},
                          const std::function<void(double)>& on_progress = nullptr);

/// Has a trajectory taken, directions carried along, a modified Hamiltonian, a balance or the end
/// of a run with events measured, likewise. Precondition: the target is no
/// Program.
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
