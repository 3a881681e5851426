// Every refusal of CONTRACT.md: its status, its message, and that nothing else is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"

using namespace hvi::test;

namespace {

/// The text above the caret of a message, from the caret on as far as it is underlined.
std::string pointed_at(const std::string& message) {
    const auto lines = lines_of(message);
    if (lines.size() < 3 || lines[2].find('^') == std::string::npos) return "";
    const std::size_t begin = lines[2].find('^');
    return begin > lines[1].size() ? "" : lines[1].substr(begin, lines[2].size() - begin);
}

bool has_place(const std::string& message) {
    const auto lines = lines_of(message);
    return lines.size() > 2 && lines[2].find('^') != std::string::npos;
}

/// error: WHAT, then perhaps a place of two lines, then perhaps help: WHAT WOULD HELP.
void check_form(const std::string& message) {
    const auto lines = lines_of(message);
    REQUIRE(!lines.empty());
    std::size_t next = 1;
    CHECK(lines[0].rfind("error: ", 0) == 0);
    if (next < lines.size() && lines[next].rfind("  ", 0) == 0) {
        REQUIRE(lines.size() > next + 1);
        CHECK(lines[next + 1].find_first_not_of(' ') == lines[next + 1].find('^'));
        CHECK(lines[next + 1].find_first_not_of(" ^~") == std::string::npos);
        next += 2;
    }
    if (next < lines.size() && lines[next].rfind("help: ", 0) == 0) ++next;
    CHECK(next == lines.size());
    for (const std::string& line : lines) CHECK(line.size() < 700);
}

struct Refusal {
    int status;
    std::string place;  ///< what the caret underlines; empty where it points to no text
    std::vector<std::string> words;
};

void check_refused(const Refusal& refusal, const std::vector<std::string>& words) {
    const Directory directory;
    write(directory / "old.hpp", "old");
    const Outcome outcome = hvi_gen(words, directory.path());
    std::string line;
    for (const std::string& word : words) line += word.substr(0, 200) + " | ";
    INFO(line << "\n" << outcome.err);
    CHECK(outcome.status == refusal.status);
    CHECK(outcome.out.empty());
    check_form(outcome.err);
    if (refusal.status == 2) CHECK(has_place(outcome.err));
    if (!refusal.place.empty()) CHECK(pointed_at(outcome.err) == refusal.place);
    CHECK(directory.names() == std::vector<std::string>{"old.hpp"});
    CHECK(contents(directory / "old.hpp") == "old");
}

/// A METHOD that is refused by `tableau` and by `stepper`, with a file of results and without.
void check_method_refused(const Refusal& refusal) {
    const std::vector<std::vector<std::string>> commands = {
        {"tableau"}, {"tableau", "-o", "old.hpp"}, {"stepper", "-o", "new.hpp"}};
    for (std::vector<std::string> words : commands) {
        words.insert(words.end(), refusal.words.begin(), refusal.words.end());
        check_refused(refusal, words);
    }
}

}  // namespace

TEST_CASE("mathematics forbids it: status 1") {
    const std::vector<Refusal> refusals = {
        // M singular
        {1, "", {"--basis", "1, cos(2*pi*tau)", "--nodes", "0, 1"}},
        {1, "", {"--basis", "1, sin(pi*tau)", "--nodes", "0, 1"}},
        {1, "", {"--basis", "1, tau", "--nodes", "1/2, 1/2"}},
        // a weight is zero
        {1, "", {"--basis", "1, tau, tau^2", "--nodes", "0, 1/3, 1"}},
        {1, "", {"--basis", "1, cos(pi*tau)", "--nodes", "0, 1/2"}},
        // nodes not real
        {1, "chebyshev:8", {"--method", "chebyshev:8"}},
        {1, "", {"--basis", "monomials:10", "--nodes", "chebyshev:10"}},
        {1, "", {"--basis", "1, tau", "--nodes", "roots(tau^2 + 1)"}},
        {1, "sqrt(-1)", {"--basis", "1, tau", "--nodes", "sqrt(-1), 1"}},
        {1, "log(0)", {"--basis", "1, tau", "--nodes", "log(0), 1"}},
        // fewer nodes than functions
        {1, "", {"--basis", "1, tau", "--nodes", "1/2"}},
        // a function not integrable on [0,1]
        {1, "tau", {"--basis", "1, 1/tau", "--nodes", "0, 1"}},
        {1, "(tau - 1/2)", {"--basis", "1, (tau - 1/2)^(-1)", "--nodes", "0, 1"}},
        {1, "tau^(-3/2)", {"--basis", "1, tau^(-3/2)", "--nodes", "1/2, 1"}},
        // a function without a real value everywhere, or without one at a node
        {1, "tau", {"--basis", "1, sin(tau)/tau", "--nodes", "0, 1"}},
        {1, "sqrt(tau - 1/2)", {"--basis", "1, sqrt(tau - 1/2)", "--nodes", "1/2, 1"}},
        {1, "log(tau)", {"--basis", "1, log(tau)", "--nodes", "0, 1"}},
        {1, "(1+tau)", {"--basis", "1, 1/(1+tau)", "--nodes", "-1, 1"}},
        // constants not in the span
        {1, "", {"--basis", "tau", "--nodes", "1/2"}},
        {1, "", {"--basis", "tau, tau^2", "--nodes", "1/2, 1"}},
    };
    for (const Refusal& refusal : refusals) check_method_refused(refusal);
}

TEST_CASE("a method that cannot be read: status 2") {
    const std::string deep(100000, '(');
    const std::string long_list = [] {
        std::string text = "1";
        for (int i = 0; i < 25000; ++i) text += ",tau";
        return text;
    }();
    const std::vector<Refusal> refusals = {
        // syntax
        {2, "", {"--basis", "1, cos(pi*tau", "--nodes", "0, 1"}},
        {2, ")", {"--basis", "1, tau)", "--nodes", "0, 1"}},
        {2, "", {"--basis", "1, ", "--nodes", "0, 1"}},
        {2, "", {"--basis", "", "--nodes", "0, 1"}},
        {2, "#", {"--basis", "1, tau # 2", "--nodes", "0, 1"}},
        {2, "", {"--basis", "1, tau", "--nodes", "0 1"}},
        {2, "", {"--basis", deep, "--nodes", "0"}},
        {2, "", {"--basis", long_list, "--nodes", "0"}},
        {2, "", {"--basis", "1, \x1b[31mtau", "--nodes", "0, 1"}},
        {2, "", {"--basis", "1, tau\xff\xfe", "--nodes", "0, 1"}},
        // unknown names
        {2, "gaus:3", {"--method", "gaus:3"}},
        {2, "gaus:2", {"--basis", "monomials:2", "--nodes", "gaus:2"}},
        {2, "coz", {"--basis", "1, coz(pi*tau)", "--nodes", "0, 1"}},
        {2, "", {"--method", ""}},
        {2, "", {"--method", "gauss"}},
        // out of range
        {2, "", {"--method", "gauss:0"}},
        {2, "", {"--method", "gauss:65"}},
        {2, "", {"--method", "gauss:99999999999999999999"}},
        {2, "", {"--method", "gauss:-1"}},
        {2, "", {"--method", "lobatto:1"}},
        {2, "", {"--method", "newton-cotes:1"}},
        {2, "", {"--method", "clenshaw-curtis:1"}},
        {2, "", {"--basis", "trig:65", "--nodes", "gauss:2"}},
        // no number
        {2, "", {"--basis", "1, tau", "--nodes", "1/0, 1"}},
        {2, "", {"--basis", "1, tau/0", "--nodes", "0, 1"}},
        {2, "tau", {"--basis", "1, tau", "--nodes", "0, tau"}},
        // parameters
        {2, "", {"--method", "gauss:2", "--param", "w=2"}},
        {2, "", {"--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--param", "w"}},
        {2, "", {"--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--param", "w=1/0"}},
        {2, "", {"--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--param", "pi=3"}},
        {2,
         "",
         {"--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--param", "w=1", "--param", "w=2"}},
        {2, "", {"--basis", "1, cos(h*tau)", "--nodes", "0, 1"}},
        {2, "(w+tau)", {"--basis", "1, 1/(w+tau)", "--nodes", "0, 1"}},
        {2, "", {"--basis", "1, exp(tau^2), cos(w*tau)", "--nodes", "0, 1/2, 1"}},
        // B-splines
        {2, "bspline(2,1)", {"--basis", "1, bspline(2,1)", "--nodes", "0, 1"}},
        {2, "64", {"--basis", "1, bspline(1,64)", "--nodes", "0, 1"}},
        // missing files
        {2, "", {"--method-file", "missing.toml"}},
        {2, "", {"--method-file", "."}},
        // to come
        {2, "log(tau)*exp(tau)", {"--basis", "1, log(tau)*exp(tau)", "--nodes", "1/2, 1"}},
        {2, "", {"--basis", "1, tau", "--nodes", "0, 1", "--weights", "1/2, 1/2"}},
        {2, "", {"--basis", "1, tau", "--nodes", "0, 1/2, 1"}},
    };
    for (const Refusal& refusal : refusals) check_method_refused(refusal);
}

TEST_CASE("a method file that cannot be read: status 2") {
    const std::vector<std::string> files = {
        "",
        "basis = \"1, tau\"",
        "nodes = \"0, 1\"",
        "basis = \"1, tau\"\nnodes = \"0, 1\"\nunknown = 1\n",
        "basis = 1\nnodes = \"0, 1\"\n",
        "basis = \"1, tau\nnodes = \"0, 1\"\n",
        "basis = \"1, coz(tau)\"\nnodes = \"0, 1\"\n",
        "basis = \"1, tau\"\nnodes = \"0, 1/0\"\n",
        "basis = \"1, tau\"\nnodes = \"0, 1\"\nweights = \"1/2, 1/2\"\n",
        "basis = \"1, cos(pi*tau)\"\nnodes = \"0, 1\"\n[parameters]\npi = 3\n",
        std::string("basis = \"1\"\0nodes", 17),
    };
    const Directory directory;
    for (const std::string& file : files) {
        write(directory / "method.toml", file);
        const Outcome outcome =
            hvi_gen({"tableau", "--method-file", "method.toml", "-o", "new"}, directory.path());
        INFO(file << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(has_place(outcome.err));
        CHECK(outcome.err.find("method.toml") != std::string::npos);
        CHECK(directory.names() == std::vector<std::string>{"method.toml"});
    }
}

TEST_CASE("a command line that cannot be read: status 2") {
    const std::vector<Refusal> refusals = {
        {2, "", {}},
        {2, "tableu", {"tableu", "--method", "gauss:2"}},
        {2, "--method", {"--method", "gauss:2", "tableau"}},
        {2, "--digitz", {"tableau", "--method", "gauss:2", "--digitz", "5"}},
        {2, "-x", {"tableau", "-x", "--method", "gauss:2"}},
        {2, "gauss:2", {"tableau", "gauss:2"}},
        {2, "list", {"tableau", "--method", "gauss:2", "list"}},
        // METHOD: none, twice, mixed, half
        {2, "", {"tableau"}},
        {2, "", {"stepper", "--separable"}},
        {2, "--method", {"tableau", "--method", "gauss:2", "--method", "gauss:3"}},
        {2, "--method=gauss:3", {"tableau", "--method=gauss:2", "--method=gauss:3"}},
        {2, "--basis", {"tableau", "--method", "gauss:2", "--basis", "1"}},
        {2, "--nodes", {"tableau", "--method", "gauss:2", "--nodes", "1"}},
        {2, "--method-file", {"tableau", "--method", "gauss:2", "--method-file", "a.toml"}},
        {2,
         "--method-file",
         {"tableau", "--basis", "1", "--nodes", "1", "--method-file", "a.toml"}},
        {2, "--basis", {"tableau", "--basis", "1"}},
        {2, "--nodes", {"tableau", "--nodes", "1"}},
        {2, "--weights", {"tableau", "--weights", "1"}},
        // values
        {2, "--method", {"tableau", "--method"}},
        {2, "--method", {"tableau", "--method", "--digits", "5"}},
        {2, "-o", {"tableau", "--method", "gauss:2", "-o"}},
        {2, "-o", {"tableau", "--method", "gauss:2", "-o", "--digits", "5"}},
        {2, "--output", {"tableau", "--method", "gauss:2", "-o", "a", "--output", "b"}},
        {2, "-o", {"tableau", "--method", "gauss:2", "-o", ""}},
        {2, "yaml", {"tableau", "--method", "gauss:2", "--format", "yaml"}},
        {2, "0", {"tableau", "--method", "gauss:2", "--digits", "0"}},
        {2, "-3", {"tableau", "--method", "gauss:2", "--digits", "-3"}},
        {2, "1e3", {"tableau", "--method", "gauss:2", "--digits", "1e3"}},
        {2, "10001", {"tableau", "--method", "gauss:2", "--digits", "10001"}},
        {2, "99999999999", {"tableau", "--method", "gauss:2", "--digits", "99999999999"}},
        {2, "--separable=maybe", {"stepper", "--method", "gauss:2", "--separable=maybe"}},
        {2, "", {"stepper", "--method", "gauss:2", "--name", "class"}},
        {2, "", {"stepper", "--method", "gauss:2", "--name", "1st"}},
        {2, "", {"stepper", "--method", "gauss:2", "--name", "a b"}},
        {2, "", {"stepper", "--method", "gauss:2", "--name", "_Reserved"}},
        {2, "", {"stepper", "--method", "gauss:2", "--name", ""}},
        {2, "method", {"list", "method"}},
        {2, "nodes", {"list", "bases", "nodes"}},
        // a tableau from elsewhere
        {2, "mine.json", {"check", "--tableau", "mine.json"}},
        {2, "--tableau", {"check", "--tableau", "mine.json", "--method", "gauss:2"}},
        {2, "--tableau", {"check", "--tableau", "a.json", "--tableau", "b.json"}},
        {2, "--tableau", {"check", "--tableau", ""}},
        {2, "--tableau", {"check", "--tableau"}},
        {2, "--tableau", {"tableau", "--tableau", "mine.json"}},
        // to come
        {2, "21", {"check", "--method", "gauss:2", "--max-order", "21"}},
        {2, "0", {"check", "--method", "gauss:2", "--max-order", "0"}},
        {2, "latex", {"check", "--method", "gauss:2", "--format", "latex"}},
        {2, "x.svg", {"check", "--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--plot", "x.svg"}},
        {2, "scene.toml", {"stepper", "--method", "gauss:2", "scene.toml"}},
        {2, "w", {"stepper", "--method", "gauss:2", "--hamiltonian", "p^2/2+w*q"}},
        {2, "(q-q)", {"stepper", "--method", "gauss:2", "--hamiltonian", "p^2/2+1/(q-q)"}},
        {1, "log(-1)", {"stepper", "--method", "gauss:2", "--hamiltonian", "p^2+log(-1)*q"}},
        {2, "--energy", {"stepper", "--method", "gauss:2", "--energy"}},
        {2, "--invariants", {"stepper", "--method", "gauss:2", "--invariants"}},
        {2, "--dense", {"stepper", "--method", "gauss:2", "--dense"}},
        {2, "--float128", {"stepper", "--method", "gauss:2", "--float128"}},
        {2, "--float128=3", {"stepper", "--method", "gauss:2", "--float128=3", "kepler"}},
        {2, "--dense=3", {"stepper", "--method", "gauss:2", "--dense=3", "kepler"}},
        {2,
         "tau*sin(tau)",
         {"stepper", "--basis", "1, tau*sin(tau)", "--nodes", "0, 1", "--dense", "qp"}},
        {2,
         "1, cos(w*tau)",
         {"stepper", "--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--dense", "qp"}},
        {2,
         "position",
         {"stepper", "--method", "gauss:2", "--name", "position", "--dense", "kepler"}},
        {2, "--lanes", {"stepper", "--method", "gauss:2", "--lanes", "ensemble"}},
        {2, "ensemble", {"run", "pendulum", "--lanes", "ensemble"}},
        {2, "ensemble", {"stepper", "--method", "lobatto:3", "--lanes", "ensemble", "kepler"}},
        {2,
         "ensemble",
         {"stepper", "--method", "gauss:2", "--lanes", "ensemble", "--dense", "kepler"}},
        {2, "kahan-li:8", {"stepper", "--method", "gauss:9", "--compose", "kahan-li:8", "kepler"}},
        {2, "kahan-li:8", {"stepper", "--method", "gauss:9", "--compose", "kahan-li:8"}},
        {2,
         "yoshida:4",
         {"stepper", "--basis", "1, cos(w*tau)", "--nodes", "0, 1", "--compose", "yoshida:4"}},
        {2,
         "yoshida:4",
         {"stepper", "--method", "gauss:2", "--compose", "yoshida:4", "--dense", "kepler"}},
        {1,
         "yoshida:4",
         {"stepper", "--method", "symplectic-euler", "--compose", "yoshida:4", "kepler"}},
        {2,
         "--basis \"1, cos(w*tau)\" --nodes \"0, 1\"",
         {"run", "--basis", "1, cos(w*tau)", "--nodes", "0, 1", "kepler"}},
        {2, "--solver", {"stepper", "--method", "gauss:2", "--solver", "newton"}},
        {2, "fast", {"stepper", "--method", "gauss:2", "--solver", "fast", "kepler"}},
        {2, "--separable", {"stepper", "--method", "gauss:2", "--separable", "kepler"}},
        {2, "keppler", {"stepper", "--method", "gauss:2", "keppler"}},
        {2, "kepler", {"stepper", "kepler", "--hamiltonian", "q*p"}},
        {2, "--coordinates", {"stepper", "--method", "gauss:2", "--coordinates", "q"}},
        {2, "mass", {"stepper", "--param", "mass=2", "kepler"}},
        {1, "(1 - ecc)", {"stepper", "--param", "ecc=1", "kepler"}},
        {1, "sqrt(mu*(1 + ecc)/(1 - ecc))", {"stepper", "--param", "ecc=2", "kepler"}},
        {1, "(2*m[i])", {"stepper", "--param", "m[3]=0", "outer-solar-system"}},
    };
    for (const Refusal& refusal : refusals) check_refused(refusal, refusal.words);
}

TEST_CASE("a tableau that cannot be read: status 2, and the line") {
    const Directory directory;
    const auto refused = [&](const std::string& text, const std::vector<std::string>& more = {}) {
        write(directory / "t.json", text);
        std::vector<std::string> words = {"check", "--tableau", "t.json", "-o", "new"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = hvi_gen(words, directory.path());
        INFO(text << outcome.err);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(directory.names() == std::vector<std::string>{"t.json"});
        return outcome;
    };
    const Outcome comma = refused("{\"A\": [[0]],\n \"b\": [1,], \"c\": [0]}");
    CHECK(comma.status == 2);
    CHECK(pointed_at(comma.err) == "]");
    CHECK(comma.err.find("t.json:2") != std::string::npos);
    CHECK(pointed_at(refused("{\"A\": [[\"1/0\"]], \"b\": [1], \"c\": [0]}").err) == "0");
    CHECK(pointed_at(refused("{\"A\": [[1, 2]], \"b\": [1], \"c\": [0]}").err) == "[1, 2]");
    CHECK(refused("{\"A\": [[0]], \"b\": [1], \"c\": [0]}", {"--param", "w=1"}).status == 2);
    CHECK(refused("{\"A\": [[\"w\"]], \"b\": [1], \"c\": [0]}", {"--plot", "p.svg"}).status == 2);
    // Understood, but not real, or not known well enough.
    CHECK(refused("{\"A\": [[\"sqrt(-1)\"]], \"b\": [1], \"c\": [0]}").status == 1);
    const std::string some_digits =
        "{\"A\": [[0.67560359597982889, 0], [1.3512071919596578, -0.1756035959798289]],"
        " \"b\": [1.3512071919596578, -0.3512071919596578],"
        " \"c\": [0.67560359597982889, 1.1756035959798289]}";
    CHECK(refused(some_digits, {"--plot", "p.svg"}).status == 1);
}

TEST_CASE("a Hamiltonian that cannot be read, or that mathematics forbids") {
    const std::vector<Refusal> refusals = {
        // the words of the command
        {2, "", {}},
        {2, "--hamiltonian", {"--hamiltonian", "q*p", "--hamiltonian", "q"}},
        {2, "--hamiltonian", {"--hamiltonian"}},
        {2, "--hamiltonian", {"--hamiltonian", "--generating"}},
        {2, "--coordinates", {"--hamiltonian", "x*p", "--coordinates", "x"}},
        {2, "--momenta", {"--hamiltonian", "x*p", "--momenta", "p"}},
        {2, "--generating=maybe", {"--hamiltonian", "q*p", "--generating=maybe"}},
        {2, "markdown", {"--hamiltonian", "q*p", "--format", "markdown"}},
        {2, "-o", {"--hamiltonian", "q*p", "-o"}},
        {2, "kepler", {"--hamiltonian", "q*p", "kepler"}},
        {2, "kepler", {"kepler", "--hamiltonian", "q*p"}},
        // each option right before a word that it must leave alone
        {2, "kepler", {"--hamiltonian", "q*p", "--coordinates", "q", "--momenta", "p", "kepler"}},
        {2, "kepler", {"--hamiltonian", "q*p", "--format", "json", "kepler"}},
        {2, "kepler", {"--hamiltonian", "q*p", "--generating", "kepler"}},
        {2, "kepler", {"--hamiltonian", "q*p", "-o", "new", "kepler"}},
        {2, "kepler", {"--hamiltonian", "w*q*p", "--param", "w=1", "kepler"}},
        // names
        {2, "x^2", {"--hamiltonian", "x^2"}},
        {2, "pi", {"--hamiltonian", "q*p", "--coordinates", "pi", "--momenta", "p"}},
        {2, "h", {"--hamiltonian", "h*q*p"}},
        {2, "t", {"--hamiltonian", "q*p + t*q", "--param", "t=1"}},
        {1, "q*p + t*q", {"--hamiltonian", "q*p + t*q", "--generating"}},
        {2, "x", {"--hamiltonian", "x*p", "--coordinates", "x, y, x", "--momenta", "p, r, s"}},
        {2, "x", {"--hamiltonian", "x*p", "--coordinates", "x", "--momenta", "x"}},
        {2, "px", {"--hamiltonian", "x*px", "--coordinates", "x, y", "--momenta", "px"}},
        {2, "x[7]", {"--hamiltonian", "x[7]", "--coordinates", "x[1..6]", "--momenta", "p[1..6]"}},
        // scenes
        {2, "scene.toml", {"scene.toml"}},
        {2, "keplr", {"keplr"}},
        {2, "", {""}},
        {2, "qp", {"kepler", "qp"}},
        {2, "kepler", {"kepler", "--coordinates", "q", "--momenta", "p"}},
        {2, "ec", {"kepler", "--param", "ec=1"}},
        {2, "x", {"kepler", "--param", "x=1"}},
        {1, "(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)", {"--generating", "kepler"}},
        // values
        {2, "v", {"--hamiltonian", "w*q*p", "--param", "v=1"}},
        {2, "q", {"--hamiltonian", "w*q*p", "--param", "q=1"}},
        {2, "w", {"--hamiltonian", "w*q*p", "--param", "w=1", "--param", "w=2"}},
        {2, "p", {"--hamiltonian", "w*q*p", "--param", "w=p"}},
        // what stands in H
        {2, "(", {"--hamiltonian", "p^2/2 + cos(q"}},
        {2, "coz", {"--hamiltonian", "p^2/2 + coz(q)"}},
        {2, "0", {"--hamiltonian", "p^2/2 + q/0"}},
        {2, "1e9", {"--hamiltonian", "q^1e9"}},
        {2, "", {"--hamiltonian", std::string(100000, '(')}},
        {2, "", {"--hamiltonian", "q + \x1b[31m"}},
        {1, "sqrt(-2)", {"--hamiltonian", "p^2/2 + sqrt(-2)*q"}},
        {1, "p^2/2 - cos(q)", {"--generating", "--hamiltonian", "p^2/2 - cos(q)"}},
    };
    for (const Refusal& refusal : refusals) {
        std::vector<std::string> words = {"scheme", "--method", "gauss:2"};
        words.insert(words.end(), refusal.words.begin(), refusal.words.end());
        check_refused(refusal, words);
        if (std::find(words.begin(), words.end(), "-o") != words.end()) continue;
        words.insert(words.begin() + 1, {"-o", "old.hpp"});
        check_refused(refusal, words);
    }
    check_refused({2, "", {}}, {"scheme", "--hamiltonian", "q*p"});
    check_refused({2, "q", {}}, {"scheme", "--basis", "1, cos(q*tau)", "--nodes", "0, 1",
                                 "--hamiltonian", "q*p"});
    check_refused({1, "chebyshev:8", {}},
                  {"scheme", "--method", "chebyshev:8", "--hamiltonian", "q*p"});
}

TEST_CASE("a stepper takes one free parameter, in its place: status 2") {
    check_refused({2, "", {}},
                  {"stepper", "--basis", "1, cos(w*tau), sin(v*tau)", "--nodes", "0, 1/2, 1"});
    check_refused({2, "", {}}, {"stepper", "--basis", "1, cos(w^2*tau)", "--nodes", "0, 1"});
    check_refused({2, "", {}}, {"stepper", "--basis", "1, cos(w*tau + v)", "--nodes", "0, 1"});
}

TEST_CASE("a constant that H simplifies to, and that has no value, is refused") {
    const auto check = [](int status, const std::string& place, const std::string& H) {
        check_refused({status, place, {}},
                      {"stepper", "--method", "gauss:1", "--hamiltonian", H + "+p^2/2"});
    };
    check(1, "log(0)", "q^4*log(q-q)");
    check(1, "sqrt(-1)", "q^4*sqrt(-q/q)");
    check(1, "asin(2)", "q^4*asin(2*q/q)");
    check(2, "log(1)", "q^4/log(q/q)");
    check(2, "sin(pi)", "q^4/sin(pi*q/q)");
    check(2, "(q-q)", "q^4/(q-q)");
    check(1, "", "q^4*exp(exp(exp(10*q/q)))");
    check(1, "", "q^4*exp(-exp(exp(10)))");
}

TEST_CASE("names that a header cannot have: status 2") {
    for (const std::string name : {"NULL", "M_PI", "EOF", "linux", "assert"})
        check_refused({2, name, {}}, {"stepper", "--method", "gauss:2", "--name", name});
    const Directory directory;
    const std::string scene = (directory / "scene.toml").string();
    const std::string H = "coordinates = \"q\"\nmomenta = \"p\"\nhamiltonian = \"p^2/2+q^4\"\n"
                          "[initial]\nq = 1\np = 0\n";
    write(scene, H + "[invariants]\nerrno = \"p^2+q^4\"\n");
    check_refused({2, "p^2+q^4", {}}, {"stepper", "--method", "gauss:2", scene, "--invariants"});
    write(scene, H + "[parameters]\nNAN = 1\nNAN_ = 2\n");
    check_refused({2, "NAN_", {}}, {"stepper", "--method", "gauss:2", scene});
}

TEST_CASE("a parameter without a value among the real numbers: status 1, and where") {
    const Directory directory;
    const std::vector<std::pair<std::string, std::string>> values = {
        {"1/0", "0"},          {"1/(1 - 1)", "(1 - 1)"},   {"sqrt(-1)", "sqrt(-1)"},
        {"log(0)", "log(0)"},  {"tan(pi/2)", "tan(pi/2)"}, {"1/(sqrt(2)^2 - 2)", "(sqrt(2)^2 - 2)"},
        {"acos(2)", "acos(2)"}};
    const std::string scene = "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                              "hamiltonian = \"p^2/2 + w*q^2/2\"\n[initial]\nq = 1\np = 0\n"
                              "[run]\nmethod = \"gauss:2\"\nstep = \"1/10\"\nuntil = 1\n"
                              "[parameters]\nw = \"";
    const std::vector<std::vector<std::string>> commands = {{"run"},
                                                            {"run", "--accuracy", "1e-6"},
                                                            {"report", "-o", "new"},
                                                            {"stepper"},
                                                            {"stepper", "--accuracy", "1e-6"}};
    const auto check = [&](const std::vector<std::string>& words, const std::string& place,
                           const std::string& name) {
        const Outcome outcome = hvi_gen(words, directory.path());
        INFO(words.front() << " " << words.back() << "\n" << outcome.err);
        CHECK(outcome.status == 1);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(outcome.err.find("in the value of `") != std::string::npos);
        CHECK(outcome.err.find("  " + name + ": ") != std::string::npos);
        CHECK(pointed_at(outcome.err) == place);
        CHECK(directory.names() == std::vector<std::string>{"scene.toml"});
    };
    for (const auto& [value, place] : values) {
        write(directory / "scene.toml", scene + value + "\"\n");
        for (std::vector<std::string> words : commands) {
            words.emplace_back("scene.toml");
            check(words, place, "scene.toml:12");
            if (words.front() == "report") continue;  // which takes no parameters
            words.back() = "kepler";
            words.insert(words.end(), {"--param", "ecc=" + value});
            check(words, place, "--param");
        }
        check({"stepper", "--method", "gauss:2", "--hamiltonian", "p^2/2+w*q", "--param",
               "w=" + value},
              place, "--param");
        check({"scheme", "--method", "gauss:2", "kepler", "--param", "mu=" + value}, place,
              "--param");
    }
}

TEST_CASE("what a method file gives to a parameter is pointed at in its own text") {
    const Directory directory;
    write(directory / "method.toml",
          "basis = \"1, cos(w*tau)\"\nnodes = \"0, 1\"\n[parameters]\nw = \"2 + 1/0\"\n");
    const Outcome outcome = hvi_gen({"tableau", "--method-file", "method.toml"}, directory.path());
    CHECK(outcome.status == 2);
    CHECK(outcome.err == "error: division by zero\n"
                         "  method.toml:4: 2 + 1/0\n"
                         "                       ^\n");
}

TEST_CASE("a scene that lacks something is pointed at") {
    const Directory directory;
    write(directory / "scene.toml", "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                    "hamiltonian = \"p^2/2\"\n[initial]\nq = 1\np = 0\n");
    const std::vector<std::vector<std::string>> commands = {
        {"run", "scene.toml"},
        {"run", "scene.toml", "--method", "gauss:2"},
        {"run", "scene.toml", "--method", "gauss:2", "--step", "1"},
        {"stepper", "scene.toml"},
        {"report", "scene.toml"}};
    for (const std::vector<std::string>& words : commands) {
        const Outcome outcome = hvi_gen(words, directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(pointed_at(outcome.err) == "scene.toml");
    }
}

TEST_CASE("words of any length make short messages") {
    const std::string word(100000, 'x');
    const std::vector<std::vector<std::string>> commands = {
        {word},
        {"tableau", "--" + word},
        {"tableau", word},
        {"tableau", "--method", word},
        {"tableau", "--method", "gauss:2", "--format", word},
        {"tableau", "--method", "gauss:2", "--param", word + "=1"},
        {"tableau", "--basis", "1", "--nodes", word + "(2)"},
        {"run", "kepler", "--only", word},
        {"run", "kepler", "--compose", word},
        {"stepper", "--method", "gauss:2", "--name", word + "!"},
        {"check", "--tableau", word},
        {"report", "kepler", "--methods", "gauss:2-" + word}};
    for (const std::vector<std::string>& words : commands) {
        const Outcome outcome = hvi_gen(words);
        INFO(words.front().substr(0, 20) << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(has_place(outcome.err));
        for (const std::string& line : lines_of(outcome.err)) CHECK(line.size() < 250);
    }
    const Outcome path = hvi_gen({"tableau", "--method", "gauss:2", "-o", "/tmp/" + word});
    CHECK(path.status == 3);
    CHECK(path.err.size() < 200);
    CHECK(path.err.find("File name too long") != std::string::npos);
}

TEST_CASE("help points to what was meant") {
    CHECK(hvi_gen({"tableau", "--method", "gaus:3"}).err.find("gauss") != std::string::npos);
    CHECK(hvi_gen({"tableu"}).err.find("`tableau`") != std::string::npos);
    CHECK(hvi_gen({"tableau", "--methd", "x"}).err.find("`--method`") != std::string::npos);
    CHECK(hvi_gen({"tableau", "gauss:3"}).err.find("--method") != std::string::npos);
}
