// Chunks that are handed out to ranks.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/ensembles/chunk_queue.hpp"

using namespace hvi::gen;

namespace {

using Answers = std::vector<std::pair<int, std::int64_t>>;

Answers told(ChunkQueue& queue, int rank, std::int64_t message) {
    Answers answers;
    for (const auto& [to, chunk] : queue.take(rank, message)) answers.emplace_back(to, chunk);
    return answers;
}

}  // namespace

TEST_CASE("chunks are handed out in their order, and an end to each rank") {
    ChunkQueue queue({7, 8, 9}, 3);
    CHECK(told(queue, 2, wants_chunk) == Answers{{2, 7}});
    CHECK(queue.next() == 8);
    CHECK(told(queue, 1, wants_chunk) == Answers{{1, 9}});
    CHECK(!queue.next());
    CHECK(!queue.is_over());  // ranks may give their chunks back
    CHECK(told(queue, 2, wants_chunk).empty());
    CHECK(!queue.is_over());
    CHECK(told(queue, 1, wants_chunk) == Answers{{1, no_chunk}, {2, no_chunk}});
    CHECK(queue.is_over());
    CHECK(queue.is_alone());
}

TEST_CASE("a chunk that is given back goes to a rank that waits") {
    ChunkQueue queue({7, 8}, 3);
    CHECK(told(queue, 1, wants_chunk) == Answers{{1, 7}});
    CHECK(told(queue, 1, wants_chunk) == Answers{{1, 8}});
    CHECK(told(queue, 2, wants_chunk).empty());
    CHECK(told(queue, 1, leaves).empty());
    CHECK(told(queue, 1, 8) == Answers{{2, 8}});
    CHECK(!queue.is_alone());
    CHECK(told(queue, 2, wants_chunk) == Answers{{2, no_chunk}});
    CHECK(queue.is_alone());
}

TEST_CASE("a chunk that is given back goes to rank 0 where no other waits") {
    ChunkQueue queue({7}, 2);
    CHECK(told(queue, 1, wants_chunk) == Answers{{1, 7}});
    CHECK(!queue.next());
    CHECK(told(queue, 1, 7).empty());
    CHECK(queue.is_alone());
    CHECK(!queue.is_over());
    CHECK(queue.next() == 7);
    CHECK(queue.is_over());
}

TEST_CASE("a rank that leaves while it waits is told at once") {
    ChunkQueue queue({7, 8}, 3);
    CHECK(told(queue, 1, wants_chunk) == Answers{{1, 7}});
    CHECK(told(queue, 2, wants_chunk) == Answers{{2, 8}});
    CHECK(told(queue, 1, wants_chunk).empty());
    CHECK(told(queue, 1, leaves) == Answers{{1, no_chunk}});
    CHECK(told(queue, 1, leaves).empty());
    CHECK(told(queue, 2, wants_chunk) == Answers{{2, no_chunk}});
    CHECK(told(queue, 2, leaves).empty());
    CHECK(queue.is_alone());
}

TEST_CASE("one rank alone, and no chunks at all") {
    ChunkQueue alone({7}, 1);
    CHECK(alone.is_alone());
    CHECK(alone.next() == 7);
    CHECK(alone.is_over());
    ChunkQueue empty({}, 2);
    CHECK(empty.is_over());
    CHECK(told(empty, 1, wants_chunk) == Answers{{1, no_chunk}});
}
