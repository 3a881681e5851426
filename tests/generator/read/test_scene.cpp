// Scenes as they are read.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

TEST_CASE("a scene is read") {
    const WrittenOutScene scene = read(planet);
    CHECK(scene.name == "planet");
    CHECK(scene.description.empty());
    CHECK(hamiltonian_of(scene).coordinates == Names{"x", "y"});
    CHECK(hamiltonian_of(scene).momenta == Names{"px", "py"});
    CHECK(hamiltonian_of(scene).origin == "s.toml");
    CHECK(hamiltonian_of(scene).parameters.empty());
    CHECK(hamiltonian_of(scene).source->name == "s.toml:4");
    CHECK(names(scene.parameters) == Names{"mu", "ecc"});
    CHECK(to_text(scene.parameters[1].value) == "3/5");
    CHECK(lines(scene.invariants) == Names{"angular = x*py-y*px"});
    CHECK(lines(scene.initial) ==
          Names{"x = 1-ecc", "y = 0", "px = 0", "py = sqrt(mu*(1+ecc)/(1-ecc))"});
    CHECK(scene.initial[3].place.source->name == "s.toml:14");
    CHECK(scene.exact.empty());
    CHECK(written(planet).run.method->text == "gauss:4");
    const SceneTimes times = times_of(written(planet));
    CHECK(to_text(times.step->expression) == "1/20");
    CHECK(to_text(times.until->expression) == "200");
}

TEST_CASE("indexed names are all of them, and their values a list") {
    const WrittenOutScene scene = read(bodies);
    CHECK(scene.name == "s");
    CHECK(variables(hamiltonian_of(scene)) ==
          Names{"x[1]", "x[2]", "x[3]", "p[1]", "p[2]", "p[3]"});
    CHECK(names(scene.parameters) == Names{"m[1]", "m[2]", "m[3]"});
    CHECK(to_text(scene.parameters[2].value) == "1/4");
    CHECK(lines(scene.initial) ==
          Names{"x[1] = 1", "x[2] = 2", "x[3] = -3", "p[1] = 0", "p[2] = 0", "p[3] = m[2]"});
    CHECK(written(bodies).run.method == nullptr);
    CHECK(!times_of(written(bodies)).step);
    const WrittenOutScene other = read(edited(bodies, "\"x[1..3]\"", "[\"x[2..3]\", \"x[1]\"]"));
    CHECK(hamiltonian_of(other).coordinates == Names{"x[2]", "x[3]", "x[1]"});
    CHECK(lines(other.initial)[0] == "x[2] = 2");
    CHECK(lines(other.initial)[2] == "x[1] = 1");
}

TEST_CASE("what is in a scene stands as in the file, and means what is written") {
    const std::string text = edited(planet, "mu = 1\n", "mu = 1\nzeta = 0.1\nb = 1e-3\na = -2\n");
    const WrittenOutScene scene =
        read(edited(text, "[initial]", "z = \"px\"\nf = \"x\"\n[initial]"));
    CHECK(names(scene.parameters) == Names{"mu", "zeta", "b", "a", "ecc"});
    CHECK(to_text(scene.parameters[1].value) == "1/10");
    CHECK(to_text(scene.parameters[2].value) == "1/1000");
    CHECK(to_text(scene.parameters[3].value) == "-2");
    CHECK(lines(scene.invariants) == Names{"angular = x*py-y*px", "z = px", "f = x"});
}

TEST_CASE("the time may stand in H and in the exact solution") {
    const WrittenOutScene scene =
        read("coordinates = \"q\"\nmomenta = \"p\"\n"
             "hamiltonian = \"p^2/2 + q*cos(t)\"\n"
             "description = \"driven\"\n"
             "[initial]\nq = 1\np = 0\n[exact]\nq = \"cos(t)\"\np = \"-sin(t)\"\n");
    CHECK(depends_on_time(hamiltonian_of(scene)));
    CHECK(lines(scene.exact) == Names{"q = cos(t)", "p = -sin(t)"});
    CHECK(scene.description == "driven");
    CHECK(!depends_on_time(hamiltonian_of(read(planet))));
}

TEST_CASE("a parameter of a scene has its value wherever it occurs") {
    const auto set = [](Method& method, Scene& scene, const std::string& text) {
        set_parameter(method, scene, parse_parameter(source(text, "--param")));
    };
    Method method = method_from_text(source("1, cos(mu*w*tau)"), source("0, 1"));
    Scene scene = written(planet);
    set(method, scene, "ecc=1/2");
    CHECK(to_text(unrolled(scene).parameters[1].value) == "1/2");
    CHECK(hamiltonian_of(unrolled(scene)).parameters.empty());
    CHECK(method.parameters.empty());
    set(method, scene, "mu=2");
    CHECK(to_text(unrolled(scene).parameters[0].value) == "2");
    REQUIRE(hamiltonian_of(unrolled(scene)).parameters.size() == 1);
    REQUIRE(method.parameters.size() == 1);
    set(method, scene, "w=3");
    CHECK(method.parameters.size() == 2);
    const Refusal unknown = refusal([&] {
        set(method, scene, "ec=1");
        return 0;
    });
    CHECK(unknown.marked == "[ec]=1");
    CHECK(unknown.helps("`ecc`"));
    CHECK(refusal([&] {
              set(method, scene, "px=1");
              return 0;
          }).says("is a variable"));
    Scene many = written(bodies);
    many.fixed = {"m[2]"};
    set(method, many, "m[2]=7");
    CHECK(to_text(unrolled(many).parameters[1].value) == "7");
    CHECK(to_text(hamiltonian_of(unrolled(many)).parameters[0].value) == "7");
    for (const std::string text :
         {"m[2=7", "m[]=1", "m[01]=1", "m[1]x=1", "[1]=1", "m[x]=1", "m[1][2]=3"})
        CHECK(refusal([&] { return parse_parameter(source(text)); }).says("is no name for"));
    CHECK(refusal([&] { return parse_parameter(source("pi[1]=1")); }).says("reserved"));
}

TEST_CASE("the scenes that come with the program are read") {
    struct Facts {
        std::string name;
        std::size_t degrees_of_freedom;
        Names parameters;
        std::size_t invariants;
        bool has_exact;
        std::string method, step, until, some_value;
    };
    const std::vector<Facts> all = {
        {"bead-on-hoop", 1, {"m", "r", "g", "w"}, 0, false, "gauss:3", "1/20", "200", "a = 1/10"},
        {"bouncing-ball", 1, {}, 0, false, "stormer-verlet", "1/20", "20", "q = 1"},
        {"chain-of-links", 6, {"m", "l", "g"}, 0, false, "gauss:3", "1/200", "20", "a[6] = pi/8"},
        {"double-pendulum",
         2,
         {"m1", "m2", "l1", "l2", "g"},
         0,
         false,
         "gauss:4",
         "1/100",
         "100",
         "theta2 = pi/4"},
        {"eccentric-kepler", 2, {"ecc"}, 3, false, "stormer-verlet", "pi/25", "20*pi", "x = 1-ecc"},
        {"eccentric-planet",
         6,
         {"G", "m[1]", "m[2]", "m[3]", "ecc"},
         3,
         false,
         "mclachlan:8.4",
         "1/20",
         "1000",
         "x[1] = 0"},
        {"fpu", 6, {"omega"}, 0, false, "gauss:3", "1/50", "200", "d[1] = 1/omega"},
        {"harmonic-oscillator", 1, {"omega"}, 0, true, "gauss:2", "1/10", "100", "q = 1"},
        {"henon-heiles", 2, {}, 0, false, "gauss:4", "1/4", "1000", "px = sqrt(301/1500)"},
        {"kepler", 2, {"mu", "ecc"}, 1, false, "gauss:4", "1/20", "200", "x = 1-ecc"},
        {"nonseparable", 1, {}, 0, false, "gauss:3", "1/50", "1000", "q = -3"},
        {"outer-solar-system",
         18,
         {"G", "m[1]", "m[2]", "m[3]", "m[4]", "m[5]", "m[6]"},
         6,
         false,
         "gauss:8",
         "300",
         "500000",
         "py[6] = -85351*m[6]/50000000"},
        {"pendulum", 1, {}, 0, false, "gauss:3", "1/10", "1000", "q = 3/2"},
        {"point-vortices",
         4,
         {"g[1]", "g[2]", "g[3]", "g[4]"},
         3,
         false,
         "gauss:3",
         "1/20",
         "100",
         "p[3] = -g[3]"},
        {"pythagorean", 6, {}, 3, false, "gauss:8", "1/10", "63", "y3 = -1"},
        {"qp", 1, {}, 0, true, "chebyshev:3", "1/10", "3", "p = 1"},
        {"robot-arm",
         3,
         {"m1", "m2", "m3", "l1", "l2", "l3", "k2", "k3"},
         0,
         false,
         "gauss:3",
         "1/100",
         "100",
         "w3 = 1/2"},
        {"spherical-pendulum", 2, {"m", "l", "g"}, 1, false, "gauss:4", "1/20", "200", "vphi = 2"},
        {"two-pendulums",
         2,
         {"m1", "m2", "l1", "l2", "g"},
         0,
         false,
         "gauss:4",
         "1/100",
         "100",
         "theta2 = pi/4"}};
    std::vector<SceneEntry> entries = scenes();
    CHECK(entries.size() == 36);
    // NOTE: for those with rotations see test_rotations.cpp.
    const auto is_other = [](const SceneEntry& entry) {
        return entry.degrees_of_freedom > 64 ||
               !function_of(embedded(std::string(entry.name))).rotations.empty();
    };
    entries.erase(std::remove_if(entries.begin(), entries.end(), is_other), entries.end());
    REQUIRE(entries.size() == all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Facts& facts = all[k];
        CHECK(entries[k].degrees_of_freedom == facts.degrees_of_freedom);
        CAPTURE(facts.name);
        const WrittenOutScene scene = embedded(facts.name);
        CHECK(entries[k].name == facts.name);
        CHECK(entries[k].description == scene.description);
        CHECK(scene.description.size() > 20);
        CHECK(scene.name == facts.name);
        CHECK(function_of(scene).origin == facts.name);
        CHECK(function_of(scene).degrees_of_freedom() == facts.degrees_of_freedom);
        CHECK(names(scene.parameters) == facts.parameters);
        CHECK(scene.invariants.size() == facts.invariants);
        CHECK(scene.initial.size() == 2 * facts.degrees_of_freedom);
        CHECK(scene.exact.size() == (facts.has_exact ? 2 * facts.degrees_of_freedom : 0));
        const Scene found = find_scene(source(std::string(facts.name), "SCENE"));
        CHECK(found.run.method->text == facts.method);
        const SceneTimes times = times_of(found);
        CHECK(to_text(times.step->expression) == facts.step);
        CHECK(to_text(times.until->expression) == facts.until);
        const Names values = lines(scene.initial);
        CHECK(std::find(values.begin(), values.end(), facts.some_value) != values.end());
    }
}

// NOTE: without being written out; they are run at their sizes as soon as sums stay loops.
TEST_CASE("large scenes that come with the program") {
    std::vector<std::string> found;
    for (const SceneEntry& entry : scenes()) {
        if (entry.degrees_of_freedom <= 64) { continue; }
        CAPTURE(std::string(entry.name));
        found.push_back(std::string(entry.name) + " " + std::to_string(entry.degrees_of_freedom));
        CHECK(entry.description.size() > 20);
        const Scene scene = find_scene(source(std::string(entry.name), "SCENE"),
                                       {parse_parameter(source("N=4", "--param"))});
        const WrittenOutScene small = unrolled(scene);
        CHECK(small.description == entry.description);
        CHECK(scene.run.method->text == "stormer-verlet");
    }
    CHECK(found == Names{"droplet 3000", "fpu-chain 1024", "lennard-jones-38 114", "phi4-chain 400",
                         "phi4-plane 4096", "plummer 3000", "ring-of-bodies 200", "sine-gordon 400",
                         "sine-gordon-plane 16384", "toda-ring 1000"});
}

TEST_CASE("a scene is found by name, or by file") {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() /
        ("hvi-scene-" +
         std::to_string(std::filesystem::file_time_type::clock::now().time_since_epoch().count()) +
         ".toml");
    std::ofstream(file) << planet;
    CHECK(embedded(file.string()).name == "planet");
    CHECK(hamiltonian_of(embedded(file.string())).origin == file.filename().string());
    std::filesystem::remove(file);
    const Refusal gone = refusal([&] { return embedded(file.string()); });
    CHECK(gone.status == 2);
    CHECK(gone.name == "SCENE");
    CHECK(gone.helps("`hvi-gen list scenes`"));
    const Refusal mistyped = refusal([] { return embedded("keplr"); });
    CHECK(mistyped.what == "there is no scene and no file `keplr`");
    CHECK(mistyped.marked == "[keplr]");
    CHECK(mistyped.helps("`kepler`"));
    CHECK(refusal([] { return embedded("."); }).says("a directory"));
    CHECK(refusal([] { return embedded(""); }).status == 2);
    CHECK(refusal([] { return embedded(std::string(5000, 'x')); }).status == 2);
}
