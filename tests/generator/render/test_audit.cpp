// Audits: what stands where in JSON and in text. What is found out is checked in
// tests/generator/certify.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/render/certificate.hpp"
#include "tests/generator/certify/audit.hpp"

using namespace hvi::gen;
using Read = nlohmann::json;

namespace {

Read json_of(const std::string& tableau) { return Read::parse(render_json(audit_of(tableau, 4))); }

/// The lines of the text, each at most 80 columns wide.
std::vector<std::string> lines_of(const std::string& tableau) {
    std::vector<std::string> lines;
    std::istringstream stream(render_text(audit_of(tableau, 4)));
    for (std::string line; std::getline(stream, line);) {
        CHECK(line.size() <= 80);
        lines.push_back(line);
    }
    return lines;
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
}

}  // namespace

TEST_CASE("an audit has the fields of a certificate and an object of its own") {
    const Read found = json_of(lobatto_3);
    const Read direct = Read::parse(render_json(certify(derive(method("lobatto:3")), 4)));
    for (const auto& [key, value] : direct.items()) {
        CAPTURE(key);
        if (key != "name") { CHECK(found[key] == value); }
    }
    CHECK(found.size() == direct.size() + 1);
    CHECK(found["audit"] == Read::parse(R"({"is": "lobatto:3",
            "meant": {"method": "lobatto:3", "A": "A", "A_tilde": "A_tilde", "compared": 24},
            "wrong": [], "trusted_digits": null, "within_digits": false, "rounded": 0,
            "digits": null, "as_written": null, "symplectic_defect": null,
            "row_sums": {"A": true, "A_tilde": true}})"));
}

TEST_CASE("wrong entries in JSON") {
    const Read audit = json_of(replaced(lobatto_3, "\"-1/6\"", "\"1/6\""))["audit"];
    CHECK(audit["is"].is_null());
    CHECK(audit["meant"]["method"] == "lobatto:3");
    REQUIRE(audit["wrong"].size() == 1);
    CHECK(audit["wrong"][0]["entry"] == "A_tilde[1][2]");
    CHECK(audit["wrong"][0]["given"] == "1/6");
    CHECK(audit["wrong"][0]["right"]["exact"] == "-1/6");
    CHECK(audit["wrong"][0]["right"]["double"] == "-0x1.5555555555555p-3");
    CHECK(audit["trusted_digits"] == 0);
    CHECK(audit["symplectic_defect"]["i"] == 1);
    CHECK(audit["symplectic_defect"]["j"] == 2);
    CHECK(audit["symplectic_defect"]["residual"]["exact"] == "1/18");
    CHECK(audit["row_sums"] == Read({{"A", true}, {"A_tilde", false}}));
}

TEST_CASE("decimals in JSON") {
    const Read found = json_of(gauss_3);
    CHECK(found["order"] == 4);
    CHECK(found["order_is_at_least"] == true);
    CHECK(found["proved"] == false);
    CHECK(found["audit"]["is"] == "gauss:3");
    CHECK(found["audit"]["within_digits"] == true);
    CHECK(found["audit"]["rounded"] == 14);
    CHECK(found["audit"]["digits"] == 16);
    CHECK(found["audit"]["trusted_digits"] == 16);
    CHECK(found["audit"]["as_written"]["symplectic"] == false);
    CHECK(found["audit"]["as_written"]["order"] == 2);
    CHECK(found["linear_stability"]["determinant_is_one"] == true);
    const Read wrong = json_of(replaced(gauss_3, "-0.0359766675249389", "-0.0359766675279389"));
    CHECK(wrong["audit"]["is"].is_null());
    CHECK(wrong["audit"]["wrong"][0]["right"]["exact"] == "2/9-sqrt(15)/15");
    CHECK(wrong["audit"]["trusted_digits"] == 11);
    CHECK(wrong["order"] == 1);
    CHECK(wrong["failures"].size() == 4);
}

TEST_CASE("what is not known is null") {
    const Read kutta = json_of(kutta_4);
    CHECK(kutta["audit"]["is"].is_null());
    CHECK(kutta["audit"]["meant"].is_null());
    CHECK(kutta["audit"]["wrong"].is_null());
    CHECK(kutta["audit"]["trusted_digits"].is_null());
    CHECK(kutta["linear_stability"]["determinant_is_one"] == false);
    CHECK(kutta["linear_stability"]["half_trace"] == "(z^4-12*z^2+24)/24");
    CHECK(kutta["linear_stability"]["stable"][0][1].get<double>() == Approx(std::sqrt(8.0)));
    CHECK(kutta["explicit"] == Read({{"separable", true}, {"general", true}}));
    CHECK(kutta["conserves"] == Read({{"linear", true}, {"qCp", false}, {"quadratic", false}}));
    const Read twice = json_of(printed_example_4_5)["audit"];
    CHECK(twice["is"].is_null());
    CHECK(twice["meant"]["A"] == "A");
    CHECK(twice["meant"]["A_tilde"] == "A");
    CHECK(twice["wrong"] == Read::array());
    const Read weights = json_of(R"({"c": [0], "b": [1], "b_tilde": [2], "A": [[0]]})");
    CHECK(weights["conserves"]["linear"] == false);
    CHECK(weights["audit"]["symplectic_defect"]["j"].is_null());
    const Read unknown = json_of(composition_4);
    CHECK(unknown["audit"]["within_digits"] == true);
    CHECK(unknown["proved"] == false);
    CHECK(unknown["order_is_at_least"] == true);
    for (const char* const key : {"half_trace", "stable", "poles", "touching", "at_infinity"}) {
        CHECK(unknown["linear_stability"][key].is_null());
    }
    CHECK(unknown["linear_stability"]["determinant_is_one"] == false);
    CHECK(unknown["audit"]["as_written"]["symplectic"] == false);
}

TEST_CASE("an audit as text") {
    const auto kutta = lines_of(kutta_4);
    CHECK(kutta.front() == "--tableau t.json");
    CHECK(has(kutta, "is            no method that has a name, and no collocation"));
    CHECK(has(kutta, "row sums      c = A 1 = A~ 1"));
    CHECK(has(kutta, "defect        b_1 a~_11 + b~_1 a_11 - b_1 b~_1 = -1/36 = -0.0277778"));
    CHECK(has(kutta, "determinant   not 1: stable is where both eigenvalues lie inside the unit "
                     "circle"));
    CHECK(has(kutta, "stable        z = h omega in (0, 2.82843)"));
    CHECK(has(kutta, "explicit      for every H"));
    CHECK(kutta.back() == "All of it is proved.");
    const auto lobatto = lines_of(replaced(lobatto_3, "\"-1/6\"", "\"1/6\""));
    CHECK(has(lobatto, "meant         lobatto:3, but for 1 of 24 entries"));
    CHECK(has(lobatto, "wrong         A_tilde[1][2]: 1/6"));
    CHECK(has(lobatto, "              right is -1/6 = -0.166667"));
    CHECK(has(lobatto, "right to      0 decimal places"));
    CHECK(has(lobatto, "row sums      c = A 1, not A~ 1"));
    const auto gauss = lines_of(gauss_3);
    CHECK(has(gauss, "given         14 of 15 numbers look rounded, to 16 digits"));
    CHECK(has(gauss, "is            gauss:3, within the digits given"));
    CHECK(has(gauss, "right to      16 decimal places"));
    CHECK(gauss.back() ==
          "All of this is said of that method, of which these are the first digits.");
    const auto wrong = lines_of(replaced(gauss_3, "-0.0359766675249389", "-0.0359766675279389"));
    CHECK(has(wrong, "wrong         A[1][2]: -0.0359766675279389"));
    CHECK(has(wrong, "              right is 2/9-sqrt(15)/15 = -0.03597666752493890"));
    CHECK(has(wrong, "symplectic    no"));
    const auto unknown = lines_of(composition_4);
    CHECK(has(unknown, "oscillator    not looked at: only some digits are known"));
    CHECK(has(unknown, "symplectic    yes, within digits"));
    CHECK(unknown.back() ==
          "What holds does so within the digits given; what fails is proved to fail.");
    const auto free = lines_of(R"({"c": ["w"], "b": [1], "A": [["w"]]})");
    CHECK(has(free, "is            not compared with other methods: it has a free parameter"));
}

TEST_CASE("the text of an audit has no line that is too wide") {
    for (const int digits : {16, 50}) {
        for (const std::string name : {"gauss:8", "lobatto:8", "chebyshev:9", "trig3"}) {
            CAPTURE(name, digits);
            const std::string json = render_json(derive(method(name)), digits);
            CHECK_FALSE(lines_of(json).empty());
            // An entry that is wrong, and one that is longer than a line.
            const std::size_t at = json.find("\"A_tilde\"");
            const std::size_t begin = json.find("\"exact\": ", at) + 9;
            const std::size_t end = json.find(',', begin);
            REQUIRE(end != std::string::npos);
            const std::string number = "\"-9.7" + std::string(80, '1') + "\"";
            CHECK_FALSE(lines_of(std::string(json).replace(begin, end - begin, number)).empty());
        }
    }
}
