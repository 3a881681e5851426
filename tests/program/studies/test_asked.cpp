// Words of `ensemble` and `collect`: what is refused, and what is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "tests/program/studies/study_run.hpp"

using namespace hvi::test;

namespace {

const std::string oscillator =
    "hamiltonian = \"p^2/2 + w^2*q^2/2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
    "parameters = {w = 1, unused = 2}\ninitial = {q = 1, p = 0}\n"
    "run = {method = \"stormer-verlet\", step = \"1/10\", until = 1}\n";

/// A directory with the scene.
class Asked {
public:
    Asked() { write(directory_ / "scene.toml", oscillator); }

    void refused(const std::string& words, int status, const std::string& message) const {
        const Outcome outcome = study_in(directory_, "eval \"$study " + words + "\"");
        CAPTURE(words, outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.err.find(message) != std::string::npos);
        CHECK(directory_.names() == before_);
    }

    Outcome operator()(const std::string& line) const { return study_in(directory_, line); }
    [[nodiscard]] const Directory& directory() const { return directory_; }

private:
    Directory directory_;
    std::vector<std::string> before_{"scene.toml"};
};

}  // namespace

TEST_CASE("studies that cannot be are refused, with the place") {
    const Asked asked;
    asked.refused("", 2, "no rows are asked for");
    asked.refused("--vary z=0:1:3", 2, "no row can have its own `z`");
    asked.refused("--vary ww=0:1:3", 2, "did you mean `w`?");
    asked.refused("--vary w=0:1:3 --vary w=0:1:3", 2, "`w` gets its values twice");
    asked.refused("--vary w=0:1:3 --random 'w=normal(0, 1)'", 2, "`w` gets its values twice");
    asked.refused("--vary w=0:1", 2, "--vary");
    asked.refused("--vary w=0:1:0", 2, "--vary");
    asked.refused("--random 'w=normal(0, -1)'", 2, "--random");
    asked.refused("--random 'w=cauchy(0, 1)'", 2, "--random");
    asked.refused("--samples 3 --vary w=0:1:3", 2, "--random");
    asked.refused("--initial missing.csv", 2, "missing.csv");
    asked.refused("--vary w=0:1:3 --param w=2", 2, "`w` has a value for all rows by --param");
    asked.refused("--vary w=0:1:3 --columns z", 2, "z");
    asked.refused("--vary w=0:1:3 --reduce 'median(q)'", 2, "median");
    asked.refused("--vary w=0:1:3 --map 'w, z'", 2, "the study has no column `z`");
    asked.refused("--vary w=0:1:3 --map 'w'", 2, "two or three columns are wanted here");
    asked.refused("--vary w=0:1:3 --slurm 3 --mpi", 2, "--mpi");
    asked.refused("--vary w=0:1:3 --workers 0", 2, "--workers");
    asked.refused("--vary w=0:1:3 --lanes stages", 2, "--lanes");
    for (const std::string other : {"--megno", "--interpret", "--reduce 'min(q)'", "--lanes none"})
        asked.refused("--vary w=0:1:3 --cuda " + other, 2, "--cuda does not go with");
    asked.refused("--vary w=0:1:100000000 --vary q=0:1:100000000", 2, "10^15");
}

TEST_CASE("a file of starts lacks no column that it names") {
    const Asked asked;
    write(asked.directory() / "starts.csv", "w,v\n1,2\n");
    const Outcome outcome = asked("eval \"$study --initial starts.csv\"");
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("no row can have its own `v`") != std::string::npos);
}

TEST_CASE("rows of a file go with all points of grids and all samples") {
    const Asked asked;
    write(asked.directory() / "starts.csv", "w,q\n1,2\n3,4\n");
    const Outcome outcome =
        asked("eval \"$study --initial starts.csv --vary p=0:1:2 --vary step=1/20:1/10:2 --random "
              "'until=uniform(1, 2)' --samples 3\" && \"$hvi_gen\" collect study");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("seed         1\n") != std::string::npos);
    const TextTable rows = table_of(contents(asked.directory() / "study" / "rows.csv"));
    REQUIRE(rows.rows.size() == 24);
    for (std::size_t row = 0; row < 24; ++row) {
        CAPTURE(row);
        CHECK(rows.number(row, "w") == (row < 12 ? 1 : 3));
        CHECK(rows.number(row, "q_0") == (row < 12 ? 2 : 4));
        CHECK(rows.number(row, "p_0") == (row / 6 % 2 == 0 ? 0 : 1));
        CHECK(rows.number(row, "step") == (row / 3 % 2 == 0 ? 0.05 : 0.1));
        CHECK((rows.number(row, "until") > 1 && rows.number(row, "until") < 2));
        CHECK((row == 0 || rows.at(row, "until") != rows.at(row - 1, "until")));
    }
}

TEST_CASE("tables are collected in three formats, by the ending of the file") {
    const Asked asked;
    const Outcome outcome = asked(
        "eval \"$study --vary w=1:2:11 --columns q,energy --chunk 4\" && for ending in csv npy "
        "h5; do \"$hvi_gen\" collect study -o rows.$ending || exit 9; done; /usr/bin/python3 - "
        "<<'END'\n"
        "import csv, numpy\n"
        "rows = numpy.load('rows.npy')\n"
        "text = list(csv.DictReader(open('rows.csv')))\n"
        "assert len(rows) == len(text) == 11\n"
        "for row, line in zip(rows, text):\n"
        "    for name in ('row', 'w', 'q', 'energy', 't', 'steps'):\n"
        "        assert row[name] == float(line[name]), name\n"
        "    assert row['status'] == 0 and line['status'] == 'ok'\n"
        "END\n");
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(asked("head -c 4 rows.h5").out == "\x89HDF");
    const Outcome wrong = asked("\"$hvi_gen\" collect study -o rows.txt");
    CHECK(wrong.status == 2);
    CHECK(wrong.err.find("rows.txt") != std::string::npos);
    CHECK(asked("\"$hvi_gen\" collect nowhere").status == 2);
    CHECK(asked("\"$hvi_gen\" collect").status == 2);
    CHECK(asked("\"$hvi_gen\" collect study -o nowhere/rows.csv").status == 3);
}

TEST_CASE("a batch file of Slurm runs the study, here without Slurm") {
    const Asked asked;
    const Outcome printed = asked("eval \"$study --vary w=1:2:11 --slurm 3\" > job.sh");
    INFO(printed.err);
    REQUIRE(printed.status == 0);
    const std::string script = contents(asked.directory() / "job.sh");
    CHECK(script.find("#SBATCH --array=1-3\n") != std::string::npos);
    CHECK(script.find("--slurm") == std::string::npos);
    const Outcome outcome = asked(
        "mkdir bin && ln -s \"$hvi_gen\" bin/hvi-gen && PATH=$PWD/bin:$PATH && export PATH && "
        "for task in 1 2 3; do SLURM_CPUS_PER_TASK=2 sh job.sh & done; wait; "
        "\"$hvi_gen\" collect study -o rows.csv");
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(table_of(contents(asked.directory() / "rows.csv")).rows.size() == 11);
}
