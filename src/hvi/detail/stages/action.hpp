// The discrete Hamiltonian of a step, and the discrete action of a run.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Returns a . b.
template <class Vector>
[[nodiscard]] ScalarOf<Vector> dot(const Vector& a, const Vector& b) {
    ScalarOf<Vector> sum = 0;
    for (IndexOf<Vector> k = 0; k < a.size(); ++k) { sum += a[k] * b[k]; }
    return sum;
}

/// Returns whether both are the same state, bit for bit.
template <class Vector>
[[nodiscard]] bool same_state(const State<Vector>& x, const State<Vector>& y) {
    return same_bits(x.q, y.q) && same_bits(x.p, y.p);
}
template <class Vector>
[[nodiscard]] bool same_state(const TimedState<Vector>& x, const TimedState<Vector>& y) {
    return same_bits(x.q, y.q) && same_bits(x.p, y.p) && x.t == y.t;
}

/// Action of (4.19), or (4.2), and (3.11), by the integrals of p dq - H dt over the steps l = 0,
/// ..., k - 1. U_i is the velocity at stage i, for (4.19) dH/dp(Q_i, P_i):
///
///     A_l = h sum_i b_i (P_i . U_i - H(Q_i, P_i)) = h sum_i b_i L(Q_i, U_i),
///     H_d^+(q_l, p_{l+1}) = p_{l+1} . q_{l+1} - A_l,    S_d^k = p_k . q_k - sum_l A_l.
///
/// The remainder that rounding cuts off from the sum of all A_l is kept. The sum begins anew with a
/// step that does not begin, bit for bit, where the last good step has ended. A step that failed
/// leaves all as it was, so that it can be tried again.
template <class State>
class ActionSum {
public:
    using Scalar = ScalarOf<decltype(State::q)>;

    /// Prepares for the end of a step from x, over which A_l is `integral`.
    void begin(const State& x, Scalar integral) {
        continues_ = ended_ && same_state(at_, x);
        integral_ = integral;
    }

    /// Ends the step in x, or leaves all as it was where `status` is not ok.
    [[nodiscard]] Status end(const State& x, Status status) {
        if (!status.ok()) { return status; }
        const Sum<Scalar> before = continues_ ? sum_ : Sum<Scalar>{0, 0};
        sum_ = two_sum(before.value, before.remainder + integral_);
        product_ = dot(x.p, x.q);
        of_step_ = product_ - integral_;
        at_ = x;
        ended_ = true;
        return status;
    }

    void forget() { ended_ = false; }

    /// Return H_d^+ of the last step, and S_d^k; NaN where there was none.
    [[nodiscard]] Scalar of_step() const { return ended_ ? of_step_ : nothing(); }
    [[nodiscard]] Scalar of_steps() const {
        return ended_ ? (product_ - sum_.value) - sum_.remainder : nothing();
    }

private:
    // NOTE: NaN of float, as the standard library may know none of __float128.
    [[nodiscard]] static Scalar nothing() {
        return static_cast<Scalar>(std::numeric_limits<float>::quiet_NaN());
    }

    State at_{};  // end of the last good step
    Sum<Scalar> sum_{0, 0};
    Scalar integral_ = 0;  // over the present step
    Scalar product_ = 0;   // p . q in at_
    Scalar of_step_ = 0;
    bool continues_ = false;
    bool ended_ = false;
};

}  // namespace hvi::detail
