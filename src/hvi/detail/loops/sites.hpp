// Degrees of freedom on the sites of a lattice, and the gradient of H there.
// SPDX-License-Identifier: MIT
//
// Families of coordinates with the same indices live on sites: component c of site number e is
// q[c * count + e]. A generated `System` describes H = T(p) + U(q) by
//
//     using Scalar = double;
//     static constexpr std::size_t dimension = 1;   // indices of a site
//     static constexpr std::size_t components = 1;  // families
//     static constexpr Site<dimension> reach = {1}; // how far inside sites look, for each index
//     Sites<dimension> sites() const;
//     // dU/dq of the inside sites e, e + 1, ... of a row that V stands for, k being the first
//     template <class V>
//     void force(const Scalar* q, Place e, const Site<dimension>& k, V (&out)[components]) const;
//     // dU/dq of any site
//     void force_at_edge(const Scalar* q, Place e, const Site<dimension>& k,
//                        Scalar (&out)[components]) const;
//     // dT/dp of any sites with the momenta p
//     template <class V>
//     void velocity(const V (&p)[components], Place e, const Site<dimension>& k,
//                   V (&out)[components]) const;
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/loops/stretch.hpp>

namespace hvi::detail {

/// Indices of a site. The last one runs fastest.
template <std::size_t dimension>
using Site = std::array<Place, dimension>;

/// The sites k with first[i] <= k[i] < end[i] for each i.
template <std::size_t dimension>
struct Box {
    Site<dimension> first, end;

    [[nodiscard]] Place length(std::size_t i) const { return end[i] - first[i]; }

    /// Returns the number of rows: sites that differ in the last index alone.
    [[nodiscard]] Place rows() const {
        Place product = 1;
        for (std::size_t i = 0; i + 1 < dimension; ++i) { product *= length(i); }
        return product;
    }

    /// Returns the first site of a row. Precondition: row < rows().
    [[nodiscard]] Site<dimension> row(Place row) const {
        Site<dimension> k = first;
        for (std::size_t i = dimension - 1; i > 0; --i) {
            k[i - 1] += row % length(i - 1);
            row /= length(i - 1);
        }
        return k;
    }

    [[nodiscard]] bool has(const Site<dimension>& k) const {
        bool is_inside = true;
        for (std::size_t i = 0; i < dimension; ++i) {
            is_inside = is_inside && first[i] <= k[i] && k[i] < end[i];
        }
        return is_inside;
    }
};

/// Consecutive sites of one row, from number `at` and indices k on.
template <std::size_t dimension>
struct RowPart {
    Place at;
    Site<dimension> k;
    Place count;

    void skip(Place sites) {
        at += sites;
        k[dimension - 1] += sites;
        count -= sites;
    }

    [[nodiscard]] RowPart head(Place sites) const { return {at, k, std::min(sites, count)}; }
    [[nodiscard]] RowPart tail(Place sites) const {
        RowPart part = *this;
        part.skip(std::min(sites, count));
        return part;
    }
};

/// All sites of a lattice, and the inside: the sites that have all their neighbours. The other
/// sites are edges.
template <std::size_t dimension>
class Sites {
public:
    /// Makes a lattice. An inside that is empty in one index becomes empty in all.
    Sites(const Box<dimension>& all, const Box<dimension>& inside) : all_(all), inside_(inside) {
        for (std::size_t i = 0; i < dimension; ++i) {
            if (inside.end[i] <= inside.first[i]) { inside_ = {all.first, all.first}; }
        }
    }

    [[nodiscard]] const Box<dimension>& inside() const { return inside_; }

    [[nodiscard]] Place count() const { return all_.rows() * all_.length(dimension - 1); }

    [[nodiscard]] Place number(const Site<dimension>& k) const {
        Place number = 0;
        for (std::size_t i = 0; i < dimension; ++i) {
            number = number * all_.length(i) + (k[i] - all_.first[i]);
        }
        return number;
    }

    /// Returns the number of rows of the inside.
    [[nodiscard]] Place inside_rows() const {
        return inside_.length(dimension - 1) == 0 ? 0 : inside_.rows();
    }

    /// Returns a row of the inside. Precondition: row < inside_rows().
    [[nodiscard]] RowPart<dimension> inside_row(Place row) const {
        const Site<dimension> k = inside_.row(row);
        return {number(k), k, inside_.length(dimension - 1)};
    }

    /// Calls f(e, k) for each site that is not inside.
    template <class F>
    void for_each_edge(F&& f) const {
        const std::size_t last = dimension - 1;
        for (Place row = 0; row < all_.rows(); ++row) {
            Site<dimension> k = all_.row(row);
            Place e = row * all_.length(last);
            k[last] = inside_.first[last];
            const bool crosses = inside_.has(k);
            for (k[last] = all_.first[last]; k[last] < all_.end[last]; ++k[last], ++e) {
                if (crosses && k[last] == inside_.first[last]) {
                    k[last] += inside_.length(last);
                    e += inside_.length(last);
                    if (k[last] == all_.end[last]) { break; }
                }
                f(e, k);
            }
        }
    }

private:
    Box<dimension> all_, inside_;
};

/// Number of sites in a register: more than one where there are registers for them.
template <class Scalar>
inline constexpr std::size_t sites_in_register = register_width<Scalar, 8>();

template <class Scalar, std::size_t count>
using SitesAtOnce = std::conditional_t<count == 1, Scalar, Lanes<Scalar, count>>;

/// Numbers that are computed at once. NOTE: of two registers one computes while the other waits.
template <class Scalar, std::size_t registers = 2>
using SiteLanes =
    SitesAtOnce<Scalar, sites_in_register<Scalar> == 1 ? 1 : registers * sites_in_register<Scalar>>;

/// Calls f(Stretch<V>(), e, k) for stretches that make up the part: as many as possible of
/// SiteLanes, then one register, then single numbers.
template <class Scalar, std::size_t registers = 2, std::size_t dimension, class F>
HVI_INLINE_IN_LANES inline void for_each_stretch(RowPart<dimension> part, F&& f) {
    using Wide = Stretch<SiteLanes<Scalar, registers>>;
    for (; part.count >= Wide::count; part.skip(Wide::count)) { f(Wide(), part.at, part.k); }
    if constexpr (Wide::count > 1) {
        using One = Stretch<SiteLanes<Scalar, 1>>;
        if (registers > 1 && part.count >= One::count) {
            f(One(), part.at, part.k);
            part.skip(One::count);
        }
        for (; part.count > 0; part.skip(1)) { f(Stretch<Scalar>(), part.at, part.k); }
    }
}

// ---- the components of sites ----

template <class V, class Scalar, std::size_t components>
HVI_INLINE_IN_LANES inline void load(const Scalar* from, Place count, V (&to)[components]) {
    for (std::size_t c = 0; c < components; ++c) {
        to[c] = Stretch<V>::load(from + static_cast<Place>(c) * count);
    }
}

template <class V, class Scalar, std::size_t components>
HVI_INLINE_IN_LANES inline void store(const V (&from)[components], Place count, Scalar* to) {
    for (std::size_t c = 0; c < components; ++c) {
        Stretch<V>::store(from[c], to + static_cast<Place>(c) * count);
    }
}

// ---- the gradient of H ----

/// Sets out = dU/dq at q. Both hold all components of all sites, and do not overlap.
template <class System>
void gather(const System& system, const typename System::Scalar* q, typename System::Scalar* out) {
    using Scalar = typename System::Scalar;
    const Sites<System::dimension> sites = system.sites();
    const Place count = sites.count();
    sites.for_each_edge([&](Place e, const Site<System::dimension>& k) {
        Scalar force[System::components];
        system.force_at_edge(q, e, k, force);
        store(force, count, out + e);
    });
    for (Place row = 0; row < sites.inside_rows(); ++row) {
        for_each_stretch<Scalar>(sites.inside_row(row),
                                 [&](auto stretch, Place e, const Site<System::dimension>& k) {
                                     ValueOf<decltype(stretch)> force[System::components];
                                     system.force(q, e, k, force);
                                     store(force, count, out + e);
                                 });
    }
}

/// Sets out = dT/dp at p. Both hold all components of all sites, and do not overlap.
template <class System>
void velocities(const System& system, const typename System::Scalar* p,
                typename System::Scalar* out) {
    using Scalar = typename System::Scalar;
    const Sites<System::dimension> sites = system.sites();
    const Place count = sites.count();
    const auto write = [&](auto stretch, Place e, const Site<System::dimension>& k) {
        using V = ValueOf<decltype(stretch)>;
        V momenta[System::components];
        V velocity[System::components];
        load(p + e, count, momenta);
        system.velocity(momenta, e, k, velocity);
        store(velocity, count, out + e);
    };
    sites.for_each_edge(
        [&](Place e, const Site<System::dimension>& k) { write(Stretch<Scalar>(), e, k); });
    for (Place row = 0; row < sites.inside_rows(); ++row) {
        for_each_stretch<Scalar>(sites.inside_row(row), write);
    }
}

}  // namespace hvi::detail
