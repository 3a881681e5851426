// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/answers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "generator/drive/drive.hpp"
#include "generator/drive/module.hpp"
#include "generator/support/child.hpp"
#include "generator/support/error.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

// Exit statuses of drivers.
constexpr int cannot_write = 3;
constexpr int out_of_memory = 4;
constexpr int cannot_read = 5;

/// Returns the driven file, for errors.
std::filesystem::path file_of(const Target& target) {
    if (const auto* program = std::get_if<Program>(&target)) return program->file;
    if (const auto* library = std::get_if<Library>(&target)) return library->file;
    return "/proc/self/exe";
}

using OnLine = std::function<void(std::string_view)>;

ModuleStart start_of(const Library& library) {
    const std::shared_ptr<LateBuild>& solvers = library.solvers;
    return {std::filesystem::absolute(library.file).string(),
            solvers && solvers->file() ? solvers->file()->string() : "",
            std::filesystem::absolute("." / library.directory).string(), library.parameters};
}

/// Work on steppers, which returns the exit status.
using WorkOnSteppers = std::function<int(const FindSteppers&)>;

/// An order to a driver: words for a program, or work on the steppers of a module.
struct Command {
    std::vector<std::string> words;
    WorkOnSteppers work;
    WhenInterrupted end = WhenInterrupted::it_is_ended;
};

ChildResult driven(const Command& command, const Program& program, const OnLine& on_line) {
    HVI_CHECK(!command.work);
    std::vector<std::string> line{program.file.string()};
    line.insert(line.end(), command.words.begin(), command.words.end());
    return run_child(line, ".", on_line);
}

/// Starts the work, or the words, on steppers; `looks_at_rows` is that of a Library.
ChildResult driven(const Command& command, const FindSteppers& find, bool looks_at_rows,
                   const OnLine& on_line) {
    return run_child(
        [&] {
            if (command.work) return command.work(find);
            std::vector<std::string_view> line(command.words.begin(), command.words.end());
            if (looks_at_rows) line.insert(line.begin(), rows_word);
            return drive(find, line);
        },
        on_line, command.end);
}

ChildResult driven(const Command& command, const Library& library, const OnLine& on_line) {
    return driven(
        command, [&] { return loaded_module(start_of(library)); }, library.looks_at_rows, on_line);
}

ChildResult driven(const Command& command, const Interpreted& interpreted, const OnLine& on_line) {
    return driven(
        command, [&] { return interpreted.family(interpreted.parameters); }, false, on_line);
}

}  // namespace

EnvironmentError solver_is_missing() {
    return EnvironmentError("fixed points are too slow for these steps, and Newton's method "
                            "needs a compiler",
                            "without --interpret it is compiled; or smaller steps");
}

StepperFamily steppers_of(const Target& target) {
    if (const auto* interpreted = std::get_if<Interpreted>(&target)) return interpreted->family;
    return loaded_family(start_of(std::get<Library>(target)));
}

void Answers::hear(std::string_view line) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos) throw unexpected(fmt::format("it says `{}`", line));
    values_[std::string(line.substr(0, blank))].emplace_back(line.substr(blank + 1));
}

template <class Number>
Number Answers::read(const std::string& key, std::string_view text) const {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        throw unexpected(fmt::format("it says `{} {}`", key, text));
    return value;
}

const std::string& Answers::text(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) throw unexpected(fmt::format("it says nothing of `{}`", key));
    return found->second.back();
}

std::int64_t Answers::integer(const std::string& key) const {
    return read<std::int64_t>(key, text(key));
}

double Answers::number(const std::string& key) const { return read<double>(key, text(key)); }

std::vector<double> Answers::numbers(const std::string& key) const {
    std::vector<double> result;
    if (const auto found = values_.find(key); found != values_.end())
        for (const std::string& value : found->second) result.push_back(read<double>(key, value));
    return result;
}

std::vector<double> Answers::numbers(const std::string& key, std::size_t count) const {
    std::vector<double> result = numbers(key);
    if (result.size() != count)
        throw unexpected(fmt::format("it says `{}` {} times, not {}", key, result.size(), count));
    return result;
}

EnvironmentError Answers::unexpected(const std::string& what) const {
    return EnvironmentError("a compiled program does not answer as it should: " + what,
                            fmt::format("it is compiled anew by another compiler, which CXX names, "
                                        "or where {} is removed",
                                        program_.parent_path().string()));
}

namespace {

/// The output of a program, and its end.
struct Hearing {
    Answers answers;
    ChildResult ended;
};

Hearing heard(const Target& target, const Command& command,
              const std::function<void(double)>& on_progress) {
    constexpr std::string_view progress = "progress ";
    const Progress::Stage stage("running");
    const std::filesystem::path file = file_of(target);
    Answers answers(file);
    const OnLine on_line = [&](std::string_view line) {
        if (!line.starts_with(progress)) return answers.hear(line);
        Answers of_progress(file);
        of_progress.hear(line);
        const double part = of_progress.number("progress");
        if (!(part >= 0 && part <= 1)) throw answers.unexpected(fmt::format("it says `{}`", line));
        if (on_progress) on_progress(part);
    };
    ChildResult ended =
        std::visit([&](const auto& each) { return driven(command, each, on_line); }, target);
    return {std::move(answers), std::move(ended)};
}

Answers answers_to(const Target& target, const Command& command, const std::filesystem::path& file,
                   const std::function<void(double)>& on_progress) {
    Hearing last = heard(target, command, on_progress);
    const auto* library = std::get_if<Library>(&target);
    if (last.ended.status == solver_is_apart && library != nullptr && library->solvers) {
        library->solvers->compile();
        last = heard(target, command, on_progress);
    }
    const auto& [answers, ended] = last;
    if (ended.status == solver_is_apart) throw solver_is_missing();
    if (ended.status == cannot_write && !file.empty())
        throw EnvironmentError("cannot write " + file.string());
    if (ended.status == out_of_memory)
        throw EnvironmentError("there is not enough memory for the run");
    if (ended.status == cannot_read) throw EnvironmentError(answers.text("unreadable"));
    if (ended.status > 128)
        throw EnvironmentError(
            fmt::format("a compiled program was ended by signal {}", ended.status - 128));
    if (!ended.ok()) throw answers.unexpected(fmt::format("it ends with status {}", ended.status));
    return std::move(last.answers);
}

}  // namespace

Answers ask(const Target& target, const std::vector<std::string>& words,
            const std::filesystem::path& file, const std::function<void(double)>& on_progress) {
    std::vector<std::string> all = words;
    if (!file.empty()) all.push_back(file.string());
    return answers_to(target, {all, {}}, file, on_progress);
}

Answers ask(const Target& target, const TrajectoryWishes& wishes,
            const std::function<void(double)>& on_progress) {
    TrajectoryWishes all = wishes;
    const auto* library = std::get_if<Library>(&target);
    all.looks_at_rows = library != nullptr && library->looks_at_rows;
    return answers_to(
        target,
        {{}, [&](const FindSteppers& find) { return drive(find, all); }, WhenInterrupted::it_stops},
        wishes.tables.front().file, on_progress);
}

Answers ask(const Target& target, const TangentWishes& wishes,
            const std::function<void(double)>& on_progress) {
    return answers_to(target, {{}, [&](const FindSteppers& find) { return drive(find, wishes); }},
                      {}, on_progress);
}

Answers ask(const Target& target, const ShadowWishes& wishes,
            const std::function<void(double)>& on_progress) {
    return answers_to(target, {{}, [&](const FindSteppers& find) { return drive(find, wishes); }},
                      {}, on_progress);
}

Answers ask(const Target& target, const BalanceWishes& wishes,
            const std::function<void(double)>& on_progress) {
    return answers_to(target, {{}, [&](const FindSteppers& find) { return drive(find, wishes); }},
                      {}, on_progress);
}

Answers ask(const Target& target, const EventfulRunWishes& wishes) {
    return answers_to(target, {{}, [&](const FindSteppers& find) { return drive(find, wishes); }},
                      {}, nullptr);
}

}  // namespace hvi::gen
