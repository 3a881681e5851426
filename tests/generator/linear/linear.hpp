// Quadratic Hamiltonians from text, and what a map of a step has to satisfy.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/linear/generating_function.hpp"
#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

inline std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

inline NumberVector vector_of(const std::string& text, const Ground& ground) {
    NumberVector result;
    for (const std::string& entry : split(text, ',')) { result.push_back(read(entry, ground)); }
    return result;
}

/// Rows are separated by `;`, entries by `,`.
inline NumberMatrix matrix_of(const std::string& text, const Ground& ground) {
    NumberMatrix result;
    for (const std::string& row : split(text, ';')) { result.push_back(vector_of(row, ground)); }
    return result;
}

/// Returns a Hamiltonian with S, g and the constant in one text: `w^2, 0; 0, 1 | 0, 0 | 0`. Missing
/// parts are zero.
inline QuadraticForm form_of(const std::string& text, const Ground& ground) {
    const std::vector<std::string> parts = split(text, '|');
    QuadraticForm H;
    H.S = matrix_of(parts[0], ground);
    H.g = parts.size() > 1 ? vector_of(parts[1], ground) : NumberVector(H.S.size());
    if (parts.size() > 2) { H.constant = read(parts[2], ground); }
    return H;
}

// Methods and Hamiltonians that the tests share.
inline constexpr const char* many_methods[] = {
    "symplectic-euler", "midpoint",     "adjoint-symplectic-euler",
    "stormer-verlet",   "trig3",        "gauss:2",
    "gauss:3",          "chebyshev:3",  "lobatto:3",
    "lobatto:4",        "radau-left:2", "newton-cotes-open:4",
};
inline constexpr const char* oscillator = "omega^2, 0; 0, 1";
inline constexpr const char* product_qp = "0, 1; 1, 0";
inline constexpr const char* any_one = "a, b; b, d | e, f | k";  ///< one degree of freedom
inline constexpr const char* coupled_springs = "3, -1, 0, 0; -1, 2, 0, 0; 0, 0, 1, 0; 0, 0, 0, m";
inline constexpr const char* coupled_any = "3, -1, 2, 1; -1, 2, 1, a; 2, 1, 1, -1; 1, a, -1, 5";
inline constexpr const char* degenerate =
    "0, 0, 1, 0; 0, 0, 0, 0; 1, 0, 0, 2; 0, 0, 2, 1 | 0, 3, 0, 1";
/// Hamiltonians of one and of two degrees of freedom.
inline constexpr const char* many_hamiltonians[] = {oscillator,      product_qp,  any_one,
                                                    coupled_springs, coupled_any, degenerate};
inline constexpr const char* four_springs = "4, 1, 0, 2, 0, 0, 0, 0; 1, 5, 1, 0, 0, 0, 0, 0;"
                                            "0, 1, 6, 1, 0, 0, 0, 0; 2, 0, 1, 3, 0, 0, 0, 0;"
                                            "0, 0, 0, 0, 1, 1, 0, 0; 0, 0, 0, 0, 1, 2, 0, 0;"
                                            "0, 0, 0, 0, 0, 0, 1, 0; 0, 0, 0, 0, 0, 0, 0, 1/2";
inline constexpr const char* four_any = "4, 1, 0, 2, 1, 0, 0, 0; 1, 5, 1, 0, 0, 0, 3, 0;"
                                        "0, 1, 6, 1, 0, -1, 0, 0; 2, 0, 1, 3, 0, 0, 2, 1;"
                                        "1, 0, 0, 0, 1, 1, 0, 0; 0, 0, -1, 0, 1, 2, 0, 0;"
                                        "0, 3, 0, 2, 0, 0, 1, 0; 0, 0, 0, 1, 0, 0, 0, 1/2";

/// Calls `work` with a method's tableau, a Hamiltonian and their ground.
template <class Work>
auto with_method(const Method& method, const std::string& hamiltonian, Work work) {
    return on_new_ground([&](const Ground& new_ground) {
        const auto [tableau, ground] = derive_on(new_ground, method);
        return work(tableau, form_of(hamiltonian, ground), ground);
    });
}

inline bool are_equal(const NumberMatrix& left, const NumberMatrix& right) {
    return is_zero(left + right * Number(-1));
}

inline bool are_equal(const NumberVector& left, const NumberVector& right) {
    return are_equal(NumberMatrix{left}, NumberMatrix{right});
}

inline NumberVector plus(const NumberVector& left, const NumberVector& right) {
    return (NumberMatrix{left} + NumberMatrix{right}).front();
}

inline bool are_equal(const QuadraticForm& left, const QuadraticForm& right) {
    return are_equal(left.S, right.S) && are_equal(left.g, right.g) &&
           (left.constant - right.constant).is_zero();
}

/// J with x' = J grad H(x).
inline NumberMatrix symplectic_matrix(std::size_t n) {
    NumberMatrix J = zeros(2 * n, 2 * n);
    for (std::size_t i = 0; i < n; ++i) {
        J[i][n + i] = Number(1);
        J[n + i][i] = Number(-1);
    }
    return J;
}

/// Whether M^T J M = J, which both are antisymmetric. NOTE: entry by entry above the diagonal,
/// since all of them in two products of matrices take more than a field's budget.
inline bool is_symplectic(const NumberMatrix& M) {
    const std::size_t n = M.size() / 2;
    for (std::size_t i = 0; i < 2 * n; ++i) {
        for (std::size_t j = i + 1; j < 2 * n; ++j) {
            Number entry = Number(j == i + n ? -1 : 0);
            for (std::size_t k = 0; k < n; ++k) {
                entry = entry + M[k][i] * M[n + k][j] - M[n + k][i] * M[k][j];
            }
            if (!entry.is_zero()) { return false; }
        }
    }
    return true;
}

}  // namespace hvi::gen
