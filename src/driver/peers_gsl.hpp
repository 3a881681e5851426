// Integrators of the GNU Scientific Library.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp. For the members of a peer see peer.hpp.
#pragma once

#include <gsl/gsl_errno.h>

#include <cstddef>
#include <tuple>

#include <driver/cost.hpp>
#include <driver/equations.hpp>
#include <driver/peer.hpp>
#include <gsl/gsl_odeiv2.h>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::driver::gsl {

/// A scene as the library sees it, and the present state of a run.
template <class Problem>
class Integration {
public:
    Integration(const gsl_odeiv2_step_type* type, const PeerWishes& wishes, double tolerance)
        : driver_(
              gsl_odeiv2_driver_alloc_y_new(&system_, type, wishes.step(), tolerance, tolerance)) {}
    ~Integration() { gsl_odeiv2_driver_free(driver_); }
    Integration(const Integration&) = delete;
    Integration& operator=(const Integration&) = delete;

    /// Takes a step of size h from t. Returns false where it fails.
    [[nodiscard]] bool step(double t, double h) {
        return gsl_odeiv2_step_apply(driver_->s, t, h, y_.data(), errors_.data(), nullptr, nullptr,
                                     &system_) == GSL_SUCCESS;
    }

    /// Takes a step from t towards `until`, of a size that the library chooses, h at first. It
    /// changes t and h.
    [[nodiscard]] bool step_towards(double until, double& t, double& h) {
        return gsl_odeiv2_evolve_apply(driver_->e, driver_->c, driver_->s, &system_, &t, until, &h,
                                       y_.data()) == GSL_SUCCESS;
    }

    template <class Watch>
    void show(Watch& watch, double t) const {
        watch(y_.data(), y_.data() + Equations<Problem>::n, t);
    }

    /// Returns the outcome, completed at the end of the run.
    [[nodiscard]] Outcome end(Outcome outcome) const {
        outcome.evaluations = equations_.evaluations();
        if (outcome.ok() && !detail::finite(y_, y_)) { outcome.status = not_finite(); }
        return outcome;
    }

private:
    using Values = typename Equations<Problem>::Values;

    static int slope(double t, const double* y, double* dydt, void* equations) {
        static_cast<const Equations<Problem>*>(equations)->slope(y, dydt, t);
        return GSL_SUCCESS;
    }

    /// Computes the Jacobian. NOTE: rk4imp, which alone asks for it, ignores the derivatives by t.
    static int jacobian(double t, const double* y, double* rows, double* by_t, void* equations) {
        static_cast<const Equations<Problem>*>(equations)->jacobian(y, rows, t);
        for (std::size_t k = 0; k < std::tuple_size<Values>::value; ++k) { by_t[k] = 0; }
        return GSL_SUCCESS;
    }

    Equations<Problem> equations_;
    gsl_odeiv2_system system_{slope, jacobian, std::tuple_size<Values>::value, &equations_};
    gsl_odeiv2_driver* driver_;
    Values y_ = Equations<Problem>::initial();
    Values errors_{};
};

/// Prince and Dormand's pair of orders 8 and 9.
template <class Problem>
class PrinceDormand {
public:
    static constexpr bool takes_equal_steps = false;

    explicit PrinceDormand(const PeerWishes& wishes)
        : wishes_(wishes), integration_(gsl_odeiv2_step_rk8pd, wishes, wishes.tolerance) {}

    template <class Watch>
    Outcome run(Watch watch) {
        Outcome outcome;
        double t = 0, h = wishes_.step();
        while (t != wishes_.until) {
            const bool is_good = outcome.steps < most_steps_of_peers &&
                                 integration_.step_towards(wishes_.until, t, h);
            if (!is_good) {
                outcome.status = no_step_is_small_enough;
                break;
            }
            ++outcome.steps;
            integration_.show(watch, t);
        }
        return integration_.end(outcome);
    }

private:
    PeerWishes wishes_;
    Integration<Problem> integration_;
};

/// Gauss' method of two stages. To estimate its error, rk4imp takes each step a second time as two
/// halves, and goes on from these. So it is our gauss:2 with twice as many steps. The tolerance is
/// that of Newton's method.
template <class Problem>
class Gauss {
public:
    static constexpr bool takes_equal_steps = true;

    explicit Gauss(const PeerWishes& wishes)
        : wishes_(wishes), integration_(gsl_odeiv2_step_rk4imp, wishes, wishes.tolerance) {}

    template <class Watch>
    Outcome run(Watch watch) {
        Outcome outcome;
        const double h = wishes_.step();
        for (; outcome.steps < wishes_.steps; ++outcome.steps) {
            const double t = h * static_cast<double>(outcome.steps);
            if (!integration_.step(t, h)) {
                outcome.status = Status(Status::Code::not_converged).message();
                break;
            }
            integration_.show(watch, t + h);
        }
        return integration_.end(outcome);
    }

private:
    PeerWishes wishes_;
    Integration<Problem> integration_;
};

template <class Problem>
int main(int argc, char** argv) {
    gsl_set_error_handler_off();
    return main_of_peers(argc, argv,
                         {named<Problem, Gauss<Problem>>("rk4imp"),
                          named<Problem, PrinceDormand<Problem>>("rk8pd")});
}

}  // namespace hvi::driver::gsl
