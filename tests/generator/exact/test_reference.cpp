// Values that another computer algebra system computed, independently of this project.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>

#include <catch2/catch.hpp>

#include "tests/generator/exact/reference.hpp"

using namespace hvi::gen;

namespace {

bool has_reference_value(const Number& entry, const std::string& expected) {
    if (entry.has_parameters()) return same(text(entry), expected);
    return close(entry.decimal(50), expected);
}

bool has_reference_value(const Number& entry, const Json& expected) {
    const auto value = expected.get<std::string>();
    if (has_reference_value(entry, value)) return true;
    UNSCOPED_INFO(text(entry) << " is not " << value);
    return false;
}

template <class Entries>
bool has_reference_value(const std::vector<Entries>& entries, const Json& expected) {
    if (entries.size() != expected.size()) return false;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!has_reference_value(entries[i], expected[i])) return false;
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
        CHECK(has_reference_value(tableau.c, entry["c"]));
        CHECK(has_reference_value(tableau.b, entry["b"]));
        CHECK(has_reference_value(tableau.A, entry["A"]));
        CHECK(has_reference_value(tableau.A_tilde, entry["A_tilde"]));
        CHECK(has_reference_value(tableau.c_tilde, entry["c_tilde"]));
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
