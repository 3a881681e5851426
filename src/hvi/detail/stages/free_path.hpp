// Free paths of momenta and kicks of forces, in the units of positions.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/two_product.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

// A step of H = p^T K p/2 + U(q) is symplectic where positions and momenta are moved by one and the
// same step size. For a given h, however, roundings of h x have a mean that is not 0 and differs
// from set to set of x: with h K p and h K Lp rounded each for itself the energy drifts (kepler,
// gauss:12, h = 1/5: by 2.6e-19 of H a step). So p is turned into w = (h K) p, forces kick w, and p
// is w/(h K) at the end: both ways in twice the digits, with one number h K. A kick W_j is then
// rounded in the same way in the stages, in q and in p.

/// Moves x by far + near, where `near` is small or far is exact. `remainder` is what rounding has
/// cut off from x before, and becomes what it cuts off now. V is a number or lanes.
template <class V>
[[gnu::always_inline]] constexpr void move_far(V& x, V& remainder, const V& far, const V& near) {
    const Sum<V> first = two_sum<V>(x, far);
    const Sum<V> both = two_sum<V>(first.value, first.remainder + (remainder + near));
    x = both.value;
    remainder = both.remainder;
}

/// Moves x by kick + rest, where the rest is what rounding cut off from the kick.
///
/// NOTE: `remainder` may be a little more than half a unit in the last place of x. The next step,
/// which begins with x, then waits for two sums instead of two exact ones.
template <class V>
[[gnu::always_inline]] constexpr void move_by_kick(V& x, V& remainder, const Pair<V>& kick) {
    const Sum<V> near = two_sum<V>(kick.hi, remainder);
    const Sum<V> sum = two_sum<V>(x, near.value);
    x = sum.value;
    remainder = sum.remainder + (near.remainder + kick.lo);
}

/// Returns factor (p + e_p) + offset, where the offset is small or p is 0.
template <class V>
[[nodiscard, gnu::always_inline]] inline Pair<V> scaled_momentum(const V& factor, const V& p,
                                                                 const V& e_p, const V& offset) {
    const Pair<V> product = two_product(factor, p);
    return {product.hi, product.lo + (factor * e_p + offset)};
}

/// Returns kick / factor, where `inverse` is 1/factor, rounded.
template <class V>
[[nodiscard, gnu::always_inline]] inline Pair<V> momentum_of(const Pair<V>& kick, const V& factor,
                                                             const V& inverse) {
    const V quotient = kick.hi * inverse;
    const Pair<V> product = two_product(quotient, factor);
    return {quotient, (((kick.hi - product.hi) - product.lo) + kick.lo) * inverse};
}

/// Returns the sum of f(first), f(first + 1), ...; `lo` is what rounding cuts off from `hi`.
///
/// NOTE: rounded sums of the kicks of stages are as biased as products with h: added up one after
/// the other, those of kepler with gauss:12 and h = 1/5 drift by 3e-19 of H a step.
template <class V, std::size_t count, std::size_t first = 0, class F>
[[nodiscard, gnu::always_inline]] inline Pair<V> exact_sum(const F& f) {
    if constexpr (count == 1) {
        return {f(first), V(0)};
    } else {
        const Pair<V> left = exact_sum<V, count / 2, first>(f);
        const Pair<V> right = exact_sum<V, count - count / 2, first + count / 2>(f);
        const Sum<V> both = two_sum<V>(left.hi, right.hi);
        return {both.value, both.remainder + (left.lo + right.lo)};
    }
}

/// Factors h K_k from momenta to paths in a step of size h, where K is diagonal. Otherwise the
/// factor is h, and paths are K times scaled momenta.
///
/// NOTE: values that do not depend on h are computed once, as steps of a composition have sizes in
/// turn.
template <class Vector>
class PathFactors {
public:
    using Index = IndexOf<Vector>;
    using Scalar = ScalarOf<Vector>;

    /// Sets the factors for h. Precondition: the system is the same each time.
    template <class System>
    void set(const System& system, Index n, Scalar h) {
        if (!is_known_ || n != K_.size()) { look_at(system, n); }
        has_zeros_ = false;
        for (Index k = 0; k < n; ++k) {
            factor_[k] = h * K_[k];
            inverse_[k] = 1 / factor_[k];
            offset_[k] = h * velocity_[k];
            has_zeros_ = has_zeros_ || factor_[k] == 0;
        }
    }

    [[nodiscard]] const Scalar& operator[](Index k) const { return factor_[k]; }
    [[nodiscard]] const Vector& all() const { return factor_; }
    [[nodiscard]] const Scalar& inverse(Index k) const { return inverse_[k]; }

    /// Returns h times the part of dH/dp that does not depend on p.
    [[nodiscard]] const Scalar& offset(Index k) const { return offset_[k]; }

    /// Returns room for momenta times factors.
    [[nodiscard]] Vector& scratch() { return scratch_; }

    /// Sets path + rest to w = h dH/dp, to twice the digits.
    template <class System>
    void scale(const System& system, const Vector& p, const Vector& e_p, Vector& path,
               Vector& rest) {
        for (Index k = 0; k < p.size(); ++k) {
            const Scalar offset = System::has_diagonal_mass ? offset_[k] : Scalar(0);
            const Pair<Scalar> w = scaled_momentum<Scalar>(factor_[k], p[k], e_p[k], offset);
            path[k] = w.hi;
            rest[k] = w.lo;
        }
        if constexpr (!System::has_diagonal_mass) {
            for (Vector* each : {&path, &rest}) {
                copy(*each, scratch_);
                system.inverse_mass(scratch_, *each);
            }
            for (Index k = 0; k < p.size(); ++k) { rest[k] += offset_[k]; }
        }
    }

    /// Moves p by the kicks of a step; `kick(k)` is their exact sum, and `force(k)` that of Lp_j.
    template <class Kick, class Force>
    void kick(Vector& p, Vector& e_p, Kick kick, Force force) const {
        if (has_zeros_) { return kick_some(p, e_p, kick, force); }
        for (Index k = 0; k < p.size(); ++k) {
            move_by_kick<Scalar>(p[k], e_p[k],
                                 momentum_of<Scalar>(kick(k), factor_[k], inverse_[k]));
        }
    }

private:
    /// Sets the values that do not depend on h.
    template <class System>
    [[gnu::noinline]] void look_at(const System& system, Index n) {
        for (Vector* v : {&K_, &velocity_, &factor_, &inverse_, &offset_, &scratch_}) {
            fit(*v, n);
        }
        for (Index k = 0; k < n; ++k) { scratch_[k] = 0; }
        system.dHdp(scratch_, velocity_);
        for (Index k = 0; k < n; ++k) { scratch_[k] = 1; }
        if constexpr (System::has_diagonal_mass) {
            system.inverse_mass(scratch_, K_);
        } else {
            copy(scratch_, K_);
        }
        is_known_ = true;
    }

    /// Moves p where some factors are 0, so that the forces alone give the change.
    template <class Kick, class Force>
    [[gnu::noinline]] void kick_some(Vector& p, Vector& e_p, const Kick& kick,
                                     const Force& force) const {
        for (Index k = 0; k < p.size(); ++k) {
            move_by_kick<Scalar>(
                p[k], e_p[k],
                factor_[k] == 0 ? force(k) : momentum_of<Scalar>(kick(k), factor_[k], inverse_[k]));
        }
    }

    Vector K_{}, velocity_{};  ///< K_k, or 1; dH/dp without p
    Vector factor_{}, inverse_{}, offset_{}, scratch_{};
    bool is_known_ = false;   ///< whether the values that do not depend on h are set
    bool has_zeros_ = false;  ///< whether some momenta do not move their positions
};

}  // namespace hvi::detail
