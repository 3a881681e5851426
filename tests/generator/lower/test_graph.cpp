// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/lower/derivative.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/parse.hpp"
#include "tests/generator/lower/evaluate.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

using Names = std::vector<std::string>;

/// A graph with inputs, and an expression in it.
struct Lowered {
    Graph graph;
    Symbols symbols;
    std::vector<Node> variables;

    Lowered(const Names& coordinates, const Names& momenta, const Names& parameters = {}) {
        add(coordinates, Role::coordinate, true);
        add(momenta, Role::conjugate, true);
        add(parameters, Role::parameter, false);
    }

    Scaled operator()(const std::string& text) {
        const auto whole = source(text);
        return lower(graph, parsed(text), symbols, whole);
    }

    /// Parses a text that may call two functions of the user's own.
    [[nodiscard]] static Expression parsed(const std::string& text) {
        return parse_indexed_expression(source(text), {{"U", 1}, {"W", 2}}).written;
    }

private:
    void add(const Names& names, Role role, bool is_variable) {
        for (const std::string& name : names) {
            symbols[name] = graph.input(name, role);
            if (is_variable) { variables.push_back(symbols[name].node); }
        }
    }
};

Values at_random(const Names& names, unsigned seed) {
    std::mt19937 generator(seed);
    Values values;
    for (const std::string& name : names) {
        values[name] = 0.25L + static_cast<Real>(generator()) / 8e9L;
    }
    return values;
}

/// Returns the derivative by Richardson's extrapolation of central differences: an error of d^4 and
/// of 1e-19/d.
Real difference(const Expression& f, const Values& at, const std::string& name) {
    const auto central = [&](Real d) {
        Values left = at, right = at;
        left[name] -= d;
        right[name] += d;
        return (value(f, right) - value(f, left)) / (2 * d);
    };
    const Real d = 1e-4L;
    return (4 * central(d / 2) - central(d)) / 3;
}

/// `1+ 7* 1/ 1sqrt 0f`
std::string text(const OperationCounts& counts) {
    return std::to_string(counts.additions) + "+ " + std::to_string(counts.multiplications) + "* " +
           std::to_string(counts.divisions) + "/ " + std::to_string(counts.square_roots) + "sqrt " +
           std::to_string(counts.calls) + "f";
}

}  // namespace

TEST_CASE("equal computations are one node") {
    Lowered f({"x", "y", "z"}, {"p"}, {"m"});
    CHECK(f("x-y").node == f("y-x").node);
    CHECK(f("x-y").factor == -f("y-x").factor);
    CHECK(f("x+y+z") == f("z+x+y"));
    CHECK(f("2*x+2*y") == Scaled{{2, 1}, f("x+y").node});
    CHECK(f("x*m*y") == f("y*(x*m)"));
    CHECK(f("x/2") == Scaled{{1, 2}, f("x").node});
    CHECK(f("sqrt(x)^2") == f("sqrt(x)*sqrt(x)"));
    CHECK(f("e^x") == f("exp(x)"));
    CHECK(f("0.5*x") == f("x/2"));
    CHECK(f("x+y") != f("x-y"));
    CHECK(f("x^2") != f("x^3"));
    CHECK(f("sin(x)") != f("cos(x)"));
    CHECK(f("sin(x)") != f("sin(y)"));
    CHECK(f("0.123456789012") != f("0.123456789013"));
}

TEST_CASE("what algebra sees at once is left out") {
    Lowered f({"x", "y"}, {"p"});
    CHECK(f("x-x").is_zero());
    CHECK(f("0*sin(x)").is_zero());
    CHECK(f("x*y-y*x").is_zero());
    CHECK(f("x+2*y-2*y") == f("x"));
    CHECK(f("x/x") == f("1"));
    CHECK(f("x^0") == f("1"));
    CHECK(f("1/(1/x)") == f("x"));
    CHECK(f("(x+y)*3/3") == f("x+y"));
}

TEST_CASE("a function of the user's own is no constant, and its derivatives have numbers") {
    Lowered f({"x", "y"}, {"p"}, {"m"});
    CHECK(f("U(x)") == f("U(x)"));
    CHECK(f("U(x)") != f("U(y)"));
    CHECK(f.graph.at(f("U(2)").node).operation == Operation::call);
    CHECK(f.graph.at(f("U(pi)*sqrt(2)").node).operation == Operation::product);
    CHECK(!varies(f.graph.at(f("U(m)+U(1)").node).roles));
    const auto by = [&](const Scaled& value, std::size_t variable) {
        return gradient(f.graph, value, f.variables)[variable];
    };
    const auto name = [&](const Scaled& value) { return f.graph.at(value.node).name; };
    CHECK(name(by(f("U(x)"), 0)) == "U_1");
    CHECK(name(by(by(f("U(x)"), 0), 0)) == "U_11");
    const Scaled W = f("W(x,y)");
    CHECK(name(by(W, 0)) == "W_1");
    CHECK(name(by(W, 1)) == "W_2");
    CHECK(name(by(by(W, 1), 1)) == "W_22");
    CHECK(name(by(by(W, 1), 0)) == "W_12");
    CHECK(by(by(W, 1), 0) == by(by(W, 0), 1));
    CHECK(by(W, 2).is_zero());
}

TEST_CASE("derivatives agree with differences") {
    const std::vector<std::string> functions{
        "p^2/2+w^2*q^2/2",
        "q*p",
        "p^2/2-cos(q)",
        "(p^2+r^2)/2-w/sqrt(q^2+s^2)",
        "(p^2+r^2)/2+(q^2+s^2)/2+q^2*s-s^3/3",
        "(q^2+1)*(p^2+1)/2",
        "-log((q-s)^2+(p/w-r)^2)/(4*pi)",
        "(2*p^2+3*r^2-2*p*r*cos(q-s))/(1+w*sin(q-s)^2)",
        "q^3*s^(-2)+q^(3/2)+s^(-5/2)+q^w+w^s+q^(1/3)",
        "exp(q*p)+tan(q/2)*tanh(s)+sinh(p)*cosh(r)+asin(q/2)+acos(s/2)+atan(r)",
        "sqrt(1+q^2)*sqrt(1+q^2+s^4)/(1+sqrt(1+q^2))",
        "log10(q*p)+cbrt(s-3)+asinh(q*r)+acosh(1+p)+atanh(s/2)*erf(q+p)+erfc(s*r)",
        "atan2(q,p)*atan2(-s,r-2)+atan2(1,q)",
        "abs(q-2)*sign(s-3)*p+abs(r*q)",
        "min(q,2*s+1)*max(p,r-3)+min(q*p,-1)^2",
        "if(q<3,q^2*p,r)+if(3<q,q^2*p,r*s)+if(q<=s+2,if(p<0,r,p^3),r)*s",
        "if(q<0,sqrt(q-1),q^2)+min(q,sqrt(p))+if(p>=0,p^2,log(-p))",
        "12345678901234567890*q^2/(98765432109876543210+p)",
        "W(q,p)+s*W(2*r,s/2)+W(q*p,w)+W(W(s,r)/9,q)",
    };
    const Names names{"q", "s", "p", "r"};
    for (const std::string& text : functions) {
        Lowered f({"q", "s"}, {"p", "r"}, {"w"});
        const Expression expression = Lowered::parsed(text);
        const Scaled H = f(text);
        const std::vector<Scaled> slopes = gradient(f.graph, H, f.variables);
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const Values at = at_random({"q", "s", "p", "r", "w"}, seed);
            CAPTURE(text, seed);
            CHECK(value(f.graph, H, at) == Approx(value(expression, at)).epsilon(1e-16));
            for (std::size_t k = 0; k < names.size(); ++k) {
                CAPTURE(names[k]);
                CHECK(static_cast<double>(value(f.graph, slopes[k], at)) ==
                      Approx(static_cast<double>(difference(expression, at, names[k])))
                          .epsilon(1e-11)
                          .margin(1e-11));
            }
        }
    }
}

TEST_CASE("second derivatives are symmetric, and derivatives of first ones") {
    Lowered f({"q", "s"}, {"p", "r"}, {"w"});
    const Scaled H = f("(2*p^2+3*r^2-2*p*r*cos(q-s))/(1+w*sin(q-s)^2)");
    const std::vector<Scaled> slopes = gradient(f.graph, H, f.variables);
    const Values at = at_random({"q", "s", "p", "r", "w"}, 5);
    std::vector<std::vector<Scaled>> second;
    for (const Scaled& slope : slopes) { second.push_back(gradient(f.graph, slope, f.variables)); }
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            CHECK(static_cast<double>(value(f.graph, second[i][j], at)) ==
                  Approx(static_cast<double>(value(f.graph, second[j][i], at))).epsilon(1e-14));
        }
    }
    Values moved = at;
    moved["s"] += 1e-6L;
    const Real slope = (value(f.graph, slopes[0], moved) - value(f.graph, slopes[0], at)) / 1e-6L;
    CHECK(static_cast<double>(value(f.graph, second[0][1], at)) ==
          Approx(static_cast<double>(slope)).epsilon(1e-5));
}

// By hand: r2 = x x + y y, f = mu/(r2 sqrt(r2)); x f, y f.
TEST_CASE("the force of the Kepler problem costs what it costs by hand") {
    Lowered f({"x", "y"}, {"px", "py"}, {"mu"});
    const Scaled U = f("-mu/sqrt(x^2+y^2)");
    const Kernel forces = kernel(f.graph, gradient(f.graph, U, {f.variables[0], f.variables[1]}));
    CHECK(text(forces.counts) == "1+ 5* 1/ 1sqrt 0f");
}

// By hand: x + 2 x y, y + x^2 - y^2.
TEST_CASE("the force of Henon and Heiles is a short polynomial") {
    Lowered f({"x", "y"}, {});
    const Scaled U = f("(x^2+y^2)/2+x^2*y-y^3/3");
    const Kernel forces = kernel(f.graph, gradient(f.graph, U, f.variables));
    CHECK(text(forces.counts) == "3+ 4* 0/ 0sqrt 0f");
}

TEST_CASE("forces between bodies are computed once for each pair") {
    Lowered f({"x1", "x2", "x3", "y1", "y2", "y3"}, {}, {"G", "m1", "m2", "m3"});
    const Scaled U = f("-G*(m1*m2/sqrt((x1-x2)^2+(y1-y2)^2)+m1*m3/sqrt((x1-x3)^2+(y1-y3)^2)"
                       "+m2*m3/sqrt((x2-x3)^2+(y2-y3)^2))");
    const Kernel forces = kernel(f.graph, gradient(f.graph, U, f.variables));
    // 3 pairs: 2 differences, 1 sum; 2 squares, f = G m m/(r2 sqrt(r2)), 2 products; 6 sums of 2.
    CHECK(text(forces.counts) == "15+ 15* 3/ 3sqrt 0f");

    // And one pair is done with before the next begins: differences, division, differences, ...
    std::string order;
    std::vector<Node> done = forces.given;
    for (const Node node : forces.nodes) {
        const Computation& computation = f.graph.at(node);
        std::vector<Node> operands = computation.arguments;
        for (const Scaled& term : computation.terms) { operands.push_back(term.node); }
        for (const Node operand : operands) {
            CHECK(std::count(done.begin(), done.end(), operand) == 1);
        }
        done.push_back(node);
        const bool is_difference =
            computation.operation == Operation::sum &&
            f.graph.at(computation.terms.front().node).operation == Operation::input;
        if (is_difference) { order += 'd'; }
        if (computation.operation == Operation::inverse) { order += '/'; }
    }
    CHECK(order == "dd/dd/dd/");
}

TEST_CASE("a division by what is seen to be zero, with its place") {
    for (const auto& [text, marked] :
         {std::pair{"p^2+1/(q-q)", "p^2+1/[(q-q)]"}, std::pair{"q/(2-2)", "q/[(2-2)]"},
          std::pair{"1+(q-q)^(-2)", "1+[(q-q)]^(-2)"},
          std::pair{"sqrt(m*0)^(-1)", "[sqrt(m*0)]^(-1)"}}) {
        Lowered f({"q"}, {"p"}, {"m"});
        const std::string given = text;
        const Refusal error = refusal([&] { return f(given); });
        CHECK(error.status == 2);
        CHECK(error.says("a division by zero"));
        CHECK(error.marked == marked);
    }
}

TEST_CASE("a quotient is one division, and a shared one is a product with the inverse") {
    Lowered f({"x", "y", "z"}, {});
    CHECK(text(kernel(f.graph, {f("y/(1+x^2)")}).counts) == "1+ 1* 1/ 0sqrt 0f");
    CHECK(text(kernel(f.graph, {f("y/(1+x^2)"), f("z/(1+x^2)")}).counts) == "1+ 3* 1/ 0sqrt 0f");
    CHECK(text(kernel(f.graph, {f("y/sqrt(x)")}).counts) == "0+ 0* 1/ 1sqrt 0f");
    CHECK(text(kernel(f.graph, {f("x-x"), f("7")}).counts) == "0+ 0* 0/ 0sqrt 0f");
}

TEST_CASE("what depends on parameters alone is computed once") {
    Lowered f({"q"}, {"p"}, {"k", "m"});
    const Scaled H = f("p^2/(2*m)+k*sqrt(m)*q^2/2");
    const Kernel slopes = kernel(f.graph, gradient(f.graph, H, f.variables));
    CHECK(text(slopes.counts) == "0+ 2* 0/ 0sqrt 0f");
    // q, p, k sqrt(m) and 1/m; by the way there, sqrt(m).
    CHECK(slopes.given.size() == 4);
    const Kernel before =
        kernel_of_inputs(f.graph, {{{1, 1}, slopes.given[2]}, {{1, 1}, slopes.given[3]}});
    CHECK(text(before.counts) == "0+ 1* 1/ 1sqrt 0f");
}

TEST_CASE(
    "a choice is the chosen one where both are the same, and its derivative is chosen alike") {
    Lowered f({"q", "s"}, {"p"});
    CHECK(f("if(q<s,p,p)") == f("p"));
    CHECK(f("min(q,q)") == f("q"));
    CHECK(f("if(q<s,p,2*p)") != f("if(q<=s,p,2*p)"));
    CHECK(f("if(q>s,p,2*p)") == f("if(s<q,p,2*p)"));
    CHECK(f("atan2(q,s)") != f("atan2(s,q)"));
    const std::vector<Scaled> slopes = gradient(f.graph, f("if(q<s,p^2,p)"), f.variables);
    CHECK(slopes[0].is_zero());
    CHECK(slopes[1].is_zero());
    CHECK(slopes[2] == f("if(q<s,2*p,1)"));
    CHECK(gradient(f.graph, f("abs(q)*s"), f.variables)[0] == f("s*sign(q)"));
    CHECK(gradient(f.graph, f("sign(q)"), f.variables)[0].is_zero());
    CHECK(gradient(f.graph, f("max(q,s^2)"), f.variables)[1] == f("if(q<s^2,2*s,0)"));
}

TEST_CASE("the derivatives of choices among choices are no more than these are") {
    Lowered f({"q"}, {"p"});
    std::string text = "q";
    for (int i = 0; i < 5; ++i) { text = "if(" + text + "<p," + text + "+1," + text + "*2)"; }
    const Scaled H = f(text);
    const std::size_t size = f.graph.size();
    static_cast<void>(gradient(f.graph, H, f.variables));
    CHECK(f.graph.size() < 12 * size);
}
