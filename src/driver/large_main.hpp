// The main() of programs that run scenes of any size.
// SPDX-License-Identifier: MIT
//
// `Problem` is as in main.hpp.
#pragma once

#include <cstdio>
#include <new>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <driver/large_measure.hpp>
#include <driver/trajectory.hpp>

namespace hvi::driver {

/// What a program ends with that has not enough memory, or of whose files one cannot be read.
inline constexpr int out_of_memory = 4, cannot_read = 5;

/// Runs it, and says what becomes of it where that throws.
template <class Work>
int guarded(Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) { return out_of_memory; } catch (const std::runtime_error& e) {
        say("unreadable", e.what());
        return cannot_read;
    }
}

template <class Problem>
int large_main(int argc, char** argv) {
    std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const std::string_view command = words.empty() ? std::string_view() : words.front();
    if (!words.empty()) { words.erase(words.begin()); }
    const int status = guarded([&] {
        if (command == "trajectory") { return trajectory<Problem, Watch::rows>(words); }
        if (command == "measure") { return large_measure<Problem>(words); }
        if (command == "departures") { return large_departures<Problem>(words); }
        return command == "pace" ? large_pace<Problem>(words) : 2;
    });
    if (status == 2) {
        std::fprintf(stderr, "usage: trajectory H STEPS (EVERY COLUMNS FILE)...\n"
                             "       measure H STEPS SECONDS UNTIL FILE\n"
                             "       departures H STEPS SAMPLES\n"
                             "       pace H STEPS\n");
    }
    return status;
}

}  // namespace hvi::driver
