// Copies of the vectors of a lattice, to go back to.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include <hvi/detail/loops/sites.hpp>
#include <hvi/detail/loops/team.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// Returns whether all numbers are finite. NOTE: x - x is 0, or NaN.
template <class Scalar>
[[nodiscard]] bool are_finite(const Scalar* x, Place size) {
    using Wide = Stretch<SiteLanes<Scalar>>;
    SiteLanes<Scalar> sum(Scalar(0));
    Place i = 0;
    for (; i + Wide::count <= size; i += Wide::count) {
        const SiteLanes<Scalar> part = Wide::load(x + i);
        sum = sum + (part - part);
    }
    Scalar rest = Wide::total(sum);
    for (; i < size; ++i) { rest += x[i] - x[i]; }
    return rest == 0;
}

/// Vectors of `size` numbers each, and a copy of each. Work on them is cut into `pieces` for a
/// team.
template <class Scalar>
class SiteCopies {
public:
    SiteCopies(Team& team, std::vector<Scalar*> vectors, Place size, Place pieces,
               std::vector<Scalar>& memory)
        : team_(team), vectors_(std::move(vectors)), size_(size), pieces_(pieces), memory_(memory) {
        memory_.resize(vectors_.size() * static_cast<std::size_t>(size));
    }

    void keep() {
        for_each_piece([](const Scalar* vector, Scalar* copy, Place size) {
            std::copy_n(vector, size, copy);
        });
    }

    void restore() {
        for_each_piece([](Scalar* vector, const Scalar* copy, Place size) {
            std::copy_n(copy, size, vector);
        });
    }

    [[nodiscard]] bool finite() {
        std::atomic<bool> all{true};
        for_each_piece([&](const Scalar* vector, const Scalar*, Place size) {
            if (!are_finite(vector, size)) { all = false; }
        });
        return all;
    }

private:
    /// Calls f(vector, copy, size) for each pair of pieces.
    template <class F>
    void for_each_piece(F&& f) {
        team_.run(static_cast<std::size_t>(pieces_), [&](std::size_t piece) {
            const Place first = size_ * static_cast<Place>(piece) / pieces_;
            const Place end = size_ * static_cast<Place>(piece + 1) / pieces_;
            Scalar* copy = memory_.data() + first;
            for (Scalar* vector : vectors_) {
                f(vector + first, copy, end - first);
                copy += size_;
            }
        });
    }

    Team& team_;
    std::vector<Scalar*> vectors_;
    Place size_, pieces_;
    std::vector<Scalar>& memory_;
};

}  // namespace hvi::detail
