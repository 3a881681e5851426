// Signals and standard streams.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

// Both ends of a pipe, in which a byte stands for an interruption; -1 while none are held.
std::array<std::atomic<int>, 2> held{-1, -1};
std::atomic<bool> seen = false;  // a byte is in the pipe
static_assert(std::atomic<int>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);  // as a signal's handler needs it

void interrupt(int) {
    const int writing = held[1].load();
    if (writing < 0 || ::write(writing, "", 1) != 1)
        ::_exit(static_cast<int>(ExitStatus::interrupted));
    seen.store(true);
}

}  // namespace

void set_up_process() {
    // NOTE: opened in the wrong direction, so that writing to a closed standard output still fails.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0)
            (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    // NOTE: the calls that would raise these signals return an error instead. Programs that this
    // one starts inherit this; only SIGPIPE ends them again.
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
    for (const int signal : {SIGINT, SIGQUIT, SIGTERM}) std::signal(signal, interrupt);
    // NOTE: where SIGHUP was ignored it stays so, as nohup wants it.
    if (std::signal(SIGHUP, interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

InterruptionsHeld::InterruptionsHeld() {
    HVI_CHECK(interruption_descriptor() < 0);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        throw EnvironmentError("cannot make a pipe: " + std::generic_category().message(errno));
    held[0].store(ends[0]);
    held[1].store(ends[1]);
}

InterruptionsHeld::~InterruptionsHeld() {
    ::close(held[1].exchange(-1));
    const int reading = held[0].exchange(-1);
    char byte = 0;
    if (::read(reading, &byte, 1) == 1) ::_exit(static_cast<int>(ExitStatus::interrupted));
    ::close(reading);
    seen.store(false);
}

int interruption_descriptor() { return held[0].load(); }

bool is_interrupted() { return seen.load(std::memory_order_relaxed); }

}  // namespace hvi::gen
