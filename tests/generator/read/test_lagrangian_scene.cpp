// Scenes with a Lagrangian: what is read, and what is refused where.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

namespace {

const std::string charge = R"toml(coordinates = ["x", "y"]
velocities = "vx, vy"
lagrangian = "m*(vx^2 + vy^2)/2 + B*(x*vy - y*vx)/2"
[parameters]
m = 1
B = "1/2"
[invariants]
energy = "m*(vx^2 + vy^2)/2"
[initial]
x = 0
y = "-B"
vx = "2*m"
vy = 0
)toml";

WrittenOutScene any(const std::string& text) { return unrolled(scene_from_toml({"s.toml", text})); }

Lagrangian& lagrangian_of(WrittenOutScene& scene) { return std::get<Lagrangian>(scene.mechanics); }

Refusal any_refused(const std::string& part, const std::string& other) {
    return refusal([&] { return any(edited(charge, part, other)); });
}

}  // namespace

TEST_CASE("a scene with a Lagrangian has velocities, and their initial values") {
    WrittenOutScene scene = any(charge);
    const Lagrangian& L = lagrangian_of(scene);
    CHECK(scene.name == "s");
    CHECK(L.coordinates == Names{"x", "y"});
    CHECK(L.velocities == Names{"vx", "vy"});
    CHECK(to_text(L.expression) == "m*(vx^2+vy^2)/2+B*(x*vy-y*vx)/2");
    CHECK(L.origin == "s.toml");
    CHECK(L.parameters.empty());
    CHECK(parameter_names(L) == Names{"B", "m"});
    CHECK_FALSE(depends_on_time(L));
    CHECK(names(scene.parameters) == Names{"m", "B"});
    CHECK(lines(scene.initial) == Names{"x = 0", "y = -B", "vx = 2*m", "vy = 0"});
    CHECK(lines(scene.invariants) == Names{"energy = m*(vx^2+vy^2)/2"});
    CHECK(std::holds_alternative<Hamiltonian>(any(planet).mechanics));
    WrittenOutScene indexed = any("coordinates = \"x[1..2]\"\nvelocities = \"v[1..2]\"\n"
                                  "lagrangian = \"sum(i=1..2, v[i]^2/2) - t*x[1]\"\n"
                                  "[initial]\nx = [1, 2]\nv = [0, 3]\n");
    CHECK(lines(indexed.initial) == Names{"x[1] = 1", "x[2] = 2", "v[1] = 0", "v[2] = 3"});
    CHECK(depends_on_time(lagrangian_of(indexed)));
}

TEST_CASE("the values of parameters of a Lagrangian") {
    Scene scene = scene_from_toml({"s.toml", charge});
    scene.fixed = {"m"};
    Method method = named_method(source("gauss:2", "--method"));
    set_parameter(method, scene, parse_parameter(source("m=3", "--param")));
    WrittenOutScene charged = unrolled(scene);
    CHECK(to_text(lagrangian_of(charged).parameters.at(0).value) == "3");
    CHECK(to_text(charged.parameters.at(0).value) == "3");
    const Refusal variable = refusal([&] {
        set_parameter(method, scene, parse_parameter(source("vx=3", "--param")));
        return 0;
    });
    CHECK(variable.says("`vx` is a variable of the Lagrangian, and no parameter"));
    CHECK(variable.status == 2);
}

TEST_CASE("one of hamiltonian and lagrangian, with the variables that belong to it") {
    const Refusal both = any_refused("[parameters]", "hamiltonian = \"x\"\n[parameters]");
    CHECK(both.what == "`hamiltonian` stands beside `lagrangian`");
    CHECK(both.name == "s.toml:4");
    CHECK(both.marked == "[hamiltonian] = \"x\"");
    CHECK(both.status == 2);
    const Refusal momenta = any_refused("[parameters]", "momenta = \"px, py\"\n[parameters]");
    CHECK(momenta.what == "`momenta` stands beside `lagrangian`");
    CHECK(momenta.marked == "[momenta] = \"px, py\"");
    const Refusal without = any_refused("lagrangian = ", "hamiltonian = ");
    CHECK(without.what == "`velocities` stands without `lagrangian`");
    CHECK(without.marked == "[velocities] = \"vx, vy\"");
    CHECK(without.status == 2);
    CHECK(any_refused("velocities = \"vx, vy\"\n", "").what == "the scene has no `velocities`");
    CHECK(any_refused("lagrangian", "lagrangean").helps("did you mean `lagrangian`?"));
}

TEST_CASE("words of a Lagrangian stand where they may") {
    const Refusal one = any_refused("\"vx, vy\"", "\"vx\"");
    CHECK(one.what == "2 coordinates and 1 velocity");
    CHECK(one.help == "each coordinate has a velocity of its own");
    const Refusal unknown = any_refused("B*(x", "C*(x");
    CHECK(unknown.what == "`C` is neither a variable nor a parameter with a value");
    CHECK(unknown.marked == "m*(vx^2 + vy^2)/2 + [C]*(x*vy - y*vx)/2");
    CHECK(any_refused("B*(x", "roots(x)*(x").says("`roots` cannot stand in the Lagrangian"));
    CHECK(any_refused("vx = \"2*m\"", "vx = \"2*vy\"")
              .says("an initial value cannot depend on the variable `vy`"));
    CHECK(any_refused("vx = \"2*m\"\n", "").what == "an initial value is missing: that of `vx`");
    CHECK(any_refused("vx = \"2*m\"\n", "px = 1\n").says("`px` is no variable"));
}

TEST_CASE("where a Hamiltonian is wanted, a Lagrangian is refused by mathematics") {
    const WrittenOutScene scene = any(charge);
    const Refusal refused = refusal([&] { return hamiltonian_of(scene); });
    CHECK(refused.status == 1);
    CHECK(refused.says("here a Hamiltonian is wanted, and the scene has a Lagrangian"));
    CHECK(refused.name == "s.toml:3");
    CHECK(refused.helps("`hvi-gen scheme` prints its Hamiltonian"));
}
