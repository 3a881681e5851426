// A step of the general Galerkin form (4.6) by Newton's method in numbers, for the tests of its
// equations: from nodes and functions that the tests write down, and derivatives by dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generator/read/hamiltonian.hpp"
#include "tests/generator/hamiltonian/dual.hpp"

namespace hvi::gen {

using Reals = std::vector<Real>;

/// psi(tau), and its integral from 0 to tau.
struct NumericFunction {
    std::function<Real(Real)> value, integral;
};

inline NumericFunction power_of_tau(int k) {
    return {[k](Real tau) { return std::pow(tau, static_cast<Real>(k)); },
            [k](Real tau) { return std::pow(tau, static_cast<Real>(k + 1)) / (k + 1); }};
}

struct NumericRule {
    std::vector<NumericFunction> psi;
    Reals c, b;
};

/// Solves equations, given row by row, by elimination with pivots.
inline Reals solved(std::vector<Reals> rows, Reals right) {
    const std::size_t n = right.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i)
            if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
        std::swap(rows[k], rows[pivot]);
        std::swap(right[k], right[pivot]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const Real factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j < n; ++j) rows[i][j] -= factor * rows[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (std::size_t k = 0; k < n; ++k) right[k] /= rows[k][k];
    return right;
}

/// The values at the end, and within the step: x at node i and V^j have the names x + "@i" and x +
/// "#j", with indices from 0.
class NumericStep {
public:
    NumericStep(const NumericRule& rule, const Hamiltonian& H, Point start)
        : rule_(rule), H_(H), start_(std::move(start)), n_(H.degrees_of_freedom()) {
        const std::size_t unknowns = n_ * (rule.psi.size() + rule.c.size());
        Reals z(unknowns, 0);
        for (std::size_t k = 0; k < n_; ++k)
            for (std::size_t i = 0; i < rule.c.size(); ++i)
                z[place_of_P(k, i)] = start_.at(H.momenta[k]).value;
        for (int round = 0; round < 30; ++round) {
            const Reals r = residual(z);
            std::vector<Reals> J(unknowns, Reals(unknowns));
            for (std::size_t j = 0; j < unknowns; ++j) {
                const Real step = 1e-9L;
                Reals other = z;
                other[j] += step;
                const Reals there = residual(other);
                for (std::size_t i = 0; i < unknowns; ++i) J[i][j] = (there[i] - r[i]) / step;
            }
            const Reals change = solved(J, r);
            for (std::size_t j = 0; j < unknowns; ++j) z[j] -= change[j];
        }
        finish(z);
    }

    [[nodiscard]] Real at(const std::string& name) const { return values_.at(name).value; }
    [[nodiscard]] Real end(const std::string& variable) const { return end_.at(variable).value; }

    /// A derivative of H at a node.
    [[nodiscard]] Real slope(const Reals& z, const std::string& by, std::size_t i) const {
        Point point = start_;
        for (std::size_t k = 0; k < n_; ++k) {
            point[H_.coordinates[k]] = {position(z, k, rule_.c[i])};
            point[H_.momenta[k]] = {z[place_of_P(k, i)]};
        }
        point["t"] = {start_.at("t").value + rule_.c[i] * h()};
        point[by].slope = 1;
        return evaluate(H_.expression, point).slope;
    }

private:
    [[nodiscard]] Real h() const { return start_.at("h").value; }
    [[nodiscard]] std::size_t place_of_V(std::size_t k, std::size_t j) const {
        return k * rule_.psi.size() + j;
    }
    [[nodiscard]] std::size_t place_of_P(std::size_t k, std::size_t i) const {
        return n_ * rule_.psi.size() + k * rule_.c.size() + i;
    }
    /// q_d(tau h)
    [[nodiscard]] Real position(const Reals& z, std::size_t k, Real tau) const {
        Real q = start_.at(H_.coordinates[k]).value;
        for (std::size_t j = 0; j < rule_.psi.size(); ++j)
            q += h() * z[place_of_V(k, j)] * rule_.psi[j].integral(tau);
        return q;
    }

    /// (4.6d) and (4.6e)
    [[nodiscard]] Reals residual(const Reals& z) const {
        Reals result(z.size());
        const auto& [psi, c, b] = rule_;
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t j = 0; j < psi.size(); ++j) {
                const Real B = psi[j].integral(1);
                Real sum = -start_.at(H_.momenta[k]).value * B;
                for (std::size_t i = 0; i < c.size(); ++i)
                    sum +=
                        b[i] * z[place_of_P(k, i)] * psi[j].value(c[i]) +
                        h() * b[i] * (B - psi[j].integral(c[i])) * slope(z, H_.coordinates[k], i);
                result[place_of_V(k, j)] = sum;
            }
            for (std::size_t i = 0; i < c.size(); ++i) {
                Real velocity = 0;
                for (std::size_t j = 0; j < psi.size(); ++j)
                    velocity += z[place_of_V(k, j)] * psi[j].value(c[i]);
                result[place_of_P(k, i)] = velocity - slope(z, H_.momenta[k], i);
            }
        }
        return result;
    }

    void finish(const Reals& z) {
        for (std::size_t k = 0; k < n_; ++k) {
            const std::string &x = H_.coordinates[k], &p = H_.momenta[k];
            end_[x] = {position(z, k, 1)};
            end_[p] = start_.at(p);
            for (std::size_t j = 0; j < rule_.psi.size(); ++j)
                values_[x + "#" + std::to_string(j)] = {z[place_of_V(k, j)]};
            for (std::size_t i = 0; i < rule_.c.size(); ++i) {
                values_[x + "@" + std::to_string(i)] = {position(z, k, rule_.c[i])};
                values_[p + "@" + std::to_string(i)] = {z[place_of_P(k, i)]};
                end_[p].value -= h() * rule_.b[i] * slope(z, x, i);
            }
        }
    }

    const NumericRule& rule_;
    const Hamiltonian& H_;
    Point start_;
    std::size_t n_;
    Point values_, end_;
};

}  // namespace hvi::gen
