// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method stormer-verlet kepler --name VerletKepler
// SPDX-License-Identifier: MIT
//
// stormer-verlet: symplectic, 2 stages, for separable Hamiltonians.
// Basis functions of tau: 1, cos(pi*tau).
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1
//     b_1 = 1/2
//     b_2 = 1/2
//     a_1,1 = 0
//     a_1,2 = 0
//     a_2,1 = 1/2
//     a_2,2 = 1/2
//     a~_1,1 = 1/2
//     a~_1,2 = 0
//     a~_2,1 = 1/2
//     a~_2,2 = 0
//
// Found in H:
//
//     H = T(p) + U(q), and T is quadratic with a constant matrix
//     6 of 16 second derivatives are not zero, 2 constant
//
// Cost:
//
//     no unknowns: nothing is solved for
//     dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root
//     dH/dp once: nothing to compute
//     evaluations in a step: 1 of dH/dq, 1 of dH/dp
//
// Choices:
//
//     P_1 = P_2 is evaluated once: these stages are equal
//     Q_1 is not solved for: it is q at the start of the step
//     Q_2 takes no sum of its own: it is q at the end of the step
//     no solver: no stage depends on itself: the step is kicks and drifts in turn
//     no compensated summation: the error of the step is far above round-off
//     one force a step is not evaluated: the last one of a step is the first one of the next
#pragma once

#include <array>
#include <cmath>
#include <utility>

// The state that a stepper advances, and what a step says about itself.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone, because generated headers without a solver carry a copy
// of this file. The guard, not `#pragma once`, lets the copy and the file meet in either order.
#ifndef HVI_STATE_HPP
#define HVI_STATE_HPP

namespace hvi {

/// Positions q and momenta p, of the same dimension.
template <class Vector>
struct State {
    Vector q{};
    Vector p{};
};

/// Result of a step. Unless it is ok, the state has kept its bits.
class [[nodiscard]] Status {
public:
    enum class Code {
        ok,
        not_converged,        ///< the stage equations have no solution nearby: try a smaller h
        not_finite,           ///< h, the state or a derivative of H is infinite or not a number
        singular,             ///< the linear system of Newton's method is singular at this h
        dimension_mismatch,   ///< q and p differ in dimension
        unsafe_arithmetic,    ///< compiled with -ffast-math or the like
        pole,                 ///< the method does not exist at this parameter, or very near it
        zero_weight,          ///< a weight is zero at this parameter, or very near it
        parameter_too_large,  ///< the coefficients are not computed so far out
        not_a_rotation,       ///< a matrix of the state is no rotation
        outside_chart,        ///< a body turns by 2 pi or more in the step: try a smaller h
    };

    constexpr Status() = default;
    constexpr explicit Status(Code what, int sweeps = 0) : iterations(sweeps), code_(what) {}

    [[nodiscard]] constexpr bool ok() const { return code_ == Code::ok; }
    [[nodiscard]] constexpr Code code() const { return code_; }

    /// Returns one line without a full stop, for people.
    [[nodiscard]] constexpr const char* message() const {
        switch (code_) {
        case Code::ok: return "ok";
        case Code::not_converged: return "the stage equations did not converge: try a smaller step";
        case Code::not_finite: return "the step met a value that is infinite or not a number";
        case Code::singular: return "the stage equations are singular at this step size";
        case Code::dimension_mismatch: return "q and p differ in dimension";
        case Code::unsafe_arithmetic:
            return "compiled with reordered floating-point sums (-ffast-math)";
        case Code::pole: return "there is no method at, or very near, this value of the parameter";
        case Code::zero_weight:
            return "a weight of the method is zero at, or very near, this value of the parameter";
        case Code::parameter_too_large: return "the parameter of the method is too large";
        case Code::not_a_rotation: return "a matrix of the state is not a rotation";
        case Code::outside_chart:
            return "a body turns by a whole turn or more in a step: try a smaller step";
        }
        return "unknown status";
    }

    int iterations = 0;  ///< of the solver, over all coupled stages; 0 where none is needed

private:
    Code code_ = Code::ok;
};

}  // namespace hvi

#endif  // HVI_STATE_HPP

// The numbers that a stepper computes in: float, double, long double, or __float128.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp. Under -std=c++17 the standard library
// knows nothing of __float128: what is needed stands here and in arithmetic.hpp, without
// libquadmath.
#ifndef HVI_SCALAR_HPP
#define HVI_SCALAR_HPP

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace hvi::detail {

/// Type of the numbers in a vector of std::array, Eigen or a user. It is the type that operator[]
/// refers to, unless a specialisation names another one.
template <class Vector>
struct HeldBy {
    using type = std::remove_reference_t<decltype(std::declval<Vector&>()[0])>;
};
template <class Vector>
using ScalarOf = typename HeldBy<Vector>::type;

/// Whether the standard library computes with it.
template <class Scalar>
inline constexpr bool is_standard =
    std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double> ||
    std::is_same_v<Scalar, long double>;

/// Returns the bits of the mantissa, the leading one included. They name the format, which the type
/// does not: long double has 53, 64 or 113 bits or is a pair of doubles, depending on the machine.
template <class Scalar>
[[nodiscard]] constexpr int count_bits() {
    if constexpr (std::numeric_limits<Scalar>::is_specialized) {
        return std::numeric_limits<Scalar>::digits;
    } else {
        int count = 0;
        for (Scalar power = 1; (power + Scalar(1)) - power == Scalar(1); power += power) {
            ++count;
        }
        return count;
    }
}

template <class Scalar>
inline constexpr int bits = count_bits<Scalar>();

/// Whether a type may be a number. A class is one by a specialisation, with one of `bits`.
template <class Scalar>
inline constexpr bool is_number = !std::is_class_v<Scalar>;

/// Returns whether there are coefficients for a type: a floating-point number of 24, 53, 64 or 113
/// bits.
template <class Scalar>
[[nodiscard]] constexpr bool is_supported() {
    if constexpr (!is_number<Scalar> || std::is_const_v<Scalar> ||
                  std::numeric_limits<Scalar>::is_integer) {
        return false;
    } else {
        return bits<Scalar> == 24 || bits<Scalar> == 53 || bits<Scalar> == 64 ||
               bits<Scalar> == 113;
    }
}

template <class Scalar>
[[nodiscard]] constexpr bool is_finite(Scalar x) {
    if constexpr (is_standard<Scalar>) {
        return std::isfinite(x);
    } else {
        return x - x == 0;
    }
}

}  // namespace hvi::detail

#endif  // HVI_SCALAR_HPP

// One real number in each format.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_ROUNDED_HPP
#define HVI_ROUNDED_HPP

namespace hvi::detail {

/// Returns the number of 24 bits, `single`, of 53 bits, `hi`, of 64 bits, hi + to_64, or of 113
/// bits, hi + (to_113 + rest). hvi-gen rounds each of them from the exact value, and writes them so
/// that these sums are exact. NOTE: literals of long double would be rounded once more where long
/// double is another format, and -std=c++17 refuses those of __float128.
template <class Scalar>
[[nodiscard]] constexpr Scalar
rounded([[maybe_unused]] float single, [[maybe_unused]] double hi, [[maybe_unused]] double to_64,
        [[maybe_unused]] double to_113, [[maybe_unused]] double rest) {
    static_assert(is_supported<Scalar>());
    if constexpr (bits<Scalar> == 24) {
        return static_cast<Scalar>(single);
    } else if constexpr (bits<Scalar> == 53) {
        return static_cast<Scalar>(hi);
    } else if constexpr (bits<Scalar> == 64) {
        return static_cast<Scalar>(hi) + static_cast<Scalar>(to_64);
    } else {
        return static_cast<Scalar>(hi) + (static_cast<Scalar>(to_113) + static_cast<Scalar>(rest));
    }
}

}  // namespace hvi::detail

#endif  // HVI_ROUNDED_HPP

// Requirements of steppers on a user's class and on its vectors.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_SYSTEM_HPP
#define HVI_SYSTEM_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace hvi::detail {

/// Index type of a vector: std::size_t for std::array, a signed one for Eigen.
template <class Vector>
using IndexOf = std::decay_t<decltype(std::declval<const Vector&>().size())>;

template <class Vector, class = void>
struct HasTupleSize : std::false_type {};
template <class Vector>
struct HasTupleSize<Vector, std::void_t<decltype(std::tuple_size<Vector>::value)>>
    : std::true_type {};

template <class Vector, class = void>
struct HasSizeOfEigen : std::false_type {};
template <class Vector>
struct HasSizeOfEigen<Vector, std::void_t<decltype(Vector::SizeAtCompileTime)>> : std::true_type {};

/// Returns the dimension that is part of the type of a vector, of std::array or of Eigen; else 0.
template <class Vector>
[[nodiscard]] constexpr std::size_t fixed_size() {
    if constexpr (HasTupleSize<Vector>::value) {
        return std::tuple_size<Vector>::value;
    } else if constexpr (HasSizeOfEigen<Vector>::value) {
        constexpr auto size = static_cast<long>(Vector::SizeAtCompileTime);
        return size > 0 ? static_cast<std::size_t>(size) : 0;
    } else {
        return 0;
    }
}

/// Returns whether a vector always holds n numbers of the type Number.
template <class Vector, class Number, std::size_t n>
[[nodiscard]] constexpr bool is_fixed_vector() {
    return std::is_same_v<ScalarOf<Vector>, Number> && fixed_size<Vector>() == n;
}

template <class System, class = void>
struct HasVector : std::false_type {};
template <class System>
struct HasVector<System, std::void_t<typename System::Vector>> : std::true_type {};

template <class Vector, class = void>
struct IsVector : std::false_type {};
template <class Vector>
struct IsVector<Vector, std::void_t<decltype(std::declval<Vector&>()[0]), IndexOf<Vector>>>
    : std::is_lvalue_reference<decltype(std::declval<Vector&>()[0])> {};

template <class Vector, class = void>
struct HasResize : std::false_type {};
template <class Vector>
struct HasResize<Vector, std::void_t<decltype(std::declval<Vector&>().resize(1))>>
    : std::true_type {};

template <class System, class Vector, class = void>
struct HasGradients : std::false_type {};
template <class System, class Vector>
struct HasGradients<System, Vector,
                    std::void_t<decltype(std::declval<const System&>().dHdq(
                                    std::declval<const Vector&>(), std::declval<const Vector&>(),
                                    std::declval<Vector&>())),
                                decltype(std::declval<const System&>().dHdp(
                                    std::declval<const Vector&>(), std::declval<const Vector&>(),
                                    std::declval<Vector&>()))>> : std::true_type {};

template <class System, class Vector, class = void>
struct HasSeparableGradients : std::false_type {};
template <class System, class Vector>
struct HasSeparableGradients<
    System, Vector,
    std::void_t<decltype(std::declval<const System&>().dHdq(std::declval<const Vector&>(),
                                                            std::declval<Vector&>())),
                decltype(std::declval<const System&>().dHdp(
                    std::declval<const Vector&>(), std::declval<Vector&>()))>> : std::true_type {};

/// Fails to compile with a message about what a class lacks to be a Hamiltonian system.
template <class System, bool separable>
constexpr bool check_system() {
    static_assert(HasVector<System>::value,
                  "hvi: the system must name its vectors: using Vector = std::array<double, n>;");
    using Vector = typename System::Vector;
    static_assert(IsVector<Vector>::value,
                  "hvi: Vector must hold numbers, with operator[] and size(): "
                  "std::array<double, n> or a vector of Eigen");
    static_assert(is_supported<ScalarOf<Vector>>(),
                  "hvi: Vector must hold float, double, long double or __float128, with a mantissa "
                  "of 24, 53, 64 or 113 bits: there are no coefficients for other numbers");
    if constexpr (separable) {
        static_assert(HasSeparableGradients<System, Vector>::value,
                      "hvi: for H = T(p) + U(q) the system must offer const members "
                      "dHdq(const Vector& q, Vector& out) and dHdp(const Vector& p, Vector& out)");
    } else {
        static_assert(HasGradients<System, Vector>::value,
                      "hvi: the system must offer const members dHdq and dHdp, each "
                      "(const Vector& q, const Vector& p, Vector& out)");
    }
    return true;
}

/// Returns component k of a vector with any index type.
template <class Vector>
[[nodiscard]] constexpr decltype(auto) at(Vector& v, std::size_t k) {
    return v[static_cast<IndexOf<std::decay_t<Vector>>>(k)];
}

/// Gives v the dimension n, and fills it with zeros where that is new. Allocates only then, and
/// only where the dimension is dynamic.
template <class Vector>
constexpr void fit(Vector& v, IndexOf<Vector> n) {
    if constexpr (HasResize<Vector>::value) {
        if (v.size() == n) { return; }
        v.resize(n);
        for (IndexOf<Vector> k = 0; k < n; ++k) { v[k] = 0; }
    }
}

/// Returns a vector to compute in: a new one, which lives in registers, where the dimension is part
/// of the type; otherwise the caller's `own`, so that nothing is allocated.
template <class Vector>
[[nodiscard]] constexpr std::conditional_t<HasResize<Vector>::value, Vector&, Vector>
scratch(Vector& own) {
    if constexpr (HasResize<Vector>::value) {
        return own;
    } else {
        return {};
    }
}

/// Returns whether the compiler evaluates this; false where it does not tell.
[[nodiscard]] constexpr bool is_constant_evaluated() {
#ifdef __has_builtin
#if __has_builtin(__builtin_is_constant_evaluated)
    return __builtin_is_constant_evaluated();
#endif
#endif
    return false;
}

/// Returns same_bits() of two numbers in a constant expression, where bits cannot be compared.
template <class Scalar>
[[nodiscard]] constexpr bool same_constant(Scalar x, Scalar y) {
#ifdef __has_builtin
#if __has_builtin(__builtin_copysign)
    // NOTE: only the sign of 0, as other numbers may be beyond the range of double.
    if constexpr (!std::is_class_v<Scalar>) {
        return x == y && (x != 0 || __builtin_copysign(1.0, static_cast<double>(x)) ==
                                        __builtin_copysign(1.0, static_cast<double>(y)));
    }
#endif
#endif
    return x == y;
}

/// Returns whether a and b agree bit for bit, -0.0 and 0.0 being different.
template <class Vector>
[[nodiscard]] constexpr bool same_bits(const Vector& a, const Vector& b) {
    if (a.size() != b.size()) { return false; }
    using Scalar = ScalarOf<Vector>;
    if (is_constant_evaluated()) {
        bool same = true;
        for (IndexOf<Vector> k = 0; k < a.size(); ++k) {
            same = same && same_constant<Scalar>(a[k], b[k]);
        }
        return same;
    }
    // NOTE: in the 64-bit format ten bytes are the number, the others are padding.
    constexpr std::size_t bytes = bits<Scalar> == 64 ? 10 : sizeof(Scalar);
    constexpr std::size_t words = (bytes + 7) / 8;
    std::uint64_t difference = 0;
    for (IndexOf<Vector> k = 0; k < a.size(); ++k) {
        // NOTE: copies, since g++ keeps the vectors that are copied here in registers of integers,
        // and the next step would wait for them to come back.
        const Scalar x = a[k];
        const Scalar y = b[k];
        std::uint64_t left[words] = {};
        std::uint64_t right[words] = {};
        std::memcpy(left, &x, bytes);
        std::memcpy(right, &y, bytes);
        for (std::size_t i = 0; i < words; ++i) { difference |= left[i] ^ right[i]; }
    }
    return difference == 0;
}

/// Returns 0 where all components are finite, else NaN.
template <class Vector>
[[nodiscard]] constexpr ScalarOf<Vector> zero_if_finite(const Vector& v) {
    // NOTE: x - x is 0, or NaN where x is infinite or NaN. Two sums, since each waits for itself
    // alone.
    ScalarOf<Vector> even = 0;
    ScalarOf<Vector> odd = 0;
    IndexOf<Vector> k = 0;
    for (; k + 1 < v.size(); k += 2) {
        even += v[k] - v[k];
        odd += v[k + 1] - v[k + 1];
    }
    if (k < v.size()) { even += v[k] - v[k]; }
    return even + odd;
}

/// Returns whether all components of both are finite. One test of a sum is cheaper than one of
/// each.
template <class Vector>
[[nodiscard]] constexpr bool finite(const Vector& q, const Vector& p) {
    return zero_if_finite(q) + zero_if_finite(p) >= 0;
}

/// Sets to = from; both have one dimension.
template <class Vector>
constexpr void copy(const Vector& from, Vector& to) {
    // NOTE: four at a time. For an assignment, or a loop over single components, g++ calls memcpy
    // where there are many components. The next step then waits: it loads values that were stored
    // in two parts.
    IndexOf<Vector> k = 0;
    for (; k + 3 < from.size(); k += 4) {
        to[k] = from[k];
        to[k + 1] = from[k + 1];
        to[k + 2] = from[k + 2];
        to[k + 3] = from[k + 3];
    }
    for (; k < from.size(); ++k) { to[k] = from[k]; }
}

}  // namespace hvi::detail

#endif  // HVI_SYSTEM_HPP

namespace hvi::generated {

/// The scene kepler with stormer-verlet, computed in Number: float, double or long double. States
/// hold Numbers: arrays, or vectors of Eigen of fixed size.
/// A planet around a fixed sun, on an ellipse
template <class Number, class Numbers = std::array<Number, 2>>
class BasicVerletKepler {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 2>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
        Scalar mu = Scalar(1.0);  // mu = 1
        Scalar ecc = hvi::detail::rounded<Scalar>(0.6f, 0.6, 0x1.9ap-56, 0x1.9999999999999p-56,
            0x1.3p-109);  // ecc = 3/5
    };

    /// H = (px^2+py^2)/2-mu/sqrt(x^2+y^2), where q is (x, y) and p is (px, py).
    struct System {
        using Vector = Numbers;

        constexpr explicit System(const Parameters& parameters) {
            c1_ = parameters.mu;
        }

        constexpr void dHdq(const Vector& q, Vector& out) const {
            const Scalar t1 = q[0] * q[0] + q[1] * q[1];
            const Scalar t2 = c1_ / (t1 * std::sqrt(t1));
            out[0] = q[0] * t2;
            out[1] = q[1] * t2;
        }

        constexpr void dHdp(const Vector& p, Vector& out) const {
            out[0] = p[0];
            out[1] = p[1];
        }

        static constexpr void begin(const Parameters& parameters, Vector& q, Vector& p) {
            const Scalar t1 = Scalar(1.0) - parameters.ecc;
            const Scalar t2 = std::sqrt(parameters.mu * (Scalar(1.0) + parameters.ecc) / t1);
            q[0] = t1;
            q[1] = Scalar(0.0);
            p[0] = Scalar(0.0);
            p[1] = t2;
        }

        Scalar c1_ = 0;
    };

    using State = hvi::State<Vector>;

    constexpr BasicVerletKepler() : BasicVerletKepler(Parameters{}) {}
    constexpr explicit BasicVerletKepler(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static constexpr State initial(const Parameters& parameters) {
        State x;
        System::begin(parameters, x.q, x.p);
        return x;
    }
    [[nodiscard]] static constexpr State initial() { return initial(Parameters{}); }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] constexpr Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        if (!hvi::detail::is_finite(h)) { return Status(Status::Code::not_finite); }
        const Index n = x.q.size();
        if (x.p.size() != n) { return Status(Status::Code::dimension_mismatch); }
        hvi::detail::fit(p_, n);
        hvi::detail::fit(slope_, n);
        hvi::detail::fit(end_, n);
        hvi::detail::fit(force_, n);

        auto&& p = hvi::detail::scratch(p_);
        auto&& slope = hvi::detail::scratch(slope_);
        auto&& end = hvi::detail::scratch(end_);
        const bool kept = known_ && hvi::detail::same_bits(q_, x.q);
        known_ = false;
        if (!kept) {
            hvi::detail::fit(q_, n);
            system_.dHdq(x.q, force_);
        }
        for (Index k = 0; k < n; ++k) {
            p[k] = x.p[k] - h * b_p[0] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q_[k] = x.q[k] + h * slope[k];
        }
        system_.dHdq(q_, force_);
        for (Index k = 0; k < n; ++k) {
            end[k] = p[k] - h * b_p[1] * force_[k];
        }

        if (!hvi::detail::finite(q_, end)) { return Status(Status::Code::not_finite); }
        known_ = true;
        hvi::detail::copy(q_, x.q);
        for (Index k = 0; k < n; ++k) {
            x.p[k] = p[k] - h * b_p[1] * force_[k];
        }
        return {};
    }

    /// Forgets what the last step left.
    constexpr void reset() { known_ = false; }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    static constexpr Scalar b_p[2] = {
        Scalar(0.5),  // b_1 = 1/2
        Scalar(0.5),  // b_2 = 1/2
    };

    System system_;
    Vector q_{}, p_{}, slope_{}, end_{};
    Vector force_{};  // dH/dq where the last step ended, at q_
    bool known_ = false;  // whether it is kept
};

using VerletKepler = BasicVerletKepler<double>;

}  // namespace hvi::generated
