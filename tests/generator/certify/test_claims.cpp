// Claims of the paper (Leok & Zhang) about its methods, and the facts. Both are printed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <functional>
#include <iostream>

#include <catch2/catch.hpp>

#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/oscillator.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/exact/methods/stability.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

std::string order(const std::string& method) {
    const Orders found = orders(tableau(method), 8);
    return fmt::format("{}, separable {}, Nystrom {}", found.general.order, found.separable.order,
                       found.nystrom.order);
}

std::string symplectic(const PartitionedMethod& method) {
    const Verdict verdict = is_symplectic(method);
    REQUIRE(verdict.proved);
    return verdict.holds ? "symplectic" : "not symplectic";
}

/// Example 4.5 with an A~ as given.
std::string verlet_with(const NumberMatrix& A_tilde) {
    PartitionedMethod method = partitioned_method(tableau("stormer-verlet"));
    method.A_tilde = A_tilde;
    return symplectic(method);
}

std::string invariants(const std::string& method) {
    const bool symplectic = is_symplectic(tableau(method)).holds;
    const bool same = is_runge_kutta(tableau(method)).holds;
    return symplectic && same ? "all quadratic" : symplectic ? "q^T C p" : "linear";
}

std::string stable_intervals(const std::string& method) {
    const auto stability = linear_stability(oscillator_map(tableau(method)), 20);
    std::string result;
    for (const StabilityInterval& interval : stability.stable) {
        result += fmt::format("{}({}, {})", result.empty() ? "" : " ", text(interval.low),
                              text(interval.high));
    }
    return result;
}

std::string refusal(const std::string& given) {
    try {
        (void)tableau(given);
    } catch (const MathError& error) { return error.what(); }
    return "there is such a method";
}

std::string adjoints() {
    const Tableau one = tableau("symplectic-euler");
    const Tableau other = tableau("adjoint-symplectic-euler");
    // b_j - a_ij for the stages in reverse: one stage.
    const bool adjoint = (one.b[0] - one.A[0][0] - other.A[0][0]).is_zero() &&
                         (one.b[0] - one.A_tilde[0][0] - other.A_tilde[0][0]).is_zero();
    return adjoint ? "adjoint" : "not adjoint";
}

/// q_1(q_0, p_1) to first order in h for H = (p^2 + q^2)/2, one stage with c = 1/2 and b = 1: from
/// H_d^+ = ext p_1 (q_0 + h V) - factor (P V - (P^2 + Q^2)/2), Q = q_0 + h V/2, whose stationarity
/// is V = P and h p_1 - factor P + factor h Q/2 = 0.
std::string first_order(const char* factor_text) {
    return on_new_ground([&](const Ground& ground) {
        const Number h = ground.parameter("h");
        const Number factor = read(factor_text, ground);
        // q_1 = q_0 + slope p_1 + ..., with V (factor - factor h^2/4) = h p_1 + ...
        const Number slope = h * h / (factor * (Number(1) - h * h / Number(4)));
        const bool consistent =
            !(slope - h).is_zero() && (slope * (Number(1) - h * h / Number(4)) - h).is_zero();
        return std::string(consistent ? "q_0 + h p_1 + O(h^2)" : "not q_0 + h p_1 + O(h^2)");
    });
}

struct Claim {
    const char* place;
    const char* subject;
    const char* paper;
    const char* truth;
    std::function<std::string()> found;
};

const Number half = Number(1) / Number(2);

const std::vector<Claim> claims{
    {"Example 4.4 (i)", "order of symplectic Euler", "1", "1, separable 1, Nystrom 1",
     [] { return order("symplectic-euler"); }},
    {"Example 4.4 (ii)", "order of the midpoint rule", "2", "2, separable 2, Nystrom 2",
     [] { return order("midpoint"); }},
    {"Example 4.4 (iii)", "(i) and (iii) are", "adjoint", "adjoint", adjoints},
    {"Example 4.5", "A~ = (0 0; 1/2 1/2), as printed", "symplectic", "not symplectic",
     [] {
         return verlet_with({{0, 0}, {half, half}});
     }},
    {"Example 4.5", "A~ = (1/2 0; 1/2 0), as computed", "", "symplectic",
     [] {
         return verlet_with({{half, 0}, {half, 0}});
     }},
    {"Example 4.6", "order of trig3", "2", "2, separable 2, Nystrom 2",
     [] { return order("trig3"); }},
    {"Example 4.7 (i)", "order, one node", "2", "2, separable 2, Nystrom 2",
     [] { return order("chebyshev:1"); }},
    {"Example 4.7 (ii)", "order, two nodes", "4", "4, separable 4, Nystrom 4",
     [] { return order("chebyshev:2"); }},
    {"Example 4.7 (iii)", "order of Cheby4", "4", "4, separable 4, Nystrom 4",
     [] { return order("chebyshev:3"); }},
    {"Section 4.2", "order at four equal distances", "that of the quadrature, 4",
     "2, separable 2, Nystrom 2", [] { return order("newton-cotes:4"); }},
    {"before (4.6)", "b_i != 0", "without loss of generality",
     "the weight of node 1, c = 0, is zero, and step 5 divides by it",
     [] { return refusal("1, tau, tau^2 | 0, 1/3, 1"); }},
    {"(5.7), printed", "q_1 for the midpoint", "q_0 + h p_1 + O(h^2)", "not q_0 + h p_1 + O(h^2)",
     [] { return first_order("1"); }},
    {"(5.7), h sum b_i R", "q_1 for the midpoint", "", "q_0 + h p_1 + O(h^2)",
     [] { return first_order("h"); }},
    {"Section 6", "invariants that GauLe4 keeps", "(p^2 + w^2 q^2)/2", "all quadratic",
     [] { return invariants("gauss:2"); }},
    {"Section 6", "invariants that Cheby4 keeps", "q p alone", "q^T C p",
     [] { return invariants("chebyshev:3"); }},
    {"Figure 7", "Cheby4 is bounded for h w in", "the whole experiment, h w = 0.5",
     "(0, 2*sqrt(2)) (4*sqrt(6)/3, 2*sqrt(6)) (4*sqrt(6), 20)",
     [] { return stable_intervals("chebyshev:3"); }},
};

}  // namespace

TEST_CASE("what the paper claims, and what is true") {
    for (const Claim& claim : claims) {
        const std::string found = claim.found();
        std::cout << fmt::format("{:<18}  {:<32}  paper: {:<27}  found: {}\n", claim.place,
                                 claim.subject, claim.paper, found);
        CAPTURE(claim.place, claim.subject);
        CHECK(found == claim.truth);
    }
}
