// Tables of runs as NPY, against the same as text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// An array of records: see numpy.lib.format.
struct Records {
    std::string header;
    std::vector<double> values;
};

Records records_in(const std::string& file) {
    REQUIRE(file.size() > 12);
    CHECK(file.substr(0, 8) == std::string("\x93NUMPY\x02\x00", 8));
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k)
        length |= static_cast<std::size_t>(static_cast<unsigned char>(file[8 + k])) << (8 * k);
    REQUIRE(file.size() >= 12 + length);
    CHECK((12 + length) % 64 == 0);
    Records result{file.substr(12, length), {}};
    const std::string bytes = file.substr(12 + length);
    CHECK(bytes.size() % sizeof(double) == 0);
    result.values.resize(bytes.size() / sizeof(double));
    std::memcpy(result.values.data(), bytes.data(), bytes.size());
    return result;
}

/// Checks that both tables of a run have equal numbers.
void agree(const std::string& words, const std::string& header) {
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& more) {
        const Outcome outcome = shell("exec \"$hvi_gen\" run " + words + more, directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
    };
    run(" --only table -o text");
    run(" --only table -o npy --format npy");
    CHECK(names_in(directory / "npy") == std::vector<std::string>{"trajectory.npy"});
    const Records records = records_in(contents(directory / "npy/trajectory.npy"));
    CHECK(records.header.substr(0, header.size()) == header);
    CHECK(records.header.back() == '\n');
    const auto lines = lines_of(contents(directory / "text/trajectory.csv"));
    std::vector<double> expected;
    for (std::size_t k = 1; k < lines.size(); ++k)
        for (const double value : numbers_of(lines[k])) expected.push_back(value);
    CHECK(records.values == expected);
}

}  // namespace

TEST_CASE("a table as NPY has names and the same doubles") {
    agree("kepler --method gauss:4 --interpret --until 1 --columns \"energy, x\" --step 1/10",
          "{'descr': [('t', '<f8'), ('energy', '<f8'), ('x', '<f8')], 'fortran_order': False, "
          "'shape': (11,), }");
    agree("outer-solar-system --method stormer-verlet --interpret --times 0:1000:3 --columns "
          "\"px[1..2]\"",
          "{'descr': [('t', '<f8'), ('px[1]', '<f8'), ('px[2]', '<f8')], 'fortran_order': False, "
          "'shape': (3,), }");
}

TEST_CASE("a table in float has the doubles of the other one, rounded, over the same times") {
    use_cache();
    const Directory directory;
    // NOTE: 10^39 is beyond the floats, and 10^-50 below them.
    write(
        directory / "scene.toml",
        "hamiltonian = \"p^4/4 + py^2/2 - cos(y)/3 + pz^4/4\"\ncoordinates = [\"q\", \"y\", "
        "\"z\"]\nmomenta = [\"p\", \"py\", \"pz\"]\ninitial = {q = \"-10^39\", y = 1, z = 0, p "
        "= 1, py = 0, pz = \"10^-50\"}\nrun = {method = \"stormer-verlet\", step = \"1/7\", until "
        "= 10}\n");
    const auto lines = [&](const std::string& words) {
        const Outcome outcome =
            shell("exec \"$hvi_gen\" run scene.toml --interpret --only table -o "
                  "out " +
                      words,
                  directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return lines_of(contents(directory / "out/trajectory.csv"));
    };
    const auto expected = lines(""), found = lines("--numbers float");
    static_cast<void>(lines("--numbers float --format npy"));
    const std::string file = contents(directory / "out/trajectory.npy");
    REQUIRE(found.size() == expected.size());
    REQUIRE(found.size() == 72);
    CHECK(found.front() == expected.front());
    CHECK(file.find("{'descr': [('t', '<f8'), ('q', '<f4'), ('y', '<f4'), ('z', '<f4'), ") == 12);
    const char* record = file.data() + file.size() - 71 * (8 + 7 * 4);
    for (std::size_t k = 1; k < found.size(); ++k) {
        const std::vector<double> row = numbers_of(expected[k]);
        CHECK(found[k].substr(0, found[k].find(',')) ==
              expected[k].substr(0, expected[k].find(',')));
        double time = 0;
        std::memcpy(&time, record, sizeof time);
        CHECK(time == row[0]);
        record += sizeof time;
        std::string text = found[k];
        REQUIRE(row.size() == 8);
        for (std::size_t i = 1; i < row.size(); ++i) {
            const auto wanted = static_cast<float>(row[i]);
            text.erase(0, text.find(',') + 1);
            float number = 0;
            const auto end =
                std::from_chars(text.data(), text.data() + text.size(), number).ptr - text.data();
            CHECK(number == wanted);
            CHECK(end <= 13);  // -1.23456789e-01 has a digit more than any float takes
            std::memcpy(&number, record, sizeof number);
            CHECK(number == wanted);
            record += sizeof number;
        }
        CHECK(std::isinf(static_cast<float>(row[1])));
    }
    CHECK(found[1] == "0,-inf,1,0,1,0,0,0.06989923");
    const Outcome refused =
        shell("exec \"$hvi_gen\" run scene.toml --numbers half", directory.path());
    CHECK(refused.status == 2);
    CHECK(refused.err ==
          "error: no such value of --numbers: `half`\n  --numbers: half\n             "
          "^~~~\nhelp: one of double or float\n");
}

TEST_CASE("a run that goes on adds to its NPY table, and a picture is drawn beside one") {
    use_cache();
    const std::string numbers = GENERATE(as<std::string>(), "double", "float");
    CAPTURE(numbers);
    const Directory directory;
    const auto run = [&](const std::string& more) {
        const Outcome outcome = shell("exec \"$hvi_gen\" run kepler --method stormer-verlet "
                                      "--interpret --step 1/10 --format npy --numbers " +
                                          numbers + " " + more,
                                      directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 0);
    };
    const std::string kept = "--every 3 --checkpoint-every 50 --checkpoint ";
    run("--until 20 -o whole " + kept + "whole.hvi");
    run("--until 11 -o parts " + kept + "parts.hvi");
    run("--until 20 -o parts --resume parts.hvi " + kept + "parts.hvi");
    CHECK(contents(directory / "parts/trajectory.npy") ==
          contents(directory / "whole/trajectory.npy"));
    run("--until 20 -o drawn");
    CHECK(names_in(directory / "drawn") ==
          std::vector<std::string>{"picture.svg", "summary.txt", "trajectory.npy"});
}

TEST_CASE("beside a table of another format the picture shows the rows at given times") {
    use_cache();
    const Directory directory;
    const auto picture = [&](const std::string& format) {
        const Outcome outcome = shell("exec \"$hvi_gen\" run kepler --interpret --until 1 --times "
                                      "0:1:5 --format " +
                                          format + " -o " + format,
                                      directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return contents(directory / format / "picture.svg");
    };
    CHECK(picture("npy") == picture("csv"));
}
