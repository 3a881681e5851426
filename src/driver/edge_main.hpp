// The main() of programs that test steps at edges.
// SPDX-License-Identifier: MIT
//
// For `Problem` see edge_steps.hpp. A program that takes longer than its limit is ended by SIGALRM.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string_view>
#include <vector>

#include <driver/edge_energy.hpp>
#include <driver/edge_steps.hpp>

namespace hvi::driver {

inline constexpr unsigned edge_seconds = 60;  ///< the limit

template <class Problem>
int edge_main(int argc, char** argv) {
    ::alarm(edge_seconds);
    std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const std::string_view command = words.empty() ? std::string_view() : words.front();
    if (!words.empty()) { words.erase(words.begin()); }
    int status = 2;
    if (command == "start") { status = start<Problem>(words); }
    if (command == "advance") { status = advance<Problem>(words); }
    if (command == "return") { status = there_and_back<Problem>(words); }
    if (command == "energy") { status = energy<Problem>(words); }
    if (command == "forgetful-energy") { status = energy<Forgetful<Problem>>(words); }
    if (status == 2) {
        std::fprintf(stderr, "usage: start\n"
                             "       advance H STEPS [STATE... [VALUES...]]\n"
                             "       return H STEPS [STATE... [VALUES...]]\n"
                             "       [forgetful-]energy H STEPS [STATE... [VALUES...]]\n");
    }
    return status;
}

}  // namespace hvi::driver
