// Chunks that ranks of mpirun share.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/program/compiler.hpp"
#include "generator/support/child.hpp"
#include "generator/support/error.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/read/scratch.hpp"

using namespace hvi::gen;

namespace {

/// The MPI of this machine: its starter with options, or none.
std::vector<std::string> starter() {
    try {
        const ChildResult answer = run_child({"mpirun", "--version"}, ".");
        if (answer.output.find("Open MPI") == std::string::npos) return {"mpirun"};
        return {"mpirun", "--oversubscribe", "--allow-run-as-root"};
    } catch (const EnvironmentError&) { return {}; }
}

bool has_mpi() {
    if (!starter().empty()) return true;
    WARN("there is no mpirun: what ranks share is not tested");
    return false;
}

/// Lines of each rank, of which the chunks are numbers from 100 on.
struct Shared {
    ChildResult result;
    std::vector<std::vector<std::string>> lines;

    /// The chunks of all ranks, in order.
    [[nodiscard]] std::vector<int> chunks() const {
        std::vector<int> all;
        for (const auto& of_rank : lines)
            for (const std::string& line : of_rank)
                if (line != "end") all.push_back(std::stoi(line));
        std::sort(all.begin(), all.end());
        return all;
    }
    [[nodiscard]] bool all_end() const {
        return std::all_of(lines.begin(), lines.end(), [](const auto& of_rank) {
            return !of_rank.empty() && of_rank.back() == "end";
        });
    }
};

/// Starts so many ranks. NOTE: MPI leaves memory behind, which a sanitizer would report.
Shared shared(int ranks, int chunks, const std::string& how = "works") {
    static const Scratch cache;
    const Scratch place;
    std::vector<std::string> words{"env", "ASAN_OPTIONS=detect_leaks=0",
                                   "OMPI_MCA_btl_vader_single_copy_mechanism=none",
                                   "XDG_CACHE_HOME=" + cache.path.string()};
    for (const std::string& word : starter()) words.push_back(word);
    for (const std::string& word :
         {std::string("-n"), std::to_string(ranks), std::string(HVI_MPI_RANK), place.path.string(),
          std::to_string(chunks), how})
        words.push_back(word);
    Shared all{run_child(words, "."), {}};
    INFO(all.result.errors);
    for (int rank = 0; rank < ranks; ++rank) {
        std::ifstream file(place.path / ("rank-" + std::to_string(rank)));
        all.lines.emplace_back();
        for (std::string line; std::getline(file, line);) all.lines.back().push_back(line);
    }
    return all;
}

std::vector<int> numbers_from_100(int count) {
    std::vector<int> numbers;
    for (int k = 0; k < count; ++k) numbers.push_back(100 + k);
    return numbers;
}

}  // namespace

TEST_CASE("each chunk goes to one rank, and all ranks work") {
    if (!has_mpi()) return;
    for (const int ranks : {1, 2, 4}) {
        const Shared all = shared(ranks, 200);
        INFO(all.result.errors);
        CHECK(all.result.ok());
        CHECK(all.chunks() == numbers_from_100(200));
        CHECK(all.all_end());
        for (const auto& of_rank : all.lines) CHECK(of_rank.size() > 1);
    }
}

TEST_CASE("there may be fewer chunks than ranks, and none") {
    if (!has_mpi()) return;
    for (const int count : {0, 1, 3}) {
        const Shared all = shared(4, count);
        CHECK(all.result.ok());
        CHECK(all.chunks() == numbers_from_100(count));
        CHECK(all.all_end());
    }
}

TEST_CASE("where one rank leaves, or is interrupted, the others go on") {
    if (!has_mpi()) return;
    for (const std::string how : {"leaves", "is interrupted"}) {
        for (const int ranks : {2, 4}) {
            const Shared all = shared(ranks, 60, how);
            CHECK(all.chunks() == numbers_from_100(60));
            CHECK(all.lines.back().size() == 2);  // its first chunk, and the end
            CHECK(all.all_end());
        }
    }
}

TEST_CASE("where all ranks leave, no more chunks are handed out") {
    if (!has_mpi()) return;
    const Shared all = shared(4, 60, "all leave");
    CHECK(all.result.ok());
    CHECK(all.all_end());
    CHECK(all.chunks().size() == 4);
}

TEST_CASE("an error on one rank ends all, and is said") {
    if (!has_mpi()) return;
    for (const int ranks : {1, 2, 4}) {
        const Shared all = shared(ranks, 60, "fails");
        CHECK(all.result.status == 3);
        CHECK(all.result.errors.find("error: the disk is full\nhelp: remove something\n") !=
              std::string::npos);
        const std::string rank = "this is rank " + std::to_string(ranks - 1) + " of " +
                                 std::to_string(ranks) + ", and the end of all\n";
        CHECK((all.result.errors.find(rank) != std::string::npos) == (ranks > 1));
    }
}

TEST_CASE("a rank that dies ends all") {
    if (!has_mpi()) return;
    const Shared all = shared(4, 60, "dies");
    CHECK(!all.result.ok());
    CHECK(all.result.errors.find("signal 9") != std::string::npos);
}

TEST_CASE("without a compiler of MPI its name and a remedy are said") {
    ::setenv("MPICXX", "no-such-mpicxx", 1);
    const Refusal missing = refusal([] { return find_mpi_compiler().version; });
    ::unsetenv("MPICXX");
    CHECK(missing.status == 3);
    CHECK(missing.what == "there is no compiler of MPI: `no-such-mpicxx --version` fails");
    CHECK(missing.helps("libopenmpi-dev"));
}
