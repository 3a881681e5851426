// Teams of threads.
// SPDX-License-Identifier: GPL-2.0-or-later

#include <chrono>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/loops/team.hpp>

namespace {

using hvi::detail::Team;

/// How often each piece was done.
std::vector<int> done(Team& team, std::size_t pieces) {
    std::vector<int> times(pieces, 0);
    team.run(pieces, [&](std::size_t piece) { ++times[piece]; });
    return times;
}

TEST_CASE("a team does each piece once, run after run") {
    const unsigned threads = GENERATE(1U, 2U, 3U, 7U);
    Team team(threads);
    REQUIRE(team.threads() == threads);
    for (int run = 0; run < 2000; ++run) {
        const std::size_t pieces = static_cast<std::size_t>(run % 20);
        if (done(team, pieces) != std::vector<int>(pieces, 1)) { FAIL("run " << run); }
    }
}

TEST_CASE("what a run has written the next one reads, on whatever thread") {
    Team team(3);
    std::vector<std::size_t> sums(16, 1);
    std::vector<std::size_t> next(16);
    for (int run = 0; run < 50; ++run) {
        team.run(16, [&](std::size_t i) { next[i] = (sums[i] + sums[15 - i]) % 1000003; });
        team.run(16, [&](std::size_t i) { sums[i] = next[i]; });
    }
    std::size_t expected = 1;
    for (int run = 0; run < 50; ++run) { expected = expected * 2 % 1000003; }
    CHECK(sums == std::vector<std::size_t>(16, expected));
}

TEST_CASE("a team wakes up from its sleep") {
    Team team(4);
    CHECK(done(team, 9) == std::vector<int>(9, 1));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK(done(team, 9) == std::vector<int>(9, 1));
}

TEST_CASE("more threads than one take part") {
    Team team(2);
    std::mutex mutex;
    std::set<std::thread::id> seen;
    team.run(2, [&](std::size_t) {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            seen.insert(std::this_thread::get_id());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    });
    CHECK(seen.size() == 2);
}

TEST_CASE("a copy of a team is a team of its own") {
    Team team(2);
    CHECK(done(team, 5) == std::vector<int>(5, 1));
    Team copy = team;
    CHECK(copy.threads() == 2);
    // Each may run while the other does.
    std::vector<int> inner(5, 0);
    team.run(2, [&](std::size_t piece) {
        if (piece == 0) {
            copy.run(5, [&](std::size_t i) { ++inner[i]; });
        }
    });
    CHECK(inner == std::vector<int>(5, 1));
    copy = Team(3);
    CHECK(copy.threads() == 3);
    CHECK(done(copy, 5) == std::vector<int>(5, 1));
    CHECK(done(team, 5) == std::vector<int>(5, 1));
}

TEST_CASE("no number of threads means as many as there are processors") {
    Team team(0);
    CHECK(team.threads() >= 1);
    CHECK(done(team, 5) == std::vector<int>(5, 1));
}

}  // namespace
