// Signals and standard streams.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "generator/support/error.hpp"

namespace hvi::gen {

void set_up_process() {
    // NOTE: opened the wrong way round, so that writing to a closed standard output still fails.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0)
            (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    std::signal(SIGPIPE, SIG_IGN);
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { ::_exit(static_cast<int>(ExitStatus::interrupted)); });
}

}  // namespace hvi::gen
