// A rank of mpirun for tests: mpi_rank DIRECTORY CHUNKS HOW, which writes its chunks, one a line,
// to DIRECTORY/rank-N, and `end` where it has no more.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <signal.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "generator/ensembles/mpi.hpp"
#include "generator/support/error.hpp"
#include "generator/support/process.hpp"

namespace {

using namespace hvi::gen;

std::string path_of(const std::string& directory, int rank) {
    return directory + "/rank-" + std::to_string(rank);
}

/// Waits until each rank has a chunk; where something is wrong, for a minute.
void wait_for_ranks(const std::string& directory, int ranks) {
    using namespace std::chrono_literals;
    const auto have_begun = [&] {
        for (int rank = 0; rank < ranks; ++rank)
            if (std::filesystem::file_size(path_of(directory, rank)) == 0) return false;
        return true;
    };
    for (int tenth = 0; tenth < 600 && !have_begun(); ++tenth) std::this_thread::sleep_for(100ms);
}

/// Works on a chunk; the last rank does that as `how` says.
bool work_on(const MpiRank& rank, const std::string& how) {
    if (how == "all leave") return false;
    if (rank.number() < rank.count() - 1) return true;
    if (how == "fails") throw EnvironmentError("the disk is full", "remove something");
    if (how == "dies") ::raise(SIGKILL);
    if (how == "is interrupted") ::raise(SIGTERM);
    return how != "leaves";
}

}  // namespace

int main(int, char** words) {
    const std::string directory = words[1], how = words[3];
    std::vector<std::int64_t> chunks(std::stoul(words[2]));
    std::iota(chunks.begin(), chunks.end(), 100);
    set_up_process();
    try {
        under_mpi([&](const MpiRank& rank) {
            const InterruptionsHeld held;
            const bool all_have_one = chunks.size() >= static_cast<std::size_t>(rank.count());
            std::ofstream file(path_of(directory, rank.number()));
            rank.meet();
            rank.hand_out(chunks, [&](std::int64_t chunk) {
                file << chunk << "\n" << std::flush;
                if (all_have_one) wait_for_ranks(directory, rank.count());
                return work_on(rank, how);
            });
            file << "end\n";
            file.close();
            rank.meet();
        });
    } catch (const Error& error) {
        std::fputs(message(error).c_str(), stderr);
        return static_cast<int>(error.status());
    }
}
