// Modules that hvi-gen compiles and drives: what is data, and what is no module.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/drive/module.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;

namespace {

/// A compiler that wraps the tests' compiler and counts how often it compiles, in a fresh cache.
class CountedCompiler {
public:
    CountedCompiler() {
        write(directory / "cxx", "#!/bin/sh\n[ \"$1\" = --version ] || echo >> '" +
                                     (directory / "compilations").string() + "'\nexec " +
                                     compiler_of_tests() + " \"$@\"\n");
        std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
        write(directory / "compilations", "");
    }

    [[nodiscard]] Outcome run(const std::string& line) const {
        return shell("export CXX=\"$PWD/cxx\" XDG_CACHE_HOME=\"$PWD/cache\"; " + line,
                     directory.path());
    }

    [[nodiscard]] std::size_t compilations() const {
        return lines_of(contents(directory / "compilations")).size();
    }

    const Directory directory;
};

std::string after(const std::string& text, const std::string& word) {
    const std::size_t place = text.find("\n" + word);
    REQUIRE(place != std::string::npos);
    return text.substr(place + 1, text.find('\n', place + 1) - place - 1);
}

}  // namespace

TEST_CASE("another value of a parameter starts no compiler") {
    const CountedCompiler compiler;
    const std::string run = "hvi-gen run kepler --method gauss:2 --only summary ";
    const Outcome usual = compiler.run(run), other = compiler.run(run + "--param ecc=3/10"),
                  third = compiler.run(run + "--param mu=2 --param ecc=0.1 --step 0.01");
    INFO(usual.err << other.err << third.err);
    REQUIRE(usual.status == 0);
    REQUIRE(other.status == 0);
    REQUIRE(third.status == 0);
    CHECK(compiler.compilations() == 1);
    // The angular momentum of an ellipse of semi-axis 1 is sqrt(mu (1 - e^2)).
    CHECK(after(usual.out, "angular_momentum").find(" 0.8,") != std::string::npos);
    CHECK(after(other.out, "angular_momentum").find(" 0.9539392014,") != std::string::npos);
    CHECK(after(third.out, "angular_momentum").find(" 1.407124728,") != std::string::npos);
}

TEST_CASE("another size starts no compiler where sums stay loops") {
    const CountedCompiler compiler;
    const std::string run = "hvi-gen run fpu-chain --unroll no --until 1 --only summary ";
    const Outcome usual = compiler.run(run + "--no-symmetries"),
                  other = compiler.run(run + "--no-symmetries --param N=2000 --param beta=1/10");
    INFO(usual.err << other.err);
    REQUIRE(usual.status == 0);
    REQUIRE(other.status == 0);
    CHECK(compiler.compilations() == 1);
    CHECK(after(usual.out, "energy") != after(other.out, "energy"));
}

TEST_CASE("a scene with other values in it starts no compiler") {
    const CountedCompiler compiler;
    const auto report = [&](const std::string& omega) {
        write(compiler.directory / "spring.toml",
              "name = \"spring\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
              "hamiltonian = \"p^2/2 + omega^2*q^2/2\"\nparameters = {omega = " +
                  omega +
                  "}\ninitial = {q = 1, p = 0}\n"
                  "exact = {q = \"cos(omega*t)\", p = \"-omega*sin(omega*t)\"}\n"
                  "run = {step = 0.1, until = 10}\n");
        return compiler.run("hvi-gen report spring.toml --methods gauss:2,midpoint --only work,csv "
                            "--no-symmetries --steps 0.1");
    };
    // The midpoint's phase is wrong by omega^3 h^2 t/12, and p = -omega sin(omega t) by omega of it.
    const auto error = [&] {
        std::string row = contents(compiler.directory / "report/report.csv");
        row.erase(0, row.find("\"midpoint\""));
        for (int field = 0; field < 6; ++field) row.erase(0, row.find(',') + 1);
        return std::stod(row);
    };
    REQUIRE(report("1").status == 0);
    CHECK(compiler.compilations() == 2);  // one for each method
    const double slow = error();
    REQUIRE(report("2").status == 0);
    CHECK(compiler.compilations() == 2);
    CAPTURE(slow, error());
    CHECK(error() > 8 * slow / 2);
    CHECK(error() < 16 * slow * 2);
}

TEST_CASE("another start starts no compiler") {
    const CountedCompiler compiler;
    const auto first_row = [&](const std::string& x) {
        write(compiler.directory / "two.toml",
              "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {a = 2}\n"
              "hamiltonian = \"(px^2 + py^2)/2 + a*x^2*y^2/2\"\n"
              "[initial]\nx = \"" +
                  x + "\"\ny = \"a/3\"\npx = 0\npy = \"sin(pi*a)\"\n");
        const Outcome run =
            compiler.run("hvi-gen run two.toml -o out --method stormer-verlet "
                         "--step 0.1 --until 0.1 --no-symmetries --columns x,y,px,py --only table");
        INFO(run.err);
        REQUIRE(run.status == 0);
        return lines_of(contents(compiler.directory / "out/trajectory.csv")).at(1);
    };
    // Correctly rounded: sin(2 pi) is 0, which of the double 2 pi is -2.4e-16.
    CHECK(first_row("1/3") == "0,0.3333333333333333,0.6666666666666666,0,0");
    CHECK(first_row("sqrt(a)") == "0,1.4142135623730951,0.6666666666666666,0,0");
    CHECK(compiler.compilations() == 1);
}

TEST_CASE("other values of a list start no compiler") {
    const CountedCompiler compiler;
    const auto first_row = [&](const std::string& masses) {
        write(compiler.directory / "free.toml",
              "coordinates = [\"x[1..3]\"]\nmomenta = [\"p[1..3]\"]\nparameters = {m = " + masses +
                  "}\nhamiltonian = \"sum(i=1..3, p[i]^2/(2*m[i]) + x[i]^4)\"\n"
                  "[initial]\n\"x[i]\" = 0\n\"p[i]\" = 1\n");
        const Outcome run =
            compiler.run("hvi-gen run free.toml -o out --method stormer-verlet --unroll no "
                         "--step 1/2 --until 1/2 --columns energy --only table");
        INFO(run.err);
        REQUIRE(run.status == 0);
        return lines_of(contents(compiler.directory / "out/trajectory.csv")).at(1);
    };
    CHECK(first_row("[1, 2, 4]") == "0,0.875");
    CHECK(first_row("[\"1/2\", 1, 1]") == "0,2");
    CHECK(compiler.compilations() == 1);
}

TEST_CASE("solvers are compiled when a step calls for them") {
    const CountedCompiler compiler;
    const auto run = [&](const std::string& words) {
        const Outcome outcome = compiler.run("hvi-gen run kepler -o out --method gauss:4 " + words);
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return lines_of(contents(compiler.directory / "out/trajectory.csv"));
    };
    run("--step 1/50");
    CHECK(compiler.compilations() == 1);
    // Around the pericentre fixed points do not contract, and Newton's method goes on.
    const auto large = run("--step 7/10 --until 70");
    CHECK(compiler.compilations() == 2);
    REQUIRE(large.size() == 102);
    CHECK(run("--step 7/10 --until 70 --param ecc=1/2").size() == 102);
    CHECK(compiler.compilations() == 2);
    CHECK(run("--step 7/10 --until 70") == large);
    run("--step 1/50 --solver fixed-point");
    CHECK(compiler.compilations() == 3);
}

TEST_CASE("what is no module is refused") {
    const Directory directory;
    write(directory / "text.so", "no library");
    for (const std::string& library :
         {(directory / "text.so").string(), (directory / "missing.so").string(),
          std::string("libm.so.6")}) {
        INFO(library);
        CHECK_THROWS_AS(hvi::gen::loaded_module({library, "", ".", {}}), std::runtime_error);
    }
}
