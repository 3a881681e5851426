// The main() of programs that run scenes of any size.
// SPDX-License-Identifier: MIT
//
// `Problem` is as in main.hpp.
#pragma once

#include <cstdio>
#include <exception>
#include <string_view>
#include <vector>

#include <driver/trajectory.hpp>

namespace hvi::driver {

template <class Problem>
int large_main(int argc, char** argv) {
    std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const bool is_right = !words.empty() && words.front() == "trajectory";
    if (is_right) {
        words.erase(words.begin());
        try {
            const int status = trajectory<Problem, Watch::rows>(words);
            if (status != 2) { return status; }
        } catch (const std::bad_alloc&) {
            std::fputs("out of memory\n", stderr);
            return out_of_memory;
        }
    }
    std::fprintf(stderr, "usage: trajectory H STEPS (EVERY COLUMNS FILE)...\n");
    return 2;
}

}  // namespace hvi::driver
