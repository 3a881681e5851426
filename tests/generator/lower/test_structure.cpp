// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/lower/system.hpp"
#include "tests/generator/lower/evaluate.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

System analysed(const std::string& H, const std::string& coordinates = "q",
                const std::string& momenta = "p") {
    const Hamiltonian hamiltonian =
        hamiltonian_from_text(source(H), source(coordinates), source(momenta));
    return system_of(hamiltonian, parameter_names(hamiltonian));
}

}  // namespace

TEST_CASE("separable Hamiltonians, and those with quadratic kinetic energy") {
    const Structure pendulum = analysed("p^2/(2*m)-cos(q)").structure;
    CHECK(pendulum.is_separable);
    CHECK(pendulum.kinetic_is_quadratic);
    CHECK_FALSE(pendulum.is_quadratic);

    const Structure relativistic = analysed("sqrt(1+p^2)-cos(q)").structure;
    CHECK(relativistic.is_separable);
    CHECK_FALSE(relativistic.kinetic_is_quadratic);

    const Structure magnetic = analysed("(p-q)^2/2").structure;
    CHECK_FALSE(magnetic.is_separable);
    CHECK_FALSE(magnetic.kinetic_is_quadratic);
    CHECK(magnetic.is_quadratic);

    // The mass depends on the place.
    const Structure pendulums = analysed("p^2/(2*(1+q^2))").structure;
    CHECK_FALSE(pendulums.is_separable);
    CHECK_FALSE(pendulums.kinetic_is_quadratic);
}

TEST_CASE("quadratic and degenerate Hamiltonians") {
    CHECK(analysed("p^2/2+w^2*q^2/2").structure.is_quadratic);
    CHECK(analysed("q*p").structure.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+q^3").structure.is_quadratic);
    CHECK(analysed("q*p").structure.is_linear_in_p);
    CHECK(analysed("q*p").structure.is_linear_in_q);
    CHECK(analysed("sin(q)*p").structure.is_linear_in_p);
    CHECK_FALSE(analysed("sin(q)*p").structure.is_linear_in_q);
    CHECK_FALSE(analysed("p^2/2").structure.is_linear_in_p);
}

TEST_CASE("quadratic in a disguise that exact arithmetic sees through") {
    const System quotient = analysed("p^2/2+(q^4-1)/(q^2-1)");
    CHECK(quotient.structure.is_quadratic);
    CHECK_FALSE(varies(quotient.graph.at(hessian_of(quotient).qq[0][0].node).roles));
    CHECK(value(quotient.graph, hessian_of(quotient).qq[0][0], {}) == 2);
    CHECK(analysed("exp(q)*exp(-q)*p^2").structure.is_quadratic);
    CHECK(analysed("sin(2*q)-2*sin(q)*cos(q)+p^2").structure.is_quadratic);
    CHECK(analysed("(p^2+q^2)*sqrt(k)^2").structure.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+(q^4-1)/(q^2+1)+1e-60*q^4").structure.is_quadratic);
    CHECK_FALSE(analysed("(sin(q)^2+cos(q)^2*(1+1e-40))*p^2/2").structure.is_quadratic);
}

TEST_CASE("an H that depends on time has another form at each time") {
    CHECK(analysed("p^2/2+q^2/2").structure.has_linear_map);
    CHECK(analysed("p^2/2+q^2/2+q*t").structure.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+q^2/2+q*t").structure.has_linear_map);
    CHECK_FALSE(analysed("p^2/2+(1+t)*q^2/2").structure.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+q^2/2+sin(t)").structure.has_linear_map);
}

TEST_CASE("the first derivatives of a quadratic H at the origin") {
    const System shifted = analysed("(p-q-a)^2/2+3*q+p*q");
    REQUIRE(shifted.structure.is_quadratic);
    const Values at{{"a", 2}, {"p", 5}, {"q", 7}};
    CHECK(value(shifted.graph, shifted.structure.by_q[0], at) == 2 + 3);
    CHECK(value(shifted.graph, shifted.structure.by_p[0], at) == -2);
    CHECK(analysed("q*p").structure.by_q[0].is_zero());
}

namespace {

/// Empty where there are none, or where constant terms couple.
std::vector<LinearStiffness> by_components(const System& system) {
    const auto* found = std::get_if<std::vector<LinearStiffness>>(&system.structure.constant);
    return found == nullptr ? std::vector<LinearStiffness>{} : *found;
}

}  // namespace

TEST_CASE("the constant stiffness of components, where none couples with another") {
    const auto stiff = [](const std::string& H, const std::string& q, const std::string& p) {
        return by_components(analysed(H, q, p));
    };
    const System spring = analysed("p^2/(2*m)+k*q^2+q^4");
    REQUIRE(by_components(spring).size() == 1);
    CHECK(by_components(spring)[0].component == 0);
    CHECK(value(spring.graph, by_components(spring)[0].value, {{"m", 4}, {"k", 3}}) == 1.5L);
    // A hill: the sum is kept as -(2 k - 12 q^2).
    const System hill = analysed("p^2/(2*m)-k*q^2+q^4");
    REQUIRE(by_components(hill).size() == 1);
    CHECK(value(hill.graph, by_components(hill)[0].value, {{"m", 4}, {"k", 3}}) == -1.5L);
    // x^2/2 - x^3/3 has the second derivative 1 - 2 x, and cos none that is constant.
    const System two = analysed("(a^2+b^2)/2-cos(x)+y^2/2-y^3/3", "x, y", "a, b");
    REQUIRE(by_components(two).size() == 1);
    CHECK(by_components(two)[0].component == 1);
    CHECK(value(two.graph, by_components(two)[0].value, {}) == 1);
    CHECK(stiff("(a^2+b^2)/2+x^2+x*y+x^4", "x, y", "a, b").empty());
    CHECK(stiff("(a^2+a*b+b^2)/2+x^2+x^4", "x, y", "a, b").empty());
    CHECK(stiff("p^2/2-cos(q)", "q", "p").empty());
}

TEST_CASE("the constant terms of second derivatives, where components couple") {
    const auto entries = [](const HessianBlock& block, const System& system, const Values& at) {
        std::vector<Real> values;
        for (const std::vector<Scaled>& row : block) {
            for (const Scaled& entry : row) { values.push_back(value(system.graph, entry, at)); }
        }
        return values;
    };
    using All = std::vector<Real>;
    const Values at{{"k", 3}, {"B", 5}};
    const System chain = analysed("(a^2+b^2)/2+k*(x-y)^2/2+x^4", "x, y", "a, b");
    REQUIRE(std::holds_alternative<Hessian>(chain.structure.constant));
    const auto& springs = std::get<Hessian>(chain.structure.constant);
    CHECK(entries(springs.qq, chain, at) == All{3, -3, -3, 3});
    CHECK(entries(springs.mixed, chain, at) == All{0, 0, 0, 0});
    CHECK(entries(springs.conjugates, chain, at) == All{1, 0, 0, 1});
    // ((a + B y)^2 + (b - B x)^2)/2: by x, x, B^2; by x and b, -B; by y and a, B.
    const System magnet = analysed("((a+B*y)^2+(b-B*x)^2)/2+x^4+k*x*y^3", "x, y", "a, b");
    REQUIRE(std::holds_alternative<Hessian>(magnet.structure.constant));
    const auto& field = std::get<Hessian>(magnet.structure.constant);
    CHECK(entries(field.qq, magnet, at) == All{25, 0, 0, 25});
    CHECK(entries(field.mixed, magnet, at) == All{0, -5, 5, 0});
    CHECK(entries(field.conjugates, magnet, at) == All{1, 0, 0, 1});
    // Nothing moves by constant terms of one kind alone.
    const auto has_none = [](const std::string& H) {
        return std::holds_alternative<std::monostate>(
            analysed(H, "x, y", "a, b").structure.constant);
    };
    CHECK(has_none("a^2/2+a^4+b^2/2+cos(x)*y"));
    CHECK(has_none("(a^2+a*b+b^2)/2+cos(x)*y"));
    CHECK_FALSE(has_none("(a^2+a*b+b^2)/2+cos(x)*y+y^2"));
}

TEST_CASE("what H does not depend on") {
    CHECK(cyclic_coordinates(analysed("p^2/2")) == std::vector<std::size_t>{0});
    CHECK(cyclic_coordinates(analysed("p^2/2+q-q")) == std::vector<std::size_t>{0});
    CHECK(cyclic_coordinates(analysed("p^2/2+q")).empty());
}

TEST_CASE("of an L there are second derivatives, and no parts are looked for") {
    // L = v^2/2 + w^2/2 - x^2/2: d2L/dv2 = 1, d2L/dx2 = -1, and p_w is constant.
    const System system = system_of(unrolled(scene_from_toml(Source{"l.toml", R"toml(
lagrangian = "v^2/2+w^2/2-x^2/2"
coordinates = ["x", "y"]
velocities = ["v", "w"]
[initial]
x = 1
y = 0
v = 0
w = 1
)toml"})));
    CHECK_FALSE(system.structure.is_separable);
    CHECK_FALSE(system.structure.has_linear_map);
    CHECK(system.structure.direction.empty());
    CHECK(value(system.graph, hessian_of(system).conjugates[0][0], {}) == 1);
    CHECK(value(system.graph, hessian_of(system).qq[0][0], {}) == -1);
    CHECK(cyclic_coordinates(system) == std::vector<std::size_t>{1});
}

TEST_CASE("the inverse mass times the momenta, without what is linear in T") {
    const System coupled = analysed("pa^2/m+pa*pb+3*pb+cos(a-b)", "a, b", "pa, pb");
    REQUIRE(coupled.structure.kinetic_is_quadratic);
    const Values at{{"m", 4}, {"pa", 5}, {"pb", 7}, {"a", 0}, {"b", 0}};
    CHECK(value(coupled.graph, coupled.structure.inverse_mass[0], at) == 2.0L * 5 / 4 + 7);
    CHECK(value(coupled.graph, coupled.structure.inverse_mass[1], at) == 5);
    CHECK(value(coupled.graph, by_conjugates(coupled)[1], at) == 5 + 3);
}

TEST_CASE("what sin^2 + cos^2 and cosh^2 - sinh^2 hide") {
    const auto two = [](const std::string& H) { return analysed(H, "a, b", "pa, pb").structure; };
    CHECK(two("(pa*cos(b))^2/2+(pa*sin(b))^2/2+pb^2/2+a^2*b^2").kinetic_is_quadratic);
    CHECK(two("pa^2*(cosh(b)^2-sinh(b)^2)/2+pb^2/2").is_quadratic);
    CHECK(two("pa^2*cosh(a*b)^2-pa^2*sinh(a*b)^2+pb^2").is_quadratic);
    // Twice: sin(a)^2 cos(b)^2 + sin(a)^2 sin(b)^2 + cos(a)^2.
    CHECK(two("pa^2*((sin(a)*cos(b))^2+(sin(a)*sin(b))^2+cos(a)^2)+pb^2").is_quadratic);

    CHECK_FALSE(two("pa^2*(cos(b)^2+2*sin(b)^2)+pb^2").is_separable);
    CHECK_FALSE(two("pa^2*(cos(b)^2+sin(a)^2)+pb^2").is_separable);
    CHECK_FALSE(two("pa^2*(cos(b)^2-sin(b)^2)+pb^2").is_separable);
    CHECK_FALSE(two("pa^2*(cosh(b)^2+sinh(b)^2)+pb^2").is_separable);
    CHECK_FALSE(two("pa^2*sinh(b)^2-pa^2*cosh(a)^2+pb^2").is_separable);
    // 1 - 2 sin^2 + ... of products of three: only one pair goes.
    CHECK_FALSE(two("pa^2*(cos(b)^2+sin(b)^2+sin(b)^2)+pb^2").is_separable);
}

TEST_CASE("what has kinks is neither linear nor quadratic, whatever its second derivatives are") {
    const Structure size = analysed("abs(p)+q^2/2").structure;
    CHECK(size.is_separable);
    CHECK_FALSE(size.kinetic_is_quadratic);
    CHECK_FALSE(size.is_linear_in_p);
    CHECK_FALSE(size.is_quadratic);
    CHECK_FALSE(size.has_linear_map);

    const Structure halves = analysed("if(p<0,p^2/2,p^2)+q^2/2").structure;
    CHECK(halves.is_separable);
    CHECK_FALSE(halves.kinetic_is_quadratic);

    const Structure lines = analysed("p^2/2+max(q,2*q)").structure;
    CHECK(lines.kinetic_is_quadratic);
    CHECK_FALSE(lines.is_quadratic);
    CHECK_FALSE(lines.is_linear_in_q);

    CHECK_FALSE(analysed("min(p*q,1)").structure.is_separable);
    CHECK(analysed("p^2/2+abs(w)*q^2/2").structure.is_quadratic);
    CHECK(analysed("p^2/2+min(w,2)*q").structure.has_linear_map);
}

TEST_CASE("second derivatives are zero in both orders, or in none") {
    // q1 q2/q2 is q1: its second derivatives are zero, and one order of them says so at once.
    for (const char* term : {"q1*q2/q2", "q2*q1/q2", "q1*q2^2/q2^2", "q1*exp(q2)/exp(q2)",
                             "p1*p2/p2", "q1*q2*q2/q2*q1/q1"}) {
        const System system = analysed("p1^2/2+p2^2/2-" + std::string(term), "q1, q2", "p1, p2");
        for (const HessianBlock* block : {&hessian_of(system).qq, &hessian_of(system).conjugates})
            CHECK((*block)[0][1].is_zero() == (*block)[1][0].is_zero());
    }
}
