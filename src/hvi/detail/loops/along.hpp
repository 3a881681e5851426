// Loops over the innermost index of a sum, in lanes.
// SPDX-License-Identifier: MIT
//
// A term of H that is a sum over pairs is evaluated once for each pair, and its derivatives are
// added where they belong. Derivatives by variables that do not depend on the inner index j go to a
// Total, which is one number when the loop has ended. Derivatives by x[j], x[j+1], ... go to as
// many consecutive numbers.
#pragma once

#include <cstddef>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/loops/stretch.hpp>
#include <hvi/detail/numbers/compensated.hpp>

/// Attribute of the lambda that along() calls, between its parameters and its body. Sums of the
/// lambda stay in registers only where it is inlined. NOTE: [[...]] would be an attribute of its
/// type there.
#if defined(__GNUC__)
#define HVI_INLINED __attribute__((always_inline))
#else
#define HVI_INLINED
#endif

namespace hvi::detail {

/// Type of `width` numbers computed at once.
template <class Scalar, std::size_t width>
struct ManyNumbers {
    using type = Lanes<Scalar, width>;
};
template <class Scalar>
struct ManyNumbers<Scalar, 1> {
    using type = Scalar;
};

/// Calls body(Stretch<Value>{}, j) for stretches that cover all j with first <= j < last, in this
/// order: a single number, then 2 numbers in Lanes, 4 and so on where the number of indices is no
/// multiple of `width`, and then Lanes of `width`. Precondition: width is a power of two.
///
/// The body adds values of the type of its stretch. A number that does not depend on j is made one
/// by stretch.spread().
///
/// NOTE: the odd ones come first. Where `last` is the same for all outer indices, as in i < j,
/// whole stretches stand at the same places each time: a processor loads at once what it has just
/// stored as one, and waits for what it stored in parts.
template <class Scalar, std::size_t width, class Body>
[[gnu::always_inline]] inline void along(Place first, Place last, Body&& body) {
    using Many = Stretch<typename ManyNumbers<Scalar, width>::type>;
    if (last <= first) { return; }
    if constexpr (width > 1) {
        const Place odd = (last - first) % Many::count;
        along<Scalar, width / 2>(first, first + odd, body);
        first += odd;
    }
    for (Place j = first; j < last; j += Many::count) { body(Many(), j); }
}

/// Adds the value to to[0], to[1], ...
template <class Scalar>
void add(Scalar* to, const Scalar& value) {
    *to = *to + value;
}
template <class Scalar, std::size_t width>
void add(Scalar* to, const Lanes<Scalar, width>& value) {
    (Lanes<Scalar, width>::load(to) + value).store(to);
}

/// Subtracts the value from to[0], to[1], ... NOTE: no compiler sees that adding -value in
/// registers has the same result.
template <class Scalar>
void subtract(Scalar* to, const Scalar& value) {
    *to = *to - value;
}
template <class Scalar, std::size_t width>
void subtract(Scalar* to, const Lanes<Scalar, width>& value) {
    (Lanes<Scalar, width>::load(to) - value).store(to);
}

/// Total of the numbers that along<Scalar, width>() adds up, in lanes of its widths.
template <class Scalar, std::size_t width>
class Total {
public:
    void add(const Lanes<Scalar, width>& value) { wide_ += value; }
    template <std::size_t narrower>
    void add(const Lanes<Scalar, narrower>& value) {
        rest_ = rest_ + Stretch<Lanes<Scalar, narrower>>::total(value);
    }
    void add(const Scalar& value) { rest_ = rest_ + value; }

    [[nodiscard]] Scalar sum() const { return Stretch<Lanes<Scalar, width>>::total(wide_) + rest_; }

private:
    Lanes<Scalar, width> wide_ = Scalar(0);
    Scalar rest_ = 0;
};

template <class Scalar>
class Total<Scalar, 1> {
public:
    void add(const Scalar& value) { sum_ = sum_ + value; }
    [[nodiscard]] const Scalar& sum() const { return sum_; }

private:
    Scalar sum_ = 0;
};

/// Total of many numbers as if computed with twice the digits and rounded once. Energies, which
/// hardly change, are summed by it.
template <class Scalar>
class CompensatedTotal {
public:
    void add(const Scalar& value) {
        const Sum<Scalar> next = two_sum(sum_.value, value);
        sum_ = {next.value, sum_.remainder + next.remainder};
    }
    [[nodiscard]] Scalar sum() const { return sum_.value + sum_.remainder; }

private:
    Sum<Scalar> sum_{0, 0};
};

}  // namespace hvi::detail
