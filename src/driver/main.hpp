// The main() of programs that hvi-gen compiles and calls.
// SPDX-License-Identifier: MIT
//
// `Problem` names its Stepper and has static members stepper() and initial(), which make one and
// its first state, values(stepper, x), the invariants there, and their names `invariants`.
#pragma once

#include <cstdio>
#include <string_view>
#include <vector>

#include <driver/departures.hpp>
#include <driver/measure.hpp>
#include <driver/trajectory.hpp>

namespace hvi::driver {

template <class Problem>
int main(int argc, char** argv) {
    std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const std::string_view command = words.empty() ? std::string_view() : words.front();
    if (!words.empty()) { words.erase(words.begin()); }
    int status = 2;
    if (command == "trajectory") { status = trajectory<Problem>(words); }
    if (command == "measure") { status = measure<Problem>(words); }
    if (command == "departures") { status = departures<Problem>(words); }
    if (status == 2) {
        std::fprintf(stderr, "usage: trajectory H STEPS (EVERY COLUMNS FILE)...\n"
                             "       measure H STEPS SECONDS\n"
                             "       departures H STEPS SAMPLES\n");
    }
    return status;
}

}  // namespace hvi::driver
