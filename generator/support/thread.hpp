// Threads beside the main one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <thread>

namespace hvi::gen {

/// A thread without signals, which are for the main one: that holds them back while it writes a
/// file. Not joinable where no thread is to be had.
[[nodiscard]] std::thread start_thread(std::function<void()> run);

/// Bytes that work of any kind may have for its stack. A reader goes 200 levels deep and takes 4.4
/// KiB for each, 15 KiB where a sanitizer looks on; expressions are 1200 levels deep at most, and
/// those who walk through them take 1 KiB for each.
constexpr std::size_t size_of_stack = 64 * 1024 * 1024;

/// Ends the program with the status that `run` returns, which has a stack of that size whatever the
/// limit of the shell is: on a thread that takes the place of the main one, with its signals.
/// Returns only where there is no such thread.
void exit_with(const std::function<int()>& run);

}  // namespace hvi::gen
