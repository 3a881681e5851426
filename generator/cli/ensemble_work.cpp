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

std::vector<std::string> EnsembleWork::events() const {
    std::vector<std::string> names;
    for (const IndexedEvent& event : scene.events) names.push_back(event.name);
    return names;
}

bool EnsembleWork::has_energy() const {
    const std::vector<std::string> names = conserved_names(stepper.system);
    return !names.empty() && names.front() == "energy";
}

namespace {

/// The steppers of a study.
struct Families {
    StepperFamily steppers;
    StepperFamily directions = nullptr;
};

/// Computes rows of a study one after the other.
class Rows {
public:
    Rows(const EnsembleWork& work, RowSource& source, Families families)
        : work_(work), source_(source), families_(std::move(families)) {}

    [[nodiscard]] std::optional<std::vector<double>> at(std::int64_t number) {
        const std::vector<double> values = source_.at(number);
        const std::optional<RowEnd> end = end_of(values);
        if (!end) return {};
        std::vector<double> row{static_cast<double>(number)};
        row.insert(row.end(), values.begin(), values.end());
        add(*end, row);
        return row;
    }

private:
    /// Returns the end of a row; that of one which takes no steps has no numbers.
    [[nodiscard]] std::optional<RowEnd> end_of(const std::vector<double>& values) const {
        const RowData data = work_.plan.at(values);
        if (data.fault != RowStatus::ok) return none(data.fault);
        RowStart start{.make = families_.steppers(data.numbers),
                       .h = data.h,
                       .steps = data.steps,
                       .clock = data.clock,
                       .events = data.events};
        if (work_.directions)
            start.make_directions = families_.directions(work_.directions->plan.at(values).numbers);
        return take_row(work_.wishes, start);
    }

    [[nodiscard]] RowEnd none(RowStatus fault) const {
        constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
        return {.status = static_cast<std::size_t>(fault),
                .t = 0,
                .columns = std::vector<double>(work_.wishes.columns.size(), nothing),
                .energy_error = nothing,
                .events = std::vector<std::int64_t>(work_.scene.events.size()),
                .reduced = std::vector<double>(work_.wishes.reductions.size(), nothing),
                .lyapunov = nothing,
                .megno = nothing};
    }

    /// Adds what there is of an end, in the order of the columns of a study.
    void add(const RowEnd& end, std::vector<double>& row) const {
        row.insert(row.end(), end.columns.begin(), end.columns.end());
        row.insert(row.end(),
                   {end.t, static_cast<double>(end.status), static_cast<double>(end.steps)});
        if (work_.has_energy()) row.push_back(end.energy_error);
        for (std::size_t k = 0; k < work_.scene.events.size(); ++k)
            row.push_back(static_cast<double>(end.events[k]));
        row.insert(row.end(), end.reduced.begin(), end.reduced.end());
        if (work_.wishes.growth) row.insert(row.end(), {end.lyapunov, end.megno});
    }

    const EnsembleWork& work_;
    RowSource& source_;
    Families families_;
};

/// Reports numbers of finished rows ten times a second.
class Reports {
public:
    ~Reports() { tell(); }
    void operator()() {
        ++rows_;
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
int work_on(const Study& study, Rows& rows) {
    heed_signals();
    Reports reports;
    try {
        return driver::guarded([&] {
            LockClaims claims(study);
            while (const auto chunk = claims.next()) {
                const bool is_whole = compute_chunk(
                    study, *chunk, [&](std::int64_t row) { return rows.at(row); },
                    [&] { reports(); });
                if (!is_whole || is_stopped()) break;
            }
            driver::say("others", claims.held_by_others());
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

bool compute(const Study& study, const EnsembleWork& work, const RowSource& source,
             std::size_t workers, Runner& runner) {
    const auto begin = [&](const SceneStepper& stepper) { runner.begin(stepper); };
    begin(work.stepper);
    if (work.directions) begin(work.directions->stepper);
    const Target target = runner.target(work.stepper);
    std::optional<Target> of_directions;
    if (work.directions) of_directions = runner.target(work.directions->stepper);
    heed_warning();
    for (;;) {
        Hearing hearing(study, workers);
        const std::vector<ChildResult> ended = run_children(
            workers,
            [&](std::size_t) {
                RowSource own = source.again();
                Rows rows(work, own,
                          {steppers_of(target),
                           of_directions ? steppers_of(*of_directions) : StepperFamily()});
                return work_on(study, rows);
            },
            [&](std::size_t worker, std::string_view line) { hearing.hear(worker, line); });
        if (!are_solvers_apart(ended, hearing.fault())) break;
        runner.compile_solvers(target);
    }
    return !is_interrupted();
}

}  // namespace hvi::gen
