// Copies of the vectors of a lattice, to go back to.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <hvi/detail/loops/sites.hpp>
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

/// Vectors of a lattice, each of `components` numbers for each of `count` sites, and a copy of
/// each. Sites are kept and looked at where a sweep has them in its cache.
template <class Scalar>
class SiteCopies {
public:
    SiteCopies(std::vector<Scalar*> vectors, Place components, Place count,
               std::vector<Scalar>& memory)
        : vectors_(std::move(vectors)), components_(components), count_(count), memory_(memory) {
        memory_.resize(vectors_.size() * static_cast<std::size_t>(components * count));
    }

    /// Copies `sites` sites from number `at` on.
    void keep(Place at, Place sites) {
        for_each_row(at, sites,
                     [&](const Scalar* vector, Scalar* copy) { std::copy_n(vector, sites, copy); });
    }

    /// Returns whether all numbers of these sites are finite.
    [[nodiscard]] bool finite(Place at, Place sites) {
        bool all = true;
        for_each_row(at, sites, [&](const Scalar* vector, const Scalar*) {
            all = all && are_finite(vector, sites);
        });
        return all;
    }

    void restore() {
        for_each_row(0, count_, [&](Scalar* vector, const Scalar* copy) {
            std::copy_n(copy, count_, vector);
        });
    }

private:
    /// Calls f(vector, copy) with the places from which each component of these sites stands.
    template <class F>
    void for_each_row(Place at, Place sites, F&& f) {
        if (sites == 0) { return; }
        Scalar* copy = memory_.data() + at;
        for (Scalar* vector : vectors_) {
            for (Place c = 0; c < components_; ++c, copy += count_) {
                f(vector + c * count_ + at, copy);
            }
        }
    }

    std::vector<Scalar*> vectors_;
    Place components_, count_;
    std::vector<Scalar>& memory_;
};

}  // namespace hvi::detail
