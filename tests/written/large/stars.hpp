// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method stormer-verlet plummer --name Stars
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
//     P_1 = P_2 is evaluated once: these stages are equal
//     Q_1 is not solved for: it is q at the start of the step
//     Q_2 takes no sum of its own: it is q at the end of the step
//     no solver: no stage depends on itself: the step is kicks and drifts in turn
//     no compensated summation: the error of the step is far above round-off
//     one force a step is not evaluated: the last one of a step is the first one of the next
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <hvi/detail/coefficients/rounded.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/ranges.hpp>
#include <hvi/detail/loops/chunks.hpp>

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

namespace hvi::generated {

/// The scene plummer of any size with stormer-verlet, computed in Number: float, double or long
/// double. States hold std::vector.
/// A star cluster, Plummer's sphere with softened forces
template <class Number>
class BasicStars {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 1000;
        Scalar m = hvi::detail::rounded<Scalar>(0.001f, 0.001, -0x1.8ap-66, -0x1.89374bc6a7ef9p-66,
            -0x1.cp-119);  // m = 1/1000
        Scalar eps = hvi::detail::rounded<Scalar>(0.02f, 0.02, -0x1.ecp-62, -0x1.eb851eb851eb8p-62,
            -0x1.4p-116);  // eps = 1/50
    };

    /// H =
    /// sum(i=1..N,(px[i]^2+py[i]^2+pz[i]^2)/(2*m))-sum(i=1..N-1,sum(j=i+1..N,m^2/sqrt((x[i]-x[j])^2
    /// +(y[i]-y[j])^2+(z[i]-z[j])^2+eps^2)))
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;

        explicit System(const Parameters& parameters, unsigned threads = 1)
            : N_(parameters.N), team_(threads) {
            Place in_q = 0, in_p = 0;
            x_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            y_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            z_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            px_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            py_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            pz_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            size_ = static_cast<std::size_t>(in_q);
            c1_ = parameters.m * parameters.m;
            c2_ = parameters.eps * parameters.eps;
            c3_ = Scalar(1.0) / parameters.m;
            c4_ = Scalar(1.0) / static_cast<Scalar>(parameters.N);
            c5_ = parameters.m * k12;
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return size_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == size_;
        }

        void add_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to, Place stride) const {
            for (Place i = from; i < to; i += stride) {
                hvi::detail::Total<Scalar, 4> sum_1;
                hvi::detail::Total<Scalar, 4> sum_3;
                hvi::detail::Total<Scalar, 4> sum_5;
                const Scalar a1 = q[x_at_ + (i)];
                const Scalar a2 = q[y_at_ + (i)];
                const Scalar a3 = q[z_at_ + (i)];
                hvi::detail::along<Scalar, 4>(i + 1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place j) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a4 = stretch.load(q + x_at_ + (j));
                    const V a5 = stretch.load(q + y_at_ + (j));
                    const V a6 = stretch.load(q + z_at_ + (j));
                    const V t1 = a1 - a4;
                    const V t2 = a2 - a5;
                    const V t3 = a3 - a6;
                    const V t4 = t1 * t1 + t2 * t2 + t3 * t3 + c2_;
                    const V t5 = c1_ / (t4 * hvi::math::sqrt(t4));
                    const V t6 = t3 * t5;
                    const V t7 = t2 * t5;
                    const V t8 = t1 * t5;
                    sum_1.add(V(t8));
                    hvi::detail::subtract(out + x_at_ + (j), V(t8));
                    sum_3.add(V(t7));
                    hvi::detail::subtract(out + y_at_ + (j), V(t7));
                    sum_5.add(V(t6));
                    hvi::detail::subtract(out + z_at_ + (j), V(t6));
                });
                out[x_at_ + (i)] += sum_1.sum();
                out[y_at_ + (i)] += sum_3.sum();
                out[z_at_ + (i)] += sum_5.sum();
            }
        }

        void dHdq([[maybe_unused]] const Vector& q, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            hvi::detail::chunked(team_, 1, N_, out.data(), out.size(), memory_,
                [&](Place from, Place to, Place stride, Scalar* to_out) {
                add_by_q_2(q.data(), nullptr, to_out, from, to, stride);
            });
        }

        void add_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(p + px_at_ + (i));
                const V a2 = stretch.load(p + py_at_ + (i));
                const V a3 = stretch.load(p + pz_at_ + (i));
                hvi::detail::add(out + px_at_ + (i), V(a1 * c3_));
                hvi::detail::add(out + py_at_ + (i), V(a2 * c3_));
                hvi::detail::add(out + pz_at_ + (i), V(a3 * c3_));
            });
        }

        void dHdp([[maybe_unused]] const Vector& p, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_p_1(nullptr, p.data(), out.data(), 1, N_ + 1);
        }

        [[nodiscard]] Scalar energy([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + px_at_ + (i));
                    const V a2 = stretch.load(p + py_at_ + (i));
                    const V a3 = stretch.load(p + pz_at_ + (i));
                    inner.add(V(Scalar(0.5) * ((a1 * a1 + a2 * a2 + a3 * a3) * c3_)));
                });
                total.add(inner.sum());
            }
            for (Place i = 1; i <= N_ - 1; ++i) {
                hvi::detail::Total<Scalar, 4> inner;
                const Scalar a1 = q[x_at_ + (i)];
                const Scalar a2 = q[y_at_ + (i)];
                const Scalar a3 = q[z_at_ + (i)];
                hvi::detail::along<Scalar, 4>(i + 1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place j) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a4 = stretch.load(q + x_at_ + (j));
                    const V a5 = stretch.load(q + y_at_ + (j));
                    const V a6 = stretch.load(q + z_at_ + (j));
                    const V t1 = a1 - a4;
                    const V t2 = a2 - a5;
                    const V t3 = a3 - a6;
                    inner.add(V(-c1_ / hvi::math::sqrt(t1 * t1 + t2 * t2 + t3 * t3 + c2_)));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        [[nodiscard]] Scalar momentum_x([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + px_at_ + (i));
                    inner.add(V(a1));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        [[nodiscard]] Scalar momentum_y([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + py_at_ + (i));
                    inner.add(V(a1));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        [[nodiscard]] Scalar momentum_z([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + pz_at_ + (i));
                    inner.add(V(a1));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        [[nodiscard]] Scalar angular_momentum_x([[maybe_unused]] const Vector& q_of,
            [[maybe_unused]] const Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + py_at_ + (i));
                    const V a2 = stretch.load(p + pz_at_ + (i));
                    const V a3 = stretch.load(q + y_at_ + (i));
                    const V a4 = stretch.load(q + z_at_ + (i));
                    inner.add(V(a2 * a3 - a1 * a4));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        [[nodiscard]] Scalar angular_momentum_y([[maybe_unused]] const Vector& q_of,
            [[maybe_unused]] const Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + px_at_ + (i));
                    const V a2 = stretch.load(p + pz_at_ + (i));
                    const V a3 = stretch.load(q + x_at_ + (i));
                    const V a4 = stretch.load(q + z_at_ + (i));
                    inner.add(V(a1 * a4 - a2 * a3));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        [[nodiscard]] Scalar angular_momentum_z([[maybe_unused]] const Vector& q_of,
            [[maybe_unused]] const Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + px_at_ + (i));
                    const V a2 = stretch.load(p + py_at_ + (i));
                    const V a3 = stretch.load(q + x_at_ + (i));
                    const V a4 = stretch.load(q + y_at_ + (i));
                    inner.add(V(a2 * a3 - a1 * a4));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        /// Where the scene begins; empty where lists do not fit.
        void begin(Vector& q_of, Vector& p_of) const {
            q_of.clear();
            p_of.clear();
            q_of.assign(size_, Scalar(0));
            [[maybe_unused]] Scalar* const q = q_of.data();
            p_of.assign(size_, Scalar(0));
            [[maybe_unused]] Scalar* const p = p_of.data();
            for (Place i = 1; i <= N_; ++i) {
                const Scalar t1 = hvi::math::pow(-(Scalar(0.5) - static_cast<Scalar>(i)) * c4_, k1);
                const Scalar t2 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k2)));
                const Scalar t3 = Scalar(1.0) - Scalar(2.0) * (t2 * k3);
                const Scalar t4 = hvi::math::sqrt(Scalar(1.0)
                    - t3 * t3) * hvi::math::cos(Scalar(2.0) * (static_cast<Scalar>(i) * k4));
                q[x_at_ + i] = t4 / hvi::math::sqrt(-(Scalar(1.0) - t1));
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar t1 = hvi::math::pow(-(Scalar(0.5) - static_cast<Scalar>(i)) * c4_, k1);
                const Scalar t2 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k2)));
                const Scalar t3 = Scalar(1.0) - Scalar(2.0) * (t2 * k3);
                const Scalar t4 = hvi::math::sqrt(Scalar(1.0)
                    - t3 * t3) * hvi::math::sin(Scalar(2.0) * (static_cast<Scalar>(i) * k4));
                q[y_at_ + i] = t4 / hvi::math::sqrt(-(Scalar(1.0) - t1));
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar t1 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k2)));
                const Scalar t2 = hvi::math::pow(-(Scalar(0.5) - static_cast<Scalar>(i)) * c4_, k1);
                const Scalar t3 = (Scalar(1.0)
                    - Scalar(2.0) * (t1 * k3)) / hvi::math::sqrt(-(Scalar(1.0) - t2));
                q[z_at_ + i] = -t3;
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar t1 = hvi::math::pow(-(Scalar(0.5) - static_cast<Scalar>(i)) * c4_, k1);
                const Scalar t2 = Scalar(1.0) / hvi::math::sqrt(-(Scalar(1.0) - t1));
                const Scalar t3 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k6)));
                const Scalar t4 = hvi::math::sqrt(Scalar(1.0)
                    - hvi::math::pow(k3 * t3, k7)) * hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k8));
                p[px_at_ + i] = c5_ * t4 * hvi::math::pow(Scalar(1.0) + t2 * t2, k5);
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar t1 = hvi::math::pow(-(Scalar(0.5) - static_cast<Scalar>(i)) * c4_, k1);
                const Scalar t2 = Scalar(1.0) / hvi::math::sqrt(-(Scalar(1.0) - t1));
                const Scalar t3 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k6)));
                const Scalar t4 = hvi::math::sqrt(Scalar(1.0)
                    - hvi::math::pow(k3 * t3, k7)) * hvi::math::sin(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k8));
                p[py_at_ + i] = c5_ * t4 * hvi::math::pow(Scalar(1.0) + t2 * t2, k5);
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar t1 = hvi::math::pow(-(Scalar(0.5) - static_cast<Scalar>(i)) * c4_, k1);
                const Scalar t2 = Scalar(1.0) / hvi::math::sqrt(-(Scalar(1.0) - t1));
                const Scalar t3 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k6)));
                const Scalar t4 = hvi::math::acos(hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k9)));
                const Scalar t5 = (Scalar(1.0) - (Scalar(1.0)
                    - hvi::math::pow(k3 * t3, k7))) * (Scalar(1.0) - hvi::math::pow(k3 * t4, k10));
                const Scalar t6 = hvi::math::sqrt(t5) * hvi::math::cos(Scalar(2.0) *
                    (static_cast<Scalar>(i) * k11));
                p[pz_at_ + i] = c5_ * t6 * hvi::math::pow(Scalar(1.0) + t2 * t2, k5);
            }
        }

        static constexpr Scalar k1 = hvi::detail::rounded<Scalar>(-0.6666667f, -0.6666666666666666,
            -0x1.558p-55, -0x1.5555555555555p-55, -0x1.5p-109);  // -2/3
        static constexpr Scalar k2 = hvi::detail::rounded<Scalar>(4.442883f, 4.442882938158366,
            0x1.4fp-53, 0x1.4edf1f285c1f5p-53, 0x1.fp-106);  // pi*sqrt(2)
        static constexpr Scalar k3 = hvi::detail::rounded<Scalar>(0.31830987f, 0.3183098861837907,
            -0x1.6bp-56, -0x1.6b01ec5417056p-56, -0x1.6p-110);  // 1/pi
        static constexpr Scalar k4 = hvi::detail::rounded<Scalar>(5.441398f, 5.441398092702654,
            -0x1.d08p-52, -0x1.d084feacc3f0dp-52, -0x1.7p-105);  // pi*sqrt(3)
        static constexpr Scalar k5 = Scalar(-0.25);  // -1/4
        static constexpr Scalar k6 = hvi::detail::rounded<Scalar>(7.0248146f, 7.024814731040727,
            -0x1.89p-52, -0x1.890eadc660411p-52, -0x1.9p-106);  // pi*sqrt(5)
        static constexpr Scalar k7 = hvi::detail::rounded<Scalar>(0.2f, 0.2, -0x1.998p-57,
            -0x1.9999999999999p-57, -0x1.3p-110);  // 1/5
        static constexpr Scalar k8 = hvi::detail::rounded<Scalar>(8.3118725f, 8.311872882066082,
            -0x1.3p-56, -0x1.3202835517434p-56, 0.0);  // pi*sqrt(7)
        static constexpr Scalar k9 = hvi::detail::rounded<Scalar>(10.419484f, 10.419484076094312,
            0x1.abp-52, 0x1.aaa81c56474dep-52, 0x1.fp-105);  // pi*sqrt(11)
        static constexpr Scalar k10 = Scalar(0.25);  // 1/4
        static constexpr Scalar k11 = hvi::detail::rounded<Scalar>(11.327173f, 11.327173399138978,
            -0x1.82p-52, -0x1.81cea74cd9815p-52, -0x1.4p-105);  // pi*sqrt(13)
        static constexpr Scalar k12 = hvi::detail::rounded<Scalar>(1.4142135f, 1.4142135623730951,
            -0x1.bep-54, -0x1.bdd3413b26455p-54, -0x1.58p-107);  // sqrt(2)
        Scalar c1_ = 0;
        Scalar c2_ = 0;
        Scalar c3_ = 0;
        Scalar c4_ = 0;
        Scalar c5_ = 0;
        Place N_;
        Place x_at_ = 0;
        Place y_at_ = 0;
        Place z_at_ = 0;
        Place px_at_ = 0;
        Place py_at_ = 0;
        Place pz_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
        mutable hvi::detail::Team team_;
        mutable Vector memory_{};  // of chunks
    };

    using State = hvi::State<Vector>;

    BasicStars() : BasicStars(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicStars(const Parameters& parameters, unsigned threads = 1) : system_(parameters,
        threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H =
    /// sum(i=1..N,(px[i]^2+py[i]^2+pz[i]^2)/(2*m))-sum(i=1..N-1,sum(j=i+1..N,m^2/sqrt((x[i]-x[j])^2
    /// +(y[i]-y[j])^2+(z[i]-z[j])^2+eps^2))); not a number where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
    }

    /// sum(i=1..N,px[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar momentum_x(const State& x) const {
        return system_.momentum_x(x.q, x.p);
    }

    /// sum(i=1..N,py[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar momentum_y(const State& x) const {
        return system_.momentum_y(x.q, x.p);
    }

    /// sum(i=1..N,pz[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar momentum_z(const State& x) const {
        return system_.momentum_z(x.q, x.p);
    }

    /// sum(i=1..N,y[i]*pz[i]-z[i]*py[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar angular_momentum_x(const State& x) const {
        return system_.angular_momentum_x(x.q, x.p);
    }

    /// sum(i=1..N,z[i]*px[i]-x[i]*pz[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar angular_momentum_y(const State& x) const {
        return system_.angular_momentum_y(x.q, x.p);
    }

    /// sum(i=1..N,x[i]*py[i]-y[i]*px[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar angular_momentum_z(const State& x) const {
        return system_.angular_momentum_z(x.q, x.p);
    }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] constexpr Status step(State& x, Scalar h) {
        if (!system_.fits(x.q, x.p)) { return Status(Status::Code::dimension_mismatch); }
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

using Stars = BasicStars<double>;

}  // namespace hvi::generated
