// Chunks that are handed out to ranks, each to one of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace hvi::gen {

/// Messages of ranks to rank 0, beside the number of a chunk that is given back, and an answer.
enum ChunkMessage : std::int64_t {
    wants_chunk = -1,  ///< the rank begins the chunk that it has, and asks for the next one
    leaves = -2,       ///< the rank wants no more
    no_chunk = -1,     ///< an answer: there is nothing more
};

/// The chunks on rank 0. A rank has at most one chunk that it has not begun. It gives that back
/// where it leaves early; then nobody has been told before that there is nothing more.
class ChunkQueue {
public:
    /// An answer to a rank: a chunk, or `no_chunk`, which is the last one.
    struct Answer {
        int rank = 0;
        std::int64_t chunk = no_chunk;
    };

    /// Ranks are counted from 0 on; rank 0 asks by next() alone. Precondition: no chunk is
    /// negative.
    ChunkQueue(const std::vector<std::int64_t>& chunks, int ranks);

    /// Takes a message of another rank. Returns answers, also to ranks that have waited.
    [[nodiscard]] std::vector<Answer> take(int rank, std::int64_t message);

    /// Returns a chunk for rank 0, which begins it.
    [[nodiscard]] std::optional<std::int64_t> next();

    /// Whether no chunk can come any more.
    [[nodiscard]] bool is_over() const;

    /// Whether all other ranks have left.
    [[nodiscard]] bool is_alone() const;

private:
    enum class State { computes, waits, has_another, is_gone };

    [[nodiscard]] State& state(int rank) { return states_[static_cast<std::size_t>(rank)]; }
    void answer_waiting(std::vector<Answer>& answers);

    std::deque<std::int64_t> chunks_;
    std::vector<State> states_;
};

}  // namespace hvi::gen
