// A run in which the energy changes by much says so.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;

namespace {

/// Runs the oscillator from (1, 0) with symplectic-euler, whose steps keep
/// q^2 + p^2 + h q p or q^2 + p^2 - h q p: so H changes by up to (1/2) (h/2)/(1 - h/2).
Outcome oscillator(const std::string& hamiltonian, const std::string& step) {
    use_cache();
    const Directory directory;
    write(directory / "scene.toml", "hamiltonian = \"" + hamiltonian +
                                        "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                        "initial = {q = 1, p = 0}\n");
    return hvi_gen({"run", "scene.toml", "--method", "symplectic-euler", "--step", step, "--until",
                    "60", "--only", "summary"},
                   directory.path());
}

bool has_warning(const Outcome& outcome) {
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    return outcome.err.find("warning: the energy changes by ") != std::string::npos;
}

}  // namespace

TEST_CASE("a change of the energy by more than a tenth of it is spoken of") {
    CHECK_FALSE(has_warning(oscillator("(p^2 + q^2)/2", "3/20")));  // 8.1 per cent
    const Outcome outcome = oscillator("(p^2 + q^2)/2", "1/4");     // 14.3 per cent
    CHECK(has_warning(outcome));
    CHECK(outcome.err == "warning: the energy changes by 0.071, of a scale of 0.5: the step is too "
                         "large\nhelp: a smaller --step; or in its place --accuracy 1e-6, which "
                         "finds a method and a step\n");
}

TEST_CASE("an energy that begins at 0 has the scale of the motion") {
    // The mean of p^2/2 is 1/4, of which the energy changes by 5 and by 29 per cent.
    CHECK_FALSE(has_warning(oscillator("(p^2 + q^2 - 1)/2", "1/20")));
    CHECK(has_warning(oscillator("(p^2 + q^2 - 1)/2", "1/4")));
}

TEST_CASE("an energy far below its terms is a scale all the same") {
    use_cache();
    // At the sun p^2/2 is 20 000 times -H = 1/2.
    const auto orbit = [](const std::string& step) {
        return hvi_gen({"run", "kepler", "--param", "ecc=0.9999", "--method", "gauss:2", "--step",
                        step, "--until", "2*pi", "--only", "summary"});
    };
    CHECK(has_warning(orbit("pi/500")));
    CHECK_FALSE(has_warning(hvi_gen({"run", "kepler", "--only", "summary"})));
}

TEST_CASE("nothing is said of an energy that need not be conserved, or where nothing moves") {
    CHECK_FALSE(has_warning(oscillator("(p^2 + q^2)/2 + 3*q*cos(t)", "1/4")));
    CHECK_FALSE(has_warning(oscillator("p^2/2 + (q - 1)^2/2", "1/4")));
}
