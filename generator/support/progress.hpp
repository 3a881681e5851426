// A word on standard error when something takes long.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace hvi::gen {

/// While it lives, a line on standard error tells every few seconds what the program is at. What
/// ends within two seconds is never spoken of.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// What is being done in this scope: `const Progress::Stage stage("inverting M");`. Stages
    /// nest. Announcing one costs an exchange of a pointer, and needs no Progress to be there.
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
