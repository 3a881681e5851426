// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/builds.hpp"

#include <algorithm>

#include "generator/support/progress.hpp"
#include "generator/support/thread.hpp"

namespace hvi::gen {

std::filesystem::path built(const Build& build) {
    const Progress::Stage stage("compiling");
    return build.get();
}

Builds::Builds(Compiler compiler) : compiler_(std::move(compiler)) {
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        if (std::thread worker = start_thread([this] { work(); }); worker.joinable())
            workers_.push_back(std::move(worker));
}

Builds::~Builds() {
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
        waiting_.clear();
    }
    changed_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

Build Builds::order(const ProgramText& text) {
    for (const auto& [other, build] : known_)
        if (other == text) return build;
    Task task([this, text] { return built_program(cache_, compiler_, text); });
    Build build = task.get_future().share();
    known_.emplace_back(text, build);
    if (workers_.empty()) {
        task();
        return build;
    }
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(task));
    }
    changed_.notify_one();
    return build;
}

void Builds::work() {
    while (true) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return end_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        Task task = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        task();
    }
}

}  // namespace hvi::gen
