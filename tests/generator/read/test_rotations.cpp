// Scenes with rotations: names, values, and what is refused.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

namespace {

const std::string body = R"(rotations       = ["R"]
angular_momenta = ["L"]
hamiltonian     = "L[1]^2/2 + L[2]^2/4 + L[3]^2/6 + g*R[3,3]"

[parameters]
g = 2

[initial]
R = "identity"
L = [1, 0, "1/2"]
)";

Refusal refused(const std::string& from, const std::string& to) {
    return hvi::gen::refused(body, from, to);
}

std::string value(const WrittenOutScene& scene, const std::string& name) {
    for (const NamedExpression& initial : scene.initial)
        if (initial.name == name) return to_text(initial.expression);
    return "none";
}

}  // namespace

TEST_CASE("the entries of a rotation and of its angular momentum are variables") {
    const WrittenOutScene scene = read(body);
    const Hamiltonian& H = hamiltonian_of(scene);
    CHECK(H.coordinates.size() == 9);
    CHECK(H.coordinates.front() == "R[1,1]");
    CHECK(H.coordinates[5] == "R[2,3]");
    CHECK(H.momenta == std::vector<std::string>{"L[1]", "L[2]", "L[3]"});
    CHECK(H.degrees_of_freedom() == 3);
    REQUIRE(H.rotations.size() == 1);
    CHECK(H.rotations[0].rotation == "R");
    CHECK(H.rotations[0].momentum == "L");
    CHECK(value(scene, "R[2,2]") == "1");
    CHECK(value(scene, "R[2,3]") == "0");
    CHECK(value(scene, "L[3]") == "1/2");
}

TEST_CASE("several rotations, beside coordinates") {
    const WrittenOutScene scene = read(R"(coordinates = "x"
momenta = "p"
rotations = ["A[1..2]", "B"]
angular_momenta = ["M[1..2], N"]
hamiltonian = "p^2/2 + sum(k=1..2, sum(i=1..3, M[k,i]^2)/2) + sum(i=1..3, N[i]^2)/2 + x*A[2,1,3]"
[initial]
x = 1
p = 0
"A[1]" = {quaternion = [1, 0, 0, 0]}
"A[2]" = {axis = [0, 0, 1], angle = "pi/2"}
B = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
M = [[1, 2, 3], [4, 5, 6]]
"N[i]" = "i/2"
)");
    const Hamiltonian& H = hamiltonian_of(scene);
    CHECK(H.coordinates.size() == 28);
    CHECK(H.coordinates[1] == "A[1,1,1]");
    CHECK(H.coordinates[18] == "A[2,3,3]");
    CHECK(H.coordinates[19] == "B[1,1]");
    CHECK(H.momenta[1] == "M[1,1]");
    CHECK(H.momenta[7] == "N[1]");
    CHECK(H.degrees_of_freedom() == 10);
    CHECK(H.rotations[1].rotation == "A[2]");
    CHECK(H.rotations[2].momentum == "N");
    CHECK(value(scene, "M[2,1]") == "4");
    CHECK(value(scene, "N[3]") == "3/2");
    CHECK(value(scene, "B[3,3]") == "1");
}

TEST_CASE("angular momenta of several bodies may be given one by one, as rotations are") {
    const std::string two = R"toml(rotations = "R[1..2]"
angular_momenta = "L[1..2]"
hamiltonian = "sum(k=1..2, L[k,1]^2/2 + L[k,2]^2/4 + L[k,3]^2/6)"
[initial]
"R[1]" = "identity"
"R[2]" = "identity"
"L[2]" = [4, 5, "11/2"]
"L[1]" = [1, 2, 3]
)toml";
    CHECK(value(read(two), "L[1,3]") == "3");
    CHECK(value(read(two), "L[2,3]") == "11/2");
    const auto check = [&](const std::string& other, const std::string& what) {
        CHECK(hvi::gen::refused(two, "\"L[1]\" = [1, 2, 3]", other).what == what);
    };
    check("\"L[1]\" = [1, 2]", "`L[1]` has three components");
    check("\"L[1]\" = 1", "`L[1]` has three components");
    check("L = [[1, 2, 3], [4, 5, 6]]", "`L` is given values twice");
    check("\"L[3]\" = [1, 2, 3]", "`L[3]` is no variable");
    check("", "an initial value is missing: that of `L[1,1]`");
}

TEST_CASE("rotations of several bodies may be given by a rule") {
    const std::string two = R"toml(rotations = "R[1..2]"
angular_momenta = "L[1..2]"
hamiltonian = "sum(k=1..2, L[k,1]^2/2 + L[k,2]^2/4 + L[k,3]^2/6)"
[parameters]
a = [3, 4]
[initial]
"R[k]" = {axis = [0, 0, 1], angle = "k*a[k]"}
"L[k,i]" = "k"
)toml";
    CHECK(value(read(two), "R[1,2,1]").find("a[1]") != std::string::npos);
    CHECK(value(read(two), "R[2,2,1]").find("2*a[2]") != std::string::npos);
    const auto check = [&](const std::string& name, const std::string& what) {
        CHECK(hvi::gen::refused(two, "\"R[k]\" =", name + " =").what == what);
    };
    check("\"R[k,j]\"", "`R` has 1 index, and here it has 2");
    check("\"R[2]\"", "`k` is neither a variable nor a parameter with a value");
}

TEST_CASE("an angle may depend on parameters, and on the time where it is that of a solution") {
    const std::string text = edited(body, "\"identity\"", "{axis = [0, 0, 1], angle = \"g/2\"}");
    CHECK(value(read(text), "R[2,1]").find("sin(g/2)") != std::string::npos);
    const WrittenOutScene scene = read(text + "[exact]\nR = {axis = [0, 0, 1], angle = \"g/2+t\"}\n"
                                              "L = [0, 0, 1]\n");
    CHECK(scene.exact.size() == 12);
}

TEST_CASE("what makes no rotation is refused where it stands") {
    CHECK(refused("\"identity\"", "\"unity\"").marked == "R = [\"unity\"]");
    CHECK(refused("\"identity\"", "1").marked == "R = [1]");
    CHECK(refused("\"identity\"", "{axis = [0, 0, 1]}").says("angle is missing"));
    CHECK(refused("\"identity\"", "{angle = 1}").says("`axis` is a list of 3"));
    CHECK(refused("\"identity\"", "{axis = [0, 1], angle = 1}").marked ==
          "R = {axis = [[0, 1]], angle = 1}");
    CHECK(refused("\"identity\"", "{quaternion = [1, 0, 0]}").says("list of 4"));
    CHECK(refused("\"identity\"", "{quaternion = [1, 0, 0, 0], angle = 1}")
              .says("an axis and an angle, or a quaternion"));
    CHECK(refused("\"identity\"", "{quaternion = [0, 0, 0, 0]}").says("zeros are no quaternion"));
    CHECK(refused("\"identity\"", "{axis = [0, 0, 0], angle = 1}").says("zeros are no axis"));
    CHECK(refused("\"identity\"", "{axes = [1, 0, 0], angle = 1}").says("has no key `axes`"));
    CHECK(refused("\"identity\"", "[1, 0, 0, 1]").says("9 indices"));
    const Refusal unknown = refused("\"identity\"", "{axis = [0, 0, 1], angle = \"f/2\"}");
    CHECK(unknown.marked == "R = [{axis = [0, 0, 1], angle = \"f/2\"}]");
    CHECK(refused("\"identity\"", "{axis = [0, 0, \"1+\"], angle = 1}").marked == "1+[]");
    CHECK(refused("R = \"identity\"\n", "").says("that of `R[1,1]`"));
    CHECK(refused("R = \"identity\"", "R = \"identity\"\n\"R[1]\" = \"identity\"").status == 2);
}

TEST_CASE("rotations and angular momenta come in pairs") {
    CHECK(refused("angular_momenta = [\"L\"]\n", "").says("no `angular_momenta`"));
    CHECK(refused("rotations       = [\"R\"]\n", "").says("stands without"));
    CHECK(refused("[\"L\"]", "[\"L[1..2]\"]").says("1 rotation and 2 angular momenta"));
    CHECK(refused("[\"L\"]", "[\"R\"]").status == 2);
    CHECK(refused("hamiltonian ", "coordinates = \"x\"\nhamiltonian ").says("no `momenta`"));
    const Refusal lagrangian = refusal([] {
        return read("coordinates = \"x\"\nvelocities = \"v\"\nlagrangian = \"v^2/2\"\n"
                    "rotations = \"R\"\nangular_momenta = \"L\"\n[initial]\nx = 0\nv = 0\n");
    });
    CHECK(lagrangian.says("stands beside"));
    CHECK(refused("R[3,3]", "R[3,4]").status == 2);
    CHECK(refused("R[3,3]", "R[3]").status == 2);
    CHECK(refused("[\"R\"]", "[\"R[1..30]\"]").status == 2);
}

TEST_CASE("invariants may be vectors") {
    const WrittenOutScene scene =
        read(body + "[invariants]\nJ = [\"L[1]\", \"L[2]\"]\nK = \"L[3]\"\n");
    REQUIRE(scene.invariants.size() == 3);
    CHECK(scene.invariants[0].name == "J_1");
    CHECK(scene.invariants[1].name == "J_2");
    CHECK(to_text(scene.invariants[1].expression) == "L[2]");
    CHECK(scene.invariants[2].name == "K");
    CHECK(refusal([] {
              return read(body + "[invariants]\nJ = [\"L[1]\"]\nJ_1 = \"L[2]\"\n");
          }).status == 2);
}

TEST_CASE("scenes of bodies come with the program") {
    const std::map<std::string, std::size_t> degrees{
        {"coupled-rotors", 12}, {"free-rigid-body", 3},   {"heavy-top", 3},   {"lagrange-top", 3},
        {"spacecraft", 6},      {"two-rigid-bodies", 12}, {"water-dimer", 12}};
    std::size_t count = 0;
    for (const SceneEntry& entry : scenes()) {
        const auto found = degrees.find(std::string(entry.name));
        if (found == degrees.end()) continue;
        ++count;
        CHECK(entry.degrees_of_freedom == found->second);
    }
    CHECK(count == degrees.size());
}
