// Threads beside the main one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <thread>

namespace hvi::gen {

/// A thread without signals, which are for the main one: that holds them back while it writes a
/// file. Not joinable where no thread is to be had.
[[nodiscard]] std::thread start_thread(std::function<void()> run);

}  // namespace hvi::gen
