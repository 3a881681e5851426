// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/thread.hpp"

#include <pthread.h>

#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace hvi::gen {

namespace {

/// Blocks all signals while it lives; they wait for threads that do not block them.
class SignalsBlocked {
public:
    SignalsBlocked() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before_);
    }
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;

    [[nodiscard]] const sigset_t& before() const { return before_; }

private:
    sigset_t before_;
};

}  // namespace

std::thread start_thread(std::function<void()> run) {
    const SignalsBlocked blocked;
    try {
        return std::thread(std::move(run));
    } catch (const std::system_error&) { return {}; }
}

void exit_with(const std::function<int()>& run) {
    struct Work {
        const std::function<int()>& run;
        const sigset_t& signals;
    };
    const SignalsBlocked blocked;
    Work work{run, blocked.before()};
    const auto start = [](void* given) -> void* {
        const Work& of_thread = *static_cast<Work*>(given);
        pthread_sigmask(SIG_SETMASK, &of_thread.signals, nullptr);
        // NOTE: exits here, so that the data that libraries keep for each thread live until the
        // end.
        std::exit(of_thread.run());
    };
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, size_of_stack);
    pthread_t thread{};
    if (pthread_create(&thread, &attributes, start, &work) == 0) pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}

}  // namespace hvi::gen
