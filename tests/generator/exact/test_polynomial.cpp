// Polynomials over Q, and their real roots.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/algebra/polynomial.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

using Texts = std::vector<std::string>;

/// From the constant upwards.
RationalPolynomial polynomial(const Texts& coefficients) {
    RationalPolynomial result;
    for (std::size_t k = 0; k < coefficients.size(); ++k)
        result.set_coefficient(static_cast<long>(k), coefficients[k]);
    return result;
}

Texts coefficients(const RationalPolynomial& polynomial) {
    Texts result;
    for (long k = 0; k <= polynomial.degree(); ++k) result.push_back(polynomial.coefficient(k));
    return result;
}

std::vector<std::string> roots(const RationalPolynomial& polynomial) {
    return on_new_ground(
        [&](const Ground& ground) { return texts(real_roots(polynomial, ground)); });
}

std::vector<std::string> decimal_roots(const RationalPolynomial& polynomial, int digits) {
    return on_new_ground([&](const Ground& ground) {
        std::vector<std::string> result;
        for (const Number& root : real_roots(polynomial, ground))
            result.push_back(root.decimal(digits));
        return result;
    });
}

}  // namespace

TEST_CASE("the polynomials of Chebyshev's quadrature with equal weights") {
    // (4.20), made monic, and beyond
    const std::vector<Texts> G{
        {"1"},
        {"0", "1"},
        {"-1/3", "0", "1"},
        {"0", "-1/2", "0", "1"},
        {"1/45", "0", "-2/3", "0", "1"},
        {"0", "7/72", "0", "-5/6", "0", "1"},
        {"-1/105", "0", "1/5", "0", "-1", "0", "1"},
        {"0", "-149/6480", "0", "119/360", "0", "-7/6", "0", "1"},
        {"-43/42525", "0", "-148/2835", "0", "22/45", "0", "-4/3", "0", "1"},
        {"0", "53/22400", "0", "-57/560", "0", "27/40", "0", "-3/2", "0", "1"}};
    for (unsigned s = 0; s < G.size(); ++s) CHECK(coefficients(chebyshev_equal_weights(s)) == G[s]);
}

TEST_CASE("Legendre's polynomials") {
    CHECK(coefficients(legendre(0)) == Texts{"1"});
    CHECK(coefficients(legendre(1)) == Texts{"0", "1"});
    CHECK(coefficients(legendre(2)) == Texts{"-1/2", "0", "3/2"});
    CHECK(coefficients(legendre(4)) == Texts{"3/8", "0", "-15/4", "0", "35/8"});
    CHECK(coefficients(legendre(5)) == Texts{"0", "15/8", "0", "-35/4", "0", "63/8"});
}

TEST_CASE("arithmetic of polynomials") {
    const RationalPolynomial p = polynomial({"1", "-2", "3"});
    const RationalPolynomial x = RationalPolynomial::variable();
    CHECK(coefficients(p + x) == Texts{"1", "-1", "3"});
    CHECK(coefficients(p - p).empty());
    CHECK((p - p).degree() == -1);
    CHECK(coefficients(p * x) == Texts{"0", "1", "-2", "3"});
    CHECK(coefficients(p.derivative()) == Texts{"-2", "6"});
    CHECK(coefficients(p.at_affine(2, -1)) == Texts{"6", "-16", "12"});
}

TEST_CASE("roots that are written with square roots") {
    CHECK(roots(polynomial({"-1", "3"})) == Texts{"1/3"});
    CHECK(roots(polynomial({"-1", "-1", "1"})) == Texts{"1/2-sqrt(5)/2", "1/2+sqrt(5)/2"});
    CHECK(same(roots(polynomial({"1", "0", "-10", "0", "1"})),
               {"-sqrt(3)-sqrt(2)", "sqrt(2)-sqrt(3)", "sqrt(3)-sqrt(2)", "sqrt(3)+sqrt(2)"}));
    CHECK(roots(polynomial({"-2", "0", "0", "0", "1"})) ==
          Texts{"-sqrt(sqrt(2))", "sqrt(sqrt(2))"});
    // P_4(2 tau - 1): a quartic in (tau - 1/2)^2
    CHECK(roots(legendre(4).at_affine(2, -1)) ==
          Texts{"1/2-sqrt(525+70*sqrt(30))/70", "1/2-sqrt(525-70*sqrt(30))/70",
                "1/2+sqrt(525-70*sqrt(30))/70", "1/2+sqrt(525+70*sqrt(30))/70"});
}

TEST_CASE("each real root once, ascending, and no complex ones") {
    const RationalPolynomial square = polynomial({"1/4", "-1", "1"});  // (x - 1/2)^2
    CHECK(roots(square * polynomial({"-2", "0", "1"})) == Texts{"-sqrt(2)", "1/2", "sqrt(2)"});
    CHECK(roots(square * square) == Texts{"1/2"});
    CHECK(roots(polynomial({"1", "0", "1"})).empty());
    CHECK(roots(polynomial({"1", "0", "0", "0", "1"})).empty());
    CHECK(roots(polynomial({"-1", "1", "-1", "1"})) == Texts{"1"});  // (x - 1)(x^2 + 1)
    CHECK(roots(polynomial({"5"})).empty());
}

TEST_CASE("enclosed roots") {
    // x^3 - 3x + 1: 2 cos(8 pi/9), 2 cos(4 pi/9), 2 cos(2 pi/9)
    const RationalPolynomial cubic = polynomial({"1", "-3", "0", "1"});
    CHECK(roots(cubic) == Texts{"none", "none", "none"});
    CHECK(decimal_roots(cubic, 30) == Texts{"-1.87938524157181676810821855465",
                                            "0.347296355333860697703433253539",
                                            "1.53208888623795607040478530111"});
    CHECK(roots(polynomial({"-2", "0", "0", "1"})) == Texts{"none"});
    CHECK(decimal_roots(polynomial({"-2", "0", "0", "1"}), 30) ==
          Texts{"1.25992104989487316476721060728"});
}

TEST_CASE("exact and enclosed roots in one order") {
    const RationalPolynomial mixed = polynomial({"1", "-3", "0", "1"}) * polynomial({"-1/3", "1"});
    CHECK(roots(mixed) == Texts{"none", "1/3", "none", "none"});
}

TEST_CASE("roots that are close to each other") {
    // (x^3 - 2)^2 - 10^-40: two real roots, 10^-20 apart
    const RationalPolynomial cubic = polynomial({"-2", "0", "0", "1"});
    const RationalPolynomial close = cubic * cubic - polynomial({"1/1" + std::string(40, '0')});
    const Texts found = decimal_roots(close, 25);
    REQUIRE(found.size() == 2);
    CHECK(found[0] == "1.259921049894873164765111");
    CHECK(found[1] == "1.259921049894873164769310");
}
