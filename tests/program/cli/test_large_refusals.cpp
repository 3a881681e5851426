// Refusals of what is asked of scenes whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/refusals.hpp"

using namespace hvi::test;

namespace {

/// A thousand springs, with a parameter that a basis may have too.
const std::string springs = R"toml(coordinates = "x[1..N]"
momenta     = "p[1..N]"
hamiltonian = "sum(i=1..N, p[i]^2/2 + a*x[i]^2/2)"
[parameters]
N = 1000
a = 2
[initial]
"x[i]" = "sin(i)"
"p[i]" = "0"
)toml";

Outcome stepper_of_springs(const std::vector<std::string>& words, const Directory& directory) {
    write(directory / "springs.toml", springs);
    std::vector<std::string> all = {"stepper", "springs.toml"};
    all.insert(all.end(), words.begin(), words.end());
    return hvi_gen(all, directory.path());
}

const std::vector<std::string> fitted = {"--basis", "1, cos(w*tau)", "--nodes", "0, 1"};

}  // namespace

TEST_CASE("values are given to parameters of the method and of the scene") {
    const Directory directory;
    for (const std::vector<std::string>& values :
         {std::vector<std::string>{"--param", "w=2"},
          std::vector<std::string>{"--param", "w=2", "--param", "a=3", "--param", "N=2000"}}) {
        std::vector<std::string> words = fitted;
        words.insert(words.end(), values.begin(), values.end());
        const Outcome outcome = stepper_of_springs(words, directory);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.out.find("--param \"w=2\"") != std::string::npos);
        const bool is_larger = values.size() > 2;
        CHECK((outcome.out.find("Place N = 2000;") != std::string::npos) == is_larger);
        CHECK((outcome.out.find("a = 3") != std::string::npos) == is_larger);
    }
}

TEST_CASE("commands that write sums out say who does not") {
    check_refused({2, "plummer", {"--series is not built for loops"}},
                  {"scheme", "--method", "gauss:2", "plummer", "--series", "2"});
    check_refused({2, "plummer", {"--unroll yes"}},
                  {"scheme", "--method", "gauss:2", "plummer", "--unroll", "yes"});
}

TEST_CASE("a report on a large scene refuses what is not built for it, by name") {
    check_refused({2, "--peers", {}}, {"report", "plummer", "--peers"});
    check_refused({2, "--edges", {}}, {"report", "--edges", "pendulum", "plummer"});
    check_refused({2, "symplecticity,json", {}},
                  {"report", "plummer", "--only", "symplecticity,json"});
    check_refused({1, "0", {}}, {"report", "plummer", "--steps", "1/10, 0"});
}

TEST_CASE("an exact solution of a large scene is looked at") {
    const auto check = [](const std::string& exact) {
        const Directory directory;
        write(directory / "springs.toml",
              springs + "[exact]\n" + exact +
                  "\n[run]\nmethod = \"stormer-verlet\"\nstep = 1\nuntil = 2\n");
        const Outcome outcome = hvi_gen({"report", "springs.toml", "-o", "out"}, directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        return outcome.err;
    };
    const std::string x = "\"x[i]\" = \"cos(t)\"\n";
    CHECK(check(x).find("an exact solution is missing: that of `p`") != std::string::npos);
    CHECK(pointed_at(check(x + "\"p[i]\" = \"x[i]*t\"")) == "x[i]");
    CHECK(pointed_at(check(x + "\"p[i]\" = \"s*t\"")) == "s");
    CHECK(pointed_at(check(x + "\"p[i]\" = 0\n\"y[i]\" = 0")).find("y[i]") != std::string::npos);
}

TEST_CASE("initial values of a list are looked at one by one") {
    const Directory directory;
    const auto check = [&](const std::string& value) {
        std::string scene = springs;
        std::string list = "x = [" + value;
        for (int i = 1; i < 100; ++i) list += ", \"c[1]\"";
        scene.replace(scene.find("\"x[i]\" = \"sin(i)\""), 17, list + "]");
        scene.replace(scene.find("N = 1000"), 8, "N = 100\nc = [1, 2]");
        write(directory / "listed.toml", scene);
        const Outcome outcome = hvi_gen(
            {"stepper", "listed.toml", "--method", "gauss:2", "--unroll", "no"}, directory.path());
        INFO(outcome.err);
        if (outcome.status == 0) return std::string("fine");
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        return pointed_at(outcome.err);
    };
    CHECK(check("\"c[2]\"") == "fine");
    CHECK(check("\"c[3]\"") == "c[3]");
    CHECK(check("\"p[1]\"") == "p[1]");
    CHECK(check("\"2*x[2] + 1\"") == "x[2]");
    CHECK(check("\"d\"") == "d");
    CHECK(check("\"i\"") == "i");
}

TEST_CASE("what steppers of large scenes are not built for is refused, with its place") {
    const Directory directory;
    const auto check = [&](int status, const std::string& place,
                           const std::vector<std::string>& words) {
        const Outcome outcome = stepper_of_springs(words, directory);
        std::string line;
        for (const std::string& word : words) line += word + " | ";
        INFO(line << "\n" << outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(pointed_at(outcome.err) == place);
        return outcome.err;
    };
    check(2, "springs.toml", {});  // no method is named
    check(2, "b", {"--method", "gauss:2", "--param", "b=1"});
    check(2, "a", {"--method", "gauss:2", "--param", "a=1", "--param", "a=1"});
    check(2, "1..N", {"--method", "gauss:2", "--param", "N=0"});
    check(2, "graph", {"--method", "gauss:2", "--dump", "graph"});
    const std::vector<std::vector<std::string>> wishes = {
        {"--lanes", "ensemble"}, {"--lanes", "gpu"}, {"--lanes", "stages"},
        {"--solver", "newton-taylor"}};
    for (const std::vector<std::string>& wish : wishes) {
        std::vector<std::string> words{"--method", "gauss:2", wish[0], wish[1]};
        // These are written out, which a thousand are too many for.
        CHECK(check(2, "springs.toml", words).find(wish[0] + " " + wish[1]) != std::string::npos);
        words.insert(words.end(), {"--unroll", "no"});
        const std::string message = check(2, "sum(i=1..N, p[i]^2/2 + a*x[i]^2/2)", words);
        CHECK(message.find(wish[0] + " " + wish[1]) != std::string::npos);
        CHECK(message.find("--unroll yes") != std::string::npos);
    }
}

TEST_CASE("a Lagrangian whose sums stay loops has a mass for each velocity, and no more") {
    const Directory directory;
    const auto refused = [&](const std::string& kinetic) {
        write(directory / "rails.toml",
              "coordinates = \"x[1..N]\"\nvelocities = \"v[1..N]\"\nlagrangian = \"" + kinetic +
                  " - sum(i=1..N, x[i]^4)\"\n[parameters]\nN = 300\n[initial]\n\"x[i]\" = "
                  "\"i/10\"\n\"v[i]\" = 0\n");
        const Outcome outcome =
            hvi_gen({"stepper", "rails.toml", "--method", "gauss:2"}, directory.path());
        INFO(kinetic << "\n" << outcome.err);
        if (outcome.status == 0) return std::string();
        CHECK(outcome.status == 2);
        check_form(outcome.err);
        const std::size_t why = outcome.err.find("alone: ") + 7;
        return outcome.err.substr(why, outcome.err.find('\n', why) - why);
    };
    CHECK(refused("sum(i=1..N, i*v[i]^2/2)").empty());
    CHECK(refused("sum(i=1..N, (i + 1)*v[i]^2/2)").empty());
    CHECK(refused("sum(i=1..N, v[i]^2/2 + 3)").empty());
    const std::string of_all = "its sums run over all velocities of a name";
    CHECK(refused("sum(i=1..N-1, v[i]^2/2) + v[N]^2/2") == of_all);
    CHECK(refused("sum(i=1..N-1, (v[i] + v[i+1])^2/2)") ==
          "a kinetic energy is quadratic in each velocity, and couples none of them");
    CHECK(refused("sum(i=1..N, v[i]^2/2 + v[i])") ==
          "a kinetic energy is quadratic in each velocity, and couples none of them");
    CHECK(refused("sum(i=1..N, v[i]^4)") ==
          "a kinetic energy is quadratic in each velocity, and couples none of them");
    CHECK(refused("sum(i=1..N, x[i]*v[i]^2)") ==
          "here velocities stand beside coordinates or the time");
    CHECK(refused("sum(i=1..N, (2 + sin(t))*v[i]^2)") ==
          "here velocities stand beside coordinates or the time");
    CHECK(refused("sum(i=1..N, j=1..N, v[i]^2)") == "its sums run over velocities once each");
    CHECK(refused("0*sum(i=1..N, v[i]^2)") == "here a velocity has no mass");
}

TEST_CASE("rotations and angular momenta are pairs, and the message is of these") {
    const Directory directory;
    write(directory / "bodies.toml",
          "coordinates = \"x[1..N]\"\nmomenta = \"p[1..N]\"\nrotations = \"R[1..N]\"\n"
          "angular_momenta = \"L[1..M]\"\n"
          "hamiltonian = \"sum(k=1..N, p[k]^2/2 + x[k]*R[k,3,1] + L[k,1]^2/2)\"\n"
          "[parameters]\nN = 3\nM = 3\n[initial]\n\"x[k]\" = 0\n\"p[k]\" = 0\nR = \"identity\"\n"
          "\"L[k,i]\" = \"k\"\n");
    const Outcome outcome = hvi_gen(
        {"stepper", "bodies.toml", "--method", "gauss:2", "--unroll", "no"}, directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("rotations and angular momenta are pairs") != std::string::npos);
    CHECK(outcome.err.find("bodies.toml:4") != std::string::npos);
    check_form(outcome.err);
}
