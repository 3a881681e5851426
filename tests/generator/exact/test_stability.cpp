// Steps for which the powers of a map of the oscillator are bounded.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/generator/exact/reference.hpp"
#include "tests/generator/exact/stability.hpp"

using namespace hvi::gen;

// ---- the reference ----

namespace {

/// The reference's intervals go on where the map is I or -I, and so do these.
bool same_intervals(const std::vector<StabilityInterval>& intervals, const Json& expected) {
    if (intervals.size() != expected.size()) { return false; }
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        if (!agrees(intervals[i].low, expected[i][0].get<std::string>()) ||
            !agrees(intervals[i].high, expected[i][1].get<std::string>())) {
            return false;
        }
    }
    return true;
}

/// Returns marks as the reference has them: poles, and touching points with I and -I.
std::vector<std::pair<Number, std::string>> marks(const LinearStability& stability) {
    std::vector<std::pair<Number, std::string>> result;
    for (const Number& pole : stability.poles) { result.emplace_back(pole, "pole"); }
    for (const TouchingPoint& point : stability.touching) {
        result.emplace_back(point.z, std::string(point.half_trace > 0 ? "+" : "-") +
                                         (point.is_identity ? "I" : "J"));
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
        return a.first.nearest_double() < b.first.nearest_double();
    });
    return result;
}

bool same_marks(const LinearStability& stability, const Json& expected) {
    const auto found = marks(stability);
    if (found.size() != expected.size()) { return false; }
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!agrees(found[i].first, expected[i][0].get<std::string>()) ||
            found[i].second != expected[i][1].get<std::string>()) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("maps, intervals, poles and touching points agree with the reference") {
    const Json known = reference("exact/reference_stability.json");
    int maps = 0;
    int analyses = 0;
    for (const Json& entry : reference_methods()) {
        const auto expected = known.find(entry["name"].get<std::string>());
        if (expected == known.end()) { continue; }
        CAPTURE(entry["name"]);
        const OscillatorMap map = oscillator_map(derive(method_of(entry)));
        CHECK(map.proved);
        CHECK(proved_one(map));
        CHECK(same_quotient(map.half_trace.numerator, map.half_trace.denominator,
                            (*expected)["half_trace_num"], (*expected)["half_trace_den"]));
        if (expected->contains("D")) {
            const Json& D = (*expected)["D"];
            CHECK(same_quotient(map.m11, map.D, (*expected)["m11"], D));
            CHECK(same_quotient(map.m12, map.D, (*expected)["m12"], D));
            CHECK(same_quotient(map.m21, map.D, (*expected)["m21"], D));
            CHECK(same_quotient(map.m22, map.D, (*expected)["m22"], D));
            ++maps;
        }
        if (!expected->contains("stable")) { continue; }
        const LinearStability stability = linear_stability(map, 20);
        CHECK(stability.proved);
        CHECK(same_intervals(stability.stable, (*expected)["stable"]));
        CHECK(same_marks(stability, (*expected)["touching"]));
        ++analyses;
    }
    CHECK(maps == 42);
    CHECK(analyses == 49);
}

// ---- facts ----

TEST_CASE("ends have closed forms where they are short") {
    CHECK(ends(stability_of("stormer-verlet")) == "(0, 2)");
    CHECK(ends(stability_of("chebyshev:3")) ==
          "(0, 2*sqrt(2)) (4*sqrt(6)/3, 2*sqrt(6)) (4*sqrt(6), 20)");
    CHECK(same("4*sqrt(6)/3", "sqrt(32/3)"));
    // A factor that is a polynomial in z, not in z^2.
    CHECK(ends(stability_of("radau-left:2")) == "(0, sqrt(13)-1) (1+sqrt(13), 6)");
    const LinearStability trig = stability_of("trig3");
    CHECK(same(text(trig.stable.front().high), "pi*sqrt((pi-2)/2)"));
    CHECK(trig.poles.size() == 1);
    CHECK(trig.poles.front().decimal(5) == "7.3814");
    CHECK(trig.proved);
}

TEST_CASE("ends whose closed forms nobody could read are decimals") {
    const LinearStability stability =
        stability_of("1, tau, cos(pi*tau), sin(pi*tau) | 0, 1/3, 2/3, 1");
    CHECK(ends(stability) ==
          "(0, 2.675145864) (3.325287006, 5.197694450) (8.401725269, 9.818216743)");
    CHECK(stability.proved);
    CHECK(text(stability_of("1, exp(tau), exp(-tau) | 0, 1/3, 1").poles.at(0)) == "none");
    CHECK(ends(stability_of("1, tau, exp(tau) | 0, 1/2, 1")) ==
          "(0, 4*sqrt((e-exp(1/2)-1)/(4*e-15*exp(1/2)+14))) "
          "(3.478496799, 2*sqrt((2*e-4*exp(1/2)+2)/(4*e-15*exp(1/2)+14)))");
}

TEST_CASE("Gauss methods are stable everywhere") {
    for (const int s : {1, 2, 3, 4, 5, 6, 7, 8, 9, 24}) {
        CAPTURE(s);
        const OscillatorMap map = map_of("gauss:" + std::to_string(s));
        CHECK(map.proved);
        CHECK(proved_one(map));
        const LinearStability stability = linear_stability(map, 20);
        CHECK(stability.proved);
        CHECK(ends(stability) == "(0, 20)");
        CHECK(stability.poles.empty());
        CHECK(std::all_of(stability.touching.begin(), stability.touching.end(),
                          [](const TouchingPoint& point) { return point.is_identity; }));
        CHECK(stability.at_infinity.is_stable);
        CHECK(text(stability.at_infinity.value.value()) == (s % 2 == 0 ? "1" : "-1"));
    }
}

TEST_CASE("poles are found where a system of stages is singular") {
    const LinearStability open = stability_of("newton-cotes-open:4");
    REQUIRE(open.poles.size() == 2);
    CHECK(open.poles[0].decimal(10) == "0.3660776152");
    const LinearStability chebyshev = stability_of("chebyshev:9");
    CHECK(chebyshev.proved);
    REQUIRE(chebyshev.poles.size() == 5);
    CHECK(chebyshev.poles[0].decimal(10) == "0.7515880747");
    CHECK(chebyshev.poles[0].decimal(50).substr(0, 12) == "0.7515880747");
}

TEST_CASE("half the trace has a limit") {
    const auto limit = [](const std::string& given) { return stability_of(given).at_infinity; };
    CHECK_FALSE(limit("stormer-verlet").value);
    CHECK(limit("stormer-verlet").sign == -1);
    CHECK_FALSE(limit("stormer-verlet").is_stable);
    CHECK(limit("lobatto:3").sign == 1);
    CHECK(text(limit("chebyshev:3").value.value()) == "-1");
    CHECK(limit("chebyshev:3").is_stable);
    CHECK(text(limit("midpoint").value.value()) == "-1");
    CHECK(limit("newton-cotes-open:3").value);
    CHECK_FALSE(limit("newton-cotes-open:3").is_stable);
}

TEST_CASE("an interval ends where it is asked to") {
    const OscillatorMap map = map_of("chebyshev:3");
    CHECK(ends(linear_stability(map, 2)) == "(0, 2)");
    CHECK(ends(linear_stability(map, 4)) == "(0, 2*sqrt(2)) (4*sqrt(6)/3, 4)");
    // A special point at the end is not inside.
    CHECK(ends(linear_stability(map_of("stormer-verlet"), 2)) == "(0, 2)");
}

TEST_CASE("enclosures give the same intervals, and claim no proof") {
    for (const std::string name : {"lobatto:8", "gauss:6", "chebyshev:7"}) {
        CAPTURE(name);
        Tableau tableau = derive(method(name));
        const LinearStability exact = linear_stability(oscillator_map(tableau), 20);
        tableau.galerkin.reset();
        const OscillatorMap map = oscillator_map(tableau);
        const LinearStability enclosed = linear_stability(map, 20);
        CHECK(map.determinant_one.holds);
        CHECK_FALSE(map.determinant_one.proved);
        CHECK_FALSE(enclosed.proved);
        REQUIRE(enclosed.stable.size() == exact.stable.size());
        for (std::size_t i = 0; i < exact.stable.size(); ++i) {
            CHECK(agrees(enclosed.stable[i].low, exact.stable[i].low.decimal(45)));
            CHECK(agrees(enclosed.stable[i].high, exact.stable[i].high.decimal(45)));
        }
        CHECK(enclosed.poles.size() == exact.poles.size());
        CHECK(enclosed.touching.size() == exact.touching.size());
    }
}

// ---- maps made by hand: half_trace = c, D = 1 and m12 m21 = c^2 - 1 ----

namespace {

NumberVector polynomial(const std::string& text) {
    return on_new_ground([&](const Ground& ground) { return read_polynomial(text, ground); });
}

OscillatorMap made(const std::string& c, const std::string& m12, const std::string& m21) {
    OscillatorMap map{polynomial(c),   polynomial(m12),
                      polynomial(m21), polynomial(c),
                      {Number(1)},     {polynomial(c), {Number(1)}},
                      {true, true},    true};
    CHECK(same_quotient(map.m11, map.D, c, "1"));
    return map;
}

}  // namespace

TEST_CASE("a touching point splits an interval unless the map is I or -I there") {
    // c - 1 = -z^2 (z^2 - 1)^2/8, and c = -1 at z = 1.796...
    const std::string c = "1-z^2*(z^2-1)^2/8";
    const OscillatorMap identity = made(c, "z*(z^2-1)/8", "-z*(z^2-1)*(2-z^2*(z^2-1)^2/8)");
    const LinearStability whole = linear_stability(identity, 20);
    CHECK(ends(whole) == "(0, 1.796321903)");
    REQUIRE(whole.touching.size() == 1);
    CHECK(text(whole.touching[0].z) == "1");
    CHECK(whole.touching[0].half_trace == 1);
    CHECK(whole.touching[0].is_identity);
    const OscillatorMap jordan = made(c, "z*(z^2-1)^2/8", "-z*(2-z^2*(z^2-1)^2/8)");
    const LinearStability split = linear_stability(jordan, 20);
    CHECK(ends(split) == "(0, 1) (1, 1.796321903)");
    REQUIRE(split.touching.size() == 1);
    CHECK_FALSE(split.touching[0].is_identity);
}

TEST_CASE("a point with the identity among unstable ones is an interval") {
    // c - 1 = z^2 (z^2 - 1) (z^2 - 2)^2
    const OscillatorMap map =
        made("1+z^2*(z^2-1)*(z^2-2)^2", "z*(z^2-2)*(z^2-1)", "z*(z^2-2)*(2+z^2*(z^2-1)*(z^2-2)^2)");
    const LinearStability stability = linear_stability(map, 20);
    CHECK(ends(stability) == "(0, 1) [sqrt(2), sqrt(2)]");
    CHECK(stability.touching.empty());
}

TEST_CASE("a map that is the identity or a Jordan block everywhere has no interval") {
    const LinearStability stability = linear_stability(made("1", "z", "0"), 20);
    CHECK(stability.stable.empty());
    CHECK(stability.touching.empty());
}

TEST_CASE("a diagonal map has no interval where it is not the identity") {
    OscillatorMap map = made("5/4", "0", "0");
    map.m11 = polynomial("2");
    map.m22 = polynomial("1/2");
    CHECK(linear_stability(map, 20).stable.empty());
}
