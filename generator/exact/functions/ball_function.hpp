// Functions of tau on complex balls: values, and derivatives where they are asked for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <acb.h>

#include <functional>

#include "generator/exact/functions/factor.hpp"
#include "generator/exact/numbers/ball.hpp"

namespace hvi::gen {

/// A rectangular complex ball of Arb, with value semantics.
class ComplexBall {
public:
    ComplexBall() { acb_init(ball_); }
    explicit ComplexBall(const Ball& real) : ComplexBall() { acb_set_arb(ball_, real.get()); }
    ComplexBall(const ComplexBall& other) : ComplexBall() { acb_set(ball_, other.ball_); }
    ComplexBall(ComplexBall&& other) noexcept : ComplexBall() { acb_swap(ball_, other.ball_); }
    ComplexBall& operator=(ComplexBall other) noexcept {
        acb_swap(ball_, other.ball_);
        return *this;
    }
    ~ComplexBall() { acb_clear(ball_); }

    [[nodiscard]] acb_ptr get() { return ball_; }
    [[nodiscard]] acb_srcptr get() const { return ball_; }

private:
    acb_t ball_;
};

/// Values of a function on a ball and, with `has_slope`, of its derivative.
struct Jet {
    ComplexBall value;
    ComplexBall slope;
    bool has_slope = false;
};

/// A function with its constants enclosed once. With `analytic` the result is not finite unless the
/// function is analytic on the whole ball, as acb_calc_integrate requires of an integrand.
using BallFunction = std::function<Jet(const Jet& tau, bool analytic)>;

/// Compile a function, or a term. Preconditions: no free parameter, no step.
[[nodiscard]] BallFunction compile(const ExactFunction& function, Precision bits);
[[nodiscard]] BallFunction compile(const ExactTerm& term, Precision bits);
[[nodiscard]] BallFunction compile(const Factor& factor, Precision bits);

/// Returns bounds of the real values on a real ball.
[[nodiscard]] Ball real_values(const BallFunction& function, const Ball& tau);

}  // namespace hvi::gen
