// Runs without a compiler: the bits of compiled ones in which no product is fused with a sum.
//
// NOTE: g++ 12 makes vfmaddsub of products, sums and differences side by side, whatever
// -ffp-contract says, and does not where it puts nothing side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;

namespace {

/// Runs in a directory with scenes, compiled and interpreted.
class BothWays {
public:
    BothWays() { use_cache(); }

    void write_scene(const std::string& name, const std::string& text) const {
        write(directory_ / name, text);
    }

    [[nodiscard]] Outcome interpreted(const std::string& words) const {
        return shell("export CXX=\"$PWD/none\"; hvi-gen run " + words +
                         " --interpret -o interpreted",
                     directory_.path());
    }

    [[nodiscard]] Outcome compiled(const std::string& words) const {
        return shell("export CXX='" + compiler_of_tests() +
                         " -ffp-contract=off -fno-tree-slp-vectorize'; hvi-gen run " + words +
                         " --lanes none -o compiled",
                     directory_.path());
    }

    /// Checks that both write equal tables, after they end with this status.
    void check_same(const std::string& words, int status = 0) const {
        const Outcome one = interpreted(words), other = compiled(words);
        INFO(words << "\n" << one.err << other.err);
        REQUIRE(one.status == status);
        REQUIRE(other.status == status);
        const std::string table = contents(directory_ / "interpreted/trajectory.csv");
        CHECK(lines_of(table).size() > 2);
        CHECK(table == contents(directory_ / "compiled/trajectory.csv"));
    }

    [[nodiscard]] const Directory& directory() const { return directory_; }

private:
    Directory directory_;
};

}  // namespace

TEST_CASE("steps that solve nothing are interpreted to the bits of compiled ones") {
    const BothWays both;
    for (const std::string words :
         {"henon-heiles --method stormer-verlet --until 50",
          "pendulum --method symplectic-euler --until 50",
          "pendulum --method adjoint-symplectic-euler --until 50",
          "kepler --method stormer-verlet --compose kahan-li:8 --step 1/10 --until 20",
          "outer-solar-system --method lobatto:2 --until 30000",
          "fpu --method stormer-verlet --compose suzuki:4 --step 1/50 --until 5",
          "kepler --method stormer-verlet --step -1/50 --until -3 --param ecc=1/10"})
        both.check_same(words + " --only table --no-symmetries");
}

TEST_CASE("stages that are solved for are interpreted to the bits of compiled ones") {
    const BothWays both;
    for (const std::string words :
         {"kepler --method gauss:4", "kepler --method gauss:1 --solver fixed-point",
          "kepler --method trig3 --step 1/50", "pendulum --method lobatto:4",
          "outer-solar-system --method gauss:3 --until 20000",
          "fpu --method gauss:6 --step 1/20 --until 5", "henon-heiles --method radau-left:3",
          "henon-heiles --method radau-right:2", "pendulum --method newton-cotes:4",
          "nonseparable --method gauss:3", "nonseparable --method stormer-verlet",
          "nonseparable --method radau-left:2", "double-pendulum --method gauss:2",
          "double-pendulum --method lobatto:3", "double-pendulum --method clenshaw-curtis:4",
          "point-vortices --method gauss:3", "point-vortices --method symplectic-euler",
          "kepler --method gauss:4 --sweeps 2", "nonseparable --method gauss:3 --sweeps 3"})
        both.check_same(words + " --only table --no-symmetries");
}

TEST_CASE("kinetic energy with a matrix, or without some momenta, is interpreted") {
    const BothWays both;
    both.write_scene("mass.toml", R"toml(
coordinates = ["x", "y"]
momenta = ["px", "py"]
parameters = {a = 3}
hamiltonian = "(a*px^2 + 2*px*py + py^2)/5 + x^4/4 + y^4/3 + x*y"
initial = {x = 1, y = "1/3", px = "1/7", py = 0}
)toml");
    both.write_scene("quartic.toml", R"toml(
coordinates = ["x", "y"]
momenta = ["px", "py"]
hamiltonian = "(px^2 + py^2)^2/4 + exp(x)/3 + exp(-x)/2 + y^4/3 + x*y"
initial = {x = 1, y = "1/3", px = "1/7", py = 1}
)toml");
    both.write_scene("cyclic.toml", R"toml(
coordinates = ["x", "y"]
momenta = ["px", "py"]
hamiltonian = "px^2/2 + x^4/4 + cos(x)*y^2"
initial = {x = 1, y = "1/3", px = "1/7", py = 1}
)toml");
    for (const std::string scene : {"mass.toml", "quartic.toml", "cyclic.toml"})
        for (const std::string method : {"gauss:3", "lobatto:3", "radau-right:3", "stormer-verlet"})
            both.check_same(scene + " --step 1/20 --until 5 --only table --method " + method);
}

TEST_CASE("all functions are interpreted to the bits of compiled ones") {
    const BothWays both;
    both.write_scene("functions.toml", R"toml(
coordinates = ["x", "y"]
momenta = ["px", "py"]
parameters = {a = "1/3", b = 2, c = "sqrt(2)"}
hamiltonian = """(px^2 + py^2)/2 + a*exp(-x^2) + log(1 + x^2)/b + sin(c*x)*cos(y) + tan(x/9)
    + atan(x*y) + asin(x/20) + acos(y/20) + sinh(x/5) + cosh(y) + tanh(x) + asinh(x) + acosh(3 + y^2)
    + atanh(y/20) + erf(x) + erfc(y) + cbrt(7 + x^2) + log10(2 + y^2) + atan2(x, 4 + y)
    + abs(x - y)^3 + max(x, y)^2/b + min(x, a)^2 + if(x < y, (x - y)^4, 0) + (2 + x^2)^a
    + (5 + x*y)^(-3/2) + 1/(4 + x) + y^3/7 - 3*x*y/11"""
initial = {x = "1/7", y = "1/3", px = "c/5", py = 0}
)toml");
    both.check_same("functions.toml --method stormer-verlet --step 1/40 --until 3 --only table");
    both.check_same(
        "functions.toml --method stormer-verlet --compose yoshida:6 --step 1/10 --until 3 "
        "--only table --param a=2/9");
}

TEST_CASE("forces that depend on the time are interpreted") {
    const BothWays both;
    both.write_scene("driven.toml", R"toml(
coordinates = ["q"]
momenta = ["p"]
parameters = {w = 3}
hamiltonian = "p^2/2 - cos(q)*(1 + sin(w*t)/3)"
initial = {q = 1, p = 0}
)toml");
    for (const std::string method :
         {"stormer-verlet", "symplectic-euler", "adjoint-symplectic-euler", "gauss:3", "lobatto:3",
          "radau-left:2"})
        both.check_same("driven.toml --step 1/10 --until 20 --only table --method " + method);
    both.write_scene("moved.toml", R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/(2 + sin(t)) - cos(q)*(1 + sin(3*t)/3) + t*p/7"
initial = {q = 1, p = 0}
)toml");
    for (const std::string method : {"stormer-verlet", "gauss:3", "lobatto:3"})
        both.check_same("moved.toml --step 1/10 --until 10 --only table --method " + method);
    both.check_same("driven.toml --step 1/10 --until 20 --only table --method stormer-verlet "
                    "--compose suzuki:4");
}

TEST_CASE("a step that fails ends an interpreted run") {
    const BothWays both;
    both.write_scene("fall.toml", R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 - q^4"
initial = {q = 1, p = 1}
)toml");
    both.check_same("fall.toml --method stormer-verlet --step 1/10 --until 10 --only table", 1);
}

TEST_CASE("summaries of interpreted runs say the same but for the time") {
    const BothWays both;
    const std::string words = "kepler --method stormer-verlet --step 1/100 --until 10";
    const Outcome one = both.interpreted(words), other = both.compiled(words);
    REQUIRE(one.status == 0);
    REQUIRE(other.status == 0);
    const auto said = [](const std::string& summary) {
        std::vector<std::string> lines;
        for (const std::string& line : lines_of(summary))
            if (line.rfind("time", 0) != 0) lines.push_back(line);
        return lines;
    };
    CHECK(said(one.out).size() + 1 == lines_of(one.out).size());
    CHECK(said(one.out) == said(other.out));
}

TEST_CASE("without a compiler steps are interpreted, where they can be") {
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& words) {
        return shell("export CXX=\"$PWD/none\"; hvi-gen run " + words + " --only summary",
                     directory.path());
    };
    const Outcome can = run("pendulum --method stormer-verlet");
    CHECK(can.status == 0);
    CHECK(can.err.find("there is no C++ compiler") != std::string::npos);
    CHECK(can.err.find("steps are interpreted") != std::string::npos);
    const Outcome cannot = run("heavy-top");
    CHECK(cannot.status == 3);
    CHECK(cannot.err.find("there is no C++ compiler") != std::string::npos);
}

TEST_CASE("where fixed points are too slow an interpreted run says so") {
    const BothWays both;
    both.write_scene("stiff.toml", R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 + 10000*q^2/2 + q^4"
initial = {q = 1, p = 0}
)toml");
    const Outcome outcome =
        both.interpreted("stiff.toml --method gauss:2 --step 1/5 --until 1 --only table");
    CHECK(outcome.status == 3);
    CHECK(outcome.err.find("Newton's method needs a compiler") != std::string::npos);
    CHECK(!std::filesystem::exists(both.directory() / "interpreted/trajectory.csv"));
}

TEST_CASE("what cannot be interpreted is refused") {
    use_cache();
    const Directory directory;
    for (const std::string words :
         {"heavy-top", "two-pendulums", "fpu-chain --unroll no --method stormer-verlet",
          "kepler --method gauss:2 --solver newton", "kepler --method gauss:2 --lanes stages",
          "harmonic-oscillator --method gauss:2"}) {
        const Outcome outcome =
            shell("hvi-gen run --interpret --step 1/10 " + words, directory.path());
        INFO(words << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find("--interpret") != std::string::npos);
    }
}
