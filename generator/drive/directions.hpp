// Several directions along one motion.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "generator/drive/driven_stepper.hpp"

namespace hvi::gen {

/// Numbers of a direction: dq, then dp. Of a rotation R they are the theta of R exp(hat theta), and
/// of its angular momentum in the body dL.
using DirectionVector = std::vector<double>;

[[nodiscard]] double norm_of(const DirectionVector& v);
[[nodiscard]] double product_of(const DirectionVector& v, const DirectionVector& w);

/// The symplectic form of two directions at a state:
///
///     sum (dq_v dp_w - dp_v dq_w) + sum L . (theta_v x theta_w),
///
/// the first sum with theta and dL as well, the second over rotations (R. Abraham & J. E. Marsden,
/// Foundations of Mechanics, 1978, Proposition 4.4.1). In scaled time directions are those at one
/// time.
[[nodiscard]] double symplectic_form(const DrivenStepper::State& x, const DirectionVector& v,
                                     const DirectionVector& w);

/// The direction in a state (q, dq), (dp, p).
[[nodiscard]] DirectionVector direction_of(const DrivenStepper::State& x);

/// The derivatives of a state along the motion: of coordinates, then of momenta.
using FindMotion = std::function<std::vector<double>(const DrivenStepper::State&)>;

/// Directions at one time, of states that have a time t and its momentum e as their last coordinate
/// and momentum, as K = g (H + e) moves them. A direction that the motion carries along leads to
/// states of another time; less so much of the motion f that dt = 0 it is
///
///     d - f dt/f_t,
///
/// and without its part e that of H. As H + e stays 0, such a direction of H has de = -dH.
class DirectionsAtOneTime {
public:
    /// Looks at directions of a state that moves so.
    explicit DirectionsAtOneTime(std::vector<double> motion)
        : motion_(std::move(motion)), n_(motion_.size() / 2) {}

    [[nodiscard]] DirectionVector without_time(const DirectionVector& v) const;
    [[nodiscard]] DirectionVector with_time(const DirectionVector& v) const;

    /// Leaves out the parts along the time and e.
    [[nodiscard]] static DirectionVector of_q_and_p(const DirectionVector& v);

private:
    std::vector<double> motion_;
    std::size_t n_;  ///< coordinates, the time included
};

/// Directions that steps carry along. They begin as the states of the problem do.
class MovedDirections {
public:
    MovedDirections() = default;
    virtual ~MovedDirections() = default;
    MovedDirections(const MovedDirections&) = delete;
    MovedDirections& operator=(const MovedDirections&) = delete;

    /// Unless the status is ok, they are not to be used any more.
    [[nodiscard]] virtual Status step(double h) = 0;
    [[nodiscard]] virtual std::vector<DirectionVector> all() const = 0;
    /// Precondition: there are as many.
    virtual void set(const std::vector<DirectionVector>& all) = 0;
    /// Coordinates and momenta alone.
    [[nodiscard]] virtual DrivenStepper::State state() const = 0;
};

/// Directions along one motion. Of scaled time they are those of H, at one time.
class Directions {
public:
    /// Directions that begin as the states of the problem do: as derivatives by a parameter. Such a
    /// one has in scaled time the derivative of -H as its part along e. `motion` is that of scaled
    /// time, and nothing where time is not scaled.
    Directions(std::size_t count, FindMotion motion);
    /// Directions that begin here.
    Directions(const std::vector<DirectionVector>& start, FindMotion motion);

    /// Takes a step with all. Unless the status is ok, they are not to be used any more.
    [[nodiscard]] Status step(double h) { return moved_->step(h); }

    [[nodiscard]] std::vector<DirectionVector> all() const;
    /// Replaces all of them. Precondition: there are as many.
    void set(const std::vector<DirectionVector>& all);

    /// Directions as the steps carry them along, with parts along time and e, where there are.
    [[nodiscard]] std::vector<DirectionVector> carried() const { return moved_->all(); }

    /// The state that all go along.
    [[nodiscard]] DrivenStepper::State state() const { return moved_->state(); }

private:
    std::unique_ptr<MovedDirections> moved_;
    FindMotion motion_;
};

/// Degrees of freedom of DrivenProblem, whose steps or states have directions; a scaled time is one
/// of them.
[[nodiscard]] std::size_t degrees_of_problem();

/// Makes the directions orthonormal, one after the other (Gram and Schmidt, twice), and returns
/// their norms on the way.
[[nodiscard]] std::vector<double> orthonormalize(std::vector<DirectionVector>& all);

}  // namespace hvi::gen
