// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/hamiltonian.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

using Names = std::vector<std::string>;

Hamiltonian read_hamiltonian(const std::string& text) {
    return hamiltonian_from_text(source(text, "--hamiltonian"));
}

Hamiltonian read_hamiltonian(const std::string& text, const std::string& coordinates,
                             const std::string& momenta) {
    return hamiltonian_from_text(source(text, "--hamiltonian"),
                                 source(coordinates, "--coordinates"),
                                 source(momenta, "--momenta"));
}

Refusal refused_hamiltonian(const std::string& text) {
    return refusal([&] { return read_hamiltonian(text); });
}

Refusal refused_hamiltonian(const std::string& text, const std::string& coordinates,
                            const std::string& momenta) {
    return refusal([&] { return read_hamiltonian(text, coordinates, momenta); });
}

Method method(const std::string& basis) {
    return method_from_text(source(basis, "--basis"), source("0, 1", "--nodes"));
}

Refusal refused_parameter(const std::string& basis, const std::string& H, const std::string& text) {
    return refusal([&] {
        Method given = method(basis);
        Hamiltonian hamiltonian = read_hamiltonian(H);
        set_parameter(given, hamiltonian, parse_parameter(source(text, "--param")));
        return 0;
    });
}

std::string joined(const std::string& format, int count) {
    std::string text;
    for (int k = 1; k <= count; ++k) {
        std::string piece = format;
        piece.replace(piece.find('#'), 1, std::to_string(k));
        text += piece;
    }
    return text;
}

}  // namespace

TEST_CASE("q and p are taken as they stand") {
    const Hamiltonian H = read_hamiltonian("p^2/2 + w^2*q^2/2");
    CHECK(H.coordinates == Names{"q"});
    CHECK(H.momenta == Names{"p"});
    CHECK(parameter_names(H) == Names{"w"});
    CHECK(variables(H) == Names{"q", "p"});
    CHECK(H.degrees_of_freedom() == 1);
    CHECK(read_hamiltonian("q").momenta == Names{"p"});
    CHECK(read_hamiltonian("p").coordinates == Names{"q"});
}

TEST_CASE("numbered variables come in pairs, by their numbers") {
    const Hamiltonian H = read_hamiltonian("p10 + q2^2 + p2 + q1*q0 + q01 + p_1");
    CHECK(H.coordinates == Names{"q1", "q2", "q10"});
    CHECK(H.momenta == Names{"p1", "p2", "p10"});
    CHECK(parameter_names(H) == Names{"p_1", "q0", "q01"});
    CHECK(read_hamiltonian("q7").momenta == Names{"p7"});
    CHECK(read_hamiltonian("q99999999999999999999999").momenta ==
          Names{"p99999999999999999999999"});
}

TEST_CASE("variables by name, also such that do not occur") {
    const Hamiltonian H = read_hamiltonian("px^2/(2*m) + q", " x,  y ", "px, py");
    CHECK(H.coordinates == Names{"x", "y"});
    CHECK(H.momenta == Names{"px", "py"});
    CHECK(parameter_names(H) == Names{"m", "q"});
    CHECK(read_hamiltonian("1", "x", "p").degrees_of_freedom() == 1);
}

TEST_CASE("a Hamiltonian knows how it was given") {
    CHECK(read_hamiltonian(" p ^2/2").origin == "--hamiltonian \"p^2/2\"");
    CHECK(read_hamiltonian("x^2", " x,y", "px , py").origin ==
          "--hamiltonian \"x^2\" --coordinates \"x, y\" --momenta \"px, py\"");
}

TEST_CASE("every decimal means what is written") {
    CHECK(to_text(read_hamiltonian("0.1*q + 1e-3*p").expression) == "q/10+p/1000");
}

TEST_CASE("names of variables that cannot be") {
    CHECK(refused_hamiltonian("x", "pi", "p").marked == "[pi]");
    CHECK(refused_hamiltonian("x", "e", "p").helps("`ecc`"));
    CHECK(refused_hamiltonian("x", "x, t", "p, r").marked == "x, [t]");
    CHECK(refused_hamiltonian("x", "x", "h").helps("`height`"));
    CHECK(refused_hamiltonian("x", "tau", "p").helps("`tau_value`"));
    CHECK(refused_hamiltonian("x", "sin", "p").status == 2);
    CHECK(refused_hamiltonian("x", "x, y, x", "p, q, r").marked == "x, y, [x]");
    CHECK(refused_hamiltonian("x", "x, y", "p, p").says("named twice"));
    CHECK(refused_hamiltonian("x", "x, y", "p, x").marked == "p, [x]");
    CHECK(refused_hamiltonian("x", "x, y", "p, x").says("a coordinate already"));
    CHECK(refused_hamiltonian("x", "x, y", "p").says("2 coordinates and 1 momentum"));
    CHECK(refused_hamiltonian("x", "x", "p, q").says("1 coordinate and 2 momenta"));
    CHECK(refused_hamiltonian("x", "x, y", "p").name == "--momenta");
    CHECK(refused_hamiltonian("x", "2*x", "p").marked == "[2]*x");
    CHECK(refused_hamiltonian("x", "2", "p").says("a name is wanted here"));
    CHECK(refused_hamiltonian("x", "x", "gauss:2").marked == "gauss[:]2");
    CHECK(refused_hamiltonian("x", "_x", "p").says("no name for a coordinate"));
    CHECK(refused_hamiltonian("x", "", "p").status == 2);
    CHECK(refused_hamiltonian("x", "x", ",").status == 2);
}

TEST_CASE("which names are variables must be clear") {
    CHECK(refused_hamiltonian("x^2 + y^2").says("neither q and p"));
    CHECK(refused_hamiltonian("x^2 + y^2").helps("--coordinates"));
    CHECK(refused_hamiltonian("w^2").marked == "[w^2]");
    CHECK(refused_hamiltonian("p^2 + q1^2").marked == "p^2 + [q1]^2");
    CHECK(refused_hamiltonian("q1 + p2 + q").says("some have none"));
    CHECK(refused_hamiltonian("q^2", "q", "p").status == 0);
}

TEST_CASE("there are limits to what a Hamiltonian has") {
    CHECK(read_hamiltonian("0" + joined("+q#", 64)).degrees_of_freedom() == 64);
    CHECK(refused_hamiltonian("0" + joined("+q#", 257)).says("more than 256 degrees of freedom"));
    const std::string x = "x" + joined(",x#", 256);
    CHECK(refused_hamiltonian("x", x, x).says("more than 256 degrees of freedom"));
    CHECK(refused_hamiltonian("q" + joined("+a#", 64)).status == 0);
    CHECK(refused_hamiltonian("q" + joined("+a#", 65)).says("more than 64 parameters"));
    CHECK(refused_hamiltonian("sum(k=1..100, a[k]*cos(k*q))").status == 0);
    CHECK(refused_hamiltonian(std::string(70000, 'q')).says("64 KiB"));
    CHECK(refused_hamiltonian(std::string(300, '(')).says("nested"));
}

TEST_CASE("what cannot stand in a Hamiltonian") {
    CHECK(refused_hamiltonian("p^2 + cos(t[1])*q").marked == "p^2 + cos([t[1]])*q");
    CHECK(refused_hamiltonian("t").says("neither q and p"));
    CHECK(refused_hamiltonian("p^2 + h*q").marked == "p^2 + [h]*q");
    CHECK(refused_hamiltonian("q*tau").marked == "q*[tau]");
    CHECK(refused_hamiltonian("q + roots(q)").marked == "q + [roots(q)]");
    CHECK(refused_hamiltonian("bspline(1,0)*q").marked == "[bspline(1,0)]*q");
    CHECK(refused_hamiltonian("floor(q)").says("there is no function `floor`"));
    CHECK(refused_hamiltonian("q^2, p").marked == "q^2[,] p");
    CHECK(refused_hamiltonian("gauss:2").status == 2);
    CHECK(refused_hamiltonian("").status == 2);
    CHECK(refused_hamiltonian("p^2 + (q").marked == "p^2 + [(]q");
    CHECK(refused_hamiltonian("q + pi[1]").helps("`pi_value`"));
    CHECK(refused_hamiltonian("q + \xc3\x97").status == 2);
}

TEST_CASE("variables and parameters with an index") {
    const std::string text = "sum(i=1..2,p[i]^2/(2*m[i]))+k*x[1]*x[2]";
    const Hamiltonian H = read_hamiltonian(text, "x[1..2]", "p[1..2]");
    CHECK(to_text(H.expression) == "p[1]^2/(2*m[1])+p[2]^2/(2*m[2])+k*x[1]*x[2]");
    CHECK(variables(H) == Names{"x[1]", "x[2]", "p[1]", "p[2]"});
    CHECK(parameter_names(H) == Names{"k", "m[1]", "m[2]"});
    CHECK(H.origin ==
          "--hamiltonian \"" + text + "\" --coordinates \"x[1], x[2]\" --momenta \"p[1], p[2]\"");
    const Hamiltonian again = read_hamiltonian(text, "x[1], x[2]", "p[1], p[2]");
    CHECK(read_hamiltonian(to_text(H.expression), "x[1..2]", "p[1..2]").expression == H.expression);
    CHECK(again.expression == H.expression);
    CHECK(again.origin == H.origin);
    CHECK(refused_hamiltonian("x[3]", "x[1..2]", "p[1..2]").marked == "[x[3]]");
    CHECK(refused_hamiltonian("x[7]", "x[1..6]", "p[1..6]").help ==
          "the indices of `x` are from 1 to 6");
    CHECK(refused_hamiltonian("x[7]", "x[1..2], x[5]", "p[1..3]").help ==
          "the indices of `x` are 1, 2, 5");
    CHECK(refused_hamiltonian("x", "x[1..2]", "p[1..2]").what == "`x` wants an index");
    CHECK(refused_hamiltonian("q[1]*q").what == "`q` has no index");
    CHECK(refused_hamiltonian("sum(i=1..2, q[i]^2)").says("neither q and p"));
    CHECK(refused_hamiltonian("x[1]", "x[1], x[1..2]", "p[1..3]").marked == "x[1], [x[1..2]]");
    CHECK(refused_hamiltonian("x[1]", "pi[1..2]", "p[1..2]").says("reserved"));
    CHECK(refused_hamiltonian("x", "x, x[1]", "p, r").says("with an index and without"));
}

TEST_CASE("the time is neither a variable nor a parameter") {
    const Hamiltonian H = read_hamiltonian("p^2/2 - q*cos(w*t)");
    CHECK(depends_on_time(H));
    CHECK(variables(H) == Names{"q", "p"});
    CHECK(parameter_names(H) == Names{"w"});
    CHECK(!depends_on_time(read_hamiltonian("q*p")));
    CHECK(refused_hamiltonian("x*t", "t", "p").says("it is the time"));
    CHECK(refused_parameter("1, tau", "q*t", "t=1").says("it is the time"));
}

TEST_CASE("a parameter has its value wherever it occurs") {
    Method fitted = method("1, cos(w*tau)");
    Hamiltonian H = read_hamiltonian("p^2/(2*m) + w^2*q^2/2");
    CHECK_NOTHROW(check_together(fitted, H));
    set_parameter(fitted, H, parse_parameter(source("w=2")));
    set_parameter(fitted, H, parse_parameter(source("m=3")));
    REQUIRE(fitted.parameters.size() == 1);
    REQUIRE(H.parameters.size() == 2);
    CHECK(H.parameters[0].name == "w");
    CHECK(to_text(H.parameters[0].value) == "2");
    set_parameter(fitted, H, parse_parameter(source("w=1/3")));
    CHECK(to_text(H.parameters[0].value) == "1/3");
    CHECK(to_text(fitted.parameters[0].value) == "1/3");
}

TEST_CASE("values of what is no parameter") {
    CHECK(refused_parameter("1, tau", "p^2 + w*q", "v=1").marked == "[v]=1");
    CHECK(refused_parameter("1, tau", "p^2 + w*q", "v=1").helps("`w`"));
    CHECK(refused_parameter("1, tau", "p^2 + q", "omega=1").helps("there are no parameters"));
    CHECK(refused_parameter("1, tau", "p^2 + q", "q=1").says("a variable of the Hamiltonian"));
    CHECK(refused_parameter("1, cos(w*tau)", "p^2 + q", "w=1").status == 0);
}

TEST_CASE("a variable is no parameter of the method") {
    const Refusal both = refusal([] {
        check_together(method("1, cos(q*tau)"), read_hamiltonian("p^2 + q^2"));
        return 0;
    });
    CHECK(both.marked == "1, cos([q]*tau)");
    CHECK(both.status == 2);
    const Refusal node = refusal([] {
        check_together(method_from_text(source("1"), source("p/2", "--nodes")),
                       read_hamiltonian("p^2"));
        return 0;
    });
    CHECK(node.marked == "[p]/2");
}

TEST_CASE("a choice compares two values, and chooses one of two") {
    const auto read = [](const std::string& text) {
        return to_text(read_hamiltonian(text + "+p").expression);
    };
    CHECK(read("if(q < 1, q^2, 2*q-1)") == "if(q<1,q^2,2*q-1)+p");
    CHECK(read("if(q <= 1, q, 1)") == "if(q<=1,q,1)+p");
    CHECK(read("if(q > 1, q, 1)") == "if(1<q,q,1)+p");
    CHECK(read("if(q >= 1, q, 1)") == "if(1<=q,q,1)+p");
    CHECK(read("if(q<1,if(q<0,0,q),1)^2") == "if(q<1,if(q<0,0,q),1)^2+p");
    CHECK(read("min(q,2)*atan2(q,1)") == "min(q,2)*atan2(q,1)+p");
}

TEST_CASE("a choice that is none") {
    CHECK(refused_hamiltonian("p + if(q, 1, 2)").marked == "p + if(q[,] 1, 2)");
    CHECK(refused_hamiltonian("p + if(q, 1, 2)").says("wants a comparison first"));
    CHECK(refused_hamiltonian("p + if(q < 1, 2)").marked == "p + [if(q < 1, 2)]");
    CHECK(refused_hamiltonian("p + if(q < 1, 2)").says("a comparison and 2 values, not 1"));
    CHECK(refused_hamiltonian("p + if(q < 1, 2, 3, 4)").says("not 3"));
    CHECK(refused_hamiltonian("p + if(q < 1").marked == "p + if[(]q < 1");
    CHECK(refused_hamiltonian("p + if()").status == 2);
    CHECK(refused_hamiltonian("p + if(q < 1 < 2, 3, 4)").marked == "p + if(q < 1 [<] 2, 3, 4)");
    CHECK(refused_hamiltonian("p + if(q == 1, 3, 4)").marked == "p + if(q [=]= 1, 3, 4)");
    CHECK(refused_hamiltonian("p + (q < 1)").marked == "p + (q [<] 1)");
    CHECK(refused_hamiltonian("p >= q").marked == "p [>=] q");
    CHECK(refused_hamiltonian("p >= q").helps("if(a < b, x, y)"));
    CHECK(refused_hamiltonian("p + if*q").says("`if` is a function and wants an argument"));
    CHECK(refused_hamiltonian("min(q)+p").says("`min` takes 2 arguments, not 1"));
    CHECK(refused_hamiltonian("abs(q,p)").says("`abs` takes 1 argument, not 2"));
    CHECK(refused_hamiltonian("asinn(q)+p").helps("asin"));
    CHECK(refused_hamiltonian("q*p", "q, if", "p, r").says("`if` is reserved: it is a function"));
}
