// `hvi-gen symmetries` as a user runs it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/program.hpp"
#include "tests/program/cli/refusals.hpp"
#include "tests/program/cli/torsion.hpp"

using namespace hvi::test;

namespace {

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const char* const motion_in_a_bowl = R"(
coordinates = ["x", "y"]
momenta     = ["px", "py"]
hamiltonian = "(px^2 + py^2)/2 + (x^2 + y^2)^2"
[invariants]
L  = "x*py - y*px"
px = "INVARIANT"
[initial]
x  = 1
y  = 0
px = 0
py = 1
[run]
method = "gauss:2"
step   = "1/10"
until  = 1
)";

std::string scene_with(const std::string& invariant) {
    std::string text = motion_in_a_bowl;
    text.replace(text.find("px = \"INV"), 16, "I = \"" + invariant + "\"");
    return text;
}

}  // namespace

TEST_CASE("The symmetries of a scene as text") {
    const Outcome found = hvi_gen({"symmetries", "kepler"});
    CHECK(found.status == 0);
    CHECK(found.out == R"(kepler

symmetries    1 generator of affine transformations, and these are all
  J1          x*py-y*px
              by x' = -y, y' = x
algebra       so(2): all brackets vanish

regular       yes: d2H/dp2 has the rank 2 of 2

invariants    angular_momentum: conserved
)");
    CHECK(says(hvi_gen({"symmetries", "qp"}).out, "no: d2H/dp2 has the rank 0 of 1"));
    CHECK(says(hvi_gen({"symmetries", "--hamiltonian", "p^2/2 + log(1+atan(q))"}).out, "none"));
}

TEST_CASE("The symmetries of a Hamiltonian as JSON") {
    const Outcome found = hvi_gen({"symmetries", "--hamiltonian", "(p1^2+p2^2)/2 + a*(q1^2+q2^2)^2",
                                   "--param", "a=3", "--format", "json"});
    CHECK(found.status == 0);
    for (const char* part :
         {"\"schema\": \"hvi-symmetries/1\"", "\"regular\": true", "\"rank\": 2",
          "\"degrees_of_freedom\": 2", "\"complete\": true", "\"q1\": \"-q2\"", "\"q2\": \"q1\"",
          "\"momentum_map\": \"q1*p2-q2*p1\"", "\"name\": \"so(2)\""})
        CHECK(says(found.out, part));
    const Outcome kepler = hvi_gen({"symmetries", "kepler", "--format", "json"});
    CHECK(says(kepler.out, "\"name\": \"angular_momentum\""));
    CHECK(says(kepler.out, "\"conserved\": true"));
    CHECK(says(kepler.out, "\"bracket\": \"0\""));
}

TEST_CASE("The same input gives the same bytes") {
    for (const char* name : {"outer-solar-system", "robot-arm"}) {
        const Outcome first = hvi_gen({"symmetries", name, "--format", "json"});
        CHECK(first.status == 0);
        for (int round = 0; round < 3; ++round)
            CHECK(hvi_gen({"symmetries", name, "--format", "json"}).out == first.out);
    }
}

TEST_CASE("An invariant that is none is an error of symmetries") {
    const Directory directory;
    write(directory / "scene.toml", scene_with("x*py + y*px"));
    const Outcome found = hvi_gen({"symmetries", "scene.toml"}, directory.path());
    CHECK(found.status == 1);
    CHECK(found.out.empty());
    CHECK(says(found.err, "the invariant `I`: {I, H} = 2*px*py-8*x^3*y-8*x*y^3 is not "
                          "zero as a function of q and p"));
    CHECK(says(found.err, "^~~~~~~~~~~"));
    write(directory / "scene.toml", scene_with("(px^2+py^2)/2 + (x^2+y^2)^2"));
    CHECK(hvi_gen({"symmetries", "scene.toml"}, directory.path()).status == 0);
}

TEST_CASE("What symmetries cannot read") {
    CHECK(hvi_gen({"symmetries"}).status == 2);
    CHECK(hvi_gen({"symmetries", "keppler"}).status == 2);
    CHECK(hvi_gen({"symmetries", "kepler", "--hamiltonian", "p"}).status == 2);
    CHECK(hvi_gen({"symmetries", "kepler", "--param", "nu=1"}).status == 2);
    CHECK(hvi_gen({"symmetries", "kepler", "--method", "gauss:2"}).status == 2);
    CHECK(hvi_gen({"symmetries", "kepler", "--format", "latex"}).status == 2);
    CHECK(hvi_gen({"symmetries", "--hamiltonian", "p^2/0"}).status == 2);
    CHECK(hvi_gen({"symmetries", "--hamiltonian", "p^2/2 + sqrt(-1)"}).status == 1);
}

TEST_CASE("What a method keeps of a scene stands beside its certificate") {
    const Outcome text = hvi_gen({"check", "--method", "lobatto:3", "kepler", "--max-order", "2"});
    CHECK(text.status == 0);
    CHECK(says(text.out, R"(Of kepler

momentum maps x*py-y*px: kept
              (the action is affine, and the method interpolates in a vector
              space)
invariants    angular_momentum: kept
)"));
    CHECK(says(text.out, "energy: not conserved exactly by this method"));
    // A = A~ decides on a quadratic H
    const auto of_oscillator = [](const char* method) {
        return hvi_gen({"check", "--method", method, "harmonic-oscillator", "--max-order", "2"})
            .out;
    };
    CHECK(says(of_oscillator("gauss:2"), "energy: kept"));
    CHECK(says(of_oscillator("lobatto:3"), "energy: not conserved exactly by this method"));
    // the general form, which makes no steps of some H
    const std::vector<std::string> general{"check",   "--basis",   "1, tau",
                                           "--nodes", "0, 1/2, 1", "--max-order",
                                           "2",       "--format",  "json"};
    const auto of = [&](std::vector<std::string> scene) {
        scene.insert(scene.begin(), general.begin(), general.end());
        return hvi_gen(scene).out;
    };
    CHECK(says(of({"kepler"}), "\"kept\": true"));
    CHECK_FALSE(says(of({"qp"}), "\"kept\": true"));
    CHECK(says(of({"qp"}), "d2H/dp2 is singular"));
    CHECK(says(of({"--hamiltonian", "p^2/2+a*q^4", "--param", "a=2"}), "not quadratic"));
    CHECK(hvi_gen({"check", "--method", "gauss:2", "--hamiltonian", "p^2/2", "--param", "b=2"})
              .status == 2);
}

namespace {

/// The sphere, seen from a pole: turned about another axis, which is no affine map of the picture.
const char* const sphere = R"(
coordinates = ["x", "y"]
momenta     = ["px", "py"]
hamiltonian = "(px^2 + py^2)*(1 + x^2 + y^2)^2/2"
[invariants]
L = "x*py - y*px"
nearly = {value = "x", approximate = true}
[symmetries]
tilt = {x = "1 + x^2 - y^2", y = "2*x*y"}
[initial]
x  = 1
y  = 0
px = 0
py = 1
[run]
method = "gauss:2"
step   = "1/20"
until  = 1
)";

std::string sphere_with(const std::string& old, const std::string& other) {
    std::string text = sphere;
    return text.replace(text.find(old), old.size(), other);
}

}  // namespace

TEST_CASE("A symmetry that is not affine is one that the scene names") {
    const Directory directory;
    const auto of = [&](const std::string& text, const std::string& format = "text") {
        write(directory / "sphere.toml", text);
        return hvi_gen({"symmetries", "sphere.toml", "--format", format}, directory.path());
    };
    CHECK(says(of(sphere).out, "tilt, with (1+x^2-y^2)*px+2*x*y*py: conserved"));
    CHECK(says(of(sphere).out, "nearly: approximate: {nearly, H} = "));
    CHECK(says(of(sphere, "json").out, "\"momentum_map\": \"(1+x^2-y^2)*px+2*x*y*py\""));
    CHECK(says(of(sphere, "json").out, "\"approximate\": true"));
    const Outcome kept = hvi_gen(
        {"check", "--method", "gauss:2", "sphere.toml", "--max-order", "2"}, directory.path());
    CHECK(says(kept.out, "tilt: measured, not claimed"));
    CHECK(says(kept.out, "nearly: its bracket with H is not zero"));

    const auto check = [&](int status, const std::string& place, const std::string& text) {
        const Outcome outcome = of(text);
        INFO(outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        check_form(outcome.err);
        CHECK(pointed_at(outcome.err) == place);
    };
    check(1, "tilt", sphere_with("2*x*y", "x*y"));
    check(1, "x", sphere_with("{value = \"x\", approximate = true}", "\"x\""));
    check(1, "x", sphere_with("true", "false"));
    check(2, "px", sphere_with("{x = \"1 + x^2 - y^2\"", "{px = \"1\""));
    check(2, "z", sphere_with("{x = \"1 + x^2 - y^2\"", "{z = \"1\""));
    check(2, "py", sphere_with("2*x*y", "2*x*py"));
    check(2, "z", sphere_with("2*x*y", "2*x*z"));
    check(2, "t", sphere_with("2*x*y", "2*x*t"));
    check(2, "1", sphere_with("true", "1"));
    check(2, "nearby", sphere_with("approximate", "nearby"));
    check(2, "L", sphere_with("tilt", "L"));
    check(2, "pi", sphere_with("tilt", "pi"));
    CHECK(of(sphere_with("{x = \"1 + x^2 - y^2\", y = \"2*x*y\"}", "{}")).status == 2);
    CHECK(of(sphere_with("{x = \"1 + x^2 - y^2\", y = \"2*x*y\"}", "3")).status == 2);
    CHECK(of(sphere_with("{value = \"x\", approximate = true}", "{approximate = true}")).status ==
          2);
}

TEST_CASE("A search for symmetries that takes for ever is interrupted") {
    for (const std::string signal : {"INT", "TERM"}) {
        const Directory directory;
        write(directory / "torsion.toml", torsion);
        const Outcome outcome = shell(
            "timeout -s KILL 30 \"$hvi_gen\" symmetries torsion.toml -o out & sleep 3; kill -" +
                signal + " $!; wait $!",
            directory.path());
        INFO(signal << "\n" << outcome.err);
        CHECK(outcome.status == 130);
        CHECK(outcome.out.empty());
        CHECK(directory.names() == std::vector<std::string>{"torsion.toml"});
    }
}

TEST_CASE("A certificate does not wait for symmetries") {
    const Directory directory;
    write(directory / "torsion.toml", torsion);
    const std::vector<std::string> words{"check", "--method", "gauss:2", "torsion.toml"};
    const Outcome text = hvi_gen(words, directory.path());
    CHECK(text.status == 0);
    CHECK(says(text.out,
               "Of torsion\n\nsymmetries    not looked for: the search was given up after "
               "about a second\n"));
    std::vector<std::string> without = words;
    without.insert(without.end(), {"--no-symmetries", "--format", "json"});
    const Outcome json = hvi_gen(without, directory.path());
    CHECK(json.status == 0);
    CHECK(says(json.out, "\"left_out\": \"--no-symmetries is given\",\n  \"momentum_maps\": null"));
    const Outcome no_scene = hvi_gen({"check", "--method", "gauss:2", "--no-symmetries"});
    CHECK(no_scene.status == 2);
}
