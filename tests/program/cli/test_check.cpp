// Results of `hvi-gen check`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/program/cli/results.hpp"

using namespace hvi::test;

TEST_CASE("check says what a method can do") {
    const Directory directory;
    const std::string text =
        hvi_gen({"check", "--method", "trig3", "--plot", "trig3.svg"}, directory.path()).out;
    for (const std::string line :
         {"order         2: 6 conditions hold, and 14 of order 3 fail\n",
          "  separable   2: 4 conditions hold, and 4 of order 3 fail\n",
          "  Nystrom     2: 4 conditions hold, and 3 of order 3 fail\n",
          "determinant   1, by exact arithmetic\n", "symplectic    yes\n", "A == A~       no\n",
          "stable        z = h omega in (0, 2.37351), (3.31779, 3.9374)\n",
          "no step       at z = 7.38143\n", "All of it is proved.\n"})
        CHECK(text.find(line) != std::string::npos);
    CHECK(contents(directory / "trig3.svg").rfind("<svg", 0) == 0);
    const std::string json =
        same_every_time({"check", "--method", "gauss:8", "--max-order", "16", "--format", "json"});
    for (const std::string field :
         {"\"schema\": \"hvi-check/1\"", "\"order\": 16", "\"order_is_at_least\": true",
          "\"failures\": null", "\"error_constant\": null", "\"quadratic\": true",
          "\"proved\": true", "\"until\": 20"})
        CHECK(json.find(field) != std::string::npos);
}

TEST_CASE("check says what a tableau from elsewhere is") {
    const Directory directory;
    const auto check = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"check", "--tableau"});
        const Outcome outcome = hvi_gen(words, directory.path());
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        return outcome.out;
    };
    // NOTE: Python prints these numbers; the file wrong.json has one digit changed, at the 12th
    // place.
    write(directory / "gauss.json",
          "{\"c\": [0.21132486540518713, 0.7886751345948129], \"b\": [0.5, 0.5],\n"
          " \"A\": [[0.25, -0.038675134594812866], [0.5386751345948129, 0.25]]}");
    write(directory / "wrong.json",
          "{\"c\": [0.21132486540518713, 0.7886751345948129], \"b\": [0.5, 0.5],\n"
          " \"A\": [[0.25, -0.038675134598812866], [0.5386751345948129, 0.25]]}");
    const std::string right = check({"gauss.json"});
    CHECK(right.find("is            gauss:2, within the digits given\n") != std::string::npos);
    CHECK(right.find("symplectic    yes\n") != std::string::npos);
    const std::string wrong = check({"wrong.json"});
    CHECK(wrong.find("wrong         A[1][2]: -0.038675134598812866\n") != std::string::npos);
    CHECK(wrong.find("right is 1/4-sqrt(3)/6 = -0.0386751345948128823\n") != std::string::npos);
    CHECK(wrong.find("right to      11 decimal places\n") != std::string::npos);
    CHECK(wrong.find("symplectic    no\n") != std::string::npos);
    const std::string json = check({"wrong.json", "--format", "json"});
    CHECK(json.find("\"entry\": \"A[1][2]\"") != std::string::npos);
    CHECK(check({"wrong.json", "--format", "json"}) == json);
    CHECK(check({"gauss.json", "--plot", "gauss.svg", "-o", "out.txt"}).empty());
    CHECK(contents(directory / "out.txt") == right);
    CHECK(contents(directory / "gauss.svg").rfind("<svg", 0) == 0);
    write(directory / "theta.json", "{\"c\": [\"w\"], \"b\": [1], \"A\": [[\"w\"]]}");
    CHECK(check({"theta.json", "--param", "w=1/2"}).find("is            midpoint\n") !=
          std::string::npos);
}

TEST_CASE("what tableau writes is what check reads") {
    const Directory directory;
    for (const std::string method :
         {"gauss:3", "lobatto:4", "trig3", "stormer-verlet", "chebyshev:3", "radau-right:3"}) {
        CAPTURE(method);
        CHECK(hvi_gen({"tableau", "--method", method, "--format", "json", "-o", "t.json"},
                      directory.path())
                  .status == 0);
        const std::string direct = hvi_gen({"check", "--method", method, "--format", "json"}).out;
        const std::string read =
            hvi_gen({"check", "--tableau", "t.json", "--format", "json"}, directory.path()).out;
        // NOTE: the bytes are equal up to the audit, which is the last of the fields.
        const std::size_t end = direct.rfind("\n}");
        REQUIRE(end != std::string::npos);
        CHECK(read.substr(0, end) == direct.substr(0, end));
        CHECK(read.substr(end, 12) == ",\n  \"audit\":");
        CHECK(read.find("\"is\": \"" + method + "\"") != std::string::npos);
    }
    CHECK(shell("hvi-gen tableau --method gauss:32 --format json | "
                "hvi-gen check --tableau /dev/stdin --max-order 4",
                directory.path())
              .out.find("is            gauss:32, within the digits given\n") != std::string::npos);
}
