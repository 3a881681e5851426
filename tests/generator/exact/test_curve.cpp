// The curve between the ends of a step, and how far it is from the exact solution.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <utility>

#include <catch2/catch.hpp>

#include "generator/exact/methods/curve.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

Number whole(std::size_t n) { return Number(static_cast<long>(n)); }

/// P_0, ..., P_n of Legendre at 2 tau - 1, by the recurrence.
NumberVector legendre_values(std::size_t n, const Number& tau) {
    const Number x = Number(2) * tau - Number(1);
    NumberVector P{Number(1), x};
    for (std::size_t k = 1; k < n; ++k) {
        P.push_back((whole(2 * k + 1) * x * P[k] - whole(k) * P[k - 1]) / whole(k + 1));
    }
    return P;
}

Number value(const Antiderivative& A, const Number& tau, const Ground& ground) {
    switch (A.kind) {
    case Antiderivative::Kind::power: return power(tau, A.power);
    case Antiderivative::Kind::exponential: return ground.exp(A.rate * tau) - Number(1);
    case Antiderivative::Kind::sine: return ground.sin(A.rate * tau);
    case Antiderivative::Kind::cosine: return ground.cos(A.rate * tau) - Number(1);
    }
    return {};
}

/// g_1, g_2, ... at tau.
NumberVector departures(const Curve& curve, const Number& tau, const Ground& ground) {
    NumberVector g;
    for (const Antiderivative& A : curve.A) {
        g.push_back(value(A, tau, ground) - tau * value(A, Number(1), ground));
    }
    if (!curve.A.empty()) { return g; }
    const std::size_t count = curve.F.front().size();
    const NumberVector P = legendre_values(count + 1, tau);
    for (std::size_t k = 1; k <= count; ++k) { g.push_back((P[k + 1] - P[k - 1]) / Number(2)); }
    return g;
}

/// The integral of phi_j over [0, tau], as the curve has it.
Number integral(const AnyDerivation& derivation, const Curve& curve, std::size_t j,
                const Number& tau) {
    const NumberVector g = departures(curve, tau, derivation.ground);
    Number sum = std::get<Tableau>(derivation.method).b[j] * tau;
    for (std::size_t k = 0; k < g.size(); ++k) { sum = sum + curve.F[j][k] * g[k]; }
    return sum;
}

/// To 60 digits, for numbers that are not known exactly.
bool agree(const Number& left, const Number& right) {
    return (left - right + Number(1)).decimal(60) == Number(1).decimal(60) ||
           (left - right + Number(1)).decimal(60) == "1." + std::string(59, '0');
}

std::size_t order(const std::string& given) {
    return on_new_ground([&](const Ground& ground) {
        const Method method = any_method(given);
        return curve(method, derive_any_on(ground, method)).order;
    });
}

}  // namespace

TEST_CASE("the curve passes through all stage values: its integrals up to c_i are a_ij") {
    const auto given =
        GENERATE(as<std::string>(), "midpoint", "symplectic-euler", "gauss:2", "gauss:4", "gauss:8",
                 "lobatto:3", "lobatto:7", "chebyshev:3", "chebyshev:5", "newton-cotes:4",
                 "1, tau | 0, 1", "1, tau^2 | 1/5, sqrt(2)/2", "1, tau^3, tau | 1/7, 1/2, 1",
                 "trig3", "stormer-verlet", "1, exp(2*tau) | 0, 1",
                 "cos(tau)^2, tau*(1-tau)+exp(-tau), sin(tau)^2, sin(3*tau) | "
                 "0, 1/3, 1/2, 1");
    INFO(given);
    on_new_ground([&](const Ground& ground) {
        const Method method = any_method(given);
        const AnyDerivation derivation = derive_any_on(ground, method);
        const Tableau& tableau = std::get<Tableau>(derivation.method);
        const Curve found = curve(method, derivation);
        for (std::size_t j = 0; j < tableau.stages(); ++j) {
            CHECK(agree(integral(derivation, found, j, Number(1)), tableau.b[j]));
            for (std::size_t i = 0; i < tableau.stages(); ++i) {
                CHECK(agree(integral(derivation, found, j, tableau.c[i]), tableau.A[i][j]));
            }
        }
        return 0;
    });
}

TEST_CASE("Gauss' rule computes the moments: F_jk = b_j P_k(2 c_j - 1)") {
    const auto given = GENERATE(as<std::string>(), "gauss:3", "gauss:9");
    on_new_ground([&](const Ground& ground) {
        const Method method = any_method(given);
        const AnyDerivation derivation = derive_any_on(ground, method);
        const Tableau& tableau = std::get<Tableau>(derivation.method);
        const NumberMatrix F = curve(method, derivation).F;
        for (std::size_t j = 0; j < tableau.stages(); ++j) {
            const NumberVector P = legendre_values(F[j].size(), tableau.c[j]);
            for (std::size_t k = 1; k <= F[j].size(); ++k) {
                CHECK(agree(F[j][k - 1], tableau.b[j] * P[k]));
            }
        }
        return 0;
    });
}

TEST_CASE("with more nodes than functions the curve passes through the positions too") {
    const auto given =
        GENERATE(as<std::string>(), "1, tau | gauss:3", "1, tau | 0, 1/2, 1", "1 | 0, 1",
                 "1, tau, tau^2 | lobatto:5", "1, tau-1/2 | gauss:6", "1, cos(pi*tau) | gauss:3");
    INFO(given);
    on_new_ground([&](const Ground& ground) {
        const Method method = any_method(given);
        const AnyDerivation derivation = derive_any_on(ground, method);
        const auto& rule = std::get<GalerkinRule>(derivation.method);
        const Curve found = curve(method, derivation);
        REQUIRE(found.of_forces);
        for (std::size_t j = 0; j < rule.nodes(); ++j) {
            for (std::size_t i = 0; i < rule.nodes(); ++i) {
                const NumberVector g = departures(found, rule.c[i], derivation.ground);
                // The chord ends at sum_j (1 - c_j) W_j.
                Number sum = rule.c[i] * (Number(1) - rule.c[j]);
                for (std::size_t k = 0; k < g.size(); ++k) {
                    sum = sum + (*found.of_forces)[j][k] * g[k];
                }
                CHECK(agree(sum, rule.n[i][j]));
            }
        }
        return 0;
    });
}

TEST_CASE("with more nodes than functions velocities of the span make their own curve") {
    const auto given = GENERATE(as<std::string>(), "1, tau | gauss:3", "1, tau | 0, 1/2, 1",
                                "1, tau, tau^2 | lobatto:5", "1, cos(pi*tau) | gauss:3");
    INFO(given);
    on_new_ground([&](const Ground& ground) {
        const Method method = any_method(given);
        const AnyDerivation derivation = derive_any_on(ground, method);
        const auto& rule = std::get<GalerkinRule>(derivation.method);
        const Curve found = curve(method, derivation);
        for (std::size_t i = 0; i < rule.nodes(); ++i) {
            const NumberVector g = departures(found, rule.c[i], derivation.ground);
            for (std::size_t l = 0; l < rule.functions(); ++l) {
                Number sum = rule.c[i] * rule.B[l];  // the chord of the integral of psi_l
                for (std::size_t j = 0; j < rule.nodes(); ++j) {
                    for (std::size_t k = 0; k < g.size(); ++k) {
                        sum = sum + rule.Psi[l][j] * found.F[j][k] * g[k];
                    }
                }
                CHECK(agree(sum, rule.A_psi[i][l]));
            }
        }
        return 0;
    });
}

TEST_CASE("the order of the curve") {
    // min(s, r + 1), of a rule with s nodes that is exact for degree s - 1 + r.
    const std::vector<std::pair<std::string, std::size_t>> expected = {
        {"midpoint", 1},
        {"symplectic-euler", 1},
        {"gauss:2", 2},
        {"gauss:3", 3},
        {"gauss:8", 8},
        {"lobatto:3", 2},
        {"lobatto:4", 3},
        {"lobatto:8", 7},
        {"radau-left:3", 3},
        {"chebyshev:3", 2},
        {"chebyshev:4", 3},
        {"chebyshev:5", 2},
        {"newton-cotes:4", 1},
        {"1, tau | 0, 1", 1},
        {"1, tau | 1/2-sqrt(3)/6, 1/2+sqrt(3)/6", 2},
        {"1, tau | 1/3, 1", 2},
        {"1, tau^2 | 0, 1", 1},
        {"trig3", 1},
        {"1, tau, cos(tau) | gauss:3", 1},
        // min(s, u - s + 1), of a rule that is exact for the degrees below u.
        {"1, tau | 0, 1/2, 1", 2},
        {"1, tau | gauss:3", 2},
        {"1, tau, tau^2 | newton-cotes:4", 2},
        {"1, tau, tau^2 | newton-cotes:5", 3},
        {"1, tau, tau^2, tau^3 | gauss:6", 4},
        {"1 | 0, 1", 1},
        {"1, tau^2 | gauss:3", 1},
    };
    for (const auto& [method, number] : expected) {
        INFO(method);
        CHECK(order(method) == number);
    }
}

TEST_CASE("curves that are to come are refused") {
    for (const std::string given :
         {"1, tau*sin(tau) | 0, 1", "1, exp(tau)*cos(tau) | 0, 1", "1, sqrt(tau) | 0, 1",
          "1, abs(tau-1/2) | 0, 1/2", "1, tau | 1/3, w", "1, cos(w*tau) | 0, 1"}) {
        INFO(given);
        CHECK_THROWS_AS(order(given), InputError);
    }
}
