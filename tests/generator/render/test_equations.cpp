// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/read/unroll.hpp"
#include "generator/render/equations.hpp"
#include "tests/generator/render/output.hpp"

using namespace hvi::gen;
using Json = nlohmann::ordered_json;

namespace {

Expression expression(const std::string& text) {
    return unrolled(parse_indexed_expression(std::make_shared<const Source>(Source{"text", text})));
}

StepEquations step(const std::string& H) {
    StepEquations result;
    result.name = "gauss:2";
    result.origin = "--method gauss:2 --hamiltonian \"" + H + "\"";
    result.hamiltonian = expression(H);
    result.coordinates = {"q"};
    result.momenta = {"p"};
    return result;
}

/// (6.6)
StepEquations oscillator() {
    StepEquations result = step("p^2/2+w^2*q^2/2");
    result.parameters = {"w"};
    const Expression diagonal = expression("(h^4*w^4-60*h^2*w^2+144)/(h^4*w^4+12*h^2*w^2+144)");
    result.map =
        MapEquations{{{diagonal, expression("(-12*h^3*w^2+144*h)/(h^4*w^4+12*h^2*w^2+144)")},
                      {expression("(12*h^3*w^4-144*h*w^2)/(h^4*w^4+12*h^2*w^2+144)"), diagonal}},
                     {expression("0"), expression("0")}};
    return result;
}

StepEquations kick() {
    StepEquations result = step("p^2/2+g*q");
    result.values = {{"g", expression("2"), {}}};
    result.map = MapEquations{
        {{expression("1"), expression("h-h^2/2")}, {expression("0"), expression("-1")}},
        {expression("-h^2/2"), expression("h")}};
    return result;
}

StepEquations pendulum() {
    StepEquations result = step("p^2/2-cos(q)");
    StageEquations stages;
    stages.stages = {{"Q_1", expression("q+h*P_1/2")}, {"P_1", expression("p-h*sin(Q_1)/2")}};
    stages.update = {{"q", expression("q+h*P_1")}, {"p", expression("p-h*sin(Q_1)")}};
    result.stages = stages;
    return result;
}

StepEquations generating() {
    StepEquations result = oscillator();
    GeneratingEquations function;
    function.discrete = expression("h*q^2/(h-1)+q*p/(h-1)");
    function.exact = expression("q*p/cos(h)");
    function.gives_map = true;
    function.order_of_difference = 5;
    function.is_at_least = true;
    result.generating = function;
    return result;
}

}  // namespace

TEST_CASE("a map for people") {
    CHECK(render_text(oscillator()) == R"(gauss:2

hamiltonian   p^2/2+w^2*q^2/2
coordinates   q
momenta       p
parameters    w

 q' = (h^4*w^4-60*h^2*w^2+144)*q/(h^4*w^4+12*h^2*w^2+144)
      +(-12*h^3*w^2+144*h)*p/(h^4*w^4+12*h^2*w^2+144)
 p' = (12*h^3*w^4-144*h*w^2)*q/(h^4*w^4+12*h^2*w^2+144)
      +(h^4*w^4-60*h^2*w^2+144)*p/(h^4*w^4+12*h^2*w^2+144)
)");
    CHECK(render_text(kick()) == R"(gauss:2

hamiltonian   p^2/2+g*q
coordinates   q
momenta       p
values        g = 2

 q' = q+(h-h^2/2)*p-h^2/2
 p' = -p+h
)");
}

TEST_CASE("stages for people") {
    CHECK(contains(render_text(pendulum()), R"(
stages, to be solved together:

 Q_1 = q+h*P_1/2
 P_1 = p-h*sin(Q_1)/2

and with them:

 q' = q+h*P_1
 p' = p-h*sin(Q_1)
)"));
    StepEquations explicit_step = pendulum();
    explicit_step.stages->is_explicit = true;
    CHECK(contains(render_text(explicit_step), "\nEach line needs those above it only.\n"));
    CHECK_FALSE(contains(render_text(explicit_step), "solved"));
    explicit_step.stages->is_exact = false;
    CHECK(contains(render_text(explicit_step), "no closed form, to 20 digits.\n"));
    explicit_step.obstacle = "the coefficient sqrt(k/m)";
    CHECK(contains(render_text(explicit_step),
                   "H is quadratic, but the map has no formula here: the coefficient sqrt(k/m)\n"));
}

TEST_CASE("a generating function for people") {
    CHECK(contains(render_text(generating()), R"(
generating function of type II, by (4.19):

 H_d^+ = h*q^2/(h-1)+q*p'/(h-1)

exact discrete Hamiltonian, (4.1):

 H_d,exact^+ = q*p'/cos(h)

gives map     yes, by p = D_1 H_d^+ and q' = D_2 H_d^+ (3.10)
symmetric     no, the mixed second derivatives differ
type I        no, dq'/dp is singular for every h: (q, q') are not independent
difference    H_d^+ - H_d,exact^+ = O(h^5) at least
)"));
    StepEquations other = generating();
    other.generating->exact.reset();
    other.generating->gives_map = false;
    other.generating->is_symmetric = true;
    CHECK_FALSE(contains(render_text(other), "(4.1):"));
    CHECK(contains(render_text(other), "gives map     no, "));
    CHECK(contains(render_text(other), "symmetric     yes, "));
    other.generating->has_type_one = true;
    CHECK(contains(render_text(other), "type I        yes, "));
}

TEST_CASE("long equations are broken between the slopes, and no line passes the eightieth column") {
    StepEquations wide = pendulum();
    std::string slopes = "sin(Q_1)";
    for (int k = 2; k < 20; ++k) slopes += "+(1/4-sqrt(3)/6)*sin(Q_" + std::to_string(k) + ")";
    wide.stages->stages[1].right = expression("p-h*(" + slopes + ")");
    CHECK(contains(render_text(wide), " P_1 = p-h*(sin(Q_1)+(1/4-sqrt(3)/6)*sin(Q_2)"
                                      "+(1/4-sqrt(3)/6)*sin(Q_3)\n            +(1/4"));
    for (const StepEquations& each : {wide, oscillator(), generating(), kick()})
        CHECK(longest_line(render_text(each)) <= 80);
}

TEST_CASE("a map for programs") {
    const Json json = Json::parse(render_json(oscillator()));
    CHECK(keys(json) == std::vector<std::string>{"schema", "name", "hamiltonian", "variables",
                                                 "parameters", "values", "map", "offset", "stages",
                                                 "explicit", "exact"});
    CHECK(json["schema"] == "hvi-scheme/1");
    CHECK(json["name"] == "gauss:2");
    CHECK(json["hamiltonian"] == "p^2/2+w^2*q^2/2");
    CHECK(json["variables"] == Json({"q", "p"}));
    CHECK(json["parameters"] == Json({"w"}));
    CHECK(json["values"] == Json::object());
    CHECK(json["map"][0][1] == "(-12*h^3*w^2+144*h)/(h^4*w^4+12*h^2*w^2+144)");
    CHECK(json["offset"] == Json({"0", "0"}));
    CHECK(json["stages"].is_null());
    CHECK(json["explicit"].is_null());
    CHECK(json["exact"] == true);
    CHECK(Json::parse(render_json(kick()))["values"]["g"] == "2");
}

TEST_CASE("stages and generating functions for programs") {
    StepEquations decimal = pendulum();
    decimal.stages->is_exact = false;
    const Json json = Json::parse(render_json(decimal));
    CHECK(json["map"].is_null());
    CHECK(json["offset"].is_null());
    CHECK(json["stages"] ==
          Json({"Q_1 = q+h*P_1/2", "P_1 = p-h*sin(Q_1)/2", "q' = q+h*P_1", "p' = p-h*sin(Q_1)"}));
    CHECK(json["explicit"] == false);
    CHECK(json["exact"] == false);
    CHECK(Json::parse(render_json(generating()))["generating"] ==
          Json({{"discrete", "h*q^2/(h-1)+q*p/(h-1)"},
                {"exact", "q*p/cos(h)"},
                {"gives_map", true},
                {"symmetric", false},
                {"type_one", false},
                {"order_of_difference", 5},
                {"is_at_least", true}}));
}

TEST_CASE("a map for papers, as (6.6)") {
    CHECK(render_latex(oscillator()) ==
          R"(% hvi-gen scheme --method gauss:2 --hamiltonian "p^2/2+w^2*q^2/2" --format latex
% needs \usepackage{amsmath}
\[
\begin{aligned}
q_{n+1} &= \frac{h^{4}w^{4} - 60h^{2}w^{2} + 144}{h^{4}w^{4} + 12h^{2}w^{2} + 144} q_{n} + \frac{-12h^{3}w^{2} + 144h}{h^{4}w^{4} + 12h^{2}w^{2} + 144} p_{n}, \\
p_{n+1} &= \frac{12h^{3}w^{4} - 144hw^{2}}{h^{4}w^{4} + 12h^{2}w^{2} + 144} q_{n} + \frac{h^{4}w^{4} - 60h^{2}w^{2} + 144}{h^{4}w^{4} + 12h^{2}w^{2} + 144} p_{n}.
\end{aligned}
\]
)");
    const std::string simple = render_latex(kick());
    CHECK(contains(simple, "q_{n+1} &= q_{n} + \\left(h - \\frac{h^{2}}{2}\\right) p_{n} - "
                           "\\frac{h^{2}}{2}, \\\\\n"));
    CHECK(contains(simple, "p_{n+1} &= -p_{n} + h.\n"));
}

TEST_CASE("stages for papers") {
    CHECK(contains(render_latex(pendulum()), R"(
Q_{1} &= q_{n} + \frac{hP_{1}}{2}, \\
P_{1} &= p_{n} - \frac{h\sin\left(Q_{1}\right)}{2}, \\
q_{n+1} &= q_{n} + hP_{1}, \\
p_{n+1} &= p_{n} - h\sin\left(Q_{1}\right).
)"));
}

TEST_CASE("names with an index of their own") {
    StepEquations two = step("p1*theta_2");
    two.coordinates = {"q1", "theta_2"};
    two.momenta = {"p1", "p_theta"};
    StageEquations stages;
    stages.stages = {{"Q1_2", expression("q1+h*P_theta_3")}};
    stages.update = {{"theta_2", expression("theta_2+h*p_theta")}};
    two.stages = stages;
    CHECK(contains(render_latex(two), "Q_{1,2} &= q_{1,n} + hP_{\\theta,3}, \\\\\n"
                                      "\\theta_{2,n+1} &= \\theta_{2,n} + hp_{\\theta,n}.\n"));
}

TEST_CASE("names with an index in brackets, and the time") {
    StepEquations two = step("p[1]*px[2]*t");
    two.coordinates = {"x[1]", "x[2]"};
    two.momenta = {"p[1]", "px[2]"};
    StageEquations stages;
    stages.stages = {{"T_2", expression("t+h/2")}, {"X_2[1]", expression("x[1]+h*Px_2[2]*T_2")}};
    stages.update = {{"px[2]", expression("px[2]+h*m[1]")}};
    two.stages = stages;
    CHECK(contains(render_latex(two), "T_{2} &= t_{n} + \\frac{h}{2}, \\\\\n"
                                      "X_{1,2} &= x_{1,n} + h\\mathit{Px}_{2,2}T_{2}, \\\\\n"
                                      "\\mathit{px}_{2,n+1} &= \\mathit{px}_{2,n} + hm_{1}.\n"));
    CHECK(contains(render_text(two), " X_2[1] = x[1]+h*Px_2[2]*T_2\n"));
    CHECK(contains(render_json(two), "\"px[2]' = px[2]+h*m[1]\""));
}

TEST_CASE("generating functions for papers") {
    const std::string text = render_latex(generating());
    CHECK(contains(text, "--generating --format latex\n"));
    CHECK(contains(text,
                   ", \\\\\nH_{d}^{+} &= \\frac{hq_{n}^{2}}{h - 1} + "
                   "\\frac{q_{n}p_{n+1}}{h - 1}, \\\\\n"
                   "H_{d,\\mathrm{exact}}^{+} &= \\frac{q_{n}p_{n+1}}{\\cos\\left(h\\right)}.\n"));
}

TEST_CASE("the same equations give the same bytes") {
    CHECK(render_text(generating()) == render_text(generating()));
    CHECK(render_json(generating()) == render_json(generating()));
    CHECK(render_latex(generating()) == render_latex(generating()));
}

namespace {

/// (4.14) of an oscillator whose mass depends on where it is.
LagrangianEquations oscillator_of_velocities(const std::string& mass) {
    LagrangianEquations result;
    result.name = "gauss:1";
    result.origin = "--method gauss:1 mine.toml";
    result.lagrangian = expression(mass + "*q_dot^2/2-q^2/2");
    result.coordinates = {"q"};
    result.velocities = {"q_dot"};
    result.momenta = {"p"};
    result.legendre = {{"p", expression(mass + "*q_dot")}};
    result.positions = {{"Q_1", expression("q+h*Q_dot_1/2")}};
    result.conditions = {{expression(mass + "*Q_dot_1"), expression("p-h*Q_1/2")}};
    result.update = {{"q", expression("q+h*Q_dot_1")}, {"p", expression("p-h*Q_1")}};
    return result;
}

}  // namespace

TEST_CASE("the equations of a Lagrangian") {
    const LagrangianEquations step = oscillator_of_velocities("m");
    const std::string text = render_text(step);
    CHECK(contains(text, "lagrangian    m*q_dot^2/2-q^2/2\ncoordinates   q\nvelocities    q_dot\n"
                         "momenta       p\n"));
    CHECK(contains(text, "\n p = m*q_dot\n"));
    CHECK(contains(text, "\n Q_1 = q+h*Q_dot_1/2\n m*Q_dot_1 = p-h*Q_1/2\n"));
    CHECK(contains(text, "\n q' = q+h*Q_dot_1\n p' = p-h*Q_1\n"));
    CHECK(!contains(text, "decimal"));
    const Json json = Json::parse(render_json(step));
    CHECK(keys(json) == std::vector<std::string>{"schema", "name", "lagrangian", "coordinates",
                                                 "velocities", "momenta", "parameters", "values",
                                                 "legendre", "stages", "update", "exact"});
    CHECK(json["stages"] == Json{"Q_1 = q+h*Q_dot_1/2", "m*Q_dot_1 = p-h*Q_1/2"});
    CHECK(json["update"] == Json{"q' = q+h*Q_dot_1", "p' = p-h*Q_1"});
    const std::string latex = render_latex(step);
    CHECK(
        contains(latex, "% hvi-gen scheme --method gauss:1 mine.toml --lagrangian --format latex"));
    CHECK(contains(latex, "m\\dot{Q}_{1} &= p_{n} - \\frac{hQ_{1}}{2}"));
    CHECK(contains(latex, "p_{n+1} &= p_{n} - hQ_{1}.\n"));
}

TEST_CASE("a long left side has a line of its own") {
    const std::string mass =
        "(" + std::string("mass_of_one+mass_of_two+mass_of_three+mass_of_four+mass_of_five") + ")";
    const std::string text = render_text(oscillator_of_velocities(mass));
    CHECK(contains(text, mass + "*Q_dot_1\n    = p-h*Q_1/2\n"));
    CHECK(longest_line(text) <= 80);
}
