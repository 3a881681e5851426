// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/catalogue.hpp"
#include "generator/read/method.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Method named(const std::string& name) { return named_method(source(name, "--method")); }

Method of_lists(const std::string& basis, const std::string& nodes) {
    return method_from_text(source(basis, "--basis"), source(nodes, "--nodes"));
}

Refusal refused_method(const std::string& name) {
    return refusal([&] { return named(name); });
}

Refusal refused_method(const std::string& basis, const std::string& nodes) {
    return refusal([&] { return of_lists(basis, nodes); });
}

Refusal refused_parameter(const std::string& text) {
    return refusal([&] { return parse_parameter(source(text, "--param")); });
}

std::string item(const List& list, std::size_t index) {
    const Item& item = list.items.at(index);
    if (const auto* family = std::get_if<Family>(&item.what))
        return family->name + ":" + std::to_string(family->size);
    return to_text(std::get<Expression>(item.what));
}

}  // namespace

TEST_CASE("a family of methods has its nodes and polynomials") {
    const Method method = named("gauss:3");
    CHECK(method.name == "gauss:3");
    CHECK(method.origin == "--method gauss:3");
    CHECK(item(method.basis, 0) == "monomials:3");
    CHECK(item(method.nodes, 0) == "gauss:3");
    CHECK_FALSE(method.weights.has_value());
    CHECK(named(" gauss:03 ").name == "gauss:3");
}

TEST_CASE("the named methods of Examples 4.4 to 4.6") {
    const auto check = [](const std::string& name, const std::string& basis,
                          const std::string& nodes) {
        const Method method = named(name);
        CHECK(method.name == name);
        CHECK(method.origin == "--method " + name);
        const Method other = of_lists(basis, nodes);
        REQUIRE(method.nodes.items.size() == other.nodes.items.size());
        for (std::size_t k = 0; k < other.nodes.items.size(); ++k) {
            CHECK(item(method.basis, k) == item(other.basis, k));
            CHECK(item(method.nodes, k) == item(other.nodes, k));
        }
    };
    check("symplectic-euler", "1", "0");
    check("midpoint", "1", "1/2");
    check("adjoint-symplectic-euler", "1", "1");
    check("stormer-verlet", "1, cos(pi*tau)", "0, 1");
    check("trig3", "1, cos(pi*tau), sin(pi*tau)", "0, 1/2, 1");
}

TEST_CASE("every entry of the catalogue can be read") {
    for (const FamilyEntry& entry : node_families()) {
        CHECK(named(std::string(entry.name) + ":" + std::to_string(entry.smallest))
                  .nodes.items.size() == 1);
        CHECK(refused_method(std::string(entry.name) + ":" + std::to_string(entry.smallest - 1))
                  .status == 2);
    }
    for (const FamilyEntry& entry : basis_families())
        CHECK(of_lists(std::string(entry.name) + ":64", "0").basis.items.size() == 1);
    for (const MethodEntry& entry : named_methods())
        CHECK(named(std::string(entry.name)).name == entry.name);
}

TEST_CASE("names that there are not") {
    CHECK(refused_method("").status == 2);
    CHECK(refused_method("gaus:3").marked == "[gaus:3]");
    CHECK(refused_method("gaus:3").helps("`gauss`"));
    CHECK(refused_method("gauss").helps("`gauss:3`"));
    CHECK(refused_method("midpont").helps("`midpoint`"));
    CHECK(refused_method("xyz").helps("hvi-gen list methods"));
    CHECK(refused_method("midpoint:2").says("without a size"));
    CHECK(refused_method("monomials:3").status == 2);
    CHECK(refused_method("gauss:3 gauss:2").status == 2);
}

TEST_CASE("sizes that a family does not have") {
    for (const std::string name : {"newton-cotes:1", "lobatto:1", "clenshaw-curtis:1", "gauss:0",
                                   "gauss:65", "gauss:99999999999999999999", "chebyshev:65"}) {
        CHECK(refused_method(name).status == 2);
        CHECK(refused_method(name).says("S is out of range"));
        CHECK(refused_method(name).marked == "[" + name + "]");
    }
    for (const std::string name :
         {"gauss:-1", "gauss:x", "gauss:3.5", "gauss:", "gauss: ", "gauss:3:3"})
        CHECK(refused_method(name).status == 2);
}

TEST_CASE("Chebyshev nodes that are not real are a matter of mathematics") {
    for (const long size : {1, 2, 3, 4, 5, 6, 7, 9})
        CHECK(refused_method("chebyshev:" + std::to_string(size)).status == 0);
    for (const long size : {8, 10, 11, 64}) {
        CHECK(refused_method("chebyshev:" + std::to_string(size)).status == 1);
        CHECK(refused_method("1", "chebyshev:" + std::to_string(size)).status == 1);
    }
    CHECK(refused_method("chebyshev:8").says("not all real"));
    CHECK(refused_method("chebyshev:8").marked == "[chebyshev:8]");
}

TEST_CASE("basis functions and nodes by text") {
    const Method method = of_lists("1, cos( 0.5*tau )", "radau-left:2, roots(tau^2-1/3)");
    CHECK(method.name.empty());
    CHECK(method.origin == "--basis \"1, cos(tau/2)\" --nodes \"radau-left:2, roots(tau^2-1/3)\"");
    const Method weighted =
        method_from_text(source("1"), source("0, 1/2, 1"), source("1/6, 2/3, 1/6"));
    REQUIRE(weighted.weights.has_value());
    CHECK(weighted.weights->items.size() == 3);
    CHECK(weighted.origin == "--basis \"1\" --nodes \"0, 1/2, 1\" --weights \"1/6, 2/3, 1/6\"");
}

TEST_CASE("words that stand where they do not belong") {
    CHECK(refused_method("tau, gauss:3", "0").marked == "tau, [gauss:3]");
    CHECK(refused_method("tau, gauss:3", "0").helps("--nodes"));
    CHECK(refused_method("1", "trig:3").marked == "[trig:3]");
    CHECK(refused_method("1", "bogus:3").helps("gauss, lobatto"));
    CHECK(refused_method("1", "1/2+tau").marked == "1/2+[tau]");
    CHECK(refused_method("1", "1+roots(tau)").marked == "1+[roots(tau)]");
    CHECK(refused_method("1", "roots(roots(tau))").status == 2);
    CHECK(refused_method("roots(tau)", "0").status == 2);
    CHECK(refused_method("1", "bspline(2,1)").marked == "[bspline(2,1)]");
    CHECK(refused_method("bspline(2,1)", "0").status == 0);
    CHECK(refusal([] {
              return method_from_text(source("1"), source("0"), source("tau"));
          }).status == 2);
    CHECK(refusal([] {
              return method_from_text(source("1"), source("0"), source("gauss:1"));
          }).status == 2);
}

TEST_CASE("reserved names in basis functions") {
    CHECK(refused_method("1, t", "0").marked == "1, [t]");
    CHECK(refused_method("1, t", "0").helps("`tau`"));
    CHECK(refused_method("1, h*tau", "0").marked == "1, [h]*tau");
    CHECK(refused_method("1, exp(_a*tau)", "0").status == 2);
}

TEST_CASE("there are limits to what a method has") {
    CHECK(refused_method("monomials:64", "gauss:64").status == 0);
    CHECK(refused_method("monomials:40, trig:25", "0").marked == "monomials:40, [trig:25]");
    CHECK(refused_method("1", "gauss:64, 0").says("more than 64 nodes"));
    std::string sum = "a0*tau";
    for (int k = 1; k < 65; ++k) sum += "+a" + std::to_string(k) + "*tau";
    CHECK(refused_method("1," + sum, "0, 1").says("more than 64 parameters"));
}

TEST_CASE("parameters are the symbols that are left") {
    const Method method = of_lists("1, cos(w*tau), e^(-a*pi)", "0, c, roots(tau-b)");
    CHECK(parameter_names(method) == std::vector<std::string>{"a", "b", "c", "w"});
    CHECK(parameter_names(named("trig3")).empty());
}

TEST_CASE("a value is given to a parameter") {
    Method method = of_lists("1, cos(w*tau)", "0, 1");
    set_parameter(method, parse_parameter(source("w=2")));
    set_parameter(method, parse_parameter(source(" w = 2*pi ")));
    REQUIRE(method.parameters.size() == 1);
    CHECK(method.parameters[0].name == "w");
    CHECK(to_text(method.parameters[0].value) == "2*pi");
    CHECK(method.origin ==
          "--basis \"1, cos(w*tau)\" --nodes \"0, 1\" --param \"w=2\" --param \"w=2*pi\"");
    const Refusal unknown = refusal([&] {
        set_parameter(method, parse_parameter(source("v=2")));
        return 0;
    });
    CHECK(unknown.marked == "[v]=2");
    CHECK(unknown.helps("`w`"));
}

TEST_CASE("errors of --param") {
    CHECK(refused_parameter("w").helps("`w=2`"));
    CHECK(refused_parameter("w=").marked == "w[=]");
    CHECK(refused_parameter("=2").status == 2);
    CHECK(refused_parameter("e=1").marked == "[e]=1");
    CHECK(refused_parameter("e=1").helps("`ecc`"));
    CHECK(refused_parameter("w=2tau").marked == "w=2[tau]");
    CHECK(refused_parameter("w=v").marked == "w=[v]");
    CHECK(refused_parameter("w=tau").marked == "w=[tau]");
    CHECK(refused_parameter("w=roots(1)").status == 2);
    CHECK(refused_parameter("w=1,2").marked == "w=1[,]2");
    CHECK(refused_parameter("").status == 2);
    CHECK(refused_parameter("w=0:0.1:2").marked == "w=[0:0.1:2]");
    CHECK(refused_parameter("w= 1:2 ").marked == "w= [1:2] ");
    CHECK(refused_parameter("w=0:0.1:2").says("no range"));
    CHECK_FALSE(refused_parameter("w=0:0.1:2").helps("gauss"));
}

TEST_CASE("names of other programs are known") {
    for (const std::string name : {"verlet", "leapfrog", "velocity-verlet"})
        CHECK(named(name).name == "stormer-verlet");
    CHECK(named("implicit-midpoint").origin == "--method midpoint");
    CHECK(refused_method("rk4").helps("`gauss:2`"));
    CHECK(refused_method("rk4").helps("drifts"));
    CHECK(refused_method("forest-ruth").helps("`--compose yoshida:4`"));
    CHECK(refused_method("gauss-legendre:3").helps("`gauss:S`"));
    CHECK(refused_method("leapfrogs").helps("did you mean `leapfrog`?"));
}
