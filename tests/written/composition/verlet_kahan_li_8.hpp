// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method stormer-verlet --separable --compose kahan-li:8 --name VerletKahanLi8
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
// Choices:
//
//     17 steps in a row: they make a method of order 8: kahan-li:8
//     Q_2 = Q_3 is evaluated once: these stages are equal
//     Q_4 = Q_5 is evaluated once: these stages are equal
//     Q_6 = Q_7 is evaluated once: these stages are equal
//     Q_8 = Q_9 is evaluated once: these stages are equal
//     Q_10 = Q_11 is evaluated once: these stages are equal
//     Q_12 = Q_13 is evaluated once: these stages are equal
//     Q_14 = Q_15 is evaluated once: these stages are equal
//     Q_16 = Q_17 is evaluated once: these stages are equal
//     Q_18 = Q_19 is evaluated once: these stages are equal
//     Q_20 = Q_21 is evaluated once: these stages are equal
//     Q_22 = Q_23 is evaluated once: these stages are equal
//     Q_24 = Q_25 is evaluated once: these stages are equal
//     Q_26 = Q_27 is evaluated once: these stages are equal
//     Q_28 = Q_29 is evaluated once: these stages are equal
//     Q_30 = Q_31 is evaluated once: these stages are equal
//     Q_32 = Q_33 is evaluated once: these stages are equal
//     P_1 = P_2 is evaluated once: these stages are equal
//     P_3 = P_4 is evaluated once: these stages are equal
//     P_5 = P_6 is evaluated once: these stages are equal
//     P_7 = P_8 is evaluated once: these stages are equal
//     P_9 = P_10 is evaluated once: these stages are equal
//     P_11 = P_12 is evaluated once: these stages are equal
//     P_13 = P_14 is evaluated once: these stages are equal
//     P_15 = P_16 is evaluated once: these stages are equal
//     P_17 = P_18 is evaluated once: these stages are equal
//     P_19 = P_20 is evaluated once: these stages are equal
//     P_21 = P_22 is evaluated once: these stages are equal
//     P_23 = P_24 is evaluated once: these stages are equal
//     P_25 = P_26 is evaluated once: these stages are equal
//     P_27 = P_28 is evaluated once: these stages are equal
//     P_29 = P_30 is evaluated once: these stages are equal
//     P_31 = P_32 is evaluated once: these stages are equal
//     P_33 = P_34 is evaluated once: these stages are equal
//     Q_1 is not solved for: it is q at the start of the step
//     Q_34 takes no sum of its own: it is q at the end of the step
//     no solver: no stage depends on itself: the step is kicks and drifts in turn
//     compensated summation: errors of order 8 come down to round-off
//     one force a step is not evaluated: the last one of a step is the first one of the next
#pragma once

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

/// What became of a step. Unless it is ok, the state has kept its bits.
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
        not_a_rotation,       ///< a matrix of the state is none
        outside_chart,        ///< a body turns by 2 pi or more in the step: try a smaller h
    };

    constexpr Status() = default;
    constexpr explicit Status(Code what, int sweeps = 0) : iterations(sweeps), code_(what) {}

    [[nodiscard]] constexpr bool ok() const { return code_ == Code::ok; }
    [[nodiscard]] constexpr Code code() const { return code_; }

    /// One line without a full stop, for people.
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
// NOTE: needs the standard library alone; see state.hpp. Of __float128 the standard library knows
// nothing under -std=c++17: what is needed stands here and in arithmetic.hpp, without libquadmath.
#ifndef HVI_SCALAR_HPP
#define HVI_SCALAR_HPP

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace hvi::detail {

/// What a vector holds, std::array's or Eigen's or a user's own: what its operator[] refers to, or
/// what it says itself by a specialisation.
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

/// The bits of the mantissa, the leading one included. They name the format, not the type does:
/// long double is one of 53, 64, 113 bits or a pair of doubles, as the machine has it.
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

/// Whether it may be a number: a class says so, and what its `bits` are, by specialisations.
template <class Scalar>
inline constexpr bool is_number = !std::is_class_v<Scalar>;

/// Whether there are coefficients for it: a floating-point number of 24, 53, 64 or 113 bits.
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

/// The number of 24 bits is `single`, of 53 bits `hi`, of 64 bits hi + to_64, and of 113 bits
/// hi + (to_113 + rest). hvi-gen rounds each of them from the exact value, and then writes them so
/// that these sums are exact. NOTE: no literals of long double, which a compiler rounds once more
/// where long double is something else, and none of __float128, which -std=c++17 refuses.
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

// What a stepper asks of a user's class and of its vectors.
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

/// The type in which a vector counts: std::size_t of std::array, a signed one of Eigen.
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

/// The dimension that is part of the type of a vector, of std::array or of Eigen; else 0.
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

/// Whether a vector holds n of these numbers, whatever happens.
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

/// Says in words what a class lacks that is to be a Hamiltonian system.
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

/// Component k of a vector that counts in whatever type.
template <class Vector>
[[nodiscard]] constexpr decltype(auto) at(Vector& v, std::size_t k) {
    return v[static_cast<IndexOf<std::decay_t<Vector>>>(k)];
}

/// Gives v the dimension n, filled with zeros where that is new. Allocates only then, and only
/// where the dimension is dynamic.
template <class Vector>
constexpr void fit(Vector& v, IndexOf<Vector> n) {
    if constexpr (HasResize<Vector>::value) {
        if (v.size() == n) { return; }
        v.resize(n);
        for (IndexOf<Vector> k = 0; k < n; ++k) { v[k] = 0; }
    }
}

/// A vector to compute in: a new one, which lives in registers, where the dimension is part of the
/// type; the caller's `own` where it is not, so that nothing is allocated.
template <class Vector>
[[nodiscard]] constexpr std::conditional_t<HasResize<Vector>::value, Vector&, Vector>
scratch(Vector& own) {
    if constexpr (HasResize<Vector>::value) {
        return own;
    } else {
        return {};
    }
}

/// Whether the compiler computes this; false where it does not tell.
[[nodiscard]] constexpr bool is_constant_evaluated() {
#ifdef __has_builtin
#if __has_builtin(__builtin_is_constant_evaluated)
    return __builtin_is_constant_evaluated();
#endif
#endif
    return false;
}

/// What same_bits() says of two numbers that a compiler computes, which has no bits to compare.
template <class Scalar>
[[nodiscard]] constexpr bool same_constant(Scalar x, Scalar y) {
#ifdef __has_builtin
#if __has_builtin(__builtin_copysign)
    // NOTE: the sign of 0 alone, as others may be beyond the range of double.
    if constexpr (!std::is_class_v<Scalar>) {
        return x == y && (x != 0 || __builtin_copysign(1.0, static_cast<double>(x)) ==
                                        __builtin_copysign(1.0, static_cast<double>(y)));
    }
#endif
#endif
    return x == y;
}

/// Whether a and b agree bit for bit, -0.0 and 0.0 being different.
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
    // NOTE: of the 64-bit format ten bytes are the number, the others are padding.
    constexpr std::size_t bytes = bits<Scalar> == 64 ? 10 : sizeof(Scalar);
    constexpr std::size_t words = (bytes + 7) / 8;
    std::uint64_t difference = 0;
    for (IndexOf<Vector> k = 0; k < a.size(); ++k) {
        // NOTE: of copies, since g++ keeps what is copied here in registers of integers, and the
        // next step would wait for it to come back.
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

/// 0 where all components are finite, else no number.
template <class Vector>
[[nodiscard]] constexpr ScalarOf<Vector> zero_if_finite(const Vector& v) {
    // NOTE: x - x is 0, or no number where x is infinite or none. Two sums, since each waits for
    // itself alone.
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

/// Whether all components of both are finite. One test of a sum is cheaper than one of each.
template <class Vector>
[[nodiscard]] constexpr bool finite(const Vector& q, const Vector& p) {
    return zero_if_finite(q) + zero_if_finite(p) >= 0;
}

/// to = from, which are of one dimension.
template <class Vector>
constexpr void copy(const Vector& from, Vector& to) {
    // NOTE: four at a time. Of an assignment, or a loop over single components, g++ makes a call of
    // memcpy where there are many, and the next step waits: what it loads was stored in two parts.
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

// What solvers compute of the numbers of scalar.hpp.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_ARITHMETIC_HPP
#define HVI_ARITHMETIC_HPP

#include <cmath>
#include <limits>

namespace hvi::detail {

/// 2^exponent, for exponents that are not positive.
template <class Scalar>
[[nodiscard]] constexpr Scalar power_of_two(int exponent) {
    Scalar power = 1;
    for (; exponent < 0; ++exponent) { power /= 2; }
    return power;
}

/// The distance from 1 to the next number.
template <class Scalar>
inline constexpr Scalar epsilon = power_of_two<Scalar>(1 - bits<Scalar>);

template <class Scalar>
inline constexpr auto infinity = static_cast<Scalar>(std::numeric_limits<float>::infinity());

template <class Scalar>
[[nodiscard]] inline Scalar abs(Scalar x) {
    if constexpr (is_standard<Scalar>) {
        return std::abs(x);
    } else {
        return x < 0 ? -x : x;
    }
}

/// The larger one, or the other one of a NaN.
template <class Scalar>
[[nodiscard]] inline Scalar larger(Scalar a, Scalar b) {
    if constexpr (is_standard<Scalar>) {
        // NOTE: not a comparison, with which g++ 12 lays out the loops around it so that a step of
        // gauss:2 takes a tenth longer.
        return std::fmax(a, b);
    } else {
        return a < b || a != a ? b : a;
    }
}

}  // namespace hvi::detail

#endif  // HVI_ARITHMETIC_HPP

// Compensated summation: sums that keep what rounding cuts off.
// SPDX-License-Identifier: MIT
#ifndef HVI_COMPENSATED_HPP
#define HVI_COMPENSATED_HPP

#include <cfloat>

// clang says nothing of -fassociative-math alone; sums_are_exact() finds that out at run time.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "hvi: -ffast-math and -fassociative-math destroy compensated summation: compile without"
#endif
#if FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD < 0
#error "hvi: needs arithmetic that rounds to its own type after each operation: -mfpmath=sse"
#endif

namespace hvi {

/// A sum and what rounding cut off from it.
template <class Scalar>
struct Sum {
    Scalar value;
    Scalar remainder;
};

/// a + b == value + remainder exactly, whatever the magnitudes (Knuth's TwoSum, free of branches).
/// Precondition: no overflow.
template <class Scalar>
[[nodiscard]] constexpr Sum<Scalar> two_sum(Scalar a, Scalar b) {
    const Scalar value = a + b;
    const Scalar b_part = value - a;
    const Scalar a_part = value - b_part;
    return {value, (a - a_part) + (b - b_part)};
}

namespace detail {

/// Whether two_sum() is what it says, or was compiled with reordered sums, or for a processor that
/// is told to round otherwise.
template <class Scalar>
[[nodiscard]] bool sums_are_exact() {
    constexpr Scalar tiny = power_of_two<Scalar>(-bits<Scalar> - 7);
    const volatile Scalar large = 1;
    const volatile Scalar small = tiny;
    const Sum<Scalar> sum = two_sum<Scalar>(large, small);
    return sum.value == 1 && sum.remainder == tiny;
}

}  // namespace detail
}  // namespace hvi

#endif  // HVI_COMPENSATED_HPP

// The sums of a step that solves nothing.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_STEP_SUMS_HPP
#define HVI_STEP_SUMS_HPP

namespace hvi::detail {

/// Where the last step ended, and the remainder (e_q, e_p) that rounding cut off from it. The
/// increments of a step are summed apart, beginning with it, and the state takes one exact sum a
/// step. Its stages, where slopes are evaluated, are plain sums beside them.
///
/// NOTE: all this changes in end() alone, so that a step that failed can be tried again.
template <class Vector>
class StepSums {
public:
    /// Begins a step from x: change = (e_q, e_p), or 0 unless x is, bit for bit, where the last
    /// step ended. False where sums do not round as they should.
    [[nodiscard]] constexpr bool begin(const State<Vector>& x, Vector& change_q, Vector& change_p) {
        continues_ = ended_ && same_bits(at_.q, x.q) && same_bits(at_.p, x.p);
        for (Index k = 0; k < x.q.size(); ++k) {
            change_q[k] = continues_ ? remainder_.q[k] : Scalar(0);
            change_p[k] = continues_ ? remainder_.p[k] : Scalar(0);
        }
        return continues_ || is_constant_evaluated() || sums_are_exact<Scalar>();
    }

    /// Whether the step under way began where the last one ended.
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

    /// The sum of both, exactly: of `change` there remains what rounding cuts off.
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

// The weights of one step.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_WEIGHTS_HPP
#define HVI_WEIGHTS_HPP

#include <array>
#include <cstddef>

namespace hvi::detail {

/// NOTE: not abs(), which calls the standard library: steps of kicks and drifts may be constant
/// expressions.
template <class Scalar>
[[nodiscard]] constexpr Scalar magnitude(Scalar x) {
    return x < 0 ? -x : x;
}

/// Whether b_i = b_{n+1-i}.
template <class Scalar, std::size_t n>
[[nodiscard]] constexpr bool is_symmetric(const Scalar (&b)[n]) {
    for (std::size_t i = 0; i < n; ++i) {
        if (b[i] != b[n - 1 - i]) { return false; }
    }
    return true;
}

/// Whether the sum is 1 as far as rounded weights tell: that of an inconsistent method is not.
template <class Scalar, std::size_t n>
[[nodiscard]] constexpr bool sums_to_one(const Scalar (&b)[n]) {
    Scalar excess = -1;
    Scalar size = 1;
    for (const Scalar weight : b) {
        excess += weight;
        size += magnitude(weight);
    }
    const Scalar most = static_cast<Scalar>(n) * size * epsilon<Scalar>;
    return -most <= excess && excess <= most;
}

template <class Scalar, std::size_t n>
[[nodiscard]] constexpr std::size_t largest_of(const Scalar (&b)[n], std::size_t end) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < end; ++i) {
        if (b[i] > b[largest]) { largest = i; }
    }
    return largest;
}

/// h b_i, rounded to multiples of ulp(h), and so that they add up to h without rounding (where no
/// b_i is negative) and keep the symmetry of b.
///
/// NOTE: products that are rounded one by one add up to h (1 + delta) with the same delta in every
/// step, by which time runs fast or slow: over 10^6 steps of the oscillator the phase of gauss:4 is
/// off by 1e-11 with them and by 1e-14 with these. The low parts of the products, added to the
/// remainders of the sums, mend the time, but then what a step adds is not what its stages were
/// computed with, and the energy drifts. The method is symplectic with any weights.
template <class Scalar, std::size_t n>
[[nodiscard]] constexpr std::array<Scalar, n> weights_of_step(Scalar h, const Scalar (&b)[n]) {
    std::array<Scalar, n> weights{};
    const Scalar size = magnitude(h);
    Scalar sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        // NOTE: the sum of this and `size` is a multiple of ulp(h), and so is what is left.
        const Scalar part = (magnitude(size * b[i]) + size) - size;
        weights[i] = (b[i] < 0) == (h < 0) ? part : -part;
        sum += weights[i];
    }
    if (!sums_to_one(b)) { return weights; }
    const Scalar missing = h - sum;
    if (!is_symmetric(b)) {
        weights[largest_of(b, n)] += missing;
    } else if (n % 2 == 1) {
        weights[n / 2] += missing;
    } else {
        const std::size_t i = largest_of(b, n / 2);
        weights[i] += missing / 2;
        weights[n - 1 - i] += missing / 2;
    }
    return weights;
}

/// The weights of a step of kicks and drifts, kept while its size stays.
///
/// NOTE: those of a palindrome repeat. Were they products in the step, g++ would keep each in a
/// register until it comes again, and on few degrees of freedom the state would have to give way.
template <class Scalar, std::size_t kicks, std::size_t drifts>
struct MoveWeights {
    std::array<Scalar, kicks> p{};
    std::array<Scalar, drifts> q{};

    constexpr void weigh(Scalar h, const Scalar (&b_p)[kicks], const Scalar (&b_q)[drifts]) {
        if (h == weighed) { return; }
        p = weights_of_step(h, b_p);
        q = weights_of_step(h, b_q);
        weighed = h;
    }

    Scalar weighed = 0;  ///< the step size of the weights
};

}  // namespace hvi::detail

#endif  // HVI_WEIGHTS_HPP

namespace hvi::generated {

/// For H(q, p) = T(p) + U(q). `System` names its `Vector`, std::array<double, n> or one of Eigen,
/// also of float, long double or __float128, and has const members dHdq(q, out) = grad U and
/// dHdp(p, out) = grad T.
template <class System>
class VerletKahanLi8 {
    static_assert(hvi::detail::check_system<System, true>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    constexpr explicit VerletKahanLi8(System system = System{})
        : system_(std::move(system)) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] constexpr Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        if (!hvi::detail::is_finite(h)) { return Status(Status::Code::not_finite); }
        const Index n = x.q.size();
        if (x.p.size() != n) { return Status(Status::Code::dimension_mismatch); }
        hvi::detail::fit(q_, n);
        hvi::detail::fit(p_, n);
        hvi::detail::fit(dq_, n);
        hvi::detail::fit(dp_, n);
        hvi::detail::fit(slope_, n);
        hvi::detail::fit(force_, n);

        auto&& q = hvi::detail::scratch(q_);
        auto&& p = hvi::detail::scratch(p_);
        auto&& dq = hvi::detail::scratch(dq_);
        auto&& dp = hvi::detail::scratch(dp_);
        auto&& slope = hvi::detail::scratch(slope_);
        if (!sums_.begin(x, dq, dp)) { return Status(Status::Code::unsafe_arithmetic); }
        weights_.weigh(h, b_p, b_q);
        const bool kept = known_ && sums_.continues();
        known_ = false;
        if (!kept) { system_.dHdq(x.q, force_); }
        for (Index k = 0; k < n; ++k) {
            p[k] = x.p[k] - weights_.p[0] * force_[k];
            dp[k] -= weights_.p[0] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = x.q[k] + weights_.q[0] * slope[k];
            dq[k] += weights_.q[0] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[1] * force_[k];
            dp[k] -= weights_.p[1] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[1] * slope[k];
            dq[k] += weights_.q[1] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[2] * force_[k];
            dp[k] -= weights_.p[2] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[2] * slope[k];
            dq[k] += weights_.q[2] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[3] * force_[k];
            dp[k] -= weights_.p[3] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[3] * slope[k];
            dq[k] += weights_.q[3] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[4] * force_[k];
            dp[k] -= weights_.p[4] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[4] * slope[k];
            dq[k] += weights_.q[4] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[5] * force_[k];
            dp[k] -= weights_.p[5] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[5] * slope[k];
            dq[k] += weights_.q[5] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[6] * force_[k];
            dp[k] -= weights_.p[6] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[6] * slope[k];
            dq[k] += weights_.q[6] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[7] * force_[k];
            dp[k] -= weights_.p[7] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[7] * slope[k];
            dq[k] += weights_.q[7] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[8] * force_[k];
            dp[k] -= weights_.p[8] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[8] * slope[k];
            dq[k] += weights_.q[8] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[9] * force_[k];
            dp[k] -= weights_.p[9] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[9] * slope[k];
            dq[k] += weights_.q[9] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[10] * force_[k];
            dp[k] -= weights_.p[10] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[10] * slope[k];
            dq[k] += weights_.q[10] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[11] * force_[k];
            dp[k] -= weights_.p[11] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[11] * slope[k];
            dq[k] += weights_.q[11] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[12] * force_[k];
            dp[k] -= weights_.p[12] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[12] * slope[k];
            dq[k] += weights_.q[12] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[13] * force_[k];
            dp[k] -= weights_.p[13] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[13] * slope[k];
            dq[k] += weights_.q[13] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[14] * force_[k];
            dp[k] -= weights_.p[14] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[14] * slope[k];
            dq[k] += weights_.q[14] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[15] * force_[k];
            dp[k] -= weights_.p[15] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[15] * slope[k];
            dq[k] += weights_.q[15] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            p[k] = p[k] - weights_.p[16] * force_[k];
            dp[k] -= weights_.p[16] * force_[k];
        }
        system_.dHdp(p, slope);
        for (Index k = 0; k < n; ++k) {
            q[k] = q[k] + weights_.q[16] * slope[k];
            dq[k] += weights_.q[16] * slope[k];
        }
        system_.dHdq(q, force_);
        for (Index k = 0; k < n; ++k) {
            dp[k] -= weights_.p[17] * force_[k];
        }

        if (!sums_.end(x, dq, dp, q, p)) { return Status(Status::Code::not_finite); }
        known_ = true;
        return {};
    }

    /// Forgets what the last step left.
    constexpr void reset() { sums_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    // rounded(...) is the number of its comment as float, double, long double or __float128: the
    // one that Scalar is.
    static constexpr auto& rounded = hvi::detail::rounded<Scalar>;

    static constexpr Scalar b_p[18] = {
        // b_1 =
        // 1302024830888900808788176322625491050228175109268241597
        // /20000000000000000000000000000000000000000000000000000000
        rounded(0.06510124f, 0.06510124154444503, 0x1.9cp-58, 0x1.9bc3f8631505cp-58, 0x1.2p-113),
        // b_2+b_3 =
        // 691365464863998465440782039964135370329415165157014047
        // /2000000000000000000000000000000000000000000000000000000
        rounded(0.34568274f, 0.3456827324319992, 0x1.dfp-56, 0x1.df2555dc54939p-56, 0x1p-114),
        // b_4+b_5 =
        // 429220047825652745384714522639113249660204758555190041
        // /5000000000000000000000000000000000000000000000000000000
        rounded(0.08584401f, 0.08584400956513055, -0x1.e5p-59, -0x1.e50ffeb2aecd2p-59, -0x1.ep-113),
        // b_6+b_7 =
        // -1153165280448458427559339265077786008185654640695096843
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.115316525f, -0.11531652804484584, -0x1.b38p-58, -0x1.b3879f5b260b2p-58,
            -0x1.e8p-111),
        // b_8+b_9 =
        // -1185309937890409882200103966959034843896423732324240883
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.118530996f, -0.11853099378904099, -0x1p-59, -0x1.ffd9a8e92b1edp-60, -0x1.2p-113),
        // b_10+b_11 =
        // -105682126577460935122199498816812069906288808065633967
        // /1000000000000000000000000000000000000000000000000000000
        rounded(-0.10568213f, -0.10568212657746094, 0x1.dp-58, 0x1.cfccfaa6bad68p-58, 0x1.c8p-111),
        // b_12+b_13 =
        // 4429140286646377543858116512489979299359540285832584981
        // /20000000000000000000000000000000000000000000000000000000
        rounded(0.22145702f, 0.22145701433231887, 0x1.94p-59, 0x1.94c9484d5f7dcp-59, 0x1.8p-114),
        // b_14+b_15 =
        // 5533861112956323461649453503524052649016150279499122103
        // /20000000000000000000000000000000000000000000000000000000
        rounded(0.27669305f, 0.27669305564781616, 0x1.4bp-56, 0x1.4af93951694fep-56, 0x1.8p-110),
        // b_16+b_17 =
        // -3104968102207242128279548388427446598248903453039494523
        // /20000000000000000000000000000000000000000000000000000000
        rounded(-0.1552484f, -0.15524840511036211, 0x1.24p-57, 0x1.23cb1a83a8883p-57, 0x1.dp-111),
        // b_18+b_19 =
        // -3104968102207242128279548388427446598248903453039494523
        // /20000000000000000000000000000000000000000000000000000000
        rounded(-0.1552484f, -0.15524840511036211, 0x1.24p-57, 0x1.23cb1a83a8883p-57, 0x1.dp-111),
        // b_20+b_21 =
        // 5533861112956323461649453503524052649016150279499122103
        // /20000000000000000000000000000000000000000000000000000000
        rounded(0.27669305f, 0.27669305564781616, 0x1.4bp-56, 0x1.4af93951694fep-56, 0x1.8p-110),
        // b_22+b_23 =
        // 4429140286646377543858116512489979299359540285832584981
        // /20000000000000000000000000000000000000000000000000000000
        rounded(0.22145702f, 0.22145701433231887, 0x1.94p-59, 0x1.94c9484d5f7dcp-59, 0x1.8p-114),
        // b_24+b_25 =
        // -105682126577460935122199498816812069906288808065633967
        // /1000000000000000000000000000000000000000000000000000000
        rounded(-0.10568213f, -0.10568212657746094, 0x1.dp-58, 0x1.cfccfaa6bad68p-58, 0x1.c8p-111),
        // b_26+b_27 =
        // -1185309937890409882200103966959034843896423732324240883
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.118530996f, -0.11853099378904099, -0x1p-59, -0x1.ffd9a8e92b1edp-60, -0x1.2p-113),
        // b_28+b_29 =
        // -1153165280448458427559339265077786008185654640695096843
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.115316525f, -0.11531652804484584, -0x1.b38p-58, -0x1.b3879f5b260b2p-58,
            -0x1.e8p-111),
        // b_30+b_31 =
        // 429220047825652745384714522639113249660204758555190041
        // /5000000000000000000000000000000000000000000000000000000
        rounded(0.08584401f, 0.08584400956513055, -0x1.e5p-59, -0x1.e50ffeb2aecd2p-59, -0x1.ep-113),
        // b_32+b_33 =
        // 691365464863998465440782039964135370329415165157014047
        // /2000000000000000000000000000000000000000000000000000000
        rounded(0.34568274f, 0.3456827324319992, 0x1.dfp-56, 0x1.df2555dc54939p-56, 0x1p-114),
        // b_34 =
        // 1302024830888900808788176322625491050228175109268241597
        // /20000000000000000000000000000000000000000000000000000000
        rounded(0.06510124f, 0.06510124154444503, 0x1.9cp-58, 0x1.9bc3f8631505cp-58, 0x1.2p-113),
    };
    static constexpr Scalar b_q[17] = {
        // b_1+b_2 =
        // 1302024830888900808788176322625491050228175109268241597
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.13020249f, 0.13020248308889007, 0x1.9cp-57, 0x1.9bc3f8631505cp-57, 0x1.2p-112),
        // b_3+b_4 =
        // 5611629817751083845619644077015862653065976542301898873
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.561163f, 0.5611629817751084, 0x1.ep-57, 0x1.e0d15f0e3d487p-57, 0x1.cp-110),
        // b_5+b_6 =
        // -3894749626448472864080785986459409654425157508081138709
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.38947496f, -0.38947496264484727, -0x1.698p-56, -0x1.69acaf33ca578p-56,
            -0x1.28p-109),
        // b_7+b_8 =
        // 1588419065551556008962107456303837638053848226690945023
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.15884191f, 0.1588419065551556, 0x1.2p-57, 0x1.1fd1bf0c6ea3ep-57, 0x1.8p-112),
        // b_9+b_10 =
        // -3959038941332375773362315390221907325846695691339426789
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.3959039f, -0.39590389413323757, -0x1.ap-57, -0x1.9fc82946b96b9p-57, -0x1.3p-110),
        // b_11+b_12 =
        // 1845396409783157070918325413885665927720919530026747449
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.18453965f, 0.1845396409783157, -0x1.21p-58, -0x1.20d5b825177bbp-58, -0x1p-114),
        // b_13+b_14 =
        // 645935969215805118234947774651078342909655188951459383
        // /2500000000000000000000000000000000000000000000000000000
        rounded(0.2583744f, 0.25837438768632204, 0x1.5bp-57, 0x1.5acf80393b7cbp-57, 0x1.4p-110),
        // b_15+b_16 =
        // 2950117236093102988709662404919739277377529523693284571
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.29501173f, 0.2950117236093103, 0x1.e88p-56, 0x1.e88ab28634e16p-56, 0x1.e8p-109),
        // b_17+b_18 =
        // -3027542669150172558494605396673592937813216488366389547
        // /5000000000000000000000000000000000000000000000000000000
        rounded(-0.6055085f, -0.6055085338300346, 0x1.9d8p-55, 0x1.9da033feb9d36p-55, 0x1p-109),
        // b_19+b_20 =
        // 2950117236093102988709662404919739277377529523693284571
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.29501173f, 0.2950117236093103, 0x1.e88p-56, 0x1.e88ab28634e16p-56, 0x1.e8p-109),
        // b_21+b_22 =
        // 645935969215805118234947774651078342909655188951459383
        // /2500000000000000000000000000000000000000000000000000000
        rounded(0.2583744f, 0.25837438768632204, 0x1.5bp-57, 0x1.5acf80393b7cbp-57, 0x1.4p-110),
        // b_23+b_24 =
        // 1845396409783157070918325413885665927720919530026747449
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.18453965f, 0.1845396409783157, -0x1.21p-58, -0x1.20d5b825177bbp-58, -0x1p-114),
        // b_25+b_26 =
        // -3959038941332375773362315390221907325846695691339426789
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.3959039f, -0.39590389413323757, -0x1.ap-57, -0x1.9fc82946b96b9p-57, -0x1.3p-110),
        // b_27+b_28 =
        // 1588419065551556008962107456303837638053848226690945023
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.15884191f, 0.1588419065551556, 0x1.2p-57, 0x1.1fd1bf0c6ea3ep-57, 0x1.8p-112),
        // b_29+b_30 =
        // -3894749626448472864080785986459409654425157508081138709
        // /10000000000000000000000000000000000000000000000000000000
        rounded(-0.38947496f, -0.38947496264484727, -0x1.698p-56, -0x1.69acaf33ca578p-56,
            -0x1.28p-109),
        // b_31+b_32 =
        // 5611629817751083845619644077015862653065976542301898873
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.561163f, 0.5611629817751084, 0x1.ep-57, 0x1.e0d15f0e3d487p-57, 0x1.cp-110),
        // b_33+b_34 =
        // 1302024830888900808788176322625491050228175109268241597
        // /10000000000000000000000000000000000000000000000000000000
        rounded(0.13020249f, 0.13020248308889007, 0x1.9cp-57, 0x1.9bc3f8631505cp-57, 0x1.2p-112),
    };

    System system_;
    hvi::detail::StepSums<Vector> sums_;
    hvi::detail::MoveWeights<Scalar, 18, 17> weights_;
    Vector q_{}, p_{}, dq_{}, dp_{}, slope_{};
    Vector force_{};  // dH/dq where the last step ended
    bool known_ = false;  // whether it is kept
};

}  // namespace hvi::generated
