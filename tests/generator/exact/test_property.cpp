// Properties of every method of Algorithm 4.3, on random nodes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <random>
#include <tuple>

#include <catch2/catch.hpp>

#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

/// Nodes numerator/denominator in [0, 1], all with one denominator.
struct RationalNodes {
    std::vector<long> numerators;
    long denominator = 1;

    [[nodiscard]] std::string list() const {
        std::string result;
        for (const long numerator : numerators) {
            if (!result.empty()) result += ", ";
            result += std::to_string(numerator) + "/" + std::to_string(denominator);
        }
        return result;
    }
};

/// A basis whose span is invariant under tau -> 1 - tau.
struct Basis {
    std::string text;
    std::size_t size;
    long denominator;  ///< for nodes: keeps exponentials and angles readable
};

const std::vector<Basis> bases{
    {"monomials:2", 2, 97},
    {"monomials:3", 3, 97},
    {"monomials:4", 4, 60},
    {"monomials:5", 5, 60},
    {"trig:3", 3, 12},
    {"1, tau, cos(2*pi*tau), sin(2*pi*tau)", 4, 12},
    {"1, exp(tau), exp(-tau)", 3, 5},
    {"1, tau, exp(tau), exp(-tau)", 4, 3},
    {"1, cos(pi*tau), sin(pi*tau)", 3, 7},
};

RationalNodes random_nodes(const Basis& basis, std::mt19937& generator) {
    RationalNodes nodes{{}, basis.denominator};
    while (nodes.numerators.size() < basis.size) {
        // NOTE: std::uniform_int_distribution differs between standard libraries.
        const long numerator =
            static_cast<long>(generator() % static_cast<unsigned long>(basis.denominator + 1));
        const auto& known = nodes.numerators;
        if (std::find(known.begin(), known.end(), numerator) == known.end())
            nodes.numerators.push_back(numerator);
    }
    return nodes;
}

/// A tableau on random nodes; draws again when M is singular or a weight is zero.
struct Drawn {
    RationalNodes nodes;
    Tableau tableau;
};
Drawn draw(const Basis& basis, std::mt19937& generator) {
    for (;;) {
        auto nodes = random_nodes(basis, generator);
        try {
            return {nodes, derive(method(basis.text, nodes.list()))};
        } catch (const MathError&) {}
    }
}

/// The entries of one tableau as texts, with row and column k taken from order[k].
std::vector<std::string> entries(const Tableau& tableau, const std::vector<std::size_t>& order) {
    std::vector<std::string> result;
    for (const std::size_t i : order) {
        for (const Number& entry : {tableau.c[i], tableau.b[i], tableau.c_tilde[i]})
            result.push_back(text(entry));
        for (const std::size_t j : order) {
            result.push_back(text(tableau.A[i][j]));
            result.push_back(text(tableau.A_tilde[i][j]));
        }
    }
    return result;
}

std::vector<std::size_t> ascending(std::size_t count) {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = i;
    return order;
}

}  // namespace

TEST_CASE("random methods are symplectic, and rows sum to nodes") {
    const unsigned seed = GENERATE(1U, 2U);
    std::mt19937 generator(seed);
    for (const Basis& basis : bases) {
        const auto [nodes, tableau] = draw(basis, generator);
        CAPTURE(seed, basis.text, nodes.list());
        const auto& [b, A, A_tilde] = std::tie(tableau.b, tableau.A, tableau.A_tilde);
        CHECK(sum(b).is_one());
        for (std::size_t i = 0; i < basis.size; ++i) {
            CHECK((sum(A[i]) - tableau.c[i]).is_zero());
            CHECK((sum(A_tilde[i]) - tableau.c_tilde[i]).is_zero());
            for (std::size_t j = 0; j < basis.size; ++j)
                CHECK((b[i] * A_tilde[i][j] + b[j] * A[j][i] - b[i] * b[j]).is_zero());
        }
    }
}

TEST_CASE("permuted nodes give the permuted tableau") {
    const unsigned seed = 11;
    std::mt19937 generator(seed);
    for (const Basis& basis : bases) {
        const auto [nodes, tableau] = draw(basis, generator);
        std::vector<std::size_t> order = ascending(basis.size);
        std::rotate(order.begin(), order.begin() + 1, order.end());
        std::swap(order.front(), order[1]);
        RationalNodes permuted{{}, nodes.denominator};
        for (const std::size_t i : order) permuted.numerators.push_back(nodes.numerators[i]);
        CAPTURE(seed, basis.text, nodes.list(), permuted.list());
        const Tableau other = derive(method(basis.text, permuted.list()));
        CHECK(same(entries(other, ascending(basis.size)), entries(tableau, order)));
    }
}

TEST_CASE("reflected nodes give the adjoint method") {
    // a*_ij = b_j - a_ij with stages in reverse order, and likewise a~*
    const unsigned seed = 21;
    std::mt19937 generator(seed);
    for (const Basis& basis : bases) {
        const auto [nodes, tableau] = draw(basis, generator);
        const std::size_t s = basis.size;
        RationalNodes reflected{{}, nodes.denominator};
        for (std::size_t i = s; i-- > 0;)
            reflected.numerators.push_back(nodes.denominator - nodes.numerators[i]);
        Tableau adjoint = tableau;
        for (std::size_t i = 0; i < s; ++i) {
            adjoint.c[i] = Number(1) - tableau.c[s - 1 - i];
            adjoint.c_tilde[i] = Number(1) - tableau.c_tilde[s - 1 - i];
            adjoint.b[i] = tableau.b[s - 1 - i];
            for (std::size_t j = 0; j < s; ++j) {
                adjoint.A[i][j] = tableau.b[s - 1 - j] - tableau.A[s - 1 - i][s - 1 - j];
                adjoint.A_tilde[i][j] =
                    tableau.b[s - 1 - j] - tableau.A_tilde[s - 1 - i][s - 1 - j];
            }
        }
        CAPTURE(seed, basis.text, nodes.list(), reflected.list());
        const Tableau other = derive(method(basis.text, reflected.list()));
        CHECK(same(entries(other, ascending(s)), entries(adjoint, ascending(s))));
    }
}

TEST_CASE("the basis does not matter, its span does") {
    const std::string nodes = "0, 1/4, 1";
    const auto equal = [&](const std::string& left, const std::string& right) {
        return same(entries(derive(method(left, nodes)), ascending(3)),
                    entries(derive(method(right, nodes)), ascending(3)));
    };
    CHECK(equal("1, tau, tau^2", "1, 2*tau-1, 6*tau^2-6*tau+1"));
    CHECK(equal("1, exp(tau), exp(-tau)", "cosh(tau), 3, sinh(tau)+2"));
    CHECK(equal("1, cos(2*tau), sin(2*tau)", "cos(tau)^2, sin(tau)*cos(tau), 1"));
    CHECK_FALSE(equal("1, tau, tau^2", "1, tau, tau^3"));
}
