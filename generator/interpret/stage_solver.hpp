// Solvers of stage equations without a compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <hvi/detail/module/loaded_solvers.hpp>
#include <hvi/detail/solvers/automatic.hpp>
#include <hvi/fixed_point.hpp>
#include <hvi/fixed_sweeps.hpp>

#include "generator/interpret/system_program.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// A policy in place of Newton's method, which is to come.
struct NewtonToCome {
    template <class Vector>
    struct Iteration {
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled&) const {
            throw detail::SolverIsApart();
        }
    };
};

/// Fixed points, alone, for as long as they contract, or of counted sweeps. Throws SolverIsApart
/// where Newton's method is called for.
class StageSolver {
public:
    explicit StageSolver(const Iteration& iteration)
        : is_automatic_(iteration.solver == Solver::automatic), sweeps_(iteration.sweeps) {}

    template <class Coupled>
    [[nodiscard]] Status solve(Coupled coupled) {
        if (sweeps_ > 0) return counted_.solve(coupled, sweeps_);
        return is_automatic_ ? automatic_.solve(coupled) : fixed_point_.solve(coupled);
    }

private:
    using Vector = InterpretedSystem::Vector;

    bool is_automatic_;
    int sweeps_;  ///< counted ones; 0: they end at round-off
    Automatic<NewtonToCome>::Iteration<Vector> automatic_;
    FixedPoint::Iteration<Vector> fixed_point_;
    detail::CountedSweeps<Vector> counted_;
};

}  // namespace hvi::gen
