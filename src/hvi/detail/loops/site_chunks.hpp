// The inside of a lattice, cut into chunks that can be swept in any order.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include <hvi/detail/loops/sites.hpp>

namespace hvi::detail {

/// Units of the inside of a lattice: sites of a chain, rows of anything else.
struct Units {
    Place first, end;
};

/// The inside is cut into chunks, of a size that depends on the lattice alone, whatever the number
/// of threads. The first units of a chunk, as many as the force reaches, are its seam, the others
/// its core: no force on a core reads a position in another core. So the cores can be moved in
/// place in any order, where the momenta of all seams were kicked before and their positions drift
/// afterwards.
template <class System>
class SiteChunks {
public:
    static constexpr std::size_t dimension = System::dimension;
    using Part = RowPart<dimension>;

    explicit SiteChunks(const Sites<dimension>& sites) : sites_(sites) {
        const Box<dimension>& inside = sites.inside();
        if constexpr (dimension == 1) {
            units_ = inside.length(0);
            reach_ = System::reach[0];
        } else {
            units_ = sites.inside_rows();
            for (std::size_t i = 0; i + 1 < dimension; ++i) {
                reach_ = reach_ * inside.length(i) + System::reach[i];
            }
        }
        // NOTE: a power of two, so that two, four or eight threads have as much to do each.
        Place count = 1;
        while (count < most && 2 * count * smallest <= sites.count()) { count *= 2; }
        // NOTE: seams take another sweep.
        length_ = std::max({(units_ + count - 1) / count, 8 * reach_, Place{1}});
    }

    [[nodiscard]] const Sites<dimension>& sites() const { return sites_; }

    /// Returns how many units beyond its own a force may read.
    [[nodiscard]] Place reach() const { return reach_; }

    [[nodiscard]] Place count() const { return (units_ + length_ - 1) / length_; }

    /// Returns the seam of chunk i. The first chunk has none.
    [[nodiscard]] Units seam(Place i) const {
        const Place first = i * length_;
        return {first, i == 0 ? first : std::min(first + reach_, units_)};
    }

    [[nodiscard]] Units core(Place i) const {
        return {seam(i).end, std::min((i + 1) * length_, units_)};
    }

    /// Calls f for each part of a row that the units consist of.
    template <class F>
    void for_each_part(Units units, F&& f) const {
        if constexpr (dimension == 1) {
            f(sites_.inside_row(0).tail(units.first).head(units.end - units.first));
        } else {
            for (Place row = units.first; row < units.end; ++row) { f(sites_.inside_row(row)); }
        }
    }

private:
    static constexpr Place smallest = 8192, most = 64;

    Sites<dimension> sites_;
    Place units_ = 0;
    Place reach_ = 0;
    Place length_ = 1;
};

}  // namespace hvi::detail
