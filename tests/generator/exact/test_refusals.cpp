// Refusals: impossible methods, methods that are not built yet, and methods that are too large.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/refusals.hpp"

using namespace hvi::gen;

namespace {

Refusal refused(const std::string& expression) {
    return refusal([&] { return number(expression); });
}

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

/// sqrt(1)+sqrt(2)+...
std::string sum_of_roots(int count) {
    std::string result = "sqrt(1)";
    for (int i = 2; i <= count; ++i) result += "+sqrt(" + std::to_string(i) + ")";
    return result;
}

}  // namespace

TEST_CASE("a singular M names the combination that vanishes at the nodes") {
    const auto names = [](const std::string& basis, const std::string& nodes,
                          const std::string& combination) {
        const Refusal answer = refused(basis, nodes);
        CAPTURE(answer.what);
        CHECK(answer.status == mathematics);
        CHECK(answer.says("M is singular: `" + combination + "` vanishes at all nodes"));
        CHECK(answer.name == "--nodes");
        CHECK(answer.marked == "[" + nodes + "]");
        CHECK_FALSE(answer.help.empty());
    };
    names("1, cos(2*pi*tau)", "0, 1", "cos(2*pi*tau)-1");
    names("1, sin(pi*tau)", "0, 1", "sin(pi*tau)");
    names("1, cos(2*pi*tau)", "1/4, 3/4", "cos(2*pi*tau)");
    names("1, (tau-1/2)^2", "gauss:2", "(tau-1/2)^2-1/12");
}

TEST_CASE("functions that are dependent are said to be, whatever the nodes are") {
    const auto names = [](const std::string& basis, const std::string& nodes,
                          const std::string& combination) {
        const Refusal answer = refused(basis, nodes);
        CAPTURE(answer.what);
        CHECK(answer.status == mathematics);
        CHECK(answer.what == "the functions are dependent: `" + combination + "` is 0");
        CHECK(answer.name == "--basis");
        CHECK(answer.helps("leave one of them out"));
    };
    names("1, tau, 1+tau", "0, 1/2, 1", "1+tau-(1+tau)");
    names("1, tau, 2*tau-3", "0, 1/2, 1", "3-2*tau+2*tau-3");
    names("1, sin(tau)^2, cos(2*tau)", "0, 1/2, 1", "1-2*sin(tau)^2-cos(2*tau)");
}

TEST_CASE("equal nodes are named") {
    Refusal answer = refused("1, tau, tau^2", "0, 1/2, 0.5");
    CHECK(answer.status == mathematics);
    CHECK(answer.says("nodes 2 and 3 are equal"));
    answer = refused("1, tau", "sqrt(6), sqrt(2)*sqrt(3)");
    CHECK(answer.says("nodes 1 and 2 are equal"));
    answer = refused("1, tau, tau^2", "gauss:2, 1/2-sqrt(3)/6");
    CHECK(answer.says("nodes 1 and 3 are equal"));
}

TEST_CASE("a zero weight names its node") {
    const auto names = [](const std::string& basis, const std::string& nodes,
                          const std::string& node) {
        const Refusal answer = refused(basis, nodes);
        CAPTURE(answer.what);
        CHECK(answer.status == mathematics);
        CHECK(answer.says("the weight of node " + node + ", is zero"));
        CHECK(answer.name == "--nodes");
    };
    names("1, tau, tau^2", "0, 1/3, 1", "1, c = 0");
    names("1, tau, tau^2", "gauss:2, 1/2", "3, c = 1/2");
    names("1, cos(pi*tau)", "0, 1/2", "1, c = 0");
    names("1, tau", "1/2, 1", "2, c = 1");
    names("1, cos(2*pi*tau), sin(2*pi*tau)", "0, 1/4, 3/4", "1, c = 0");
    names("1, tau, tau^2, tau^3", "gauss:3, 1/3", "4, c = 1/3");
}

TEST_CASE("constants must be in the span of the basis") {
    const Refusal answer = refused("tau, tau^2", "1/3, 1");
    CHECK(answer.status == mathematics);
    CHECK(answer.says("constants are not in the span of the basis"));
    CHECK(answer.name == "--basis");
    CHECK(refused("cos(pi*tau), sin(pi*tau)", "0, 1/2").status == mathematics);
    CHECK(refused("exp(tau)", "1").status == mathematics);

    CHECK(refused("exp(tau), exp(tau)+1", "0, 1").status == 0);
    CHECK(refused("cos(tau)^2, sin(tau)^2", "0, 1").status == 0);
    CHECK(refused("1+tau, 1-tau", "0, 1").status == 0);
    CHECK(refused("2", "1/3").status == 0);
}

TEST_CASE("counts of functions, nodes and weights") {
    Refusal answer = refused("1, tau, tau^2", "0, 1");
    CHECK(answer.status == mathematics);
    CHECK(answer.says("fewer nodes (2) than basis functions (3)"));
    CHECK(answer.marked == "[0, 1]");

    answer = refused("1, tau", "0, 1/2, 1");
    CHECK(answer.status == input);
    CHECK(answer.says("general Galerkin form"));
}

TEST_CASE("a node that is no number") {
    CHECK(refused("1, tau", "1/0, 1").status == input);
    CHECK(refused("1, tau", "1/0, 1").says("division by zero"));
    CHECK(refused("1, tau", "1/0, 1").marked == "1/[0], 1");
    CHECK(refused("1, tau", "1/(sqrt(4)-2), 1").status == input);
    CHECK(refused("1, tau", "1/(sqrt(4)-2), 1").marked == "1/[(sqrt(4)-2)], 1");
    CHECK(refused("1, tau", "0, (cos(1)^2+sin(1)^2-1)^(-1)").status == input);
    CHECK(refused("1, tau", "0, tan(pi/2)").status == input);
    CHECK(refused("1, tau", "sqrt(-1), 1").status == mathematics);
    CHECK(refused("1, tau", "sqrt(-1), 1").marked == "[sqrt(-1)], 1");
    CHECK(refused("1, tau", "0, sqrt(1-sqrt(2))").status == mathematics);
    CHECK(refused("1, tau", "0, log(0)").status == mathematics);
    CHECK(refused("1, tau", "0, log(2-e)").status == mathematics);
    CHECK(refused("1, tau", "roots(tau^2+1), 1").status == mathematics);
}

TEST_CASE("roots takes a polynomial over Q") {
    CHECK(refused("1", "roots(tau-pi)").marked == "roots([tau-pi])");
    CHECK(refused("1", "roots(cos(tau))").marked == "roots([cos(tau)])");
    CHECK(refused("1", "roots(3)").marked == "roots([3])");
    CHECK(refused("1", "roots(tau^65-2)").marked == "roots([tau^65-2])");
    CHECK(refused("1", "roots(2*tau-1)").status == 0);
}

TEST_CASE("numbers beyond any method are refused at once") {
    const std::vector<std::string> numbers{
        "2^(2^100)",
        "2^2^100",
        "2^(-10^9)",
        "(1+pi+e)^1000",
        "(1+sqrt(2)+sqrt(3)+sqrt(5))^1000",
        "2" + repeated("^10", 12),
        "(1+pi+w)^100*(1+e+v)^100*(1+log(2))^100",
        repeated("7^1000*", 20) + "1",
    };
    for (const std::string& huge : numbers) {
        CAPTURE(huge);
        CHECK(refused(huge).status == input);
    }
}

TEST_CASE("long and deep numbers come to an end") {
    CHECK(number(repeated("sqrt(2+", 12) + "1" + repeated(")", 12)).nearest_double() ==
          0x1.fffffee743bcp+0);
    CHECK(number(repeated("sqrt(2+", 150) + "1" + repeated(")", 150)).nearest_double() == 2.0);
    CHECK(number(repeated("cos(", 40) + "1" + repeated(")", 40)).decimal(5) == "0.73909");
    CHECK(number(sum_of_roots(200)).decimal(5) == "1892.5");
    CHECK(number("1/(" + sum_of_roots(20) + ")").decimal(5) == "0.016216");
    CHECK(number(repeated("cos(w)*", 60) + "1").has_parameters());
    CHECK(refused(repeated("exp(", 50) + "1" + repeated(")", 50)).status != 0);
}
