// Refusals of methods, of tableaux and of command lines, as CONTRACT.md has them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/options/option_table.hpp"
#include "tests/program/cli/refusals.hpp"

using namespace hvi::test;

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
        // weights
        {2, "1/2", {"--basis", "1, tau", "--nodes", "0, 1", "--weights", "1/2"}},
    };
    for (const Refusal& refusal : refusals) check_method_refused(refusal);
}

TEST_CASE("a method file that cannot be read: status 2") {
    const std::vector<std::string> files = {
        "",
        "basis = \"1, tau\"",
        "nodes = \"0, 1\"",
        "basis = \"1, tau\"\nnodes = \"0, 1\"\nunknown = 1\n",
        "basis = true\nnodes = \"0, 1\"\n",
        "basis = \"1, tau\nnodes = \"0, 1\"\n",
        "basis = \"1, coz(tau)\"\nnodes = \"0, 1\"\n",
        "basis = \"1, tau\"\nnodes = \"0, 1/0\"\n",
        "basis = \"1, tau\"\nnodes = \"0, 1\"\nweights = \"1/2, gauss:3\"\n",
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
        {2, "none", {"list", "splits", "heavy-top", "--split", "none"}},
        {2, "nodes", {"list", "bases", "nodes"}},
        {2, "", {"completions"}},
        {2, "tcsh", {"completions", "tcsh"}},
        {2, "zsh", {"completions", "bash", "zsh"}},
        {2, "bash", {"manual", "bash"}},
        // a tableau from elsewhere
        {2, "mine.json", {"check", "--tableau", "mine.json"}},
        {2, "--tableau", {"check", "--tableau", "mine.json", "--method", "gauss:2"}},
        {2, "--tableau", {"check", "--tableau", "a.json", "--tableau", "b.json"}},
        {2, "--tableau", {"check", "--tableau", ""}},
        {2, "--tableau", {"check", "--tableau"}},
        {2, "--tableau", {"tableau", "--tableau", "mine.json"}},
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
        {2, "--action", {"stepper", "--method", "gauss:2", "--action"}},
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
        {2, "ensemble", {"stepper", "--method", "gauss:2", "--lanes", "ensemble", "heavy-top"}},
        {2, "gpu", {"stepper", "--method", "strang", "--lanes", "gpu", "heavy-top"}},
        {2,
         "ensemble",
         {"stepper", "--method", "gauss:2", "--lanes", "ensemble", "--dense", "kepler"}},
        {2,
         "ensemble",
         {"stepper", "--method", "gauss:2", "--lanes", "ensemble", "--action", "kepler"}},
        {2,
         "stages",
         {"stepper", "--method", "gauss:2", "--lanes", "stages", "--action", "kepler"}},
        {2, "action", {"stepper", "--method", "gauss:2", "--name", "action", "kepler"}},
        {2,
         "q*p",
         {"stepper", "--method", "gauss:2", "--solver", "newton-taylor", "--action",
          "--hamiltonian", "q*p"}},
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
        {2, "1, cos(w*tau)", {"run", "--basis", "1, cos(w*tau)", "--nodes", "0, 1", "kepler"}},
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

TEST_CASE("help of what is no command is none") {
    check_refused({2, "nonsense", {}}, {"nonsense", "--help"});
    check_refused({2, "nonsense", {}}, {"nonsense", "tableau", "--help"});
    CHECK(hvi_gen({"tableau", "--help"}).status == 0);
}

TEST_CASE("a report of a scene without a step asks for --steps") {
    const Directory directory;
    write(directory / "own.toml", "coordinates = \"q\"\nmomenta = \"p\"\nhamiltonian = "
                                  "\"p^2/2-cos(q)\"\n[initial]\nq = 1\np = 0\n");
    const Outcome asks = hvi_gen({"report", "own.toml", "--until", "1"}, directory.path());
    CHECK(asks.status == 2);
    CHECK(asks.err.find("give --steps 1/10,1/20, or a section [run]") != std::string::npos);
    const Outcome none =
        hvi_gen({"run", "own.toml", "--method", "gauss:2", "--until", "1"}, directory.path());
    CHECK(none.err.find("give --step 1/10, or a section [run]") != std::string::npos);
    // The first of --steps is taken, and refused as one: it leads away from the end.
    const Outcome taken =
        hvi_gen({"report", "own.toml", "--until", "1", "--steps", "-1/10"}, directory.path());
    CHECK(taken.status == 1);
    CHECK(taken.err.find("lead away from the end") != std::string::npos);
}

TEST_CASE("what is to come is refused as such, whatever stands around it") {
    using hvi::gen::State;
    const auto check_to_come = [](const std::string& place, const std::vector<std::string>& words) {
        check_refused({2, place, {}}, words);
        CHECK(hvi_gen(words).err.rfind(
                  "error: " + place.substr(0, place.find('=')) + " is to come\n", 0) == 0);
    };
    std::size_t count = 0;
    for (const hvi::gen::CommandEntry& entry : hvi::gen::command_table()) {
        const std::string command(entry.name);
        if (entry.state == State::to_come) {
            ++count;
            for (const std::string more : {"kepler", "--help", "--seed=1"})
                check_to_come(command, {command, more});
        }
        for (const hvi::gen::OptionEntry* option :
             hvi::gen::options_of(entry.command, State::to_come)) {
            ++count;
            const std::string name(option->name);
            check_to_come(name, {command, name});
            check_to_come(name, {command, name, "3"});
            check_to_come(name, {command, "kepler", name, "--method", "gauss:2"});
            check_to_come(name + "=3", {command, name + "=3"});
        }
    }
    CHECK(count > 0);
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

TEST_CASE("what is nested as deep as the reader lets pass needs no large stack of the shell's") {
    const auto nested = [](const std::string& open, int levels) {
        std::string text = "p^2/2+";
        for (int k = 0; k < levels; ++k) text += open;
        return text + "q" + std::string(static_cast<std::size_t>(levels), ')');
    };
    for (const std::string open : {"sin(", "1-1/(2+", "min(2,"}) {
        const std::string H = " --hamiltonian '" + nested(open, open == "sin(" ? 190 : 95) + "'";
        for (const std::string command : {"stepper --method gauss:2", "scheme --method gauss:2"}) {
            const Outcome outcome = shell("ulimit -s 256; hvi-gen " + command + H);
            INFO(command << H << "\n" << outcome.err);
            CHECK(outcome.status == 0);
        }
    }
    CHECK(shell("ulimit -s 256; hvi-gen symmetries --hamiltonian '" + nested("sin(", 60) + "'")
              .status == 0);
    CHECK(shell("ulimit -s 256; hvi-gen symmetries --hamiltonian '" + nested("sin(", 250) + "'")
              .status == 2);
}
