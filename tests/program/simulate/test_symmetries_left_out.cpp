// Runs and reports never wait for symmetries.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "tests/program/cli/torsion.hpp"
#include "tests/program/simulate/pretended.hpp"

using namespace hvi::test;

namespace {

bool has_words(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const char* const given_up = "not looked for: the search was given up after about a second; "
                             "`hvi-gen symmetries torsion.toml` "
                             "looks for them";

}  // namespace

TEST_CASE("a run gives up a search for symmetries that takes long, and says so") {
    const PretendedCompiler compiler;
    write(compiler.directory / "torsion.toml", torsion);
    const Outcome first = compiler.run("$hvi_gen run torsion.toml --only summary -o out");
    INFO(first.err);
    CHECK(first.status == 0);
    CHECK(has_words(first.err, given_up));
    CHECK(has_words(first.out, "symmetries   " + std::string(given_up)));
    CHECK(contents(compiler.directory / "out/summary.txt") == first.out);
    CHECK(compiler.run("$hvi_gen run torsion.toml --only summary").out == first.out);
}

TEST_CASE("a run that is to look for no symmetries does not speak of them") {
    const PretendedCompiler compiler;
    write(compiler.directory / "torsion.toml", torsion);
    const Outcome torsion_run =
        compiler.run("$hvi_gen run torsion.toml --only summary --no-symmetries");
    INFO(torsion_run.err);
    CHECK(torsion_run.status == 0);
    CHECK(torsion_run.err.empty());
    CHECK_FALSE(has_words(torsion_run.out, "symmetries"));
    // The angular momentum of a plane that is turned is found, and would be a second value.
    write(compiler.directory / "turned.toml",
          "hamiltonian = \"(px^2 + py^2 + x^2 + y^2)/2\"\ncoordinates = [\"x\", \"y\"]\n"
          "momenta = [\"px\", \"py\"]\ninitial = {x = 1, y = 0, px = 0, py = 1}\n"
          "run = {method = \"midpoint\", step = 0.1, until = 1}\n");
    CHECK(compiler.run("$hvi_gen run turned.toml --only summary --no-symmetries").status == 0);
    CHECK(compiler.run("$hvi_gen run turned.toml --only summary").status == 3);
}

TEST_CASE("a report gives up that search too") {
    const PretendedCompiler compiler;
    write(compiler.directory / "torsion.toml", torsion);
    const Outcome outcome = compiler.run("$hvi_gen report torsion.toml --only work,json -o out");
    INFO(outcome.err);
    CHECK(has_words(contents(compiler.directory / "out/report.json"),
                    "symmetries of torsion are not looked for: the search was given up"));
    CHECK(compiler
              .run("$hvi_gen report torsion.toml --only work,json -o out --no-symmetries; "
                   "grep -c symmetries out/report.json")
              .out == "0\n");
}

TEST_CASE("an interruption ends exact computations of a run at once") {
    for (const std::string signal : {"INT", "TERM"}) {
        const PretendedCompiler compiler;
        const Outcome outcome = compiler.run("timeout -s KILL 30 $hvi_gen run scene.toml --basis "
                                             "trig:64 --nodes gauss:64 -o out & sleep 2; "
                                             "kill -" +
                                             signal + " $!; wait $!");
        INFO(signal << "\n" << outcome.err);
        CHECK(outcome.status == 130);
        CHECK(outcome.out.empty());
        CHECK_FALSE(std::filesystem::exists(compiler.directory / "out"));
    }
}

TEST_CASE("an interruption ends exact computations of a report soon") {
    for (const std::string signal : {"INT", "TERM"}) {
        const PretendedCompiler compiler;
        const Outcome outcome =
            compiler.run("timeout -s KILL 30 $hvi_gen report scene.toml --basis trig:40 --nodes "
                         "gauss:40 --only work,json -o out & "
                         "sleep 4; kill -" +
                         signal + " $!; wait $!");
        INFO(signal << "\n" << outcome.err);
        CHECK(outcome.status == 130);
        CHECK_FALSE(std::filesystem::exists(compiler.directory / "out"));
    }
}
