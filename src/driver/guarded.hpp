// The end of a program that has not enough memory, or whose files cannot be read.
// SPDX-License-Identifier: MIT
#pragma once

#include <new>
#include <stdexcept>

#include <driver/answer.hpp>

namespace hvi::driver {

/// Exit statuses for too little memory, and for a file that cannot be read.
inline constexpr int out_of_memory = 4, cannot_read = 5;

/// Runs work(). Returns its status, or reports the exception that it throws.
template <class Work>
int guarded(Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) { return out_of_memory; } catch (const std::runtime_error& e) {
        say("unreadable", e.what());
        return cannot_read;
    }
}

}  // namespace hvi::driver
