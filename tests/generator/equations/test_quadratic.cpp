// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/equations/quadratic.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

std::string text(const Number& number) { return to_text(number.closed_form().value()); }

/// The lower triangle of S row by row, g and the constant; or the obstacle; or `none`.
std::string form_of(const std::string& given, const std::vector<std::string>& values = {}) {
    Hamiltonian H = hamiltonian_from_text(source(given));
    Method method = named_method(source("midpoint"));
    for (const std::string& value : values)
        set_parameter(method, H, parse_parameter(source(value)));
    return on_new_ground([&](const Ground& ground) -> std::string {
        const QuadraticProof proof = quadratic_form(H, ground);
        if (!proof.form) return proof.obstacle.empty() ? "none" : proof.obstacle;
        std::string result;
        for (std::size_t i = 0; i < proof.form->S.size(); ++i) {
            for (std::size_t j = 0; j <= i; ++j) result += text(proof.form->S[i][j]) + " ";
            for (std::size_t j = 0; j <= i; ++j)
                CHECK((proof.form->S[i][j] - proof.form->S[j][i]).is_zero());
        }
        for (const Number& entry : proof.form->g) result += "| " + text(entry) + " ";
        return result + "| " + text(proof.form->constant);
    });
}

}  // namespace

TEST_CASE("quadratic Hamiltonians") {
    CHECK(form_of("p^2/2 + w^2*q^2/2") == "w^2 0 1 | 0 | 0 | 0");
    CHECK(form_of("(p^2+w^2*q^2)/2 + 0*sin(q)") == "w^2 0 1 | 0 | 0 | 0");
    CHECK(form_of("q*p") == "0 1 0 | 0 | 0 | 0");
    CHECK(form_of("p^2/(2*m) + g*m*q + a") == "0 0 1/m | g*m | 0 | a");
    CHECK(form_of("q") == "0 0 0 | 1 | 0 | 0");
    CHECK(form_of("q^3-q^3+p") == "0 0 0 | 0 | 1 | 0");
    CHECK(form_of("(q-a)^2*k/2 + (p+0.5)*(q-3)") == "k 1 0 | 1/2-a*k | -3 | a^2*k/2-3/2");
    CHECK(form_of("(q1+q2)^2*k/2 + p1^2/2 + p2^2/2") == "k k k 0 0 1 0 0 0 1 | 0 | 0 | 0 | 0 | 0");
}

TEST_CASE("quadratic Hamiltonians in disguise") {
    CHECK(form_of("(q^4-1)/(q^2-1) + p^2") == "2 0 2 | 0 | 0 | 1");
    CHECK(form_of("(sin(q)^2+cos(q)^2)*p^2/2") == "0 0 1 | 0 | 0 | 0");
    CHECK(form_of("exp(q)*exp(-q)*p^2 + (exp(q)+exp(-q))*0") == "0 0 2 | 0 | 0 | 0");
    CHECK(form_of("(q+p)^3 - q^3 - p^3 - 3*q*p*(q+p) + q^2/2") == "1 0 0 | 0 | 0 | 0");
    CHECK(form_of("sqrt(2)*sqrt(3)*q^3 - sqrt(6)*q^3 + q") == "0 0 0 | 1 | 0 | 0");
    CHECK(form_of("cosh(q)^2 - sinh(q)^2") == "0 0 0 | 0 | 0 | 1");
    CHECK(form_of("p^2/2 + sqrt(k)^2*q^2/2") == "k 0 1 | 0 | 0 | 0");
}

TEST_CASE("coefficients from every corner of the field") {
    CHECK(form_of("sqrt(2)*q^2 + pi*p + e") == "2*sqrt(2) 0 0 | 0 | pi | e");
    CHECK(form_of("exp(a)*q^2/2 + cos(b)*p") == "exp(a) 0 0 | 0 | cos(b) | 0");
    CHECK(form_of("w*q^2/2", {"w=1/3"}) == "1/3 0 0 | 0 | 0 | 0");
    CHECK(form_of("sqrt(k/m)*q^2/2", {"k=4", "m=2"}) == "sqrt(2) 0 0 | 0 | 0 | 0");
}

TEST_CASE("Hamiltonians that are not quadratic, or not proved to be") {
    for (const std::string given :
         {"p^2/2 - cos(q)", "p^2/2 + q^3/1e30", "q^4", "p^2/2 + 1e-40*q^3", "q*p^2", "1/q",
          "sqrt(q^2+p^2)", "sqrt(q^4)", "exp(q)", "p^2/2 + q^2/2 + c*q^2*p", "sin(q)^2+cos(p)^2",
          "(q^4-1)/(q^2+1) + q^4*0.001", "q^n", "log(exp(q^2))+log(q)"})
        CHECK(form_of(given) == "none");
    CHECK(form_of("(q^3+q^2)/q") == "H has no value for q = p = 0 as it is written");
}

TEST_CASE("what is nearly quadratic is not") {
    for (const std::string given :
         {"p^2/2 + q^2/2 + 1e-40*q^3", "q + 1e-30*sin(q)", "p^2 + q*p + exp(q/1e50)",
          "q^2 + 1e-60*p^4", "(sin(q)^2+cos(q)^2*(1+1e-40))*p^2/2"})
        CHECK(form_of(given) == "none");
}

TEST_CASE("a coefficient that has no place in the field is named") {
    CHECK(form_of("p^2/2 + sqrt(k/m)*q^2/2").find("the coefficient sqrt(k/m): ") == 0);
    CHECK(form_of("p^2/2 + atan(1/3)*q^2").find("the coefficient 2*atan(1/3): ") == 0);
}

TEST_CASE("many degrees of freedom") {
    std::string H = "0";
    for (int k = 1; k <= 64; ++k) {
        const std::string q = "q" + std::to_string(k);
        H += "+p" + std::to_string(k) + "^2/2+" + q + "^2/2";
        if (k > 1) H += "+(" + q + "-q" + std::to_string(k - 1) + ")^2*c";
    }
    CHECK(form_of(H).find("4*c+1") != std::string::npos);
}
