// The stage equations of directions as one system of linear equations.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/directions/cells.hpp>
#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/solvers/pause.hpp>

namespace hvi::detail {

/// Calls use(rows, stage, component, number) for each slope of a direction.
template <class Equations, std::size_t stages, class Use>
void for_unknowns(const Use& use) {
    std::size_t number = 0;
    for (std::size_t rows = 0; rows < Equations::unknown_rows; ++rows) {
        for (std::size_t stage = 0; stage < stages; ++stage) {
            for (std::size_t k = 0; k < Equations::degrees; ++k) { use(rows, stage, k, number++); }
        }
    }
}

/// Solves for the slopes L = G L + g where sweeps do not: L is moved by (I - G)^-1 (G L + g - L).
/// The matrix is of the step, and all directions share it. `Equations` are those of one direction,
/// in `Cells`.
template <class Equations, class Cells, std::size_t stages>
class DirectSolution {
public:
    using Scalar = typename Cells::Number;
    static constexpr std::size_t unknowns = stages * Equations::degrees * Equations::unknown_rows;

    /// Before the directions of a step are taken along.
    void begin_step() {
        is_computed_ = false;
        sweeps_fail_.pass();
    }

    /// Whether sweeps are worth a trial.
    [[nodiscard]] bool allows_sweeps() const { return sweeps_fail_.is_over(); }
    void note_failure() {
        if (sweeps_fail_.is_over()) { sweeps_fail_.begin(); }
    }

    /// Makes the matrix of this step. False where it is singular.
    template <class Step>
    [[nodiscard]] bool compute(const Step& step) {
        if (is_computed_) { return is_regular_; }
        is_computed_ = true;
        Equations equations;
        equations.begin(step);
        matrix_.set_zero(unknowns);
        matrix_.set_identity();
        for_unknowns<Equations, stages>(
            [&](std::size_t rows, std::size_t stage, std::size_t k, std::size_t column) {
                equations.slopes = {};
                Cells::set(equations.slopes[rows], stage, k, 0, 1);
                equations.sweep(step);
                for_unknowns<Equations, stages>(
                    [&](std::size_t of, std::size_t i, std::size_t l, std::size_t row) {
                        matrix_(row, column) -= Cells::get(equations.slopes[of], i, l, 0);
                    });
            });
        is_regular_ = matrix_.is_finite() && factors_.compute(matrix_);
        return is_regular_;
    }

    /// (I - G)^-1 b.
    void solve(Scalar* b) const { factors_.solve(b); }

private:
    SquareMatrix<Scalar> matrix_;
    Factors<Scalar> factors_;
    bool is_computed_ = false, is_regular_ = false;
    Pause<8> sweeps_fail_;
};

}  // namespace hvi::detail
