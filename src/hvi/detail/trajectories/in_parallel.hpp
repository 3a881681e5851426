// Work that threads take from one another.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace hvi::detail {

/// Keeps the first exception of several threads.
class Failure {
public:
    void keep(std::exception_ptr exception) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!first_) { first_ = std::move(exception); }
    }

    void rethrow() const {
        if (first_) { std::rethrow_exception(first_); }
    }

private:
    std::mutex mutex_;
    std::exception_ptr first_;
};

/// Threads beside the present one, joined by the destructor.
class Joined {
public:
    template <class Work>
    void start(std::size_t threads, const Work& work) {
        for (std::size_t i = 1; i < threads; ++i) { threads_.emplace_back(work); }
    }

    Joined() = default;
    Joined(const Joined&) = delete;
    Joined& operator=(const Joined&) = delete;
    ~Joined() {
        for (std::thread& thread : threads_) { thread.join(); }
    }

private:
    std::vector<std::thread> threads_;
};

/// The numbers below a count. Each is taken once, by any thread.
class Numbers {
public:
    explicit Numbers(std::size_t count) : count_(count) {}

    /// Sets `number` to the next one. Returns whether there is one.
    [[nodiscard]] bool take(std::size_t& number) {
        number = next_++;
        return number < count_;
    }

    /// Leaves none to take.
    void end() { next_ = count_; }

private:
    std::atomic<std::size_t> next_{0};
    std::size_t count_;
};

/// Calls work(numbers) on each of `threads` threads, to take numbers below `count`; 0 threads: as
/// many as there are processors. The first exception is rethrown when all threads have ended; then
/// some numbers were not taken.
template <class Work>
void in_parallel(std::size_t count, unsigned threads, const Work& work) {
    if (threads == 0) { threads = std::max(1U, std::thread::hardware_concurrency()); }
    Numbers numbers(count);
    Failure failure;
    const auto serve = [&] {
        try {
            work(numbers);
        } catch (...) {
            numbers.end();
            failure.keep(std::current_exception());
        }
    };
    {
        Joined others;
        try {
            others.start(std::min<std::size_t>(threads, count), serve);
        } catch (...) { failure.keep(std::current_exception()); }
        serve();
    }
    failure.rethrow();
}

}  // namespace hvi::detail
