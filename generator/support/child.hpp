// Programs that this one starts and waits for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hvi::gen {

/// The outcome of a program.
struct ChildResult {
    int status = 0;      ///< its exit status, or 128 and the number of the signal that ended it
    std::string output;  ///< its standard output, but for lines that were handed on
    std::string errors;  ///< the first 64 kB, at most, of its standard error

    [[nodiscard]] bool ok() const { return status == 0; }
};

/// Runs a program and waits for its end. `words` are its name and its arguments. A name without a
/// slash is looked for in the absolute directories of PATH. The program reads nothing, runs in
/// `directory`, and signals end it as usual. Complete lines of its output are handed to `on_line`,
/// where there is one, as they come.
///
/// Throws EnvironmentError where the program cannot be started. Where interruptions are held, an
/// interruption ends the program and the processes that it has started; then throws Interruption.
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& words,
                                    const std::filesystem::path& directory,
                                    const std::function<void(std::string_view)>& on_line = nullptr);

/// The reaction of a child to an interruption, where these are held.
enum class WhenInterrupted {
    it_is_ended,
    it_stops,  ///< by SIGTERM, which it heeds within seconds; SIGUSR1 is handed on to it, too
};

/// Calls a function in a copy of this process; its result is the exit status. The output of a child
/// that stops at an interruption is read to its end, and the interruption is left to others. Throws
/// as above. Precondition: the function waits for no other thread, as there are none in the copy.
[[nodiscard]] ChildResult run_child(const std::function<int()>& work,
                                    const std::function<void(std::string_view)>& on_line = nullptr,
                                    WhenInterrupted end = WhenInterrupted::it_is_ended);

/// Calls work(k) for k from 0 to count - 1, each in a copy of this process and all at once. An
/// interruption stops all of them. Lines are handed on with the number of their copy. Returns the
/// outcomes in order. Throws as above, with the same precondition.
[[nodiscard]] std::vector<ChildResult>
run_children(std::size_t count, const std::function<int(std::size_t)>& work,
             const std::function<void(std::size_t, std::string_view)>& on_line = nullptr);

}  // namespace hvi::gen
