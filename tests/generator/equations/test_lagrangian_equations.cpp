// The equations (4.14): by hand, and as the same step as (4.18), by Proposition 4.1.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/equations/lagrangian_equations.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/read/unroll.hpp"
#include "tests/generator/equations/systems.hpp"

using namespace hvi::gen;

namespace {

Lagrangian lagrangian(const std::string& text, const std::string& coordinates,
                      const std::string& velocities) {
    const auto of = source(text);
    return lagrangian_of(unrolled(parse_indexed_expression(of)), of,
                         unrolled(name_texts(source(coordinates))),
                         unrolled(name_texts(source(velocities))));
}

std::vector<std::string> lines(const LagrangianEquations& step) {
    std::vector<std::string> result;
    for (const Equation& position : step.positions)
        result.push_back(position.left + " = " + to_text(position.right));
    for (const ImplicitEquation& stage : step.conditions)
        result.push_back(to_text(stage.left) + " = " + to_text(stage.right));
    for (const Equation& update : step.update)
        result.push_back(update.left + "' = " + to_text(update.right));
    return result;
}

using Lines = std::vector<std::string>;

/// Returns the largest difference between the sides of (4.14), and at the end of a step. The values
/// in the stages are those of (4.18) for the Hamiltonian of L, with V = dH/dp there.
Real largest_difference(const std::string& name, const Lagrangian& L) {
    const LagrangianEquations step = lagrangian_equations(method(name), L);
    const Hamiltonian H = legendre_transform(L);
    const Gradient slopes = gradient(H);
    const Tableau tableau = derive(method(name));
    const StageEquations other = stage_equations(tableau, H, slopes);
    Point point = some_point(H);
    for (const Equation& stage : other.stages) point[stage.left] = {0.4L};
    for (int round = 0; round < 200; ++round)
        for (const Equation& stage : other.stages) point[stage.left] = evaluate(stage.right, point);
    const auto in_stages = stage_names(variables(H), {}, tableau.stages());
    const auto velocities = stage_names(L.velocities, {}, tableau.stages());
    for (std::size_t i = 0; i < tableau.stages(); ++i)
        for (std::size_t k = 0; k < L.degrees_of_freedom(); ++k)
            point[velocities[i].at(L.velocities[k])] =
                evaluate(renamed(slopes.by_momenta[k], in_stages[i]), point);
    Real most = 0;
    const auto compare = [&](Real left, Real right) {
        most = std::max(most, std::isnan(left - right) ? Real(1) : std::abs(left - right));
    };
    for (const Equation& position : step.positions)
        compare(point.at(position.left).value, evaluate(position.right, point).value);
    for (const ImplicitEquation& stage : step.conditions)
        compare(evaluate(stage.left, point).value, evaluate(stage.right, point).value);
    const auto ends = solved(other, some_point(H));
    for (const Equation& update : step.update)
        compare(ends.at(update.left), evaluate(update.right, point).value);
    return most;
}

}  // namespace

TEST_CASE("(4.14) of a pendulum, by hand") {
    const Lagrangian L = lagrangian("m*v^2/2 + cos(q)", "q", "v");
    const LagrangianEquations midpoint = lagrangian_equations(method("gauss:1"), L);
    CHECK(lines(midpoint) == Lines{"Q_1 = q+h*V_1/2", "m*V_1 = p_q-h*sin(Q_1)/2", "q' = q+h*V_1",
                                   "p_q' = p_q-h*sin(Q_1)"});
    CHECK(midpoint.legendre.at(0).left == "p_q");
    CHECK(to_text(midpoint.legendre.at(0).right) == "m*v");
    CHECK(midpoint.parameters == Lines{"m"});
    CHECK(midpoint.is_exact);
    CHECK(lines(lagrangian_equations(method("stormer-verlet"), L)) ==
          Lines{"Q_1 = q", "Q_2 = q+h*(V_1/2+V_2/2)", "m*V_1 = p_q-h*sin(Q_1)/2",
                "m*V_2 = p_q-h*sin(Q_1)/2", "q' = q+h*(V_1/2+V_2/2)",
                "p_q' = p_q-h*(sin(Q_1)/2+sin(Q_2)/2)"});
}

TEST_CASE("(4.14) of a Hamiltonian, with its momenta") {
    const LagrangianEquations step =
        lagrangian_equations(method("gauss:1"), hamiltonian("p^2/2 + w*q*p + t*q^2/2"));
    CHECK(step.velocities == Lines{"q_dot"});
    CHECK(step.momenta == Lines{"p"});
    CHECK(to_text(step.legendre.at(0).right) == "q_dot-w*q");
    CHECK(lines(step).front() == "T_1 = t+h/2");
}

TEST_CASE("Proposition 4.1: (4.14) is the step (4.18) of the Hamiltonian") {
    const Lagrangian pendulum =
        lagrangian("(m1+m2)*l1^2*w1^2/2 + m2*l2^2*w2^2/2 + m2*l1*l2*w1*w2*cos(a1-a2)"
                   " + (m1+m2)*g*l1*cos(a1) + m2*g*l2*cos(a2)",
                   "a1, a2", "w1, w2");
    const Lagrangian charge =
        lagrangian("m*(a^2+b^2)/2 + B*(x*b - y*a)*(1+x^2)/2 - k*x*y", "x, y", "a, b");
    for (const std::string name : {"gauss:2", "gauss:3", "chebyshev:3", "lobatto:3", "trig3"}) {
        INFO(name);
        CHECK(largest_difference(name, pendulum) < 1e-15L);
        CHECK(largest_difference(name, charge) < 1e-15L);
    }
}
