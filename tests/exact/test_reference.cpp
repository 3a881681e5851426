// Values that another computer algebra system computed, independently of this project.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <fstream>
#include <map>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/exact/exact.hpp"

using namespace hvi::gen;
using Json = nlohmann::json;

namespace {

Json reference_methods() {
    std::ifstream file(HVI_REFERENCE);
    return Json::parse(file).at("methods");
}

Method method_of(const Json& entry) {
    if (entry.contains("method")) return method(entry["method"].get<std::string>());
    return method(entry["basis"].get<std::string>(), entry["nodes"].get<std::string>());
}

/// One unit of the last digit of a decimal: 0.3333 has 0.0001, and 1.99e-20 has 0.01e-20.
std::string last_unit(std::string decimal) {
    const std::size_t mantissa = std::min(decimal.find('e'), decimal.size());
    for (std::size_t i = 0; i < mantissa; ++i) {
        if (decimal[i] != '.') decimal[i] = i + 1 < mantissa ? '0' : '1';
    }
    return decimal;
}

/// Whether two decimals differ by one unit of the first one's last digit at most.
bool close(const std::string& left, const std::string& right) {
    const Ground ground(std::make_shared<Field>(Denominators{}));
    const Number a = read(left, ground);
    const Number b = read(right, ground);
    if (a.is_zero() || b.is_zero()) return a.is_zero() && b.is_zero();
    const Number unit = read(last_unit(left), ground);
    return (unit - (a - b)).sign() >= 0 && (unit + (a - b)).sign() >= 0;
}

bool agrees(const Number& entry, const std::string& expected) {
    if (entry.has_parameters()) return same(text(entry), expected);
    return close(entry.decimal(50), expected);
}

bool agrees(const Number& entry, const Json& expected) {
    const auto value = expected.get<std::string>();
    if (agrees(entry, value)) return true;
    UNSCOPED_INFO(text(entry) << " is not " << value);
    return false;
}

template <class Entries>
bool agrees(const std::vector<Entries>& entries, const Json& expected) {
    if (entries.size() != expected.size()) return false;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!agrees(entries[i], expected[i])) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("all coefficients agree with the reference") {
    int methods = 0;
    for (const Json& entry : reference_methods()) {
        if (entry["status"] != "ok") continue;
        CAPTURE(entry["name"]);
        const Tableau tableau = derive(method_of(entry));
        CHECK(agrees(tableau.c, entry["c"]));
        CHECK(agrees(tableau.b, entry["b"]));
        CHECK(agrees(tableau.A, entry["A"]));
        CHECK(agrees(tableau.A_tilde, entry["A_tilde"]));
        CHECK(agrees(tableau.c_tilde, entry["c_tilde"]));
        ++methods;
    }
    CHECK(methods == 50);
}

TEST_CASE("what the reference refuses is refused, for the same reason") {
    const std::map<std::string, std::string> reasons{{"singular_M", "M is singular"},
                                                     {"zero_weight", "is zero, and step 5 divides"},
                                                     {"complex_nodes", "are not all real"}};
    int methods = 0;
    for (const Json& entry : reference_methods()) {
        if (entry["status"] == "ok") continue;
        CAPTURE(entry["name"]);
        const Refusal refused = refusal([&] { return derive(method_of(entry)); });
        CHECK(refused.status == 1);
        CHECK(refused.says(reasons.at(entry["status"].get<std::string>())));
        ++methods;
    }
    CHECK(methods == 16);
}

TEST_CASE("decimals that differ by more than one unit are told apart") {
    CHECK(close("0.3333", "0.3333"));
    CHECK(close("0.3333", "0.3334"));
    CHECK(close("-0.3333", "-0.3332"));
    CHECK(close("1.999e-20", "2.000e-20"));
    CHECK(close("0", "0.0"));
    CHECK_FALSE(close("0.3333", "0.3335"));
    CHECK_FALSE(close("0.3333", "-0.3333"));
    CHECK_FALSE(close("0", "1e-50"));
}
