// Programs that are compiled side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "generator/program/cache.hpp"
#include "generator/program/compiler.hpp"

namespace hvi::gen {

/// Where a program is once it is compiled. Its get() waits, and throws what built_program() does,
/// and Interruption.
using Build = std::shared_future<std::filesystem::path>;

/// Waits for it, and says so where that takes long.
[[nodiscard]] std::filesystem::path built(const Build& build);

/// Compiles what is ordered, while other things are done: as many programs at a time as the machine
/// has processors, or one after the other where there are no threads to be had. At the end of its
/// life those that are not begun are forgotten, and those that are begun come to their end; where
/// its CacheDirectory is one for this time, the programs are gone then.
class Builds {
public:
    /// Throws as CacheDirectory does.
    explicit Builds(Compiler compiler);
    ~Builds();
    Builds(const Builds&) = delete;
    Builds& operator=(const Builds&) = delete;

    [[nodiscard]] const Compiler& compiler() const { return compiler_; }

    /// The same for the same text. Order all of them before the first is waited for.
    [[nodiscard]] Build order(const ProgramText& text);

    /// Where it is, if it was compiled before.
    [[nodiscard]] std::optional<std::filesystem::path> kept(const ProgramText& text) const {
        return kept_program(cache_, compiler_, text);
    }

private:
    using Task = std::packaged_task<std::filesystem::path()>;

    void work();

    Compiler compiler_;
    CacheDirectory cache_;
    std::vector<std::pair<ProgramText, Build>> known_;
    std::mutex mutex_;  ///< of the two below
    std::deque<Task> waiting_;
    bool end_ = false;
    std::condition_variable changed_;
    std::vector<std::thread> workers_;  ///< last: they use the members above
};

/// A program that is compiled when it is first called for, or before.
class LateBuild {
public:
    /// Precondition: `builds` live longer.
    LateBuild(Builds& builds, ProgramText text)
        : builds_(&builds), text_(std::move(text)), file_(builds_->kept(text_)) {}

    /// Where it is, if it is compiled.
    [[nodiscard]] const std::optional<std::filesystem::path>& file() const { return file_; }

    /// Begins to compile it, while other things are done.
    void begin() {
        if (!file_ && !build_) build_ = builds_->order(text_);
    }

    /// Waits until it is compiled, and says so. Throws what its Build does.
    void compile() {
        begin();
        if (!file_) file_ = built(*build_);
    }

private:
    Builds* builds_;
    ProgramText text_;
    std::optional<std::filesystem::path> file_;
    std::optional<Build> build_;
};

}  // namespace hvi::gen
