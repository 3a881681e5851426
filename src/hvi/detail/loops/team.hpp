// Threads that work together, run after run.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace hvi::detail {

/// The threads of a team besides the one that calls run(). They wait for the next run a little
/// while without letting go of their processors, then by yielding, then asleep.
class Crew {
public:
    /// Where not so many threads can start there are fewer.
    explicit Crew(std::size_t members) {
        try {
            members_.reserve(members);
            while (members_.size() < members) {
                members_.emplace_back([this] { serve(); });
            }
        } catch (const std::exception&) {}  // std::system_error or std::bad_alloc
    }

    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    ~Crew() {
        open(leaving);
        for (std::thread& member : members_) { member.join(); }
    }

    /// Team::run(). Precondition: 1 < pieces.
    template <class F>
    void run(std::size_t pieces, F& f) {
        call_ = [](void* of, std::size_t piece) { (*static_cast<F*>(of))(piece); };
        f_ = const_cast<void*>(static_cast<const void*>(std::addressof(f)));
        pieces_ = pieces;
        next_ = 0;
        open(++runs_);
        work();
        // Who has come in by now is waited for, and who comes later finds a closed door: a member
        // that the system keeps from running delays nobody.
        door_ = closed;
        while (!comes_true([this] { return inside_ == 0; })) {}
    }

private:
    static constexpr std::uint64_t closed = 0, leaving = ~closed;

    void open(std::uint64_t door) {
        door_ = door;
        if (asleep_ > 0) {
            { const std::lock_guard<std::mutex> lock(mutex_); }
            wake_.notify_all();
        }
    }

    void work() {
        for (std::size_t i = next_++; i < pieces_; i = next_++) { call_(f_, i); }
    }

    void serve() {
        std::uint64_t last = closed;
        const auto is_called = [&] {
            const std::uint64_t door = door_;
            return door != closed && door != last;
        };
        while (true) {
            if (!comes_true(is_called)) { sleep_until(is_called); }
            // NOTE: all these atomics are in one order: run() sees who is inside, or the door is
            // seen closed here.
            ++inside_;
            last = door_;
            if (last != closed && last != leaving) { work(); }
            --inside_;
            if (last == leaving) { return; }
        }
    }

    template <class Condition>
    void sleep_until(Condition condition) {
        std::unique_lock<std::mutex> lock(mutex_);
        ++asleep_;
        wake_.wait(lock, condition);
        --asleep_;
    }

    /// Returns whether the condition has become true in about a millisecond.
    template <class Condition>
    static bool comes_true(Condition condition) {
        for (int looks = 0; looks < 2000; ++looks) {
            if (condition()) { return true; }
        }
        for (int looks = 0; looks < 2000; ++looks) {
            std::this_thread::yield();
            if (condition()) { return true; }
        }
        return false;
    }

    void (*call_)(void*, std::size_t) = nullptr;
    void* f_ = nullptr;
    std::size_t pieces_ = 0;
    std::uint64_t runs_ = closed;
    alignas(64) std::atomic<std::size_t> next_{0};
    alignas(64) std::atomic<std::uint64_t> door_{closed};  ///< which run it is open for
    std::atomic<int> inside_{0}, asleep_{0};
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::thread> members_;  // last: they use all others
};

/// So many threads, the one that calls run() included. The others start with the first run that
/// has work for them, where they can, and end with the team. A copy is a team of its own.
class Team {
public:
    /// 0: as many as there are processors.
    explicit Team(unsigned threads)
        : threads_(threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

    Team(const Team& other) : threads_(other.threads_) {}
    Team(Team&&) = default;
    Team& operator=(const Team& other) { return *this = Team(other); }
    Team& operator=(Team&&) = default;
    ~Team() = default;

    [[nodiscard]] unsigned threads() const { return threads_; }

    /// f(piece) for 0 <= piece < pieces, each once, in any order and by any of the threads; returns
    /// when all are done. Preconditions: f throws nothing and calls no run() of this team, and
    /// nobody else does meanwhile. Throws std::bad_alloc, before anything is done.
    template <class F>
    void run(std::size_t pieces, F&& f) {
        if (threads_ == 1 || pieces <= 1) {
            for (std::size_t i = 0; i < pieces; ++i) { f(i); }
            return;
        }
        if (!crew_) { crew_ = std::make_unique<Crew>(threads_ - 1); }
        crew_->run(pieces, f);
    }

private:
    unsigned threads_;
    std::unique_ptr<Crew> crew_;
};

}  // namespace hvi::detail
