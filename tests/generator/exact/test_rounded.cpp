// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "generator/exact/methods/collocation.hpp"
#include "generator/exact/methods/given.hpp"
#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/exact/numbers/rounded.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

/// The decimal as any of the numbers that round to it.
Number rounded(const std::string& text, std::optional<double> spacing = {}) {
    return unrounded(number(text), decimal_digits(text).value(), spacing);
}

/// Whether a decimal can stand for a number.
bool stands_for(const std::string& decimal, const std::string& exact,
                std::optional<double> spacing = {}) {
    const Verdict verdict = can_agree(rounded(decimal, spacing), number(exact), bits_for(60));
    CHECK(verdict.proved == !verdict.holds);
    return verdict.holds;
}

GivenTableau given(const std::string& json) {
    return on_new_ground([&](const Ground& ground) {
        return given_tableau(coefficients_from_json({"t.json", json}), ground);
    });
}

/// Gauss' method of three stages in decimals of 16 places (computed with 60 digits elsewhere).
const char* const gauss_3 = R"({
    "c": [0.1127016653792583, 0.5, 0.8872983346207417],
    "b": [0.2777777777777778, 0.4444444444444444, 0.2777777777777778],
    "A": [[0.1388888888888889, -0.0359766675249389, 0.0097894440153083],
          [0.3002631949808646, 0.2222222222222222, -0.0224854172030868],
          [0.2679883337624695, 0.4804211119693833, 0.1388888888888889]]})";

}  // namespace

TEST_CASE("a decimal stands for what is not further than half a unit of its last digit") {
    CHECK(stands_for("0.1388888888888889", "5/36"));
    CHECK_FALSE(stands_for("0.1388888888888888", "5/36"));
    CHECK_FALSE(stands_for("0.1388888888888890", "5/36"));
    CHECK(stands_for("0.66666667", "2/3"));
    CHECK_FALSE(stands_for("0.66666666", "2/3"));
    CHECK(stands_for("-0.66666667", "-2/3"));
    CHECK(stands_for("2.2360680e2", "100*sqrt(5)"));
    CHECK_FALSE(stands_for("2.2360681e2", "100*sqrt(5)"));
    // Half a unit is not more than half a unit.
    CHECK(stands_for("0.1250000", "0.12500005"));
    CHECK(stands_for("0.1250001", "0.12500005"));
    CHECK_FALSE(stands_for("0.1250000", "0.12500006"));
    CHECK(stands_for("0.3333333333333333333333333333333333333333333333333333333", "1/3"));
    CHECK_FALSE(stands_for("0.3333333333333333333333333333333333333333333333333333334", "1/3"));
}

TEST_CASE("a double stands for what is near it at the size of the largest number") {
    const double spacing = spacing_at(0.75);  // of doubles between 1/2 and 1
    CHECK(spacing == std::ldexp(1.0, -53));
    CHECK(spacing_at(-0.75) == spacing);
    // Python prints this for 1/6. It is off by 6.7e-18, which is more than half a unit.
    CHECK_FALSE(stands_for("0.16666666666666666", "1/6"));
    CHECK(stands_for("0.16666666666666666", "1/6", spacing));
    // 2^-54 is 5.55e-17.
    CHECK(stands_for("0.009789444015308318", "5/36-sqrt(15)/30", spacing));
    CHECK(stands_for("0.25000000000000000", "1/4+2^-54", spacing));
    CHECK_FALSE(stands_for("0.25000000000000000", "1/4+2^-53", spacing));
}

TEST_CASE("numbers agree or are proved to differ") {
    const Precision bits = bits_for(16);
    const Verdict same = can_agree(number("1/3"), number("2/6"), bits);
    CHECK((same.holds && same.proved));
    const Verdict near = can_agree(number("1/3"), number("1/3+10^-60"), bits);
    CHECK((!near.holds && near.proved));
    CHECK(overlap(number("sqrt(2)"), number("exp(log(2)/2)"), bits));
}

TEST_CASE("common decimal places") {
    const Precision bits = bits_for(16);
    const auto places = [&](const std::string& left, const std::string& right) {
        return on_new_ground([&](const Ground& ground) {
            return common_places(read(left, ground), read(right, ground), bits);
        });
    };
    CHECK_FALSE(places("sqrt(2)/2", "1/sqrt(2)"));
    CHECK(places("1/3", "0.333") == 3);
    CHECK(places("1/3", "0.334") == 2);
    CHECK(places("1/6", "-1/6") == 0);
    CHECK(places("1/6", "-100/6") == -2);
    CHECK(places("5/36", "5/36+3*10^-12") == 11);
    CHECK(places("5/36", "5/36+6*10^-12") == 10);
    CHECK(common_places(rounded("0.3333333333"), number("1/3"), bits) == 9);
}

TEST_CASE("coefficients are read in two ways") {
    const GivenTableau gauss = given(gauss_3);
    CHECK(gauss.rounded == 14);
    CHECK(gauss.digits == 16);
    CHECK(text(gauss.written.c[1]) == "1/2");
    CHECK(text(gauss.enclosed.c[1]) == "1/2");
    CHECK(text(gauss.written.method.b[0]) == "1388888888888889/5000000000000000");
    CHECK(text(gauss.enclosed.method.b[0]) == "none");
    CHECK(can_agree(gauss.enclosed.method.A[0][1], number("2/9-sqrt(15)/15"), gauss.bits).holds);
    CHECK(gauss.written.method.A_tilde.size() == 3);
    // Beside a free parameter a decimal is exact.
    const GivenTableau free = given(R"({"A": [["w"]], "b": [0.3333333333], "c": ["w"]})");
    CHECK(free.parameters == std::vector<std::string>{"w"});
    CHECK(free.rounded == 0);
    CHECK(text(free.enclosed.method.b[0]) == "3333333333/10000000000");
}

TEST_CASE("a free parameter beside a number without a closed form is refused") {
    const auto refused = [](const std::string& json) {
        return refusal([&] { return given(json); });
    };
    const Refusal cube = refused(R"json({"A": [["w"]], "b": ["2^(1/3)"], "c": [0]})json");
    CHECK(cube.status == 2);
    CHECK(cube.marked == "[2^(1/3)]");
    CHECK(cube.helps("--param"));
    CHECK(refused(R"json({"A": [["w"]], "b": ["sqrt(2)"], "c": ["cos(w)"]})json").status == 0);
    CHECK(refused(R"json({"A": [[1]], "b": ["2^(1/3)"], "c": [0]})json").status == 0);
}

TEST_CASE("within its digits a rounded method has its order and is symplectic") {
    const GivenTableau gauss = given(gauss_3);
    const Orders found = orders(gauss.rounded_method(), 8);
    for (const OrderConditions& conditions : {found.general, found.separable, found.nystrom}) {
        CHECK(conditions.order == 6);
        CHECK_FALSE(conditions.is_at_least);
        CHECK_FALSE(conditions.proved);
    }
    CHECK(found.general.failures.size() == 4116);
    // sum b_i c_i^6 - 1/7 = -1/2800 for Gauss' quadrature.
    CHECK(found.general.failures.front().tree->text == "f[f,f,f,f,f,f]");
    CHECK(found.general.failures.front().residual.decimal(6) == "-0.000357143");
    CHECK(found.general.error_constant()->decimal(6) ==
          orders(derive(method("gauss:3")), 8).general.error_constant()->decimal(6));
    const Verdict symplectic = is_symplectic(gauss.rounded_method());
    CHECK((symplectic.holds && !symplectic.proved));
    CHECK(is_symmetric(gauss.rounded_method()).holds);
    CHECK(is_runge_kutta(gauss.rounded_method()).holds);
    CHECK(is_runge_kutta(gauss.rounded_method()).proved);  // A~ is A: the same decimals
    CHECK_FALSE(symplectic_defect(gauss.rounded_method()));
    // The written numbers themselves have neither property.
    CHECK(orders(gauss.written.method, 8).general.order == 2);
    CHECK_FALSE(is_symplectic(gauss.written.method).holds);
}

TEST_CASE("a wrong digit is proved to be one, whatever stands behind the given digits") {
    std::string json = gauss_3;
    json.replace(json.find("-0.0359766675249389"), 19, "-0.0359766675279389");
    const GivenTableau wrong = given(json);
    const Orders found = orders(wrong.rounded_method(), 8);
    CHECK(found.general.order == 1);
    REQUIRE(found.general.failures.size() == 4);
    CHECK(found.general.failures.front().tree->text == "f[f]");
    // b_1 times the error of -3e-12
    CHECK(found.general.failures.front().residual.decimal(4) == "-8.333e-13");
    const Verdict symplectic = is_symplectic(wrong.rounded_method());
    CHECK((!symplectic.holds && symplectic.proved));
    const auto defect = symplectic_defect(wrong.rounded_method());
    REQUIRE(defect);
    CHECK(defect->i == 0);
    CHECK(defect->j == 1);
    CHECK(defect->residual.decimal(4) == "-8.333e-13");
}

TEST_CASE("collocation at nodes of which some digits are known") {
    const NumberVector c{number("0"), rounded("0.42857142857143"), number("1")};
    const Precision bits = bits_for(14);
    const auto enclosed = enclosed_collocation(c, bits);
    REQUIRE(enclosed);
    const Tableau exact = derive(method("monomials:3", "0, 3/7, 1"));
    const PartitionedMethod expected = partitioned_method(exact);
    // At 0, 1/3, 1 the first weight is zero, and equal nodes have no polynomials.
    CHECK_FALSE(
        enclosed_collocation({number("0"), rounded("0.333333333333333"), number("1")}, bits));
    CHECK_FALSE(
        enclosed_collocation({number("0"), rounded("0.333333333333333"), number("1/3")}, bits));
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(overlap(enclosed->b[i], expected.b[i], bits));
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK(overlap(enclosed->A[i][j], expected.A[i][j], bits));
            CHECK(overlap(enclosed->A_tilde[i][j], expected.A_tilde[i][j], bits));
            // Known to about as many digits as the nodes, and no more.
            const auto places = common_places(enclosed->A[i][j], expected.A[i][j], bits);
            if (i > 0) { CHECK((places && *places >= 12 && *places <= 14)); }
        }
    }
}
