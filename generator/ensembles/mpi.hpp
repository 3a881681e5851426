// Work that ranks of mpirun share. hvi-gen is not linked with MPI: the compiler of MPI on the
// machine makes a small library, which is loaded.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <driver/mpi_functions.hpp>

namespace hvi::gen {

/// This process among those of mpirun. Its functions are called by one thread.
class MpiRank {
public:
    explicit MpiRank(const driver::MpiFunctions& call);

    /// Returns the number of this rank, from 0 on.
    [[nodiscard]] int number() const { return number_; }
    [[nodiscard]] int count() const { return count_; }

    /// Waits until all ranks are here.
    void meet() const;

    /// Hands the chunks of rank 0 out; those that other ranks name do not count. Each is given to
    /// one rank, which calls `work` with it: on rank 0 in a thread, as its main thread answers the
    /// others. A rank asks for its next chunk before it begins one, so that it does not wait.
    ///
    /// Where `work` returns false, or a held interruption has come, the rank gets no more chunks,
    /// and the others go on; the chunk that it was at counts as handed out. Returns on each rank
    /// when that has no more to do, on rank 0 when no rank has. Throws what `work` throws.
    /// Precondition: no chunk is negative.
    void hand_out(const std::vector<std::int64_t>& chunks,
                  const std::function<bool(std::int64_t chunk)>& work) const;

private:
    void serve(const std::vector<std::int64_t>& chunks,
               const std::function<bool(std::int64_t chunk)>& work) const;
    void ask(const std::function<bool(std::int64_t chunk)>& work) const;
    [[nodiscard]] std::int64_t answer() const;

    const driver::MpiFunctions& call_;
    int number_ = 0, count_ = 1;
};

/// Starts MPI, calls the function on each rank, and returns when it has returned on all of them. An
/// exception on one of several ranks ends all: it is written to standard error, and becomes the
/// exit status. Of one rank alone it is thrown. Throws EnvironmentError, too, where there is no
/// compiler of MPI, its library cannot be loaded, or mpirun is of another MPI. Call it once in a
/// process.
void under_mpi(const std::function<void(const MpiRank&)>& action);

}  // namespace hvi::gen
