// Neighbours: where the force on a place of a lattice needs what is near it, and nothing else.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/ir/sums.hpp"

namespace hvi::gen {

/// What index k of a site says of a summand that has an element there.
struct SiteIndex {
    std::optional<std::size_t> loop;  ///< of the sum: its index is k - shift, or that and a
                                      ///< multiple of the modulus; else k is `shift` alone
    AffineForm shift;
    bool wraps = false;
};

/// The derivative of a summand by an element at a site.
struct SiteTerm {
    std::size_t sum = 0;        ///< of System::sums
    AccessSlope slope;          ///< by this element
    std::size_t component = 0;  ///< the coordinate that it is one of
    std::vector<SiteIndex> indices;
};

/// An element as a site sees it: index d of it is that of the site with number `of[d]`, and
/// `offset[d]`; or the offset alone.
struct SiteAccess {
    FamilyKind kind = FamilyKind::coordinate;
    std::size_t family = 0;
    std::vector<std::optional<std::size_t>> of;
    std::vector<AffineForm> offset;
    Node node = 0;
};

/// H = T(p) + U(q) of a lattice: all coordinates have the same indices, the *sites*; dU/dq at a
/// site is made of a number of elements that does not depend on sizes, and dT/dp of the momenta
/// there.
struct Sites {
    std::vector<LoopRange> ranges;  ///< of the sites
    std::vector<SiteTerm> terms;    ///< of dU/dq
    /// Where all terms exist and no index wraps, for each index from the largest of `firsts` to the
    /// least of `lasts`.
    struct Inside {
        std::vector<AffineForm> firsts, lasts;
    };
    std::vector<Inside> inside;
    std::vector<long> reach;           ///< for each index, how far other sites are there
    std::vector<Scaled> forces;        ///< there, one for each coordinate
    std::vector<Scaled> velocities;    ///< everywhere, one for each momentum
    std::vector<SiteAccess> accesses;  ///< inputs of forces and velocities
    std::vector<Node> indices;         ///< the inputs k as numbers
};

}  // namespace hvi::gen
