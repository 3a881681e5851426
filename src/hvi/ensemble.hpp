// Many trajectories of one scene on all processors.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <hvi/detail/trajectories/courses.hpp>
#include <hvi/detail/trajectories/in_parallel.hpp>
#include <hvi/detail/trajectories/lane_groups.hpp>
#include <hvi/detail/trajectories/single_states.hpp>
#include <hvi/detail/trajectories/takes_several.hpp>

namespace hvi {

namespace detail {

/// NOTE: the name differs from hvi::Trajectories, which generated headers use.
template <class Stepper>
using TrajectoriesOf =
    std::conditional_t<TakesSeveral<Stepper>::value, LaneGroups<Stepper>, SingleStates<Stepper>>;

}  // namespace detail

/// `Stepper` is a class that `hvi-gen stepper --lanes ensemble` has written, which takes eight
/// trajectories at once, or any other stepper of a scene, such as one of a scene of any size. Each
/// trajectory ends with the same bits on any number of threads, whatever the other trajectories are
/// and wherever it stands among them. A trajectory whose step fails keeps the state before that
/// step, and the others go on. Where one has come to its end, or its step has failed, the next
/// takes its place among the eight, so that one with many steps does not hold others.
/// # Use
/// All trajectories have the same parameters, h and number of steps, unless each is given its own.
/// h is a time in the units of H and may be negative. Precondition of state(i), status(i), steps(i)
/// and stepper(i): i < size(). A step that fails throws nothing: ok() and status(i) report it. With
/// -pthread and the header of
///
///     hvi-gen stepper --method stormer-verlet pendulum --lanes ensemble -o pendulums.hpp
///
/// this is a program:
/// ```cpp
/// #include <cmath>
/// #include <cstddef>
/// #include <vector>
///
/// #include <hvi/ensemble.hpp>
/// #include <pendulums.hpp>
///
/// using Pendulum = hvi::generated::PendulumStormerVerlet;  // H = p^2/2 - cos(q)
///
/// double energy(const Pendulum::Trajectory& x) { return x.p[0] * x.p[0] / 2 - std::cos(x.q[0]); }
///
/// int main() {
///     std::vector<Pendulum::Trajectory> starts(20);
///     double angle = 0;
///     for (Pendulum::Trajectory& x : starts) { x.q[0] = angle += 0.1; }
///     starts[7].p[0] = std::nan("");
///     hvi::Ensemble<Pendulum> swings(starts);
///     const double h = 0.05;
///     swings.advance(h, 1000);
///
///     for (std::size_t i = 0; i < swings.size(); ++i) {
///         if (i == 7) { continue; }
///         // The method conserves H + h^2 (p^2 cos(q)/12 - sin(q)^2/24) up to h^4, and |p| <= 2.
///         const double error = energy(swings.state(i)) - energy(starts[i]);
///         if (swings.steps(i) != 1000 || std::abs(error) > h * h) { return 1; }
///     }
///     const bool has_stopped = swings.status(7).code() == hvi::Status::Code::not_finite;
///     return has_stopped && swings.steps(7) == 0 && !swings.ok() ? 0 : 1;
/// }
/// ```
template <class Stepper>
class Ensemble {
    using Trajectories = detail::TrajectoriesOf<Stepper>;

public:
    using Trajectory = typename Trajectories::Trajectory;
    using Parameters = typename Stepper::Parameters;
    using Scalar = typename Stepper::Scalar;

    /// Begins one trajectory at each of the states `starts`.
    explicit Ensemble(const std::vector<Trajectory>& starts, const Parameters& parameters = {})
        : parameters_{parameters}, size_(starts.size()), trajectories_(starts) {}

    /// Begins one trajectory at each of the states `starts`, with the parameters of the same place.
    /// Throws std::invalid_argument unless there are as many of both.
    Ensemble(const std::vector<Trajectory>& starts, const std::vector<Parameters>& parameters)
        : parameters_(parameters), size_(starts.size()), trajectories_(starts) {
        if (parameters.size() != starts.size()) {
            throw std::invalid_argument("hvi: there are as many parameters as starts");
        }
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// Takes each trajectory `steps` steps of size h further, on `threads` threads; 0: as many
    /// threads as there are processors. A thread takes one trajectory, or eight, through all steps,
    /// and then the next.
    ///
    /// Rethrows, when all threads have ended, the first exception of a step, std::bad_alloc or
    /// std::system_error. Some trajectories have then been advanced and others not.
    void advance(Scalar h, std::int64_t steps, unsigned threads = 0) {
        go({h}, {steps}, threads, detail::NoWatch());
    }

    /// Takes trajectory i `steps[i]` steps of size `h[i]` further, as advance() above does. One
    /// that has no steps, or steps of size 0, keeps every bit. Throws std::invalid_argument unless
    /// there are as many of both as trajectories.
    void advance(const std::vector<Scalar>& h, const std::vector<std::int64_t>& steps,
                 unsigned threads = 0) {
        check(h, steps);
        go(h, steps, threads, detail::NoWatch());
    }

    /// Take trajectories further as advance() does, and call watch(i, x) after each step of
    /// trajectory i, where x is its state now. Where that returns false the trajectory ends there,
    /// with all its steps so far; further calls go on from there. So a program stops trajectories,
    /// counts what happens to them, and keeps the largest or the mean of what it likes.
    ///
    /// Calls for one trajectory come in the order of its steps, and calls for several from several
    /// threads at once. Precondition: watch() throws nothing.
    template <class Watch>
    void advance_watched(Scalar h, std::int64_t steps, const Watch& watch, unsigned threads = 0) {
        go({h}, {steps}, threads, watch);
    }
    template <class Watch>
    void advance_watched(const std::vector<Scalar>& h, const std::vector<std::int64_t>& steps,
                         const Watch& watch, unsigned threads = 0) {
        check(h, steps);
        go(h, steps, threads, watch);
    }

    [[nodiscard]] Trajectory state(std::size_t i) const { return trajectories_.state(i); }

    /// Returns the status of the last step of trajectory i.
    [[nodiscard]] Status status(std::size_t i) const { return trajectories_.status(i); }

    /// Returns the number of steps that trajectory i has taken.
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return trajectories_.steps(i); }

    /// Returns whether no step of any trajectory has failed.
    [[nodiscard]] bool ok() const { return trajectories_.ok(); }

    /// Returns a stepper with the parameters of trajectory i. Its members give the energy and
    /// invariants of a state, where the header was generated with them.
    [[nodiscard]] Stepper stepper(std::size_t i = 0) const {
        return Stepper(parameters_[parameters_.size() > 1 ? i : 0]);
    }

private:
    void check(const std::vector<Scalar>& h, const std::vector<std::int64_t>& steps) const {
        if (h.size() == size_ && steps.size() == size_) { return; }
        throw std::invalid_argument(
            "hvi: there are as many sizes and numbers of steps as trajectories");
    }

    template <class Watch>
    void go(const std::vector<Scalar>& h, const std::vector<std::int64_t>& steps, unsigned threads,
            const Watch& watch) {
        if (size_ == 0) { return; }
        const detail::Courses<Stepper> courses(parameters_, h, steps);
        detail::in_parallel(trajectories_.pieces(), threads, [&](detail::Numbers& pieces) {
            trajectories_.advance(pieces, courses, watch);
        });
    }

    std::vector<Parameters> parameters_;  ///< of each trajectory, or one for all
    std::size_t size_;
    Trajectories trajectories_;
};

}  // namespace hvi
