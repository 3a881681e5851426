// Programs that this one starts.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/support/child.hpp"
#include "generator/support/error.hpp"
#include "generator/support/process.hpp"
#include "generator/support/thread.hpp"

namespace fs = std::filesystem;

using namespace hvi::gen;

TEST_CASE("what a program writes, and how it ends") {
    const ChildResult result = run_child({"sh", "-c", "echo out; echo err >&2; exit 7"}, ".");
    CHECK(result.output == "out\n");
    CHECK(result.errors == "err\n");
    CHECK(result.status == 7);
    CHECK(!result.ok());
    CHECK(run_child({"sh", "-c", "kill -9 $$"}, ".").status == 128 + 9);
    CHECK(run_child({"pwd"}, "/").output == "/\n");
    CHECK(run_child({"cat"}, ".").output.empty());  // there is nothing to read
}

TEST_CASE("lines come one by one, the last one without its end stays") {
    std::vector<std::string> lines;
    const ChildResult result = run_child({"printf", "a\\nbc\\n\\nd"}, ".",
                                         [&](std::string_view line) { lines.emplace_back(line); });
    CHECK(lines == std::vector<std::string>{"a", "bc", ""});
    CHECK(result.output == "d");
}

TEST_CASE("much output on both streams") {
    const ChildResult result =
        run_child({"sh", "-c",
                   "i=0; while [ $i -lt 20000 ]; do echo 0123456789; echo 0123456789 >&2; "
                   "i=$((i+1)); done"},
                  ".");
    CHECK(result.output.size() == 220000);
    CHECK(result.errors.size() == 64 * 1024);
}

TEST_CASE("a program that is not there") {
    CHECK_THROWS_AS(run_child({"hvi-no-such-program"}, "."), EnvironmentError);
    CHECK_THROWS_AS(run_child({"true"}, "/hvi-no-such-directory"), EnvironmentError);
}

TEST_CASE("a program is not looked for in the directory that it gets") {
    std::string directory = (fs::temp_directory_path() / "hvi-test-XXXXXX").string();
    REQUIRE(::mkdtemp(directory.data()) != nullptr);
    const fs::path planted = fs::path(directory) / "hvi-planted";
    std::ofstream(planted) << "#!/bin/sh\necho planted\n";
    fs::permissions(planted, fs::perms::owner_all);
    const std::string before = std::getenv("PATH");
    for (const std::string& path :
         {":" + before, before + ":", ".:" + before, before + "::/none"}) {
        INFO(path);
        ::setenv("PATH", path.c_str(), 1);
        CHECK_THROWS_AS(run_child({"hvi-planted"}, directory), EnvironmentError);
        CHECK(run_child({"pwd"}, "/").output == "/\n");
    }
    ::setenv("PATH", (before + ":" + directory).c_str(), 1);
    CHECK(run_child({"hvi-planted"}, ".").output == "planted\n");
    ::setenv("PATH", before.c_str(), 1);
    fs::remove_all(directory);
}

TEST_CASE("signals end a program as usual, from whatever thread it is started") {
    set_up_process();
    ChildResult result;
    start_thread([&] {
        result = run_child({"grep", "-E", "^Sig(Blk|Ign):", "/proc/self/status"}, ".");
    }).join();
    std::istringstream lines(result.output);
    std::string name;
    unsigned long blocked = 1, ignored = ~0UL;
    lines >> name >> std::hex >> blocked >> name >> ignored;
    REQUIRE(name == "SigIgn:");
    CHECK(blocked == 0);
    for (const int signal : {SIGPIPE, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGCHLD}) {
        INFO(signal);
        CHECK((ignored >> static_cast<unsigned>(signal - 1) & 1U) == 0);
    }
}

TEST_CASE("an interruption ends the program and what it has started") {
    const int signal = GENERATE(SIGINT, SIGQUIT, SIGTERM, SIGHUP);
    INFO(signal);
    std::signal(SIGHUP, SIG_DFL);  // it may be ignored, by whom the test is started
    set_up_process();
    {
        const InterruptionsHeld held;
        std::thread sender([signal] {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            std::raise(signal);
        });
        // NOTE: the inner one would hold the output open for longer than a test may take.
        CHECK_THROWS_AS(run_child({"sh", "-c", "sleep 1000 & sleep 1000"}, "."), Interruption);
        sender.join();
        char byte = 0;
        CHECK(::read(interruption_descriptor(), &byte, 1) == 1);  // seen: the program goes on
    }
    CHECK(interruption_descriptor() < 0);
}
