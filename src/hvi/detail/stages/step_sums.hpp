// The sums of a step that solves nothing.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_STEP_SUMS_HPP
#define HVI_STEP_SUMS_HPP

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The end of the last step, and its remainder (e_q, e_p). The increments of a step are summed
/// apart, beginning with the remainder, and the state takes one exact sum a step. The stages, where
/// slopes are evaluated, are plain sums beside them.
///
/// NOTE: only end() changes them, so that a step that failed can be tried again.
template <class Vector>
class StepSums {
public:
    /// Begins a step from x: change = (e_q, e_p), or 0 unless x is, bit for bit, the end of the
    /// last step. Returns false where sums do not round as they should.
    [[nodiscard]] constexpr bool begin(const State<Vector>& x, Vector& change_q, Vector& change_p) {
        continues_ = ended_ && same_bits(at_.q, x.q) && same_bits(at_.p, x.p);
        for (Index k = 0; k < x.q.size(); ++k) {
            change_q[k] = continues_ ? remainder_.q[k] : Scalar(0);
            change_p[k] = continues_ ? remainder_.p[k] : Scalar(0);
        }
        return continues_ || is_constant_evaluated() || sums_are_exact<Scalar>();
    }

    /// Returns whether the present step began where the last one ended.
    [[nodiscard]] constexpr bool continues() const { return continues_; }

    /// Adds the changes to x, by way of the vectors `q` and `p`, where the sums are finite.
    [[nodiscard]] constexpr bool end(State<Vector>& x, Vector& change_q, Vector& change_p,
                                     Vector& q, Vector& p) {
        add(x.q, change_q, q);
        add(x.p, change_p, p);
        if (!finite(q, p)) { return false; }
        ended_ = false;  // should the system be out of memory
        keep(q, x.q, at_.q);
        keep(p, x.p, at_.p);
        fit(remainder_.q, x.q.size());
        fit(remainder_.p, x.p.size());
        copy(change_q, remainder_.q);
        copy(change_p, remainder_.p);
        ended_ = true;
        return true;
    }

    constexpr void forget() { ended_ = false; }

private:
    using Index = IndexOf<Vector>;
    using Scalar = ScalarOf<Vector>;

    /// Sets `sum` to from + change, and `change` to the remainder of the sum.
    static constexpr void add(const Vector& from, Vector& change, Vector& sum) {
        for (Index k = 0; k < from.size(); ++k) {
            const Sum<Scalar> exact = two_sum(from[k], change[k]);
            sum[k] = exact.value;
            change[k] = exact.remainder;
        }
    }

    static constexpr void keep(const Vector& from, Vector& state, Vector& at) {
        fit(at, from.size());
        copy(from, state);
        copy(from, at);
    }

    State<Vector> at_;
    State<Vector> remainder_;
    bool continues_ = false;
    bool ended_ = false;
};

}  // namespace hvi::detail

#endif  // HVI_STEP_SUMS_HPP
