// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/equations/systems.hpp"

using namespace hvi::gen;

namespace {

StepEquations step(const std::string& name, const std::string& H, bool generating = false) {
    return step_equations(method(name), hamiltonian(H), generating);
}

std::string text(const std::vector<Expression>& expressions) {
    std::string result;
    for (const Expression& expression : expressions)
        result += (result.empty() ? "" : ", ") + to_text(expression);
    return result;
}

}  // namespace

TEST_CASE("the maps of Section 6") {
    const StepEquations cheby = step("chebyshev:3", "q*p");
    CHECK(text(cheby.map->matrix[0]) == "-(h^3+10*h^2+48*h+96)/(h^3-10*h^2+48*h-96), 0");  // (6.2)
    CHECK(text(cheby.map->matrix[1]) == "0, (-h^3+10*h^2-48*h+96)/(h^3+10*h^2+48*h+96)");
    const StepEquations gauss = step("gauss:2", "q*p");
    CHECK(text(gauss.map->matrix[0]) == "(h^2+6*h+12)/(h^2-6*h+12), 0");  // (6.3)
    CHECK(text(gauss.map->matrix[1]) == "0, (h^2-6*h+12)/(h^2+6*h+12)");
    CHECK(text(step("chebyshev:3", "(p^2+w^2*q^2)/2").map->matrix[0]) ==  // (6.5)
          "(-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216), "
          "(36*h^5*w^4-1248*h^3*w^2+9216*h)/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216)");
    const StepEquations oscillator = step("gauss:2", "p^2/2 + w^2*q^2/2");  // (6.6)
    CHECK(text(oscillator.map->matrix[0]) == "(h^4*w^4-60*h^2*w^2+144)/(h^4*w^4+12*h^2*w^2+144), "
                                             "(-12*h^3*w^2+144*h)/(h^4*w^4+12*h^2*w^2+144)");
    CHECK(text(oscillator.map->matrix[1]) == "(12*h^3*w^4-144*h*w^2)/(h^4*w^4+12*h^2*w^2+144), "
                                             "(h^4*w^4-60*h^2*w^2+144)/(h^4*w^4+12*h^2*w^2+144)");
    CHECK_FALSE(oscillator.stages);
    CHECK(oscillator.parameters == std::vector<std::string>{"w"});
}

TEST_CASE("the map is what the equations of the stages have for a solution") {
    for (const char* name : {"midpoint", "stormer-verlet", "trig3", "gauss:3", "chebyshev:3"})
        for (const char* given : {"p^2/2 + w^2*q^2/2 + g*q", "a*q*p + b*p^2 + c*q",
                                  "p1^2/(2*m) + p2^2 + k*(q1-q2)^2 + q1*p2/3 - q2 + 0.1*q1*q2"}) {
            const Hamiltonian H = hamiltonian(given);
            Point point = some_point(H);
            const auto expected =
                solved(stage_equations(derive(method(name)), H, gradient(H)), point);
            const StepEquations found = step(name, given);
            REQUIRE(found.map);
            const std::vector<std::string> names = variables(found);
            for (std::size_t i = 0; i < names.size(); ++i) {
                Real value = evaluate(found.map->offset[i], point).value;
                for (std::size_t j = 0; j < names.size(); ++j)
                    value += evaluate(found.map->matrix[i][j], point).value * point[names[j]].value;
                CAPTURE(name, given, names[i]);
                CHECK(std::abs(value - expected.at(names[i])) < 1e-17L);
            }
        }
}

TEST_CASE("a parameter of H and of the method is one parameter") {
    Method fitted = method("1, cos(w*tau)", "0, 1");
    Hamiltonian H = hamiltonian("p^2/2 + w^2*q^2/2 + a*q");
    CHECK(step_equations(fitted, H, false).parameters == std::vector<std::string>{"a", "w"});
    set_parameter(fitted, H, parse_parameter(source("w=pi/2")));
    set_parameter(fitted, H, parse_parameter(source("a=1/3")));
    const StepEquations found = step_equations(fitted, H, false);
    CHECK(found.parameters.empty());
    REQUIRE(found.values.size() == 2);
    CHECK(found.values[0].name == "a");
    CHECK(to_text(found.values[1].value) == "pi/2");
    CHECK(found.origin == "--basis \"1, cos(w*tau)\" --nodes \"0, 1\" --param \"w=pi/2\" "
                          "--hamiltonian \"p^2/2+w^2*q^2/2+a*q\" --param \"a=1/3\"");
    // The weights are 2/pi and 1-2/pi, and the map is that of a kick, a drift and a kick.
    CHECK(text(found.map->matrix[0]) == "1-h^2*pi/2, h");
}

TEST_CASE("other Hamiltonians have equations of stages") {
    const StepEquations pendulum = step("gauss:2", "p^2/2 - g*cos(q)");
    CHECK_FALSE(pendulum.map);
    CHECK(pendulum.obstacle.empty());
    REQUIRE(pendulum.stages);
    CHECK(pendulum.parameters == std::vector<std::string>{"g"});
    const StepEquations root = step("gauss:2", "p^2/2 + sqrt(k/m)*q^2/2");
    CHECK_FALSE(root.map);
    CHECK(root.stages);
    CHECK(root.obstacle.find("sqrt(k/m)") != std::string::npos);
    const StepEquations enclosed =
        step_equations(method("1, exp(tau^2)", "0, 1"), hamiltonian("p^2/2 + q^2/2"), false);
    CHECK_FALSE(enclosed.map);
    CHECK(enclosed.stages);
    CHECK(enclosed.obstacle.find("no closed form") != std::string::npos);
}

TEST_CASE("an H that depends on time has no constant map, be it quadratic in q and p") {
    const StepEquations step =
        step_equations(method("gauss:2"), hamiltonian("p^2/2 + (1+t)*q^2/2"), false);
    CHECK_FALSE(step.map);
    REQUIRE(step.stages);
    CHECK(step.stages->stages[0].left == "T_1");
    CHECK(step.obstacle.empty());
    CHECK(step.parameters.empty());
    const Refusal generating =
        refusal([] { return step_equations(method("gauss:2"), hamiltonian("q*p + t"), true); });
    CHECK(generating.status == 1);
    CHECK(generating.says("does not depend on the time"));
    CHECK(generating.marked == "[q*p + t]");
}

TEST_CASE("the map of variables with an index is that of others") {
    const auto map = [](const std::string& H, const std::string& q, const std::string& p) {
        const StepEquations step = step_equations(method("gauss:2"), hamiltonian(H, q, p), true);
        REQUIRE(step.map);
        std::string text = to_text(step.generating->discrete);
        for (const auto& row : step.map->matrix)
            for (const Expression& entry : row) text += " " + to_text(entry);
        for (const char* part : {"[", "]"})
            for (std::size_t at = 0; (at = text.find(part)) != std::string::npos;)
                text.erase(at, 1);
        return text;
    };
    CHECK(map("sum(i=1..2, p[i]^2/(2*m[i])) + k*x[1]*x[2]", "x[1..2]", "p[1..2]") ==
          map("p1^2/(2*m1) + p2^2/(2*m2) + k*x1*x2", "x1, x2", "p1, p2"));
}

TEST_CASE("nodes without a closed form do not keep the map from having one") {
    const StepEquations gauss = step("gauss:6", "q*p");
    REQUIRE(gauss.map);
    // The diagonal Pade approximation of exp(h).
    CHECK(text({gauss.map->matrix[0][0]}) ==
          "(h^6+42*h^5+840*h^4+10080*h^3+75600*h^2+332640*h+665280)/"
          "(h^6-42*h^5+840*h^4-10080*h^3+75600*h^2-332640*h+665280)");
}

TEST_CASE("the generating function") {
    const StepEquations found = step("gauss:2", "q*p", true);
    REQUIRE(found.generating);
    CHECK(to_text(found.generating->discrete) == "(h^2+6*h+12)*q*p/(h^2-6*h+12)");
    CHECK(to_text(found.generating->exact.value()) == "exp(h)*q*p");
    CHECK(found.generating->gives_map);
    CHECK(found.generating->is_symmetric);
    CHECK_FALSE(found.generating->has_type_one);
    CHECK(step("gauss:2", "p^2/2+q^2/2", true).generating->has_type_one);
    CHECK(found.generating->order_of_difference == 5);
    CHECK_FALSE(found.generating->is_at_least);
    // q' = q + h p' for the free particle, whatever the method
    CHECK(to_text(step("midpoint", "p^2/2", true).generating->discrete) == "q*p+h*p^2/2");
    const Refusal refused = refusal([] { return step("gauss:2", "p^2/2 - cos(q)", true); });
    CHECK(refused.status == 1);
    CHECK(refused.marked == "[p^2/2 - cos(q)]");
    CHECK(refused.helps("--generating"));
    CHECK(refusal([] { return step("gauss:2", "sqrt(k/m)*q^2", true); }).helps("sqrt(k/m)"));
}
