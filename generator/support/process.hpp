// The settings of the process, made before anything else.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// Sets the process up. An interruption - SIGINT, SIGQUIT, SIGTERM, or the terminal's end, SIGHUP -
/// ends the program with status 130. Writing to a closed pipe, or to a file that may not grow, is
/// an error like any other. The numbers of closed standard streams are not given to files that are
/// opened later.
void set_up_process();

/// Holds interruptions back while it lives. An interruption then makes interruption_descriptor()
/// readable, and a function that waits for a child ends it first. One object at a time, in the main
/// thread. An interruption that nobody has seen ends the program at the end of its life.
class InterruptionsHeld {
public:
    /// Throws EnvironmentError where the process may open no more files.
    InterruptionsHeld();
    ~InterruptionsHeld();
    InterruptionsHeld(const InterruptionsHeld&) = delete;
    InterruptionsHeld& operator=(const InterruptionsHeld&) = delete;
};

/// Returns a descriptor that is readable after an interruption; -1 where interruptions are not
/// held.
[[nodiscard]] int interruption_descriptor();

/// Whether a held interruption has come: for functions that compute, and do not wait.
[[nodiscard]] bool is_interrupted();

}  // namespace hvi::gen
