// Kepler orbits in H: which are found, which are not, and coordinates of Jacobi and Poincare.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/lower/orbit_coordinates.hpp"
#include "generator/lower/parts.hpp"
#include "generator/lower/system.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

/// A scene of bodies in a plane, with masses a, b, c; `split` is the text behind its parameters.
std::string plane_bodies(const std::string& hamiltonian, const std::string& split = "") {
    return "hamiltonian = \"" + hamiltonian +
           "\"\ncoordinates = [\"x[1..3]\", \"y[1..3]\"]\nmomenta = [\"u[1..3]\", \"v[1..3]\"]\n"
           "[parameters]\na = 2\nb = 3\nc = 5\nG = 7\n" +
           split + "[initial]\nx = [0, 1, 3]\ny = [0, 0, 1]\nu = [0, 0, 1]\nv = [0, 1, 0]\n";
}

std::string distance_of(const std::string& i, const std::string& j) {
    return "sqrt((x[" + i + "]-x[" + j + "])^2 + (y[" + i + "]-y[" + j + "])^2)";
}

const std::string kinetic_energy =
    "(u[1]^2+v[1]^2)/(2*a) + (u[2]^2+v[2]^2)/(2*b) + (u[3]^2+v[3]^2)/(2*c)";
const std::string three_bodies = kinetic_energy + " - G*a*b/" + distance_of("1", "2") +
                                 " - G*a*c/" + distance_of("1", "3") + " - G*b*c/" +
                                 distance_of("2", "3");

WrittenOutScene written_scene(const std::string& text) {
    return unrolled(scene_from_toml(*source(text, "s.toml")));
}

std::vector<std::string> kinds(const System& system) {
    std::vector<std::string> result;
    for (const HamiltonianPart& part : system.parts.value().parts) {
        result.push_back(part.name + ": " + part.flow);
    }
    return result;
}

std::vector<std::string> kinds_of(const std::string& text) {
    const WrittenOutScene scene = written_scene(text);
    return kinds(with_parts(system_of(scene), scene));
}

std::vector<std::string> orbits_of(const std::string& text, SplitChoice coordinates) {
    const Place place = whole(source("H", "s.toml"));
    return kinds(with_orbits(system_of(written_scene(text)), coordinates, place));
}

std::string refusal_of(const std::string& text,
                       SplitChoice coordinates = SplitChoice::heliocentric) {
    try {
        static_cast<void>(orbits_of(text, coordinates));
    } catch (const MathError& error) { return error.what(); }
    FAIL("nothing is refused");
    throw;
}

bool is_refused(const std::string& text) {
    try {
        static_cast<void>(kinds_of(text));
        return false;
    } catch (const MathError&) { return true; }
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("two bodies are one orbit, also relative, and beside others") {
    const auto first_alone = [](const std::string& potential) {
        return plane_bodies(kinetic_energy + potential,
                            "[split]\nA = \"" + kinetic_energy + potential + "\"\n");
    };
    const Names orbits{"A: Kepler orbits, a shear"};
    CHECK(kinds_of(first_alone("- G/" + distance_of("1", "2"))) == orbits);
    CHECK(kinds_of(first_alone("- G/sqrt(x[1]^2+y[1]^2) - c/sqrt(x[2]^2+y[2]^2)")) == orbits);
    CHECK(kinds_of(first_alone("+ G/sqrt(x[1]^2+y[1]^2)")) == orbits);
    CHECK(kinds_of(first_alone("- G/sqrt(4*x[1]^2+4*y[1]^2)")) == orbits);
    // NOTE: one axis has the orbits that fall straight in.
    CHECK(kinds_of(first_alone("- G/sqrt((x[1]-x[3])^2)")) == orbits);
}

TEST_CASE("what only looks like an orbit is none") {
    const auto whole = [](const std::string& text) {
        return plane_bodies(text, "[split]\nA = \"" + text + "\"\n");
    };
    CHECK(is_refused(whole(kinetic_energy + "- G/sqrt(x[1]^2+y[1]^2+1)")));
    CHECK(is_refused(whole(kinetic_energy + "- G/sqrt(x[1]^2+2*y[1]^2)")));
    CHECK(is_refused(whole(kinetic_energy + "- G/sqrt(x[1]^2+y[1]^2)^3")));
    CHECK(is_refused(whole(kinetic_energy + "- G*x[1]/sqrt(x[1]^2+y[1]^2)")));
    CHECK(is_refused(whole("u[1]^2/2 + v[1]^2 + u[2]^2 + v[2]^2 + u[3]^2 + v[3]^2"
                           " - G/sqrt(x[1]^2+y[1]^2)")));
    CHECK(is_refused(whole("u[1]^4 + v[1]^2 - G/sqrt(x[1]^2+y[1]^2)")));
    CHECK(is_refused(whole(three_bodies)));
    CHECK(is_refused(whole(kinetic_energy + " - G*a*b/" + distance_of("1", "2") + " - G*a*c/" +
                           distance_of("1", "3"))));
}

TEST_CASE("orbits about the centre of mass do not couple, and others do") {
    const auto about = [](const std::string& centre) {
        const std::string orbits = kinetic_energy + " - G/" + distance_of("1", "2") +
                                   " - G/sqrt((x[3]-(" + centre + "*x[1]+b*x[2])/(" + centre +
                                   "+b))^2 + (y[3]-(" + centre + "*y[1]+b*y[2])/(" + centre +
                                   "+b))^2)";
        return plane_bodies(orbits, "[split]\nA = \"" + orbits + "\"\n");
    };
    CHECK(kinds_of(about("a")) == Names{"A: Kepler orbits"});
    CHECK(is_refused(about("c")));
}

TEST_CASE("three bodies are orbits and a rest in coordinates of Jacobi, or about the first") {
    CHECK(orbits_of(plane_bodies(three_bodies), SplitChoice::jacobi) ==
          Names{"A: Kepler orbits", "B: a shear"});
    CHECK(orbits_of(plane_bodies(three_bodies), SplitChoice::heliocentric) ==
          Names{"A: Kepler orbits", "C: a shear", "B: a shear"});
    // NOTE: other potentials are of the rest.
    CHECK(orbits_of(plane_bodies(three_bodies + " + x[1]^4 + G/" + distance_of("2", "3") + "^3"),
                    SplitChoice::jacobi)
              .size() == 2);
}

TEST_CASE("masses that add up to nothing make no orbits") {
    const auto of_masses = [](const std::string& b, const std::string& c) {
        return plane_bodies("(u[1]^2+v[1]^2)/2 + (u[2]^2+v[2]^2)/(2*" + b +
                            ") + (u[3]^2+v[3]^2)/(2*" + c + ") - 1/" + distance_of("1", "2") +
                            " - 1/" + distance_of("1", "3"));
    };
    for (const SplitChoice choice : {SplitChoice::jacobi, SplitChoice::heliocentric}) {
        CHECK(refusal_of(of_masses("(-1)", "2"), choice) ==
              "the masses of the first 2 bodies add up to 0");
        CHECK(refusal_of(of_masses("2", "(-3)"), choice) ==
              "the masses of the first 3 bodies add up to 0");
    }
    const std::string pair =
        "u[1]^2/2 + v[1]^2/2 - u[2]^2/2 - v[2]^2/2 + u[3]^2 + v[3]^2 - 1/" + distance_of("1", "2");
    CHECK(is_refused(plane_bodies(pair, "[split]\nA = \"" + pair + "\"\n")));
}

TEST_CASE("an H that is not one of bodies that attract each other is refused with a reason") {
    const std::string what = "this H is not one of bodies that attract each other: ";
    CHECK(refusal_of(plane_bodies(kinetic_energy)) ==
          what + "it has no attraction -k/r of two bodies");
    CHECK(refusal_of(plane_bodies(kinetic_energy + "- G/" + distance_of("1", "2"))) ==
          what + "no body is attracted along x[3]");
    CHECK(refusal_of(plane_bodies(three_bodies + " + u[1]*x[1]")) ==
          what + "x[1] has no mass of its own");
    CHECK(refusal_of(plane_bodies(three_bodies + " + u[1]*u[2]")) ==
          what + "x[1] has no mass of its own");
    CHECK(refusal_of(plane_bodies(three_bodies + " + u[1]^2")) ==
          what + "a body has another mass along y[1]");
    CHECK(refusal_of(plane_bodies(kinetic_energy + " + cos(1/" + distance_of("1", "2") +
                                  ") + cos(1/" + distance_of("2", "3") + ")")) ==
          "no body is attracted by the first one");
}
