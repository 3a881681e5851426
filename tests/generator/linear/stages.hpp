// The stage equations (4.18) as they are written, with numbers in them, and solved by elimination.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <random>
#include <utility>

#include "tests/generator/linear/linear.hpp"

namespace hvi::gen {

/// The solution of a square system. Precondition: it has one.
inline NumberVector by_elimination(NumberMatrix rows, const NumberVector& right) {
    const std::size_t size = rows.size();
    for (std::size_t i = 0; i < size; ++i) { rows[i].push_back(right[i]); }
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t pivot = k;
        while (rows[pivot][k].is_zero()) { ++pivot; }
        std::swap(rows[pivot], rows[k]);
        for (std::size_t i = 0; i < size; ++i) {
            if (i == k || rows[i][k].is_zero()) { continue; }
            const Number factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j <= size; ++j) {
                rows[i][j] = rows[i][j] - factor * rows[k][j];
            }
        }
    }
    NumberVector result;
    for (std::size_t k = 0; k < size; ++k) { result.push_back(rows[k][size] / rows[k][k]); }
    return result;
}

inline Number dot(const NumberVector& left, const NumberVector& right) {
    return (NumberMatrix{left} * right).front();
}

inline Number value_of(const QuadraticForm& H, const NumberVector& x) {
    return dot(x, H.S * x) / Number(2) + dot(H.g, x) + H.constant;
}

struct Step {
    NumberMatrix stages;     ///< (Q^i, P^i)
    NumberMatrix gradients;  ///< (dH/dq, dH/dp) there
    NumberVector end;        ///< (q_1, p_1)
};

inline Step step_by_elimination(const Tableau& tableau, const QuadraticForm& H, const Number& h,
                                const NumberVector& start) {
    const std::size_t s = tableau.stages();
    const std::size_t size = start.size();
    const std::size_t n = size / 2;
    const auto place = [&](std::size_t stage, std::size_t variable) {
        return stage * size + variable;
    };
    // dq/dt = dH/dp, dp/dt = -dH/dq: which row of the gradient, and its sign.
    const auto slope = [&](std::size_t variable) {
        return variable < n ? std::pair(n + variable, Number(1))
                            : std::pair(variable - n, Number(-1));
    };
    NumberMatrix equations = identity(s * size);
    NumberVector right(s * size);
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            right[place(i, k)] = start[k];
            const auto [row, sign] = slope(k);
            for (std::size_t j = 0; j < s; ++j) {
                const Number a = h * sign * (k < n ? tableau.A : tableau.A_tilde)[i][j];
                right[place(i, k)] = right[place(i, k)] + a * H.g[row];
                for (std::size_t l = 0; l < size; ++l) {
                    Number& entry = equations[place(i, k)][place(j, l)];
                    entry = entry - a * H.S[row][l];
                }
            }
        }
    }
    const NumberVector all = by_elimination(equations, right);
    Step result{{}, {}, start};
    for (std::size_t i = 0; i < s; ++i) {
        const NumberVector stage(all.begin() + static_cast<long>(place(i, 0)),
                                 all.begin() + static_cast<long>(place(i, 0) + size));
        const NumberVector gradient = plus(H.S * stage, H.g);
        for (std::size_t k = 0; k < size; ++k) {
            const auto [row, sign] = slope(k);
            result.end[k] = result.end[k] + h * sign * tableau.b[i] * gradient[row];
        }
        result.stages.push_back(stage);
        result.gradients.push_back(gradient);
    }
    return result;
}

/// Two degrees of freedom with small integers everywhere.
inline std::string random_form(std::mt19937& generator) {
    const auto small = [&] { return std::to_string(static_cast<long>(generator() % 9) - 4); };
    std::string entries[4][4];
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j <= i; ++j) { entries[i][j] = entries[j][i] = small(); }
    }
    std::string result;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            result += (j > 0 ? "," : i > 0 ? ";" : "") + entries[i][j];
        }
    }
    return result + "|" + small() + "," + small() + "," + small() + "," + small() + "|" + small();
}

}  // namespace hvi::gen
