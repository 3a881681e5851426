// Symmetries of sums over any number of elements, against those of the same sums written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fstream>

#include <catch2/catch.hpp>

#include "generator/symmetry/families.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/read/scratch.hpp"
#include "tests/generator/symmetry/found.hpp"

using namespace hvi::gen;

namespace {

using Texts = std::vector<std::string>;

/// A scene of families with an index each.
std::string scene_of(const Texts& families, const std::string& hamiltonian,
                     const std::string& parameters, const std::string& more = "") {
    std::string coordinates, momenta, initial;
    for (const std::string& name : families) {
        const std::string separator = coordinates.empty() ? "" : ", ";
        coordinates += separator + "\"" + name + "[1..N]\"";
        momenta += separator + "\"p" + name + "[1..N]\"";
        initial += "\"" + name + "[i]\" = \"i\"\n\"p" + name + "[i]\" = \"i^2\"\n";
    }
    return "coordinates = [" + coordinates + "]\nmomenta = [" + momenta + "]\nhamiltonian = \"" +
           hamiltonian + "\"\n" + more + "[parameters]\n" + parameters + "[initial]\n" + initial;
}

SceneSymmetries of_families(const std::string& toml) {
    return symmetries_of_families(scene_from_toml({"scene.toml", toml}));
}

const char* const bodies_in_space =
    "sum(i=1..N, (px[i]^2+py[i]^2+pz[i]^2)/(2*m[i]))"
    " - sum(i=1..N-1, j=i+1..N, m[i]*m[j]/sqrt((x[i]-x[j])^2+(y[i]-y[j])^2+(z[i]-z[j])^2))";
const char* const bodies_in_plane =
    "sum(k=1..N, px[k]^2/(2*m[k])) + sum(i=1..N, py[i]^2/(2*m[i]))"
    " - sum(i=1..N-1, j=i+1..N, m[i]*m[j]/sqrt((x[i]-x[j])^2+(y[i]-y[j])^2))";

}  // namespace

TEST_CASE("Bodies of any number have the symmetries that few of them have") {
    for (const auto& [N, masses] : {std::pair{"2", "[2, 3]"}, std::pair{"3", "[1, 2, \"1/2\"]"}}) {
        const std::string parameters = std::string("N = ") + N + "\nm = " + masses + "\n";
        const std::string space = scene_of({"x", "y", "z"}, bodies_in_space, parameters);
        const SceneSymmetries whole = of_families(space), written_out = found_of_scene(space);
        CHECK(whole.affine.basis.size() == 9);
        CHECK(written_out.affine.basis.size() == 9);
        CHECK(written_out.affine.doubt == "");
        CHECK(algebra_name(whole) == "se(3)+so(3)");
        CHECK(algebra_name(written_out) == "se(3)+so(3)");
        CHECK(whole.is_regular());

        const std::string plane = scene_of({"x", "y"}, bodies_in_plane, parameters);
        CHECK(momentum_maps(of_families(plane)) ==
              Texts{"sum(k=1..N,px[k])", "sum(k=1..N,py[k])", "sum(k=1..N,x[k]*py[k]-y[k]*px[k])",
                    "sum(k=1..N,m[k]*x[k])*sum(k=1..N,py[k])"
                    "-sum(k=1..N,m[k]*y[k])*sum(k=1..N,px[k])"});
        CHECK(algebra_name(of_families(plane)) == "se(2)+R");
        CHECK(found_of_scene(plane).affine.basis.size() == 4);
        CHECK(algebra_name(found_of_scene(plane)) == "se(2)+R");
    }
}

TEST_CASE("What moves all elements alike") {
    const auto maps = [](const Texts& families, const std::string& hamiltonian,
                         const std::string& parameters = "N = 100\n") {
        return momentum_maps(of_families(scene_of(families, hamiltonian, parameters)));
    };
    // a ring, and a chain between walls
    CHECK(maps({"q"}, "sum(i=1..N, pq[i]^2/2 + exp(q[i]-q[mod(i,N)+1]))") ==
          Texts{"sum(i=1..N,pq[i])"});
    CHECK(maps({"q"}, "sum(i=1..N, pq[i]^2/2) + sum(i=1..N-1, (q[i]-q[i+1])^4) + q[1]^2").empty());
    // each in a bowl of its own, with an index in its coefficients
    CHECK(maps({"x", "y"}, "sum(i=1..N, (px[i]^2+py[i]^2)/2 + i*(x[i]^2+y[i]^2)^2)") ==
          Texts{"sum(i=1..N,x[i]*py[i]-y[i]*px[i])"});
    CHECK(maps({"x", "y"}, "sum(i=1..N, (px[i]^2+py[i]^2)/2 + x[i]^2+i*y[i]^2)").empty());
    // masses that differ from family to family: the centre is not turned
    CHECK(maps({"x", "y"}, "sum(i=1..N, px[i]^2/2+py[i]^2/4)"
                           " + sum(i=1..N-1, (x[i]-x[i+1])^4+(y[i]-y[i+1])^4)") ==
          Texts{"sum(i=1..N,px[i])", "sum(i=1..N,py[i])"});
    // momenta that stand elsewhere too
    CHECK(maps({"x", "y"}, "sum(i=1..N, (px[i]^2+py[i]^2)/2) + sum(i=1..N-1, px[i]*px[i+1])"
                           " + sum(i=1..N-1, (x[i]-x[i+1])^4+(y[i]-y[i+1])^4)") ==
          Texts{"sum(i=1..N,px[i])", "sum(i=1..N,py[i])"});
    // what stands below and above a threshold
    CHECK(maps({"q"}, "sum(i=1..N, pq[i]^2/2)"
                      " + sum(i=1..N-1, if((q[i]-q[i+1])^2 < 2, (q[i]-q[i+1])^2, 0))") ==
          Texts{"sum(i=1..N,pq[i])"});
    CHECK(maps({"q"}, "sum(i=1..N, pq[i]^2/2) + sum(i=1..N-1, if(q[i] < 2, q[i]-q[i+1], 0))")
              .empty());
}

TEST_CASE("Invariants of sums are compared with what sums up momentum maps") {
    const auto conserved = [](const std::string& invariant) {
        const std::string invariants = "[invariants]\nI = \"" + invariant + "\"\n";
        const auto found = of_families(
            scene_of({"x", "y", "z"}, bodies_in_space, "N = 2\nm = [1, 2]\n", invariants));
        return found.invariants[0].finding.conserved == Vanishing::proved;
    };
    CHECK(conserved("sum(i=1..N, px[i])"));
    CHECK(conserved("sum(k=1..N, 2*px[k] - y[k]*pz[k] + z[k]*py[k])"));
    CHECK_FALSE(conserved("sum(i=1..N, x[i]*px[i])"));
    CHECK_FALSE(conserved("sum(i=1..N, m[i]*px[i])"));
    CHECK_FALSE(conserved("sum(i=1..N-1, px[i])"));
}

TEST_CASE("What is no number, or too large for a search, has its place") {
    const auto refused = [](const std::string& term, const std::string& more = "") {
        return refusal([&] {
            return of_families(
                scene_of({"x"}, "sum(i=1..N, px[i]^2/2 + " + term + ")", "N = 80\n", more));
        });
    };
    const std::string before = "sum(i=1..N, px[i]^2/2 + ";
    const Refusal arcsine = refused("asin(2)*x[i]");
    CHECK(arcsine.marked == before + "[asin(2)]*x[i])");
    CHECK(arcsine.status == 1);
    CHECK(refused("x[i]^2+log(-1)").marked == before + "x[i]^2+[log(-1)])");
    const Refusal power = refused("x[i]^10000");
    CHECK(power.what == "this is larger than any Hamiltonian needs");
    CHECK(power.marked == "[" + before + "x[i]^10000)]");
    CHECK(power.status == 2);
    CHECK(refused("U[i]", "[definitions]\n\"U[i]\" = \"asin(2)+x[i]\"\n").marked ==
          before + "[U[i]])");
    const auto of_invariant = [&](const std::string& invariant) {
        return refused("x[i]^2", "[invariants]\nI = \"sum(i=1..N, " + invariant + ")\"\n");
    };
    CHECK(of_invariant("acos(3)+x[i]").marked == "sum(i=1..N, [acos(3)]+x[i])");
    CHECK(of_invariant("x[i]^10000").marked == "[sum(i=1..N, x[i]^10000)]");
}

TEST_CASE("A function of the user's own has no exact symmetries, however many elements there are") {
    const Scratch scratch;
    std::ofstream(scratch.path / "V.hpp") << "// V\n";
    const auto scene = [&](const char* size) {
        const std::string own = "[functions]\nV = {header = \"V.hpp\", arguments = 1}\n";
        const std::string file = scratch.path / "scene.toml";
        std::ofstream(file) << scene_of({"x"}, "sum(i=1..N, px[i]^2/2 + V(x[i]))",
                                        std::string("N = ") + size + "\n", own);
        return scene_from_file(file);
    };
    for (const Refusal& own_function :
         {refusal([&] { return symmetries_of_families(scene("3")); }),
          refusal([&] { return symmetries_of_families(scene("80")); }),
          refusal([&] { return symmetries_of(unrolled(scene("3"))); })}) {
        CHECK(own_function.what == "`V` cannot stand in what is computed exactly");
        CHECK(own_function.marked == "sum(i=1..N, px[i]^2/2 + [V(x[i])])");
        CHECK(own_function.status == 2);
    }
    // Written out there are too many equations.
    CHECK(refusal([&] { return symmetries_of(unrolled(scene("80"))); }).status == 1);
}

TEST_CASE("What keeps each sum in a product or a function, and each summand, keeps H") {
    const std::string plane =
        "sum(i=1..N, px[i]^2+py[i]^2)/2 + sqrt(1 + sum(i=1..N, x[i]^2+y[i]^2))";
    const SceneSymmetries turned = of_families(scene_of(
        {"x", "y"}, plane, "N = 100\n",
        "[invariants]\nL = \"sum(i=1..N, x[i]*py[i]-y[i]*px[i])\"\nW = \"sum(i=1..N, x[i])^2\"\n"));
    CHECK(momentum_maps(turned) == Texts{"sum(i=1..N,x[i]*py[i]-y[i]*px[i])"});
    CHECK(turned.is_regular());
    CHECK(turned.affine.doubt.find("sums in products or functions") != std::string::npos);
    REQUIRE(turned.invariants.size() == 2);
    CHECK(turned.invariants[0].finding.conserved == Vanishing::proved);
    // A function of a sum is no combination of momentum maps, though its symbol is a constant.
    CHECK(turned.invariants[1].finding.conserved != Vanishing::proved);
    // Neither a turn nor a shift keeps the one sum and the other.
    CHECK(momentum_maps(
              of_families(scene_of({"x", "y"}, plane + " + sum(i=1..N, x[i])^2", "N = 100\n")))
              .empty());
    // The momenta of a total have no mass.
    CHECK_FALSE(of_families(scene_of({"x"}, "sqrt(1 + sum(i=1..N, px[i]^2)) + sum(i=1..N, x[i]^2)",
                                     "N = 100\n"))
                    .is_regular());
    CHECK_FALSE(
        of_families(
            scene_of({"x"}, "sum(i=1..N, px[i]^2)/2 + sqrt(1 + sum(i=1..N, px[i]^2))", "N = 100\n"))
            .is_regular());
}
