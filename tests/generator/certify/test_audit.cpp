// Certificates of tableaux: exact, of the method that they are, or within their digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/certify/audit.hpp"

using namespace hvi::gen;

namespace {

bool has_orders(const Properties& found, int general, int separable, int nystrom) {
    const Orders& orders = found.orders;
    return orders.general.order == general && orders.separable.order == separable &&
           orders.nystrom.order == nystrom;
}

}  // namespace

TEST_CASE("the classical Runge-Kutta method") {
    const Audit found = audit_of(kutta_4);
    const Certificate& certificate = found.certificate;
    CHECK(has_orders(certificate, 4, 4, 4));
    CHECK(certificate.orders.general.failures.size() == 214);
    // sum b_i c_i^4 - 1/5
    CHECK(text(certificate.orders.general.failures.front().residual) == "1/120");
    CHECK_FALSE(certificate.symplectic.holds);
    CHECK_FALSE(certificate.symmetric.holds);
    CHECK(certificate.runge_kutta.holds);
    CHECK(certificate.common_weights.holds);
    CHECK(certificate.coupled_general.empty());
    CHECK(certificate.coupled_separable.empty());
    CHECK(certificate.is_proved());
    CHECK(certificate.origin == "--tableau t.json");
    CHECK(found.defect->i == 0);
    CHECK(text(found.defect->residual) == "-1/36");
    CHECK(found.c_is_sum_of_A.holds);
    CHECK(text(certificate.stability->stable.at(0).high) == "2*sqrt(2)");
}

TEST_CASE("the midpoint rule in decimals is exact") {
    const Audit found = audit_of(R"({"A": [[0.5]], "b": [1.0], "c": [0.5]})");
    CHECK(found.rounded == 0);
    CHECK(found.certificate.is_proved());
    CHECK(has_orders(found.certificate, 2, 2, 2));
    CHECK(found.certificate.conserves_quadratic());
}

TEST_CASE("Lobatto IIIA-IIIB, right and with a sign swapped") {
    const Audit right = audit_of(lobatto_3);
    CHECK(has_orders(right.certificate, 4, 4, 4));
    CHECK(right.certificate.symplectic.holds);
    CHECK(right.certificate.is_proved());
    CHECK_FALSE(right.defect);
    const Audit wrong = audit_of(replaced(lobatto_3, "\"-1/6\"", "\"1/6\""));
    CHECK(has_orders(wrong.certificate, 1, 1, 1));
    CHECK_FALSE(wrong.certificate.symplectic.holds);
    CHECK(wrong.certificate.is_proved());
    // b_1 times 1/3 in sum b_i a~_ij c_j^0 - 1/2
    const FailedCondition& first = wrong.certificate.orders.general.failures.front();
    CHECK(first.tree->text == "f[g]");
    CHECK(text(first.residual) == "1/18");
    CHECK(wrong.defect->i == 0);
    CHECK(wrong.defect->j == 1);
    CHECK(text(wrong.defect->residual) == "1/18");
    CHECK(wrong.c_is_sum_of_A.holds);
    CHECK_FALSE(wrong.c_is_sum_of_A_tilde.holds);
}

TEST_CASE("Example 4.5 as it is printed is no symplectic method") {
    const Audit found = audit_of(printed_example_4_5);
    CHECK_FALSE(found.certificate.symplectic.holds);
    CHECK(found.certificate.runge_kutta.holds);
    CHECK(has_orders(found.certificate, 2, 2, 2));
    CHECK_FALSE(found.certificate.coupled_separable.empty());
    CHECK(text(found.defect->residual) == "-1/4");
    // The trapezoidal rule is conjugate to the midpoint rule: on the oscillator its map has
    // determinant 1.
    CHECK(found.certificate.oscillator->determinant_one.holds);
    const Audit right =
        audit_of(replaced(printed_example_4_5, R"("A_tilde": [[0, 0], ["1/2", "1/2"]])",
                          R"("A_tilde": [["1/2", 0], ["1/2", 0]])"));
    CHECK(right.certificate.symplectic.holds);
    CHECK(right.certificate.coupled_separable.empty());
}

TEST_CASE("decimals of a known method have its certificate, within their digits") {
    for (const std::string& json : {gauss_3, gauss_3_of_python}) {
        const Audit found = audit_of(json);
        CHECK(found.certificate.within_digits);
        CHECK(found.is_known());
        CHECK(has_orders(found.certificate, 6, 6, 6));
        CHECK(found.certificate.symplectic.holds);
        CHECK(found.certificate.symmetric.holds);
        CHECK(found.certificate.runge_kutta.holds);
        CHECK(found.certificate.stability.has_value());
        CHECK_FALSE(found.certificate.is_proved());
        CHECK(found.certificate.origin == "--tableau t.json");
        CHECK(found.certificate.name.empty());
        REQUIRE(found.as_written);
        CHECK(found.as_written->orders.general.order <= 2);
        CHECK_FALSE(found.as_written->symplectic.holds);
        CHECK(found.c_is_sum_of_A.holds);
    }
}

TEST_CASE("the file of gauss:8 is found to be gauss:8, of order 16") {
    const std::string json = render_json(derive(method("gauss:8")), 50);
    const Audit found = audit_of(json, 16);
    CHECK(found.rounded == 144);
    CHECK(found.digits == 50);
    CHECK(found.is_known());
    CHECK(found.rebuilt->tableau->provenance.name == "gauss:8");
    CHECK(found.certificate.orders.general.order == 16);
    CHECK(found.certificate.orders.general.is_at_least);
    CHECK(found.certificate.within_digits);
    CHECK_FALSE(found.certificate.is_proved());
    // One wrong digit at the 45th place, and it is of order 1.
    const std::string digits = derive(method("gauss:8")).A[0][1].decimal(50);
    std::string wrong = digits;
    wrong[wrong.size() - 5] = wrong[wrong.size() - 5] == '9' ? '8' : '9';
    std::string other = json;  // A~ has the same entry
    other.replace(other.find(digits), digits.size(), wrong);
    const Audit off = audit_of(other, 16);
    CHECK(off.rebuilt->wrong.size() == 1);
    CHECK_FALSE(off.is_known());
    CHECK(off.certificate.orders.general.order == 1);
    CHECK_FALSE(off.certificate.symplectic.holds);
    CHECK(off.certificate.symplectic.proved);
}

TEST_CASE("a digit that is changed at the 12th place is found") {
    const Audit found = audit_of(replaced(gauss_3, "-0.0359766675249389", "-0.0359766675279389"));
    CHECK_FALSE(found.is_known());
    CHECK(has_orders(found.certificate, 1, 1, 1));
    CHECK_FALSE(found.certificate.symplectic.holds);
    CHECK(found.certificate.symplectic.proved);
    CHECK_FALSE(found.c_is_sum_of_A.holds);
    CHECK(found.c_is_sum_of_A.proved);
}

TEST_CASE("coefficients of no known method are looked at within their digits") {
    const Audit found = audit_of(composition_4);
    const Certificate& certificate = found.certificate;
    CHECK_FALSE(found.rebuilt);
    CHECK(certificate.within_digits);
    CHECK(has_orders(certificate, 4, 4, 4));
    CHECK(certificate.symplectic.holds);
    CHECK_FALSE(certificate.symplectic.proved);
    CHECK(certificate.symmetric.holds);
    CHECK(certificate.negative_weights == std::vector<std::size_t>{2});
    CHECK_FALSE(certificate.is_proved());
    CHECK_FALSE(certificate.oscillator);
    CHECK_FALSE(certificate.stability);
    REQUIRE(found.as_written);
    CHECK_FALSE(found.as_written->symplectic.holds);
}

TEST_CASE("where the digits behind would change nothing, what is written is proved") {
    // Dyadic fractions: the midpoint rule of weights 147/512 and 365/512.
    const Audit found = audit_of(R"({"c": [0.1435546875, 0.6435546875],
        "b": [0.287109375, 0.712890625],
        "A": [[0.1435546875, 0], [0.287109375, 0.3564453125]]})");
    CHECK(found.rounded > 0);
    CHECK_FALSE(found.certificate.within_digits);
    CHECK_FALSE(found.as_written);
    CHECK(has_orders(found.certificate, 2, 2, 2));
    CHECK(found.certificate.symplectic.holds);
    CHECK(found.certificate.is_proved());
    CHECK(found.certificate.stability.has_value());
}

TEST_CASE("weights of their own conserve linear invariants of q or of p alone") {
    const Audit found = audit_of(R"({"c": [0, 1], "b": ["1/2", "1/2"], "b_tilde": [0, 1],
        "A": [[0, 0], ["1/2", "1/2"]]})");
    CHECK_FALSE(found.certificate.common_weights.holds);
    CHECK_FALSE(found.certificate.symplectic.holds);
    CHECK_FALSE(found.certificate.runge_kutta.holds);
    CHECK(found.defect->i == 0);
    CHECK_FALSE(found.defect->j);
}

TEST_CASE("a parameter stays free, or gets a value") {
    Coefficients theta =
        coefficients_from_json({"t.json", R"({"A": [["w"]], "b": [1], "c": ["w"]})"});
    const Audit free = audit(theta, 4);
    CHECK(free.certificate.parameters == std::vector<std::string>{"w"});
    CHECK(has_orders(free.certificate, 1, 1, 1));
    CHECK_FALSE(free.certificate.stability);
    CHECK(text(free.defect->residual) == "2*w-1");
    set_parameter(theta, parse_parameter(source("w=1/2")));
    const Audit midpoint = audit(theta, 4);
    CHECK(midpoint.rebuilt->tableau->provenance.name == "midpoint");
    CHECK(has_orders(midpoint.certificate, 2, 2, 2));
}

TEST_CASE("what comes from tableau is certified as the method is") {
    for (const std::string name : {"trig3", "gauss:4", "lobatto:5", "chebyshev:3"}) {
        CAPTURE(name);
        const Tableau tableau = derive(method(name));
        const Audit found = audit_of(render_json(tableau, 50), 6);
        const Certificate direct = certify(tableau, 6);
        CHECK(found.certificate.is_proved());
        CHECK(found.certificate.orders.general.order == direct.orders.general.order);
        CHECK(found.certificate.name == name);
    }
    // And the same by the coefficients alone.
    const NodesAndMethod alone{derive(method("lobatto:4")).c,
                               partitioned_method(derive(method("lobatto:4")))};
    const Certificate by_coefficients = certify(alone, {}, 8);
    const Certificate by_polynomials = certify(derive(method("lobatto:4")), 8);
    CHECK(by_coefficients.is_proved());
    CHECK(has_orders(by_coefficients, 6, 6, 6));
    CHECK(texts(by_coefficients.oscillator->half_trace.numerator) ==
          texts(by_polynomials.oscillator->half_trace.numerator));
    CHECK(texts(by_coefficients.oscillator->half_trace.denominator) ==
          texts(by_polynomials.oscillator->half_trace.denominator));
}
