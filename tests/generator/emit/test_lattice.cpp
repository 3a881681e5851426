// Coefficients in each format: symplectic, and as near to the exact ones as that allows.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstdint>

#include <catch2/catch.hpp>

#include "generator/plan/lattice.hpp"
#include "generator/plan/plan.hpp"
#include "generator/support/error.hpp"
#include "tests/generator/emit/header.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;
using Catch::Matchers::Contains;
using tableaux::ratio;

namespace {

Number power_of_two(int exponent) {
    Number power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) { power = power * Number(2); }
    return exponent < 0 ? Number(1) / power : power;
}

/// Returns the exact number, as parts of 40 bits, each of which is a double.
Number exactly(Dyadic value) {
    Number sum = 0;
    while (!value.is_zero()) {
        const Dyadic part = value.cut(40);
        const double integer = std::ldexp(part.to_double(), -part.last());
        sum = sum + Number(static_cast<long>(integer)) * power_of_two(part.last());
        value = value - part;
    }
    return sum;
}

bool at_most(const Number& a, const Number& b) { return (b - a).sign() >= 0; }

Number absolute(const Number& a) { return a.sign() < 0 ? -a : a; }

/// Explicit for separable H, with any weights: kicks after drifts of b_i.
Tableau composition(const NumberVector& b) {
    const std::size_t s = b.size();
    NumberVector c(s);
    NumberMatrix A(s, NumberVector(s));
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j <= i; ++j) { A[i][j] = b[j]; }
        for (std::size_t j = 0; j <= i; ++j) { c[i] = c[i] + b[j]; }
    }
    return tableaux::make(c, b, A);
}

}  // namespace

TEST_CASE("coefficients are complementary in every format, and nearest on their lattice") {
    for (const auto& tableau :
         {tableaux::lobatto_3(), tableaux::negative_weight(), tableaux::two_midpoints(),
          tableaux::midpoint(), tableaux::verlet(), composition({ratio(1, 7), ratio(6, 7)})}) {
        const Step step = plan({tableau}, {.is_separable = false});
        const RoundedCoefficients coefficients = rounded(step);
        for (std::size_t i = 0; i < step.positions.size(); ++i) {
            for (std::size_t j = 0; j < step.momenta.size(); ++j) {
                for (std::size_t f = 0; f < formats.size(); ++f) {
                    const Dyadic m = coefficients.m[i][j][f].value();
                    const Dyadic mt = coefficients.mt[j][i][f].value();
                    CHECK((exactly(m) + exactly(mt)).is_one());
                    CHECK(std::max(m.bits(), mt.bits()) <= formats[f].bits);
                    const int leading = std::max(m.is_zero() ? -1000 : m.leading(),
                                                 mt.is_zero() ? -1000 : mt.leading());
                    const Number unit = power_of_two(leading - formats[f].bits + 1);
                    const Number error = absolute(exactly(m) - step.m[i][j]);
                    CHECK(at_most(Number(2) * error, unit));
                }
            }
        }
    }
}

TEST_CASE("the nearest numbers of 24, 53, 64 and 113 bits") {
    const Rounded third = nearest(ratio(-1, 3));
    CHECK(third[0]->to_double() == -0x1.555556p-2);
    CHECK(third[1]->to_double() == -0x1.5555555555555p-2);
    CHECK((*third[2] - *third[1]).to_double() == -0x1.558p-56);
    CHECK((*third[3] - *third[1]).cut(53).to_double() == -0x1.5555555555555p-56);
    CHECK(absolute(exactly(*third[3]) - ratio(-1, 3)).sign() != 0);
    CHECK(at_most(absolute(exactly(*third[3]) - ratio(-1, 3)), power_of_two(-115)));
}

TEST_CASE("what float cannot hold is empty, or small where that will do") {
    const Number tiny = power_of_two(-140) * ratio(1, 3);
    CHECK_FALSE(nearest(tiny)[0]);
    CHECK(nearest(tiny)[1]);
    CHECK(nearest_or_small(tiny)[0]->to_double() == 0x1.56p-142);
    CHECK(nearest_or_small(power_of_two(-200))[0]->is_zero());
    CHECK(nearest(power_of_two(-126))[0]);
    CHECK_FALSE(nearest(power_of_two(128))[0]);
    // Float has no digits for the difference of 1 and a number above 2^24.
    const Number small = power_of_two(-26) * ratio(1, 3);
    const Step step = plan({composition({small, Number(1) - small})}, {.is_separable = false});
    Step steep = step;
    steep.m[0][0] = power_of_two(25) + ratio(1, 3);
    CHECK_FALSE(rounded(steep).m[0][0][0]);
    CHECK(rounded(steep).m[0][0][1]);
}

TEST_CASE("a header refuses float at compile time, and the generator what no double holds") {
    const auto with_first_weight = [](const Number& b) { return composition({b, Number(1) - b}); };
    const std::string usual = header(with_first_weight(ratio(1, 3)), true);
    CHECK_THAT(usual, Contains("rounded(0.33333334f, 0.3333333333333333, 0x1.558p-56,"));
    CHECK_THAT(usual, Contains("#ifndef HVI_ROUNDED_HPP") && !Contains("#include <hvi"));
    CHECK_THAT(usual, !Contains("static_assert(hvi::detail::bits<Scalar>"));
    const std::string tiny = header(with_first_weight(power_of_two(-130)), true);
    CHECK_THAT(tiny, Contains("static_assert(hvi::detail::bits<Scalar> != 24,\n"
                              "                  \"hvi: b_1 is beyond the range of float\");"));
    CHECK_THROWS_AS(header(with_first_weight(power_of_two(-1100)), true), MathError);
}

TEST_CASE("an exact meaning stands once for all formats, and rounding only where it is needed") {
    const std::string lobatto = header(tableaux::lobatto_3());
    const std::size_t first = lobatto.find("m_2,1 = 5/4");
    CHECK(first != std::string::npos);
    CHECK(lobatto.find("m_2,1 = 5/4", first + 1) == std::string::npos);
    CHECK_THAT(lobatto, Contains("Scalar(1.25),   // m_2,1 = 5/4"));
    const std::string verlet = header(tableaux::verlet(), true);
    CHECK_THAT(verlet, !Contains("rounded") && Contains("Scalar(0.5),  // b_1 = 1/2"));
}

TEST_CASE("weights that are no powers of two are rounded together in each step") {
    CHECK_THAT(header(tableaux::lobatto_3()), Contains("s_.weigh(b, b);"));
    CHECK_THAT(header(tableaux::lobatto_3()), Contains("-s.hb_p[0] * slope[k]"));
    CHECK_THAT(header(tableaux::two_midpoints()), !Contains("s_.weigh(") && !Contains("hb_"));
    CHECK(is_power_of_two(ratio(-1, 4)));
    CHECK_FALSE(is_power_of_two(ratio(3, 4)));
    CHECK_FALSE(is_power_of_two(ratio(1, 3)));
}
