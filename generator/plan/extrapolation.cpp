// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hvi::gen {

namespace {

template <class T>
using Matrix = std::vector<std::vector<T>>;

/// The c_j of the last steps, as the next one counts its time: first those of the last.
template <class T>
std::vector<T> nodes_behind(const std::vector<T>& c, std::size_t steps) {
    std::vector<T> nodes;
    for (std::size_t step = 1; step <= steps; ++step) {
        for (const T& node : c) { nodes.push_back(node - T(static_cast<int>(step))); }
    }
    return nodes;
}

/// f(c_i) = sum_j l_j(c_i) f_j of the polynomial through the f_j at the nodes: l_j(c_i).
Matrix<Number> interpolation(const NumberVector& c, const NumberVector& nodes) {
    Matrix<Number> values(c.size(), NumberVector(nodes.size(), Number(1)));
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

/// The same of the polynomial of this degree that is nearest to the f_j, by least squares:
/// sum_k pi_k(c_i) pi_k(node_j)/|pi_k|^2, of polynomials that are orthogonal on the nodes
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

/// From f to L = h b f, and a table for each step.
template <class T>
std::vector<Matrix<T>> of_slopes(const Matrix<T>& values, const std::vector<T>& b) {
    const std::size_t s = b.size();
    std::vector<Matrix<T>> result(values.front().size() / s, Matrix<T>(s, std::vector<T>(s, T(0))));
    for (std::size_t step = 0; step < result.size(); ++step) {
        for (std::size_t i = 0; i < s; ++i) {
            for (std::size_t j = 0; j < s; ++j) {
                result[step][i][j] = b[i] / b[j] * values[i][step * s + j];
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

}  // namespace

std::vector<NumberMatrix> extrapolation(const Quadrature& rule, const SlopePolynomial& polynomial) {
    const NumberVector nodes = nodes_behind(rule.c, polynomial.steps);
    return of_slopes(polynomial.is_through_all(rule)
                         ? interpolation(rule.c, nodes)
                         : least_squares(rule.c, nodes, polynomial.degree),
                     rule.b);
}

double magnification(const Quadrature& rule, const SlopePolynomial& polynomial) {
    const std::vector<double> c = doubles(rule.c), b = doubles(rule.b);
    const auto tables =
        of_slopes(least_squares(c, nodes_behind(c, polynomial.steps), polynomial.degree), b);
    double largest = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        double sum = 0;
        for (const Matrix<double>& N : tables) {
            for (const double entry : N[i]) { sum += std::abs(entry); }
        }
        largest = std::max(largest, sum);
    }
    return largest;
}

}  // namespace hvi::gen
