// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/thread.hpp"

#include <csignal>
#include <system_error>
#include <utility>

namespace hvi::gen {

std::thread start_thread(std::function<void()> run) {
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    std::thread thread;
    try {
        thread = std::thread(std::move(run));
    } catch (const std::system_error&) {}
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
}

}  // namespace hvi::gen
