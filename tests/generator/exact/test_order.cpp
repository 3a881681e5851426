// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>

#include <catch2/catch.hpp>

#include "generator/exact/methods/order.hpp"
#include "tests/generator/exact/reference.hpp"

using namespace hvi::gen;

namespace {

OrderConditions general(const std::string& method, int max_order = 8) {
    return orders(tableau(method), max_order).general;
}

/// Computes the order from the coefficients alone.
OrderConditions by_coefficients(const std::string& method, int max_order = 8) {
    return orders(partitioned_method(tableau(method)), max_order).general;
}

/// Whether the order is found, not only bounded, and proved.
bool has_order(const OrderConditions& conditions, int order) {
    UNSCOPED_INFO("found " << conditions.order);
    return conditions.order == order && !conditions.is_at_least && conditions.proved;
}

std::map<std::string, std::string> residuals(const OrderConditions& conditions) {
    std::map<std::string, std::string> result;
    for (const FailedCondition& failed : conditions.failures) {
        result[failed.tree->text] = text(failed.residual);
    }
    return result;
}

/// sum_i b_i Phi_i - 1/gamma by definition.
NumberVector elementary_weights(const PartitionedMethod& method, const Tree& tree) {
    NumberVector result(method.stages(), Number(1));
    for (const TreePointer& child : tree.children) {
        const NumberMatrix& A = child->root == Colour::f ? method.A : method.A_tilde;
        const NumberVector values = elementary_weights(method, *child);
        for (std::size_t i = 0; i < result.size(); ++i) {
            Number sum;
            for (std::size_t j = 0; j < values.size(); ++j) { sum = sum + A[i][j] * values[j]; }
            result[i] = result[i] * sum;
        }
    }
    return result;
}

Number residual(const PartitionedMethod& method, const Tree& tree) {
    const NumberVector& b = tree.root == Colour::f ? method.b : method.b_tilde;
    const NumberVector Phi = elementary_weights(method, tree);
    Number sum = Number(-1) / Number(tree.density);
    for (std::size_t i = 0; i < b.size(); ++i) { sum = sum + b[i] * Phi[i]; }
    return sum;
}

bool agrees(const OrderConditions& found, const Json& expected, TreeFamily family) {
    std::vector<FailedCondition> failures = found.failures;
    if (family == TreeFamily::general) {  // the reference has the roots f, and both have b
        std::erase_if(failures, [](const auto& one) { return one.tree->root == Colour::g; });
    }
    const Json& first = expected["first"];
    if (found.order != expected["order"] || found.is_at_least != first.empty() ||
        failures.size() != expected["failures"].get<std::size_t>()) {
        return false;
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
        const auto tree = first[i][0].get<std::string>();
        const auto residual = first[i][1].get<std::string>();
        if (failures[i].tree->text != tree) { return false; }
        if (!close(residual, failures[i].residual.decimal(45))) { return false; }
    }
    return true;
}

}  // namespace

TEST_CASE("orders and violated conditions agree with the reference") {
    const Json expected = reference("exact/reference_order.json");
    int methods = 0;
    for (const Json& entry : reference_methods()) {
        const auto name = entry["name"].get<std::string>();
        if (!expected.contains(name)) { continue; }
        CAPTURE(name);
        const Orders found = orders(derive(method_of(entry)), 6);
        CHECK(agrees(found.general, expected[name]["general"], TreeFamily::general));
        CHECK(agrees(found.separable, expected[name]["separable"], TreeFamily::separable));
        CHECK(agrees(found.nystrom, expected[name]["nystrom"], TreeFamily::nystrom));
        ++methods;
    }
    CHECK(methods == 49);
}

TEST_CASE("the families' orders are found and proved") {
    for (int s = 1; s <= 4; ++s) {
        CAPTURE(s);
        const std::string size = std::to_string(s);
        CHECK(has_order(general("gauss:" + size, 9), 2 * s));
        if (s == 1) { continue; }
        CHECK(has_order(general("lobatto:" + size), 2 * s - 2));
        CHECK(has_order(general("radau-left:" + size), 2 * s - 1));
        CHECK(has_order(general("radau-right:" + size), 2 * s - 1));
    }
    CHECK(has_order(general("symplectic-euler"), 1));
    CHECK(has_order(general("stormer-verlet"), 2));
    CHECK(has_order(general("trig3"), 2));
    CHECK(has_order(general("chebyshev:4"), 6));
    CHECK(has_order(general("chebyshev:9"), 4));
    CHECK(has_order(general("newton-cotes:9"), 4));
    CHECK(has_order(general("newton-cotes:12"), 2));
    CHECK(has_order(general("clenshaw-curtis:12"), 2));
    CHECK(has_order(general("fejer:11"), 4));
}

TEST_CASE("what holds up to the largest order asked for is a lower bound") {
    for (const auto& [method, order] :
         {std::pair{"gauss:8", 16}, {"gauss:32", 8}, {"lobatto:9", 16}}) {
        CAPTURE(method);
        const Orders found = orders(tableau(method), order);
        for (const OrderConditions& conditions : {found.general, found.separable, found.nystrom}) {
            CHECK(conditions.order == order);
            CHECK(conditions.is_at_least);
            CHECK(conditions.proved);
            CHECK(conditions.failures.empty());
            CHECK_FALSE(conditions.error_constant_squared);
            CHECK(conditions.conditions.size() == static_cast<std::size_t>(order));
        }
    }
}

TEST_CASE("the coefficients alone give the same as interpolation") {
    for (const char* const method :
         {"gauss:2", "gauss:3", "gauss:4", "lobatto:4", "radau-left:3", "chebyshev:3",
          "chebyshev:4", "newton-cotes:5", "clenshaw-curtis:5", "radau-right:2"}) {
        CAPTURE(method);
        const OrderConditions one = general(method);
        const OrderConditions other = by_coefficients(method);
        CHECK(one.order == other.order);
        CHECK(one.is_at_least == other.is_at_least);
        CHECK(other.proved);
        CHECK(residuals(one) == residuals(other));
        CHECK(one.is_at_least == !one.error_constant());
        if (one.error_constant()) {
            CHECK(text(*one.error_constant()) == text(*other.error_constant()));
        }
    }
}

TEST_CASE("residuals are those of the definition") {
    for (const char* const method : {"trig3", "1, tau | 0, 2/3", "1, tau, exp(tau) | 0, 1/2, 1",
                                     "gauss:2", "1, cos(w*tau) | 0, 1"}) {
        CAPTURE(method);
        const PartitionedMethod coefficients = partitioned_method(tableau(method));
        const OrderConditions found = orders(coefficients, 8).general;
        const auto failures = residuals(found);
        for (const auto& level : trees(TreeFamily::general, found.order + 1)) {
            for (const TreePointer& tree : level) {
                const Number expected = residual(coefficients, *tree);
                const auto failed = failures.find(tree->text);
                CHECK(expected.is_zero() == (failed == failures.end()));
                if (failed != failures.end()) { CHECK(failed->second == text(expected)); }
            }
        }
    }
}

TEST_CASE("weights for p of their own are seen") {
    PartitionedMethod method = partitioned_method(tableau("gauss:2"));
    method.b_tilde = {Number(1), Number(0)};
    const OrderConditions found = orders(method, 8).general;
    CHECK(has_order(found, 1));
    CHECK(residuals(found) ==
          std::map<std::string, std::string>{{"g[f]", "-sqrt(3)/6"}, {"g[g]", "-sqrt(3)/6"}});
}

TEST_CASE("a wrong digit lowers the order") {
    PartitionedMethod method = partitioned_method(tableau("gauss:3"));
    CHECK(orders(method, 6).general.order == 6);
    const Number digit = Number(1) / Number(1000000000000);
    method.A[1][2] = method.A[1][2] + digit;
    const Orders found = orders(method, 6);
    CHECK(has_order(found.general, 1));
    CHECK(residuals(found.general) ==
          std::map<std::string, std::string>{{"f[f]", "1/2250000000000"},
                                             {"g[f]", "1/2250000000000"}});
    method.b[0] = method.b[0] + digit;
    CHECK(has_order(orders(method, 6).general, 0));
}

TEST_CASE("Lobatto IIIB-IIIA, and IIIB alone, are of order 4") {
    PartitionedMethod method = partitioned_method(tableau("lobatto:3"));
    std::swap(method.A, method.A_tilde);
    CHECK(has_order(orders(method, 8).general, 4));
    method.A_tilde = method.A;  // Lobatto IIIB alone
    CHECK(has_order(orders(method, 8).general, 4));
}

TEST_CASE("the error constant is the norm of the leading coefficients") {
    // Midpoint: the residuals of f[f,f], f[f,g], f[g,g] are -1/12, of the four chains 1/12; sigma
    // is 2, 1, 2; and all that twice, for both roots.
    const OrderConditions midpoint = general("midpoint");
    REQUIRE(midpoint.error_constant_squared);
    CHECK(text(*midpoint.error_constant_squared) == "11/144");
    CHECK(text(midpoint.error_constant().value()) == "sqrt(11)/12");
    const OrderConditions trigonometric = general("trig3");
    REQUIRE(trigonometric.error_constant());
    const double constant = trigonometric.error_constant()->nearest_double();
    CHECK(constant * constant == Approx(trigonometric.error_constant_squared->nearest_double()));
    CHECK_FALSE(general("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1").error_constant());
}

TEST_CASE("with a free parameter the factors of the coefficients give the same residuals") {
    for (const std::string method :
         {"1, cos(w*tau), sin(w*tau) | 0, 1/2, 1", "1, exp(w*tau) | 1/5, 2/3",
          "1, cos(w*tau), tau | 0, 1/3, 1"}) {
        CAPTURE(method);
        const OrderConditions by_factors = orders(tableau(method), 8).general;
        const OrderConditions other = orders(partitioned_method(tableau(method)), 8).general;
        CHECK(by_factors.order == other.order);
        REQUIRE(by_factors.failures.size() == other.failures.size());
        for (std::size_t i = 0; i < other.failures.size(); ++i) {
            CHECK(by_factors.failures[i].tree->text == other.failures[i].tree->text);
            CHECK(text(by_factors.failures[i].residual) == text(other.failures[i].residual));
        }
    }
}

TEST_CASE("thousands of terms with a free parameter are not squared for an error constant") {
    const Orders found = orders(tableau("1, tau, cos(w*tau), sin(w*tau) | gauss:4"), 8);
    CHECK(has_order(found.general, 2));
    CHECK(found.general.failures.size() == 14);
    CHECK_FALSE(found.general.error_constant_squared);
    CHECK_FALSE(found.nystrom.error_constant_squared);
}

TEST_CASE("beyond the listed sizes there is a tree for each value") {
    const OrderConditions found = general("gauss:5", 12);
    CHECK(has_order(found, 10));
    CHECK(found.failures.size() < 100);
    CHECK_FALSE(found.error_constant_squared);
    CHECK(found.conditions.back() == 2119904);
    for (const FailedCondition& failed : found.failures) {
        CHECK(failed.tree->vertices == 11);
        CHECK_FALSE(failed.residual.is_zero());
    }
}

TEST_CASE("enclosures decide where there is no closed form, and are told of") {
    const OrderConditions found = general("1, exp(tau^2) | 0, 1");
    CHECK(found.order == 1);
    CHECK_FALSE(found.is_at_least);
    CHECK_FALSE(found.proved);
    CHECK(found.failures.size() == 4);
    CHECK(found.failures.front().residual.decimal(10) ==
          (tableau("1, exp(tau^2) | 0, 1").b[1] - Number(1) / Number(2)).decimal(10));
    CHECK(found.error_constant()->sign() == 1);
    // Exact coefficients give a proof.
    const OrderConditions enclosed = by_coefficients("gauss:6", 4);
    CHECK(enclosed.order == 4);
    CHECK_FALSE(enclosed.proved);
    CHECK(general("gauss:6", 4).proved);
}

TEST_CASE("enclosures decide only when they are as narrow as promised") {
    const auto small = [](int digits) {
        Number result(1);
        for (int i = 0; i < digits; ++i) { result = result / Number(10); }
        return result;
    };
    PartitionedMethod method = partitioned_method(tableau("gauss:6"));
    const Number enclosed = method.A[0][1];
    for (const int digits : {45, 100}) {
        CAPTURE(digits);
        method.A[0][1] = enclosed + small(digits);
        const OrderConditions found = orders(method, 3).general;
        CHECK(found.order == 1);
        CHECK(found.failures.size() == 2);  // f[f], g[f]
    }
    const Verdict far = vanishes(method.A[0][1] - (enclosed + small(45)));
    CHECK((!far.holds && far.proved));
    const Verdict near = vanishes(method.A[0][1] - (enclosed + small(100)));
    CHECK((near.holds && !near.proved));
    method.A[0][1] = enclosed + small(300);
    CHECK(orders(method, 3).general.order == 3);
}

TEST_CASE("where no weights are known to be equal it stops before there are millions of them") {
    PartitionedMethod method = partitioned_method(tableau("lobatto:8"));
    method.A_tilde = method.A;  // Lobatto IIIA, of order 14, without closed forms
    const OrderConditions found = orders(method, 20).general;
    CHECK(found.is_at_least);
    CHECK(found.order >= 8);
    CHECK(found.order < 14);
    CHECK(static_cast<int>(found.conditions.size()) == found.order);
    CHECK(found.failures.empty());
}

TEST_CASE("with a free parameter the order is the generic one") {
    CHECK(has_order(general("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1"), 2));
    CHECK(has_order(general("1, tau, tau^2 | 0, w, 1"), 2));
}
