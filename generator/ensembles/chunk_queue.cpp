// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/chunk_queue.hpp"

#include <algorithm>

namespace hvi::gen {

ChunkQueue::ChunkQueue(const std::vector<std::int64_t>& chunks, int ranks)
    : chunks_(chunks.begin(), chunks.end()),
      states_(static_cast<std::size_t>(ranks), State::computes) {
    state(0) = State::is_gone;
}

std::vector<ChunkQueue::Answer> ChunkQueue::take(int rank, std::int64_t message) {
    std::vector<Answer> answers;
    if (message == wants_chunk) {
        state(rank) = State::waits;
    } else if (message == leaves) {
        // NOTE: an answer to the rank's question may be on its way; a chunk comes back then.
        if (state(rank) == State::waits) {
            state(rank) = State::is_gone;
            answers.push_back({rank, no_chunk});
        }
    } else {
        chunks_.push_front(message);
        state(rank) = State::is_gone;
    }
    answer_waiting(answers);
    return answers;
}

void ChunkQueue::answer_waiting(std::vector<Answer>& answers) {
    for (std::size_t rank = 0; rank < states_.size() && !chunks_.empty(); ++rank) {
        if (states_[rank] != State::waits) continue;
        answers.push_back({static_cast<int>(rank), chunks_.front()});
        chunks_.pop_front();
        states_[rank] = State::has_another;
    }
    if (!is_over()) return;
    for (std::size_t rank = 0; rank < states_.size(); ++rank) {
        if (states_[rank] != State::waits) continue;
        answers.push_back({static_cast<int>(rank), no_chunk});
        states_[rank] = State::is_gone;
    }
}

std::optional<std::int64_t> ChunkQueue::next() {
    if (chunks_.empty()) return {};
    const std::int64_t chunk = chunks_.front();
    chunks_.pop_front();
    return chunk;
}

bool ChunkQueue::is_over() const {
    return chunks_.empty() &&
           std::find(states_.begin(), states_.end(), State::has_another) == states_.end();
}

bool ChunkQueue::is_alone() const {
    return std::all_of(states_.begin(), states_.end(),
                       [](State state) { return state == State::is_gone; });
}

}  // namespace hvi::gen
