// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <csignal>

#include "generator/cli/ensemble_work.hpp"
#include "generator/drive/checkpoint_saver.hpp"
#include "generator/ensembles/mpi.hpp"
#include "generator/ensembles/study_rows.hpp"
#include "generator/ensembles/worker.hpp"
#include "generator/support/bar.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Lets any signal that asks for the end stop the row that is being computed.
void heed_all_signals() {
    heed_signals();
    for (const int signal : {SIGINT, SIGQUIT, SIGUSR1})
        std::signal(signal, [](int) { std::raise(SIGTERM); });
}

/// Computes the chunks that are handed to this rank, and on rank 0 shows how many are handed out.
void compute_on(const MpiRank& rank, const Study& study, StudyRows& rows) {
    const std::vector<std::int64_t> todo = missing_chunks(study);
    Bar bar;
    rank.hand_out(todo, [&](std::int64_t chunk) {
        const auto place = std::lower_bound(todo.begin(), todo.end(), chunk) - todo.begin();
        if (rank.number() == 0)
            bar.show(static_cast<double>(place) / static_cast<double>(todo.size()));
        return compute_chunk(
            study, chunk,
            [&](std::int64_t first, std::int64_t count) { return rows.from(first, count); },
            [](std::int64_t) {});
    });
}

}  // namespace

void compute_by_ranks(const Study& study, const EnsembleWork& work, const RowSource& source,
                      Runner& runner, const std::function<void()>& finish) {
    const Targets targets = targets_of(work, runner);
    targets.compile_solvers();  // as ranks do not begin anew where they are missing
    under_mpi([&](const MpiRank& rank) {
        if (rank.number() == 0) begin(study);
        rank.meet();
        heed_all_signals();
        RowSource own = source.again();
        StudyRows rows(work, own, targets.families());
        compute_on(rank, study, rows);
        rank.meet();
        if (rank.number() == 0 && !is_stopped()) finish();
    });
    if (is_stopped()) throw Interruption();
}

}  // namespace hvi::gen
