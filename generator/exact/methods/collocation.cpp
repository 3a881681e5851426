// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/collocation.hpp"

#include <arb_hypgeom.h>

#include <algorithm>

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

using Balls = std::vector<Ball>;

/// Gauss' rule on [0,1], exact for polynomials of degree less than s.
struct Rule {
    Rule(std::size_t s, Precision bits) {
        const std::size_t count = s / 2 + 1;
        for (std::size_t k = 0; k < count; ++k) {
            Ball node, weight;
            arb_hypgeom_legendre_p_ui_root(node.get(), weight.get(), count, k, bits);
            arb_add_ui(node.get(), node.get(), 1, bits);
            arb_mul_2exp_si(node.get(), node.get(), -1);
            arb_mul_2exp_si(weight.get(), weight.get(), -1);
            nodes.push_back(std::move(node));
            weights.push_back(std::move(weight));
        }
    }

    Balls nodes, weights;
};

/// Returns Lagrange's polynomial l_j, computed from its factors for as narrow an enclosure as
/// possible: with its coefficients digits would cancel.
Ball lagrange(const Balls& c, std::size_t j, const Ball& at, Precision bits) {
    Ball result, factor, distance;
    arb_one(result.get());
    for (std::size_t k = 0; k < c.size(); ++k) {
        if (k == j) { continue; }
        arb_sub(factor.get(), at.get(), c[k].get(), bits);
        arb_sub(distance.get(), c[j].get(), c[k].get(), bits);
        arb_div(factor.get(), factor.get(), distance.get(), bits);
        arb_mul(result.get(), result.get(), factor.get(), bits);
    }
    return result;
}

/// Returns the integral of l_j over [0, end].
Number integral(const Balls& c, std::size_t j, const Ball& end, const Rule& rule, Precision bits) {
    Ball sum;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        Ball at;
        arb_mul(at.get(), end.get(), rule.nodes[k].get(), bits);
        const Ball value = lagrange(c, j, at, bits);
        arb_addmul(sum.get(), rule.weights[k].get(), value.get(), bits);
    }
    arb_mul(sum.get(), sum.get(), end.get(), bits);
    return number(Real([sum](Precision) { return sum; }));
}

bool may_be_equal(const Balls& c) {
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (arb_overlaps(c[i].get(), c[j].get()) != 0) { return true; }
        }
    }
    return false;
}

}  // namespace

std::optional<PartitionedMethod> enclosed_collocation(const NumberVector& c, Precision bits) {
    Balls nodes;
    for (const Number& node : c) { nodes.push_back(enclosure(node, bits)); }
    if (may_be_equal(nodes)) { return std::nullopt; }
    const Rule rule(c.size(), bits);
    Ball one;
    arb_one(one.get());
    PartitionedMethod result;
    for (std::size_t j = 0; j < c.size(); ++j) {
        result.b.push_back(integral(nodes, j, one, rule, bits));
    }
    result.b_tilde = result.b;
    for (const Ball& node : nodes) {
        NumberVector& row = result.A.emplace_back();
        for (std::size_t j = 0; j < c.size(); ++j) {
            row.push_back(integral(nodes, j, node, rule, bits));
        }
    }
    auto partner = symplectic_partner(result.b, result.A, bits);
    if (!partner) { return std::nullopt; }
    result.A_tilde = *std::move(partner);
    return result;
}

std::optional<NumberMatrix> symplectic_partner(const NumberVector& b, const NumberMatrix& A,
                                               Precision bits) {
    const bool has_zero = std::any_of(
        b.begin(), b.end(), [&](const Number& weight) { return can_vanish(weight, bits).holds; });
    if (has_zero) { return std::nullopt; }
    NumberMatrix result;
    for (std::size_t i = 0; i < b.size(); ++i) {
        NumberVector& row = result.emplace_back();
        for (std::size_t j = 0; j < b.size(); ++j) {
            row.push_back(b[j] * (Number(1) - A[j][i] / b[i]));
        }
    }
    return result;
}

}  // namespace hvi::gen
