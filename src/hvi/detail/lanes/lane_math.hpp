// Functions of numbers side by side.
// SPDX-License-Identifier: MIT
//
// NOTE: the runtime calls none of them. Headers of scenes call them, as hvi::math::sin(x), for one
// number and for several, and so depend on the headers they include. More functions are in
// lane_functions.hpp.
#pragma once

#include <cstddef>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/lanes/register_trigonometry.hpp>
#include <hvi/detail/lanes/registers.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/more_math.hpp>

namespace hvi {

namespace detail {

/// Applies f to each number alone. NOTE: in xsimd 8 erf is off by up to 70 units in the last place,
/// erfc by 10^7, and acosh is infinite far below 1.
template <class Number, std::size_t count, std::size_t most, class F>
[[nodiscard]] Lanes<Number, count, most> one_by_one(const Lanes<Number, count, most>& x, F f) {
    typename Lanes<Number, count, most>::Row row;
    x.store(row);
    for (std::size_t i = 0; i < count; ++i) { row.set(i, f(row[i])); }
    return row;
}
template <class Number, std::size_t count, std::size_t most, class F>
[[nodiscard]] Lanes<Number, count, most> one_by_one(const Lanes<Number, count, most>& x,
                                                    const Lanes<Number, count, most>& y, F f) {
    typename Lanes<Number, count, most>::Row first, second;
    x.store(first);
    y.store(second);
    for (std::size_t i = 0; i < count; ++i) { first.set(i, f(first[i], second[i])); }
    return first;
}

/// Evaluation of of_each() for one number, or for several, number by number.
template <class Value>
struct Each {
    template <class F, class... Values>
    [[nodiscard]] static Value call(F f, const Values&... x) {
        return f(x...);
    }
};

template <class Number, std::size_t count, std::size_t most>
struct Each<Lanes<Number, count, most>> {
    using Row = typename Lanes<Number, count, most>::Row;

    template <class F, class... Values>
    [[nodiscard]] static Lanes<Number, count, most> call(F f, const Values&... x) {
        return rows(f, row(x)...);
    }

private:
    [[nodiscard]] static Row row(const Lanes<Number, count, most>& x) {
        Row result;
        x.store(result);
        return result;
    }

    template <class F, class... Rows>
    [[nodiscard]] static Row rows(F f, const Rows&... x) {
        Row result;
        for (std::size_t i = 0; i < count; ++i) { result.set(i, f(x[i]...)); }
        return result;
    }
};

/// Returns f(x, ...) as a Value, number by number, for a function f of single numbers. Value is
/// named by the caller, so that arguments of other types are converted.
template <class Value, class F, class... Given>
[[nodiscard]] Value of_each(F f, const Given&... x) {
    return Each<Value>::call(f, Value(x)...);
}

}  // namespace detail

// NOTE: functions of a register are found by its type. The result in a lane depends on that lane
// alone.
namespace math {

template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> acosh(const Lanes<Number, count, most>& x) {
    return detail::one_by_one(x, [](const Number& a) { return acosh(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> atan2(const Lanes<Number, count, most>& y,
                                               const Lanes<Number, count, most>& x) {
    return detail::one_by_one(y, x, [](const Number& a, const Number& b) { return atan2(a, b); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> atan2(const Lanes<Number, count, most>& y,
                                               const Number& x) {
    return atan2(y, Lanes<Number, count, most>(x));
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> atan2(const Number& y,
                                               const Lanes<Number, count, most>& x) {
    return atan2(Lanes<Number, count, most>(y), x);
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard, gnu::always_inline]] inline Lanes<Number, count, most>
cos(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) __attribute__((always_inline)) { return detail::cos_of(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> erf(const Lanes<Number, count, most>& x) {
    return detail::one_by_one(x, [](const Number& a) { return erf(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> erfc(const Lanes<Number, count, most>& x) {
    return detail::one_by_one(x, [](const Number& a) { return erfc(a); });
}
/// Returns x^y, number by number. NOTE: pow of xsimd is exp(y log(x)), off by as many units in the
/// last place as that exponent is large.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> pow(const Lanes<Number, count, most>& x,
                                             const Lanes<Number, count, most>& y) {
    return detail::one_by_one(x, y, [](const Number& a, const Number& b) { return pow(a, b); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> pow(const Lanes<Number, count, most>& x, const Number& y) {
    return pow(x, Lanes<Number, count, most>(y));
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> pow(const Number& x, const Lanes<Number, count, most>& y) {
    return pow(Lanes<Number, count, most>(x), y);
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard, gnu::always_inline]] inline Lanes<Number, count, most>
sin(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) __attribute__((always_inline)) { return detail::sin_of(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> sqrt(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return sqrt(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> tan(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return detail::tan_of(a); });
}

}  // namespace math

}  // namespace hvi
