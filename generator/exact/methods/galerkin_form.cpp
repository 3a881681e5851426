// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/galerkin_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// A basis T psi, and its Gram matrix G.
struct Basis {
    NumberMatrix T;
    NumberMatrix G;

    /// Adds factor psi_j to psi_k.
    void add(std::size_t k, std::size_t j, const Number& factor) {
        const std::size_t s = G.size();
        for (std::size_t l = 0; l < s; ++l) { T[k][l] = T[k][l] + factor * T[j][l]; }
        for (std::size_t l = 0; l < s; ++l) { G[k][l] = G[k][l] + factor * G[j][l]; }
        for (std::size_t l = 0; l < s; ++l) { G[l][k] = G[l][k] + factor * G[l][j]; }
    }

    void exchange(std::size_t j, std::size_t k) {
        std::swap(T[j], T[k]);
        std::swap(G[j], G[k]);
        for (NumberVector& row : G) { std::swap(row[j], row[k]); }
    }
};

/// Makes G[j][j] different from zero, by the functions from j on. NOTE: negative weights may make
/// all of them null. Then two that are not orthogonal have a sum that is not null.
void set_pivot(Basis& basis, std::size_t j) {
    const std::size_t s = basis.G.size();
    for (std::size_t k = j; k < s; ++k) {
        if (basis.G[k][k].is_zero()) { continue; }
        basis.exchange(j, k);
        return;
    }
    for (std::size_t k = j; k < s; ++k) {
        for (std::size_t l = j; l < k; ++l) {
            if (basis.G[k][l].is_zero()) { continue; }
            basis.add(l, k, Number(1));
            basis.exchange(j, l);
            return;
        }
    }
    HVI_CHECK(false);  // G is regular
}

/// Returns the power of two that brings f^2 = square near to 1.
Number scale_of(const Number& square) {
    const int exponent = -std::ilogb(square.nearest_double()) / 2;
    Number power(1);
    for (int i = 0; i < std::abs(exponent); ++i) { power = power * Number(2); }
    return exponent < 0 ? Number(1) / power : power;
}

Basis orthogonal(const NumberMatrix& gram) {
    Basis basis{identity(gram.size()), gram};
    for (std::size_t j = 0; j < gram.size(); ++j) {
        set_pivot(basis, j);
        for (std::size_t k = j + 1; k < gram.size(); ++k) {
            basis.add(k, j, -(basis.G[k][j] / basis.G[j][j]));
        }
        const Number scale = scale_of(basis.G[j][j]);
        basis.T[j] = basis.T[j] * scale;
        basis.G[j][j] = basis.G[j][j] * scale * scale;
    }
    return basis;
}

GalerkinForm form_of(const GalerkinRule& rule) {
    const Basis basis = orthogonal(rule.gram);
    GalerkinForm form;
    form.B = basis.T * rule.B;
    for (std::size_t j = 0; j < rule.functions(); ++j) { form.gram.push_back(basis.G[j][j]); }
    const NumberMatrix psi = transpose(rule.Psi);
    for (std::size_t i = 0; i < rule.nodes(); ++i) {
        if (rule.b[i].known_zero() == true) { continue; }
        form.c.push_back(rule.c[i]);
        form.b.push_back(rule.b[i]);
        form.phi.push_back(basis.T * psi[i]);
        form.A.push_back(basis.T * rule.A_psi[i]);
    }
    return form;
}

GalerkinForm form_of(const Tableau& tableau) {
    return {tableau.c, tableau.b, identity(tableau.stages()), tableau.A, tableau.b, tableau.b};
}

/// Returns u^T G^-1 v.
Number product(const GalerkinForm& form, const NumberVector& u, const NumberVector& v) {
    Number sum;
    for (std::size_t j = 0; j < form.functions(); ++j) { sum = sum + u[j] * v[j] / form.gram[j]; }
    return sum;
}

}  // namespace

GalerkinForm galerkin_form(const DerivedMethod& method) {
    return std::visit([](const auto& derived) { return form_of(derived); }, method);
}

std::optional<std::vector<std::size_t>> mirrored(const NumberVector& c, Verdict& evidence) {
    std::vector<std::size_t> result;
    for (const Number& node : c) {
        const auto partner = std::find_if(c.begin(), c.end(), [&](const Number& other) {
            const Verdict verdict = vanishes(node + other - Number(1));
            if (verdict.holds) { evidence = evidence && verdict; }
            return verdict.holds;
        });
        if (partner == c.end()) { return std::nullopt; }
        result.push_back(static_cast<std::size_t>(partner - c.begin()));
    }
    return result;
}

// NOTE: the step depends on the weights and the numbers phi_i G^-1 phi_k and phi_i G^-1 A_k, as the
// phi_i span all s-vectors. The adjoint has node 1 - c_i and B - A_i where this form has c_i and
// A_i, and phi_i G^-1 B = 1, as B are the coefficients of 1 times G.
Verdict is_symmetric(const GalerkinForm& form) {
    Verdict result;
    const auto sigma = mirrored(form.c, result);
    if (!sigma) { return {false, true}; }
    for (std::size_t i = 0; i < form.nodes() && result.holds; ++i) {
        const std::size_t i_ = (*sigma)[i];
        result = result && vanishes(form.b[i_] - form.b[i]);
        for (std::size_t k = 0; k < form.nodes() && result.holds; ++k) {
            const std::size_t k_ = (*sigma)[k];
            result = result && vanishes(product(form, form.phi[i_], form.phi[k_]) -
                                        product(form, form.phi[i], form.phi[k]));
            result = result && vanishes(product(form, form.phi[i_], form.A[k_]) +
                                        product(form, form.phi[i], form.A[k]) - Number(1));
        }
    }
    return result;
}

}  // namespace hvi::gen
