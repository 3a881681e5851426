// How much work a computation may take, and whether anybody still waits for it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// Thrown by spend_work() beyond a limit, for whoever set it.
struct WorkLimitReached {};

/// While it lives, this thread may spend so much work. NOTE: a limit is never in seconds, so that
/// one input has one output on all machines.
class WorkLimit {
public:
    /// Precondition: this thread has no limit yet.
    explicit WorkLimit(double most);
    ~WorkLimit();
    WorkLimit(const WorkLimit&) = delete;
    WorkLimit& operator=(const WorkLimit&) = delete;
};

/// Work that takes a second, or some seconds, on the machines of these years.
constexpr double work_of_a_second = 1e6;

/// Said in the inner loops of exact computations: so many units are being done, of which one is an
/// operation on a term of a sum, in a microsecond or less. Throws WorkLimitReached where that is
/// more than a WorkLimit allows for, and Interruption where one is held and nobody waits any more.
void spend_work(double units = 1);

}  // namespace hvi::gen
