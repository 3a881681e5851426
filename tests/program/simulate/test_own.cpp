// Scenes with functions of their own, run and reported on.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/checkout.hpp"
#include "tests/program/cli/program.hpp"
#include "tests/program/cli/refusals.hpp"
#include "tests/program/simulate/cache.hpp"
#include "tests/program/simulate/pretended.hpp"

using namespace hvi::test;

namespace {

/// H = p^2/2 + q^2/2, in which q^2/2 is of a header.
const std::string own_spring = "name = \"own\"\nhamiltonian = \"p^2/2 + V(q)\"\n"
                               "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                               "functions = {V = {header = \"below/spring.hpp\", arguments = 1}}\n"
                               "initial = {q = 1, p = 0}\n"
                               "run = {method = \"gauss:2\", step = 0.1, until = 1}\n";

const std::string potential = "#pragma once\n#include \"half.hpp\"\n"
                              "template <class X> X V(X x) { return half<X>() * x * x; }\n"
                              "template <class X> X V_1(X x) { return x; }\n";

const std::string second = "template <class X> X V_11(X) { return X(1); }\n";

void write_scene(const Directory& directory, const std::string& header) {
    std::filesystem::create_directories(directory / "below");
    write(directory / "scene.toml", own_spring);
    write(directory / "below/spring.hpp", header);
    write(directory / "below/half.hpp",
          "#pragma once\ntemplate <class X> X half() { return X(1) / X(2); }\n");
}

/// Returns the last line of numbers.
std::vector<double> last_row(const std::filesystem::path& table) {
    std::string line = lines_of(contents(table)).back() + ",";
    std::vector<double> numbers;
    for (std::size_t at = 0; (at = line.find(',')) != std::string::npos; line.erase(0, at + 1))
        numbers.push_back(std::stod(line));
    return numbers;
}

}  // namespace

TEST_CASE("a run calls the functions of the user's header") {
    use_cache();
    const Directory directory;
    write_scene(directory, potential + second);
    const Outcome result =
        hvi_gen({"run", "scene.toml", "-o", "out", "--only", "table"}, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const auto row = last_row(directory / "out/trajectory.csv");
    REQUIRE(row.size() == 4);
    // By the matrix of gauss:2, (6.6) of the paper, the phase is off by (h^4/720) t.
    CHECK(std::abs(row[1] - std::cos(1.0)) < 1e-4 / 720);
    CHECK(std::abs(row[2] + std::sin(1.0)) < 1e-4 / 720);
    CHECK(std::abs(row[3] - 0.5) < 1e-14);
}

TEST_CASE("without second derivatives there are fixed points, and explicit steps") {
    use_cache();
    const Directory directory;
    write_scene(directory, potential);
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", "scene.toml", "--only", "summary"};
        words.insert(words.end(), more.begin(), more.end());
        return hvi_gen(words, directory.path());
    };
    CHECK(run({"--solver", "fixed-point"}).status == 0);
    CHECK(run({"--method", "stormer-verlet"}).status == 0);
    const Outcome newton = run({});
    CHECK(newton.status == 3);
    CHECK(newton.err.find("V_11") != std::string::npos);
}

TEST_CASE("a flow of a part of H calls the functions of the user's header") {
    use_cache();
    const Directory directory;
    write_scene(directory, potential);
    // NOTE: with half a turn, a kick of q^2/2 and half a turn q is cos(n theta) after n steps,
    // where cos(theta) = cos h - (h/2) sin h is half the trace of a step's matrix. No flow calls
    // V_11.
    const double h = 0.1, theta = std::acos(std::cos(h) - h / 2 * std::sin(h));
    std::string scene = own_spring;
    scene.replace(scene.find("p^2/2 + V(q)"), 12, "p^2/2 + q^2/2 + V(q)");
    const auto check = [&](const std::string& text, const std::vector<std::string>& more) {
        write(directory / "scene.toml", text);
        std::vector<std::string> words{"run", "scene.toml", "--method", "strang",
                                       "-o",  "out",        "--only",   "table"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome result = hvi_gen(words, directory.path());
        INFO(result.err);
        REQUIRE(result.status == 0);
        const auto row = last_row(directory / "out/trajectory.csv");
        REQUIRE(row.size() == 4);
        CHECK(std::abs(row[1] - std::cos(10 * theta)) < 1e-14);
    };
    check(scene, {"--split", "auto"});
    std::filesystem::remove_all(directory / "out");
    check(scene + "split = {A = \"p^2/2 + q^2/2\", B = \"V(q)\"}\n", {});
}

TEST_CASE("of flows with functions of the user's own no errors and directions are known") {
    const Directory directory;
    write_scene(directory, potential + second);
    const auto of = [&](const std::vector<std::string>& words) {
        return hvi_gen(words, directory.path());
    };
    std::string scene = own_spring;
    scene.replace(scene.find("p^2/2 + V(q)"), 12, "p^2/2 + q^2/2 + V(q)");
    write(directory / "scene.toml", scene);
    const Outcome splits = of({"list", "splits", "scene.toml", "--split", "auto"});
    REQUIRE(splits.status == 0);
    const std::string first = "\n  *  in order    3      ";
    const std::size_t row = splits.out.find(first);
    REQUIRE(row != std::string::npos);
    // NOTE: operations stand there alone, without an error and work.
    const std::size_t end = splits.out.find('\n', row + 1);
    const std::string numbers = splits.out.substr(row + first.size(), end - row - first.size());
    CHECK(numbers.find_first_not_of("0123456789") == std::string::npos);
    const Outcome tangent =
        of({"run", "scene.toml", "--method", "strang", "--split", "auto", "--tangent"});
    CHECK(tangent.status == 2);
    CHECK(tangent.err.find("error: --tangent is not built for functions of your own\n") == 0);
    const Outcome header =
        of({"stepper", "scene.toml", "--method", "strang", "--split", "auto", "--tangent"});
    CHECK(header.status == 2);
    CHECK(header.err.find("error: --tangent is not built for functions of your own\n") == 0);
    CHECK(header.err.find("^~~~") != std::string::npos);
    write(directory / "scene.toml", scene + "parameters = {a = 1}\n");
    const Outcome sensitivity =
        of({"run", "scene.toml", "--method", "strang", "--split", "auto", "--sensitivity", "a"});
    CHECK(sensitivity.status == 2);
    CHECK(sensitivity.err.find("error: --sensitivity is not built for functions of your own\n") ==
          0);
    scene.replace(scene.find("+ V(q)"), 6, "+ V(q*p)");
    write(directory / "scene.toml", scene + "split = {A = \"p^2/2 + q^2/2\", B = \"V(q*p)\"}\n");
    const Outcome unknown = of({"run", "scene.toml", "--method", "strang"});
    INFO(unknown.err);
    CHECK(unknown.status == 1);
    CHECK(unknown.err.find(
              "error: the flow of `B` is not known: no flow is known where q, p move\n") == 0);
    CHECK(pointed_at(unknown.err) == "V(q*p)");
}

TEST_CASE("a function of the user's own of a quadratic form turns with the speed of its slope") {
    use_cache();
    const Directory directory;
    write_scene(directory, potential);
    // NOTE: V is half the square of q^2 + p^2, which is 1: its flow turns with the speed 2, that of
    // the other part with the speed 1.
    std::string scene = own_spring;
    scene.replace(scene.find("p^2/2 + V(q)"), 12, "p^2/2 + q^2/2 + V(q^2 + p^2)");
    write(directory / "scene.toml",
          scene + "split = {A = \"p^2/2 + q^2/2\", B = \"V(q^2 + p^2)\"}\n");
    const Outcome result =
        hvi_gen({"run", "scene.toml", "--method", "strang", "-o", "out", "--only", "table"},
                directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const auto row = last_row(directory / "out/trajectory.csv");
    REQUIRE(row.size() == 4);
    CHECK(std::abs(row[1] - std::cos(3.0)) < 1e-14);
    CHECK(std::abs(row[2] + std::sin(3.0)) < 1e-14);
}

TEST_CASE("an error in the user's header is that of the compiler") {
    use_cache();
    const Directory directory;
    write_scene(directory, potential + second + "int wrong = unknown_word;\n");
    const Outcome result = hvi_gen({"run", "scene.toml"}, directory.path());
    CHECK(result.status == 3);
    CHECK(result.out.empty());
    CHECK(result.err.find("error: the compiler failed: scene/below/spring.hpp:6") == 0);
    CHECK(result.err.find("unknown_word") != std::string::npos);
}

TEST_CASE("an edited header is compiled again") {
    const PretendedCompiler compiler;
    write_scene(compiler.directory, potential);
    const auto compilations_of_run = [&] {
        const std::size_t before =
            compiler.directory.names().size() < 5 ? 0 : compiler.compilations();
        REQUIRE(compiler.run("$run").status == 0);
        return compiler.compilations() - before;
    };
    CHECK(compilations_of_run() == 1);
    CHECK(compilations_of_run() == 0);
    write(compiler.directory / "below/spring.hpp", potential + second);
    CHECK(compilations_of_run() == 1);
    write(compiler.directory / "below/half.hpp", "// another\n");
    CHECK(compilations_of_run() == 1);
    CHECK(compilations_of_run() == 0);
}

TEST_CASE("a header may be called as a file of the program") {
    use_cache();
    for (const std::string name : {"stepper.hpp", "main.cpp", "hvi/state.hpp", "math.h"}) {
        const Directory directory;
        write_scene(directory, potential + second);
        std::string scene = own_spring;
        scene.replace(scene.find("below/spring.hpp"), 16, name);
        write(directory / "scene.toml", scene);
        std::filesystem::create_directories((directory / name).parent_path());
        write(directory / name, potential.substr(0, 13) +
                                    "template <class X> X V(X x) { return x * x / X(2); }\n"
                                    "template <class X> X V_1(X x) { return x; }\n" +
                                    second);
        const Outcome result =
            hvi_gen({"run", "scene.toml", "--method", "stormer-verlet", "--only", "summary"},
                    directory.path());
        INFO(name << "\n" << result.err);
        CHECK(result.status == 0);
    }
}

TEST_CASE("a report measures against a reference in long double") {
    use_cache();
    const Directory directory;
    write_scene(directory, potential + second);
    const Outcome result = hvi_gen({"report", "scene.toml", "--methods", "stormer-verlet, gauss:2",
                                    "--steps", "1/10, 1/20", "--only", "json", "-o", "out"},
                                   directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const auto report = nlohmann::json::parse(contents(directory / "out/report.json"));
    const auto& scene = report.at("scenes").at(0);
    const std::string kind = scene.at("reference").at("kind");
    CHECK(kind.rfind("gauss:10 in ", 0) == 0);
    const double error = scene.at("methods").at(1).at("points").at(0).at("error");
    CHECK(error == Approx(1e-4 / 720).epsilon(0.01));
}

TEST_CASE("steps with functions of two arguments are symplectic, by dual numbers") {
    use_cache();
    const Directory directory;
    const Outcome result = hvi_gen({"report", in_checkout("tests/runtime/own/waves.toml"),
                                    "--edges", "--methods", "gauss:2, symplectic-euler", "--steps",
                                    "1/10", "--only", "rejections,symplecticity,json", "-o", "out"},
                                   directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const auto report = nlohmann::json::parse(contents(directory / "out/report.json"));
    std::size_t defects = 0;
    for (const auto& chapter : report.at("edges")) {
        for (const auto& check : chapter.at("checks")) {
            CHECK(check.at("scene") == "waves");
            const bool is_defect = chapter.at("name") == "symplecticity";
            if (!is_defect) continue;
            const std::string seen = check.at("seen");
            CHECK(std::stod(seen) < 1e-12);
            ++defects;
        }
    }
    CHECK(defects == 4);
}

TEST_CASE("a stepper is written by a scene and not by its headers") {
    const Directory directory;
    write_scene(directory, potential);
    const std::vector<std::string> words{"stepper", "scene.toml"};
    const Outcome first = hvi_gen(words, directory.path());
    REQUIRE(first.status == 0);
    CHECK(first.out.find("\n#include \"below/spring.hpp\"\n") != std::string::npos);
    write(directory / "below/spring.hpp", "");
    CHECK(hvi_gen(words, directory.path()).out == first.out);
}

TEST_CASE("what a scene with functions of its own is refused") {
    const Directory directory;
    write_scene(directory, potential);
    const auto check = [&](int status, const std::string& place,
                           const std::vector<std::string>& words) {
        const Outcome outcome = hvi_gen(words, directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(pointed_at(outcome.err) == place);
    };
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {}, {"--series", "3"}, {"--lagrangian"}, {"--generating"}, {"--format", "latex"}}) {
        std::vector<std::string> words{"scheme", "--method", "gauss:2", "scene.toml"};
        words.insert(words.end(), more.begin(), more.end());
        check(2, "V(q)", words);
    }
    check(2, "V", {"stepper", "scene.toml", "-o", "spring.hpp"});
    for (const std::string name : {"class", "errno", "linux", "a__b"}) {
        std::string scene = own_spring;
        scene.replace(scene.find("V(q)"), 1, name);
        scene.replace(scene.find("{V"), 2, "{" + name);
        write(directory / "scene.toml", scene);
        check(2, name, {"stepper", "scene.toml"});
    }
    CHECK(directory.names() == std::vector<std::string>{"below", "scene.toml"});
}

TEST_CASE("a scene of any size is refused what a small one is") {
    const Directory directory;
    write_scene(directory, potential);
    const std::string chain =
        "hamiltonian = \"sum(i=1..N, p[i]^2/2 + a*V(q[i]))\"\n"
        "coordinates = \"q[1..N]\"\nmomenta = \"p[1..N]\"\n"
        "functions = {V = {header = \"below/spring.hpp\", arguments = 1}}\n"
        "definitions = {\"start[i]\" = \"V(i)\"}\nparameters = {N = 100, a = 1, m = [1, 2]}\n"
        "initial = {\"q[i]\" = \"i/2\", \"p[i]\" = 0}\nrun = {method = \"stormer-verlet\"}\n";
    const auto pointed = [&](const std::string& part, const std::string& other) {
        std::string scene = chain;
        scene.replace(scene.find(part), part.size(), other);
        write(directory / "chain.toml", scene);
        const Outcome outcome = hvi_gen({"stepper", "chain.toml"}, directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        check_form(outcome.err);
        CHECK(outcome.err.find("error: `V` cannot stand in ") == 0);
        return pointed_at(outcome.err);
    };
    CHECK(pointed("a = 1", "a = \"2*V(1)\"") == "V(1)");
    CHECK(pointed("[1, 2]", "[1, \"V(2)\"]") == "V(2)");
    CHECK(pointed("\"i/2\"", "\"V(i)/2\"") == "V(i)");
    CHECK(pointed("\"i/2\"", "\"start[i]/2\"") == "start[i]");
    write(directory / "chain.toml", chain);
    CHECK(hvi_gen({"stepper", "chain.toml"}, directory.path()).status == 0);
}
