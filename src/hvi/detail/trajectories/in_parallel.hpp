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

/// Calls work(i) for 0 <= i < count, each once, on `threads` threads; 0: as many as there are
/// processors. prepare() makes a work for each thread. The first exception is rethrown when all
/// threads have ended; then some calls have not been made.
template <class Prepare>
void in_parallel(std::size_t count, unsigned threads, Prepare prepare) {
    if (threads == 0) { threads = std::max(1U, std::thread::hardware_concurrency()); }
    std::atomic<std::size_t> next{0};
    Failure failure;
    const auto serve = [&] {
        try {
            auto work = prepare();
            for (std::size_t i = next++; i < count; i = next++) { work(i); }
        } catch (...) {
            next = count;
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
