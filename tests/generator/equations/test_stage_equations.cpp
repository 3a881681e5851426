// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/unroll.hpp"
#include "tests/generator/equations/systems.hpp"

using namespace hvi::gen;

namespace {

StageEquations equations(const Method& method, const Hamiltonian& H) {
    return stage_equations(derive(method), H, gradient(H));
}

std::vector<std::string> lines(const StageEquations& equations) {
    std::vector<std::string> result;
    for (const Equation& stage : equations.stages)
        result.push_back(stage.left + " = " + to_text(stage.right));
    for (const Equation& update : equations.update)
        result.push_back(update.left + "' = " + to_text(update.right));
    return result;
}

std::vector<std::string> lines(const std::string& name, const std::string& H) {
    return lines(equations(method(name), hamiltonian(H)));
}

using Lines = std::vector<std::string>;

/// A step of (4.18) by fixed-point iteration, from the decimals of the tableau and from derivatives
/// by automatic differentiation.
std::map<std::string, Real> stepped(const Tableau& tableau, const Hamiltonian& H,
                                    const Point& start) {
    const std::size_t s = tableau.stages(), n = H.degrees_of_freedom();
    const std::vector<std::string> names = variables(H);
    const auto number = [](const Number& value) { return std::stold(value.decimal(25)); };
    std::vector<Point> stage(s, start);
    const auto derivative = [&](std::size_t j, std::size_t variable) {
        Point point = stage[j];
        point[names[variable]].slope = 1;
        return evaluate(H.expression, point).slope;
    };
    const auto increment = [&](std::size_t variable, const NumberVector& a,
                               const NumberVector& a_tilde) {
        Real sum = 0;
        for (std::size_t j = 0; j < s; ++j)
            sum += variable < n ? number(a[j]) * derivative(j, variable + n)
                                : -number(a_tilde[j]) * derivative(j, variable - n);
        return start.at("h").value * sum;
    };
    for (int round = 0; round < 60; ++round)
        for (std::size_t i = 0; i < s; ++i)
            for (std::size_t k = 0; k < 2 * n; ++k)
                stage[i][names[k]].value =
                    start.at(names[k]).value + increment(k, tableau.A[i], tableau.A_tilde[i]);
    std::map<std::string, Real> result;
    for (std::size_t k = 0; k < 2 * n; ++k)
        result[names[k]] = start.at(names[k]).value + increment(k, tableau.b, tableau.b);
    return result;
}

}  // namespace

TEST_CASE("the equations give the step of (4.18)") {
    for (const char* name : {"symplectic-euler", "midpoint", "stormer-verlet", "trig3", "gauss:2",
                             "chebyshev:3", "lobatto:3", "gauss:6"}) {
        for (const Hamiltonian& H :
             {hamiltonian("p^2/2 - cos(q)"), hamiltonian("q*p + sin(q*p)/3 + q^3"),
              hamiltonian("(p1^2+p2^2)/2 + (q1^2+q2^2)/2 + q1^2*q2 - q2^3/3"),
              hamiltonian("(px^2+py^2)/(2*m) - mu/sqrt(x^2+y^2) + 2*x*py", "x, y", "px, py"),
              hamiltonian("p^2/2 + w*q + exp(p)"), hamiltonian("p^2/2 + w^2*q^2/2")}) {
            const Point start = some_point(H);
            const StageEquations found = equations(method(name), H);
            CHECK(found.is_exact == (std::string(name) != "gauss:6"));
            const auto expected = stepped(derive(method(name)), H, start);
            for (const auto& [variable, value] : solved(found, start)) {
                CAPTURE(name, to_text(H.expression), variable);
                CHECK(std::abs(value - expected.at(variable)) < 1e-17L);
            }
        }
    }
}

TEST_CASE("the pendulum, as one would write it") {
    CHECK(lines("gauss:2", "p^2/2 - cos(q)") ==
          Lines{"Q_1 = q+h*(P_1/4+(1/4-sqrt(3)/6)*P_2)", "Q_2 = q+h*((1/4+sqrt(3)/6)*P_1+P_2/4)",
                "P_1 = p-h*(sin(Q_1)/4+(1/4-sqrt(3)/6)*sin(Q_2))",
                "P_2 = p-h*((1/4+sqrt(3)/6)*sin(Q_1)+sin(Q_2)/4)", "q' = q+h*(P_1/2+P_2/2)",
                "p' = p-h*(sin(Q_1)/2+sin(Q_2)/2)"});
    CHECK(lines("midpoint", "p^2/2 + cos(q)") ==
          Lines{"Q_1 = q+h*P_1/2", "P_1 = p+h*sin(Q_1)/2", "q' = q+h*P_1", "p' = p+h*sin(Q_1)"});
}

TEST_CASE("explicit methods in an order in which one can compute") {
    const Hamiltonian pendulum = hamiltonian("p^2/2 - cos(q)");
    const StageEquations verlet = equations(method("stormer-verlet"), pendulum);
    CHECK(verlet.is_explicit);
    CHECK(lines(verlet) == Lines{"Q_1 = q", "P_1 = p-h*sin(Q_1)/2", "P_2 = p-h*sin(Q_1)/2",
                                 "Q_2 = q+h*(P_1/2+P_2/2)", "q' = q+h*(P_1/2+P_2/2)",
                                 "p' = p-h*(sin(Q_1)/2+sin(Q_2)/2)"});
    CHECK(equations(method("symplectic-euler"), pendulum).is_explicit);
    CHECK(equations(method("adjoint-symplectic-euler"), pendulum).is_explicit);
    CHECK_FALSE(equations(method("midpoint"), pendulum).is_explicit);
    CHECK_FALSE(equations(method("lobatto:3"), pendulum).is_explicit);
    CHECK_FALSE(equations(method("stormer-verlet"), hamiltonian("p^2/2 + q*p^2")).is_explicit);
}

TEST_CASE("what no derivative depends on has no stages") {
    CHECK(lines("midpoint", "p^3 + 2*q") == Lines{"P_1 = p-h", "q' = q+3*h*P_1^2", "p' = p-2*h"});
    CHECK(lines("gauss:2", "p^3") ==
          Lines{"P_1 = p", "P_2 = p", "q' = q+h*(3*P_1^2/2+3*P_2^2/2)", "p' = p"});
}

TEST_CASE("derivatives that are the same in all stages come once") {
    CHECK(lines("gauss:2", "q*g + cos(p)")[0] == "P_1 = p-h*(1/2-sqrt(3)/6)*g");
    CHECK(lines("symplectic-euler", "q + cos(p)") ==
          Lines{"P_1 = p-h", "q' = q-h*sin(P_1)", "p' = p-h"});
}

TEST_CASE("numbers are multiplied, and stand in front") {
    CHECK(lines("stormer-verlet", "p^3/3 + 5*q^4/12")[1] == "P_1 = p-5*h*Q_1^3/6");
    CHECK(lines("gauss:2", "p^3 - 2*q^3")[0] == "Q_1 = q+h*(3*P_1^2/4+3*(1/4-sqrt(3)/6)*P_2^2)");
    CHECK(lines("gauss:2", "p^3 - 2*q^3")[2] == "P_1 = p+h*(3*Q_1^2/2+6*(1/4-sqrt(3)/6)*Q_2^2)");
    CHECK(lines("midpoint", "(q+p)^3/6")[0] == "Q_1 = q+h*(Q_1+P_1)^2/4");
    CHECK(lines("midpoint", "q*p^2 - 4*p")[0] == "Q_1 = q+h*(2*Q_1*P_1-4)/2");
}

TEST_CASE("the time is a coordinate of the extended system") {
    for (const char* name : {"symplectic-euler", "midpoint", "stormer-verlet", "trig3", "gauss:2",
                             "chebyshev:3", "lobatto:3", "gauss:6"}) {
        for (const std::string H : {"p^2/2 + (1 + #)*q^2/2", "p^2/2 - cos(q)*cos(w*#)",
                                    "p^2*(1+#^2)/2 + q*p*sin(#) + q^3", "p^2/2 + q*#", "p*# + q"}) {
            const auto with = [&](const std::string& time) {
                std::string text = H;
                for (std::size_t at = 0; (at = text.find('#')) != std::string::npos;)
                    text.replace(at, 1, time);
                return text;
            };
            const Hamiltonian extended = hamiltonian(with("s") + " + r", "q, s", "p, r");
            Point start = some_point(extended);
            const auto expected = stepped(derive(method(name)), extended, start);
            start["t"] = start.at("s");
            for (const auto& [variable, value] :
                 solved(equations(method(name), hamiltonian(with("t"), "q", "p")), start)) {
                CAPTURE(name, H, variable);
                CHECK(std::abs(value - expected.at(variable)) < 1e-17L);
            }
        }
    }
}

TEST_CASE("the time in the stages, as one would write it") {
    CHECK(lines("lobatto:3", "p^2/2 + q*t") ==
          Lines{"T_1 = t", "T_2 = t+h/2", "T_3 = t+h", "P_1 = p-h*(T_1/6-T_2/6)",
                "P_2 = p-h*(T_1/6+T_2/3)", "P_3 = p-h*(T_1/6+5*T_2/6)",
                "q' = q+h*(P_1/6+2*P_2/3+P_3/6)", "p' = p-h*(T_1/6+2*T_2/3+T_3/6)"});
    CHECK(lines("gauss:2", "p^2/2 + q^2*cos(t)")[0] == "T_1 = t+(1/2-sqrt(3)/6)*h");
    CHECK(lines("midpoint", "p^2/2 + q*t*T_1")[0] == "t_1 = t+h/2");
    CHECK(lines("midpoint", "p^2/2 + t^2") == lines("midpoint", "p^2/2"));
    CHECK(equations(method("stormer-verlet"), hamiltonian("p^2/2 - cos(q-t)")).is_explicit);
    CHECK(equations(method("gauss:6"), hamiltonian("p^3 + t")).is_exact ==
          equations(method("gauss:6"), hamiltonian("p^3")).is_exact);
}

TEST_CASE("variables with an index") {
    const StageEquations found =
        equations(method("midpoint"),
                  hamiltonian("sum(i=1..2, p[i]^2/m[i]) - cos(x[1]-x[2])", "x[1..2]", "p[1..2]"));
    CHECK(lines(found) ==
          Lines{"X_1[1] = x[1]+h*P_1[1]/m[1]", "X_1[2] = x[2]+h*P_1[2]/m[2]",
                "P_1[1] = p[1]-h*sin(X_1[1]-X_1[2])/2", "P_1[2] = p[2]+h*sin(X_1[1]-X_1[2])/2",
                "x[1]' = x[1]+2*h*P_1[1]/m[1]", "x[2]' = x[2]+2*h*P_1[2]/m[2]",
                "p[1]' = p[1]-h*sin(X_1[1]-X_1[2])", "p[2]' = p[2]+h*sin(X_1[1]-X_1[2])"});
    for (const std::string& line : lines(found)) {
        const std::string right = line.substr(line.find('=') + 1);
        CHECK(" " + to_text(unrolled(parse_indexed_expression(source(right)))) == right);
    }
    const StageEquations taken =
        equations(method("midpoint"), hamiltonian("p[1]^3 + x[1]^3 + X_1[1]", "x[1]", "p[1]"));
    CHECK(lines(taken)[0] == "x_1[1] = x[1]+3*h*p_1[1]^2/2");
}

TEST_CASE("names of stages keep clear of other names") {
    CHECK(lines("midpoint", "p^3 + q^3")[0] == "Q_1 = q+3*h*P_1^2/2");
    CHECK(lines("midpoint", "p^3 + q^3*Q_1")[0] == "q_1 = q+3*h*p_1^2/2");
    CHECK(lines("midpoint", "p^3 + q^3*Q_1*p_1")[0] == "q_stage_1 = q+3*h*p_stage_1^2/2");
    const StageEquations both =
        equations(method("midpoint"), hamiltonian("p^3 + x^3 + X^3 + P^3", "x, X", "p, P"));
    CHECK(lines(both)[0] == "x_1 = x+3*h*p_1^2/2");
    const StageEquations greek =
        equations(method("midpoint"), hamiltonian("p_theta^3 - cos(theta)", "theta", "p_theta"));
    CHECK(lines(greek)[0] == "Theta_1 = theta+3*h*P_theta_1^2/2");
}

TEST_CASE("without a closed form a coefficient is a decimal of 20 digits") {
    const StageEquations found = equations(method("gauss:6"), hamiltonian("p^3 + q^3"));
    CHECK_FALSE(found.is_exact);
    CHECK(to_text(found.stages[0].right).rfind("q+h*(0.12849336928437775878*P_1^2", 0) == 0);
}
