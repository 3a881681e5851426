// The error of splittings by nested brackets, and the parts that are taken. Brackets of bodies were
// computed by SymPy, and their motion by the classical Runge-Kutta method in steps of 1/50.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/lower/parts.hpp"
#include "generator/lower/split_choice.hpp"
#include "generator/lower/system.hpp"
#include "generator/lower/values_in_doubles.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

WrittenOutScene scene_of_text(const std::string& toml) {
    return unrolled(scene_from_toml(*source(toml, "s.toml")));
}

std::string line_scene(const std::string& hamiltonian, const std::string& split,
                       const std::string& start = "q = 1\np = 2\n") {
    return "hamiltonian = \"" + hamiltonian +
           "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n[split]\n" + split + "[initial]\n" +
           start;
}

/// Returns the heavy top of examples/scenes, with its parts in an order.
std::string top_in_parts(const std::vector<std::string>& parts) {
    std::string sum, split;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        sum += (k == 0 ? "" : " + ") + parts[k];
        split += std::string(1, static_cast<char>('A' + k)) + " = \"" + parts[k] + "\"\n";
    }
    return "rotations = [\"R\"]\nangular_momenta = [\"L\"]\nhamiltonian = \"" + sum +
           "\"\n[split]\n" + split +
           "[initial]\nR = {axis = [0, 1, 0], angle = \"pi/3\"}\nL = [\"1/2\", 1, \"-7/10\"]\n";
}

/// Returns the error of strang with the parts that the scene names.
double error_of_split(const std::string& toml) {
    const WrittenOutScene scene = scene_of_text(toml);
    const System system = with_parts(system_of(scene), scene);
    return split_error(system, scene, states_of_motion(system, scene).value()).value();
}

std::vector<SplitCandidate> ways_of(const std::string& toml) {
    const WrittenOutScene scene = scene_of_text(toml);
    return split_candidates(system_of(scene), scene);
}

}  // namespace

TEST_CASE("the error of drifts and kicks of an oscillator is h^2 p^2/24 and h^2 q^2/12") {
    // E = -p^2/24 + q^2/12 on q^2 + p^2 = 5 goes from -5/24 to 5/12: 5/8, and H is 5/2.
    CHECK(error_of_split(line_scene("(q^2 + p^2)/2", "A = \"p^2/2\"\nB = \"q^2/2\"\n")) ==
          Approx(0.25).epsilon(0.02));
    CHECK(error_of_split(line_scene("(q^2 + p^2)/2", "A = \"q^2/2\"\nB = \"p^2/2\"\n")) ==
          Approx(0.25).epsilon(0.02));
}

TEST_CASE("the error of a top's turns is that of their brackets of Lie and Poisson") {
    const std::string A = "L[1]^2/2", B = "L[2]^2/4", C = "L[3]^2/6",
                      D = "3*R[3,1]/10 + R[3,2]/10 + R[3,3]";
    CHECK(error_of_split(top_in_parts({A, B, C, D})) == Approx(0.2998).epsilon(0.01));
    CHECK(error_of_split(top_in_parts({D, C, B, A})) == Approx(0.4415).epsilon(0.01));
}

TEST_CASE("states near an equilibrium are not too far apart to be followed") {
    const std::string text = "rotations = [\"R\"]\nangular_momenta = [\"L\"]\nhamiltonian = "
                             "\"L[1]^2/2 + L[2]^2/4 + L[3]^2/6\"\n[initial]\nR = \"identity\"\n"
                             "L = [\"1/1000\", 1, 0]\n";
    const WrittenOutScene scene = scene_of_text(text);
    const System system = with_parts(system_of(scene), scene);
    const StatesOfMotion states = states_of_motion(system, scene).value();
    REQUIRE(states.size() == 129);
    for (const std::vector<double>& state : states) {
        REQUIRE(state.size() == 12);
        CHECK(state[9] * state[9] + state[10] * state[10] + state[11] * state[11] ==
              Approx(1.000001).epsilon(1e-3));
    }
}

TEST_CASE("in steps in a row the parts at the ends are moved once, and the others twice") {
    const auto cost = [](const std::string& hamiltonian, const std::string& parts) {
        const WrittenOutScene scene = scene_of_text(line_scene(hamiltonian, parts));
        return cost_of_strang(with_parts(system_of(scene), scene));
    };
    const double drift = cost("p^2/2", "A = \"p^2/2\"\n"), kick = cost("q^4", "A = \"q^4\"\n"),
                 wave = cost("cos(q)", "A = \"cos(q)\"\n");
    CHECK(cost("p^2/2 + q^4", "A = \"p^2/2\"\nB = \"q^4\"\n") == Approx(drift + kick));
    CHECK(cost("p^2/2 + q^4", "A = \"q^4\"\nB = \"p^2/2\"\n") == Approx(drift + kick));
    CHECK(cost("p^2/2 + q^4 + cos(q)", "A = \"p^2/2\"\nB = \"q^4\"\nC = \"cos(q)\"\n") ==
          Approx(drift + 2 * kick + wave));
    CHECK(cost("p^2/2 + q^4 + cos(q)", "A = \"q^4\"\nB = \"cos(q)\"\nC = \"p^2/2\"\n") ==
          Approx(drift + kick + 2 * wave));
}

TEST_CASE("of ways to take H apart that of clearly the least work is taken") {
    const auto candidate = [](double cost, std::optional<double> error) {
        SplitCandidate result;
        result.cost = cost;
        result.error = error;
        return result;
    };
    CHECK(candidate(10, 0.25).work() == Approx(5));
    CHECK(chosen_split({candidate(10, 0.25), candidate(20, 0.01), candidate(30, 0.01)}) == 1);
    CHECK(chosen_split({candidate(10, 0.25), candidate(9.5, 0.25)}) == 0);  // hardly less
    CHECK(chosen_split({candidate(10, 0.25), candidate(8, 0.25)}) == 1);
    CHECK(chosen_split({candidate(10, 0.25), candidate(8, std::nullopt)}) == 0);
}

TEST_CASE("there are T(p) and U(q) beside terms where H is their sum, and each in reverse") {
    const auto names = [](const std::vector<SplitCandidate>& all) {
        std::vector<std::string> result;
        for (const SplitCandidate& each : all) result.push_back(each.name);
        return result;
    };
    const auto plane = [](const std::string& hamiltonian) {
        return "hamiltonian = \"" + hamiltonian +
               "\"\ncoordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n[initial]\nx = "
               "\"1/4\"\ny = \"1/5\"\npx = 0\npy = \"1/3\"\n";
    };
    const auto all = ways_of(plane("(px^2 + py^2 + x^2 + y^2)/2 + x^2*y"));
    CHECK(names(all) ==
          std::vector<std::string>{"in order", "in reverse", "T(p), U(q)", "U(q), T(p)"});
    CHECK(all[1].system.parts->parts[0].name == "A");
    CHECK(all[1].system.parts->parts[0].flow == "a shear");
    CHECK(all[2].system.parts->parts[0].moved.front().is_conjugate == false);
    CHECK(all[3].system.parts->parts[0].moved.front().is_conjugate);
    CHECK(names(ways_of(plane("(px^2 + py^2)/2 + x^4*y^2"))) ==
          std::vector<std::string>{"in order", "in reverse"});
    CHECK(names(ways_of(plane("(px^2 + x^2)/2 + (py^2 + y^2)/2"))) ==
          std::vector<std::string>{"in order", "T(p), U(q)", "U(q), T(p)"});
    CHECK(names(ways_of(line_scene("(q^2 + p^2)/2", "A = \"p^2/2\"\nB = \"q^2/2\"\n"))) ==
          std::vector<std::string>{"as named"});
}

TEST_CASE("nothing is measured without an initial state") {
    WrittenOutScene scene =
        scene_of_text(line_scene("(q^2 + p^2)/2", "A = \"p^2/2\"\nB = \"q^2/2\"\n"));
    scene.initial.clear();
    CHECK_FALSE(states_of_motion(with_parts(system_of(scene), scene), scene));
}

TEST_CASE("values of a graph are those of its operations") {
    Graph graph;
    const Scaled x = graph.input("x", Role::coordinate), a = graph.input("a", Role::parameter);
    const std::vector<Scaled> results{
        graph.sum({x, graph.times({-1, 2}, a)}), graph.half_power(x, -3),
        graph.call("sin", {graph.product(a, x)}), graph.power(a, x), graph.inverse(a)};
    const std::vector<double> values = values_at(graph, results, {{"x", 4}, {"a", 0.5}});
    CHECK(values[0] == 3.75);
    CHECK(values[1] == 0.125);
    CHECK(values[2] == Approx(0.90929742682568169540).epsilon(1e-15));
    CHECK(values[3] == 0.0625);
    CHECK(values[4] == 2);
    CHECK_FALSE(std::isfinite(values_at(graph, {graph.half_power(x, 1)}, {{"x", -1}})[0]));
    // NOTE: of a function of the user's own only C++ knows values.
    CHECK_FALSE(std::isfinite(values_at(graph, {graph.call("V", {x})}, {{"x", 4}})[0]));
}
