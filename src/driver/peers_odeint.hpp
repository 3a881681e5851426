// Integrators of Boost.Odeint.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp. For the members of a peer see peer.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>
#include <driver/cost.hpp>
#include <driver/equations.hpp>
#include <driver/peer.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::driver::odeint {

namespace library = boost::numeric::odeint;

/// A peer that chooses its steps. A function of the library makes its `Stepper` from the wishes.
template <class Problem, class Stepper>
class Adaptive {
public:
    static constexpr bool takes_equal_steps = false;

    Adaptive(const PeerWishes& wishes, Stepper stepper)
        : wishes_(wishes), stepper_(std::move(stepper)) {}

    template <class Watch>
    Outcome run(Watch watch) {
        using Values = typename Equations<Problem>::Values;
        const auto slope = [this](const Values& y, Values& dydt, double t) {
            equations_.slope(y.data(), dydt.data(), t);
        };
        Outcome outcome;
        std::int64_t seen = 0;
        const auto observe = [&](const Values& y, double t) {
            if (++seen > most_steps_of_peers) { throw std::runtime_error("too many steps"); }
            watch(y.data(), y.data() + Equations<Problem>::n, t);
        };
        try {
            outcome.steps = static_cast<std::int64_t>(library::integrate_adaptive(
                std::ref(stepper_), slope, y_, 0.0, wishes_.until, wishes_.step(), observe));
        } catch (const std::runtime_error&) { outcome.status = no_step_is_small_enough; }
        outcome.evaluations = equations_.evaluations();
        if (outcome.ok() && !detail::finite(y_, y_)) { outcome.status = not_finite(); }
        return outcome;
    }

private:
    PeerWishes wishes_;
    Equations<Problem> equations_;
    Stepper stepper_;
    typename Equations<Problem>::Values y_ = Equations<Problem>::initial();
};

template <class Problem>
using BulirschStoerStepper = library::bulirsch_stoer<typename Equations<Problem>::Values>;

template <class Problem>
struct BulirschStoer : Adaptive<Problem, BulirschStoerStepper<Problem>> {
    explicit BulirschStoer(const PeerWishes& wishes)
        : Adaptive<Problem, BulirschStoerStepper<Problem>>(
              wishes, BulirschStoerStepper<Problem>(wishes.tolerance, wishes.tolerance)) {}
};

template <class Problem>
using Fehlberg78Stepper = library::controlled_runge_kutta<
    library::runge_kutta_fehlberg78<typename Equations<Problem>::Values>>;

template <class Problem>
struct Fehlberg78 : Adaptive<Problem, Fehlberg78Stepper<Problem>> {
    explicit Fehlberg78(const PeerWishes& wishes)
        : Adaptive<Problem, Fehlberg78Stepper<Problem>>(
              wishes, library::make_controlled<
                          library::runge_kutta_fehlberg78<typename Equations<Problem>::Values>>(
                          wishes.tolerance, wishes.tolerance)) {}
};

/// McLachlan's symplectic method of six stages for H = T(p) + U(q). NOTE: one line of the library's
/// documentation gives its order as 6, the next one as 4, which is the order that runs show.
template <class Problem>
class McLachlan {
public:
    static constexpr bool takes_equal_steps = true;

    explicit McLachlan(const PeerWishes& wishes) : wishes_(wishes) {
        const auto x = Problem::initial();
        q_ = x.q;
        p_ = x.p;
    }

    template <class Watch>
    Outcome run(Watch watch) {
        const auto velocity = [this](const Vector& p, Vector& out) { equations_.velocity(p, out); };
        const auto force = [this](const Vector& q, Vector& out) { equations_.force(q, out); };
        Outcome outcome;
        const double h = wishes_.step();
        for (; outcome.steps < wishes_.steps; ++outcome.steps) {
            const double t = h * static_cast<double>(outcome.steps);
            stepper_.do_step(std::make_pair(std::cref(velocity), std::cref(force)),
                             std::make_pair(std::ref(q_), std::ref(p_)), t, h);
            watch(q_.data(), p_.data(), t + h);
        }
        outcome.evaluations = equations_.evaluations();
        if (!detail::finite(q_, p_)) { outcome.status = not_finite(); }
        return outcome;
    }

private:
    using Vector = typename Equations<Problem>::Vector;

    PeerWishes wishes_;
    Equations<Problem> equations_;
    library::symplectic_rkn_sb3a_mclachlan<Vector> stepper_;
    Vector q_, p_;
};

template <class Problem>
int main(int argc, char** argv) {
    std::vector<NamedPeer> peers{
        named<Problem, BulirschStoer<Problem>>("bulirsch-stoer"),
        named<Problem, Fehlberg78<Problem>>("rkf78"),
    };
    if constexpr (Problem::is_separable && !Problem::depends_on_time) {
        peers.push_back(named<Problem, McLachlan<Problem>>("sb3a"));
    }
    return main_of_peers(argc, argv, peers);
}

}  // namespace hvi::driver::odeint
