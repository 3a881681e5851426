// Numbers that stand in a row in memory, one or several at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include <hvi/detail/lanes/lanes.hpp>

namespace hvi::detail {

/// Place in a vector, or index of a sum. Signed, as indices may be.
using Place = std::ptrdiff_t;

/// One step of a loop: a Value of `count` consecutive numbers.
template <class Value>
struct Stretch {
    static constexpr Place count = 1;
    [[nodiscard]] static const Value& load(const Value* from) { return *from; }
    static void store(const Value& x, Value* to) { *to = x; }
    /// Returns a number with the value x for each of the `count` numbers.
    [[nodiscard]] static const Value& spread(const Value& x) { return x; }
    [[nodiscard]] static const Value& total(const Value& x) { return x; }
    /// Returns `first` + 0, 1, 2, ...
    [[nodiscard]] static Value indices(Place first) { return static_cast<Value>(first); }
};

template <class Number, std::size_t width>
struct Stretch<Lanes<Number, width>> {
    using Value = Lanes<Number, width>;
    static constexpr Place count = static_cast<Place>(width);
    [[nodiscard]] static Value load(const Number* from) { return Value::load(from); }
    static void store(const Value& x, Number* to) { x.store(to); }
    [[nodiscard]] static Value spread(const Number& x) { return x; }
    [[nodiscard]] static Number total(const Value& x) { return sum(x); }
    [[nodiscard]] static Value indices(Place first) {
        Number each[width];
        for (std::size_t i = 0; i < width; ++i) {
            each[i] = static_cast<Number>(first + static_cast<Place>(i));
        }
        return Value::load(each);
    }
};

/// Type of the values that a stretch computes with.
template <class Stretch>
using ValueOf = std::decay_t<decltype(Stretch::load(nullptr))>;

}  // namespace hvi::detail
