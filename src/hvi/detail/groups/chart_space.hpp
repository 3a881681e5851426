// The space of a step with rotations, and states in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/groups/space.hpp>

namespace hvi::detail {

/// n coordinates with their momenta, and m rotations R with the angular momenta L in the body.
template <class Number, std::size_t n, std::size_t m>
struct ChartSpace {
    using Scalar = Number;

    static constexpr std::size_t coordinates = n;
    static constexpr std::size_t rotations = m;
    static constexpr std::size_t degrees_of_freedom = n + 3 * m;

    /// Coordinates, then the R, row by row.
    using Positions = std::array<Number, n + 9 * m>;
    /// One number for each degree of freedom. The three of a rotation follow the coordinates.
    using Vector = std::array<Number, n + 3 * m>;

    /// One T for each rotation.
    template <class T>
    using PerRotation = std::array<T, m>;

    /// NOTE: arrays always have their size.
    static constexpr bool has_fixed_size = true;
    template <class At>
    void fit(const At& /*state*/) {}
    static void set_zero(Vector& v) { v = {}; }
    [[nodiscard]] static Positions no_positions() { return Positions{}; }

    /// Returns the three numbers of a Vector that belong to rotation r.
    [[nodiscard]] static Vector3<Number> part(const Vector& v, std::size_t r) {
        return {v[n + 3 * r], v[n + 3 * r + 1], v[n + 3 * r + 2]};
    }
    static void set_part(Vector& v, std::size_t r, const Vector3<Number>& part) {
        for (std::size_t k = 0; k < 3; ++k) { v[n + 3 * r + k] = part[k]; }
    }
    [[nodiscard]] static Matrix3<Number> rotation(const Positions& q, std::size_t r) {
        Matrix3<Number> R{};
        for (std::size_t k = 0; k < 9; ++k) { R[k] = q[n + 9 * r + k]; }
        return R;
    }
    static void set_rotation(Positions& q, std::size_t r, const Matrix3<Number>& R) {
        for (std::size_t k = 0; k < 9; ++k) { q[n + 9 * r + k] = R[k]; }
    }
};

/// State: q, p, R and L.
template <class Space>
struct ChartState {
    typename Space::Positions q{};
    typename Space::Vector p{};
};

}  // namespace hvi::detail
