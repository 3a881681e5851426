// Finds the method that a tableau is, or was meant to be.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/certify/audit.hpp"

using namespace hvi::gen;

namespace {

/// `lobatto:3`, with the matrices where they are not its own: `lobatto:3 A A`.
std::string meant(const Audit& found) {
    if (!found.rebuilt) { return "nothing"; }
    if (!found.rebuilt->tableau) { return "partner"; }
    const Tableau& tableau = *found.rebuilt->tableau;
    const auto name = [](Matrix which) { return which == Matrix::A ? " A" : " A~"; };
    const std::string pair = found.rebuilt->is_method() ? ""
                                                        : std::string(name(found.rebuilt->A)) +
                                                              name(found.rebuilt->A_tilde);
    return (tableau.provenance.name.empty() ? "collocation" : tableau.provenance.name) + pair;
}

std::string number_text(const Number& number, int digits) {
    const auto rational = number.closed_form();
    return digits == 0 ? to_text(rational.value()) : number.decimal(digits);
}

/// c, b, A and perhaps A~ of a method, exact or in so many digits.
std::string as_json(const Tableau& tableau, int digits = 0, bool with_partner = true) {
    const auto vector = [&](const NumberVector& numbers) {
        std::string text;
        for (const Number& entry : numbers) {
            text += (text.empty() ? "\"" : ", \"") + number_text(entry, digits) + "\"";
        }
        return "[" + text + "]";
    };
    const auto matrix = [&](const NumberMatrix& rows) {
        std::string text;
        for (const NumberVector& row : rows) { text += (text.empty() ? "" : ", ") + vector(row); }
        return "[" + text + "]";
    };
    return "{\"c\": " + vector(tableau.c) + ", \"b\": " + vector(tableau.b) +
           ", \"A\": " + matrix(tableau.A) +
           (with_partner ? ", \"A_tilde\": " + matrix(tableau.A_tilde) : "") + "}";
}

}  // namespace

TEST_CASE("named methods are found by their coefficients") {
    for (const std::string name : {"stormer-verlet", "trig3", "gauss:2", "gauss:4", "lobatto:4",
                                   "radau-left:2", "radau-right:3", "newton-cotes:4", "chebyshev:4",
                                   "newton-cotes-open:4", "clenshaw-curtis:4", "fejer:3"}) {
        CAPTURE(name);
        const Audit found = audit_of(as_json(tableau(name)), 4);
        CHECK(meant(found) == name);
        CHECK(found.rebuilt->wrong.empty());
        CHECK(found.rebuilt->proved);
        CHECK_FALSE(found.rebuilt->places);
        CHECK(found.certificate.is_proved());
    }
    CHECK(meant(audit_of(R"({"A": [["1/2"]], "b": [1], "c": ["1/2"]})")) == "midpoint");
    // The name that the file gives itself is preferred, if it is one of those.
    CHECK(meant(audit_of(R"({"name": "fejer:1", "A": [["1/2"]], "b": [1], "c": ["1/2"]})")) ==
          "fejer:1");
    CHECK(meant(audit_of(R"({"name": "trig3", "A": [["1/2"]], "b": [1], "c": ["1/2"]})")) ==
          "midpoint");
}

TEST_CASE("decimals are enough, as many as there are") {
    for (const int digits : {6, 8, 15, 16, 17, 30, 50}) {
        CAPTURE(digits);
        const Audit found = audit_of(as_json(tableau("gauss:8"), digits), 4);
        CHECK(meant(found) == "gauss:8");
        CHECK(found.rebuilt->wrong.empty());
        CHECK_FALSE(found.rebuilt->proved);
        CHECK(found.rebuilt->places.value() >= digits - 1);
        CHECK(found.digits == digits);
    }
    CHECK(meant(audit_of(gauss_3)) == "gauss:3");
    CHECK(meant(audit_of(gauss_3_of_python)) == "gauss:3");
    CHECK(audit_of(gauss_3_of_python).rebuilt->wrong.empty());
    CHECK(audit_of(gauss_3_of_python).rebuilt->places == 16);
}

TEST_CASE("every entry that is off is listed with the right one") {
    const Audit sign = audit_of(replaced(lobatto_3, "\"-1/6\"", "\"1/6\""));
    CHECK(meant(sign) == "lobatto:3");
    CHECK(wrong_entries(sign) == "A_tilde[1][2]: -1/6");
    CHECK(sign.rebuilt->wrong.front().given == "1/6");
    CHECK(sign.rebuilt->places == 0);
    const Audit digit = audit_of(replaced(gauss_3, "-0.0359766675249389", "-0.0359766675279389"));
    CHECK(meant(digit) == "gauss:3");
    CHECK(wrong_entries(digit) == "A[1][2]: 2/9-sqrt(15)/15");
    CHECK(digit.rebuilt->wrong.front().given == "-0.0359766675279389");
    CHECK(digit.rebuilt->places == 11);
    const Audit last = audit_of(replaced(gauss_3, "0.4444444444444444", "0.4444444444444446"));
    CHECK(wrong_entries(last) == "b[2]: 4/9");
    CHECK(last.rebuilt->places == 15);
    const Audit node = audit_of(replaced(gauss_3, "0.1127016653792583", "0.1127106653792583"));
    CHECK(wrong_entries(node) == "c[1]: 1/2-sqrt(15)/10");
    const Audit weight =
        audit_of(R"({"A": [["1/2"]], "b": [1], "b_tilde": ["0.9"], "c": ["1/2"]})");
    CHECK(wrong_entries(weight) == "b_tilde[1]: 1");
}

TEST_CASE("an exact entry is wrong by any difference, a decimal by more than half a unit") {
    const std::string exact = as_json(tableau("gauss:3"));
    CHECK(wrong_entries(audit_of(replaced(exact, "\"c\": [\"1/2-sqrt(15)/10\"",
                                          "\"c\": [\"1/2-sqrt(15)/10+10^-60\""))) ==
          "c[1]: 1/2-sqrt(15)/10");
    const Tableau gauss = tableau("gauss:6");  // without closed forms
    const std::string thirty = as_json(gauss, 30, false);
    const std::string node = "\"c\": [\"" + gauss.c[0].decimal(30);
    CHECK(audit_of(thirty, 2).rebuilt->wrong.empty());
    std::string other = node;
    other.back() = other.back() == '9' ? '8' : static_cast<char>(other.back() + 1);
    const Audit found = audit_of(replaced(thirty, node, other), 2);
    CHECK(meant(found) == "gauss:6");
    CHECK(wrong_entries(found) == "c[1]: " + gauss.c[0].decimal(10));
}

TEST_CASE("A and A~ can stand for each other") {
    const std::string A = R"("A": [[0, 0, 0], ["5/24", "1/3", "-1/24"], ["1/6", "4/6", "1/6"]])";
    const std::string B = R"([["1/6", "-1/6", 0], ["1/6", "1/3", 0], ["1/6", "5/6", 0]])";
    const std::string head = R"({"c": [0, "1/2", 1], "b": ["1/6", "2/3", "1/6"], )";
    CHECK(meant(audit_of(head + A + "}")) == "lobatto:3 A A");                // Lobatto IIIA
    CHECK(meant(audit_of(head + "\"A\": " + B + "}")) == "lobatto:3 A~ A~");  // Lobatto IIIB
    CHECK(meant(audit_of(head + "\"A\": " + B + ", \"A_tilde\": " + B + "}")) == "lobatto:3 A~ A~");
    const std::string exchanged =
        R"({"c": [0, "1/2", 1], "b": ["1/6", "2/3", "1/6"], "A": )" + B +
        R"(, "A_tilde": [[0, 0, 0], ["5/24", "1/3", "-1/24"], ["1/6", "2/3", "1/6"]]})";
    const Audit found = audit_of(exchanged);
    CHECK(meant(found) == "lobatto:3 A~ A");
    CHECK(found.certificate.symplectic.holds);
    // The misprint of the paper is the trapezoidal rule.
    CHECK(meant(audit_of(printed_example_4_5)) == "stormer-verlet A A");
}

TEST_CASE("stages may stand in any order") {
    const Audit found = audit_of(R"({"c": [1, 0], "b": ["1/2", "1/2"],
        "A": [["1/2", "1/2"], [0, 0]], "A_tilde": [[0, "1/2"], [0, "1/3"]]})");
    CHECK(meant(found) == "stormer-verlet");
    CHECK(wrong_entries(found) == "A_tilde[2][2]: 1/2");
}

TEST_CASE("collocation at nodes without a name") {
    const Tableau collocation = tableau("monomials:3 | 0, 1/3, 6/7");
    const Audit exact = audit_of(as_json(collocation));
    CHECK(meant(exact) == "collocation");
    CHECK(exact.rebuilt->proved);
    CHECK(exact.rebuilt->tableau->provenance.origin ==
          "--basis \"monomials:3\" --nodes \"0, 1/3, 6/7\"");
    const Audit rounded = audit_of(as_json(collocation, 16));
    CHECK(meant(rounded) == "collocation");
    CHECK(rounded.rebuilt->wrong.empty());
    CHECK_FALSE(rounded.rebuilt->determined);
    CHECK_FALSE(rounded.certificate.is_proved());
    const std::string entry = collocation.A[1][2].decimal(16);
    std::string misprint = entry;
    misprint[8] = misprint[8] == '9' ? '8' : '9';
    const Audit wrong = audit_of(replaced(as_json(collocation, 16), entry, misprint));
    CHECK(meant(wrong) == "collocation");
    CHECK(wrong_entries(wrong) == "A[2][3]: " + collocation.A[1][2].decimal(10));
    // Another basis gives another A; then A~ is compared with the partner of A.
    const Tableau other = tableau("1, exp(tau), exp(2*tau) | 0, 1/3, 6/7");
    CHECK(meant(audit_of(as_json(other))) == "partner");
    CHECK(audit_of(as_json(other)).rebuilt->wrong.empty());
    const std::string partner = other.A_tilde[1][2].decimal(16);
    misprint = partner;
    misprint[9] = misprint[9] == '9' ? '8' : '9';
    const Audit off = audit_of(replaced(as_json(other, 16), partner, misprint));
    CHECK(meant(off) == "partner");
    CHECK(wrong_entries(off) == "A_tilde[2][3]: " + other.A_tilde[1][2].decimal(10));
}

TEST_CASE("what resembles nothing is not said to be meant as something") {
    CHECK(meant(audit_of(kutta_4)) == "nothing");
    // Kutta's third-order rule has the nodes and weights of lobatto:3.
    CHECK(meant(audit_of(R"({"c": [0, "1/2", 1], "b": ["1/6", "2/3", "1/6"],
        "A": [[0, 0, 0], ["1/2", 0, 0], [-1, 2, 0]]})")) == "nothing");
    CHECK(meant(audit_of(R"({"c": [0, "1/2"], "b": [0, 1], "A": [[0, 0], ["1/2", 0]]})")) ==
          "nothing");
    CHECK(meant(audit_of(R"({"c": ["w"], "b": [1], "A": [["w"]]})")) == "nothing");
    CHECK(meant(audit_of(R"({"c": [3], "b": [7], "A": [[5]], "A_tilde": [[11]]})")) == "nothing");
}
