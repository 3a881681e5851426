// Sums of a scene that are written out, or stay loops: what decides, and that it is said.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/refusals.hpp"

using namespace hvi::test;

namespace {

/// N bodies on a line, whose sum over pairs makes more than 2000 operations for N = 40.
std::string pairs(const std::string& more, const std::string& size = "40") {
    return "coordinates = \"x[1..N]\"\nmomenta = \"p[1..N]\"\nhamiltonian = \"sum(i=1..N, "
           "p[i]^2/2) + sum(i=1..N-1, j=i+1..N, (x[i]-x[j])^4)" +
           more + "\"\n[parameters]\nN = " + size +
           "\nw = 2\n[initial]\n\"x[i]\" = \"i/10\"\n\"p[i]\" = 0\n[run]\nmethod = "
           "\"gauss:2\"\nstep = \"1/100\"\nuntil = \"1/10\"\n";
}

Outcome stepper_of_pairs(const std::string& scene, const std::vector<std::string>& words) {
    const Directory directory;
    write(directory / "pairs.toml", scene);
    std::vector<std::string> all{"stepper", "pairs.toml", "--explain"};
    all.insert(all.end(), words.begin(), words.end());
    return hvi_gen(all, directory.path());
}

/// The reason, of the line of --explain: `stay loops: --unroll no`.
std::string said_of_sums(const Outcome& outcome) {
    const std::size_t begin = outcome.err.find("  sums ");
    if (begin == std::string::npos) return "";
    return outcome.err.substr(begin + 7, outcome.err.find('\n', begin) - begin - 7);
}

/// Whether the header has loops, whose sizes a program may change.
bool has_loops(const Outcome& outcome) {
    return outcome.out.find("Place N = ") != std::string::npos;
}

const std::vector<std::string> basis_with_w = {"--basis", "1, cos(w*tau)", "--nodes", "0, 1"};

}  // namespace

TEST_CASE("--explain says whether sums are written out, and why") {
    const Outcome many = stepper_of_pairs(pairs(""), {});
    CHECK(said_of_sums(many) == "stay loops: written out they make more than 2000 operations");
    CHECK(has_loops(many));
    const Outcome few = stepper_of_pairs(pairs("", "4"), {});
    // 4 terms of a power, a reciprocal, a product and an addition; 6 pairs of a difference, a power
    // and an addition; an addition for each of three bodies, and one of both sums.
    CHECK(said_of_sums(few) == "are written out: they make 38 operations, and 2000 are the most");
    CHECK_FALSE(has_loops(few));
    const Outcome wished = stepper_of_pairs(pairs("", "4"), {"--unroll", "no"});
    CHECK(said_of_sums(wished) == "stay loops: --unroll no");
    CHECK(has_loops(wished));
    CHECK(wished.out.find("pairs.toml --unroll no\n") != std::string::npos);
    const Outcome other = stepper_of_pairs(pairs(""), {"--unroll", "yes"});
    CHECK(said_of_sums(other) == "are written out: --unroll yes");
    CHECK_FALSE(has_loops(other));
}

TEST_CASE(
    "what loops do not have is written out by itself, and refused where loops are wished for") {
    const auto check = [](const std::string& scene, const std::vector<std::string>& words,
                          const std::string& reason) {
        const Outcome outcome = stepper_of_pairs(scene, words);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(said_of_sums(outcome).find("are written out: " + reason) == 0);
        CHECK_FALSE(has_loops(outcome));
        std::vector<std::string> with_loops = words;
        with_loops.insert(with_loops.end(), {"--unroll", "no"});
        const Outcome refused = stepper_of_pairs(scene, with_loops);
        INFO(refused.err);
        CHECK(refused.status == 2);
        CHECK(refused.err.find("--unroll yes") != std::string::npos);
        check_form(refused.err);
    };
    check(pairs(" + sum(i=1..N, exp(sum(j=1..N, (x[i]-x[j])^2)))"), {},
          "where sums stay loops, a sum of more than 16 terms that has the index `i`");
    check(pairs(" + sum(i=1..N, x[i])^2"), {"--solver", "newton"}, "--solver newton is not built");
    check(pairs(""), {"--method", "stormer-verlet", "--lanes", "ensemble"},
          "--lanes ensemble is not built for loops");
    check(pairs(" + sum(i=1..N, p[i]^4)"), {"--basis", "1, tau", "--nodes", "gauss:3"},
          "more nodes than functions");
}

TEST_CASE("loops have the time, products, curves, actions, wide numbers, parameters of methods") {
    const auto check = [](const std::string& scene, const std::vector<std::string>& words) {
        const Outcome outcome = stepper_of_pairs(scene, words);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(has_loops(outcome));
    };
    check(pairs(" + x[1]*sin(t)"), {});
    check(pairs(" + sum(i=1..N, x[i])*sum(i=1..N, p[i])"), {});
    check(pairs(""), {"--dense"});
    check(pairs(""), {"--action"});
    check(pairs(""), {"--float128"});
    std::vector<std::string> words = basis_with_w;
    check(pairs(""), words);
    words.insert(words.end(), {"--param", "w=2"});
    check(pairs(""), words);
}

TEST_CASE("words mean the same where sums are written out and where they stay loops") {
    const auto error = [](const std::string& scene, const char* unroll) {
        const Directory directory;
        write(directory / "pairs.toml", scene);
        const Outcome outcome =
            hvi_gen({"stepper", "pairs.toml", "--unroll", unroll}, directory.path());
        CHECK(outcome.status == 2);
        check_form(outcome.err);
        return outcome.err;
    };
    const auto edited = [](const std::string& part, const std::string& other) {
        std::string text = pairs(" + w*x[1]", "4");
        const std::size_t place = text.find(part);
        REQUIRE(place != std::string::npos);
        return text.replace(place, part.size(), other);
    };
    const std::vector<std::pair<std::string, std::string>> edits = {
        {"w*x[1]", "v*x[1]"},
        {"w*x[1]", "w*y[1]"},
        {"w*x[1]", "w*tau"},
        {"w*x[1]", "h*x[1]"},
        {"w*x[1]", "roots(w)"},
        {"w*x[1]", "i*x[1]"},
        {"w = 2", "x = 2"},
        {"w = 2", "w = \"x[1]\""},
        {"w = 2", "w = \"v\""},
        {"w = 2", "w = \"t\""},
        {"w = 2", "w = \"w + 1\""},
        {"w = 2", "2w = 2"},
        {"w = 2", "pi = 2"},
        {"w = 2\n", "w = 2\n[definitions]\nw = 3\n"},
        {"\"i/10\"", "\"v*i\""},
        {"\"i/10\"", "\"p[i]\""},
        {"\"i/10\"", "\"t\""},
        {"[run]", "[invariants]\nx = \"w\"\n[run]"},
        {"[run]", "[invariants]\na = \"b\"\n[run]"},
        {"[run]", "[invariants]\na = \"t\"\n[run]"},
        {"[run]", "[invariants]\nsin = \"w\"\n[run]"},
        {"[run]", "[symmetries]\nw = {\"x[i]\" = 1}\n[run]"},
        {"momenta = \"p[1..N]\"", "momenta = \"x[1..N]\""},
        {"momenta = \"p[1..N]\"", "momenta = \"e[1..N]\""},
        {"1/100", "1/v"},
        {"1/100", "x/100"},
    };
    for (const auto& [part, other] : edits) {
        const std::string scene = edited(part, other);
        INFO(other);
        CHECK(error(scene, "yes") == error(scene, "no"));
    }
}

TEST_CASE("factors of sparse matrices are not computed in __float128") {
    const Directory directory;
    write(directory / "plane.toml",
          "coordinates = \"x[1..N,1..N]\"\nmomenta = \"p[1..N,1..N]\"\nhamiltonian = "
          "\"sum(i=1..N, j=1..N, p[i,j]^2/2 + (x[mod(i,N)+1,j]-x[i,j])^2/2)\"\n[parameters]\nN = "
          "5\n[initial]\n\"x[i,j]\" = \"i/10\"\n\"p[i,j]\" = 0\n");
    std::vector<std::string> words{"stepper",    "plane.toml", "--method", "gauss:2",
                                   "--float128", "--unroll",   "no"};
    const Outcome refused = hvi_gen(words, directory.path());
    INFO(refused.err);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("--float128 does not go with factors") != std::string::npos);
    check_form(refused.err);
    words.insert(words.end(), {"--solver", "fixed-point"});
    CHECK(hvi_gen(words, directory.path()).status == 0);
}

TEST_CASE("a report of loops refuses a method that these do not have") {
    const Directory directory;
    write(directory / "pairs.toml", pairs(" + sum(i=1..N, p[i]^4)"));
    const Outcome refused = hvi_gen({"report", "pairs.toml", "--basis", "1, tau", "--nodes",
                                     "gauss:3", "--unroll", "no", "-o", "out"},
                                    directory.path());
    INFO(refused.err);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("more nodes than functions") != std::string::npos);
    check_form(refused.err);
}
