// The space of a step with any number of rotations.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <hvi/detail/groups/space.hpp>

namespace hvi::detail {

/// Coordinates with their momenta, and rotations R with the angular momenta L in the body, in
/// numbers that a state decides. Positions are the coordinates, then the R row by row, so that for
/// n coordinates and m rotations there are n + 9 m positions and n + 3 m momenta. ChartSpace is the
/// space of fixed numbers.
template <class Number>
struct BodySpace {
    using Scalar = Number;
    using Positions = std::vector<Number>;
    using Vector = std::vector<Number>;
    template <class T>
    using PerRotation = std::vector<T>;

    static constexpr bool has_fixed_size = false;

    std::size_t coordinates = 0, rotations = 0, degrees_of_freedom = 0;

    /// Takes the numbers of coordinates and rotations of a state.
    template <class At>
    void fit(const At& state) {
        degrees_of_freedom = state.p.size();
        rotations = (state.q.size() - state.p.size()) / 6;
        coordinates = degrees_of_freedom - 3 * rotations;
    }
    void set_zero(Vector& v) const { v.assign(degrees_of_freedom, Number(0)); }
    [[nodiscard]] Positions no_positions() const {
        return Positions(coordinates + 9 * rotations, Number(0));
    }

    /// Returns the three numbers of a Vector that belong to rotation r.
    [[nodiscard]] Vector3<Number> part(const Vector& v, std::size_t r) const {
        const std::size_t k = coordinates + 3 * r;
        return {v[k], v[k + 1], v[k + 2]};
    }
    void set_part(Vector& v, std::size_t r, const Vector3<Number>& part) const {
        std::copy(part.begin(), part.end(), v.begin() + difference(coordinates + 3 * r));
    }
    [[nodiscard]] Matrix3<Number> rotation(const Positions& q, std::size_t r) const {
        Matrix3<Number> R{};
        std::copy_n(q.begin() + difference(coordinates + 9 * r), 9, R.begin());
        return R;
    }
    void set_rotation(Positions& q, std::size_t r, const Matrix3<Number>& R) const {
        std::copy(R.begin(), R.end(), q.begin() + difference(coordinates + 9 * r));
    }

private:
    [[nodiscard]] static std::ptrdiff_t difference(std::size_t k) {
        return static_cast<std::ptrdiff_t>(k);
    }
};

/// Sets `out` to the derivatives by coordinates and by turns R exp(hat eta): D_a = G : R hat(e_a),
/// where `by_entries` has the derivatives by coordinates and, as G, by the entries of R. `out` has
/// n + 3 m numbers.
template <class Vector>
void by_turns(const Vector& q, const Vector& by_entries, Vector& out) {
    const std::size_t rotations = (q.size() - out.size()) / 6;
    const std::size_t n = out.size() - 3 * rotations;
    for (std::size_t k = 0; k < n; ++k) { out[k] = by_entries[k]; }
    for (std::size_t r = 0; r < rotations; ++r) {
        const auto R = [&](std::size_t i, std::size_t j) { return q[n + 9 * r + 3 * i + j]; };
        const auto G = [&](std::size_t i, std::size_t j) {
            return by_entries[n + 9 * r + 3 * i + j];
        };
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            auto sum = G(0, b) * R(0, c) - G(0, c) * R(0, b);
            for (std::size_t i = 1; i < 3; ++i) { sum += G(i, b) * R(i, c) - G(i, c) * R(i, b); }
            out[n + 3 * r + a] = sum;
        }
    }
}

}  // namespace hvi::detail
