// The thread that watches the stages go by.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/progress.hpp"

#include <unistd.h>

#include <atomic>
#include <string>

#include "generator/support/thread.hpp"

namespace hvi::gen {

namespace {

using namespace std::chrono_literals;

constexpr auto silence = 2s;
constexpr auto interval = 5s;

std::atomic<const char*> current_stage = "working";

}  // namespace

Progress::Stage::Stage(const char* text) noexcept : outer_(current_stage.exchange(text)) {}

Progress::Stage::~Stage() { current_stage.store(outer_); }

Progress::Progress() : watcher_(start_thread([this] { watch(); })) {}

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
        // NOTE: one write, so that the line is not mixed with others; a failure is ignored.
        (void)!::write(STDERR_FILENO, line.data(), line.size());
    }
}

}  // namespace hvi::gen
