// Several directions along one motion.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/drive/driven_stepper.hpp"

namespace hvi::gen {

/// Numbers of a direction: dq, then dp.
using DirectionVector = std::vector<double>;

[[nodiscard]] double norm_of(const DirectionVector& v);
[[nodiscard]] double product_of(const DirectionVector& v, const DirectionVector& w);

/// The direction in a state (q, dq), (dp, p).
[[nodiscard]] DirectionVector direction_of(const DrivenStepper::State& x);

/// Directions that begin where the scene does. Each has a stepper of its own, for states (q, dq),
/// (dp, p), and all go along the motion of the first: where rounding makes another one of it, as
/// stages are solved for, the others are put back.
class Directions {
public:
    explicit Directions(const std::vector<DirectionVector>& start);

    /// Takes a step with all. Unless the status is ok, they are not to be used any more.
    [[nodiscard]] Status step(double h);

    [[nodiscard]] std::size_t count() const { return states_.size(); }
    /// Half the numbers of a direction.
    [[nodiscard]] std::size_t degrees() const { return states_.front().q.size() / 2; }

    [[nodiscard]] DirectionVector direction(std::size_t k) const {
        return direction_of(states_[k]);
    }
    void set(std::size_t k, const DirectionVector& v);

    /// The state that all go along: (q, dq), (dp, p), with the first direction.
    [[nodiscard]] const DrivenStepper::State& state() const { return states_.front(); }

private:
    std::vector<DrivenStepper> steppers_;
    std::vector<DrivenStepper::State> states_;
};

/// Degrees of freedom of DrivenProblem, whose states have directions.
[[nodiscard]] std::size_t degrees_of_problem();

/// Makes the directions orthonormal, one after the other (Gram and Schmidt, twice), and returns
/// their norms on the way.
[[nodiscard]] std::vector<double> orthonormalize(std::vector<DirectionVector>& all);

}  // namespace hvi::gen
