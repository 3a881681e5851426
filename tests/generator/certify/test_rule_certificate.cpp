// Properties of the general Galerkin form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "generator/certify/rule_certificate.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

RuleCertificate certificate(const std::string& basis, const std::string& nodes, int max_order) {
    return std::get<RuleCertificate>(certify(method(basis, nodes), max_order));
}

/// `w=1/2: order 4` for each.
std::vector<std::string> exceptions_of(const RuleCertificate& certificate) {
    std::vector<std::string> result;
    for (const ExceptionalValue& value : certificate.exceptions)
        result.push_back(value.parameter + "=" + text(value.value) + ": order " +
                         std::to_string(value.order));
    return result;
}

Method with_weights(const std::string& basis, const std::string& nodes,
                    const std::string& weights) {
    return method_from_text(source(basis, "--basis"), source(nodes, "--nodes"),
                            source(weights, "--weights"));
}

/// 1, tau .. tau^(s-1)
std::string powers(int s) {
    std::string result = "1";
    for (int k = 1; k < s; ++k) result += ", tau^" + std::to_string(k);
    return result;
}

using Real = long double;

/// P_0 .. P_(count-1) of Legendre.
std::vector<Real> legendre_values(std::size_t count, Real x) {
    std::vector<Real> P{1, x};
    for (std::size_t k = 2; k < count; ++k) {
        const auto n = static_cast<Real>(k);
        P.push_back(((2 * n - 1) * x * P[k - 1] - (n - 1) * P[k - 2]) / n);
    }
    return P;
}

/// Gauss' rule with r nodes and the velocities of degree less than s: by Newton's method, and by
/// Legendre's polynomials, for which G = I.
struct Numbers {
    std::vector<Real> c, b;
    std::vector<std::vector<Real>> n;

    Numbers(std::size_t s, std::size_t r) {
        for (std::size_t i = 0; i < r; ++i) {
            const auto size = static_cast<Real>(r);
            Real x =
                -std::cos(std::acos(Real(-1)) * (static_cast<Real>(i) + 0.75L) / (size + 0.5L));
            Real slope = 0;
            for (int round = 0; round < 30; ++round) {
                const std::vector<Real> P = legendre_values(r + 1, x);
                slope = size * (P[r - 1] - x * P[r]) / (1 - x * x);
                x -= P[r] / slope;
            }
            c.push_back((1 + x) / 2);
            b.push_back(1 / ((1 - x * x) * slope * slope));
        }
        for (std::size_t i = 0; i < r; ++i) {
            n.emplace_back();
            for (std::size_t j = 0; j < r; ++j) n[i].push_back(c[i] - symmetric(s, c[i], c[j]));
        }
    }

    /// The largest N for which sum b_i c_i^(k-1) = 1/k holds up to k = N, and with f = c^m
    /// sum_i b_i c_i^a (abar f)_i = 1/((m+1) (m+2) k) for k = a + m + 3 <= N.
    [[nodiscard]] int order() const {
        int k = 1;
        while (bushy(k) && two_levels(k)) ++k;
        return k - 1;
    }

private:
    /// The sum of A_k(x) A_k(y), A_k = (P_(k+1) - P_(k-1))(2x-1)/(2 sqrt(2k+1)), A_0 = x.
    static Real symmetric(std::size_t s, Real x, Real y) {
        const std::vector<Real> P = legendre_values(s + 1, 2 * x - 1);
        const std::vector<Real> R = legendre_values(s + 1, 2 * y - 1);
        Real sum = x * y;
        for (std::size_t k = 1; k < s; ++k) {
            sum +=
                (P[k + 1] - P[k - 1]) * (R[k + 1] - R[k - 1]) / static_cast<Real>(4 * (2 * k + 1));
        }
        return sum;
    }

    static bool is_zero(Real residual) { return std::abs(residual) < 1e-16L; }

    [[nodiscard]] bool bushy(int k) const {
        Real sum = 0;
        for (std::size_t i = 0; i < c.size(); ++i) sum += b[i] * std::pow(c[i], k - 1);
        return is_zero(sum - 1 / Real(k));
    }

    [[nodiscard]] bool two_levels(int k) const {
        for (int m = 0; m + 3 <= k; ++m) {
            Real sum = 0;
            for (std::size_t i = 0; i < c.size(); ++i) {
                for (std::size_t j = 0; j < c.size(); ++j) {
                    sum += b[i] * std::pow(c[i], k - 3 - m) * b[j] * n[i][j] * std::pow(c[j], m);
                }
            }
            if (!is_zero(sum - 1 / (Real(m + 1) * Real(m + 2) * Real(k)))) return false;
        }
        return true;
    }
};

}  // namespace

TEST_CASE("a fourth node of Gauss keeps order 6, and takes the intervals of stability away") {
    // By an independent computation: the first interval ends at 3.142467, the next one begins at
    // sqrt(10).
    const RuleCertificate found = certificate("1, tau, tau^2", "gauss:4", 7);
    CHECK(found.nystrom.order == 6);
    CHECK_FALSE(found.nystrom.is_at_least);
    REQUIRE(found.stability);
    REQUIRE(found.stability->stable.size() >= 2);
    CHECK(found.stability->stable[0].high.nearest_double() == Approx(3.142467).margin(5e-7));
    CHECK(found.stability->stable[1].low.nearest_double() == Approx(std::sqrt(10.0)));
    CHECK(found.oscillator->determinant_one.holds);
    CHECK(found.is_proved());
}

TEST_CASE("orders, symmetry and what is explicit") {
    const RuleCertificate verlet = certificate("1", "0, 1", 4);
    CHECK(verlet.nystrom.order == 2);
    CHECK(verlet.symmetric.holds);
    CHECK(verlet.symplectic.holds);
    CHECK(verlet.is_explicit);
    CHECK(verlet.stability->stable[0].high.nearest_double() == Approx(2.0));

    const RuleCertificate simpson = certificate("1, tau", "0, 1/2, 1", 5);
    CHECK(simpson.nystrom.order == 4);
    CHECK(simpson.symmetric.holds);
    CHECK_FALSE(simpson.is_explicit);

    // Nodes that are not symmetric: the rule is exact for degree 2.
    const RuleCertificate skew = certificate("1, tau", "1/3, 1/2, 1", 5);
    CHECK_FALSE(skew.symmetric.holds);
    CHECK(skew.symmetric.proved);
    CHECK(skew.symplectic.holds);
    // Weights 27/160 and so on have none below zero; of 1/4, 1/2, 3/4 the middle one is -1/3.
    CHECK(certificate("1, tau", "1/4, 1/2, 3/4", 4).negative_weights ==
          std::vector<std::size_t>{2});
    CHECK(certificate("1", "-1/2, 3/2", 2).nodes_outside == std::vector<std::size_t>{1, 2});
}

TEST_CASE("a rule whose table is not that of (4.6) is found out") {
    GalerkinRule rule =
        std::get<GalerkinRule>(derive_any(with_weights("1, tau", "0, 1/2, 1", "1/6, 2/3, 1/6")));
    CHECK(certify(rule, 4).symplectic.holds);
    rule.n[1][0] = rule.n[1][0] + Number(1);
    CHECK_FALSE(certify(rule, 4).symplectic.holds);
}

TEST_CASE("at the roots of any polynomial over Q all of it is proved") {
    for (int s = 2; s <= 8; ++s) {
        for (int r = std::max(6, s + 1); r <= 12; ++r) {
            const RuleCertificate found =
                certificate(powers(s), "gauss:" + std::to_string(r), 2 * s + 1);
            CAPTURE(s, r);
            // Not more than 2s or what the rule is exact for, 2r.
            CHECK(found.nystrom.order == 2 * s);
            const Numbers numbers(static_cast<std::size_t>(s), static_cast<std::size_t>(r));
            CHECK(numbers.order() == 2 * s);
            CHECK_FALSE(found.nystrom.is_at_least);
            CHECK(found.nystrom.failures.front().residual.closed_form());
            CHECK(found.symplectic.holds);
            CHECK(found.symmetric.holds);
            CHECK(found.is_proved());
        }
    }
}

TEST_CASE("that an order is smaller is proved, by a rational number") {
    // c = (1 + cos(2 pi k/9))/2 for k = 1, 2, 4: c^3 is (96 c^2 - 36 c + 1)/64, whose integral is
    // 15/64 in place of 16/64.
    const RuleCertificate found = certificate("1, tau", "roots(64*tau^3-96*tau^2+36*tau-1)", 5);
    CHECK(found.nystrom.order == 3);
    const auto& failures = found.nystrom.failures;
    const auto bushy =
        std::find_if(failures.begin(), failures.end(),
                     [](const FailedCondition& failed) { return failed.tree->text == "g[f,f,f]"; });
    REQUIRE(bushy != failures.end());
    CHECK(same(text(bushy->residual), "-1/64"));
    CHECK(found.symplectic.holds);
    CHECK_FALSE(found.symmetric.holds);
    CHECK(found.is_proved());
    // The nodes are symmetric, and the span is not.
    const RuleCertificate skew = certificate("1, tau^2", "gauss:6", 3);
    CHECK_FALSE(skew.symmetric.holds);
    CHECK(skew.is_proved());
    CHECK(certificate("1, (2*tau-1)^3", "gauss:6", 3).symmetric.holds);
}

TEST_CASE("a rule may be exact for more than interpolation makes it") {
    CHECK(certificate("1, tau^7", "gauss:6", 3).is_proved());
    // Gauss' rule with n nodes is off by 1/((2n+1) (2n over n)^2) for tau^(2n).
    const Refusal inexact = refusal([] { return certificate("1, tau^12", "gauss:6", 3); });
    CHECK(inexact.says("off by -1/11099088"));
}

TEST_CASE("the map of the oscillator over Q is that by the coefficients") {
    const std::string small = "1/4-sqrt(30)/72", large = "1/4+sqrt(30)/72";
    const Method by_coefficients =
        with_weights("1, tau", "gauss:4", small + ", " + large + ", " + large + ", " + small);
    const auto half_trace = [](const AnyCertificate& found) {
        return to_text(
            closed_form(std::get<RuleCertificate>(found).oscillator->half_trace).value());
    };
    const std::string expected = half_trace(certify(by_coefficients, 3));
    // Products of velocities and of positions have degree 4: from three nodes on all are the same.
    for (const std::string nodes : {"gauss:3", "gauss:4", "gauss:6", "gauss:11"}) {
        CHECK(half_trace(certificate("1, tau", nodes, 3)) == expected);
    }
}

TEST_CASE("values of a parameter that raise the order of the general form are found") {
    // The interpolatory rule has order 3, and for w = 1/2, Simpson's, order 4.
    const RuleCertificate lines = certificate("1, tau", "0, w, 1", 8);
    CHECK(lines.nystrom.order == 3);
    CHECK(exceptions_of(lines) == std::vector<std::string>{"w=1/2: order 4"});
    CHECK(certificate("1, tau", "0, 1/2, 1", 8).nystrom.order == 4);
    CHECK(certificate("1, tau", "0, 1/2, 1", 8).exceptions.empty());
}
