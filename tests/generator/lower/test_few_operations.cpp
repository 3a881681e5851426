// Operations of forces of textbook potentials, against those of formulas by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/generator/lower/evaluate.hpp"
#include "tests/generator/lower/textbook_potentials.hpp"

using namespace hvi::gen;

namespace {

Operations operations(const OperationCounts& counts) {
    return {counts.additions + counts.multiplications, counts.divisions, counts.square_roots,
            counts.calls};
}

}  // namespace

TEST_CASE("forces of textbook potentials cost what they cost by hand") {
    for (const Potential& potential : textbook_potentials) {
        const Forces forces(potential);
        CAPTURE(potential.name);
        CHECK(text_of(operations(kernel(forces.graph, forces.values).counts)) ==
              text_of(potential.has.value_or(potential.least)));
    }
}

TEST_CASE("forces in few operations have the values of those that were derived") {
    for (const Potential& potential : textbook_potentials) {
        const Forces forces(potential);
        Values at{{"t", 0.3L}};
        Real next = 0.4L;
        for (const Words* names : {&potential.coordinates, &potential.parameters,
                                   &potential.momenta, &potential.neighbours}) {
            for (const std::string& name : *names) { at[name] = next += 0.17L; }
        }
        for (std::size_t k = 0; k < forces.values.size(); ++k) {
            CAPTURE(potential.name, k);
            const Real expected = value(forces.graph, forces.as_derived[k], at);
            CHECK(static_cast<double>(value(forces.graph, forces.values[k], at)) ==
                  Approx(static_cast<double>(expected)).epsilon(1e-14));
        }
    }
}

TEST_CASE("forces never cost more than those that were derived, and are the same each time") {
    for (const Potential& potential : textbook_potentials) {
        const Forces forces(potential), again(potential);
        CAPTURE(potential.name);
        CHECK(cost(kernel(forces.graph, forces.values).counts) <=
              cost(kernel(forces.graph, forces.as_derived).counts));
        CHECK(forces.values == again.values);
        CHECK(forces.graph.size() == again.graph.size());
    }
}

TEST_CASE("numbers are folded with parameters, and cost nothing in a force") {
    Potential potential{"", "2*a*x^2+b*x^3/3", {"x"}, {"a", "b"}, {3}};
    const Forces forces(potential);
    // x (4 a + b x)
    const Kernel force = kernel(forces.graph, forces.values);
    CHECK(text_of(operations(force.counts)) == text_of(potential.least));
    REQUIRE(force.given.size() == 3);
    CHECK(value(forces.graph, force.given.back(), {{"a", 3}}) == 12);
}

TEST_CASE("distances are no polynomials in positions") {
    // k (x - y) + c (x - z), and not (k + c) x - k y - c z, which loses the digits of distances.
    const Forces forces({"", "k*(x-y)^2/2+c*(x-z)^2/2", {"x", "y", "z"}, {"k", "c"}, {5}});
    const Kernel force = kernel(forces.graph, forces.values);
    CHECK(text_of(operations(force.counts)) == text_of({5}));
    const Values near{{"x", 1e15L + 3}, {"y", 1e15L + 1}, {"z", 1e15L}, {"k", 0.1L}, {"c", 0.2L}};
    CHECK(std::abs(value(forces.graph, forces.values[0], near) - (0.1L * 2 + 0.2L * 3)) < 1e-18L);
}
