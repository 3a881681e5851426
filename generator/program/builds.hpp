// Programs that are compiled in parallel.
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

/// The path of a compiled program. Its get() waits, and throws as built_program() does, and
/// Interruption.
using Build = std::shared_future<std::filesystem::path>;

/// Waits for a program, and reports that where it takes long.
[[nodiscard]] std::filesystem::path built(const Build& build);

/// Compiles programs in the background: as many at a time as the machine has processors, or one
/// after the other where no threads can be started. The destructor forgets programs that are not
/// begun, and finishes those that are. Programs in a temporary CacheDirectory are then removed.
class Builds {
public:
    /// Throws as CacheDirectory does.
    explicit Builds(Compiler compiler);
    ~Builds();
    Builds(const Builds&) = delete;
    Builds& operator=(const Builds&) = delete;

    [[nodiscard]] const Compiler& compiler() const { return compiler_; }

    /// Returns one build for equal texts. Order all programs before waiting for the first.
    [[nodiscard]] Build order(const ProgramText& text);

    /// Returns the path if the program was compiled before.
    [[nodiscard]] std::optional<std::filesystem::path> kept(const ProgramText& text) const {
        return kept_program(cache_, compiler_, text);
    }

private:
    using Task = std::packaged_task<std::filesystem::path()>;

    void work();

    Compiler compiler_;
    CacheDirectory cache_;
    std::vector<std::pair<ProgramText, Build>> known_;
    std::mutex mutex_;  ///< for the two below
    std::deque<Task> waiting_;
    bool end_ = false;
    std::condition_variable changed_;
    std::vector<std::thread> workers_;  ///< last: they use the members above
};

/// A program that is compiled when it is first needed, or before.
class LateBuild {
public:
    /// Precondition: `builds` lives longer.
    LateBuild(Builds& builds, ProgramText text)
        : builds_(&builds), text_(std::move(text)), file_(builds_->kept(text_)) {}

    /// Returns the path if it is compiled.
    [[nodiscard]] const std::optional<std::filesystem::path>& file() const { return file_; }

    /// Begins to compile it in the background.
    void begin() {
        if (!file_ && !build_) build_ = builds_->order(text_);
    }

    /// Waits until it is compiled, and reports that. Throws as its Build does.
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
