// Workers of one study: any number of them, killed at random, stopped and resumed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/studies/study_run.hpp"

using namespace hvi::test;

namespace {

/// A star whose rows take a few milliseconds each.
const std::string star = "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
                         "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                         "initial = {x = 0, y = \"1/10\", px = \"1/2\", py = 0}\n"
                         "run = {method = \"gauss:4\", step = \"1/4\", until = 2000}\n";

const std::string rows = "--random 'y=normal(0, 1/10)' --samples 200 --seed 5";

/// Words for rows that take four times as long.
const std::string long_rows = rows + " --until 8000 --chunk 200 --workers 1";

/// A directory with the scene, whose studies are compared.
class Studies {
public:
    Studies() { write(directory_ / "scene.toml", star); }

    Outcome operator()(const std::string& line) const { return study_in(directory_, line); }

    /// Returns the table of the study, without the summary of its run.
    [[nodiscard]] std::string collected() const {
        const Outcome outcome = (*this)("\"$hvi_gen\" collect study -o rows.csv");
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return contents(directory_ / "rows.csv");
    }

    /// Returns the bytes of all files of chunks.
    [[nodiscard]] std::string chunks() const {
        return (*this)("cd study/chunks && find . -type f | sort | while read -r file; do "
                       "echo \"$file\"; cksum < \"$file\"; done")
            .out;
    }

    [[nodiscard]] const Directory& directory() const { return directory_; }

private:
    Directory directory_;
};

/// Waits until a worker has a chunk.
const std::string until_a_lock =
    "for k in $(seq 3000); do ls study/chunks/000/*.lock > /dev/null 2>&1 && break; sleep 0.01; "
    "done; ";

std::string table_text_of_whole() {
    const Studies studies;
    REQUIRE(studies("eval \"$study " + long_rows + "\"").status == 0);
    return studies.collected();
}

std::string whole() {
    const Studies studies;
    REQUIRE(studies("eval \"$study " + rows + " --chunk 7 --workers 1\"").status == 0);
    return studies.collected() + studies.chunks();
}

}  // namespace

TEST_CASE("rows have the same bits for any number of workers, and any of processes") {
    const std::string expected = whole();
    for (const std::string how : {"--workers 2", "--workers 5"}) {
        const Studies studies;
        REQUIRE(studies("eval \"$study " + rows + " --chunk 7 " + how + "\"").status == 0);
        CHECK(studies.collected() + studies.chunks() == expected);
    }
    const Studies studies;
    const std::string one = "eval \"$study " + rows + " --chunk 7 --workers 1\"";
    CHECK(studies(one + " & " + one + " & " + one + " & wait").status == 0);
    CHECK(studies.collected() + studies.chunks() == expected);
}

TEST_CASE("rows have the same bits under mpirun, and ranks that are killed are made up for") {
    if (shell("command -v mpirun > /dev/null").status != 0) {
        WARN("there is no mpirun: ranks are not tested");
        return;
    }
    const std::string expected = whole();
    // NOTE: MPI leaves memory behind, which a sanitizer would report.
    const std::string ranks =
        "export ASAN_OPTIONS=detect_leaks=0 OMPI_ALLOW_RUN_AS_ROOT=1 "
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; ranks=\"mpirun --oversubscribe -n\"; ";
    const std::string command = " $study " + rows + " --chunk 7 --mpi\"";
    for (const std::string count : {"1", "2", "4"}) {
        CAPTURE(count);
        const Studies studies;
        const Outcome outcome = studies(ranks + "eval \"$ranks " + count + command);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.out.find("rows         200: ") != std::string::npos);
        CHECK(studies.collected() + studies.chunks() == expected);
    }
    const Studies studies;
    const Outcome killed =
        studies(ranks + "eval \"$ranks 2" + command +
                " & for k in $(seq 600); do ls study/chunks/000/*.npy > /dev/null 2>&1 && break; "
                "sleep 0.01; done; pkill -KILL -n -f -- 'seed 5 --chunk 7 --mpi'; wait; "
                "eval \"$ranks 2" +
                command);
    INFO(killed.err);
    CHECK(killed.status == 0);
    CHECK(studies.collected() + studies.chunks() == expected);
}

TEST_CASE("a study whose workers are killed twenty times has the bits of one that is not") {
    const std::string expected = whole();
    const Studies studies;
    const Outcome outcome =
        studies("tries=0; delay=0.10\n"
                "while [ $tries -lt 20 ]; do\n"
                "  tries=$((tries + 1))\n"
                "  eval \"exec $study " +
                rows + " --chunk 7" +
                "\" > said.txt 2> err.txt & pid=$!\n"
                "  sleep $delay; kill -KILL $pid 2> /dev/null; wait $pid\n"
                "  delay=$(awk \"BEGIN {print 0.10 + ($tries * 7 % 11) * 0.02}\")\n"
                "done\n"
                // NOTE: the last worker may yet be dying.
                "for k in $(seq 100); do\n"
                "  eval \"$study " +
                rows +
                " --chunk 7\"; \"$hvi_gen\" collect study -o all.csv && break; sleep 0.1\n"
                "done");
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(studies.collected() + studies.chunks() == expected);
}

TEST_CASE("a signal ends a study cleanly, and it goes on from its rows") {
    const std::string expected = table_text_of_whole();
    for (const std::string signal : {"TERM", "USR1", "INT"}) {
        CAPTURE(signal);
        const Studies studies;
        const std::string command = "$study " + long_rows;
        const Outcome stopped = studies("eval \"exec " + command + "\" & pid=$!; " + until_a_lock +
                                        "sleep 0.1; kill -" + signal + " $pid; wait $pid");
        INFO(stopped.err);
        CHECK(stopped.status == 130);
        CHECK(studies("ls study/chunks/000/*.lock study/chunks/000/.??*").out.empty());
        CHECK(studies("eval \"" + command + "\"").status == 0);
        CHECK(studies.collected() == expected);
    }
}

TEST_CASE("rows that a stopped worker has computed are not computed again") {
    const Studies studies;
    const std::string command = "$study " + long_rows;
    const std::string file = "study/chunks/000/000000.part";
    // NOTE: it may be stopped before its first row, or at its end.
    for (int k = 0; k < 20 && studies("test -e " + file).status != 0; ++k)
        static_cast<void>(studies("rm -rf study; eval \"exec " + command + "\" & pid=$!; " +
                                  until_a_lock + "sleep 0.05; kill -TERM $pid; wait $pid"));
    const Outcome marked = studies("/usr/bin/python3 -c \"import numpy; rows = numpy.load('" +
                                   file + "'); rows['steps'] = -7; numpy.save(open('" + file +
                                   "', 'wb'), rows); print(len(rows))\"");
    INFO(marked.err);
    REQUIRE(marked.status == 0);
    REQUIRE(studies("eval \"" + command + "\"").status == 0);
    const TextTable table = table_of(studies.collected());
    REQUIRE(table.rows.size() == 200);
    for (std::size_t row = 0; row < 200; ++row)
        CHECK((table.at(row, "steps") == "-7") == (row < std::stoul(marked.out)));
}

TEST_CASE("a signal ends a row that takes for ever") {
    const Studies studies;
    for (const std::string how : {"", "--megno"}) {
        CAPTURE(how);
        const Outcome stopped =
            studies("rm -rf study; eval \"exec $study --vary y=0:0.1:1 --until 1000000000 " + how +
                    "\" & pid=$!; " + until_a_lock + "sleep 0.1; kill -TERM $pid; wait $pid");
        INFO(stopped.err);
        CHECK(stopped.status == 130);
        CHECK(studies("ls study/chunks/000").out.empty());
    }
}

TEST_CASE("what others have is left to them, and what they have lost is not") {
    const Studies studies;
    const std::string words = "--vary y=0:0.1:6 --chunk 2";
    REQUIRE(studies("mkdir -p study/chunks/000; echo 'elsewhere 1 1' > "
                    "study/chunks/000/000001.lock; true")
                .status == 0);
    const Outcome first = studies("eval \"$study " + words + "\"");
    CHECK(first.status == 0);
    CHECK(first.err.find("note: other workers compute 1 of 3 chunks") != std::string::npos);
    CHECK(first.out.empty());
    const Outcome part = studies("\"$hvi_gen\" collect study -o part.csv");
    CHECK(part.status == 1);
    CHECK(part.err.find("1 of 3 chunks are missing in this table") != std::string::npos);
    CHECK(table_of(contents(studies.directory() / "part.csv")).rows.size() == 4);
    // A lock that nobody has touched for long, and one whose process of this machine is gone.
    CHECK(studies("touch -d '10 minutes ago' study/chunks/000/000001.lock; eval \"$study " + words +
                  "\"")
              .status == 0);
    CHECK(table_of(studies.collected()).rows.size() == 6);
    CHECK(studies("rm study/chunks/000/000002.npy; echo \"$(uname -n) 999999999 1\" > "
                  "study/chunks/000/000002.lock; eval \"$study " +
                  words + "\"")
              .status == 0);
    CHECK(table_of(studies.collected()).rows.size() == 6);
    // One whose process has ended, and whose parent does not ask how.
    const Outcome ended = studies(
        "rm study/chunks/000/000002.npy; /usr/bin/python3 -c 'import os, time\n"
        "ended = os.fork()\nif ended == 0: os._exit(0)\nprint(ended, flush=True)\n"
        "time.sleep(60)' > ended & parent=$!; "
        "for k in $(seq 600); do [ -s ended ] && break; sleep 0.05; done; ended=$(cat ended); "
        "start=$(cut -d ' ' -f 22 /proc/$ended/stat); "
        "echo \"$(uname -n) $ended $start\" > study/chunks/000/000002.lock; eval \"$study " +
        words + "\"; status=$?; kill $parent; exit $status");
    INFO(ended.err);
    CHECK(ended.status == 0);
    CHECK(table_of(studies.collected()).rows.size() == 6);
}

TEST_CASE("chunks of others are passed without a change of their directories") {
    const Studies studies;
    const std::string words = "--vary y=0:0.1:3000 --chunk 1 --until 1 --workers 1";
    const Outcome outcome = studies(
        "mkdir -p study/chunks/000 study/chunks/001 study/chunks/002\n"
        "for k in $(seq 1000 1999) $(seq 2000 2999); do\n"
        "  echo 'elsewhere 1 1' > study/chunks/00${k:0:1}/00$k.lock\n"
        "done\n"
        "touch -d '1 hour ago' study/chunks/001 study/chunks/002; touch -d '1 minute ago' then\n"
        "eval \"$study " +
        words + "\"; find study/chunks/001 study/chunks/002 -maxdepth 0 -newer then");
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.find("note: other workers compute 2000 of 3000 chunks") != std::string::npos);
    // One of them may have had the file by which the clock of the file system is asked.
    CHECK(lines_of(outcome.out).size() <= 1);
}

TEST_CASE("another study in a directory is refused, and nothing is lost") {
    const Studies studies;
    REQUIRE(studies("eval \"$study --vary y=0:0.1:6 --until 10\"").status == 0);
    const std::string before = studies.collected() + studies.chunks();
    for (const std::string words :
         {"--vary y=0:0.1:7 --until 10", "--vary y=0:0.1:6 --until 11",
          "--vary y=0:0.1:6 --until 10 --method gauss:2", "--vary x=0:0.1:6 --until 10",
          "--vary y=0:0.1:6 --until 10 --megno", "--vary y=0:0.1:6 --until 10 --chunk 3"}) {
        CAPTURE(words);
        const Outcome outcome = studies("eval \"$study " + words + "\"");
        CHECK(outcome.status == 3);
        CHECK(outcome.err.find("another study is in study") != std::string::npos);
    }
    CHECK(studies.collected() + studies.chunks() == before);
}

TEST_CASE("a damaged chunk is named") {
    const Studies studies;
    REQUIRE(studies("eval \"$study --vary y=0:0.1:6 --until 10 --chunk 3\"").status == 0);
    REQUIRE(studies("head -c 400 study/chunks/000/000001.npy > cut && mv cut "
                    "study/chunks/000/000001.npy")
                .status == 0);
    const Outcome outcome = studies("\"$hvi_gen\" collect study -o rows.csv");
    CHECK(outcome.status != 0);
    CHECK(outcome.err.find("000001.npy") != std::string::npos);
    CHECK(!std::filesystem::exists(studies.directory() / "rows.csv"));
}
