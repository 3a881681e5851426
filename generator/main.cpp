// hvi-gen: reads the command line, runs the command, and turns errors into messages and statuses.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <exception>
#include <variant>

#include "generator/cli/commands.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/process.hpp"
#include "generator/support/progress.hpp"
#include "generator/support/thread.hpp"

namespace {

using namespace hvi::gen;

void run_command(int argc, const char* const* argv) {
    const Request request = parse(CommandLine(argc, argv));
    const Progress progress;
    std::visit([](const auto& options) { run(options); }, request);
}

int report(const Error& error) {
    std::fputs(message(error).c_str(), stderr);
    return static_cast<int>(error.status());
}

int status_of(int argc, const char* const* argv) {
    try {
        run_command(argc, argv);
        return static_cast<int>(ExitStatus::done);
    } catch (const Error& error) { return report(error); } catch (const std::exception& error) {
        return report(InternalError(error.what()));
    } catch (...) { return report(InternalError("an exception of unknown type")); }
}

}  // namespace

int main(int argc, char** argv) {
    set_up_process();
    exit_with([&] { return status_of(argc, argv); });
    return report(EnvironmentError("there is no memory for a stack of 64 MiB, or no thread"));
}
