// Quantities that the flows of parts of H keep. Brackets with parts were computed by SymPy, those
// of bodies as R' = R hat(G_L), L' = L x G_L - D(G).
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/lower/parts.hpp"
#include "generator/lower/system.hpp"
#include "generator/symmetry/statements.hpp"
#include "generator/symmetry/written_out.hpp"
#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

namespace {

HamiltonianParts parts_of_scene(const WrittenOutScene& scene) {
    return with_parts(system_of(scene), scene).parts.value();
}

/// Returns a letter for each part: `k` for one that keeps the quantity, `-` for one that does not,
/// `?` where this is not known.
std::string letters(const BracketsWithParts& brackets) {
    std::string text;
    for (const Vanishing each : brackets)
        text += each == Vanishing::proved ? 'k' : each == Vanishing::refuted ? '-' : '?';
    return text;
}

using Letters = std::map<std::string, std::string>;

/// Returns the letters of the scene's invariants and of the energy.
Letters kept_in(const WrittenOutScene& scene, const HamiltonianParts& parts) {
    const SceneSymmetries found = symmetries_of(scene);
    const KeptByParts kept = kept_by_parts(parts, scene, found);
    const auto all = quantities_of(found);
    REQUIRE(kept.brackets.size() == all.size() + 1);
    Letters result{{"energy", letters(kept.brackets.back())}};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i]->kind == ConservedQuantity::Kind::invariant)
            result[all[i]->name] = letters(kept.brackets[i]);
    return result;
}

Letters kept_in(const std::string& toml) {
    const WrittenOutScene scene = read(toml);
    return kept_in(scene, parts_of_scene(scene));
}

/// Returns a body whose H is a sum of these parts.
std::string turning(const std::vector<std::string>& parts, const std::string& invariants) {
    std::string sum, split;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        sum += (k == 0 ? "" : " + ") + parts[k];
        split += std::string(1, static_cast<char>('A' + k)) + " = \"" + parts[k] + "\"\n";
    }
    return "rotations = [\"R\"]\nangular_momenta = [\"L\"]\nhamiltonian = \"" + sum +
           "\"\n[split]\n" + split + "[invariants]\n" + invariants +
           "[initial]\nR = \"identity\"\nL = [1, 2, 3]\n";
}

std::string plane(const std::string& hamiltonian, const std::string& split,
                  const std::string& invariants) {
    return "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nhamiltonian = \"" +
           hamiltonian + "\"\n[parameters]\nb = 1\n[split]\n" + split + "[invariants]\n" +
           invariants + "[initial]\nx = 1\ny = 0\npx = 0\npy = 1\n";
}

std::string row_of_space(int i) {
    const std::string R = "R[" + std::to_string(i);
    return R + ",1]*L[1] + " + R + ",2]*L[2] + " + R + ",3]*L[3]";
}

const std::string invariants_of_body = "across = \"" + row_of_space(1) + "\"\nupwards = \"" +
                                       row_of_space(3) +
                                       "\"\nsquare = \"L[1]^2 + L[2]^2 + L[3]^2\"\n"
                                       "first = \"L[1]\"\n";
const std::string central = "(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)";

/// Returns what is said of a quantity by a splitting.
Statement said_of(const std::string& name, const std::string& toml) {
    const WrittenOutScene scene = read(toml);
    const SceneSymmetries found = symmetries_of(scene);
    KeepingFacts facts = keeping_facts(derive_any(named_method(source("strang", "--method"))));
    facts.parts = kept_by_parts(parts_of_scene(scene), scene, found);
    const std::vector<Statement> all = statements(found, facts);
    const auto place =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    REQUIRE(place != all.end());
    return *place;
}

}  // namespace

TEST_CASE("turns of a body keep its angular momentum in space, and none keeps the energy") {
    CHECK(kept_in(turning({"L[1]^2/2", "L[2]^2/4", "L[3]^2/6"}, invariants_of_body)) ==
          Letters{{"across", "kkk"},
                  {"upwards", "kkk"},
                  {"square", "kkk"},
                  {"first", "k--"},
                  {"energy", "---"}});
    CHECK(kept_in(turning({"L[1]^2/2", "L[2]^2/4", "L[3]^2/6", "R[3,3] + 3*R[3,1]/10"},
                          invariants_of_body)) == Letters{{"across", "kkk-"},
                                                          {"upwards", "kkkk"},
                                                          {"square", "kkk-"},
                                                          {"first", "k---"},
                                                          {"energy", "----"}});
}

TEST_CASE("nothing is claimed of what jumps, whose derivatives vanish") {
    CHECK(kept_in(turning({"L[1]^2/2", "L[2]^2/4", "L[3]^2/6"}, "side = \"sign(L[1])\"\n")) ==
          Letters{{"side", "???"}, {"energy", "---"}});
    CHECK(kept_in(plane(central, "A = \"(px^2 + py^2)/2\"\nB = \"-1/sqrt(x^2 + y^2)\"\n",
                        "side = \"sign(x*py - y*px)\"\n")) ==
          Letters{{"side", "??"}, {"energy", "--"}});
}

TEST_CASE("what the sum of parts keeps, and no part of them, is not claimed") {
    const std::string top =
        turning({"L[1]^2/2", "L[2]^2/2", "L[3]^2", "R[3,3]"}, "own = \"L[3]\"\n");
    CHECK(kept_in(top) == Letters{{"own", "--kk"}, {"energy", "--k-"}});
    const Statement own = said_of("own", top);
    CHECK(own.keeping == Keeping::not_in_general);
    CHECK(own.reason == "its bracket is not zero with A, B");
    CHECK(kept_in(plane(central, "A = \"px^2/2\"\nB = \"py^2/2\"\nC = \"-1/sqrt(x^2 + y^2)\"\n",
                        "turn = \"x*py - y*px\"\n")) ==
          Letters{{"turn", "--k"}, {"energy", "---"}});
}

TEST_CASE("any function of a quantity that all parts keep is kept, and need not be quadratic") {
    const std::string text =
        plane(central, "A = \"(px^2 + py^2)/2\"\nB = \"-1/sqrt(x^2 + y^2)\"\n",
              "turn = \"x*py - y*px\"\nfourth = \"(x*py - y*px)^4\"\nwave = \"sin(x*py - "
              "y*px)\"\nlenz = \"px*(x*py - y*px) + y/sqrt(x^2 + y^2)\"\n");
    CHECK(kept_in(text) ==
          Letters{
              {"turn", "kk"}, {"fourth", "kk"}, {"wave", "kk"}, {"lenz", "--"}, {"energy", "--"}});
    CHECK(said_of("wave", text).keeping == Keeping::kept);
    CHECK(said_of("lenz", text).keeping == Keeping::not_in_general);
    CHECK(said_of("energy", text).keeping == Keeping::not_in_general);
}

TEST_CASE("parts that commute keep the energy") {
    const std::string text =
        plane("(x^2 + px^2)^2/4 + (y^2 + py^2)/2",
              "A = \"(x^2 + px^2)^2/4\"\nB = \"(y^2 + py^2)/2\"\n", "x_form = \"x^2 + px^2\"\n");
    CHECK(kept_in(text) == Letters{{"x_form", "kk"}, {"energy", "kk"}});
    CHECK(said_of("energy", text).keeping == Keeping::kept);
}

TEST_CASE("parameters have their values in a scene, and any values in a header") {
    const WrittenOutScene scene = read(plane("(px^2 + py^2)/2 + (x^2 + b*y^2)/2",
                                             "A = \"(px^2 + py^2)/2\"\nB = \"(x^2 + b*y^2)/2\"\n",
                                             "turn = \"x*py - y*px\"\n"));
    const HamiltonianParts parts = parts_of_scene(scene);
    CHECK(kept_in(scene, parts) == Letters{{"turn", "kk"}, {"energy", "--"}});
    Hamiltonian H = hamiltonian_of(scene);
    H.parameters.clear();
    const NamedExpression& turn = scene.invariants.front();
    const KeptByParts kept = kept_by_parts(parts, H, {{turn.expression, turn.place.source}});
    CHECK(letters(kept.brackets.front()) == "k-");
}

TEST_CASE("nothing is claimed of a part that is too long to be written") {
    const WrittenOutScene scene =
        read(plane(central, "A = \"(px^2 + py^2)/2\"\nB = \"-1/sqrt(x^2 + y^2)\"\n",
                   "turn = \"x*py - y*px\"\n"));
    HamiltonianParts parts = parts_of_scene(scene);
    parts.parts[1].expression = Expression::symbol(too_long_part);
    const NamedExpression& turn = scene.invariants.front();
    const KeptByParts alone =
        kept_by_parts(parts, hamiltonian_of(scene), {{turn.expression, turn.place.source}});
    CHECK(letters(alone.brackets.front()) == "k?");
    // H conserves it, and so does the part that is left.
    CHECK(kept_in(scene, parts) == Letters{{"turn", "kk"}, {"energy", "-?"}});
    parts.parts[0].expression = Expression::symbol(too_long_part);
    CHECK(kept_in(scene, parts) == Letters{{"turn", "??"}, {"energy", "??"}});
}

TEST_CASE("a ring of sites keeps its norm in the flows of sites alone") {
    CHECK(kept_in("coordinates = [\"q[1..4]\"]\nmomenta = [\"p[1..4]\"]\nhamiltonian = "
                  "\"sum(i=1..4, (q[i]^2 + p[i]^2)^2/4 - q[i]*q[mod(i,4)+1] - "
                  "p[i]*p[mod(i,4)+1])\"\n[split]\nA = \"sum(i=1..4, (q[i]^2 + "
                  "p[i]^2)^2/4)\"\nB = \"-sum(i=1..4, q[i]*q[mod(i,4)+1])\"\nC = "
                  "\"-sum(i=1..4, p[i]*p[mod(i,4)+1])\"\n[invariants]\nnorm = \"sum(i=1..4, "
                  "q[i]^2 + p[i]^2)\"\n[initial]\nq = [1, 0, 0, 0]\np = [0, 0, 0, 0]\n") ==
          Letters{{"norm", "k--"}, {"energy", "---"}});
}
