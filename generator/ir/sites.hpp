// Sites of a lattice, where a force needs near elements and nothing else.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/ir/sums.hpp"

namespace hvi::gen {

/// Index k of a site in terms of a summand that has an element there.
struct SiteIndex {
    std::optional<std::size_t> loop;  ///< loop of the sum whose index is k - shift, up to a
                                      ///< multiple of the modulus; without a loop k is `shift`
    AffineForm shift;
    bool wraps = false;
};

/// The derivative of a summand by an element at a site.
struct SiteTerm {
    std::size_t sum = 0;        ///< of System::sums
    AccessSlope slope;          ///< by this element
    std::size_t component = 0;  ///< number of the coordinate
    std::vector<SiteIndex> indices;
};

/// An element as a site sees it. Index d of the element is `offset[d]` plus the index with number
/// `of[d]` of the site, or the offset alone.
struct SiteAccess {
    FamilyKind kind = FamilyKind::coordinate;
    std::size_t family = 0;
    std::vector<std::optional<std::size_t>> of;
    std::vector<AffineForm> offset;
    Node node = 0;
};

/// A lattice with H = T(p) + U(q). All coordinates have the same indices, the *sites*. dU/dq at a
/// site depends on a number of elements that does not depend on sizes, and dT/dp depends on the
/// momenta at the site.
struct Sites {
    std::vector<LoopRange> ranges;  ///< of the sites
    std::vector<SiteTerm> terms;    ///< of dU/dq
    /// Sites where all terms exist and no index wraps: each index from the largest of `firsts` to
    /// the least of `lasts`.
    struct Inside {
        std::vector<AffineForm> firsts, lasts;
    };
    std::vector<Inside> inside;
    std::vector<long> reach;           ///< for each index, how far the inside reads
    std::vector<Scaled> forces;        ///< inside, one for each coordinate
    std::vector<Scaled> velocities;    ///< everywhere, one for each momentum
    std::vector<SiteAccess> accesses;  ///< inputs of forces and velocities
    std::vector<Node> indices;         ///< the inputs k as numbers
};

}  // namespace hvi::gen
