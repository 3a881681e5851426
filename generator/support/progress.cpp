// The thread that watches the stages go by.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/progress.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string>
#include <system_error>

namespace hvi::gen {

namespace {

using namespace std::chrono_literals;

constexpr auto silence = 2s;
constexpr auto interval = 5s;

std::atomic<const char*> current_stage = "working";

/// A thread without signals, which are for the main thread: that one holds them back while it
/// writes a file. Where no thread is to be had, there is no word on progress, and all else goes on.
template <class Run>
std::thread start_watcher(Run run) {
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    std::thread thread;
    try {
        thread = std::thread(run);
    } catch (const std::system_error&) {}
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
}

}  // namespace

Progress::Stage::Stage(const char* text) noexcept : outer_(current_stage.exchange(text)) {}

Progress::Stage::~Stage() { current_stage.store(outer_); }

Progress::Progress() : watcher_(start_watcher([this] { watch(); })) {}

Progress::~Progress() {
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ended_.notify_one();
    if (watcher_.joinable()) watcher_.join();
}

void Progress::watch() {
    auto next = start_ + silence;
    for (std::unique_lock lock(mutex_); !ended_.wait_until(lock, next, [this] { return end_; });
         next += interval) {
        const auto seconds =
            std::chrono::duration_cast<std::chrono::seconds>(next - start_).count();
        const std::string line = "hvi-gen: " + std::string(current_stage.load()) + " (" +
                                 std::to_string(seconds) + " s)\n";
        // One write, so that the line is not mixed with others; if nobody can read it, so be it.
        (void)!::write(STDERR_FILENO, line.data(), line.size());
    }
}

}  // namespace hvi::gen
