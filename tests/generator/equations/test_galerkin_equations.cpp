// The equations (4.6) and (4.14) of the general Galerkin form: by hand, and on solutions in
// numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/equations/lagrangian_equations.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "tests/generator/equations/galerkin_solution.hpp"
#include "tests/generator/equations/systems.hpp"

using namespace hvi::gen;

namespace {

using Lines = std::vector<std::string>;

Lines lines(const GalerkinEquations& step) {
    Lines result;
    for (const Equation& position : step.positions)
        result.push_back(position.left + " = " + to_text(position.right));
    for (const ImplicitEquation& condition : step.conditions)
        result.push_back(to_text(condition.left) + " = " + to_text(condition.right));
    for (const Equation& update : step.update)
        result.push_back(update.left + "' = " + to_text(update.right));
    return result;
}

/// A rule twice: as it is given to the program, and in numbers.
struct Case {
    std::string basis, nodes;
    NumericRule rule;
};

std::vector<Case> cases() {
    const Real root = std::sqrt(0.15L), pi = std::acos(-1.0L);
    const Reals gauss_c{0.5L - root, 0.5L, 0.5L + root}, gauss_b{5 / 18.0L, 4 / 9.0L, 5 / 18.0L};
    const Reals simpson_c{0, 0.5L, 1}, simpson_b{1 / 6.0L, 2 / 3.0L, 1 / 6.0L};
    const Reals boole_c{0, 0.25L, 0.5L, 0.75L, 1},
        boole_b{7 / 90.0L, 32 / 90.0L, 12 / 90.0L, 32 / 90.0L, 7 / 90.0L};
    const NumericFunction one = power_of_tau(0), tau = power_of_tau(1), square = power_of_tau(2);
    const NumericFunction wave{[pi](Real x) { return std::cos(pi * x); },
                               [pi](Real x) { return std::sin(pi * x) / pi; }};
    return {{"1, tau", "gauss:3", {{one, tau}, gauss_c, gauss_b}},
            {"1, tau", "0, 1/2, 1", {{one, tau}, simpson_c, simpson_b}},
            {"1, tau, tau^2", "newton-cotes:5", {{one, tau, square}, boole_c, boole_b}},
            {"1, cos(pi*tau)", "gauss:3", {{one, wave}, gauss_c, gauss_b}},
            {"1", "0, 1/2, 1", {{one}, simpson_c, simpson_b}}};
}

Point start_at_time(const Hamiltonian& H) {
    Point point = some_point(H);
    point["t"] = {0.37L};
    return point;
}

/// Returns the start, and the unknowns of (4.6) by their names in the equations.
Point solution(const Case& given, const Hamiltonian& H, const NumericStep& step) {
    Point point = start_at_time(H);
    std::vector<std::string> names = variables(H);
    names.push_back("t");
    const std::size_t r = given.rule.c.size();
    const auto at_nodes = stage_names(names, symbols_in(H.expression), r);
    for (std::size_t i = 0; i < r; ++i)
        for (const std::string& name : variables(H))
            point[at_nodes[i].at(name)] = {step.at(name + "@" + std::to_string(i))};
    for (std::size_t j = 0; j < given.rule.psi.size(); ++j)
        for (const std::string& x : H.coordinates) {
            const StageNames stage = stage_names({"v_" + x}, {}, j + 1).back();
            point[stage.at("v_" + x)] = {step.at(x + "#" + std::to_string(j))};
        }
    for (std::size_t i = 0; i < r; ++i)
        point[at_nodes[i].at("t")] = {point.at("t").value + given.rule.c[i] * point.at("h").value};
    return point;
}

/// The largest difference between the sides.
Real largest_difference(const GalerkinEquations& equations, const Point& point,
                        const NumericStep& step) {
    Real most = 0;
    const auto compare = [&](Real left, Real right) {
        most = std::max(most, std::isnan(left - right) ? Real(1) : std::abs(left - right));
    };
    for (const Equation& position : equations.positions)
        compare(point.at(position.left).value, evaluate(position.right, point).value);
    for (const ImplicitEquation& condition : equations.conditions)
        compare(evaluate(condition.left, point).value, evaluate(condition.right, point).value);
    for (const Equation& update : equations.update)
        compare(step.end(update.left), evaluate(update.right, point).value);
    return most;
}

/// Returns (4.2) for the solution of (4.6): p_1 q_1 - h sum_i b_i (P_i dq/dt(c_i) - H(Q_i, P_i)).
Real value_of_K(const Case& given, const Hamiltonian& H, const NumericStep& step,
                const Point& mixed) {
    const auto& [psi, c, b] = given.rule;
    Real K = 0;
    for (std::size_t k = 0; k < H.degrees_of_freedom(); ++k)
        K += mixed.at(H.momenta[k]).value * step.end(H.coordinates[k]);
    for (std::size_t i = 0; i < c.size(); ++i) {
        Point node = mixed;
        for (const std::string& x : variables(H)) node[x] = {step.at(x + "@" + std::to_string(i))};
        Real term = -evaluate(H.expression, node).value;
        for (std::size_t k = 0; k < H.degrees_of_freedom(); ++k)
            for (std::size_t j = 0; j < psi.size(); ++j)
                term += node.at(H.momenta[k]).value * psi[j].value(c[i]) *
                        step.at(H.coordinates[k] + "#" + std::to_string(j));
        K -= mixed.at("h").value * b[i] * term;
    }
    return K;
}

}  // namespace

TEST_CASE("(4.6) of a pendulum with Simpson's rule, by hand") {
    const Hamiltonian H = hamiltonian("p^2/(2*m) - cos(q)");
    const StepEquations step = step_equations(method("1, tau", "0, 1/2, 1"), H, false);
    REQUIRE(step.at_nodes);
    CHECK_FALSE(step.map);
    CHECK_FALSE(step.stages);
    CHECK(step.at_nodes->is_exact);
    CHECK(step.parameters == Lines{"m"});
    CHECK(lines(*step.at_nodes) ==
          Lines{"Q_1 = q", "Q_2 = q+h*(V_q_1/2+V_q_2/8)", "Q_3 = q+h*(V_q_1+V_q_2/2)",
                "P_1/6+2*P_2/3+P_3/6 = p-h*(sin(Q_1)/6+sin(Q_2)/3)",
                "P_2/3+P_3/6 = p/2-h*(sin(Q_1)/12+sin(Q_2)/4)", "V_q_1 = P_1/m",
                "V_q_1+V_q_2/2 = P_2/m", "V_q_1+V_q_2 = P_3/m", "q' = q+h*(V_q_1+V_q_2/2)",
                "p' = p-h*(sin(Q_1)/6+2*sin(Q_2)/3+sin(Q_3)/6)"});
}

TEST_CASE("a function without a mean leaves no p in (4.6d), and what varies has names of its own") {
    const Hamiltonian H = hamiltonian("p^2/2 - cos(q) + t*q + V_q_1*q");
    const StepEquations step = step_equations(method("1, tau - 1/2", "gauss:3"), H, false);
    REQUIRE(step.at_nodes);
    const Lines found = lines(*step.at_nodes);
    CHECK(found.at(0) == "t_1 = t+(1/2-sqrt(15)/10)*h");
    CHECK(found.at(3) == "q_1 = q+h*((1/2-sqrt(15)/10)*v_q_1-v_q_2/20)");
    CHECK(found.at(7).substr(0, 40) == "-sqrt(15)*p_1/36+sqrt(15)*p_3/36 = -h*((");
}

TEST_CASE("(4.6) is what a solution in numbers satisfies") {
    const std::vector<Hamiltonian> systems{
        hamiltonian("p^2/2 - g*cos(q)"), hamiltonian("(1+q^2)*(1+p^2)/2"),
        hamiltonian("p^2/2 + p^4/5 + q^4*t + a*q*p"),
        hamiltonian("p1^2/2 + p2^2*(1+q1^2)/2 + q1*p2/3 + q1^2*q2 + exp(q2)")};
    for (const Case& given : cases())
        for (const Hamiltonian& H : systems) {
            const NumericStep numbers(given.rule, H, start_at_time(H));
            const StepEquations step = step_equations(method(given.basis, given.nodes), H, false);
            CAPTURE(given.basis, given.nodes, to_text(H.expression));
            REQUIRE(step.at_nodes);
            CHECK(largest_difference(*step.at_nodes, solution(given, H, numbers), numbers) <
                  1e-17L);
        }
}

TEST_CASE("(4.14) is what a solution of (4.6) satisfies, by Proposition 4.1") {
    const std::vector<std::pair<Lagrangian, Hamiltonian>> systems = [] {
        std::vector<std::pair<Lagrangian, Hamiltonian>> result;
        for (const char* text : {"p^2/2 - g*cos(q)", "(1+q^2)*(1+p^2)/2", "(p-q*t)^2/2 + q^4*t",
                                 "p1^2/2 + p2^2*(1+q1^2)/2 + q1*p2/3 + q1^2*q2 + exp(q2)"}) {
            const Hamiltonian H = hamiltonian(text);
            result.emplace_back(legendre_transform(H), H);
        }
        return result;
    }();
    for (const Case& given : cases())
        for (const auto& [L, H] : systems) {
            const NumericStep numbers(given.rule, H, start_at_time(H));
            const LagrangianEquations step =
                lagrangian_equations(method(given.basis, given.nodes), H);
            Point point = solution(given, H, numbers);
            const auto names = stage_names(L.velocities, {}, given.rule.c.size());
            for (std::size_t i = 0; i < names.size(); ++i)
                for (std::size_t k = 0; k < L.degrees_of_freedom(); ++k) {
                    Real velocity = 0;  // (4.14e)
                    for (std::size_t j = 0; j < given.rule.psi.size(); ++j)
                        velocity += given.rule.psi[j].value(given.rule.c[i]) *
                                    numbers.at(H.coordinates[k] + "#" + std::to_string(j));
                    point[names[i].at(L.velocities[k])] = {velocity};
                }
            CAPTURE(given.basis, given.nodes, to_text(H.expression));
            CHECK(step.basis.size() == given.rule.psi.size());
            CHECK(largest_difference(step, point, numbers) < 1e-17L);
        }
}

TEST_CASE("the map of a quadratic H is the step (4.6)") {
    for (const Case& given : cases())
        for (const char* text : {"p^2/2 + w^2*q^2/2 + g*q", "a*q*p + b*p^2 + c*q + p/3",
                                 "p1^2/4 + p2^2 + p1*p2/5 + 2*(q1-q2)^2 + q1*p2/3 - q2"}) {
            const Hamiltonian H = hamiltonian(text);
            const StepEquations found = step_equations(method(given.basis, given.nodes), H, false);
            CAPTURE(given.basis, given.nodes, text);
            REQUIRE(found.map);
            CHECK_FALSE(found.at_nodes);
            const Point point = start_at_time(H);
            const NumericStep expected(given.rule, H, point);
            const Lines names = variables(H);
            for (std::size_t i = 0; i < names.size(); ++i) {
                Real value = evaluate(found.map->offset[i], point).value;
                for (std::size_t j = 0; j < names.size(); ++j)
                    value +=
                        evaluate(found.map->matrix[i][j], point).value * point.at(names[j]).value;
                CAPTURE(names[i]);
                CHECK(std::abs(value - expected.end(names[i])) < 1e-17L);
            }
        }
}

TEST_CASE("the generating function of a quadratic H generates the step (4.6)") {
    for (const Case& given : cases())
        for (const char* text : {"p^2/2 + w^2*q^2/2 + g*q", "a*q*p + b*p^2 + c*q + p/3",
                                 "p1^2/4 + p2^2 + p1*p2/5 + 2*(q1-q2)^2 + q1*p2/3 - q2"}) {
            const Hamiltonian H = hamiltonian(text);
            // NOTE: with sqrt(15) and cosines at the nodes two degrees of freedom are too long.
            if (given.basis == "1, cos(pi*tau)" && H.degrees_of_freedom() > 1) continue;
            const StepEquations found = step_equations(method(given.basis, given.nodes), H, true);
            CAPTURE(given.basis, given.nodes, text);
            REQUIRE(found.generating);
            CHECK(found.generating->gives_map);
            CHECK(found.generating->is_symmetric);
            const Point start = start_at_time(H);
            const NumericStep expected(given.rule, H, start);
            Point mixed = start;  // (q_0, p_1)
            for (const std::string& p : H.momenta) mixed[p] = {expected.end(p)};
            const auto derivative = [&](const std::string& by) {
                Point point = mixed;
                point[by].slope = 1;
                return evaluate(found.generating->discrete, point).slope;
            };
            const Real K = value_of_K(given, H, expected, mixed);
            CHECK(std::abs(evaluate(found.generating->discrete, mixed).value - K) < 1e-17L);
            for (std::size_t k = 0; k < H.degrees_of_freedom(); ++k) {  // (3.10)
                CHECK(std::abs(derivative(H.coordinates[k]) - start.at(H.momenta[k]).value) <
                      1e-17L);
                CHECK(std::abs(derivative(H.momenta[k]) - expected.end(H.coordinates[k])) < 1e-17L);
            }
        }
}

TEST_CASE("a map that is too long leaves (4.6)") {
    const Hamiltonian chain = hamiltonian(
        "sum(i=1..13, p[i]^2/2) + sum(i=1..12, (q[i+1]-q[i])^2/2)", "q[1..13]", "p[1..13]");
    const StepEquations step = step_equations(method("1, tau", "0, 1/2, 1"), chain, false);
    CHECK_FALSE(step.map);
    CHECK(step.at_nodes);
    CHECK(step.obstacle == "the map is too long to be computed");
}

TEST_CASE("what has no closed form has decimals in (4.6)") {
    const StepEquations step =
        step_equations(method("1, tau", "gauss:6"), hamiltonian("p^2/2 - cos(q)"), false);
    CHECK_FALSE(step.map);
    REQUIRE(step.at_nodes);
    CHECK_FALSE(step.at_nodes->is_exact);
}

TEST_CASE(
    "H that leaves p free at the nodes is refused, and generating functions but of quadratic H") {
    const auto step = [](const Hamiltonian& H, bool generating = false) {
        return refusal(
            [&] { return step_equations(method("1, tau", "0, 1/2, 1"), H, generating); });
    };
    const Refusal linear = step(hamiltonian("q*p"));
    CHECK(linear.status == 1);
    CHECK(linear.marked == "[q*p]");
    CHECK(linear.says("a row of it is zero"));
    CHECK(step(hamiltonian("(p1+p2)^2/2 + cos(q1) + q2^2")).says("its rank is 1 of 2"));
    CHECK(step(hamiltonian("(p1+p2)^2/2 + q1*p2 + q2^2")).says("d2H/dp2 is regular"));
    CHECK(step(hamiltonian("(p1+p2)^2*(1+q1^2)/2 + q2*p1 + q2^2")).says("its rank is 1 of 2"));
    CHECK(step(hamiltonian("(q1*p1+q2*p2)^2")).says("its rank is 1 of 2"));
    CHECK(step(hamiltonian("sqrt(p^2) + q^2")).says("its rank is 0 of 1"));
    CHECK(step(hamiltonian("q*p"), true).says("a row of it is zero"));
    CHECK(step(hamiltonian("p^2/2 + q^4"), true).says("for quadratic Hamiltonians only"));
}
