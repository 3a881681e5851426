// Functions of H that a stepper evaluates, as straight-line code: what is written, and what is
// counted.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/ir/step.hpp"
#include "generator/lower/direction_kernels.hpp"
#include "generator/lower/gradient_kernels.hpp"

namespace hvi::gen {

/// A block of second derivatives: the entries that are not zero, of a symmetric one those of the
/// lower half.
struct BlockKernel {
    struct Place {
        std::size_t row, column;
    };
    Kernel kernel;
    std::vector<Place> places;  ///< of its results
    bool is_symmetric = false;
};

/// For Newton's method: d2H/dq2 alone where the momenta are eliminated, and of a separable H no
/// mixed ones. For fixed points of the general Galerkin form d2H/dp2 alone.
struct SecondDerivatives {
    std::optional<BlockKernel> qq, mixed, conjugates;  ///< see Hessian

    [[nodiscard]] OperationCounts counts() const;
};

/// d2H/dq2 times a vector v, at one q and for several v.
struct Tangents {
    Kernel along;            ///< for each v
    std::vector<Node> kept;  ///< what it shares with dH/dq, computed for each q
    Kernel slope;            ///< dH/dq, then what is kept
};

/// A tabulated step evaluates nothing, and one of joint slopes both gradients at once alone.
struct Evaluations {
    GradientKernels gradients;
    std::optional<Kernel> inverse_mass;          ///< see Structure
    std::optional<Kernel> shared;                ///< by_q, then what by_conjugates_at_q takes of it
    std::optional<Kernel> stiffness;             ///< of StiffComponents
    std::optional<SecondDerivatives> constant;   ///< terms of them, of CoupledConstants
    std::optional<SecondDerivatives> second;     ///< where an iteration needs some
    std::optional<Tangents> tangents;            ///< for Solver::newton_taylor
    std::optional<DirectionKernels> directions;  ///< of Carries::directions
};

[[nodiscard]] Evaluations evaluations(const System& system, GradientKernels gradients,
                                      const Step& step);

}  // namespace hvi::gen
