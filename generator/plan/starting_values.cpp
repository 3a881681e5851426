// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/starting_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/ir/equal.hpp"
#include "generator/plan/extrapolation.hpp"
#include "generator/plan/solver.hpp"

namespace hvi::gen {

namespace {

constexpr double most = 1e8;  // keeps rounding of the slopes below half the digits

bool are_distinct(const NumberVector& c) {
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!differ(c[i], c[j])) { return false; }
        }
    }
    return true;
}

/// Returns the polynomial of the last step of the highest degree, at most that through all slopes,
/// that does not magnify rounding too much. None where the degree would have to be low: slopes at
/// the start are better. Where the last step has another size there is always one, for the sake of
/// the others in a row.
///
/// NOTE: iterations of gauss:16 with polynomials of degree 11 and with slopes at the start of the
/// step: point vortices, h = 2, 7.6 and 13.6; Kepler's problem, h = 0.2, 4.9 and 7.2; double
/// pendulum, h = 0.1, 7.7 and 10.7, and h = 0.4, 17.3 and 17.2. Degrees from 9 to 13 do about as
/// well.
std::optional<SlopePolynomial> polynomial_of_one_step(const Quadrature& rule,
                                                      const NumberVector& sizes) {
    const std::size_t highest = rule.c.size() - 1;
    const bool is_of_equal_size = equal(sizes.front(), Number(1));
    const std::size_t lowest = is_of_equal_size ? std::min<std::size_t>(5, highest) : 0;
    SlopePolynomial polynomial{{sizes.front()}, highest};
    while (magnification(rule, polynomial) > most) {
        if (polynomial.degree == lowest) { return {}; }
        --polynomial.degree;
    }
    return polynomial;
}

/// Returns whether slopes of two steps are remembered. NOTE: a stepper for any H keeps to one step,
/// so that its memory is simple.
bool may_take_two_steps(const Iteration& iteration, Layout layout) {
    return layout != Layout::trajectories && layout != Layout::threads &&
           (iteration.only_sweeps() || iteration.solver == Solver::automatic ||
            iteration.solver == Solver::newton_taylor);
}

/// Returns the polynomial of the last two steps where it is a better start.
///
/// NOTE: measured on Kepler's problem, the pendulum and Henon-Heiles, with steps of two sizes,
/// against the polynomial of one step. For two and three stages the polynomial through all slopes
/// saves 7 to 20 % of the evaluations. For four, that of degree s + 2 saves 6 to 15 % of them, with
/// point vortices and the double pendulum too, and 0 to 12 % of the time; the one through all saves
/// less. For six it saves 0 to 11 % of the evaluations and from 6 % to -7 % of the time.
std::optional<SlopePolynomial> polynomial_of_two_steps(const Quadrature& rule,
                                                       const NumberVector& sizes) {
    const std::size_t s = rule.c.size();
    constexpr std::size_t few = 3, most_stages = 5;
    if (s > most_stages || !are_distinct(nodes_behind(rule, sizes))) { return {}; }
    const SlopePolynomial polynomial{sizes, s <= few ? 2 * s - 1 : s + 2};
    return magnification(rule, polynomial) <= most ? std::optional(polynomial) : std::nullopt;
}

Decision begins_at_the_start(const char* reason) {
    return {"slopes at the start of the step are the starting values of the iteration", reason};
}

std::string described(const SlopePolynomial& polynomial, const Quadrature& rule) {
    return polynomial.is_through_all(rule)
               ? "extrapolated"
               : fmt::format("extrapolated by the nearest polynomial of degree {}",
                             polynomial.degree);
}

Decision begins_with(const std::vector<SlopePolynomial>& polynomials, const Quadrature& rule) {
    const SlopePolynomial& polynomial = polynomials.front();
    if (polynomials.size() > 1) {
        return {fmt::format("the slopes of the {} before, extrapolated to the size of each of the "
                            "steps in a row, are the starting values of the iteration",
                            polynomial.sizes.size() > 1 ? "two steps" : "step"),
                "how much larger one is than another is known"};
    }
    const std::string how = described(polynomial, rule);
    if (polynomial.sizes.size() > 1) {
        return {fmt::format("the slopes of the last two steps, {}, are the starting values of the "
                            "iteration",
                            how),
                "of few stages, those of one step make a polynomial of low order"};
    }
    return {
        fmt::format("the last step's slopes, {}, are the starting values of the iteration", how),
        polynomial.is_through_all(rule)
            ? "they are good to the order of the interpolation and cost no evaluation"
            : "one through all of them would magnify their rounding too much"};
}

/// Returns the sizes of the two steps before each of those in a row, relative to its own size.
std::vector<NumberVector> sizes_behind(const NumberVector& in_a_row) {
    if (in_a_row.empty()) { return {{Number(1), Number(1)}}; }
    const std::size_t k = in_a_row.size();
    std::vector<NumberVector> result;
    for (std::size_t part = 0; part < k; ++part) {
        const auto behind = [&](std::size_t count) {
            return in_a_row[(part + 2 * k - count) % k] / in_a_row[part];
        };
        result.push_back({behind(1), behind(2)});
    }
    return result;
}

/// Returns a polynomial for each, or none where one of them has none.
std::vector<SlopePolynomial> of_each(const std::vector<NumberVector>& sizes,
                                     const auto& polynomial_of) {
    std::vector<SlopePolynomial> result;
    for (const NumberVector& behind : sizes) {
        std::optional<SlopePolynomial> polynomial = polynomial_of(behind);
        if (!polynomial) { return {}; }
        result.push_back(*std::move(polynomial));
    }
    return result;
}

std::vector<SlopePolynomial> slope_polynomials(const Step& step, const Iteration& iteration,
                                               const Quadrature& rule) {
    const std::vector<NumberVector> sizes = sizes_behind(step.in_a_row);
    std::vector<SlopePolynomial> polynomials;
    if (may_take_two_steps(iteration, step.layout)) {
        polynomials = of_each(sizes, [&](const NumberVector& behind) {
            return polynomial_of_two_steps(rule, behind);
        });
    }
    if (!polynomials.empty()) { return polynomials; }
    return of_each(
        sizes, [&](const NumberVector& behind) { return polynomial_of_one_step(rule, behind); });
}

}  // namespace

std::optional<SlopePolynomial> starting_polynomial(const Quadrature& rule) {
    if (!are_distinct(rule.c)) { return {}; }
    const NumberVector sizes{Number(1), Number(1)};
    std::optional<SlopePolynomial> of_two = polynomial_of_two_steps(rule, sizes);
    return of_two ? of_two : polynomial_of_one_step(rule, sizes);
}

void set_extrapolation(Step& step, const Quadrature& rule) {
    Iteration* iteration = iteration_of(step);
    if (iteration == nullptr) { return; }
    if (step.from_parameter) {
        step.decisions.push_back(begins_at_the_start(
            "extrapolation would need coefficients for each value of the parameter"));
        return;
    }
    const bool has_no_momenta = std::holds_alternative<VelocityStep>(step.form);
    const bool merged = step.positions.size() != rule.b.size() ||
                        (!has_no_momenta && step.momenta.size() != rule.b.size());
    if (merged || !are_distinct(rule.c)) {
        step.decisions.push_back(
            begins_at_the_start("no polynomial interpolates slopes at equal nodes"));
        return;
    }
    const std::vector<SlopePolynomial> polynomials = slope_polynomials(step, *iteration, rule);
    if (polynomials.empty()) {
        step.decisions.push_back(begins_at_the_start(
            "extrapolating the last step's slopes would magnify their rounding too much"));
        return;
    }
    for (const SlopePolynomial& polynomial : polynomials) {
        std::vector<NumberMatrix> N = step.in_a_row.empty()
                                          ? extrapolation(rule, polynomial)
                                          : extrapolation_in_doubles(rule, polynomial);
        Extrapolation& from = iteration->extrapolation.emplace_back();
        from.last = std::move(N.front());
        if (N.size() > 1) { from.before = std::move(N.back()); }
    }
    step.decisions.push_back(begins_with(polynomials, rule));
}

namespace {

Quadrature nodes_of(const GalerkinForm& form) {
    return {form.c, NumberVector(form.nodes(), Number(1))};
}

/// Returns the tables. P(t) is the polynomial through the P_i, or near to them. The velocities U_i
/// = sum_j phi_ij V_j have such a polynomial too, and its values at the nodes of the next step give
/// W_j = sum_i b_i phi_ij U_i / G_j.
CurveExtrapolation extrapolation(const GalerkinForm& form, Side side,
                                 const SlopePolynomial& polynomial) {
    const std::size_t r = form.nodes(), s = form.functions();
    const NumberMatrix next = extrapolation(nodes_of(form), polynomial).front();
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
    const std::optional<SlopePolynomial> polynomial =
        polynomial_of_one_step(nodes_of(form), {Number(1)});
    if (!polynomial) {
        return begins_at_the_start("extrapolating the last step's momenta would magnify their "
                                   "rounding too much");
    }
    galerkin.extrapolation = extrapolation(form, galerkin.side, *polynomial);
    step.decisions.push_back(
        {galerkin.side == Side::hamiltonian
             ? "the last step's curve and momenta, extrapolated, are the starting values of the "
               "iteration"
             : "the last step's curve, extrapolated, gives the starting values of the iteration",
         "they are good to the order of the interpolation"});
}

}  // namespace hvi::gen
