// Functions of numbers side by side that are made of exp and log.
// SPDX-License-Identifier: MIT
//
// NOTE: apart from lane_math.hpp, as a compiler takes long to read xsimd.
#pragma once

#include <cstddef>

#include <hvi/detail/lanes/lane_math.hpp>
#include <hvi/detail/lanes/register_functions.hpp>

namespace hvi::math {

template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> acos(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return acos(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> asin(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return asin(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> asinh(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return asinh(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> atan(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return atan(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> atanh(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return atanh(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> cbrt(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return cbrt(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> cosh(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) {
        return detail::exponential(a, [](const auto& b) { return cosh(b); });
    });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> exp(const Lanes<Number, count, most>& x) {
    return x.map(
        [](const auto& a) { return detail::exponential(a, [](const auto& b) { return exp(b); }); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> expm1(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) {
        return detail::exponential(a, [](const auto& b) { return expm1(b); });
    });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> log(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return log(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> log10(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) { return log10(a); });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> sinh(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) {
        return detail::exponential(a, [](const auto& b) { return sinh(b); });
    });
}
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> tanh(const Lanes<Number, count, most>& x) {
    return x.map([](const auto& a) {
        return detail::exponential(a, [](const auto& b) { return tanh(b); });
    });
}

}  // namespace hvi::math
