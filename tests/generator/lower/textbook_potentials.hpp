// Textbook potentials, and the operations that their forces take by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/lower/collected.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

/// Numbers of operations: sums and products, then divisions, roots and calls.
struct Operations {
    std::size_t simple, divisions = 0, roots = 0, calls = 0;
};

inline std::string text_of(const Operations& operations) {
    return std::to_string(operations.simple) + ", " + std::to_string(operations.divisions) +
           " div, " + std::to_string(operations.roots) + " sqrt, " +
           std::to_string(operations.calls) + " calls";
}

using Words = std::vector<std::string>;

/// A potential, or an H where it has momenta: the least operations of its gradient that are known,
/// and those that it has where they are others. Neighbours are places that others move.
struct Potential {
    std::string name, text;
    Words coordinates, parameters;
    Operations least;
    std::optional<Operations> has = {};
    Words momenta = {}, neighbours = {};
};

/// The gradient of a potential, as it is derived and in few operations.
struct Forces {
    explicit Forces(const Potential& potential) {
        Symbols symbols;
        std::vector<Node> variables;
        const auto add = [&](const Words& names, Role role) {
            std::vector<Node> nodes;
            for (const std::string& name : names) {
                symbols[name] = graph.input(name, role);
                nodes.push_back(symbols[name].node);
            }
            return nodes;
        };
        for (const auto& [names, role] : {std::pair(&potential.coordinates, Role::coordinate),
                                          std::pair(&potential.momenta, Role::conjugate)}) {
            const std::vector<Node> nodes = add(*names, role);
            variables.insert(variables.end(), nodes.begin(), nodes.end());
        }
        add(potential.neighbours, Role::coordinate);
        add(potential.parameters, Role::parameter);
        symbols["t"] = graph.input("t", Role::time);
        const auto whole = given("text", potential.text);
        const Expression expression = parse_expression(whole);
        const Scaled H = lower(graph, expression, symbols, whole);
        as_derived = gradient(graph, H, variables);
        values = short_gradient(graph, H, variables);
    }

    Graph graph;
    std::vector<Scaled> as_derived, values;
};

// By hand, with constants of parameters computed before.
inline const std::vector<Potential> textbook_potentials = {
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
    // s = x y; s y, s x
    {"quartic coupling", "x^2*y^2/2", {"x", "y"}, {}, {3}},
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
    // As above, with exp(2 a (r0 - r)) = E^2
    {"Morse of two exponentials",
     "D*(exp(-2*a*(r-b))-2*exp(-a*(r-b)))",
     {"r"},
     {"D", "a", "b"},
     {5, 0, 0, 1}},
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
    // w = c y, f = v/(x^2 + w y + b); x f, w f
    {"logarithmic", "v*log(x^2+y^2/q^2+b^2)/2", {"x", "y"}, {"v", "q", "b"}, {7, 1}},
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
    // w = m y; f = 1/(x^2 + w y)^(3/2), x f, w f
    {"anisotropic Kepler", "-1/sqrt(x^2+m*y^2)", {"x", "y"}, {"m"}, {7, 1, 1}},
    // u = 1/r, l u; u (m u - (l u)^2), p, (l u) u
    {"Kepler in polar coordinates", "p^2/2+l^2/(2*r^2)-m/r", {"r"}, {"m"}, {6, 1}, {}, {"p", "l"}},
    // w = 1/r^8, g = w r; w (b - a g)
    {"Mie 14-7", "e*(a/r^14-b/r^7)", {"r"}, {"e", "a", "b"}, {7, 1}, Operations{8, 1}},
    // f as of Lennard-Jones, chosen once. It chooses 2 x f, 2 y f and 2 z f.
    {"Lennard-Jones with an end",
     "if(x^2+y^2+z^2 < c^2, a/(x^2+y^2+z^2)^6-b/(x^2+y^2+z^2)^3, 0)",
     {"x", "y", "z"},
     {"a", "b", "c"},
     {14, 1, 0, 1},
     Operations{17, 1, 0, 3}},
    // v = 1/sqrt(s), u = v^2, w = u^3; u (c v + w (a w - b))
    {"Lennard-Jones and Coulomb",
     "c/sqrt(x^2+y^2+z^2)+a/(x^2+y^2+z^2)^6-b/(x^2+y^2+z^2)^3",
     {"x", "y", "z"},
     {"a", "b", "c"},
     {17, 1, 1},
     Operations{18, 1, 1}},
    // r = sqrt(s), u = 1/s; u (c r exp(-B r) + d u^3)
    {"Buckingham 3-D",
     "A*exp(-B*sqrt(x^2+y^2+z^2))-C/(x^2+y^2+z^2)^3",
     {"x", "y", "z"},
     {"A", "B", "C"},
     {16, 1, 1, 1},
     Operations{17, 1, 1, 1}},
    // r = sqrt(s); exp(-m r) (g + g m r)/(s r)
    {"Yukawa 3-D",
     "-g*exp(-m*sqrt(x^2+y^2+z^2))/sqrt(x^2+y^2+z^2)",
     {"x", "y", "z"},
     {"g", "m"},
     {13, 1, 1, 1},
     Operations{14, 1, 1, 1}},
    // E = exp(-(x^2 + y^2)/(2 w^2)); x c E, y c E
    {"Gauss 2-D", "-a*exp(-(x^2+y^2)/(2*w^2))", {"x", "y"}, {"a", "w"}, {7, 0, 0, 1}},
    // t = tanh(x); c t (1 - t^2). It has sinh(x)/cosh(x)^3, which for large x keeps its digits.
    {"Poeschl-Teller", "-a/cosh(x)^2", {"x"}, {"a"}, {4, 0, 0, 1}, Operations{3, 1, 0, 2}},
    // d = b + x - y; k d sqrt(d)
    {"Hertz", "2*k*(b+x-y)^(5/2)/5", {"x", "y"}, {"k", "b"}, {4, 0, 1}},
    // t = sqrt(z^2 + b^2), d = a + t, f = M/(x^2 + y^2 + d^2)^(3/2); x f, y f, z f d/t
    {"Miyamoto-Nagai",
     "-M/sqrt(x^2+y^2+(a+sqrt(z^2+b^2))^2)",
     {"x", "y", "z"},
     {"M", "a", "b"},
     {13, 2, 2}},
    // h = x/r^3, g = 1/x - h, k = 3 h/r^2; g (k x - 1/r^3 - 1/x^2), g k z
    {"Stoermer", "(1/x-x/(x^2+z^2)^(3/2))^2/2", {"x", "z"}, {}, {15, 2, 1}, Operations{18, 2, 1}},
    // r = 1/2 - a cos(t); z/(z^2 + r^2)^(3/2). It has 1 - a cos(t), and a quarter of its square.
    {"Sitnikov",
     "-1/sqrt(z^2+(1-a*cos(t))^2/4)",
     {"z"},
     {"a"},
     {6, 1, 1, 1},
     Operations{7, 1, 1, 1}},
    // f = 1/r^3, w = y + u; x (f - 3) + (x - v), w + y f, w, v - x. It has x (f - 2) - v.
    {"Hill",
     "(u^2+v^2)/2+y*u-x*v-x^2+y^2/2-1/sqrt(x^2+y^2)",
     {"x", "y"},
     {},
     {11, 1, 1},
     Operations{14, 1, 1},
     {"u", "v"}},
    // As above, with y + u, v - x and their sums.
    {"restricted three-body, rotating",
     "(u^2+v^2)/2+y*u-x*v-(1-m)/sqrt((x+m)^2+y^2)-m/sqrt((x+m-1)^2+y^2)",
     {"x", "y"},
     {"m"},
     {18, 2, 2},
     {},
     {"u", "v"}},
    // v = p - b y/2, w = u + b x/2; (b/2) w, -(b/2) v, v, w
    {"charge in a magnetic field",
     "((p-b*y/2)^2+(u+b*x/2)^2)/2",
     {"x", "y"},
     {"b"},
     {6},
     Operations{8},
     {"p", "u"}},
    // f = q^2 + p^2; q f, p f
    {"quartic rotator", "(q^2+p^2)^2/4", {"q"}, {}, {5}, {}, {"p"}},
    // u = 1 + l x^2; x (l p^2 + w/u^2), u p. It does not see that u - l x^2 is 1.
    {"Mathews-Lakshmanan",
     "(1+l*x^2)*p^2/2+w^2*x^2/(2*(1+l*x^2))",
     {"x"},
     {"l", "w"},
     {9, 1},
     Operations{12, 1},
     {"p"}},
    // s = sin q, w = u/s^2; s (g + w^2 cos q), p, w
    {"spherical pendulum",
     "p^2/2+u^2/(2*sin(q)^2)+g*cos(q)",
     {"q"},
     {"g"},
     {5, 1, 0, 2},
     Operations{6, 1, 0, 2},
     {"p", "u"}},
    // With c = cos(q - s), s' = sin(q - s), i = 1/(1 + s'^2) the velocities v = (p - u c) i and
    // w = (2 u - p c) i; f = v w s', f + 2 g sin q, g sin s - f. That is the derivative of the
    // Lagrangian by q - s, which the one of H does not show.
    {"double pendulum of equal rods",
     "(p^2+2*u^2-2*p*u*cos(q-s))/(2*(1+sin(q-s)^2))-2*g*cos(q)-g*cos(s)",
     {"q", "s"},
     {"g"},
     {16, 1, 0, 4},
     Operations{27, 1, 0, 4},
     {"p", "u"}},
    // A sin z and five others once each; their six sums and products with u, v, w
    {"ABC flow",
     "u*(A*sin(z)+C*cos(y))+v*(B*sin(x)+A*cos(z))+w*(C*sin(y)+B*cos(x))",
     {"x", "y", "z"},
     {"A", "B", "C"},
     {18, 0, 0, 6},
     {},
     {"u", "v", "w"}},
    // x (1 + x^2 + k y^2), y (1 + y^2 + k x^2)
    {"coupled quartic oscillators", "(x^2+y^2)/2+x^4/4+y^4/4+k*x^2*y^2/2", {"x", "y"}, {"k"}, {10}},
    // x (x^2 - 1) - f cos(w t)
    {"Duffing", "x^4/4-x^2/2-f*x*cos(w*t)", {"x"}, {"f", "w"}, {6, 0, 0, 1}},
    // (g + a cos(w t)) sin q
    {"Kapitza's pendulum", "-(g+a*cos(w*t))*cos(q)", {"q"}, {"g", "a", "w"}, {4, 0, 0, 2}},
    // With r = y - x and s = z - y the force on a site: (r - s) (1 + a (r + s))
    {"FPU alpha chain",
     "((y-x)^2+(z-y)^2)/2+a*((y-x)^3+(z-y)^3)/3",
     {"y"},
     {"a"},
     {7},
     {},
     {},
     {"x", "z"}},
    // (r - s) (1 + b (r (r + s) + s^2))
    {"FPU beta chain",
     "((y-x)^2+(z-y)^2)/2+b*((y-x)^4+(z-y)^4)/4",
     {"y"},
     {"b"},
     {10},
     {},
     {},
     {"x", "z"}},
    // r - s + y (m + l y^2)
    {"Klein-Gordon chain",
     "((y-x)^2+(z-y)^2)/2+m*y^2/2+l*y^4/4",
     {"y"},
     {"m", "l"},
     {8},
     {},
     {},
     {"x", "z"}},
    // r - s + k sin y. It has the length a of springs in both.
    {"Frenkel-Kontorova chain",
     "((y-x-a)^2+(z-y-a)^2)/2+k*(1-cos(y))",
     {"y"},
     {"k", "a"},
     {5, 0, 0, 1},
     Operations{7, 0, 0, 1},
     {},
     {"x", "z"}},
    // exp(y - x) - exp(z - y)
    {"Toda chain", "exp(y-x)+exp(z-y)", {"y"}, {}, {3, 0, 0, 2}, {}, {}, {"x", "z"}},
    // a = 2 x, b = c y, E = exp(a + b), F = exp(a - b), G = exp(-2 a); d (E + F) - e G, f (E - F).
    // It has 2 (x + sqrt(3) y) and 2 (x - sqrt(3) y).
    {"Toda, three bodies",
     "(exp(2*x+2*sqrt(3)*y)+exp(2*x-2*sqrt(3)*y)+exp(-4*x))/24",
     {"x", "y"},
     {},
     {11, 0, 0, 3},
     Operations{12, 0, 0, 3}},
    // c = cos f; sin f (A + c (b - d c)). It has sin f, sin 2 f and sin 3 f.
    {"dihedral of three cosines",
     "(a*(1+cos(f))+b*(1-cos(2*f))+c*(1+cos(3*f)))/2",
     {"f"},
     {"a", "b", "c"},
     {5, 0, 0, 2},
     Operations{7, 0, 0, 3}},
    // r = sqrt(A - B cos f); k (f - c) + (C - D/r) sin f
    {"Urey-Bradley",
     "k*(f-c)^2/2+K*(sqrt(a^2+b^2-2*a*b*cos(f))-s)^2/2",
     {"f"},
     {"k", "c", "K", "a", "b", "s"},
     {7, 1, 1, 2}},
    // m = 1/sqrt(a.a b.b), c = a.b m, e = k (c - d) m, h = c e m; e b - h (b.b) a, e a - h (a.a) b
    {"angle of three bodies",
     "k*((x*u+y*v+z*w)/sqrt((x^2+y^2+z^2)*(u^2+v^2+w^2))-d)^2/2",
     {"x", "y", "z", "u", "v", "w"},
     {"k", "d"},
     {42, 1, 1},
     Operations{42, 2, 1}},
    // d = c + 1/3, u = g/(r - a), v = g/(s - a), l' = 2 l exp(u + v), f = l' d, e = f d/(2 g);
    // -e u^2, -e v^2, f
    {"Stillinger-Weber, three bodies",
     "l*(c+1/3)^2*exp(g/(r-a)+g/(s-a))",
     {"r", "s", "c"},
     {"l", "g", "a"},
     {12, 2, 0, 1},
     Operations{13, 2, 0, 1}},
};

}  // namespace hvi::gen
