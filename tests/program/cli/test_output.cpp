// Destinations of output in successful runs, and leftovers of failed ones.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "generator/options/option_table.hpp"
#include "tests/checkout.hpp"
#include "tests/program/cli/results.hpp"

using namespace hvi::test;

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> tableau = {"tableau", "--method", "gauss:2"};

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

TEST_CASE("help of a command by its name") {
    CHECK(hvi_gen({"help"}).out == hvi_gen({"--help"}).out);
    CHECK(hvi_gen({"help", "run"}).out == hvi_gen({"run", "--help"}).out);
    CHECK_THAT(hvi_gen({"help", "runn"}).err, Catch::Contains("did you mean `run`?"));
    CHECK(hvi_gen({"help", "runn"}).status == 2);
}

TEST_CASE("a scene is shown as it is written") {
    const Directory directory;
    const std::string text = hvi_gen({"show", "kepler"}).out;
    CHECK(text == contents(in_checkout("examples/scenes/kepler.toml")));
    write(directory / "mine.toml", text);
    CHECK(hvi_gen({"show", "mine.toml"}, directory.path()).out == text);
    CHECK(hvi_gen({"show", "-o", "copy.toml", "kepler"}, directory.path()).status == 0);
    CHECK(contents(directory / "copy.toml") == text);
    CHECK_THAT(hvi_gen({"show", "keplar"}).err, Catch::Contains("did you mean `kepler`?"));
    CHECK_THAT(hvi_gen({"show"}).err, Catch::Contains("no scene is given"));
}

TEST_CASE("lines of help have at most 100 columns") {
    for (const auto& command : hvi::gen::command_table()) {
        if (command.state == hvi::gen::State::to_come) continue;
        const Outcome help = hvi_gen({std::string(command.name), "--help"});
        CHECK(help.status == 0);
        for (const std::string& line : lines_of(help.out)) {
            CAPTURE(line);
            CHECK(line.size() <= 100);
        }
    }
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

TEST_CASE("all of list is its parts") {
    const std::string all = same_every_time({"list"});
    for (const std::string topic : {"bases", "nodes", "methods", "scenes", "functions"})
        CHECK(all.find(same_every_time({"list", topic})) != std::string::npos);
    for (const std::string name : {"monomials:S",
                                   "trig:S",
                                   "bspline(k,i)",
                                   "gauss:S",
                                   "lobatto:S",
                                   "radau-left:S",
                                   "radau-right:S",
                                   "newton-cotes:S",
                                   "newton-cotes-open:S",
                                   "chebyshev:S",
                                   "clenshaw-curtis:S",
                                   "fejer:S",
                                   "roots(P(tau))",
                                   "symplectic-euler",
                                   "midpoint",
                                   "adjoint-symplectic-euler",
                                   "stormer-verlet",
                                   "trig3",
                                   "y = sqrt(x)",
                                   "y = tanh(x)"})
        CHECK(all.find("  " + name) != std::string::npos);
}

TEST_CASE("scenes are listed with what they are") {
    const std::string text = hvi_gen({"list", "scenes"}).out;
    CHECK(std::count(text.begin(), text.end(), '\n') == 37);
    for (const std::string line :
         {"  double-pendulum      Two pendulums, one hanging on the other; not separable\n",
          "  kepler               A planet around a fixed sun, on an ellipse\n",
          "  outer-solar-system   The Sun and the five outer planets, from 1994 on\n"})
        CHECK(text.find(line) != std::string::npos);
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

TEST_CASE("--digits is heard") {
    const std::string text = hvi_gen(with(tableau, {"--format", "json", "--digits", "7"})).out;
    CHECK(text.find("\"0.2113249\"") != std::string::npos);
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

TEST_CASE("a file that was to be run as its owner is so no more") {
    const Directory directory;
    write(directory / "old", "");
    ::chmod((directory / "old").c_str(), 07755);
    const Outcome outcome =
        shell("hvi-gen tableau --method midpoint -o old; stat -c %a old", directory.path());
    CHECK(outcome.out == "755\n");
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
    for (const std::string signal : {"INT", "QUIT", "TERM", "HUP"}) {
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

TEST_CASE("the end of the terminal is none for what nohup starts") {
    const Directory directory;
    write(directory / "method.toml", "basis = \"1\"\nnodes = \"1/2\"\n");
    const Outcome outcome =
        shell("mkfifo pipe; (trap '' HUP; exec \"$hvi_gen\" tableau --method-file pipe) & "
              "sleep 0.3; kill -HUP $!; timeout 10 dd if=method.toml of=pipe status=none; wait $!",
              directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(!outcome.out.empty());
}

TEST_CASE("the functions in H are listed with their derivatives") {
    const std::string text = hvi_gen({"list", "functions"}).out;
    for (const std::string line :
         {"y = sqrt(x)   y' = 1/(2*y)                x >= 0\n",
          "y = acosh(x)  y' = 1/sqrt(x^2-1)          x >= 1\n",
          "y = atanh(x)  y' = 1/(1-x^2)              -1 < x < 1\n",
          "y = erf(x)    y' = 2/sqrt(pi)*exp(-x^2)\n",
          "y = atan2(a,b)   dy/da = b/(a^2+b^2), dy/db = -a/(a^2+b^2)\n",
          "y = abs(x)       y' = sign(x)\n", "y = min(a,b)     y = if(b<a,b,a)\n",
          "y = if(a<b,x,y)  x where a < b, else y; also <=, > and >=\n"}) {
        CAPTURE(line);
        CHECK(text.find("  " + line) != std::string::npos);
    }
    CHECK(text.find("roots") == std::string::npos);
}
