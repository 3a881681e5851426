// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/coefficients.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Coefficients read_coefficients(const std::string& text) {
    return coefficients_from_json({"t.json", text});
}

Refusal refused_coefficients(const std::string& text) {
    return refusal([&] { return read_coefficients(text); });
}

/// One stage with this number for A.
Refusal refused_entry(const std::string& entry) {
    return refused_coefficients("{\"A\": [[" + entry + "]],\n\"b\": [1], \"c\": [0]}");
}

Expression value(const std::string& entry) {
    return read_coefficients("{\"A\": [[" + entry + "]], \"b\": [1], \"c\": [0]}").A[0][0].value;
}

std::string texts(const CoefficientVector& entries) {
    std::string result;
    for (const Coefficient& entry : entries) {
        result += (result.empty() ? "" : " ") + to_text(entry.value);
    }
    return result;
}

/// Marks the nodes that look rounded: `r` or `-` for each.
std::string rounded(const std::vector<std::string>& numbers) {
    std::string c, row, rows;
    for (const std::string& number : numbers) {
        c += (c.empty() ? "" : ",") + number;
        row += row.empty() ? "0" : ",0";
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        rows += (rows.empty() ? "[" : ",[") + row + "]";
    }
    std::string result;
    for (const Coefficient& entry :
         read_coefficients("{\"A\":[" + rows + "],\"b\":[" + row + "],\"c\":[" + c + "]}").c) {
        result += entry.rounded ? 'r' : '-';
    }
    return result;
}

}  // namespace

TEST_CASE("a bare object with A, b and c is a tableau") {
    const Coefficients rule = read_coefficients(R"({"A": [["1/2"]], "b": [1], "c": [0.5]})");
    CHECK(rule.name.empty());
    CHECK(rule.origin == "--tableau t.json");
    CHECK(texts(rule.A[0]) == "1/2");
    CHECK(texts(rule.b) == "1");
    CHECK(texts(rule.c) == "1/2");
    CHECK_FALSE(rule.A_tilde);
    CHECK_FALSE(rule.b_tilde);
    const Coefficients pair =
        read_coefficients(R"json({"A": [[0,0],[0.5,0.5]], "A_tilde": [[0.5,0],[0.5,0]],
        "b": ["1/2","1/2"], "b_tilde": [1, 0], "c": [0, 1], "name": "Verlet (1967)"})json");
    CHECK(pair.name == "Verlet (1967)");
    CHECK(texts(pair.A_tilde->at(1)) == "1/2 0");
    CHECK(texts(*pair.b_tilde) == "1 0");
}

TEST_CASE("every number means exactly what is written") {
    CHECK(value("0.1") == Expression::rational("1", "10"));
    CHECK(value("1e-3") == Expression::rational("1", "1000"));
    CHECK(value("\"0.1\"") == value("0.1"));
    CHECK(value("123456789012345678901234567890") ==
          Expression::rational("123456789012345678901234567890", "1"));
    CHECK(to_text(value("-0.25")) == "-1/4");
    CHECK(to_text(value("\" 1/6-5*sqrt(2)/48 \"")) == "1/6-5*sqrt(2)/48");
    CHECK(to_text(value("\"cos(pi/7)\"")) == "cos(pi/7)");
}

TEST_CASE("of an entry the exact form counts, and then the decimal") {
    CHECK(to_text(value(R"({"exact": "1/3", "decimal": "0.333", "double": "0x1p-2"})")) == "1/3");
    CHECK(value(R"({"exact": null, "decimal": "0.3", "double": "0x1p-2"})") == value("0.3"));
    CHECK(value(R"({"decimal": 0.3})") == value("0.3"));
    CHECK(refused_entry(R"({"exact": null, "decimal": null})").says("neither an exact value"));
    CHECK(refused_entry(R"({"double": "0x1p-2"})").says("neither an exact value"));
    const Refusal wrong = refused_entry(R"({"exakt": "1"})");
    CHECK(wrong.marked == R"({"A": [[{["exakt"]: "1"}]],)");
    CHECK(wrong.helps("`exact`"));
}

TEST_CASE("keys of hvi-tableau/1 that are not needed are ignored, others are refused") {
    CHECK(refused_coefficients(
              R"({"schema": "hvi-tableau/1", "stages": 1, "parameters": [], "basis": ["1"],
        "c": [0], "b": [1], "c_tilde": 7, "A": [[0]], "A_tilde": [[1]], "M": 1, "M_inverse": {},
        "B": null, "A_psi": "x"})")
              .status == 0);
    const Refusal key =
        refused_coefficients(R"({"A": [[0]], "b": [1], "c": [0], "Atilde": [[1]]})");
    CHECK(key.says("no `Atilde`"));
    CHECK(key.helps("`A_tilde`"));
    CHECK(key.marked == R"({"A": [[0]], "b": [1], "c": [0], ["Atilde"]: [[1]]})");
    CHECK(refused_coefficients(R"({"schema": "hvi-check/1", "A": [[0]], "b": [1], "c": [0]})")
              .says("`hvi-tableau/1`"));
}

TEST_CASE("shapes are checked") {
    CHECK(refused_coefficients("[]").says("an object"));
    CHECK(refused_coefficients(R"({"A": [[0]], "b": [1]})").says("no `c`"));
    CHECK(refused_coefficients(R"({"A": [[0]], "c": [1]})").says("no `b`"));
    CHECK(refused_coefficients(R"({"b": [0], "c": [1]})").says("no `A`"));
    CHECK(refused_coefficients(R"({"A": [], "b": [], "c": []})").says("one stage at least"));
    CHECK(refused_coefficients(R"({"A": [[0]], "b": [1], "c": 0})").says("`c` is no list"));
    CHECK(refused_coefficients(R"({"A": [0], "b": [1], "c": [0]})").says("`A[1]` is no list"));
    CHECK(refused_coefficients(R"({"A": [[0]], "b": [1, 2], "c": [0]})")
              .says("`b` has 2 entries, and `c` has 1"));
    const Refusal row =
        refused_coefficients("{\"A\": [[0, 1],\n [0]], \"b\": [1, 2], \"c\": [0, 1]}");
    CHECK(row.says("`A[2]` has 1 entry, and `c` has 2"));
    CHECK(row.name == "t.json:2");
    CHECK(row.marked == R"( [[0]]], "b": [1, 2], "c": [0, 1]})");
    CHECK(refused_coefficients(R"({"A": [[0]], "b": [1], "c": [0], "stages": 2})")
              .says("`c` has 1 entry"));
    std::string many = "0";
    for (int k = 1; k <= 64; ++k) { many += ",0"; }
    CHECK(refused_coefficients("{\"A\": [], \"b\": [], \"c\": [" + many + "]}")
              .says("more than 64 stages"));
}

TEST_CASE("what stands in an entry is refused where it stands") {
    CHECK(refused_entry("true").marked == "{\"A\": [[[true]]],");
    CHECK(refused_entry("null").says("a number is wanted"));
    CHECK(refused_entry("[1]").says("a number is wanted"));
    const Refusal text = refused_entry("\"1/\"");
    CHECK(text.name == "t.json:1");
    CHECK(text.marked == "1/[]");
    CHECK(refused_entry("\"tau\"").says("cannot depend on `tau`"));
    CHECK(refused_entry("\"roots(tau)\"").says("`roots`"));
    CHECK(refused_entry("\"bspline(1,0)\"").says("`bspline`"));
    CHECK(refused_entry("\"1, 2\"").status == 2);
    CHECK(refused_entry("\"gauss:2\"").status == 2);
    CHECK(refused_entry("1e-1001").says("exponent"));
}

TEST_CASE("names are printable, and short") {
    const auto named = [](const std::string& name) {
        return refused_coefficients(R"({"A": [[0]], "b": [1], "c": [0], "name": )" + name + "}");
    };
    CHECK(named("\"\"").status == 0);
    CHECK(named("null").status == 0);
    CHECK(named("\"Kutta's 3/8 rule\"").status == 0);
    CHECK(named("7").status == 2);
    CHECK(named("\"a\\nb\"").status == 2);
    CHECK(named("\"\\u001b[31m\"").status == 2);
    CHECK(named("\"" + std::string(65, 'x') + "\"").status == 2);
}

TEST_CASE("symbols are parameters, and can be given values") {
    Coefficients rule = read_coefficients(R"json({"A": [["w/2"]], "b": [1], "c": ["cos(v)"]})json");
    CHECK(parameter_names(rule) == std::vector<std::string>{"v", "w"});
    set_parameter(rule, parse_parameter(source("w=1/3")));
    REQUIRE(rule.parameters.size() == 1);
    CHECK(rule.origin == "--tableau t.json --param \"w=1/3\"");
    const Refusal unknown = refusal([&] {
        set_parameter(rule, parse_parameter(source("u=1")));
        return 0;
    });
    CHECK(unknown.says("the tableau has no parameter `u`"));
}

TEST_CASE("a decimal tells its digits") {
    const auto digits = [](const std::string& text) {
        const auto found = decimal_digits(text);
        return found ? std::pair(found->significant, found->last_place) : std::pair(-1, 0L);
    };
    CHECK(digits("0.25") == std::pair(2, -2L));
    CHECK(digits(" -0.0012340 ") == std::pair(5, -7L));
    CHECK(digits("12.5e3") == std::pair(3, 2L));
    CHECK(digits("1e-20") == std::pair(1, -20L));
    CHECK(digits("+.5E+1") == std::pair(1, 0L));
    CHECK(digits("0.000") == std::pair(0, -3L));
    for (const char* const text :
         {"12", "1/2", "0.5+0", "", ".", "e5", "1e", "1.2.3", "-", "0x1p3"}) {
        CAPTURE(text);
        CHECK(digits(text) == std::pair(-1, 0L));
    }
}

TEST_CASE("long decimals look rounded, and short ones exact") {
    CHECK(rounded({"0.5", "0.0625", "1", "\"1/3\""}) == "----");
    CHECK(rounded({"0.21132", "0.78867"}) == "--");
    CHECK(rounded({"0.211325", "0.788675", "0.5", "0.25"}) == "rr--");
    CHECK(rounded({"0.2113248654051871", "0.5", "0.15625", "0.0009765625"}) == "r---");
    // Up to two digits less, or an end at about the same place.
    CHECK(rounded({"0.33333333333333", "0.444444444444", "0.55555555555"}) == "rr-");
    CHECK(rounded({"0.33333333333333", "0.00000000000123", "0.0000000000000"}) == "rr-");
    // A double has 15 digits at least, whatever else is in the file.
    CHECK(rounded({"0.1111111111111111111111111111", "0.333333333333333"}) == "rr");
    CHECK(rounded({"12345678", "\"0.3333333333+0\""}) == "--");
    CHECK(rounded({"\"0.3333333333\"", "3333333333e-10"}) == "rr");
}
