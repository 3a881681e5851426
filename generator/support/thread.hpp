// Threads beside the main one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <thread>

namespace hvi::gen {

/// Starts a thread without signals: the main thread gets them, and holds them back while it writes
/// a file. Returns a thread that is not joinable where none can be started.
[[nodiscard]] std::thread start_thread(std::function<void()> run);

/// Bytes of stack for work of any kind. A reader goes 200 levels deep and takes 4.4 KiB for each,
/// or 15 KiB with a sanitizer. Expressions are at most 1200 levels deep, and functions that walk
/// through them take 1 KiB for each.
constexpr std::size_t size_of_stack = 64 * 1024 * 1024;

/// Ends the program with the status that `run` returns. It has a stack of this size whatever the
/// limit of the shell is: it runs on a thread that takes the place of the main one, with its
/// signals. Returns only where no such thread can be started.
void exit_with(const std::function<int()>& run);

}  // namespace hvi::gen
