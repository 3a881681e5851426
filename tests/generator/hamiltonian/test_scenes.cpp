// Claims of the scenes that come with the program about their motions, against Hamilton's equations
// by automatic differentiation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/written_out_scene.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/read/small_scene.hpp"

using namespace hvi::gen;

namespace {

WrittenOutScene scene(const std::string& name) {
    return unrolled(find_scene(source(name, "SCENE")));
}

/// The values of the parameters, and a time.
Point given(const WrittenOutScene& scene, Real time) {
    Point point{{"t", {time}}};
    for (const Parameter& parameter : scene.parameters)
        point[parameter.name] = evaluate(parameter.value, {});
    return point;
}

/// The parameters, and the variables as they are at the beginning.
Point start(const WrittenOutScene& scene) {
    const Point parameters = given(scene, 0);
    Point point = parameters;
    for (const NamedExpression& value : scene.initial)
        point[value.name] = evaluate(value.expression, parameters);
    return point;
}

Real derivative(const Expression& expression, Point point, const std::string& name) {
    point.at(name).slope = 1;
    return evaluate(expression, point).slope;
}

/// q' = dH/dp and p' = -dH/dq, coordinates first.
std::vector<Real> velocity(const Hamiltonian& H, const Point& point) {
    std::vector<Real> result;
    for (const std::string& p : H.momenta) result.push_back(derivative(H.expression, point, p));
    for (const std::string& q : H.coordinates)
        result.push_back(-derivative(H.expression, point, q));
    return result;
}

}  // namespace

TEST_CASE("exact solutions solve Hamilton's equations") {
    for (const char* name : {"harmonic-oscillator", "qp"}) {
        WrittenOutScene system = scene(name);
        for (Parameter& parameter : system.parameters)
            parameter.value = Expression::rational("7", "5");
        REQUIRE(!system.exact.empty());
        const Point begin = start(system);
        for (const NamedExpression& solution : system.exact)
            CHECK(evaluate(solution.expression, given(system, 0)).value ==
                  begin.at(solution.name).value);
        for (const Real time : {0.3L, 1.1L, 2.9L}) {
            Point point = given(system, time);
            for (const NamedExpression& solution : system.exact)
                point[solution.name] = {evaluate(solution.expression, given(system, time)).value};
            const std::vector<Real> expected = velocity(hamiltonian_of(system), point);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                CAPTURE(name, time, system.exact[k].name);
                const Real found = derivative(system.exact[k].expression, given(system, time), "t");
                CHECK(std::abs(found - expected[k]) < 1e-16L * (1 + std::abs(found)));
            }
        }
    }
}

TEST_CASE("invariants do not change") {
    std::size_t count = 0;
    for (const SceneEntry& entry : scenes()) {
        const WrittenOutScene system = small_scene(entry);
        if (!std::holds_alternative<Hamiltonian>(system.mechanics)) continue;
        if (!hamiltonian_of(system).rotations.empty()) continue;  // see tests/runtime/groups
        const std::vector<std::string> names = variables(hamiltonian_of(system));
        Point point = given(system, 0);
        Real value = 0.3L;
        for (const std::string& name : names) point[name] = {value = 1.7L - 1.13L * value};
        const std::vector<Real> velocities = velocity(hamiltonian_of(system), point);
        for (const NamedExpression& invariant : system.invariants) {
            Real change = 0, size = 0;
            for (std::size_t k = 0; k < names.size(); ++k) {
                const Real part = derivative(invariant.expression, point, names[k]) * velocities[k];
                change += part;
                size += std::abs(part);
            }
            CAPTURE(std::string(entry.name), invariant.name);
            CHECK(size > 0);
            CHECK(std::abs(change) <= 1e-15L * size);
            ++count;
        }
    }
    // Small scenes have 19, toda-ring 3, ring-of-bodies 1, plummer and atoms 6 each.
    CHECK(count == 41);
}

TEST_CASE("scenes begin with the energy that is known of them") {
    const auto energy = [](const char* name) {
        const WrittenOutScene system = scene(name);
        return evaluate(hamiltonian_of(system).expression, start(system)).value;
    };
    CHECK(std::abs(energy("henon-heiles") - 0.125L) < 1e-18L);
    CHECK(std::abs(energy("kepler") + 0.5L) < 1e-18L);  // -mu/(2a), with the half axis a = 1
    CHECK(energy("nonseparable") == 5);
}
