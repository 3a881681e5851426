// Calls of MPI, between hvi-gen and a library that the MPI of a machine compiles.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hvi::driver {

/// Messages are single numbers. One thread calls these functions; MPI ends all ranks where a call
/// fails.
struct MpiFunctions {
    void (*start)(int* rank, int* ranks);
    void (*send)(int to, std::int64_t number);
    /// Takes a message if one has come. Returns the rank that has sent it; else -1.
    int (*receive)(std::int64_t* number);
    void (*begin_to_meet)();
    /// Returns whether all ranks have begun to meet.
    bool (*have_met)();
    void (*end)();
    void (*abort)(int status);
};

}  // namespace hvi::driver
