// What the program asks of the operating system before it does anything else.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// An interruption - SIGINT, SIGQUIT, SIGTERM, or the terminal's end, SIGHUP - ends the program
/// with status 130, writing to a closed pipe or to a file that may not grow is an error like any
/// other, and the numbers of closed standard streams are not given to files that are opened later.
void set_up_process();

/// While it lives, an interruption does not end the program at once: interruption_descriptor()
/// becomes readable, and whoever waits for something ends that first. One at a time, in the main
/// thread. An interruption that nobody has seen ends the program where this ends.
class InterruptionsHeld {
public:
    /// Throws EnvironmentError where the process may open no more files.
    InterruptionsHeld();
    ~InterruptionsHeld();
    InterruptionsHeld(const InterruptionsHeld&) = delete;
    InterruptionsHeld& operator=(const InterruptionsHeld&) = delete;
};

/// Readable once there was an interruption; -1 where they are not held.
[[nodiscard]] int interruption_descriptor();

/// Whether there was one that is held: for whoever computes, and does not wait.
[[nodiscard]] bool is_interrupted();

}  // namespace hvi::gen
