// Programs that this one starts and waits for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hvi::gen {

/// What became of a program.
struct ChildResult {
    int status = 0;      ///< its exit status, or 128 and the number of the signal that ended it
    std::string output;  ///< what it wrote to standard output, but for lines that were handed on
    std::string errors;  ///< the first of what it wrote to standard error, at most 64 kB

    [[nodiscard]] bool ok() const { return status == 0; }
};

/// Runs a program and waits for its end. `words` is its name, which is looked for in the absolute
/// directories of PATH unless it has a slash, and its arguments. It reads nothing, gets `directory`
/// as its own, and signals end it as usual. Complete lines of its output are handed to `on_line` as
/// they come, where there is one.
///
/// Throws EnvironmentError where the program cannot be started, and Interruption, after it has
/// ended the program and those that it has started, where interruptions are held.
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& words,
                                    const std::filesystem::path& directory,
                                    const std::function<void(std::string_view)>& on_line = nullptr);

/// What becomes of a child at an interruption, where these are held.
enum class WhenInterrupted {
    it_is_ended,
    it_stops,  ///< by SIGTERM, which it heeds within seconds; SIGUSR1 is handed on to it, too
};

/// Calls a function in a copy of this process: its result is the exit status. A child that stops at
/// an interruption is heard out, and the interruption is left to others. Throws as above.
/// Precondition: it waits for no other thread, as there are none in the copy.
[[nodiscard]] ChildResult run_child(const std::function<int()>& work,
                                    const std::function<void(std::string_view)>& on_line = nullptr,
                                    WhenInterrupted end = WhenInterrupted::it_is_ended);

}  // namespace hvi::gen
