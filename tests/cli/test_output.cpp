// What goes where when all is well, and what is left when the outside fails.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"

using namespace hvi::test;

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> tableau = {"tableau", "--method", "gauss:2"};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The words give the same bytes every time; returns them.
std::string same_every_time(const std::vector<std::string>& words) {
    const Outcome first = hvi_gen(words);
    INFO(first.err);
    REQUIRE(first.status == 0);
    CHECK(first.err.empty());
    CHECK(!first.out.empty());
    for (int run = 0; run < 9; ++run) CHECK((hvi_gen(words).out == first.out));
    return first.out;
}

}  // namespace

TEST_CASE("help and version go to standard output") {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--help"},
                                               {"-h"},
                                               {"tableau", "--help"},
                                               {"stepper", "--help"},
                                               {"scheme", "--help"},
                                               {"list", "--help"},
                                               {"--version"}}) {
        const Outcome outcome = hvi_gen(words);
        CHECK(outcome.status == 0);
        CHECK(!outcome.out.empty());
        CHECK(outcome.err.empty());
    }
    CHECK(hvi_gen({"--version"}).out == "hvi-gen 0.1.0\n");
    CHECK(hvi_gen({"tableau", "--help"}).out.find("--digits") != std::string::npos);
}

TEST_CASE("lists fit a terminal of 80 columns") {
    std::istringstream lines(hvi_gen({"list"}).out);
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(line.size() <= 80);
    }
}

TEST_CASE("the same input gives the same bytes") {
    for (const std::string format : {"text", "json", "latex", "markdown", "csv"})
        same_every_time({"tableau", "--method", "trig3", "--format", format});
    for (const std::string method : {"gauss:4", "chebyshev:5"})
        same_every_time({"tableau", "--method", method});
    same_every_time({"tableau", "--basis", "1, tau, cos(w*tau), sin(w*tau)", "--nodes",
                     "0, 1/3, 2/3, 1", "--param", "w=2"});
    same_every_time({"stepper", "--method", "gauss:4"});
    same_every_time({"stepper", "--method", "lobatto:3", "--separable"});
    for (const std::string format : {"text", "json"})
        same_every_time({"check", "--method", "trig3", "--format", format});
    same_every_time({"stepper", "--basis", "1, cos(w*tau), sin(w*tau)", "--nodes", "gauss:3"});
    same_every_time({"list"});
    for (const std::string format : {"text", "json", "latex"}) {
        same_every_time({"scheme", "--method", "trig3", "--generating", "--format", format,
                         "--hamiltonian", "a*p^2 + b*q*p + c*q^2 + d*q"});
        same_every_time({"scheme", "--method", "lobatto:3", "--format", format, "--hamiltonian",
                         "(q1-q2)^3*(q2-q3)^2*exp((q3-q1)*p1)/(b*q2-a*q3)^4 - log(p2+sin(q1*q3))"});
    }
}

TEST_CASE("scheme prints the maps of Section 6") {
    const auto printed = [](const std::string& method, const std::string& H) {
        const std::string text =
            same_every_time({"scheme", "--method", method, "--hamiltonian", H});
        return text.substr(text.find("\n q' = ") + 1);
    };
    CHECK(printed("chebyshev:3", "q*p") ==  // (6.2)
          " q' = -(h^3+10*h^2+48*h+96)*q/(h^3-10*h^2+48*h-96)\n"
          " p' = (-h^3+10*h^2-48*h+96)*p/(h^3+10*h^2+48*h+96)\n");
    CHECK(printed("gauss:2", "q*p") ==  // (6.3)
          " q' = (h^2+6*h+12)*q/(h^2-6*h+12)\n p' = (h^2-6*h+12)*p/(h^2+6*h+12)\n");
    CHECK(printed("chebyshev:3", "p^2/2 + w^2*q^2/2") ==  // (6.5)
          R"( q' = (-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)*q/(h^6*w^6-12*h^4*w^4+288*h^2*w^2
      +9216)
      +(36*h^5*w^4-1248*h^3*w^2+9216*h)*p/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216)
 p' = (-12*h^5*w^6+1248*h^3*w^4-9216*h*w^2)*q/(h^6*w^6-12*h^4*w^4+288*h^2*w^2
      +9216)
      +(-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)*p/(h^6*w^6-12*h^4*w^4
      +288*h^2*w^2+9216)
)");
    CHECK(printed("gauss:2", "(p^2+w^2*q^2)/2") ==  // (6.6)
          R"( q' = (h^4*w^4-60*h^2*w^2+144)*q/(h^4*w^4+12*h^2*w^2+144)
      +(-12*h^3*w^2+144*h)*p/(h^4*w^4+12*h^2*w^2+144)
 p' = (12*h^3*w^4-144*h*w^2)*q/(h^4*w^4+12*h^2*w^2+144)
      +(h^4*w^4-60*h^2*w^2+144)*p/(h^4*w^4+12*h^2*w^2+144)
)");
}

TEST_CASE("scheme in the words of CONTRACT.md") {
    const Directory directory;
    const std::vector<std::string> words = {"scheme",
                                            "--method",
                                            "gauss:2",
                                            "--hamiltonian",
                                            "p^2/2 + w^2*q^2/2",
                                            "--coordinates",
                                            "q",
                                            "--momenta",
                                            "p",
                                            "--param",
                                            "w=1",
                                            "--format",
                                            "json",
                                            "-o",
                                            "map.json"};
    const Outcome outcome = hvi_gen(words, directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.empty());
    const std::string json = contents(directory / "map.json");
    for (const std::string part :
         {"\"schema\": \"hvi-scheme/1\"", "\"variables\": [\n    \"q\",\n    \"p\"\n  ]",
          "\"parameters\": []", "\"w\": \"1\"", "\"(h^4-60*h^2+144)/(h^4+12*h^2+144)\"",
          "\"stages\": null"})
        CHECK(json.find(part) != std::string::npos);
    const std::string pendulum = same_every_time(
        {"scheme", "--method", "stormer-verlet", "--hamiltonian", "p^2/2 - cos(q)"});
    CHECK(pendulum.find(" P_1 = p-h*sin(Q_1)/2\n") != std::string::npos);
    const std::string generating =
        same_every_time({"scheme", "--generating", "--method", "gauss:2", "--hamiltonian", "q*p"});
    CHECK(generating.find(" H_d^+ = (h^2+6*h+12)*q*p'/(h^2-6*h+12)\n") != std::string::npos);
    CHECK(generating.find(" H_d,exact^+ = exp(h)*q*p'\n") != std::string::npos);
    CHECK(generating.find("O(h^5)\n") != std::string::npos);
}

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
    // As Python prints them, with one digit changed at the 12th place.
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
        // The same bytes up to the audit, which is the last of the fields.
        const std::size_t end = direct.rfind("\n}");
        REQUIRE(end != std::string::npos);
        CHECK(read.substr(0, end) == direct.substr(0, end));
        CHECK(read.substr(end, 12) == ",\n  \"audit\":");
        CHECK(read.find("\"is\": \"" + method + "\"") != std::string::npos);
    }
    CHECK(shell("hvi-gen tableau --method gauss:64 --format json | "
                "hvi-gen check --tableau /dev/stdin --max-order 4",
                directory.path())
              .out.find("is            gauss:64, within the digits given\n") != std::string::npos);
}

TEST_CASE("all of list is its parts") {
    const std::string all = same_every_time({"list"});
    for (const std::string topic : {"bases", "nodes", "methods", "scenes"})
        CHECK(all.find(same_every_time({"list", topic})) != std::string::npos);
    for (const std::string name :
         {"monomials:S", "trig:S", "bspline(k,i)", "gauss:S", "lobatto:S", "radau-left:S",
          "radau-right:S", "newton-cotes:S", "newton-cotes-open:S", "chebyshev:S",
          "clenshaw-curtis:S", "fejer:S", "roots(P(tau))", "symplectic-euler", "midpoint",
          "adjoint-symplectic-euler", "stormer-verlet", "trig3"})
        CHECK(all.find("  " + name) != std::string::npos);
}

TEST_CASE("scenes are listed with what they are") {
    const std::string text = hvi_gen({"list", "scenes"}).out;
    CHECK(std::count(text.begin(), text.end(), '\n') == 11);
    for (const std::string line :
         {"  double-pendulum      Two pendulums, one hanging on the other; not separable\n",
          "  kepler               A planet around a fixed sun, on an ellipse\n",
          "  outer-solar-system   The Sun and the five outer planets, from 1994 on\n"})
        CHECK(text.find(line) != std::string::npos);
}

TEST_CASE("scheme takes a scene by name, and by file") {
    const Directory directory;
    const std::string toml = contents(fs::path(HVI_SCENES) / "harmonic-oscillator.toml");
    write(directory / "mine.toml", toml);
    write(directory / "harmonic-oscillator", "this is no scene");  // the name wins
    const auto printed = [&](const std::vector<std::string>& words) {
        const Outcome outcome = hvi_gen(with({"scheme"}, words), directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        return outcome.out;
    };
    const std::string given =
        printed({"--method", "gauss:2", "--hamiltonian", "p^2/2+omega^2*q^2/2"});
    CHECK(printed({"--method", "gauss:2", "harmonic-oscillator"}) == given);
    CHECK(printed({"--method", "gauss:2", "mine.toml"}) == given);
    CHECK(printed({"--method", "gauss:2", "./mine.toml"}) == given);
    CHECK(printed({"mine.toml", "--method", "gauss:2"}) == given);
    const std::string fixed = printed(
        {"--method", "gauss:2", "--hamiltonian", "p^2/2+omega^2*q^2/2", "--param", "omega=2"});
    CHECK(printed({"--method", "gauss:2", "mine.toml", "--param", "omega=2"}) == fixed);
    // each option right before the scene, which it must leave alone
    CHECK(printed({"--method", "gauss:2", "--param", "omega=2", "mine.toml"}) == fixed);
    CHECK(printed({"--method", "gauss:2", "--format", "text", "mine.toml"}) == given);
    CHECK(printed({"--method", "gauss:2", "-o", "out", "mine.toml"}).empty());
    CHECK(contents(directory / "out") == given);
    CHECK(printed({"--method", "gauss:2", "--output", "out", "mine.toml"}).empty());
    CHECK(!printed({"--method", "gauss:2", "--generating", "mine.toml"}).empty());
    const std::string trig = printed({"--nodes", "0, 1", "--basis", "1, tau", "mine.toml"});
    CHECK(printed({"--basis", "1, tau", "--nodes", "0, 1", "mine.toml"}) == trig);
    write(directory / "method.toml", "basis = \"1, tau\"\nnodes = \"0, 1\"\n");
    CHECK(!printed({"--method-file", "method.toml", "mine.toml"}).empty());
    CHECK(printed({"--method", "gauss:2", "--param", "ecc=1/3", "kepler"}) ==
          printed({"--method", "gauss:2", "kepler"}));
    const std::string json = printed({"--method", "gauss:2", "kepler", "--format", "json"});
    CHECK(json.find("\"parameters\": [\n    \"mu\"\n  ]") != std::string::npos);
    const std::string latex = printed({"--method", "gauss:2", "mine.toml", "--format", "latex"});
    CHECK(latex.find("% hvi-gen scheme --method gauss:2 mine.toml --format latex\n") == 0);
}

TEST_CASE("scheme of what has indices, and of what depends on time") {
    const std::vector<std::string> words = {"scheme",  "--method",  "gauss:2", "--coordinates",
                                            "x[1..2]", "--momenta", "p[1..2]", "--hamiltonian"};
    const std::string short_form =
        same_every_time(with(words, {"sum(i=1..2, p[i]^2/(2*m[i])) + x[1]*x[2]"}));
    const std::string long_form =
        same_every_time(with(words, {"p[1]^2/(2*m[1]) + p[2]^2/(2*m[2]) + x[1]*x[2]"}));
    CHECK(short_form == long_form);
    CHECK(short_form.find("parameters    m[1], m[2]\n") != std::string::npos);
    const std::string fixed = same_every_time(
        with(words, {"sum(i=1..2, p[i]^2/(2*m[i])) + x[1]*x[2]", "--param", "m[1]=2"}));
    CHECK(fixed.find("values        m[1] = 2\n") != std::string::npos);
    const std::string driven = same_every_time(
        {"scheme", "--method", "lobatto:3", "--hamiltonian", "p^2/2 + (1+cos(t))*q^2/2"});
    CHECK(driven.find(" T_1 = t\n T_2 = t+h/2\n T_3 = t+h\n") != std::string::npos);
    same_every_time({"scheme", "--method", "gauss:3", "outer-solar-system"});
    same_every_time({"scheme", "--method", "gauss:3", "--format", "latex", "point-vortices"});
}

TEST_CASE("every form of METHOD is read") {
    const Directory directory;
    write(directory / "method.toml",
          "name = \"mine\"\nbasis = [\"1\", \"cos(w*tau)\"]\nnodes = \"0, 1\"\n"
          "[parameters]\nw = \"1/2\"\n");
    const std::vector<std::vector<std::string>> methods = {
        {"--method", "stormer-verlet"},
        {"--method=stormer-verlet"},
        {"--basis", "1, tau", "--nodes", "0, 1"},
        {"--basis=1, tau", "--nodes=0, 1"},
        {"--basis", "-1, tau", "--nodes", "-0, 1"},
        {"--nodes", "-1/2, 1", "--basis", "1, tau"},
        {"--method-file", "method.toml"},
        {"--method-file", "method.toml", "--param", "w=1"},
        {"--param", "w=-1", "--basis", "1, exp(w*tau)", "--nodes", "0, 1"},
        {"--param=w=1", "--param", "v=2", "--basis", "1, exp(v*w*tau)", "--nodes", "0, 1"},
    };
    for (const auto& method : methods) {
        for (const std::string command : {"tableau", "stepper"}) {
            const Outcome outcome = hvi_gen(with({command}, method), directory.path());
            INFO(outcome.err);
            CHECK(outcome.status == 0);
            CHECK(outcome.err.empty());
        }
    }
}

TEST_CASE("no option of stepper swallows the scene behind it") {
    const std::vector<std::vector<std::string>> lines = {
        {"--param", "mu=2"},    {"--energy"},  {"--invariants"}, {"--dense"},
        {"--solver", "newton"}, {"--explain"}, {"--name", "K"},  {"--method", "gauss:4"}};
    for (const auto& options : lines) {
        const Outcome outcome = hvi_gen(with(with({"stepper"}, options), {"kepler"}));
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        const std::string name = options.front() == "--name" ? "K" : "KeplerGauss4";
        CHECK(outcome.out.find("\nusing " + name + " = Basic" + name + "<double>;\n") !=
              std::string::npos);
    }
}

TEST_CASE("a stepper of a scene has what was asked for and no more") {
    const std::vector<std::string> words = {"stepper", "--method", "gauss:2", "kepler"};
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::string plain = hvi_gen(words).out;
    CHECK(has(plain, "struct Parameters"));
    CHECK(has(plain, "static constexpr State initial("));
    CHECK_FALSE(has(plain, "energy("));
    CHECK_FALSE(has(plain, "angular_momentum("));
    CHECK(has(plain, "using Solver = hvi::Automatic<hvi::NewtonOfPositions>;"));
    CHECK_FALSE(has(plain, "position("));
    CHECK_FALSE(has(plain, "curve"));
    const std::string all =
        hvi_gen(with(words, {"--energy", "--invariants", "--solver", "newton"})).out;
    CHECK(has(all, "Scalar energy(const State& x) const"));
    CHECK(has(all, "Scalar angular_momentum(const State& x) const"));
    CHECK(has(all, "using Solver = hvi::NewtonOfPositions;"));
    CHECK_FALSE(has(all, "position("));
    const std::string fixed = same_every_time(with(words, {"--solver", "fixed-point"}));
    CHECK(has(fixed, "using Solver = hvi::FixedPoint;"));
    CHECK_FALSE(has(fixed, "d2Hdq2"));
    CHECK_FALSE(has(fixed, "Modes"));
    const std::string dense = same_every_time(with(words, {"--dense"}));
    CHECK(has(dense, "Vector position(Scalar tau) const"));
    CHECK(has(dense, "it is O(h^3) away"));
    CHECK(has(dense, "hvi-gen stepper --method gauss:2 kepler --dense\n"));
    for (const std::string scene : {"kepler", "harmonic-oscillator"}) {
        const std::string alone = hvi_gen({"stepper", "--method", "stormer-verlet", scene}).out;
        CHECK(has(alone, "#ifndef HVI_STATE"));
        CHECK_FALSE(has(alone, "#include <hvi/"));
    }
    const Outcome explained = hvi_gen(with(words, {"--explain"}));
    CHECK(has(explained.err, "T is quadratic with a constant matrix"));
    CHECK(has(explained.err, "4 unknowns are solved for in a step"));
    CHECK(
        has(explained.err, "dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root"));
    CHECK(explained.out == plain);
    // Counted by hand in the straight-line code.
    CHECK(has(explained.err, "where Newton's method is needed: 3 additions, 16 "));
    const Outcome taylor = hvi_gen(with(words, {"--solver", "newton-taylor", "--explain"}));
    CHECK(
        has(taylor.err, "d2H/dq2 times a vector, after dH/dq: 3 additions, 11 multiplications\n"));
    CHECK(has(taylor.out, "using Solver = hvi::NewtonTaylor;"));
}

TEST_CASE("--explain says whether the step of a quadratic H is a matrix, and why not") {
    const auto explained = [](const std::string& H) {
        return hvi_gen({"stepper", "--method", "gauss:2", "--hamiltonian", H, "--explain"}).err;
    };
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::string coupled = explained("p1^2/2+p2^2+(q1-q2)^2");
    CHECK(has(coupled, "a step: 12 multiplications and 12 additions\n"));
    CHECK(has(coupled, "no solver: H is quadratic"));
    CHECK(has(explained("p^2/2+q^2/2+q"), "a step: 3 multiplications and 5 additions\n"));
    const std::string mixed = explained("p1^2/2+p2^2/2+q1*p2");
    CHECK(has(mixed, "iterated, though H is quadratic: products of q and p leave no symmetric "
                     "shears\n"));
    CHECK(has(mixed, "8 unknowns are solved for in a step\n"));
}

TEST_CASE("every scene gives a header, the same every time, below 100 kB") {
    for (const std::string scene :
         {"double-pendulum", "fpu", "harmonic-oscillator", "henon-heiles", "kepler", "nonseparable",
          "outer-solar-system", "pendulum", "point-vortices", "qp"}) {
        const std::string header = same_every_time({"stepper", scene, "--energy", "--invariants"});
        CHECK(header.size() < 100'000);
        CHECK(header.find("hvi-gen stepper --method") != std::string::npos);
    }
}

TEST_CASE("--digits is heard") {
    const std::string text = hvi_gen(with(tableau, {"--format", "json", "--digits", "7"})).out;
    CHECK(text.find("\"0.2113249\"") != std::string::npos);
}

TEST_CASE("--explain speaks on standard error") {
    const Outcome outcome = hvi_gen({"stepper", "--method", "gauss:2", "--explain"});
    CHECK(outcome.status == 0);
    CHECK(!outcome.err.empty());
    CHECK((outcome.out == hvi_gen({"stepper", "--method", "gauss:2"}).out));
}

TEST_CASE("-o writes what standard output would have been") {
    const Directory directory;
    const std::string text = hvi_gen(tableau).out;
    write(directory / "old", std::string(100000, 'x'));
    fs::create_symlink("old", directory / "link");
    for (const std::string name : {"new", "old", "link"}) {
        const Outcome outcome = hvi_gen(with(tableau, {"-o", name}), directory.path());
        CHECK(outcome.status == 0);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.empty());
        CHECK((contents(directory / name) == text));  // too long to be shown
    }
    CHECK(fs::is_symlink(directory / "link"));
    CHECK(directory.names() == std::vector<std::string>{"link", "new", "old"});
}

TEST_CASE("a file keeps its permissions, and a new one gets the usual ones") {
    const Directory directory;
    write(directory / "old", "");
    ::chmod((directory / "old").c_str(), 0640);
    const Outcome outcome = shell("umask 027; hvi-gen tableau --method midpoint -o new; "
                                  "hvi-gen tableau --method midpoint -o old; stat -c %a new old",
                                  directory.path());
    CHECK(outcome.out == "640\n640\n");
}

TEST_CASE("what cannot be written: status 3") {
    const Directory directory;
    const std::string line = "hvi-gen tableau --method midpoint ";
    for (const std::string where :
         {"-o .", "-o missing/file", "-o /dev/full", "> /dev/full", ">&-", "-o /proc/file"}) {
        const Outcome outcome = shell(line + where, directory.path());
        INFO(where << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.rfind("error: cannot write ", 0) == 0);
        CHECK(directory.names().empty());
    }
    CHECK(shell("hvi-gen --help > /dev/full").status == 3);
    CHECK(shell("hvi-gen list > /dev/full").status == 3);
    CHECK(shell("set -o pipefail; { hvi-gen list; echo $? >&2; } | true").err.find("141") ==
          std::string::npos);
}

TEST_CASE("a full disk leaves the old file") {
    const Directory directory;
    write(directory / "old", "old");
    // The shell counts in blocks of 1024 bytes; the signal of the limit is ignored, writing fails.
    const Outcome outcome = shell(
        "trap '' XFSZ; ulimit -f 1; hvi-gen stepper --method gauss:4 -o old", directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 3);
    CHECK((contents(directory / "old") == "old"));
    CHECK(directory.names() == std::vector<std::string>{"old"});
}

TEST_CASE("a device is written to, not replaced") {
    CHECK(hvi_gen(with(tableau, {"-o", "/dev/null"})).status == 0);
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("an interruption ends with status 130, and leaves nothing") {
    const Directory directory;
    for (const std::string signal : {"INT", "TERM"}) {
        // The program waits for its input: a pipe that nobody writes to.
        const Outcome outcome = shell(
            "mkfifo pipe; \"$hvi_gen\" tableau --method-file pipe -o new & sleep 0.3; kill -" +
                signal + " $!; wait $!; status=$?; rm pipe; exit $status",
            directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 130);
        CHECK(directory.names().empty());
    }
}
