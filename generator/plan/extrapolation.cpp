// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/exact/numbers/exact_number.hpp"

namespace hvi::gen {

namespace {

template <class T>
using Matrix = std::vector<std::vector<T>>;

template <class T>
std::vector<T> nodes_behind(const std::vector<T>& c, const std::vector<T>& sizes) {
    std::vector<T> nodes;
    T start(0);
    for (const T& size : sizes) {
        start = start - size;
        for (const T& node : c) { nodes.push_back(start + size * node); }
    }
    return nodes;
}

/// Returns l_j(c_i), by which the polynomial through the f_j at the nodes is f(c_i) = sum_j
/// l_j(c_i) f_j.
template <class T>
Matrix<T> interpolation(const std::vector<T>& c, const std::vector<T>& nodes) {
    Matrix<T> values(c.size(), std::vector<T>(nodes.size(), T(1)));
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                if (k == j) { continue; }
                values[i][j] = values[i][j] * ((c[i] - nodes[k]) / (nodes[j] - nodes[k]));
            }
        }
    }
    return values;
}

/// Returns the table of the polynomial of this degree that is nearest to the f_j, by least squares:
/// sum_k pi_k(c_i) pi_k(node_j)/|pi_k|^2, with polynomials that are orthogonal on the nodes
/// (Gautschi, Orthogonal Polynomials, Section 2.2.3.1).
template <class T>
Matrix<T> least_squares(const std::vector<T>& c, const std::vector<T>& nodes, std::size_t degree) {
    Matrix<T> values(c.size(), std::vector<T>(nodes.size(), T(0)));
    struct OfDegree {
        std::vector<T> ahead, here;  // pi_k at c and at the nodes
    };
    OfDegree before{std::vector<T>(c.size(), T(0)), std::vector<T>(nodes.size(), T(0))};
    OfDegree now{std::vector<T>(c.size(), T(1)), std::vector<T>(nodes.size(), T(1))};
    T norm_before(1);
    for (std::size_t k = 0;; ++k) {
        T norm(0), moment(0);
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            norm = norm + now.here[j] * now.here[j];
            moment = moment + nodes[j] * now.here[j] * now.here[j];
        }
        for (std::size_t i = 0; i < c.size(); ++i) {
            for (std::size_t j = 0; j < nodes.size(); ++j) {
                values[i][j] = values[i][j] + now.ahead[i] * now.here[j] / norm;
            }
        }
        if (k == degree) { return values; }
        const T alpha = moment / norm, beta = norm / norm_before;
        const auto recur = [&](const std::vector<T>& x, std::vector<T>& pi, std::vector<T>& last) {
            for (std::size_t i = 0; i < x.size(); ++i) {
                T next = (x[i] - alpha) * pi[i] - beta * last[i];
                last[i] = std::exchange(pi[i], std::move(next));
            }
        };
        recur(c, now.ahead, before.ahead);
        recur(nodes, now.here, before.here);
        norm_before = norm;
    }
}

/// Returns a table for each step, from L = h b f to L.
template <class T>
std::vector<Matrix<T>> tables(const std::vector<T>& c, const std::vector<T>& b,
                              const std::vector<T>& sizes, std::size_t degree) {
    const std::size_t s = b.size();
    const std::vector<T> nodes = nodes_behind(c, sizes);
    const bool is_through_all = degree + 1 == nodes.size();
    const Matrix<T> values =
        is_through_all ? interpolation(c, nodes) : least_squares(c, nodes, degree);
    std::vector<Matrix<T>> result(sizes.size(), Matrix<T>(s, std::vector<T>(s, T(0))));
    for (std::size_t step = 0; step < result.size(); ++step) {
        for (std::size_t i = 0; i < s; ++i) {
            for (std::size_t j = 0; j < s; ++j) {
                result[step][i][j] = b[i] / (sizes[step] * b[j]) * values[i][step * s + j];
            }
        }
    }
    return result;
}

std::vector<double> doubles(const NumberVector& numbers) {
    std::vector<double> result;
    for (const Number& number : numbers) { result.push_back(number.nearest_double()); }
    return result;
}

std::vector<Matrix<double>> tables_in_doubles(const Quadrature& rule,
                                              const SlopePolynomial& polynomial) {
    return tables(doubles(rule.c), doubles(rule.b), doubles(polynomial.sizes), polynomial.degree);
}

}  // namespace

NumberVector nodes_behind(const Quadrature& rule, const NumberVector& sizes) {
    return nodes_behind(rule.c, sizes);
}

std::vector<NumberMatrix> extrapolation(const Quadrature& rule, const SlopePolynomial& polynomial) {
    return tables(rule.c, rule.b, polynomial.sizes, polynomial.degree);
}

std::vector<NumberMatrix> extrapolation_in_doubles(const Quadrature& rule,
                                                   const SlopePolynomial& polynomial) {
    std::vector<NumberMatrix> result;
    for (const Matrix<double>& of_step : tables_in_doubles(rule, polynomial)) {
        NumberMatrix& N = result.emplace_back();
        for (const std::vector<double>& row : of_step) {
            NumberVector& numbers = N.emplace_back();
            for (const double entry : row) { numbers.push_back(exact_number(entry)); }
        }
    }
    return result;
}

double magnification(const Quadrature& rule, const SlopePolynomial& polynomial) {
    const std::vector<Matrix<double>> N = tables_in_doubles(rule, polynomial);
    double largest = 0;
    for (std::size_t i = 0; i < rule.b.size(); ++i) {
        double sum = 0;
        for (const Matrix<double>& of_step : N) {
            for (const double entry : of_step[i]) { sum += std::abs(entry); }
        }
        // Nodes that are equal in doubles give no finite number.
        if (!std::isfinite(sum)) { return std::numeric_limits<double>::infinity(); }
        largest = std::max(largest, sum);
    }
    return largest;
}

}  // namespace hvi::gen
