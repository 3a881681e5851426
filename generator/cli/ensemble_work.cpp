// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/ensemble_work.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <numeric>

#include <driver/answer.hpp>
#include <driver/guarded.hpp>

#include "generator/drive/checkpoint_saver.hpp"
#include "generator/drive/drive.hpp"
#include "generator/ensembles/claims.hpp"
#include "generator/ensembles/worker.hpp"
#include "generator/support/bar.hpp"
#include "generator/support/child.hpp"
#include "generator/support/pace.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

/// Reports numbers of finished rows ten times a second.
class Reports {
public:
    ~Reports() { tell(); }
    void operator()(std::int64_t rows) {
        rows_ += rows;
        if (Clock::now() - last_ > std::chrono::milliseconds(100)) tell();
    }

private:
    using Clock = std::chrono::steady_clock;

    void tell() {
        driver::say("rows", rows_);
        last_ = Clock::now();
    }

    std::int64_t rows_ = 0;
    Clock::time_point last_ = Clock::now();
};

/// A worker process: takes chunks until there are no more for it, or SIGTERM comes. Returns its
/// exit status.
int work_on(const Study& study, StudyRows& rows) {
    heed_signals();
    Reports reports;
    try {
        return driver::guarded([&] {
            LockClaims claims(study);
            while (const auto chunk = claims.next()) {
                const bool is_whole = compute_chunk(
                    study, *chunk,
                    [&](std::int64_t first, std::int64_t count) { return rows.from(first, count); },
                    [&](std::int64_t count) { reports(count); });
                if (!is_whole || is_stopped()) break;
            }
            return 0;
        });
    } catch (const detail::SolverIsApart&) { return solver_is_apart; }
}

/// Hears the workers, and shows how far all of them are.
class Hearing {
public:
    Hearing(const Study& study, std::size_t workers)
        : all_(study.rows), finished_(workers), pace_(static_cast<double>(study.rows), "rows") {
        for (std::int64_t chunk = 0; chunk < study.chunks(); ++chunk)
            if (is_done(study, chunk)) before_ += study.rows_of(chunk);
    }

    void hear(std::size_t worker, std::string_view line) {
        const std::size_t blank = line.find(' ');
        const std::string_view key = line.substr(0, blank);
        if (key == "unreadable") fault_ = line.substr(std::min(blank + 1, line.size()));
        if (key != "rows") return;
        std::from_chars(line.data() + blank + 1, line.data() + line.size(), finished_[worker]);
        const std::int64_t rows = std::accumulate(finished_.begin(), finished_.end(), before_);
        const double part = std::min(1.0, static_cast<double>(rows) / static_cast<double>(all_));
        bar_.show(part, pace_.at(part, Pace::Clock::now()));
    }

    [[nodiscard]] const std::string& fault() const { return fault_; }

private:
    std::int64_t all_, before_ = 0;
    std::vector<std::int64_t> finished_;
    std::string fault_;
    Bar bar_;
    Pace pace_;
};

/// Throws where a worker has failed. Returns whether one calls for solvers that are not compiled.
bool are_solvers_apart(const std::vector<ChildResult>& workers, const std::string& fault) {
    bool result = false;
    for (const ChildResult& worker : workers) {
        if (worker.status == solver_is_apart) result = true;
        if (worker.ok() || worker.status == solver_is_apart) continue;
        if (worker.status == driver::out_of_memory)
            throw EnvironmentError("there is not enough memory for the rows");
        if (worker.status > 128)
            throw EnvironmentError(
                fmt::format("a worker was ended by signal {}", worker.status - 128),
                "finished chunks are kept, and the same command goes on with them");
        throw EnvironmentError(fault.empty() ? worker.errors : fault);
    }
    return result;
}

/// SIGUSR1, by which Slurm warns of the end, asks for the end of the work.
void heed_warning() {
    std::signal(SIGUSR1, [](int) { std::raise(SIGTERM); });
}

}  // namespace

Targets targets_of(const EnsembleWork& work, Runner& runner) {
    runner.begin(work.stepper);
    if (work.directions) runner.begin(work.directions->stepper);
    if (work.at_once) runner.begin(work.at_once->stepper);
    Targets targets{runner.target(work.stepper)};
    if (work.directions) targets.directions = runner.target(work.directions->stepper);
    if (work.at_once) targets.at_once = runner.library(work.at_once->stepper);
    return targets;
}

bool compute(const Study& study, const EnsembleWork& work, const RowSource& source,
             std::size_t workers, Runner& runner) {
    const Targets targets = targets_of(work, runner);
    heed_warning();
    for (;;) {
        Hearing hearing(study, workers);
        const std::vector<ChildResult> ended = run_children(
            workers,
            [&](std::size_t) {
                RowSource own = source.again();
                StudyRows rows(work, own, targets.families());
                return work_on(study, rows);
            },
            [&](std::size_t worker, std::string_view line) { hearing.hear(worker, line); });
        if (!are_solvers_apart(ended, hearing.fault())) return !is_interrupted();
        if (!targets.compile_solvers()) throw solver_is_missing();
    }
}

}  // namespace hvi::gen
