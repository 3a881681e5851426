// The functions of <hvi/detail/numbers/math.hpp>, and the constants of a scene, against decimals of
// mpmath.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <catch2/catch.hpp>
#include <wide/constants.hpp>

#include "numbers.hpp"
#include "tests/runtime/scalars/wide.hpp"

using namespace float128;
using hvi::detail::infinity;
using scalars::Wide;

namespace {

/// Whether the value is so many units of 2^-bits(Widest) from the decimal.
bool is_at(Widest value, const std::string& decimal, int units) {
    const Wide unit = Wide::of(units * eps / 2);
    return (Wide::of(value) - Wide(decimal)).absolute() <= unit;
}

}  // namespace

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
TEST_CASE("g++ on glibc has __float128, with extensions and without") {
    STATIC_REQUIRE(HVI_HAS_FLOAT128 == 1);
    STATIC_REQUIRE(is_quad);
    STATIC_REQUIRE_FALSE(std::is_same_v<Widest, long double>);
}
#endif

TEST_CASE("each function at 3/8") {
    namespace math = hvi::math;
    const Widest x = ratio(3, 8);
    CHECK(is_at(math::acos(x), "1.186399552299257536193126818672704468345805215380988", 4));
    CHECK(is_at(math::asin(x), "0.384396774495639083038194872967046973752779484306565", 2));
    CHECK(is_at(math::atan(x), "0.3587706702705722203959200639264604997769756558809158", 2));
    CHECK(is_at(math::cos(x), "0.93050762191231429114947679222955550809519100187151", 2));
    CHECK(is_at(math::cosh(x), "1.071140346704586767299498015567016049390747022368468", 4));
    CHECK(is_at(math::exp(x), "1.454991414618201336053793691987518508346842020964416", 4));
    CHECK(is_at(math::expm1(x), "0.4549914146182013360537936919875185083468420209644157", 2));
    CHECK(is_at(math::log(x), "-0.9808292530117262368564511274520039995790098452580163", 2));
    CHECK(is_at(math::sin(x), "0.3662725290860475613729093517162641571764130143973579", 2));
    CHECK(is_at(math::sinh(x), "0.3838510679136145687542956764205024589560949985959473", 2));
    CHECK(is_at(math::sqrt(x), "0.6123724356957945245493210186764728479914868701641675", 1));
    CHECK(is_at(math::tan(x), "0.3936265759256327582294137871012180981856966444080713", 2));
    CHECK(is_at(math::tanh(x), "0.358357398350785946319360231553158042468442496439152", 2));
    const Widest exponent = ratio(5, 4);
    CHECK(
        is_at(math::pow(x, exponent), "0.293453358763741371859591031092254339339511301770273", 2));
}

TEST_CASE("of float and double they are those of the standard library") {
    CHECK(hvi::math::sin(0.375F) == std::sin(0.375F));
    CHECK(hvi::math::pow(0.375, 1.25) == std::pow(0.375, 1.25));
    STATIC_REQUIRE(std::is_same_v<decltype(hvi::math::exp(0.375F)), float>);
    STATIC_REQUIRE(std::is_same_v<decltype(hvi::math::exp(Widest(1))), Widest>);
    STATIC_REQUIRE(hvi::math::computes_in<float>);
    STATIC_REQUIRE(hvi::math::computes_in<Widest>);
    STATIC_REQUIRE_FALSE(hvi::math::computes_in<int>);
}

TEST_CASE("comparisons and classes of the widest numbers") {
    const Widest none = infinity<Widest> - infinity<Widest>;
    CHECK(hvi::math::islessgreater(Widest(1), 1 + eps));
    CHECK(hvi::math::islessgreater(1 + eps, Widest(1)));
    CHECK_FALSE(hvi::math::islessgreater(Widest(1), Widest(1)));
    CHECK_FALSE(hvi::math::islessgreater(none, Widest(1)));
    CHECK(hvi::math::isnormal(-eps));
    CHECK_FALSE(hvi::math::isnormal(Widest(0)));
    CHECK_FALSE(hvi::math::isnormal(infinity<Widest>));
    CHECK_FALSE(hvi::math::isnormal(none));
    const int least = is_quad ? -16382 : std::numeric_limits<long double>::min_exponent - 1;
    const Widest smallest = hvi::detail::power_of_two<Widest>(least);
    CHECK(hvi::math::isnormal(smallest));
    CHECK_FALSE(hvi::math::isnormal(smallest / 2));
}

TEST_CASE("the numbers of a scene have all the digits") {
    // H = p^2/2 + pi q + sqrt(2) q^2 + g q^3 + third q^4 + s q^(1/3)
    using Constants = hvi::generated::BasicWideConstants<Widest>;
    const Constants::Parameters parameters;
    CHECK(parameters.g == ratio(981, 100));
    CHECK(parameters.third == ratio(1, 3));
    CHECK(is_at(parameters.s, "1.732050807568877293527446341505872366942805253810381", 2));

    Constants::Parameters none;
    none.g = none.third = none.s = 0;
    Constants::State at_one{{Widest(1)}, {Widest(0)}};
    // pi + sqrt(2), whose rounding and that of the terms come to 8 units.
    CHECK(is_at(Constants(none).energy(at_one),
                "4.555806215962888287264332107489200962766841274752054", 8));
    none.s = 1;
    Constants::State at_two{{Widest(2)}, {Widest(0)}};
    // 2 pi + 4 sqrt(2) + 2^(1/3)
    CHECK(is_at(Constants(none).energy(at_two),
                "13.19996060656683983689925227067602643324327776495951", 64));
    CHECK(Constants::initial(none).q[0] == ratio(1, 10));
}
