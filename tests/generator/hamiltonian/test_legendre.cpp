// Legendre transforms, against those of textbooks.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/hamiltonian/legendre.hpp"
#include "generator/read/names.hpp"
#include "generator/read/unroll.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Lagrangian lagrangian(const std::string& text, const std::string& coordinates = "q",
                      const std::string& velocities = "v") {
    const auto of = source(text);
    return lagrangian_of(unrolled(parse_indexed_expression(of)), of,
                         unrolled(name_texts(source(coordinates))),
                         unrolled(name_texts(source(velocities))));
}

Hamiltonian of_momenta(const std::string& text, const std::string& coordinates = "q",
                       const std::string& momenta = "p") {
    return hamiltonian_from_text(source(text), source(coordinates), source(momenta));
}

/// At points where nothing is special.
void check_equal(const Expression& found, const std::string& expected) {
    const Expression other = unrolled(parse_indexed_expression(source(expected)));
    INFO(to_text(found) << "\nis to be " << expected);
    std::set<std::string> names{"t"};
    insert_parameters(found, names);
    insert_parameters(other, names);
    Real value = 0.37L;
    for (int round = 0; round < 5; ++round) {
        Point point;
        for (const std::string& name : names)
            point[name] = {value = 0.2L + std::fmod(value * 7.13L, 1.3L)};
        const Real wanted = evaluate(other, point).value;
        CHECK(std::abs(evaluate(found, point).value - wanted) < 1e-16L * (1 + std::abs(wanted)));
    }
}

const char* const double_pendulum =
    "(m1+m2)*l1^2*w1^2/2 + m2*l2^2*w2^2/2 + m2*l1*l2*w1*w2*cos(a1-a2)"
    " + (m1+m2)*g*l1*cos(a1) + m2*g*l2*cos(a2)";
const char* const double_pendulum_energy =
    "(m2*l2^2*p_a1^2 + (m1+m2)*l1^2*p_a2^2 - 2*m2*l1*l2*p_a1*p_a2*cos(a1-a2))"
    "/(2*m2*l1^2*l2^2*(m1 + m2*sin(a1-a2)^2)) - (m1+m2)*g*l1*cos(a1) - m2*g*l2*cos(a2)";

}  // namespace

TEST_CASE("Hamiltonians of Lagrangians") {
    const auto text = [](const Lagrangian& L) { return to_text(legendre_transform(L).expression); };
    CHECK(text(lagrangian("m*v^2/2 - U*q^4")) == "p_q^2/(2*m)+U*q^4");
    CHECK(text(lagrangian("m*l^2*(a^2 + sin(th)^2*b^2)/2 + m*g*l*cos(th)", "th, ph", "a, b")) ==
          "p_th^2/(2*l^2*m)+p_ph^2/(2*l^2*m*sin(th)^2)-g*l*m*cos(th)");
    // a bead on a hoop that turns about a vertical axis
    CHECK(text(lagrangian("m*R^2*(v^2 + W^2*sin(q)^2)/2 + m*g*R*cos(q)")) ==
          "p_q^2/(2*R^2*m)-R*g*m*cos(q)-R^2*W^2*m*sin(q)^2/2");
    check_equal(
        legendre_transform(lagrangian("m*(a^2+r^2*b^2)/2 + k/r", "r, ph", "a, b")).expression,
        "p_r^2/(2*m) + p_ph^2/(2*m*r^2) - k/r");
    check_equal(legendre_transform(lagrangian(double_pendulum, "a1, a2", "w1, w2")).expression,
                double_pendulum_energy);
    // a charge in a magnetic field, and a mass that grows with time
    check_equal(
        legendre_transform(lagrangian("m*(a^2+b^2)/2 + B*(x*b - y*a)/2 - k*x", "x, y", "a, b"))
            .expression,
        "((p_x + B*y/2)^2 + (p_y - B*x/2)^2)/(2*m) + k*x");
    check_equal(legendre_transform(lagrangian("exp(g*t)*(v^2 - q^2)/2")).expression,
                "exp(-g*t)*p_q^2/2 + exp(g*t)*q^2/2");
}

TEST_CASE("Lagrangians of Hamiltonians") {
    const auto text = [](const Hamiltonian& H) {
        return to_text(legendre_transform(H).expression);
    };
    CHECK(text(of_momenta("p^2/2 - cos(q)")) == "q_dot^2/2+cos(q)");
    CHECK(text(of_momenta("p^2*(1+q^2)/2")) == "q_dot^2/(2*(1+q^2))");
    check_equal(legendre_transform(of_momenta("(px^2+py^2)/2 - mu/sqrt(x^2+y^2)", "x, y", "px, py"))
                    .expression,
                "(x_dot^2 + y_dot^2)/2 + mu/sqrt(x^2+y^2)");
    // an oscillator seen from a frame that turns: the terms linear in p are Coriolis' force
    check_equal(
        legendre_transform(of_momenta("(px^2+py^2)/2 + w*(y*px-x*py) + k*x^2", "x, y", "px, py"))
            .expression,
        "((x_dot - w*y)^2 + (y_dot + w*x)^2)/2 - k*x^2");
    // no energy of a kinetic kind: H_pp is regular and indefinite
    check_equal(legendre_transform(of_momenta("px*py + x*y", "x, y", "px, py")).expression,
                "x_dot*y_dot - x*y");
    // the sines of its H are gone
    const Hamiltonian H = of_momenta(double_pendulum_energy, "a1, a2", "p_a1, p_a2");
    const std::string L = to_text(legendre_transform(H).expression);
    CHECK(L.find("sin") == std::string::npos);
    check_equal(legendre_transform(H).expression,
                to_text(renamed(lagrangian(double_pendulum, "a1, a2", "w1, w2").expression,
                                {{"w1", "a1_dot"}, {"w2", "a2_dot"}})));
}

TEST_CASE("there and back is where it began") {
    const Lagrangian L = lagrangian(
        "(2+cos(y))*a^2/2 + a*b*sin(x)/3 + b^2 + y*a - x^2*b - x*y + t*x", "x, y", "a, b");
    const Lagrangian back = legendre_transform(legendre_transform(L));
    CHECK(back.velocities == std::vector<std::string>{"x_dot", "y_dot"});
    check_equal(back.expression, to_text(renamed(L.expression, {{"a", "x_dot"}, {"b", "y_dot"}})));
    const Hamiltonian H = of_momenta("(1+q^4)*p^2 + q*p + w*q");
    const Hamiltonian again = legendre_transform(legendre_transform(H));
    check_equal(again.expression, to_text(renamed(H.expression, {{"p", "p_q"}})));
}

TEST_CASE("names that are taken are not given again") {
    CHECK(legendre_transform(of_momenta("p^2/2 + q_dot*q")).velocities.at(0) == "q_dot_");
    CHECK(momentum_names(lagrangian("v^2/2 + p_q*q")).at(0) == "p_q_");
    CHECK(momentum_names(lagrangian("v[1]^2+v[2]^2", "x[1..2]", "v[1..2]")) ==
          std::vector<std::string>{"p_x[1]", "p_x[2]"});
}

TEST_CASE("what is quadratic in disguise is quadratic") {
    check_equal(legendre_transform(lagrangian("(v^4-1)/(v^2-1)/2")).expression, "(p_q^2 - 1)/2");
    check_equal(legendre_transform(lagrangian("v^2/2 + v^3*(sin(q)^2+cos(q)^2-1)")).expression,
                "p_q^2/2");
}

TEST_CASE("degenerate Hamiltonians have no Lagrangian") {
    const auto refused = [](const Hamiltonian& H) {
        return refusal([&] { return legendre_transform(H); });
    };
    const Refusal zero = refused(of_momenta("q*p"));  // Leok & Zhang, Example 1.1
    CHECK(zero.what == "the associated Lagrangian is identically zero");
    CHECK(zero.marked == "[q*p]");
    CHECK(zero.status == 1);
    const Refusal line = refused(of_momenta("q*p + q^2"));
    CHECK(line.what == "the Hamiltonian is degenerate: H_pp has the rank 0 of 1");
    const Refusal flat = refused(of_momenta("(px*sin(x)+py*cos(x))^2/2", "x, y", "px, py"));
    CHECK(flat.what == "the Hamiltonian is degenerate: H_pp has the rank 1 of 2");
    CHECK(refused(of_momenta("px^2/2+(sin(x)^2+cos(x)^2-1)*py^2", "x, y", "px, py")).what ==
          "the Hamiltonian is degenerate: H_pp has the rank 1 of 2");
    const Refusal relativistic = refused(of_momenta("sqrt(p^2+1)"));
    CHECK(relativistic.says("H is not seen to be quadratic in the momenta"));
    CHECK(relativistic.status == 1);
    CHECK(relativistic.marked == "[sqrt(p^2+1)]");
}

TEST_CASE("Lagrangians that are not quadratic, or degenerate") {
    const auto refused = [](const Lagrangian& L) {
        return refusal([&] {
            check_regular(L);
            return 0;
        });
    };
    const Refusal cubic = refused(lagrangian("v^3 - q"));
    CHECK(cubic.what == "the Lagrangian is not seen to be quadratic in the velocities");
    CHECK(cubic.marked == "[v^3 - q]");
    CHECK(cubic.status == 1);
    CHECK(refused(lagrangian("-sqrt(1-v^2)")).status == 1);
    CHECK(refused(lagrangian("1/v")).status == 1);
    const Refusal flat = refused(lagrangian("(a+b)^2/2 - x*y", "x, y", "a, b"));
    CHECK(flat.what == "the Lagrangian is degenerate: its mass matrix d2L/dv2 has the rank 1 of 2");
    CHECK(flat.status == 1);
    CHECK(refused(lagrangian("(sin(x)*a+cos(x)*b)^2", "x, y", "a, b")).says("rank 1 of 2"));
    CHECK(refused(lagrangian("q*v")).says("has the rank 0 of 1"));
    CHECK(refused(lagrangian("v^2/2")).what.empty());
}

TEST_CASE("values of parameters take part") {
    Hamiltonian H = of_momenta("p^n/(2*m)");
    CHECK(refusal([&] { return legendre_transform(H); }).status == 1);
    assign(H.parameters, parse_parameter(source("n=2")));
    CHECK(to_text(legendre_transform(H).expression) == "m*q_dot^2/2");
}

TEST_CASE("a chain of eight pendulums is regular, and nobody writes out its determinant") {
    const auto term = [](int i, int j) {
        const std::string k = std::to_string(i), l = std::to_string(j);
        return "+" + std::to_string(9 - std::max(i, j)) + "*w[" + k + "]*w[" + l + "]*cos(a[" + k +
               "]-a[" + l + "])/2";
    };
    std::string terms;
    for (int i = 1; i <= 8; ++i)
        for (int j = 1; j <= 8; ++j) terms += term(i, j);
    const Lagrangian chain = lagrangian(terms, "a[1..8]", "w[1..8]");
    CHECK(refusal([&] {
              check_regular(chain);
              return 0;
          }).what.empty());
}

TEST_CASE("kinks in the coordinates stay, and in the fibre are refused") {
    const auto text = [](const Lagrangian& L) { return to_text(legendre_transform(L).expression); };
    CHECK(text(lagrangian("v^2/2 - abs(q)")) == "p_q^2/2+abs(q)");
    CHECK(text(lagrangian("v^2/2 + v*max(q,1)")).find("max(q,1)") != std::string::npos);
    const auto refused = [](const std::string& L) {
        return refusal([&] { return legendre_transform(lagrangian(L)); });
    };
    // Its third derivatives by v are 0 on both sides.
    CHECK(refused("if(v<0,v^2,v^2/2) - q^2").says("not seen to be quadratic"));
    CHECK(refused("v^2/2 + abs(v) - q^2").says("not seen to be quadratic"));
    // Regular where q > 0, and nowhere else.
    CHECK(refused("max(q,0)*v^2/2 - q^2").says("not seen to be quadratic"));
}
