// Tables of runs as NPY, against the same as text.
// SPDX-License-Identifier: GPL-2.0-or-later
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

/// Both tables of a run, which are the same numbers.
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

TEST_CASE("a run that goes on adds to its NPY table, and a picture is drawn beside one") {
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& more) {
        const Outcome outcome = shell("exec \"$hvi_gen\" run kepler --method stormer-verlet "
                                      "--interpret --step 1/10 --format npy " +
                                          more,
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
