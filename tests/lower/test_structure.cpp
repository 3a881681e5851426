// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/lower/joint_gradient.hpp"
#include "generator/lower/structure.hpp"
#include "tests/lower/evaluate.hpp"
#include "tests/read/refusal.hpp"

using namespace hvi::gen;

namespace {

struct Analysed {
    SystemGraph system;
    Structure found;
};

Analysed analysed(const std::string& H, const std::string& coordinates = "q",
                  const std::string& momenta = "p") {
    const Hamiltonian hamiltonian =
        hamiltonian_from_text(source(H), source(coordinates), source(momenta));
    Analysed result{system_graph(hamiltonian, parameter_names(hamiltonian)), {}};
    result.found = structure(result.system);
    return result;
}

}  // namespace

TEST_CASE("separable Hamiltonians, and those with quadratic kinetic energy") {
    const Structure pendulum = analysed("p^2/(2*m)-cos(q)").found;
    CHECK(pendulum.is_separable);
    CHECK(pendulum.kinetic_is_quadratic);
    CHECK_FALSE(pendulum.is_quadratic);

    const Structure relativistic = analysed("sqrt(1+p^2)-cos(q)").found;
    CHECK(relativistic.is_separable);
    CHECK_FALSE(relativistic.kinetic_is_quadratic);

    const Structure magnetic = analysed("(p-q)^2/2").found;
    CHECK_FALSE(magnetic.is_separable);
    CHECK_FALSE(magnetic.kinetic_is_quadratic);
    CHECK(magnetic.is_quadratic);

    // The mass depends on the place.
    const Structure pendulums = analysed("p^2/(2*(1+q^2))").found;
    CHECK_FALSE(pendulums.is_separable);
    CHECK_FALSE(pendulums.kinetic_is_quadratic);
}

TEST_CASE("quadratic and degenerate Hamiltonians") {
    CHECK(analysed("p^2/2+w^2*q^2/2").found.is_quadratic);
    CHECK(analysed("q*p").found.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+q^3").found.is_quadratic);
    CHECK(analysed("q*p").found.is_linear_in_p);
    CHECK(analysed("q*p").found.is_linear_in_q);
    CHECK(analysed("sin(q)*p").found.is_linear_in_p);
    CHECK_FALSE(analysed("sin(q)*p").found.is_linear_in_q);
    CHECK_FALSE(analysed("p^2/2").found.is_linear_in_p);
}

TEST_CASE("quadratic in a disguise that exact arithmetic sees through") {
    const Analysed quotient = analysed("p^2/2+(q^4-1)/(q^2-1)");
    CHECK(quotient.found.is_quadratic);
    CHECK_FALSE(varies(quotient.system.graph.at(quotient.found.qq[0][0].node).roles));
    CHECK(value(quotient.system.graph, quotient.found.qq[0][0], {}) == 2);
    CHECK(analysed("exp(q)*exp(-q)*p^2").found.is_quadratic);
    CHECK(analysed("sin(2*q)-2*sin(q)*cos(q)+p^2").found.is_quadratic);
    CHECK(analysed("(p^2+q^2)*sqrt(k)^2").found.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+(q^4-1)/(q^2+1)+1e-60*q^4").found.is_quadratic);
    CHECK_FALSE(analysed("(sin(q)^2+cos(q)^2*(1+1e-40))*p^2/2").found.is_quadratic);
}

TEST_CASE("an H that depends on time has another form at each time") {
    CHECK(analysed("p^2/2+q^2/2").found.has_linear_map);
    CHECK(analysed("p^2/2+q^2/2+q*t").found.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+q^2/2+q*t").found.has_linear_map);
    CHECK_FALSE(analysed("p^2/2+(1+t)*q^2/2").found.is_quadratic);
    CHECK_FALSE(analysed("p^2/2+q^2/2+sin(t)").found.has_linear_map);
}

TEST_CASE("the first derivatives of a quadratic H at the origin") {
    const Analysed shifted = analysed("(p-q-a)^2/2+3*q+p*q");
    REQUIRE(shifted.found.is_quadratic);
    const Values at{{"a", 2}, {"p", 5}, {"q", 7}};
    CHECK(value(shifted.system.graph, shifted.found.by_q[0], at) == 2 + 3);
    CHECK(value(shifted.system.graph, shifted.found.by_p[0], at) == -2);
    CHECK(analysed("q*p").found.by_q[0].is_zero());
}

TEST_CASE("both gradients at once, where that is likely to cost less") {
    const auto pays = [](const std::string& H, const std::string& q, const std::string& p) {
        const Analysed analysis = analysed(H, q, p);
        return joint_gradient_pays(analysis.system, gradient_kernels(analysis.system));
    };
    // Few operations: the sums of the stages are waited for once, not twice.
    CHECK(pays("(q^2+1)*(p^2+1)/2", "q", "p"));
    // All of dH/dq and dH/dp is made of the same four functions of q and p.
    CHECK(pays("log((a-b)^2+(c-d)^2)+sin(a*c+b*d)", "a, b", "c, d"));
    // What dH/dp takes from q, dH/dq has left.
    CHECK_FALSE(pays("(a^2+b^2-a*b*cos(x-y))/(1+sin(x-y)^2)-cos(x)-cos(y)", "x, y", "a, b"));
    CHECK_FALSE(pays("(p+sin(q))^2/2+exp(q)", "q", "p"));
}

TEST_CASE("what H does not depend on") {
    CHECK(analysed("p^2/2").found.cyclic == std::vector<std::size_t>{0});
    CHECK(analysed("p^2/2+q-q").found.cyclic == std::vector<std::size_t>{0});
    CHECK(analysed("p^2/2+q").found.cyclic.empty());
}

TEST_CASE("the inverse mass times the momenta, without what is linear in T") {
    const Analysed coupled = analysed("pa^2/m+pa*pb+3*pb+cos(a-b)", "a, b", "pa, pb");
    REQUIRE(coupled.found.kinetic_is_quadratic);
    const Values at{{"m", 4}, {"pa", 5}, {"pb", 7}, {"a", 0}, {"b", 0}};
    CHECK(value(coupled.system.graph, coupled.found.inverse_mass[0], at) == 2.0L * 5 / 4 + 7);
    CHECK(value(coupled.system.graph, coupled.found.inverse_mass[1], at) == 5);
    CHECK(value(coupled.system.graph, coupled.system.dHdp[1], at) == 5 + 3);
}

TEST_CASE("what sin^2 + cos^2 and cosh^2 - sinh^2 hide") {
    const auto two = [](const std::string& H) { return analysed(H, "a, b", "pa, pb").found; };
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
