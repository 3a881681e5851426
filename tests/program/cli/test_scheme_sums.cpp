// `hvi-gen scheme` of scenes with indices: sums that are written out, or stay sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "tests/program/cli/refusals.hpp"
#include "tests/program/cli/results.hpp"

using namespace hvi::test;

namespace {

std::vector<std::string> scheme_of_chain(const std::string& size,
                                         const std::vector<std::string>& more = {}) {
    return with({"scheme", "--method", "gauss:2", "fpu-chain", "--param", "N=" + size}, more);
}

bool stay_sums(const std::string& text) {
    const bool with_index = text.find("\n Q_1[k] = ") != std::string::npos;
    CHECK(with_index != (text.find("\n Q_1[1] = ") != std::string::npos));
    return with_index;
}

std::string printed(const std::vector<std::string>& words) {
    const Outcome outcome = hvi_gen(words);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    return outcome.out;
}

/// Checks that the message names the feature without sums, and has help.
void check_no_sums(const std::vector<std::string>& words, const std::string& what) {
    const Outcome outcome = hvi_gen(words);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    check_form(outcome.err);
    CHECK(has_place(outcome.err));
    CHECK(outcome.err.find(what) != std::string::npos);
    CHECK(outcome.err.find("--unroll yes") != std::string::npos);
}

}  // namespace

TEST_CASE("scheme writes sums out for few degrees of freedom, or as is wished") {
    CHECK_FALSE(stay_sums(printed(scheme_of_chain("8"))));
    CHECK(stay_sums(printed(scheme_of_chain("9"))));
    CHECK(stay_sums(printed(scheme_of_chain("8", {"--unroll", "no"}))));
    CHECK_FALSE(stay_sums(printed(scheme_of_chain("9", {"--unroll", "yes"}))));
    CHECK_FALSE(stay_sums(printed(scheme_of_chain("9", {"--series", "1"}))));
    CHECK(printed(scheme_of_chain("9", {"--lagrangian"})).find("\n q[1]' = ") != std::string::npos);
    CHECK(printed(scheme_of_chain("9", {"--unroll", "auto"})) == printed(scheme_of_chain("9")));
}

TEST_CASE("a step of a chain of 1024 fits on a page of scheme") {
    const std::string text = same_every_time(scheme_of_chain("1024"));
    CHECK(std::count(text.begin(), text.end(), '\n') < 60);
    for (const char* part : {"values        N = 1024\n", "  for k=2..N\n", "  for k=N\n"})
        CHECK(text.find(part) != std::string::npos);
    const std::string json = same_every_time(scheme_of_chain("1024", {"--format", "json"}));
    CHECK(json.find("\"schema\": \"hvi-scheme-loops/1\"") != std::string::npos);
    const std::string latex =
        same_every_time(scheme_of_chain("9", {"--unroll", "no", "--format", "latex"}));
    CHECK(latex.find("% hvi-gen scheme --method gauss:2 fpu-chain --param \"N=9\" --unroll no "
                     "--format latex\n") == 0);
}

TEST_CASE("scheme puts in the values that are given, and knows no other names") {
    const std::string text = printed(scheme_of_chain("20", {"--param", "alpha=6"}));
    CHECK(text.find("parameters    beta\nvalues        N = 20, alpha = 6\n") != std::string::npos);
    CHECK(text.substr(text.find("derivatives")).find("alpha") == std::string::npos);
    check_refused({2, "gamma", {}}, scheme_of_chain("20", {"--param", "gamma=1"}));
    const Outcome named =
        hvi_gen({"scheme", "--basis", "1, cos(q*tau)", "--nodes", "0, 1", "fpu-chain"});
    CHECK(named.status == 2);
    CHECK(pointed_at(named.err) == "q");
    check_refused({2, "--unroll", {}},
                  {"scheme", "--method", "gauss:2", "--hamiltonian", "q*p", "--unroll", "no"});
}

TEST_CASE("what scheme does not have of sums is refused, or written out where it may be") {
    check_no_sums(scheme_of_chain("20", {"--unroll", "no", "--lagrangian"}), "--lagrangian");
    check_no_sums(scheme_of_chain("20", {"--unroll", "no", "--generating"}), "--generating");
    check_no_sums(scheme_of_chain("20", {"--unroll", "no", "--series", "2"}), "--series");
    const auto general = [](const std::string& size) {
        return std::vector<std::string>{"scheme",  "--basis",   "1",       "--nodes",
                                        "gauss:2", "fpu-chain", "--param", "N=" + size};
    };
    check_no_sums(general("1024"), "as many nodes as functions");
    CHECK(printed(general("9")).find("\n q[1]' = ") != std::string::npos);

    const Directory directory;
    const std::string head = "coordinates = \"x[1..N]\"\nmomenta = \"p[1..N]\"\nhamiltonian = \"";
    const std::string tail = "\"\n[parameters]\nN = 20\n[initial]\n\"x[i]\" = 1\n\"p[i]\" = 0\n";
    write(directory / "even.toml", head + "sum(i=1..N, p[i]^2/2) + sum(i=1..10, x[2*i]^4)" + tail);
    std::vector<std::string> words{"scheme", "--method", "gauss:2", "even.toml"};
    CHECK(hvi_gen(words, directory.path()).out.find("\n P_1[2] = ") != std::string::npos);
    const Outcome even = hvi_gen(with(words, {"--unroll", "no"}), directory.path());
    CHECK(even.status == 2);
    check_form(even.err);
    CHECK(even.err.find("with the index 2*i has no formula") != std::string::npos);

    write(directory / "own.hpp", "");
    write(directory / "own.toml", head + "sum(i=1..N, p[i]^2/2 + V(x[i]))" + tail +
                                      "[functions]\nV = {header = \"own.hpp\", arguments = 1}\n");
    words.back() = "own.toml";
    const Outcome own = hvi_gen(words, directory.path());
    CHECK(own.status == 2);
    check_form(own.err);
    CHECK(own.err.find("`V` cannot stand in the exact equations of a step") != std::string::npos);
}

TEST_CASE("of a Lagrangian scheme prints the Hamiltonian with its sums") {
    const Directory directory;
    write(directory / "rails.toml",
          "coordinates = \"x[1..N]\"\nvelocities = \"v[1..N]\"\nlagrangian = \"sum(i=1..N, "
          "a*v[i]^2/2 - x[i]^4)\"\n[parameters]\nN = 300\na = 2\n[initial]\n\"x[i]\" = 1\n\"v[i]\" "
          "= 0\n");
    const Outcome outcome =
        hvi_gen({"scheme", "--method", "midpoint", "rails.toml"}, directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    INFO(outcome.out);
    CHECK(outcome.out.find("momenta       p_x[1..N]\n") != std::string::npos);
    CHECK(outcome.out.find("\n dH_dp_x[k] = p_x[k]/a\n dH_dx[k] = 4*x[k]^3\n") !=
          std::string::npos);
}
