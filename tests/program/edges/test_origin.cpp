// The motion at q = p = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "generator/edges/origin.hpp"

using namespace hvi::gen;

namespace {

Scene embedded_scene(const std::string& name) { return find_scene(given("SCENE", name)); }

Scene of_one_spring(const std::string& hamiltonian) {
    return scene_from_toml(
        {"scene.toml", "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                       "parameters = {a = 2}\ninitial = {q = 1, p = 0}\nhamiltonian = \"" +
                           hamiltonian + "\"\n"});
}

}  // namespace

TEST_CASE("the origin of the scenes that come with the program") {
    for (const std::string name : {"double-pendulum", "fpu", "harmonic-oscillator", "henon-heiles",
                                   "nonseparable", "pendulum", "qp"}) {
        INFO(name);
        CHECK(origin_of(embedded_scene(name)) == Origin::rest);
    }
    for (const std::string name : {"kepler", "outer-solar-system", "point-vortices"}) {
        INFO(name);
        CHECK(origin_of(embedded_scene(name)) == Origin::singular);
    }
}

TEST_CASE("the origin of other scenes") {
    CHECK(origin_of(of_one_spring("p^2/2 + q")) == Origin::other);
    CHECK(origin_of(of_one_spring("p^2/2 + q*sin(t)")) == Origin::rest);  // at t = 0
    CHECK(origin_of(of_one_spring("p^2/2 + q*cos(t)")) == Origin::other);
    CHECK(origin_of(of_one_spring("p^2/2 + sqrt(q^2 + a)")) == Origin::rest);
    CHECK(origin_of(of_one_spring("p^2/2 + sqrt(q^2 + a - 2)")) == Origin::singular);
    CHECK(origin_of(of_one_spring("p^2/2 + log(q + a)")) == Origin::other);
    CHECK(origin_of(of_one_spring("p^2/2 + log(q + a) - q/a")) == Origin::rest);
}
