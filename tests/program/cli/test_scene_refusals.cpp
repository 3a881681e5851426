// Refusals of Hamiltonians, of scenes and of what is asked of them, as CONTRACT.md has them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/refusals.hpp"

using namespace hvi::test;

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
    write(scene, H + "[invariants]\nsystem_ = \"p^2+q^4\"\n");
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

TEST_CASE("values beyond the range of coefficients: status 1, and where") {
    const auto check = [](const std::string& command, const std::string& value) {
        check_refused({1, value, {"the value of `mu` is beyond the range of coefficients"}},
                      {command, "--method", "gauss:2", "kepler", "--param", "mu=" + value});
    };
    check("run", "10^400");
    check("run", "10^-400");
    check("stepper", "4^512-2^970");  // halfway to the double that there is not
    check("stepper", "-(4^512-2^970)");
    check("stepper", "2^-900-2^-999");
    for (const std::string value : {"4^512-2^970-1", "2^-900", "0"}) {
        CHECK(hvi_gen({"stepper", "--method", "gauss:2", "kepler", "--param", "mu=" + value})
                  .status == 0);
    }
    const Directory directory;
    write(directory / "scene.toml", "coordinates = \"q\"\nmomenta = \"p\"\n"
                                    "hamiltonian = \"p^2/2+q^2/2\"\n"
                                    "initial = {q = \"10^400\", p = 0}\n");
    const Outcome outcome =
        hvi_gen({"run", "scene.toml", "--method", "gauss:2", "--step", "1/10", "--until", "1"},
                directory.path());
    CHECK(outcome.status == 1);
    CHECK(outcome.err.find("the value of `q` is beyond the range of coefficients") !=
          std::string::npos);
    CHECK(pointed_at(outcome.err) == "10^400");
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

TEST_CASE("what cannot be done with bodies that turn") {
    const Directory directory;
    const std::string body = "rotations = [\"R\"]\nangular_momenta = [\"L\"]\nhamiltonian = "
                             "\"L[1]^2/2+L[2]^2/4+L[3]^2\"\n[initial]\nL = [1, 2, 3]\nR = ";
    const auto refused = [&](const std::string& rotation, const std::vector<std::string>& words) {
        write(directory / "body.toml", body + rotation + "\n");
        Outcome outcome = hvi_gen(words, directory.path());
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        return outcome;
    };
    const std::vector<std::string> stepper{"stepper", "--method", "gauss:2", "body.toml"};
    // Rotations by proof: a strain, a mirror, and eight digits that are near enough.
    const Outcome strained = refused("[1, 0, 0, 0, 1, \"1/1000\", 0, 0, 1]", stepper);
    CHECK(strained.status == 1);
    CHECK(strained.err.find("`R` begins with no rotation") != std::string::npos);
    CHECK(refused("[1, 0, 0, 0, -1, 0, 0, 0, 1]", stepper).err.find("determinant is -1") !=
          std::string::npos);
    write(directory / "body.toml",
          body + "[0.70710678, -0.70710678, 0, 0.70710678, 0.70710678, 0, 0, 0, 1]\n");
    CHECK(hvi_gen(stepper, directory.path()).status == 0);

    const std::string none = "\"identity\"";
    CHECK(refused(none, {"scheme", "--method", "gauss:2", "body.toml"}).status == 2);
    CHECK(refused(none, {"stepper", "--method", "gauss:2", "body.toml", "--action"}).status == 2);
    CHECK(refused(none, {"report", "body.toml", "--peers", "-o", "new"}).status == 2);
    CHECK(refused(none, {"stepper", "--basis", "1, tau", "--nodes", "0, 1/2, 1", "body.toml"})
              .status == 1);
    CHECK(refused(none, {"stepper", "--method", "gauss:2", "body.toml", "--lanes", "ensemble"})
              .status == 2);
    CHECK(
        refused(none, {"stepper", "--method", "gauss:2", "body.toml", "--solver", "newton-taylor"})
            .status == 2);
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

TEST_CASE("what has no Lagrangian, and which Lagrangians have no steps: status 1") {
    const auto refused = [](const Refusal& refusal, const std::vector<std::string>& words) {
        check_refused(refusal, words);
    };
    const std::vector<std::string> scheme = {"scheme", "--method", "gauss:2", "--lagrangian"};
    const auto lagrangian_of = [&](const std::string& H) {
        std::vector<std::string> words = scheme;
        words.insert(words.end(), {"--hamiltonian", H});
        return words;
    };
    refused({1, "q*p", {}}, lagrangian_of("q*p"));
    refused({1, "q*p + q", {}}, lagrangian_of("q*p + q"));
    refused({1, "sqrt(1+p^2)", {}}, lagrangian_of("sqrt(1+p^2)"));
    refused({2, "--generating", {}},
            {"scheme", "--method", "gauss:2", "--lagrangian", "--generating", "kepler"});
    const Outcome zero = hvi_gen(lagrangian_of("q*p"));
    CHECK(zero.err.find("error: the associated Lagrangian is identically zero\n") == 0);

    const Directory directory;
    const auto scene = [&](const std::string& name, const std::string& L) {
        write(directory / name, "coordinates = \"q\"\nvelocities = \"v\"\nlagrangian = \"" + L +
                                    "\"\n[initial]\nq = 1\nv = 0\n"
                                    "[run]\nmethod = \"gauss:2\"\nstep = 1\nuntil = 2\n");
        return (directory / name).string();
    };
    const std::string spring = scene("spring.toml", "v^2/2 - q^2/2");
    const std::string cubic = scene("cubic.toml", "v^3");
    const std::string flat = scene("flat.toml", "q*v");
    for (const std::string& file : {cubic, flat}) {
        refused({1, file == cubic ? "v^3" : "q*v", {}}, {"scheme", "--method", "gauss:2", file});
        refused({1, file == cubic ? "v^3" : "q*v", {}},
                {"scheme", "--method", "gauss:2", "--lagrangian", file});
        refused({1, file == cubic ? "v^3" : "q*v", {}}, {"stepper", "--method", "gauss:2", file});
        refused({1, file == cubic ? "v^3" : "q*v", {}}, {"run", file});
    }
    const std::vector<std::string> stepper = {"stepper", "--method", "gauss:2", spring};
    const auto with_words = [&](std::vector<std::string> more) {
        more.insert(more.begin(), stepper.begin(), stepper.end());
        return more;
    };
    CHECK(hvi_gen(stepper).status == 0);
    CHECK(hvi_gen(with_words({"--compose", "yoshida:4"})).status == 0);
    CHECK(hvi_gen(with_words({"--dense"})).status == 0);
    refused({2, "ensemble", {}}, with_words({"--lanes", "ensemble"}));
    refused({2, "stages", {}}, with_words({"--lanes", "stages"}));
    refused({2, "v^2/2 - q^2/2", {}}, with_words({"--solver", "newton-taylor"}));
}
