// Directions and covectors at one time, for steppers whose time is scaled.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi {

namespace detail {

/// Whether both gradients are one function, gradient(q, p, dHdq, dHdp).
template <class System, class Vector, class = void>
struct HasJointGradients : std::false_type {};
template <class System, class Vector>
struct HasJointGradients<System, Vector,
                         std::void_t<decltype(std::declval<const System&>().gradient(
                             std::declval<const Vector&>(), std::declval<const Vector&>(),
                             std::declval<Vector&>(), std::declval<Vector&>()))>> : std::true_type {
};

}  // namespace detail

/// A stepper in scaled time has the time t as its last coordinate and e as its last momentum, which
/// begins as -H and moves so that H + e stays 0. Its steps carry directions of such states along,
/// which lead to states of another time. Here these become directions of (q, p) at one time, and
/// back. With the motion f of the state they are
///
///     dt = 0, de = -dH, as a direction begins, and d - f dt/f_t, as it ends.
/// # Use
/// Coordinates, momenta and the time are the motion's own: of directions and covectors of (q, p)
/// the parts along t and e are 0. It takes the class `System` of a stepper, unless sums stay loops.
/// f is that of the exact motion, so that derivatives agree with differences of runs to one time up
/// to the order of the method. With the header of
///
///     hvi-gen stepper --method stormer-verlet eccentric-kepler --tangent -o comet_tangent.hpp
///
/// this is a program, which differentiates where a comet is at the time of the end by its speed at
/// the perihelion, forward and backward:
/// ```cpp
/// #include <cmath>
/// #include <cstddef>
/// #include <vector>
///
/// #include <comet_tangent.hpp>
/// #include <hvi/one_time.hpp>
///
/// using Comet = hvi::generated::EccentricKeplerStormerVerlet;
///
/// int main() {
///     const double h = 0.1;
///     Comet::Parameters parameters;
///     parameters.ecc = 0.5;
///     Comet comet(parameters);
///     const Comet::System system(parameters);
///     std::vector<Comet::State> x{Comet::initial(parameters)};
///     const hvi::OneTime<Comet::State> start(system, x.front());
///     std::vector<Comet::State> d(1);
///     d[0].p[1] = 1;
///     start.begin(d[0]);
///     for (int step = 0; step < 100; ++step) {
///         x.push_back(x.back());
///         if (!comet.step(x.back(), d, h).ok()) { return 1; }
///     }
///     const hvi::OneTime<Comet::State> end(system, x.back());
///     end.end(d[0]);
///
///     Comet::State lambda{};
///     lambda.q[0] = 1;  // the derivative of x
///     end.pull_back_end(lambda);
///     for (std::size_t step = 100; step-- > 0;) {
///         if (!comet.pull_back(x[step], lambda, h).ok()) { return 1; }
///     }
///     start.pull_back_begin(lambda);
///     return std::abs(lambda.p[1] - d[0].q[0]) < 1e-10 ? 0 : 1;
/// }
/// ```
template <class State>
class OneTime {
    using Vector = std::decay_t<decltype(State::q)>;
    using Scalar = detail::ScalarOf<Vector>;

public:
    /// Looks at directions and covectors at the state x.
    template <class System>
    OneTime(const System& system, const State& x)
        : motion_(x), last_(static_cast<std::size_t>(x.q.size()) - 1) {
        constexpr bool separable = detail::HasSeparableGradients<System, Vector>::value;
        constexpr bool joint = detail::HasJointGradients<System, Vector>::value;
        static_assert(separable || joint || detail::HasGradients<System, Vector>::value,
                      "hvi: the derivatives dHdq and dHdp of the system are needed, which it does "
                      "not have where sums stay loops");
        if constexpr (separable) {
            system.dHdp(x.p, motion_.q);
            system.dHdq(x.q, motion_.p);
        } else if constexpr (joint) {
            system.gradient(x.q, x.p, motion_.p, motion_.q);
        } else {
            system.dHdp(x.q, x.p, motion_.q);
            system.dHdq(x.q, x.p, motion_.p);
        }
        for (std::size_t k = 0; k <= last_; ++k) { p(motion_, k) = -p(motion_, k); }
    }

    /// Makes of a direction of (q, p) the one that steps are to carry along from x.
    void begin(State& d) const {
        Scalar change = 0;  // of H, times f_t
        for (std::size_t k = 0; k < last_; ++k) {
            change += q(motion_, k) * p(d, k) - p(motion_, k) * q(d, k);
        }
        q(d, last_) = 0;
        p(d, last_) = -change / speed();
    }

    /// Makes of a direction that steps have carried to x the one of (q, p) at the time of x.
    void end(State& d) const {
        const Scalar part = q(d, last_) / speed();
        for (std::size_t k = 0; k < last_; ++k) {
            q(d, k) -= part * q(motion_, k);
            p(d, k) -= part * p(motion_, k);
        }
        q(d, last_) = p(d, last_) = 0;
    }

    /// Makes of the derivative of a function by (q, p), at the time of x, the covector that steps
    /// are to pull back from x: the transpose of end().
    void pull_back_end(State& lambda) const {
        Scalar along = 0;
        for (std::size_t k = 0; k < last_; ++k) {
            along += q(motion_, k) * q(lambda, k) + p(motion_, k) * p(lambda, k);
        }
        q(lambda, last_) = -along / speed();
        p(lambda, last_) = 0;
    }

    /// Makes of a covector that steps have pulled back to x the derivative of a function by (q, p):
    /// the transpose of begin().
    void pull_back_begin(State& lambda) const {
        const Scalar part = p(lambda, last_) / speed();
        for (std::size_t k = 0; k < last_; ++k) {
            q(lambda, k) += part * p(motion_, k);
            p(lambda, k) -= part * q(motion_, k);
        }
        q(lambda, last_) = p(lambda, last_) = 0;
    }

private:
    template <class Any>
    [[nodiscard]] static auto& q(Any& x, std::size_t k) {
        return detail::at(x.q, k);
    }
    template <class Any>
    [[nodiscard]] static auto& p(Any& x, std::size_t k) {
        return detail::at(x.p, k);
    }

    /// How fast the time goes: dt/ds.
    [[nodiscard]] Scalar speed() const { return q(motion_, last_); }

    State motion_;
    std::size_t last_;  ///< the number of the time, and of its momentum
};

}  // namespace hvi
