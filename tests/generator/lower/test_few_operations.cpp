// Operations of forces of textbook potentials, against those of formulas by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/lower/collected.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/parse.hpp"
#include "tests/generator/lower/evaluate.hpp"

using namespace hvi::gen;

namespace {

/// Numbers of operations: sums and products, then divisions, roots and calls.
struct Operations {
    std::size_t simple, divisions = 0, roots = 0, calls = 0;
};

std::string text_of(const Operations& operations) {
    return std::to_string(operations.simple) + ", " + std::to_string(operations.divisions) +
           " div, " + std::to_string(operations.roots) + " sqrt, " +
           std::to_string(operations.calls) + " calls";
}

Operations operations(const OperationCounts& counts) {
    return {counts.additions + counts.multiplications, counts.divisions, counts.square_roots,
            counts.calls};
}

using Words = std::vector<std::string>;

/// A potential, the least operations of its gradient that are known, and those that it has where
/// they are more.
struct Potential {
    std::string name, text;
    Words coordinates, parameters;
    Operations least;
    std::optional<Operations> has = {};
};

struct Forces {
    explicit Forces(const Potential& potential) {
        Symbols symbols;
        std::vector<Node> variables;
        for (const std::string& name : potential.coordinates) {
            symbols[name] = graph.input(name, Role::coordinate);
            variables.push_back(symbols[name].node);
        }
        for (const std::string& name : potential.parameters) {
            symbols[name] = graph.input(name, Role::parameter);
        }
        symbols["t"] = graph.input("t", Role::time);
        const auto whole = source(potential.text);
        const Expression expression = parse_expression(whole);
        as_derived = gradient(graph, lower(graph, expression, symbols, whole), variables);
        values = collected(graph, as_derived);
    }

    Graph graph;
    std::vector<Scaled> as_derived, values;
};

// By hand, with constants of parameters computed before.
const std::vector<Potential> potentials = {
    // r = y - x; r (1 + a r)
    {"FPU alpha", "(y-x)^2/2+a*(y-x)^3/3", {"x", "y"}, {"a"}, {4}},
    // r (1 + b r^2)
    {"FPU beta", "(y-x)^2/2+b*(y-x)^4/4", {"x", "y"}, {"b"}, {5}},
    // r + r^2 (a + b r)
    {"FPU", "(y-x)^2/2+a*(y-x)^3/3+b*(y-x)^4/4", {"x", "y"}, {"a", "b"}, {6}},
    {"FPU, factored", "(y-x)^2*(1/2+a*(y-x)/3+b*(y-x)^2/4)", {"x", "y"}, {"a", "b"}, {6}},
    // x (k + l x^2)
    {"quartic oscillator", "k*x^2/2+l*x^4/4", {"x"}, {"k", "l"}, {4}},
    // x (x^2 - 1)
    {"double well", "(x^2-1)^2/4", {"x"}, {}, {3}},
    // x (b x^2 - a)
    {"Landau's double well", "-a*x^2/2+b*x^4/4", {"x"}, {"a", "b"}, {4}},
    // x (b + x^2 (a + x^2))
    {"sextic oscillator", "x^6/6+a*x^4/4+b*x^2/2", {"x"}, {"a", "b"}, {5}},
    // x (1 + 2 y); y + x^2 - y^2
    {"Henon-Heiles", "(x^2+y^2)/2+x^2*y-y^3/3", {"x", "y"}, {}, {7}},
    // x (1 + 2 y); y + x^2
    {"Barbanis", "(x^2+y^2)/2+x^2*y", {"x", "y"}, {}, {5}},
    // w x - e y^2; y (v - 2e x)
    {"Contopoulos", "(w*x^2+v*y^2)/2-e*x*y^2", {"x", "y"}, {"w", "v", "e"}, {7}},
    // s = x y; s y, s x. It has x y^2, y x^2.
    {"quartic coupling", "x^2*y^2/2", {"x", "y"}, {}, {3}, Operations{4}},
    // f = 1 + x^2 + y^2; x f, y f
    {"round quartic", "(x^2+y^2)/2+(x^2+y^2)^2/4", {"x", "y"}, {}, {6}},
    // s = x^2 + y^2, f = m/(s sqrt(s)); x f, y f
    {"Kepler 2-D", "-m/sqrt(x^2+y^2)", {"x", "y"}, {"m"}, {6, 1, 1}},
    {"Kepler 3-D", "-m/sqrt(x^2+y^2+z^2)", {"x", "y", "z"}, {"m"}, {9, 1, 1}},
    // u = 1/r; u^2 (m + J u^2)
    {"Kepler with a quadrupole", "-m/r-J/(3*r^3)", {"r"}, {"m", "J"}, {4, 1}},
    // u = 1/s, v = u^3, f = u v (b - a v)
    {"Lennard-Jones",
     "4*e*((w/sqrt(x^2+y^2+z^2))^12-(w/sqrt(x^2+y^2+z^2))^6)",
     {"x", "y", "z"},
     {"e", "w"},
     {14, 1}},
    {"Lennard-Jones by 1/r", "e*(1/r^12-2/r^6)", {"r"}, {"e"}, {7, 1}},
    // E = exp(a (r0 - r)); c E (1 - E)
    {"Morse", "D*(1-exp(-a*(r-b)))^2", {"r"}, {"D", "a", "b"}, {5, 0, 0, 1}},
    // As above. It has both exponentials.
    {"Morse of two exponentials",
     "D*(exp(-2*a*(r-b))-2*exp(-a*(r-b)))",
     {"r"},
     {"D", "a", "b"},
     {5, 0, 0, 1},
     Operations{5, 0, 0, 2}},
    // c exp(-B r) + d/r^7
    {"Buckingham", "A*exp(-B*r)-C/r^6", {"r"}, {"A", "B", "C"}, {7, 1, 0, 1}},
    // u = 1/r; g exp(-m r) u (m + u)
    {"Yukawa", "-g*exp(-m*r)/r", {"r"}, {"g", "m"}, {5, 1, 0, 1}},
    // s = x^2 + b; k x/(s sqrt(s))
    {"Coulomb with a soft core", "-k/sqrt(x^2+b^2)", {"x"}, {"k", "b"}, {4, 1, 1}},
    {"pendulum", "1-cos(q)", {"q"}, {}, {0, 0, 0, 1}},
    // c sin a; d sin b
    {"double pendulum",
     "-(m+n)*g*k*cos(a)-n*g*l*cos(b)",
     {"a", "b"},
     {"m", "n", "g", "k", "l"},
     {2, 0, 0, 2}},
    // k (r - l) - g cos a; g r sin a
    {"spring pendulum", "k*(r-l)^2/2-g*r*cos(a)", {"r", "a"}, {"k", "l", "g"}, {6, 0, 0, 2}},
    // exp(y - x) - 1
    {"Toda", "exp(y-x)-(y-x)", {"x", "y"}, {}, {2, 0, 0, 1}},
    // r = y - x, s = z - y; r - s + y (y^2 - 1)
    {"phi^4 lattice", "((y-x)^2+(z-y)^2)/2+(y^2-1)^2/4", {"x", "y", "z"}, {}, {7}},
    // r - s + sin(y)
    {"sine-Gordon lattice", "((y-x)^2+(z-y)^2)/2-cos(y)", {"x", "y", "z"}, {}, {4, 0, 0, 1}},
    {"harmonic trap", "(a*x^2+b*y^2+c*z^2)/2", {"x", "y", "z"}, {"a", "b", "c"}, {3}},
    // c = a + b cos(w t); c x, c y
    {"Paul trap", "(a+b*cos(w*t))*(x^2-y^2)/2", {"x", "y"}, {"a", "b", "w"}, {5, 0, 0, 1}},
    {"Plummer", "-M/sqrt(x^2+y^2+z^2+b^2)", {"x", "y", "z"}, {"M", "b"}, {10, 1, 1}},
    // w = c y, f = v/(x^2 + w y + b); x f, w f. It has c y^2 and c y f.
    {"logarithmic",
     "v*log(x^2+y^2/q^2+b^2)/2",
     {"x", "y"},
     {"v", "q", "b"},
     {7, 1},
     Operations{8, 1}},
    // s = sqrt(x^2 + y^2 + b^2), d = b + s, f = M/(d^2 s)
    {"isochrone", "-M/(b+sqrt(x^2+y^2+b^2))", {"x", "y"}, {"M", "b"}, {9, 1, 1}},
    // w = 1/(r - a), u = 1/r, P = B u^4; A exp(w) (P (4 u + w^2) - w^2)
    {"Stillinger-Weber", "A*(B/r^4-1)*exp(1/(r-a))", {"r"}, {"A", "B", "a"}, {11, 2, 0, 1}},
    // c sin(3 f - d)
    {"dihedral", "k*(1+cos(3*f-d))", {"f"}, {"k", "d"}, {3, 0, 0, 1}},
    // c = cos f; sin f (b + c (2c + c (3d + c (4e + 5g c))))
    {"Ryckaert-Bellemans",
     "a+b*cos(f)+c*cos(f)^2+d*cos(f)^3+e*cos(f)^4+g*cos(f)^5",
     {"f"},
     {"a", "b", "c", "d", "e", "g"},
     {9, 0, 0, 2}},
    // f = k - k b/r; x f, y f, z f
    {"bond", "k*(sqrt(x^2+y^2+z^2)-b)^2/2", {"x", "y", "z"}, {"k", "b"}, {9, 1, 1}},
    // k (cos f - c) sin f
    {"angle", "k*(cos(f)-c)^2/2", {"f"}, {"k", "c"}, {3, 0, 0, 2}},
    // u = x + m, v = x + m - 1, f = (1-m)/r^3, g = m/s^3; f u + g v, y (f + g)
    {"restricted three-body",
     "-(1-m)/sqrt((x+m)^2+y^2)-m/sqrt((x+m-1)^2+y^2)",
     {"x", "y"},
     {"m"},
     {14, 2, 2}},
};

}  // namespace

TEST_CASE("forces of textbook potentials cost what they cost by hand") {
    for (const Potential& potential : potentials) {
        const Forces forces(potential);
        CAPTURE(potential.name);
        CHECK(text_of(operations(kernel(forces.graph, forces.values).counts)) ==
              text_of(potential.has.value_or(potential.least)));
    }
}

TEST_CASE("forces in few operations have the values of those that were derived") {
    for (const Potential& potential : potentials) {
        const Forces forces(potential);
        Values at{{"t", 0.3L}};
        Real next = 0.4L;
        for (const Words* names : {&potential.coordinates, &potential.parameters}) {
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
    for (const Potential& potential : potentials) {
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
