// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/starting_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/ir/equal.hpp"
#include "generator/plan/solver.hpp"

namespace hvi::gen {

namespace {

constexpr double most = 1e8;  // so that rounding of the slopes stays below half the digits

bool are_distinct(const NumberVector& c) {
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!differ(c[i], c[j])) { return false; }
        }
    }
    return true;
}

/// The c_j of the last `steps` steps, as the next one counts its time: first those of the last.
NumberVector nodes_behind(const NumberVector& c, int steps) {
    NumberVector nodes;
    for (int step = 1; step <= steps; ++step) {
        for (const Number& node : c) { nodes.push_back(node - Number(step)); }
    }
    return nodes;
}

/// The polynomial through the slopes f_j at these nodes, in the next step: f(c_i) is the sum of
/// l_j(c_i) f_j, so N_ij = (b_i/b_j) l_j(c_i) for L_j = h b_j f_j. Of step `block` of the nodes.
NumberMatrix extrapolation(const Quadrature& rule, const NumberVector& nodes, std::size_t block) {
    const std::size_t s = rule.b.size();
    NumberMatrix N(s, NumberVector(s));
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            Number value = rule.b[i] / rule.b[j];
            const Number& node = nodes[block * s + j];
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                if (k == block * s + j) { continue; }
                value = value * ((rule.c[i] - nodes[k]) / (node - nodes[k]));
            }
            N[i][j] = value;
        }
    }
    return N;
}

/// The same of the polynomial of a lower degree that is nearest to the slopes of the last step, by
/// least squares: its values are the sums over k of pi_k(1 + c_i) pi_k(c_j) f_j/|pi_k|^2, of
/// polynomials that are orthogonal on the nodes.
template <class T>
std::vector<std::vector<T>> extrapolation_of_degree(std::size_t degree, const std::vector<T>& c,
                                                    const std::vector<T>& b) {
    const std::size_t s = c.size();
    std::vector<std::vector<T>> N(s, std::vector<T>(s, T(0)));
    // pi_k at the nodes and in the next step, and the same of pi_k-1.
    std::vector<T> here(s, T(1)), ahead(s, T(1)), here_before(s, T(0)), ahead_before(s, T(0));
    T norm_before(1);
    for (std::size_t k = 0;; ++k) {
        T norm(0), moment(0);
        for (std::size_t j = 0; j < s; ++j) {
            norm = norm + here[j] * here[j];
            moment = moment + c[j] * here[j] * here[j];
        }
        for (std::size_t i = 0; i < s; ++i) {
            for (std::size_t j = 0; j < s; ++j) {
                N[i][j] = N[i][j] + b[i] / b[j] * (ahead[i] * here[j] / norm);
            }
        }
        if (k == degree) { return N; }
        const T alpha = moment / norm, beta = norm / norm_before;
        for (std::size_t i = 0; i < s; ++i) {
            const T next = (c[i] - alpha) * here[i] - beta * here_before[i];
            const T next_ahead = (T(1) + c[i] - alpha) * ahead[i] - beta * ahead_before[i];
            here_before[i] = std::exchange(here[i], next);
            ahead_before[i] = std::exchange(ahead[i], next_ahead);
        }
        norm_before = norm;
    }
}

/// How much it may magnify rounding: the largest sum_j |N_ij|.
double magnification(const std::vector<std::vector<double>>& N) {
    double largest = 0.0;
    for (const std::vector<double>& row : N) {
        double sum = 0.0;
        for (const double entry : row) { sum += std::abs(entry); }
        largest = std::max(largest, sum);
    }
    return largest;
}

std::vector<double> doubles(const NumberVector& numbers) {
    std::vector<double> result;
    for (const Number& number : numbers) { result.push_back(number.nearest_double()); }
    return result;
}

/// The highest degree, at most that of the polynomial through all slopes, that does not magnify
/// rounding too much. None where it would have to be low.
///
/// NOTE: iterations of gauss:16 with polynomials of degree 11 and with slopes at the start of the
/// step: point vortices, h = 2, 7.6 and 13.6; Kepler's problem, h = 0.2, 4.9 and 7.2; double
/// pendulum, h = 0.1, 7.7 and 10.7, and h = 0.4, 17.3 and 17.2. Degrees from 9 to 13 do about as
/// well.
std::optional<std::size_t> degree_of_extrapolation(const Quadrature& rule) {
    constexpr std::size_t low = 5;
    const std::vector<double> c = doubles(rule.c), b = doubles(rule.b);
    const std::size_t highest = c.size() - 1;
    for (std::size_t degree = highest; degree == highest || degree >= low; --degree) {
        if (magnification(extrapolation_of_degree(degree, c, b)) <= most) { return degree; }
        if (degree == 0) { break; }
    }
    return {};
}

/// Of the last step.
NumberMatrix extrapolation(const Quadrature& rule, std::size_t degree) {
    return degree + 1 == rule.c.size() ? extrapolation(rule, nodes_behind(rule.c, 1), 0)
                                       : extrapolation_of_degree(degree, rule.c, rule.b);
}

/// Whether the polynomial through the slopes of two steps is a better start.
///
/// NOTE: measured on Kepler's problem, the pendulum and Henon-Heiles, with steps of two sizes: for
/// two and three stages 7 to 20 % fewer evaluations than of one step, for four 0 to 11 %, for eight
/// 5 to 30 % more. A stepper for any H keeps to one step, so that what it remembers is simple.
bool takes_two_steps(Solver solver, Layout layout, const Quadrature& rule) {
    constexpr std::size_t most_stages = 3;
    const bool is_iterated = solver == Solver::automatic || solver == Solver::fixed_point ||
                             solver == Solver::newton_taylor;
    return is_iterated && layout != Layout::trajectories && rule.b.size() <= most_stages &&
           are_distinct(nodes_behind(rule.c, 2));
}

}  // namespace

void set_extrapolation(Step& step, const Quadrature& rule) {
    Iteration* iteration = iteration_of(step);
    if (iteration == nullptr) { return; }
    if (step.from_parameter) {
        step.decisions.push_back(
            {"slopes at the start of the step are the starting values of the iteration",
             "extrapolation would need coefficients for each value of the parameter"});
        return;
    }
    const bool has_no_momenta = std::holds_alternative<VelocityStep>(step.form);
    const bool merged = step.positions.size() != rule.b.size() ||
                        (!has_no_momenta && step.momenta.size() != rule.b.size());
    if (merged || !are_distinct(rule.c)) {
        step.decisions.push_back(
            {"slopes at the start of the step are the starting values of the iteration",
             "no polynomial interpolates slopes at equal nodes"});
        return;
    }
    const std::optional<std::size_t> degree = degree_of_extrapolation(rule);
    if (!degree) {
        step.decisions.push_back(
            {"slopes at the start of the step are the starting values of the iteration",
             "extrapolating the last step's slopes would magnify their rounding too much"});
        return;
    }
    if (takes_two_steps(iteration->solver, step.layout, rule)) {
        const NumberVector nodes = nodes_behind(rule.c, 2);
        iteration->extrapolation =
            Extrapolation{extrapolation(rule, nodes, 0), extrapolation(rule, nodes, 1)};
        step.decisions.push_back(
            {"the slopes of the last two steps, extrapolated, are the starting values of the "
             "iteration",
             "of few stages, those of one step make a polynomial of low order"});
        return;
    }
    iteration->extrapolation = Extrapolation{extrapolation(rule, *degree), {}};
    if (*degree + 1 < rule.c.size()) {
        step.decisions.push_back(
            {fmt::format("the last step's slopes, extrapolated by the nearest polynomial of degree "
                         "{}, are the starting values of the iteration",
                         *degree),
             "one through all of them would magnify their rounding too much"});
    } else {
        step.decisions.push_back(
            {"the last step's slopes, extrapolated, are the starting values of the iteration",
             "they are good to the order of the interpolation and cost no evaluation"});
    }
}

namespace {

Quadrature nodes_of(const GalerkinForm& form) {
    return {form.c, NumberVector(form.nodes(), Number(1))};
}

/// P(t) is the polynomial through the P_i, or near to them. Of the velocities U_i = sum_j phi_ij
/// V_j that at the nodes of the next step too, and from there to W_j = sum_i b_i phi_ij U_i / G_j.
CurveExtrapolation extrapolation(const GalerkinForm& form, Side side, std::size_t degree) {
    const std::size_t r = form.nodes(), s = form.functions();
    const NumberMatrix next = extrapolation(nodes_of(form), degree);
    const NumberMatrix U = next * form.phi;
    CurveExtrapolation result{NumberMatrix(s, NumberVector(s)), {}};
    for (std::size_t j = 0; j < s; ++j) {
        for (std::size_t k = 0; k < s; ++k) {
            Number sum;
            for (std::size_t i = 0; i < r; ++i) {
                sum = sum + form.b[i] * form.phi[i][j] * U[i][k];
            }
            result.W[j][k] = sum / form.gram[j];
        }
    }
    if (side == Side::hamiltonian) { result.P = next; }
    return result;
}

}  // namespace

void set_extrapolation(Step& step, GalerkinStep& galerkin) {
    const GalerkinForm& form = galerkin.form;
    const auto begins_at_the_start = [&](const char* reason) {
        step.decisions.push_back({"the state and its velocity at the start of the step are the "
                                  "starting values of the iteration",
                                  reason});
    };
    if (!step.in_a_row.empty()) {
        return begins_at_the_start("the steps of a composition differ in size");
    }
    if (!are_distinct(form.c)) {
        return begins_at_the_start("no polynomial interpolates momenta at equal nodes");
    }
    const std::optional<std::size_t> degree = degree_of_extrapolation(nodes_of(form));
    if (!degree) {
        return begins_at_the_start("extrapolating the last step's momenta would magnify their "
                                   "rounding too much");
    }
    galerkin.extrapolation = extrapolation(form, galerkin.side, *degree);
    step.decisions.push_back(
        {galerkin.side == Side::hamiltonian
             ? "the last step's curve and momenta, extrapolated, are the starting values of the "
               "iteration"
             : "the last step's curve, extrapolated, gives the starting values of the iteration",
         "they are good to the order of the interpolation"});
}

}  // namespace hvi::gen
