// Runs that end on the way, and go on from there.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/drive/checkpoint.hpp"
#include "generator/support/error.hpp"
#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A star whose run takes a second or so, with two kinds of events.
const std::string star =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {a = \"1/10\"}\n"
    "initial = {x = 0, y = \"a\", px = \"1/2\", py = 0}\n"
    "run = {method = \"gauss:4\", step = \"1/10\", until = 5000}\n"
    "[events.section]\nzero = \"x\"\ndirection = \"up\"\n"
    "[events.slow]\nzero = \"py\"\ncooldown = 20\n";

/// Runs of a scene in one directory, in shells.
class Broken {
public:
    explicit Broken(std::string words) : words_(std::move(words)) {
        use_cache();
        write(directory_ / "scene.toml", star);
    }

    /// Runs a line in which $run is the run with checkpoints, and $out its directory.
    Outcome operator()(const std::string& line) const {
        return shell("run=\"$hvi_gen run scene.toml -o \\$out --only table,summary " + words_ +
                         "\"; " + line,
                     directory_.path());
    }

    [[nodiscard]] std::string file(const std::string& name) const {
        return contents(directory_ / name);
    }

private:
    Directory directory_;
    std::string words_;
};

/// Returns the summary without wall-clock times.
std::string without_time(const std::string& summary) {
    std::string result;
    for (const std::string& line : lines_of(summary))
        if (line.rfind("time ", 0) != 0) result += line + "\n";
    return result;
}

}  // namespace

TEST_CASE("a run that is killed again and again has the bits of one that is not") {
    for (const std::string how : {"", "--interpret", "--times 0:5000:333", "--method lobatto:3"}) {
        CAPTURE(how);
        const Broken broken("--checkpoint-every 2000 --every 50 " + how);
        std::string words = how;
        const Broken at_times("--checkpoint-every 2000 " + how);
        const Broken& runs = how.find("--times") == std::string::npos ? broken : at_times;
        const Outcome whole = runs("out=whole; eval \"exec $run --checkpoint whole.hvi\"");
        INFO(whole.err);
        REQUIRE(whole.status == 0);
        const Outcome ended = runs(
            "out=broken; tries=0; delay=0.05\n"
            "while [ $tries -lt 60 ]; do\n"
            "  tries=$((tries + 1)); resume=\n"
            "  [ -s broken.hvi ] && resume='--resume broken.hvi'\n"
            "  eval \"exec $run --checkpoint broken.hvi $resume\" > said.txt 2> err.txt & pid=$!\n"
            "  sleep $delay; kill -KILL $pid 2> /dev/null; wait $pid && break\n"
            "  delay=$(awk \"BEGIN {print $delay * 1.15}\")\n"
            "done; cat err.txt; echo $tries > tries.txt");
        CAPTURE(ended.out, ended.err, runs.file("tries.txt"));
        CHECK(runs.file("broken/trajectory.csv") == runs.file("whole/trajectory.csv"));
        CHECK(runs.file("broken/events.csv") == runs.file("whole/events.csv"));
        CHECK(without_time(runs.file("broken/summary.txt")) ==
              without_time(runs.file("whole/summary.txt")));
    }
}

TEST_CASE("an interrupted run keeps its table, and goes on where it was") {
    const Broken broken("--every 50");
    const std::string start =
        "out=out; eval \"exec $run --checkpoint-every 1000 --checkpoint run.hvi "
        "--until 50000000\" & pid=$!; "
        "for k in $(seq 600); do [ -s run.hvi ] && break; sleep 0.05; done; ";
    const Outcome stopped = broken(start + "kill -TERM $pid; wait $pid");
    INFO(stopped.err);
    REQUIRE(stopped.status == 130);
    const std::string table = broken.file("out/trajectory.csv");
    REQUIRE(!table.empty());
    CHECK(lines_of(table).back() == "# incomplete: interrupted");
    CHECK(lines_of(table).size() > 20);
    const Outcome ended = broken("out=out; eval \"exec $run --resume run.hvi --until 6000\"");
    // NOTE: the run may have been beyond that.
    INFO(ended.err);
    CHECK(ended.status == 0);
    const std::string more = broken.file("out/trajectory.csv");
    CHECK(more.find("incomplete") == std::string::npos);
    CHECK(more.substr(0, 1000) == table.substr(0, 1000));
}

TEST_CASE("SIGUSR1 asks for a checkpoint, and the run goes on") {
    const Broken broken("--every 5000 --checkpoint run.hvi --until 50000000");
    const Outcome outcome = broken(
        "wait_for() { for k in $(seq 600); do [ -s $1 ] && break; sleep 0.05; done; }\n"
        "out=out; eval \"exec $run\" & pid=$!; wait_for out/trajectory.csv.partial; "
        "kill -USR1 $pid; wait_for run.hvi; cp run.hvi saved.hvi; kill -TERM $pid; wait $pid");
    INFO(outcome.err);
    CHECK(outcome.status == 130);
    CHECK(broken.file("saved.hvi").find("hvi checkpoint 1\n") == 0);
}

TEST_CASE("checkpoints of other runs, and what is none, are refused") {
    const Broken broken("--every 50 --until 300");
    REQUIRE(
        broken("out=out; eval \"exec $run --checkpoint run.hvi --checkpoint-every 1000\"").status ==
        0);
    const auto refused = [&](const std::string& words, int status, const std::string& message) {
        const Outcome outcome = broken("out=out; eval \"exec $run " + words + "\"");
        CAPTURE(words, outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.err.find(message) != std::string::npos);
    };
    refused("--resume run.hvi --param a=1/9", 2, "this checkpoint is of another run");
    refused("--resume run.hvi --step 1/11", 2, "this checkpoint is of another run");
    refused("--resume run.hvi --method gauss:6", 2, "this checkpoint is of another run");
    refused("--resume run.hvi --columns x", 2, "this checkpoint is of another run");
    refused("--resume run.hvi --numbers float", 2, "this checkpoint is of another run");
    refused("--resume scene.toml", 2, "there is no whole checkpoint in this file");
    refused("--resume missing.hvi", 2, "missing.hvi");
    refused("--checkpoint-every 10", 2, "--checkpoint");
    refused("--checkpoint a.hvi --checkpoint-every 10 --checkpoint-minutes 1", 2,
            "--checkpoint-minutes");
    refused("--checkpoint a.hvi --accuracy 1e-6", 2, "--accuracy");
    refused("--checkpoint nowhere/a.hvi --checkpoint-every 10", 3, "cannot write");
    const Outcome elsewhere = broken("out=else; eval \"exec $run --resume run.hvi\"");
    INFO(elsewhere.err);
    CHECK(elsewhere.status == 3);
    CHECK(elsewhere.err.find("the table that the checkpoint goes on with is not there") !=
          std::string::npos);
}

TEST_CASE("a checkpoint is read as it was written, and only where it is whole") {
    using namespace hvi::gen;
    Checkpoint written;
    written.steps = 1234567890123;
    written.t = 1.0 / 3;
    written.state = {1e-300, -0.0, std::sqrt(2.0), std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::quiet_NaN()};
    written.departures = {{0.1, 0.2, -0.3}};
    written.events.resize(2);
    written.events[1] = {-1, 1e-20, 3, 5.0, {}};
    written.counts = {3, 0};
    written.sizes = {100, 5};
    written.rows = {7};
    const std::string first = text(written, "key");
    const Checkpoint read = last_checkpoint(first, "key", "file");
    CHECK(text(read, "key") == first);
    written.steps = 8;
    const std::string second = text(written, "key");
    CHECK(last_checkpoint(first + second, "key", "file").steps == 8);
    for (std::size_t cut = 1; cut <= second.size(); ++cut) {
        const std::string all = first + second.substr(0, second.size() - cut);
        CHECK(last_checkpoint(all, "key", "file").steps == 1234567890123);
    }
    for (std::size_t k = 0; k < first.size(); ++k) {
        std::string changed = first;
        changed[k] = static_cast<char>(changed[k] ^ 1);
        CHECK_THROWS_AS(last_checkpoint(changed, "key", "file"), InputError);
    }
    CHECK_THROWS_AS(last_checkpoint(first, "other", "file"), InputError);
    CHECK_THROWS_AS(last_checkpoint("", "key", "file"), InputError);
}
