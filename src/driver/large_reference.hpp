// A solution that runs of a scene of any size are measured against.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp; its Stepper computes in numbers with more digits than double.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <driver/answer.hpp>
#include <driver/guarded.hpp>
#include <driver/reference.hpp>
#include <driver/state_file.hpp>
#include <driver/pace.hpp>

namespace hvi::driver {

/// Returns the number of steps to begin with: a run of twice as many steps has to fit in the time,
/// too.
template <class Problem>
[[nodiscard]] std::int64_t affordable(const ReferenceWishes& wishes) {
    const double h = wishes.until / static_cast<double>(wishes.steps);
    const double each = seconds_of_step<Problem>(Watch::rows, h, std::min(wishes.steps, {8}));
    const double most = std::floor(wishes.seconds / 4 / each);
    return most < static_cast<double>(wishes.steps) ? std::max<std::int64_t>(1, std::llround(most))
                                                    : wishes.steps;
}

/// Computes the reference, and writes its end into a file. Returns a status of large_main().
template <class Problem>
int tell_reference(ReferenceWishes wishes, const char* path) {
    wishes.steps = affordable<Problem>(wishes);
    const auto found = ReferenceRun<Problem>(wishes).run();
    if (found.end && !write_state(path, *found.end)) { return 3; }
    say("bits", static_cast<std::int64_t>(detail::bits<typename Problem::Stepper::Scalar>));
    if (found.end) { say("error", found.error); }
    return 0;
}

/// The main() of a program that is called as `program UNTIL STEPS WANTED SECONDS FILE`, and writes
/// the end of the run into the file; or, called as `program FILE`, its start.
template <class Problem>
int large_reference(int argc, char** argv) {
    ReferenceWishes wishes;
    if (argc == 2) {
        return guarded([&] { return write_state(argv[1], Problem::initial()) ? 0 : 3; });
    }
    if (argc == 6 && wishes.read_words(argv + 1)) {
        return guarded([&] { return tell_reference<Problem>(wishes, argv[5]); });
    }
    std::fprintf(stderr, "usage: %s UNTIL STEPS WANTED SECONDS FILE\n       %s FILE\n", argv[0],
                 argv[0]);
    return 2;
}

}  // namespace hvi::driver
