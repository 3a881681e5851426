// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/rule_map.hpp"

#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/numbers/budget.hpp"

namespace hvi::gen {

namespace {

/// NOTE: beyond that it takes long even without parameters, and nobody would read the map.
constexpr std::size_t most_unknown_velocities = 24;

/// of_V V + of_x (q_0, p_0, 1), for the unknowns V of (4.6).
struct Affine {
    NumberMatrix of_V, of_x;
};

Affine operator*(const NumberMatrix& matrix, const Affine& affine) {
    return {matrix * affine.of_V, matrix * affine.of_x};
}

Affine operator+(const Affine& left, const Affine& right) {
    return {left.of_V + right.of_V, left.of_x + right.of_x};
}

Affine operator-(const Affine& left, const Affine& right) {
    return left + Affine{right.of_V * Number(-1), right.of_x * Number(-1)};
}

NumberMatrix ones(std::size_t height) { return transpose({NumberVector(height, Number(1))}); }

/// qq, qp, pq or pp.
NumberMatrix block(const NumberMatrix& S, std::size_t row, std::size_t column) {
    const std::size_t n = S.size() / 2;
    NumberMatrix result = rows(S, row * n, (row + 1) * n);
    for (NumberVector& entries : result) {
        entries = {entries.begin() + static_cast<long>(column * n),
                   entries.begin() + static_cast<long>((column + 1) * n)};
    }
    return result;
}

NumberMatrix inverse_mass(const NumberMatrix& H_pp) {
    const auto known = inverse(H_pp);
    if (!known) {
        throw MathError(
            "with more nodes than functions (4.6e) determines p at the nodes only where "
            "d2H/dp2 is regular",
            {}, "take as many nodes as functions");
    }
    return known->adjugate * (Number(1) / known->determinant);
}

/// The weights in (4.6d): of the P^i, and of the dH/dq(Q^i, P^i) but for h.
struct Weights {
    NumberMatrix of_momenta, of_slopes;  ///< s x r
};

Weights weights(const GalerkinRule& rule) {
    Weights result{rule.Psi, rule.Psi};
    for (std::size_t j = 0; j < rule.functions(); ++j) {
        for (std::size_t i = 0; i < rule.nodes(); ++i) {
            result.of_momenta[j][i] = rule.b[i] * rule.Psi[j][i];
            result.of_slopes[j][i] = rule.b[i] * (rule.B[j] - rule.A_psi[i][j]);
        }
    }
    return result;
}

/// (q_0, p_0, 1) -> (q_1, p_1), from V = -condition.of_V^-1 condition.of_x.
NumberMatrix ends(const GalerkinRule& rule, const Affine& condition, const Affine& slopes,
                  const Number& h) {
    const std::size_t n = condition.of_V.size() / rule.functions();
    const auto known = inverse(condition.of_V);
    HVI_CHECK(known);  // G (x) H_pp^-1 at h = 0
    const NumberMatrix V = known->adjugate * condition.of_x * (Number(-1) / known->determinant);
    const NumberMatrix moved_q = kronecker(identity(n), {rule.B}) * V;
    const NumberMatrix moved_p =
        kronecker(identity(n), {rule.b}) * (slopes.of_V * V + slopes.of_x) * Number(-1);
    return beside(identity(2 * n), zeros(2 * n, 1)) + stacked(moved_q, moved_p) * h;
}

/// In matrices degree of freedom k with function j stands in place k s + j, with node i in place
/// k r + i.
LinearMap map_of_part(const GalerkinRule& rule, const QuadraticForm& H, const Number& h) {
    const std::size_t n = H.degrees_of_freedom(), r = rule.nodes(), s = rule.functions();
    if (n * s > most_unknown_velocities) { throw TooLarge(); }
    const auto for_each = [&](const NumberMatrix& matrix) {
        return kronecker(identity(n), matrix);
    };
    const auto at_nodes = [&](const NumberMatrix& of_S) { return kronecker(of_S, identity(r)); };
    const auto part_of_g = [&](std::size_t part) {
        const NumberMatrix g = rows(transpose({H.g}), part * n, (part + 1) * n);
        return Affine{zeros(n * r, n * s), beside(zeros(n * r, 2 * n), kronecker(g, ones(r)))};
    };
    const auto S = [&](std::size_t i, std::size_t j) { return at_nodes(block(H.S, i, j)); };
    const Affine Q{for_each(rule.A_psi) * h,
                   beside(for_each(ones(r)), zeros(n * r, n + 1))};  // (4.6c)
    const Affine velocities{for_each(transpose(rule.Psi)), zeros(n * r, 2 * n + 1)};
    const Affine P = at_nodes(inverse_mass(block(H.S, 1, 1))) *
                     (velocities - (S(1, 0) * Q + part_of_g(1)));  // (4.6e)
    const Affine slopes = S(0, 0) * Q + S(0, 1) * P + part_of_g(0);
    const auto [of_momenta, of_slopes] = weights(rule);
    const Affine start{
        zeros(n * s, n * s),
        beside(beside(zeros(n * s, n), for_each(transpose({rule.B}))), zeros(n * s, 1))};
    const Affine condition =
        for_each(of_momenta) * P - start + for_each(of_slopes) * h * slopes;  // (4.6d)
    NumberMatrix matrix = ends(rule, condition, slopes, h);
    NumberVector offset;
    for (NumberVector& row : matrix) {
        offset.push_back(row.back());
        row.pop_back();
    }
    return {std::move(matrix), std::move(offset)};
}

}  // namespace

LinearMap one_step_map(const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
    return by_uncoupled_parts(H, [&](const QuadraticForm& part) {
        return map_of_part(rule, part, ground.parameter("h"));
    });
}

}  // namespace hvi::gen
