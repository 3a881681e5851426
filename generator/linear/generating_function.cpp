// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/generating_function.hpp"

#include <algorithm>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/linear/exact_hamiltonian.hpp"
#include "generator/linear/stage_gradients.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

bool are_equal(const NumberMatrix& left, const NumberMatrix& right) {
    return is_zero(left + right * Number(-1));
}

/// Returns C of the stages as functions of (q_0, p_1): P^i = p_1 + h sum_j (b_j - a~_ij) dH/dq^j.
NumberMatrix from_the_end(const StageFunctions& stages) {
    return transpose({stages.one}) * NumberMatrix{stages.b} + stages.A_tilde * Number(-1);
}

/// The stages x = (Q, P) and K = grad H(x) as functions of y = (q_0, p_1, 1), each times `one`.
struct StageValues {
    Number one;
    NumberMatrix x, K;  ///< 2ns x (2n + 1)
};

/// H_d^+ of (4.19), in whose third line
///
///     H_d^+ = q_0 p_1 + h sum_i b_i ((p_1 - P^i) V^i + H(Q^i, P^i)),
///
/// and of (4.2) with the velocities V^i at the nodes of a rule, which integrates their span
/// exactly. As V = dH/dp is the second half of K and H(x) = x^T (K + g)/2, the sum is y^T left^T
/// right y for left = (p_1 - P; x) and right = gram (V; (K + g)/2).
class DiscreteHamiltonian {
public:
    /// Precondition: H has no constant.
    DiscreteHamiltonian(const StageFunctions& stages, const QuadraticForm& H);

    [[nodiscard]] QuadraticForm closed_form(const Number& h) const;
    /// Returns (p_0, q_1) of the step as functions of y.
    [[nodiscard]] NumberMatrix other_ends(const Number& h) const;
    /// Returns the lowest power of h, up to h^last, in which its series differs from the exact one.
    [[nodiscard]] std::optional<int> first_difference(ExactSeries exact, int last) const;

private:
    [[nodiscard]] NumberMatrix left(const StageValues& values) const;
    [[nodiscard]] NumberMatrix right(const StageValues& values) const;

    const StageFunctions& stages_;
    const QuadraticForm& H_;
    std::size_t n_, half_;   ///< degrees of freedom; rows of Q
    NumberMatrix start_;     ///< (q_0, p_1) as a function of y
    NumberMatrix gradient_;  ///< S (q_0, p_1) + g
    NumberMatrix y_, g_;     ///< (q_0, p_1) and g on all stages
    StageGradients K_;
};

DiscreteHamiltonian::DiscreteHamiltonian(const StageFunctions& stages, const QuadraticForm& H)
    : stages_(stages),
      H_(H),
      n_(H.degrees_of_freedom()),
      half_(n_ * stages.count()),
      start_(beside(identity(2 * n_), zeros(2 * n_, 1))),
      gradient_(beside(H.S, transpose({H.g}))),
      K_(stage_gradients(H.S, stages, from_the_end(stages))) {
    const NumberMatrix one = transpose({stages.one});
    y_ = kronecker(start_, one);
    g_ = kronecker(beside(zeros(2 * n_, 2 * n_), transpose({H.g})), one);
}

NumberMatrix DiscreteHamiltonian::left(const StageValues& values) const {
    const NumberMatrix to_the_end = y_ * values.one + values.x * Number(-1);
    return stacked(rows(to_the_end, half_, 2 * half_), values.x);
}

NumberMatrix DiscreteHamiltonian::right(const StageValues& values) const {
    const NumberMatrix mean = (values.K + g_ * values.one) * (Number(1) / Number(2));
    return kronecker(identity(3 * n_), stages_.gram) *
           stacked(rows(values.K, half_, 2 * half_), mean);
}

QuadraticForm DiscreteHamiltonian::closed_form(const Number& h) const {
    StageValues values;
    values.one = polynomial(K_.denominator, h);
    values.K = polynomial(K_.numerator, h) * gradient_;
    values.x = y_ * values.one + K_.L * values.K * h;
    // NOTE: two divisions one after the other, as the sum is a multiple of `one` when the method is
    // symplectic.
    const Number reciprocal = Number(1) / values.one;
    NumberMatrix form = transpose(left(values)) * right(values) * h * reciprocal * reciprocal;
    for (std::size_t i = 0; i < n_; ++i) { form[n_ + i][i] = form[n_ + i][i] + Number(1); }
    return without_border(form + transpose(form));
}

/// By p_0 = p_1 + h b.W and q_1 = q_0 + h b.V with K = (W, V).
NumberMatrix DiscreteHamiltonian::other_ends(const Number& h) const {
    const NumberMatrix swap = lower_half_up(n_) + upper_half_down(n_);
    const NumberMatrix weights = kronecker(identity(2 * n_), {stages_.b});
    const Number one = polynomial(K_.denominator, h);
    return (swap * start_ * one + K_.weighted(weights, h) * gradient_ * h) * (Number(1) / one);
}

/// By the stages' own series: x_0 = y, K_0 = S x_0 + g, and then x_k = L K_(k-1), K_k = S x_k.
std::optional<int> DiscreteHamiltonian::first_difference(ExactSeries exact, int last) const {
    const NumberMatrix S = kronecker(H_.S, identity(stages_.count()));
    StageValues values{Number(1), y_, S * y_ + g_};
    std::vector<NumberMatrix> lefts, rights;
    for (int k = 1; k <= last; ++k) {
        lefts.push_back(transpose(left(values)));
        rights.push_back(right(values));
        NumberMatrix sum = lefts.front() * rights.back();
        for (std::size_t i = 1; i < lefts.size(); ++i) {
            sum = sum + lefts[i] * rights[lefts.size() - 1 - i];
        }
        if (!are_equal(sum + transpose(sum), exact[static_cast<std::size_t>(k)])) { return k; }
        values = {Number(0), K_.L * values.K, S * (K_.L * values.K)};
    }
    return std::nullopt;
}

// ---- all parts ----

GeneratingFunction zero(std::size_t variables, int order) {
    const QuadraticForm form{zeros(variables, variables), NumberVector(variables), Number(0)};
    return {form, form, true, true, order, true, true};
}

void add(QuadraticForm& sum, const QuadraticForm& term, const UncoupledPart& part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        for (std::size_t j = 0; j < part.size(); ++j) { sum.S[part[i]][part[j]] = term.S[i][j]; }
        sum.g[part[i]] = term.g[i];
    }
    sum.constant = sum.constant + term.constant;
}

void add_difference(GeneratingFunction& sum, const std::optional<int>& order) {
    if (!order) { return; }
    sum.order_of_difference = std::min(sum.order_of_difference, *order);
    sum.is_at_least = false;
}

/// Whether d2H_d^+/dp_1^2 is regular. Its product with dp_1/dp_0, which is regular, is dq_1/dp_0.
bool has_type_one(const QuadraticForm& discrete) {
    const std::size_t n = discrete.degrees_of_freedom();
    NumberMatrix by_p;
    for (std::size_t i = n; i < 2 * n; ++i) {
        by_p.emplace_back(discrete.S[i].begin() + static_cast<std::ptrdiff_t>(n),
                          discrete.S[i].end());
    }
    return inverse(by_p).has_value();
}

/// Adds the generating function of a part of H.
void add(GeneratingFunction& sum, const QuadraticForm& H, const UncoupledPart& part,
         const StageFunctions& stages, const Ground& ground) {
    const Number h = ground.parameter("h");
    const DiscreteHamiltonian method(stages, H);
    const QuadraticForm discrete = method.closed_form(h);
    add(sum.discrete, discrete, part);
    sum.has_type_one = sum.has_type_one && has_type_one(discrete);
    const NumberMatrix ends = method.other_ends(h);
    NumberMatrix Jacobian = ends;
    for (NumberVector& row : Jacobian) { row.pop_back(); }
    sum.is_symmetric = sum.is_symmetric && are_equal(Jacobian, transpose(Jacobian));
    sum.gives_map = sum.gives_map && are_equal(beside(discrete.S, transpose({discrete.g})), ends);
    add_difference(sum, method.first_difference(ExactSeries(H), sum.order_of_difference - 1));
    const auto exact = exact_discrete_hamiltonian(H, ground);
    if (!exact) { sum.exact.reset(); }
    if (sum.exact) { add(*sum.exact, *exact, part); }
}

GeneratingFunction function_of(const StageFunctions& stages, const QuadraticForm& H,
                               const Ground& ground) {
    const Progress::Stage stage("computing the generating function");
    // NOTE: twice the highest possible order, 2s, is computed: the order is higher for some H.
    const int powers = 4 * static_cast<int>(stages.count()) + 6;
    GeneratingFunction result = zero(H.g.size(), powers + 1);
    for (const UncoupledPart& part : uncoupled_parts(H)) {
        add(result, restricted(H, part), part, stages, ground);
    }
    const Number constant = ground.parameter("h") * H.constant;
    result.discrete.constant = result.discrete.constant + constant;
    if (result.exact) { result.exact->constant = result.exact->constant + constant; }
    return result;
}

}  // namespace

GeneratingFunction generating_function(const Tableau& tableau, const QuadraticForm& H,
                                       const Ground& ground) {
    return function_of(exact_stage_functions(tableau, H), H, ground);
}

GeneratingFunction generating_function(const GalerkinRule& rule, const QuadraticForm& H,
                                       const Ground& ground) {
    return function_of(exact_stage_functions(rule, H), H, ground);
}

}  // namespace hvi::gen
