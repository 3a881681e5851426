// Symmetries of rotating bodies, and what is known of their invariants.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/symmetry/statements.hpp"
#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

namespace {

WrittenOutScene body(const std::string& hamiltonian, const std::string& more = "") {
    return read("rotations = [\"R\"]\nangular_momenta = [\"L\"]\nhamiltonian = \"" + hamiltonian +
                "\"\n" + more + "[initial]\nR = \"identity\"\nL = [1, 2, 3]\n");
}

std::set<std::string> maps(const SceneSymmetries& found) {
    std::set<std::string> texts;
    for (const AffineSymmetry& symmetry : found.affine.basis)
        texts.insert(to_text(symmetry.momentum_map));
    return texts;
}

std::string row(int i) {
    const std::string R = "R[" + std::to_string(i);
    return R + ",1]*L[1]+" + R + ",2]*L[2]+" + R + ",3]*L[3]";
}

}  // namespace

TEST_CASE("a free body: rotations of space, and of a body with equal moments its own") {
    const SceneSymmetries general = symmetries_of(body("L[1]^2/2+L[2]^2/4+L[3]^2/6"));
    CHECK(maps(general) == std::set{row(1), row(2), row(3)});
    CHECK(general.affine.doubt.empty());
    REQUIRE(general.affine.algebra);
    CHECK(general.affine.algebra->name == "so(3)");
    CHECK(general.rank == 3);
    CHECK(general.degrees_of_freedom == 3);
    const SceneSymmetries symmetric = symmetries_of(body("(L[1]^2+L[2]^2)/4+L[3]^2/6"));
    CHECK(maps(symmetric) == std::set<std::string>{row(1), row(2), row(3), "L[3]"});
    CHECK(symmetric.affine.doubt.empty());
    const SceneSymmetries sphere = symmetries_of(body("(L[1]^2+L[2]^2+L[3]^2)/2"));
    CHECK(maps(sphere) == std::set<std::string>{row(1), row(2), row(3), "L[1]", "L[2]", "L[3]"});
    REQUIRE(sphere.affine.algebra);
    CHECK(sphere.affine.algebra->name == "so(4)");
    // {L_1, L_2} = -L_3, {J_1, J_2} = J_3; those of the body are the first three.
    std::size_t brackets = 0;
    for (const StructureConstant& constant :
         sphere.affine.algebra->constants.value_or(std::vector<StructureConstant>{})) {
        ++brackets;
        CHECK((constant.i < 3) == (constant.j < 3));
        const bool is_cyclic = constant.k % 3 != 1;
        CHECK(to_text(constant.value) == ((constant.i < 3) == is_cyclic ? "-1" : "1"));
    }
    CHECK(brackets == 6);
}

TEST_CASE("a top: the vertical, and the axis of a symmetric one") {
    const std::string kinetic = "L[1]^2/2+L[2]^2/4+L[3]^2/6";
    CHECK(maps(symmetries_of(body(kinetic + "+R[3,1]/3+R[3,2]/5+R[3,3]"))) == std::set{row(3)});
    CHECK(maps(symmetries_of(body(kinetic + "+exp(R[2,3])"))) == std::set{row(2)});
    CHECK(maps(symmetries_of(body("(L[1]^2+L[2]^2)/2+L[3]^2+cos(R[3,3])"))) ==
          std::set<std::string>{row(3), "L[3]"});
    const SceneSymmetries none = symmetries_of(body(kinetic + "+R[3,1]+R[2,2]"));
    CHECK(none.affine.basis.empty());
    CHECK(none.affine.doubt.empty());
    // The axis of the body is not the one of its moments.
    CHECK(maps(symmetries_of(body("L[1]^2/2+(L[2]^2+L[3]^2)/4+R[3,3]"))) == std::set{row(3)});
}

TEST_CASE("an orbit and a rotation are turned together") {
    const WrittenOutScene scene = read(R"toml(coordinates = ["x", "y"]
momenta = ["px", "py"]
rotations = ["R"]
angular_momenta = ["L"]
hamiltonian = "(px^2+py^2)/2+L[1]^2/2+L[2]^2/4+L[3]^2/6+(x*R[1,1]+y*R[2,1])^2-1/sqrt(x^2+y^2)"
[initial]
x = 1
y = 0
px = 0
py = 1
R = "identity"
L = [1, 2, 3]
)toml");
    const SceneSymmetries found = symmetries_of(scene);
    CHECK(maps(found) == std::set<std::string>{"x*py-y*px+" + row(3)});
    CHECK(found.affine.doubt.empty());
    CHECK(to_text(found.affine.basis[0].generator[0]) == "-y");
    CHECK(to_text(found.affine.basis[0].generator[2]) == "-R[2,1]");
}

TEST_CASE("what holds for rotations alone is not claimed to be all") {
    // The first column has the length 1: this is a free sphere.
    const SceneSymmetries found =
        symmetries_of(body("(L[1]^2+L[2]^2+L[3]^2)/2+R[1,1]^2+R[2,1]^2+R[3,1]^2"));
    CHECK(found.affine.basis.size() < 6);
    CHECK(!found.affine.doubt.empty());
}

TEST_CASE("invariants of bodies, with proof") {
    const SceneSymmetries found =
        symmetries_of(body("L[1]^2/2+L[2]^2/4+L[3]^2/6+R[3,3]",
                           "[invariants]\nvertical = \"2*(" + row(3) +
                               ")+1\"\nlength = \"R[1,1]^2+R[2,1]^2+R[3,1]^2\"\nsquare = "
                               "\"L[1]^2+L[2]^2+L[3]^2\"\nenergy_again = "
                               "\"L[1]^2/2+L[2]^2/4+L[3]^2/6+R[3,3]\"\n"));
    const auto conserved = [&](std::size_t i) { return found.invariants[i].finding.conserved; };
    CHECK(conserved(0) == Vanishing::proved);
    CHECK(found.invariants[0].finding.is_momentum_map);
    CHECK(conserved(1) == Vanishing::proved);  // for rotations it is 1
    CHECK_FALSE(found.invariants[1].finding.is_momentum_map);
    CHECK(conserved(2) == Vanishing::refuted);
    CHECK(to_text(found.invariants[2].finding.bracket).find("R[3,") != std::string::npos);
    CHECK(conserved(3) == Vanishing::proved);

    const Method method = named_method(source("chebyshev:3", "--method"));
    const auto said = statements(found, keeping_facts(derive_any(method)));
    REQUIRE(said.size() == 6);
    CHECK(said[0].keeping == Keeping::kept);
    CHECK(said[1].keeping == Keeping::kept);
    CHECK(said[2].keeping == Keeping::not_in_general);
    CHECK(said[3].keeping == Keeping::not_conserved);
    CHECK(said[5].name == "energy");
    CHECK(said[5].keeping == Keeping::not_in_general);
}
