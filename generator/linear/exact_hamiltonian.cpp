// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/exact_hamiltonian.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/linear/stage_gradients.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

// ---- the series ----

ExactSeries::ExactSeries(const QuadraticForm& H) : H_(bordered(H)) {
    const std::size_t n = H.degrees_of_freedom();
    NumberMatrix product = lower_half_up(n) + upper_half_down(n);
    E_.push_back(bordered({std::move(product), NumberVector(2 * n), Number(0)}));
}

const NumberMatrix& ExactSeries::operator[](std::size_t k) {
    while (E_.size() <= k) { append(); }
    return E_[k];
}

/// By (k + 1) E_(k+1) = sum over i + j = k of end_i^T H end_j.
void ExactSeries::append() {
    const std::size_t k = E_.size() - 1;
    const std::size_t n = H_.size() / 2;
    NumberMatrix end = zeros(H_.size(), H_.size());
    for (std::size_t i = 0; i < n; ++i) { end[i] = E_[k][n + i]; }
    for (std::size_t i = n; k == 0 && i < end.size(); ++i) { end[i][i] = Number(1); }
    end_of_E_.push_back(std::move(end));
    NumberMatrix sum = zeros(H_.size(), H_.size());
    for (std::size_t i = 0; i <= k; ++i) {
        sum = sum + transpose(end_of_E_[i]) * (H_ * end_of_E_[k - i]);
    }
    E_.push_back(sum * (Number(1) / Number(static_cast<long>(k + 1))));
}

// ---- closed forms ----

namespace {

/// Whether the flow exp(h J S) is a polynomial in h. NOTE: the powers of a nilpotent matrix have
/// trace 0; for most other matrices the first power has another trace.
bool is_nilpotent(const NumberMatrix& S) {
    const std::size_t n = S.size() / 2;
    NumberMatrix power = (lower_half_up(n) + upper_half_down(n) * Number(-1)) * S;
    for (std::size_t exponent = 1; exponent < S.size(); exponent *= 2) {
        power = power * power;
        Number trace;
        for (std::size_t i = 0; i < power.size(); ++i) { trace = trace + power[i][i]; }
        if (!trace.is_zero()) { return false; }
    }
    return is_zero(power);
}

/// Returns the series if it ends with h^m for m = 2n + 1 or before. NOTE: once m + 1 further
/// coefficients are zero the sum up to h^m satisfies (2.7), whose right side is quadratic in it.
std::optional<QuadraticForm> sum_of_series(const QuadraticForm& H, const Number& h) {
    if (!is_nilpotent(H.S)) { return std::nullopt; }
    const std::size_t m = H.S.size() + 1;
    ExactSeries series(H);
    NumberMatrix sum = series[m];
    for (std::size_t k = m + 1; k <= 2 * m + 1; ++k) {
        if (!is_zero(series[k])) { return std::nullopt; }
    }
    for (std::size_t k = m; k-- > 0;) { sum = sum * h + series[k]; }
    return without_border(sum);
}

/// cos(omega h) and sin(omega h)/omega.
struct Wave {
    Number cosine, sine;
};

std::optional<Wave> wave(const Number& square, const Ground& ground) {
    const Number h = ground.parameter("h");
    if (square.is_zero()) { return Wave{Number(1), h}; }
    try {
        if (const auto omega = ground.either_root(square)) {
            return Wave{ground.cos(*omega * h), ground.sin(*omega * h) / *omega};
        }
        if (const auto kappa = ground.either_root(-square)) {
            const Number growing = ground.exp(*kappa * h);
            const Number shrinking = Number(1) / growing;
            return Wave{(growing + shrinking) / Number(2),
                        (growing - shrinking) / (Number(2) * *kappa)};
        }
    } catch (const InputError&) {}  // a function that has no place in the field
    return std::nullopt;
}

/// Returns the closed form of an oscillation. Precondition: one degree of freedom.
std::optional<QuadraticForm> of_oscillation(const QuadraticForm& H, const Ground& ground) {
    const Number& a = H.S[0][0];
    const Number& b = H.S[0][1];
    const Number& c = H.S[1][1];
    const Number square = a * c - b * b;
    const auto found = wave(square, ground);
    if (!found) { return std::nullopt; }
    const auto& [cosine, sine] = *found;
    const Number M22 = cosine - b * sine;
    const NumberMatrix E = {{a * sine / M22, Number(1) / M22}, {Number(1) / M22, c * sine / M22}};
    if (H.g[0].is_zero() && H.g[1].is_zero()) { return QuadraticForm{E, H.g, Number(0)}; }
    if (square.is_zero()) { return std::nullopt; }
    // Works about the point x = (q, p) where grad H = 0: there q_0 - q and p_1 - p take the places
    // of q_0 and p_1, and q_0 p + q p_1 - q p + h H(x) is added.
    const NumberVector x = {(b * H.g[1] - c * H.g[0]) / square, (b * H.g[0] - a * H.g[1]) / square};
    const NumberVector Ex = E * x;
    const Number half = Number(1) / Number(2);
    return QuadraticForm{E,
                         {x[1] - Ex[0], x[0] - Ex[1]},
                         half * (x[0] * Ex[0] + x[1] * Ex[1]) - x[0] * x[1] +
                             ground.parameter("h") * half * (H.g[0] * x[0] + H.g[1] * x[1])};
}

}  // namespace

std::optional<QuadraticForm> exact_discrete_hamiltonian(const QuadraticForm& H,
                                                        const Ground& ground) {
    if (auto polynomial = sum_of_series(H, ground.parameter("h"))) { return polynomial; }
    return H.degrees_of_freedom() == 1 ? of_oscillation(H, ground) : std::nullopt;
}

}  // namespace hvi::gen
