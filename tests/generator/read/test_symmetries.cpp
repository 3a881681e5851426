// The section [symmetries], and invariants that are nearly conserved.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/scene.hpp"
#include "generator/read/written_out_scene.hpp"

using namespace hvi::gen;

namespace {

const char* const scene_of_three = R"(
coordinates = ["x[1..2]", "y"]
momenta     = ["px[1..2]", "py"]
hamiltonian = "(px[1]^2 + px[2]^2 + py^2)/2"
[invariants]
total  = {value = "px[1] + px[2]", approximate = false}
nearly = {value = "py^2/2", approximate = true}
plain  = "py"
[symmetries]
shift = {x = [1, "1/2"]}
turn  = {y = "-x[1]", "x[i]" = "i*y^2"}
[initial]
x  = [1, 2]
y  = 0
px = [0, 1]
py = 0
)";

/// `x[1] 1, x[2] 1/2`.
std::string text_of(const VectorField& field) {
    std::string text;
    for (const NamedExpression& component : field.components)
        text += (text.empty() ? "" : ", ") + component.name + " " + to_text(component.expression);
    return text;
}

}  // namespace

TEST_CASE("Vector fields have lists and rules for components, in the order of the coordinates") {
    const WrittenOutScene scene = unrolled(scene_from_toml({"scene.toml", scene_of_three}));
    REQUIRE(scene.fields.size() == 2);
    CHECK(scene.fields[0].name == "shift");
    CHECK(text_of(scene.fields[0]) == "x[1] 1, x[2] 1/2");
    CHECK(scene.fields[1].name == "turn");
    CHECK(text_of(scene.fields[1]) == "x[1] y^2, x[2] 2*y^2, y -x[1]");
}

TEST_CASE("Invariants may be approximate") {
    const WrittenOutScene scene = unrolled(scene_from_toml({"scene.toml", scene_of_three}));
    CHECK(scene.approximate == std::set<std::string>{"nearly"});
    REQUIRE(scene.invariants.size() == 3);
    CHECK(to_text(scene.invariants[0].expression) == "px[1]+px[2]");
    const Scene written = scene_from_toml({"scene.toml", scene_of_three});
    CHECK(written.approximate == std::set<std::string>{"nearly"});
    CHECK(written.fields.size() == 2);
}
