// The main() of programs that run scenes of any size.
// SPDX-License-Identifier: MIT
//
// `Problem` is as in main.hpp.
#pragma once

#include <cstdio>
#include <new>
#include <string_view>
#include <vector>

#include <driver/large_measure.hpp>
#include <driver/trajectory.hpp>

namespace hvi::driver {

/// What a program ends with that has not enough memory.
inline constexpr int out_of_memory = 4;

template <class Problem>
int large_main(int argc, char** argv) {
    std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const std::string_view command = words.empty() ? std::string_view() : words.front();
    if (!words.empty()) { words.erase(words.begin()); }
    int status = 2;
    try {
        if (command == "trajectory") { status = trajectory<Problem, Watch::rows>(words); }
        if (command == "measure") { status = large_measure<Problem>(words); }
        if (command == "departures") { status = large_departures<Problem>(words); }
        if (command == "pace") { status = large_pace<Problem>(words); }
    } catch (const std::bad_alloc&) { return out_of_memory; }
    if (status == 2) {
        std::fprintf(stderr, "usage: trajectory H STEPS EVERY COLUMNS FILE\n"
                             "       measure H STEPS SECONDS UNTIL FILE\n"
                             "       departures H STEPS SAMPLES\n"
                             "       pace H STEPS\n");
    }
    return status;
}

}  // namespace hvi::driver
