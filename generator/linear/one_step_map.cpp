// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/one_step_map.hpp"

#include "generator/exact/algebra/matrix.hpp"
#include "generator/linear/stage_gradients.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// The map x_1 = x_0 + h J (I (x) b^T) K, where K is linear in S x_0 + g.
LinearMap map_of_part(const StageFunctions& stages, const QuadraticForm& H, const Number& h) {
    const std::size_t n = H.degrees_of_freedom();
    const StageGradients K = stage_gradients(H.S, stages, stages.A_tilde * Number(-1));
    const NumberMatrix J = lower_half_up(n) + upper_half_down(n) * Number(-1);
    const NumberMatrix slope = K.weighted(kronecker(J, {stages.b}), h) * h;
    const Number D = polynomial(K.denominator, h);
    const Number reciprocal = Number(1) / D;
    return {(identity(2 * n) * D + slope * H.S) * reciprocal, slope * H.g * reciprocal};
}

/// Computes a map for each uncoupled part of the degrees of freedom, and puts these together.
LinearMap map_of(const StageFunctions& stages, const QuadraticForm& H, const Ground& ground) {
    const Progress::Stage stage("computing the map of one step");
    const Number h = ground.parameter("h");
    const std::size_t size = H.g.size();
    LinearMap result{zeros(size, size), NumberVector(size)};
    for (const UncoupledPart& part : uncoupled_parts(H)) {
        const LinearMap map = map_of_part(stages, restricted(H, part), h);
        for (std::size_t i = 0; i < part.size(); ++i) {
            for (std::size_t j = 0; j < part.size(); ++j) {
                result.matrix[part[i]][part[j]] = map.matrix[i][j];
            }
            result.offset[part[i]] = map.offset[i];
        }
    }
    return result;
}

}  // namespace

LinearMap one_step_map(const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
    return map_of(exact_stage_functions(tableau, H), H, ground);
}

LinearMap one_step_map(const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
    return map_of(exact_stage_functions(rule, H), H, ground);
}

}  // namespace hvi::gen
