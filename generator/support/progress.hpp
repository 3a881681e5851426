// Messages on standard error about long computations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace hvi::gen {

/// Reports the present stage of the program on standard error every few seconds while it lives.
/// Stages that end within two seconds are not reported.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Names the work of a scope: `const Progress::Stage stage("inverting M");`. Stages nest. A
    /// Stage costs an exchange of a pointer, and works without a Progress.
    class Stage {
    public:
        /// `text` is a literal: it must outlive the program's last line.
        explicit Stage(const char* text) noexcept;
        ~Stage();
        Stage(const Stage&) = delete;
        Stage& operator=(const Stage&) = delete;

    private:
        const char* outer_;
    };

private:
    void watch();

    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::condition_variable ended_;
    bool end_ = false;
    std::thread watcher_;  ///< last: it uses the members above
};

}  // namespace hvi::gen
