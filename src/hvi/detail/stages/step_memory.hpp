// Memory of an implicit stepper from one step to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/moved.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The state, and the remainder (e_q, e_p) of the sums so far, which enters the stages, not the
/// update alone (Antonana, Makazaga & Murua).
///
/// Remainder, slopes and all else that one step leaves for the next belong to the state in which
/// that step ended: begin() drops them unless it is given exactly these bits.
template <class Vector>
struct StepMemory {
    using Index = IndexOf<Vector>;
    using Scalar = ScalarOf<Vector>;

    State<Vector> at;         ///< where the step begins, afterwards where it ended
    State<Vector> remainder;  ///< what rounding cut off from `at`
    Vector slope{};           ///< see scratch()
    State<Vector> change;     ///< of the stage values in one sweep: for each component, over stages
    Index n{};                ///< dimension of q and of p
    Scalar h = 0;
    Scalar h_before = 0;     ///< step size of the slopes; 0 when there are none
    bool side = false;       ///< changes with each step; see Sweeps
    bool continues = false;  ///< whether the step begins, bit for bit, where the last one ended
    bool goes_on = false;    ///< whether the last one also had the wanted size: its slopes help

    /// Prepares a step of size h from x. Precondition: h != 0.
    [[nodiscard]] Status begin(const State<Vector>& x, Scalar step_size) {
        return begin(x, step_size, step_size);
    }

    /// Prepares a step of size h from x, one of several steps in a row. Slopes are of use where the
    /// last step had the size `size_before`.
    [[nodiscard]] Status begin(const State<Vector>& x, Scalar step_size, Scalar size_before) {
        if (!sums_are_exact_) { return Status(Status::Code::unsafe_arithmetic); }
        if (!is_finite(step_size)) { return Status(Status::Code::not_finite); }
        if (x.q.size() != x.p.size()) { return Status(Status::Code::dimension_mismatch); }
        continues = ended_ && same_bits(at.q, x.q) && same_bits(at.p, x.p);
        side = continues && !side;
        h_before = continues ? h : 0;
        goes_on = continues && h_before == size_before;
        h = step_size;
        ended_ = false;
        if (!continues) { start_at(x); }
        return {};
    }

    /// Adds the increment to `at.q`, or `at.p`, keeping what rounding cuts off.
    static void add(Scalar& value, Scalar& cut_off, Scalar increment) {
        detail::move(value, cut_off, increment);
    }

    /// Ends the step: sets x to `at`, unless `at` is not finite.
    [[nodiscard]] Status end(State<Vector>& x, int iterations) {
        if (!finite(at.q, at.p)) { return Status(Status::Code::not_finite, iterations); }
        settle(at.q);
        settle(at.p);
        x.q = at.q;
        x.p = at.p;
        ended_ = true;
        return Status(Status::Code::ok, iterations);
    }

    void forget() { ended_ = false; }

    /// Takes x for the state in which the last step ended, from which it differs by rounding alone,
    /// so that the memory of that step is of use. Precondition: x has the dimension of that state.
    void go_on_from(const State<Vector>& x) {
        if (!ended_) { return; }
        at.q = x.q;
        at.p = x.p;
    }

    /// Returns whether `at`, `h` and the slopes are those of a good step.
    [[nodiscard]] bool has_ended() const { return ended_; }

private:
    /// Stores the numbers. NOTE: g++ -O3 may compute a sum once for each place that it is stored
    /// to, and contract products otherwise: x was not `at` in its last bit, after one step in 17 of
    /// one sweep of gauss:4 on Kepler's problem, and the step after it forgot all that it knew.
    [[gnu::always_inline]] static void settle([[maybe_unused]] Vector& numbers) {
        if constexpr (fixed_size<Vector>() > 0) { asm("" : "+m"(numbers)); }
    }

    void start_at(const State<Vector>& x) {
        n = x.q.size();
        at.q = x.q;
        at.p = x.p;
        for (Vector* v : {&remainder.q, &remainder.p, &change.q, &change.p, &slope}) { fit(*v, n); }
        for (Index k = 0; k < n; ++k) {
            remainder.q[k] = 0;
            remainder.p[k] = 0;
        }
    }

    bool ended_ = false;  ///< whether `at` is the end of a good step
    bool sums_are_exact_ = sums_are_exact<Scalar>();
};

}  // namespace hvi::detail
