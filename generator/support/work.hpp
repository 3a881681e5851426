// Limits on the work of a computation, and its interruption.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// Thrown by spend_work() beyond a limit, to the function that set it.
struct WorkLimitReached {};

/// Limits the work that this thread may spend while it lives. NOTE: a limit is never in seconds, so
/// that one input has one output on all machines.
class WorkLimit {
public:
    /// Precondition: this thread has no limit yet.
    explicit WorkLimit(double most);
    ~WorkLimit();
    WorkLimit(const WorkLimit&) = delete;
    WorkLimit& operator=(const WorkLimit&) = delete;
};

/// Work that takes a second, or some seconds, on present machines.
constexpr double work_of_a_second = 1e6;

/// Counts units of work; the inner loops of exact computations call it. A unit is an operation on a
/// term of a sum, which takes a microsecond or less. Throws WorkLimitReached beyond the limit of a
/// WorkLimit, and Interruption where one is held.
void spend_work(double units = 1);

}  // namespace hvi::gen
