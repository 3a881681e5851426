// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/mpi.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "generator/ensembles/chunk_queue.hpp"
#include "generator/ensembles/embedded.hpp"
#include "generator/program/cache.hpp"
#include "generator/program/compiler.hpp"
#include "generator/support/error.hpp"
#include "generator/support/process.hpp"
#include "generator/support/thread.hpp"

namespace hvi::gen {

namespace {

using Work = std::function<bool(std::int64_t chunk)>;

/// Lets others compute. NOTE: functions of MPI that wait keep their processor busy.
void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// Loads the library, which stays. NOTE: with its symbols for all, as parts of Open MPI look for
/// those of others.
const driver::MpiFunctions& mpi_functions() {
    const CacheDirectory cache;
    const ProgramText text{.main = std::string(embedded_mpi().front().text),
                           .headers = {},
                           .artifact = Artifact::library};
    const std::string path = built_program(cache, find_mpi_compiler(), text).string();
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr)
        throw EnvironmentError(fmt::format("the library of MPI cannot be loaded: {}", ::dlerror()));
    const void* const found = ::dlsym(library, "hvi_mpi_functions");
    HVI_CHECK(found != nullptr);
    return *static_cast<const driver::MpiFunctions*>(found);
}

/// Throws where a starter of processes says that there are several, and MPI that there is one.
void check_starter(const MpiRank& rank) {
    if (rank.count() > 1) return;
    for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        const char* const value = std::getenv(name);
        if (value != nullptr && std::atoi(value) > 1)
            throw EnvironmentError(
                "these processes are started by another MPI than mpicxx belongs to",
                "MPICXX names the compiler: MPICXX=mpicxx.openmpi, or mpicxx.mpich");
    }
}

/// Chunks on rank 0, and its own work on them in a thread.
class OwnWork {
public:
    OwnWork(ChunkQueue& queue, const Work& work)
        : queue_(queue), work_(work), thread_(start_thread([this] { run(); })) {
        if (!thread_.joinable()) throw EnvironmentError("cannot start a thread");
    }
    ~OwnWork() {
        if (thread_.joinable()) thread_.join();
    }
    OwnWork(const OwnWork&) = delete;
    OwnWork& operator=(const OwnWork&) = delete;

    /// Calls the function while the thread leaves the queue alone.
    template <class Function>
    auto with_queue(Function&& function) {
        const std::lock_guard lock(mutex_);
        changed_.notify_one();
        return function(queue_);
    }

    /// Throws what the work has thrown.
    [[nodiscard]] bool is_over() {
        const std::lock_guard lock(mutex_);
        if (failure_) std::rethrow_exception(failure_);
        return is_over_;
    }

private:
    void run() {
        try {
            while (const std::optional<std::int64_t> chunk = next())
                if (!work_(*chunk)) break;
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }

    /// Waits for a chunk; empty where none can come.
    std::optional<std::int64_t> next() {
        std::unique_lock lock(mutex_);
        while (!is_interrupted()) {
            if (const std::optional<std::int64_t> chunk = queue_.next()) return chunk;
            if (queue_.is_over()) break;
            changed_.wait_for(lock, std::chrono::milliseconds(100));
        }
        return {};
    }

    ChunkQueue& queue_;
    const Work& work_;
    std::mutex mutex_;  ///< for the queue and the members below
    std::condition_variable changed_;
    std::exception_ptr failure_;
    bool is_over_ = false;
    std::thread thread_;  ///< last: it uses the members above
};

/// Writes an error of one rank to standard error. Returns the exit status.
int report(const MpiRank& rank, const std::exception& error) {
    const auto* const known = dynamic_cast<const Error*>(&error);
    std::fputs(
        (known != nullptr ? message(*known) : fmt::format("error: {}\n", error.what())).c_str(),
        stderr);
    std::fputs(
        fmt::format("this is rank {} of {}, and the end of all\n", rank.number(), rank.count())
            .c_str(),
        stderr);
    return static_cast<int>(known != nullptr ? known->status() : ExitStatus::bug);
}

}  // namespace

MpiRank::MpiRank(const driver::MpiFunctions& call) : call_(call) { call_.start(&number_, &count_); }

void MpiRank::meet() const {
    call_.begin_to_meet();
    while (!call_.have_met()) rest();
}

void MpiRank::hand_out(const std::vector<std::int64_t>& chunks, const Work& work) const {
    if (number_ == 0)
        serve(chunks, work);
    else
        ask(work);
}

void MpiRank::serve(const std::vector<std::int64_t>& chunks, const Work& work) const {
    ChunkQueue queue(chunks, count_);
    OwnWork own(queue, work);
    const auto is_alone = [](const ChunkQueue& all) { return all.is_alone(); };
    while (!own.is_over() || !own.with_queue(is_alone)) {
        std::int64_t said = 0;
        const int rank = call_.receive(&said);
        if (rank < 0) {
            rest();
            continue;
        }
        for (const auto& [to, chunk] :
             own.with_queue([&](ChunkQueue& all) { return all.take(rank, said); }))
            call_.send(to, chunk);
    }
}

std::int64_t MpiRank::answer() const {
    std::int64_t chunk = 0;
    while (call_.receive(&chunk) < 0) rest();
    return chunk;
}

void MpiRank::ask(const Work& work) const {
    call_.send(0, wants_chunk);
    for (std::int64_t chunk = answer(); chunk != no_chunk;) {
        if (is_interrupted()) return call_.send(0, chunk);
        call_.send(0, wants_chunk);
        const bool goes_on = work(chunk);
        if (!goes_on) call_.send(0, leaves);
        chunk = answer();
        if (!goes_on) return chunk == no_chunk ? void() : call_.send(0, chunk);
    }
}

void under_mpi(const std::function<void(const MpiRank&)>& action) {
    const driver::MpiFunctions& call = mpi_functions();
    const MpiRank rank(call);
    try {
        check_starter(rank);
        action(rank);
        rank.meet();
    } catch (const std::exception& error) {
        if (rank.count() > 1) call.abort(report(rank, error));
        call.end();
        throw;
    }
    call.end();
}

}  // namespace hvi::gen
