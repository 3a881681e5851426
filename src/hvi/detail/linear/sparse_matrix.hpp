// Square matrices of which few entries are not zero.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/arithmetic.hpp>

namespace hvi::detail {

/// Places of entries, row by row, and the entries. Places are found once, and stay.
///
/// A matrix is made by a function `entries(out)` that calls out.add(i, j, value) for all entries;
/// values at one place are added. Later calls may set only places that were found at first.
template <class Scalar>
class SparseMatrix {
public:
    using Index = std::size_t;

    template <class Entries>
    void find_places(std::size_t n, Entries&& entries) {
        Places places;
        entries(places);
        std::sort(places.all.begin(), places.all.end());
        places.all.erase(std::unique(places.all.begin(), places.all.end()), places.all.end());
        rows_.assign(n + 1, 0);
        columns_.clear();
        columns_.reserve(places.all.size());
        for (const auto& [i, j] : places.all) {
            ++rows_[i + 1];
            columns_.push_back(j);
        }
        for (std::size_t i = 0; i < n; ++i) { rows_[i + 1] += rows_[i]; }
        values_.assign(columns_.size(), Scalar(0));
    }

    /// Sets the entries. Precondition: find_places() was called.
    template <class Entries>
    void set(Entries&& entries) {
        std::fill(values_.begin(), values_.end(), Scalar(0));
        entries(*this);
    }

    template <class Place>
    void add(Place i, Place j, const Scalar& value) {
        const auto row = static_cast<Index>(i);
        const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(rows_[row]);
        const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(rows_[row + 1]);
        const auto found = std::lower_bound(begin, end, static_cast<Index>(j));
        values_[static_cast<Index>(found - columns_.begin())] += value;
    }

    [[nodiscard]] std::size_t size() const { return rows_.empty() ? 0 : rows_.size() - 1; }

    /// Calls f(i, j, value) for each place, row by row; the value may be changed.
    template <class F>
    void for_each(F&& f) {
        for (Index i = 0; i < size(); ++i) {
            for (Index e = rows_[i]; e < rows_[i + 1]; ++e) { f(i, columns_[e], values_[e]); }
        }
    }
    template <class F>
    void for_each(F&& f) const {
        for (Index i = 0; i < size(); ++i) {
            for (Index e = rows_[i]; e < rows_[i + 1]; ++e) { f(i, columns_[e], values_[e]); }
        }
    }

    /// Returns row i times x, which has an operator[].
    template <class X>
    [[nodiscard]] Scalar times(Index i, const X& x) const {
        Scalar sum = 0;
        for (Index e = rows_[i]; e < rows_[i + 1]; ++e) { sum += values_[e] * x[columns_[e]]; }
        return sum;
    }

    [[nodiscard]] bool is_finite() const {
        return std::all_of(values_.begin(), values_.end(),
                           [](const Scalar& value) { return detail::is_finite(value); });
    }

    /// Return the columns of row i, ascending.
    [[nodiscard]] const Index* begin_of(Index i) const { return columns_.data() + rows_[i]; }
    [[nodiscard]] const Index* end_of(Index i) const { return columns_.data() + rows_[i + 1]; }

private:
    struct Places {
        std::vector<std::pair<Index, Index>> all{};

        template <class Place>
        void add(Place i, Place j, const Scalar&) {
            all.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
        }
    };

    std::vector<Index> rows_, columns_;  ///< row i is from rows_[i] to rows_[i + 1]
    std::vector<Scalar> values_;
};

}  // namespace hvi::detail
