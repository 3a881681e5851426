// Directions as groups of them keep them from step to step.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <hvi/detail/directions/cells.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// A size above zero such that a quotient by it is a finite number.
template <class Scalar>
inline constexpr auto least = static_cast<Scalar>(std::numeric_limits<float>::min());

/// A change over a size, of each direction.
template <class Cells>
[[nodiscard]] typename Cells::Number relative(const typename Cells::Lane& change,
                                              const typename Cells::Lane& size) {
    using Number = typename Cells::Number;
    using Scalar = ScalarOf<typename Cells::Row>;
    return Cells::total(change) / (Cells::total(size) + Number(least<Scalar>));
}

/// Directions, as many as `Cells` has, and what rounding cut off from them.
template <class Cells, std::size_t dimension>
class DirectionState {
public:
    using Number = typename Cells::Number;
    using Vector = std::array<typename Cells::Kept, dimension>;
    using Rows = std::array<std::array<typename Cells::Row, dimension>, Cells::parts>;
    static constexpr std::size_t degrees = dimension;

    Vector q{}, p{}, e_q{}, e_p{};

    /// Takes `count` directions; lanes that are left over have the last. Returns whether they are
    /// those with which the last step ended.
    template <class Iterator>
    bool take(Iterator directions, std::size_t count) {
        Vector next_q, next_p;
        for (std::size_t lane = 0; lane < Cells::directions; ++lane) {
            const auto& d = directions[static_cast<std::ptrdiff_t>(std::min(lane, count - 1))];
            for (std::size_t k = 0; k < dimension; ++k) {
                Cells::of_direction(next_q[k], lane) = at(d.q, k);
                Cells::of_direction(next_p[k], lane) = at(d.p, k);
            }
        }
        const bool are_known = equal(next_q, q) && equal(next_p, p);
        if (!are_known) {
            q = next_q;
            p = next_p;
            e_q = e_p = {};
        }
        return are_known;
    }

    template <class Iterator>
    void give(Iterator directions, std::size_t count) {
        for (std::size_t lane = 0; lane < count; ++lane, ++directions) {
            for (std::size_t k = 0; k < dimension; ++k) {
                at(directions->q, k) = Cells::of_direction(q[k], lane);
                at(directions->p, k) = Cells::of_direction(p[k], lane);
            }
        }
    }

    [[nodiscard]] bool is_finite() const {
        Number sum(0);
        for (std::size_t k = 0; k < dimension; ++k) {
            sum = sum + (Number(q[k]) - Number(q[k])) + (Number(p[k]) - Number(p[k]));
        }
        return Cells::all_of(sum == Number(0));
    }

protected:
    /// Adds increments to component k.
    void move(std::size_t k, const Number& of_q, const Number& of_p) {
        move(q[k], e_q[k], of_q);
        move(p[k], e_p[k], of_p);
    }

private:
    using Kept = typename Cells::Kept;

    [[nodiscard]] static bool equal(const Vector& x, const Vector& y) {
        auto all = Number(x[0]) == Number(y[0]);
        for (std::size_t k = 1; k < dimension; ++k) { all = all & (Number(x[k]) == Number(y[k])); }
        return Cells::all_of(all);
    }

    static void move(Kept& to, Kept& remainder, const Number& increment) {
        const Sum<Number> sum = two_sum<Number>(Number(to), Number(remainder) + increment);
        Cells::store(sum.value, to);
        Cells::store(sum.remainder, remainder);
    }
};

}  // namespace hvi::detail
