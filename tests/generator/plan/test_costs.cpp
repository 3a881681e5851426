// Estimates of costs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/lower/system.hpp"
#include "generator/plan/costs.hpp"
#include "generator/plan/plan.hpp"
#include "generator/read/hamiltonian.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

SystemProperties properties_of(const std::string& H, const std::string& q, const std::string& p) {
    const Hamiltonian hamiltonian = hamiltonian_from_text(source(H), source(q), source(p));
    const System system = system_of(hamiltonian, parameter_names(hamiltonian));
    return properties(system, gradient_kernels(system));
}

Step in_lanes(const char* method, const SystemProperties& system) {
    return plan({derive(named_method(source(method)))}, system,
                {.solver = Solver::automatic, .lanes = Lanes::automatic});
}

}  // namespace

TEST_CASE("both gradients at once, where that is likely to cost less") {
    const auto pays = [](const std::string& H, const std::string& q, const std::string& p) {
        return joint_gradient_pays(properties_of(H, q, p).costs);
    };
    // Few operations: the sums of the stages are waited for once, not twice.
    CHECK(pays("(q^2+1)*(p^2+1)/2", "q", "p"));
    // All of dH/dq and dH/dp is made of the same four functions of q and p.
    CHECK(pays("log((a-b)^2+(c-d)^2)+sin(a*c+b*d)", "a, b", "c, d"));
    // When slopes are used at once, dH/dp reuses the functions of q that dH/dq has computed.
    CHECK_FALSE(pays("(a^2+b^2-a*b*cos(x-y))/(1+sin(x-y)^2)-cos(x)-cos(y)", "x, y", "a, b"));
    CHECK_FALSE(pays("(p+sin(q))^2/2+exp(q)", "q", "p"));
}

TEST_CASE("corrections with one Hessian are for stages in lanes of a Runge-Kutta method") {
    const SystemProperties springs = properties_of("(p^2+q^2+q^4)/2", "q", "p");
    const SystemProperties mixed = properties_of("(p^2+1)*(q^2+1)", "q", "p");
    CHECK(in_lanes("gauss:4", springs).corrections);
    CHECK(in_lanes("gauss:4", mixed).corrections);
    // Positions alone: any method does.
    CHECK(in_lanes("fejer:3", springs).corrections);
    // A is not A~, and the stages do not decouple.
    CHECK_FALSE(in_lanes("fejer:3", mixed).corrections);
    const Step by_hand = plan({derive(named_method(source("gauss:4")))}, springs,
                              {.solver = Solver::fixed_point, .lanes = Lanes::automatic});
    CHECK_FALSE(by_hand.corrections);
}

TEST_CASE("a correction costs more than a sweep, and factors more than a correction of large H") {
    for (const char* method : {"gauss:2", "gauss:3", "gauss:8"}) {
        const Step step =
            in_lanes(method, properties_of("(a^2+b^2+x^4+x^2*y^2+y^4)/2", "x, y", "a, b"));
        REQUIRE(step.corrections);
        CHECK(step.corrections->costs.correction > step.corrections->costs.sweep);
        CHECK(step.corrections->costs.sweep > 0);
        CHECK(step.corrections->costs.factors > 0);
    }
}

TEST_CASE("costs are near to times that were measured") {
    // Measured times of corrections and factors over those of sweeps, on a processor with AVX2.
    struct Measured {
        const char* method;
        double corrections, factors;
    };
    const auto check = [](const SystemProperties& system, const std::vector<Measured>& measured) {
        for (const auto& [method, corrections, factors] : measured) {
            INFO(method);
            const SolverCosts costs = in_lanes(method, system).corrections.value().costs;
            CHECK(costs.correction / (corrections * costs.sweep) > 0.7);
            CHECK(costs.correction / (corrections * costs.sweep) < 1.3);
            CHECK(costs.factors / (factors * costs.sweep) > 0.6);
            CHECK(costs.factors / (factors * costs.sweep) < 1.7);
        }
    };
    check(properties_of("(q^2+1)*(p^2+1)/2", "q", "p"),
          {{"gauss:4", 3.3, 4.0}, {"gauss:8", 3.5, 2.4}, {"gauss:16", 3.5, 1.5}});
    check(properties_of("(a^2+b^2)/2-1/sqrt(x^2+y^2)", "x, y", "a, b"),
          {{"gauss:4", 2.4, 2.9}, {"gauss:8", 2.4, 2.2}, {"gauss:16", 2.9, 1.5}});
    check(properties_of("(a^2+b^2+x^2+y^2)/2+x^2*y-y^3/3", "x, y", "a, b"),
          {{"gauss:4", 3.1, 3.5}, {"gauss:8", 3.0, 2.6}, {"gauss:16", 3.3, 1.6}});
}

TEST_CASE("registers are narrow where little is computed, and wide where much is") {
    const SystemProperties kepler = properties_of("(a^2+b^2)/2-1/sqrt(x^2+y^2)", "x, y", "a, b");
    CHECK(in_lanes("gauss:8", kepler).register_width == 4);
    CHECK(in_lanes("gauss:4", kepler).register_width == 8);
    // A function of many sums and products.
    CHECK(in_lanes("gauss:8", properties_of("p^2/2-cos(q)", "q", "p")).register_width == 8);
}
