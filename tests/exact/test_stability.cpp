// The map of the harmonic oscillator, and for which steps its powers are bounded.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/exact/number_polynomial.hpp"
#include "generator/exact/number_value.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/stability.hpp"
#include "tests/exact/exact.hpp"

using namespace hvi::gen;
using Json = nlohmann::json;

namespace {

OscillatorMap map_of(const std::string& given) { return oscillator_map(derive(any_method(given))); }

/// Whether the map is proved to have determinant 1.
bool proved_one(const OscillatorMap& map) {
    return map.determinant_one.holds && map.determinant_one.proved;
}

LinearStability stability_of(const std::string& given) {
    return linear_stability(map_of(given), 20);
}

std::string half_trace(const std::string& given) {
    const auto form = closed_form(map_of(given).half_trace);
    return form ? to_text(*form) : "none";
}

/// `(0, 2*sqrt(2)) [2, 3]`: the intervals with closed forms for ends, or 10 digits.
std::string ends(const LinearStability& stability) {
    const auto end = [](const Number& number) {
        return text(number) == "none" ? number.decimal(10) : text(number);
    };
    std::string result;
    for (const StabilityInterval& interval : stability.stable) {
        if (!result.empty()) { result += ' '; }
        result += interval.low_included ? '[' : '(';
        result += end(interval.low) + ", " + end(interval.high);
        result += interval.high_included ? ']' : ')';
    }
    return result;
}

/// To 38 digits behind the point. NOTE: by enclosures, because the numbers' fields differ.
bool agrees(const Number& left, const std::string& right) {
    const Number enclosed = number(Real([left](Precision bits) { return enclosure(left, bits); }));
    const Number difference = enclosed - number(right);
    const Number unit = number("1e-38");
    return (unit - difference).sign() > 0 && (unit + difference).sign() > 0;
}

// ---- the reference ----

/// A polynomial in z as the reference writes it.
NumberPolynomial read_polynomial(std::string text, const Ground& ground) {
    for (std::size_t at = 0; (at = text.find('z', at)) != std::string::npos; at += 3) {
        text.replace(at, 1, "tau");
    }
    const auto given = source(text);
    return evaluate_function(parse_expression(given), given, ground).coefficients();
}

/// The same polynomial in another field.
NumberPolynomial moved(const NumberVector& polynomial, const Ground& ground) {
    NumberPolynomial result;
    for (const Number& coefficient : polynomial) {
        result.push_back(read(text(coefficient), ground));
    }
    return result;
}

bool same_quotient(const NumberVector& numerator, const NumberVector& denominator,
                   const Json& expected_numerator, const Json& expected_denominator) {
    return on_new_ground([&](const Ground& ground) {
        const auto above = read_polynomial(expected_numerator.get<std::string>(), ground);
        const auto below = read_polynomial(expected_denominator.get<std::string>(), ground);
        const auto left = product(moved(numerator, ground), below);
        const auto right = product(moved(denominator, ground), above);
        return sum(left, scaled(right, Number(-1))).empty();
    });
}

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

/// As the reference has them: poles, and touching points with I and -I.
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

Json parsed(const std::string& path) {
    std::ifstream file(path);
    return Json::parse(file).at("methods");
}

}  // namespace

TEST_CASE("maps, intervals, poles and touching points agree with the reference") {
    const Json known = parsed(HVI_REFERENCE_STABILITY);
    int maps = 0;
    int analyses = 0;
    for (const Json& entry : parsed(HVI_REFERENCE)) {
        const auto expected = known.find(entry["name"].get<std::string>());
        if (expected == known.end()) { continue; }
        CAPTURE(entry["name"]);
        const OscillatorMap map = oscillator_map(derive(
            entry.contains("method")
                ? method(entry["method"].get<std::string>())
                : method(entry["basis"].get<std::string>(), entry["nodes"].get<std::string>())));
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

TEST_CASE("a stage that the step does not use leaves no trace in the map") {
    Tableau tableau;  // the midpoint rule, and a stage of weight 0
    tableau.c = {number("1/2"), number("1/3")};
    tableau.b = {Number(1), Number(0)};
    tableau.A = {{number("1/2"), Number(0)}, {Number(0), number("1/3")}};
    tableau.A_tilde = tableau.A;
    const OscillatorMap map = oscillator_map(tableau);
    CHECK(texts(map.D) == texts(map_of("midpoint").D));
    CHECK(texts(map.m11) == texts(map_of("midpoint").m11));
    CHECK(texts(map.m21) == texts(map_of("midpoint").m21));
}

TEST_CASE("half the trace is written in lowest terms with integers") {
    CHECK(half_trace("stormer-verlet") == "(-z^2+2)/2");
    CHECK(half_trace("lobatto:3") == "(z^4-22*z^2+48)/(2*z^2+48)");
    CHECK(half_trace("chebyshev:3") == "(-z^6+228*z^4-4320*z^2+9216)/(z^6-12*z^4+288*z^2+9216)");
    CHECK(half_trace("1, tau, exp(tau^2) | 0, 1/2, 1") == "none");
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

TEST_CASE("the two ways to the map agree") {
    std::mt19937 generator(20240607);
    for (const std::string method : {"monomials:2", "monomials:3", "monomials:4"}) {
        std::vector<long> nodes;
        while (nodes.size() < static_cast<std::size_t>(method.back() - '0')) {
            const auto node = static_cast<long>(generator() % 98U);
            if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) {
                nodes.push_back(node);
            }
        }
        std::string list;
        for (const long node : nodes) {
            list += (list.empty() ? "" : ", ") + std::to_string(node) + "/97";
        }
        CAPTURE(list);
        Tableau tableau = derive(any_method(method + "|" + list));
        REQUIRE(tableau.node_polynomial);
        const OscillatorMap by_polynomials = oscillator_map(tableau);
        tableau.node_polynomial.reset();
        const OscillatorMap by_stages = oscillator_map(tableau);
        CHECK(proved_one(by_polynomials));
        CHECK(proved_one(by_stages));
        CHECK(texts(by_polynomials.D) == texts(by_stages.D));
        CHECK(texts(by_polynomials.m11) == texts(by_stages.m11));
        CHECK(texts(by_polynomials.m12) == texts(by_stages.m12));
        CHECK(texts(by_polynomials.m21) == texts(by_stages.m21));
        CHECK(texts(by_polynomials.m22) == texts(by_stages.m22));
    }
}

TEST_CASE("enclosures give the same intervals, and claim no proof") {
    for (const std::string name : {"lobatto:8", "gauss:6", "chebyshev:7"}) {
        CAPTURE(name);
        Tableau tableau = derive(method(name));
        const LinearStability exact = linear_stability(oscillator_map(tableau), 20);
        tableau.node_polynomial.reset();
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

TEST_CASE("coefficients too long for exact arithmetic are enclosed") {
    const OscillatorMap map = map_of("1, tau, cos(pi*tau), sin(pi*tau) | gauss:4");
    CHECK_FALSE(map.determinant_one.proved);
    CHECK_FALSE(map.proved);
    CHECK(linear_stability(map, 20).stable.front().high.decimal(8) == "3.1382429");
}

TEST_CASE("a free parameter stays in the map") {
    const std::string form = half_trace("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1");
    CHECK(form.find('w') != std::string::npos);
    CHECK(proved_one(map_of("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1")));
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

// ---- methods that are not of Algorithm 4.3 ----

namespace {

NumberMatrix matrix(const std::vector<std::vector<std::string>>& rows) {
    NumberMatrix result;
    for (const auto& row : rows) {
        NumberVector& numbers = result.emplace_back();
        for (const std::string& entry : row) { numbers.push_back(number(entry)); }
    }
    return result;
}

PartitionedMethod runge_kutta(const std::vector<std::vector<std::string>>& A,
                              const std::vector<std::string>& b) {
    const NumberMatrix rows = matrix(A);
    const NumberVector weights = matrix({b}).front();
    return {weights, weights, rows, rows};
}

PartitionedMethod kutta_4() {
    return runge_kutta({{"0", "0", "0", "0"},
                        {"1/2", "0", "0", "0"},
                        {"0", "1/2", "0", "0"},
                        {"0", "0", "1", "0"}},
                       {"1/6", "1/3", "1/3", "1/6"});
}

}  // namespace

TEST_CASE("a Runge-Kutta method takes x to R(i z) x on the oscillator") {
    // R(w) = 1 + w + w^2/2 + w^3/6 + w^4/24
    const OscillatorMap map = oscillator_map(kutta_4());
    CHECK(same_quotient(map.m11, map.D, "1-z^2/2+z^4/24", "1"));
    CHECK(same_quotient(map.m12, map.D, "z-z^3/6", "1"));
    CHECK(same_quotient(map.m21, map.D, "-z+z^3/6", "1"));
    CHECK(same_quotient(map.m22, map.D, "1-z^2/2+z^4/24", "1"));
    CHECK(map.proved);
    CHECK_FALSE(map.determinant_one.holds);
    CHECK(map.determinant_one.proved);
}

TEST_CASE("weights for p of their own move p") {
    // Q = q + h/2 p, P = p - h/2 q for both; q1 takes P with weight 1, p1 takes Q with weight 2.
    PartitionedMethod method = runge_kutta({{"1/2"}}, {"1"});
    method.b_tilde = {number("2")};
    const OscillatorMap map = oscillator_map(method);
    CHECK(same_quotient(map.m11, map.D, "4-z^2", "4+z^2"));
    CHECK(same_quotient(map.m12, map.D, "4*z", "4+z^2"));
    CHECK(same_quotient(map.m21, map.D, "-8*z", "4+z^2"));
    CHECK(same_quotient(map.m22, map.D, "4-3*z^2", "4+z^2"));
}

TEST_CASE("rational, exact and enclosed coefficients give the same map") {
    // A and A~ are the same numbers, but known in different ways.
    const PartitionedMethod rational =
        runge_kutta({{"1/3", "-1/12"}, {"3/4", "1/4"}}, {"3/4", "1/4"});
    PartitionedMethod radical = rational;
    radical.A[0][0] =
        on_new_ground([](const Ground& ground) { return read("1/3+sqrt(2)", ground); });
    PartitionedMethod back = radical;
    back.A[0][0] = radical.A[0][0];
    const OscillatorMap map = oscillator_map(rational);
    CHECK(text(map.D.back()) != "none");
    const OscillatorMap other = oscillator_map(radical);
    CHECK(other.D.size() == map.D.size());
    // At sqrt(2) -> 0 they agree: the coefficient of z^2 in D is the trace of A~ A, linear in a_11.
    const Number difference = other.D[2] - map.D[2];
    CHECK(text(difference) == "sqrt(2)/3");
}

TEST_CASE("a map with another determinant is stable where it contracts") {
    const auto stable = [](const PartitionedMethod& method) {
        return ends(linear_stability(oscillator_map(method), 20));
    };
    // The interval of the classical method on the imaginary axis.
    CHECK(stable(kutta_4()) == "(0, 2*sqrt(2))");
    // Euler's method grows, and so does Heun's: |R|^2 = 1 + z^4/4.
    CHECK(stable(runge_kutta({{"0"}}, {"1"})).empty());
    CHECK(stable(runge_kutta({{"0", "0"}, {"1", "0"}}, {"1/2", "1/2"})).empty());
    // Kutta's third-order rule: |R|^2 = 1 - z^4/12 + z^6/36 up to sqrt(3).
    CHECK(stable(runge_kutta({{"0", "0", "0"}, {"1/2", "0", "0"}, {"-1", "2", "0"}},
                             {"1/6", "2/3", "1/6"})) == "(0, sqrt(3))");
    // The implicit Euler rule damps everything; |R|^2 = 1/(1 + z^2).
    const LinearStability implicit =
        linear_stability(oscillator_map(runge_kutta({{"1"}}, {"1"})), 20);
    CHECK(ends(implicit) == "(0, 20)");
    CHECK(implicit.at_infinity.is_stable);
    CHECK(implicit.proved);
    CHECK(implicit.poles.empty());
    CHECK_FALSE(linear_stability(oscillator_map(kutta_4()), 20).at_infinity.is_stable);
}

TEST_CASE("poles and points on the circle split intervals of contraction") {
    // a_11 a~_11 = -1: the stage is singular at z = 1. With b = 1, A = -1 and A~ = 1:
    // D = 1 - z^2, m11 = 1 - 2 z^2, m22 = 1, det = (m11 m22 + z^2)/D^2 = 1/(1 - z^2).
    PartitionedMethod method = runge_kutta({{"-1"}}, {"1"});
    method.A_tilde = matrix({{"1"}});
    const LinearStability stability = linear_stability(oscillator_map(method), 20);
    REQUIRE(stability.poles.size() == 1);
    CHECK(text(stability.poles.front()) == "1");
    for (const StabilityInterval& interval : stability.stable) {
        CHECK((interval.high.nearest_double() <= 1 || interval.low.nearest_double() >= 1));
    }
}

TEST_CASE("a determinant that is 1 only within enclosures is taken for 1") {
    Tableau tableau = derive(method("lobatto:8"));
    const OscillatorMap map = oscillator_map(partitioned_method(tableau));
    CHECK(map.determinant_one.holds);
    CHECK_FALSE(map.determinant_one.proved);
    CHECK(ends(linear_stability(map, 3)) == "(0, 3)");
}
