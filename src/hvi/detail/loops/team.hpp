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

/// Share of the pieces: from first to end - 1, begun by one thread.
class alignas(64) Share {
public:
    /// Precondition: end < 2^32.
    void set(std::size_t first, std::size_t end) {
        has_owner_ = false;
        few_ = (end - first) / 8;
        left_ = packed(first, end);
    }

    /// Says that the owner of the share has begun. It will not leave before nothing is left.
    void begin() { has_owner_ = true; }

    /// Takes a piece for the owner of the share. Returns false where nothing is left.
    [[nodiscard]] bool take_first(std::size_t& piece) {
        std::uint64_t left = left_;
        do {
            if (first_of(left) == end_of(left)) { return false; }
            piece = first_of(left);
        } while (!left_.compare_exchange_weak(left, packed(piece + 1, end_of(left))));
        return true;
    }

    /// Takes a piece for another thread. Returns false also where few pieces are left and the owner
    /// has begun: it is about to take them, and has them in its cache.
    [[nodiscard]] bool take_last(std::size_t& piece) {
        const std::size_t few = has_owner_ ? few_ : 0;
        std::uint64_t left = left_;
        do {
            if (end_of(left) - first_of(left) <= few) { return false; }
            piece = end_of(left) - 1;
        } while (!left_.compare_exchange_weak(left, packed(first_of(left), piece)));
        return true;
    }

private:
    static std::uint64_t packed(std::size_t first, std::size_t end) {
        return std::uint64_t{first} << 32 | end;
    }
    static std::size_t first_of(std::uint64_t left) { return left >> 32; }
    static std::size_t end_of(std::uint64_t left) { return left & 0xffffffff; }

    std::atomic<std::uint64_t> left_{0};
    std::atomic<bool> has_owner_{false};
    std::size_t few_ = 0;
};

/// Threads of a team besides the one that calls run(). They wait for the next run first by
/// spinning, then by yielding, then asleep.
///
/// Each thread begins with the same share of the pieces in run after run, so that its cache holds
/// what it needs again. Afterwards it helps the others with theirs.
class Crew {
public:
    /// Starts the members, or as many as can start. Throws std::bad_alloc.
    explicit Crew(std::size_t members) : shares_(members + 1) {
        try {
            members_.reserve(members);
            while (members_.size() < members) {
                members_.emplace_back([this, share = members_.size() + 1] { serve(share); });
            }
        } catch (const std::exception&) {}  // std::system_error or std::bad_alloc
    }

    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    ~Crew() {
        open(leaving);
        for (std::thread& member : members_) { member.join(); }
    }

    /// Runs f as Team::run() does. Precondition: 1 < pieces.
    template <class F>
    void run(std::size_t pieces, F& f) {
        call_ = [](void* of, std::size_t piece) { (*static_cast<F*>(of))(piece); };
        f_ = const_cast<void*>(static_cast<const void*>(std::addressof(f)));
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            shares_[k].set(pieces * k / shares_.size(), pieces * (k + 1) / shares_.size());
        }
        open(++runs_);
        work(0);
        // run() waits for members that have come in by now, and a member that comes later finds a
        // closed door: a member that the system keeps from running delays nobody.
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

    /// Takes the thread's own share, and then pieces that others leave.
    void work(std::size_t own) {
        std::size_t piece = 0;
        shares_[own].begin();
        while (shares_[own].take_first(piece)) { call_(f_, piece); }
        for (std::size_t k = 1; k < shares_.size(); ++k) {
            Share& other = shares_[(own + k) % shares_.size()];
            while (other.take_last(piece)) { call_(f_, piece); }
        }
    }

    void serve(std::size_t own) {
        std::uint64_t last = closed;
        const auto is_called = [&] {
            const std::uint64_t door = door_;
            return door != closed && door != last;
        };
        while (true) {
            if (!comes_true(is_called)) { sleep_until(is_called); }
            // NOTE: all these atomics are in one order: either run() sees who is inside, or the
            // door is seen closed here.
            ++inside_;
            last = door_;
            if (last != closed && last != leaving) { work(own); }
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

    /// Waits about a millisecond for the condition. Returns whether it has become true.
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
    std::uint64_t runs_ = closed;
    std::vector<Share> shares_;  ///< the first is that of the thread of run()
    alignas(64) std::atomic<std::uint64_t> door_{closed};  ///< the run that it is open for
    std::atomic<int> inside_{0}, asleep_{0};
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::thread> members_;  // last: they use all others
};

/// A team of `threads` threads, the one that calls run() included. The others start with the first
/// run that has work for them, where they can, and end with the team. A copy is a team of its own.
class Team {
public:
    /// `threads`: 0 for as many as there are processors.
    explicit Team(unsigned threads)
        : threads_(threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

    Team(const Team& other) : threads_(other.threads_) {}
    Team(Team&&) = default;
    Team& operator=(const Team& other) { return *this = Team(other); }
    Team& operator=(Team&&) = default;
    ~Team() = default;

    [[nodiscard]] unsigned threads() const { return threads_; }

    /// Calls f(piece) for 0 <= piece < pieces, each once, in any order and by any of the threads.
    /// Returns when all calls are done. Preconditions: f throws nothing and calls no run() of this
    /// team, and nobody else does meanwhile. Throws std::bad_alloc, before anything is done.
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
