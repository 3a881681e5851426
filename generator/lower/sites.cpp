// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/sites.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/collected.hpp"
#include "generator/lower/totals.hpp"

namespace hvi::gen {

namespace {

/// An index as the index of a loop plus a rest; no loop where it has another form.
struct Shifted {
    std::optional<std::size_t> loop;
    AffineForm rest;  ///< without the loop's index; for a mod the rest of its argument
};

std::optional<Shifted> shifted(const AffineForm& form, const std::vector<Loop>& loops) {
    Shifted result{std::nullopt, form};
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const long coefficient = form.coefficient(loops[l].index);
        if (coefficient == 0) { continue; }
        if (coefficient != 1 || result.loop) { return std::nullopt; }
        result.loop = l;
        result.rest.coefficients.erase(loops[l].index);
    }
    return result;
}

/// Returns a form reduced by whole moduli: i + N - 2 is i - 2 modulo N.
AffineForm reduced(AffineForm form, const AffineForm& modulus) {
    if (modulus.coefficients.empty()) { return form; }
    const auto& [name, per] = *modulus.coefficients.begin();
    const long times = form.coefficient(name) / per;
    return form - times * modulus;
}

/// Returns whether loops form a box: no bound has an index.
bool are_box(const std::vector<Loop>& loops) {
    return std::all_of(loops.begin(), loops.end(), [&](const Loop& inner) {
        return std::all_of(loops.begin(), loops.end(), [&](const Loop& outer) {
            return inner.range.first.coefficient(outer.index) == 0 &&
                   inner.range.last.coefficient(outer.index) == 0;
        });
    });
}

class SiteLowering {
public:
    explicit SiteLowering(System& system) : system_(system) {}

    /// Returns whether the system is a lattice; then the result is complete.
    [[nodiscard]] bool find() {
        // NOTE: sweeps over sites have no clock, and see near places alone.
        const bool is_local = !system_.time && !is_made_of_totals(system_);
        if (!have_equal_indices() || !is_separable(system_) || !is_local) { return false; }
        sites_.ranges = system_.coordinates.front().ranges;
        const std::size_t d = sites_.ranges.size();
        if (d < 1 || d > 3) { return false; }
        for (const LoopRange& range : sites_.ranges) {
            sites_.inside.push_back({{range.first}, {range.last}});
        }
        sites_.reach.assign(d, 0);
        for (std::size_t k = 0; k < d; ++k) {
            sites_.indices.push_back(
                system_.graph.input(fmt::format("index {} of a site", k), Role::index).node);
        }
        forces_.resize(system_.coordinates.size());
        velocities_.resize(system_.conjugates.size());
        for (std::size_t s = 0; s < system_.sums.size(); ++s) {
            if (!add(s)) { return false; }
        }
        for (auto& terms : forces_) { sites_.forces.push_back(system_.graph.sum(terms)); }
        for (auto& terms : velocities_) { sites_.velocities.push_back(system_.graph.sum(terms)); }
        // NOTE: terms of several sums meet at a site.
        sites_.forces = collected(system_.graph, sites_.forces);
        sites_.velocities = collected(system_.graph, sites_.velocities);
        return true;
    }

    [[nodiscard]] Sites result() && { return std::move(sites_); }

private:
    [[nodiscard]] bool have_equal_indices() const {
        const auto& families = system_.coordinates;
        return std::all_of(families.begin(), families.end(), [&](const SystemFamily& family) {
            return family.ranges == families.front().ranges;
        });
    }

    [[nodiscard]] bool add(std::size_t s) {
        // NOTE: a copy of the slopes, since the graph grows.
        const SystemSum sum = system_.sums[s];
        if (!are_box(sum.loops)) { return false; }
        return std::all_of(sum.by_q.begin(), sum.by_q.end(),
                           [&](const AccessSlope& slope) { return add_force(s, sum, slope); }) &&
               std::all_of(sum.by_conjugates.begin(), sum.by_conjugates.end(),
                           [&](const AccessSlope& slope) { return add_velocity(sum, slope); });
    }

    /// Returns the indices of an element in terms of the loops of its sum.
    [[nodiscard]] std::optional<std::vector<SiteIndex>> site_indices(const SystemSum& sum,
                                                                     const Access& access) {
        std::vector<SiteIndex> result;
        std::size_t found = 0;
        for (const ElementIndex& index : access.indices) {
            auto form = shifted(index.form, sum.loops);
            if (!form) { return std::nullopt; }
            if (index.modulus && !form->loop) { return std::nullopt; }
            const bool is_new =
                form->loop && std::none_of(result.begin(), result.end(), [&](const auto& other) {
                    return other.loop == form->loop;
                });
            if (form->loop && !is_new) { return std::nullopt; }
            if (is_new) { ++found; }
            AffineForm shift = form->rest;
            if (index.modulus) {
                const LoopRange& range = sum.loops[*form->loop].range;
                if (range.last - range.first + AffineForm{1} != *index.modulus) {
                    return std::nullopt;
                }
                shift = reduced(shift, *index.modulus) + index.offset;
            }
            result.push_back({form->loop, shift, index.modulus.has_value()});
        }
        return found == sum.loops.size() ? std::optional(std::move(result)) : std::nullopt;
    }

    [[nodiscard]] bool add_force(std::size_t s, const SystemSum& sum, const AccessSlope& slope) {
        const Access& access = system_.accesses[slope.access];
        auto indices = site_indices(sum, access);
        if (!indices) { return false; }
        sites_.terms.push_back({s, slope, access.family, *indices});
        if (std::any_of(indices->begin(), indices->end(),
                        [](const SiteIndex& index) { return !index.loop; })) {
            return leave_out(*indices);
        }
        bound_inside(sum, *indices);
        const auto inside = seen_from_site(sum, slope.value, *indices);
        if (!inside) { return false; }
        forces_[access.family].push_back(*inside);
        return true;
    }

    /// Leaves the first or the last value of an index, where a term stands alone, out of the
    /// inside.
    [[nodiscard]] bool leave_out(const std::vector<SiteIndex>& indices) {
        for (std::size_t d = 0; d < indices.size(); ++d) {
            if (indices[d].loop) { continue; }
            const auto& [first, last] = sites_.ranges[d];
            const AffineForm one{1};
            if (indices[d].shift == first) {
                sites_.inside[d].firsts.push_back(first + one);
                return true;
            }
            if (indices[d].shift == last) {
                sites_.inside[d].lasts.push_back(last - one);
                return true;
            }
        }
        return false;
    }

    void bound_inside(const SystemSum& sum, const std::vector<SiteIndex>& indices) {
        for (std::size_t d = 0; d < indices.size(); ++d) {
            const auto& [loop, shift, wraps] = indices[d];
            bound(d, sum.loops[*loop].range.first + shift, sum.loops[*loop].range.last + shift);
            for (const std::size_t a : sum.accesses) {
                for (const ElementIndex& other : system_.accesses[a].indices) {
                    if (!other.modulus) { continue; }
                    const auto form = shifted(other.form, sum.loops);
                    if (!form || form->loop != loop) { continue; }
                    // 0 <= i + c <= modulus - 1 for i = k - shift
                    const AffineForm c = reduced(form->rest, *other.modulus);
                    bound(d, shift - c, *other.modulus - AffineForm{1} + shift - c);
                }
            }
        }
    }

    void bound(std::size_t d, const AffineForm& first, const AffineForm& last) {
        auto& [firsts, lasts] = sites_.inside[d];
        if (std::find(firsts.begin(), firsts.end(), first) == firsts.end()) {
            firsts.push_back(first);
        }
        if (std::find(lasts.begin(), lasts.end(), last) == lasts.end()) { lasts.push_back(last); }
    }

    /// Returns a summand's value where the indices of its loops are those of the site less shifts.
    [[nodiscard]] std::optional<Scaled> seen_from_site(const SystemSum& sum, const Scaled& value,
                                                       const std::vector<SiteIndex>& indices) {
        Graph& graph = system_.graph;
        std::map<Node, Scaled> inputs;
        for (std::size_t d = 0; d < indices.size(); ++d) {
            const AffineForm& shift = indices[d].shift;
            if (!shift.is_number()) { return std::nullopt; }
            const Node index = graph.input(sum.loops[*indices[d].loop].index, Role::index).node;
            inputs[index] =
                graph.sum({{{1, 1}, sites_.indices[d]}, Graph::number(-shift.constant)});
        }
        for (const std::size_t a : sum.accesses) {
            const auto seen = seen_from_site(sum, system_.accesses[a], indices);
            if (!seen) { return std::nullopt; }
            inputs[system_.accesses[a].node] = {{1, 1}, *seen};
        }
        return replaced(graph, value, inputs);
    }

    [[nodiscard]] std::optional<Node> seen_from_site(const SystemSum& sum, const Access& access,
                                                     const std::vector<SiteIndex>& indices) {
        SiteAccess seen{access.kind, access.family, {}, {}, 0};
        std::string name = system_.family(access).name;
        for (const ElementIndex& index : access.indices) {
            const auto form = shifted(index.form, sum.loops);
            if (!form) { return std::nullopt; }
            AffineForm offset = form->rest;
            if (index.modulus) { offset = reduced(offset, *index.modulus) + index.offset; }
            std::optional<std::size_t> of;
            for (std::size_t d = 0; form->loop && d < indices.size(); ++d) {
                if (indices[d].loop != form->loop) { continue; }
                of = d;
                offset = offset - indices[d].shift;
            }
            seen.of.push_back(of);
            seen.offset.push_back(offset);
            name += fmt::format(" {}{}", of ? fmt::format("k{} + ", *of) : "", to_text(offset));
        }
        if (!is_reachable(seen)) { return std::nullopt; }
        return input(std::move(seen), name);
    }

    /// Returns whether lanes along the last index of sites find the element's neighbours in a row.
    [[nodiscard]] bool is_reachable(const SiteAccess& seen) {
        const std::size_t last = sites_.ranges.size() - 1;
        for (std::size_t d = 0; d < seen.of.size(); ++d) {
            if (seen.kind == FamilyKind::table) {
                if (seen.of[d] == last && d + 1 != seen.of.size()) { return false; }
                continue;
            }
            if (seen.of[d] != d || !seen.offset[d].is_number()) { return false; }
            sites_.reach[d] = std::max(sites_.reach[d], std::labs(seen.offset[d].constant));
        }
        return true;
    }

    [[nodiscard]] Node input(SiteAccess seen, const std::string& name) {
        const Role role = seen.kind == FamilyKind::coordinate  ? Role::coordinate
                          : seen.kind == FamilyKind::conjugate ? Role::conjugate
                                                               : Role::index;
        seen.node = system_.graph.input(name, role).node;
        const bool is_new =
            std::none_of(sites_.accesses.begin(), sites_.accesses.end(),
                         [&](const SiteAccess& other) { return other.node == seen.node; });
        const Node node = seen.node;
        if (is_new) { sites_.accesses.push_back(std::move(seen)); }
        return node;
    }

    /// Adds a velocity. NOTE: one formula for all sites, and so no neighbours.
    [[nodiscard]] bool add_velocity(const SystemSum& sum, const AccessSlope& slope) {
        const auto is_at_site = [&](const Access& access) {
            if (access.kind == FamilyKind::table) { return true; }
            const auto indices = site_indices(sum, access);
            if (!indices) { return false; }
            for (std::size_t d = 0; d < indices->size(); ++d) {
                const SiteIndex& index = (*indices)[d];
                const bool is_plain = index.loop && !index.wraps && index.shift == AffineForm{};
                if (!is_plain || sum.loops[*index.loop].range != sites_.ranges[d]) { return false; }
            }
            return true;
        };
        const Access& access = system_.accesses[slope.access];
        const bool is_local =
            std::all_of(sum.accesses.begin(), sum.accesses.end(),
                        [&](std::size_t a) { return is_at_site(system_.accesses[a]); });
        if (!is_local) { return false; }
        const auto value = seen_from_site(sum, slope.value, *site_indices(sum, access));
        if (!value) { return false; }
        velocities_[access.family].push_back(*value);
        return true;
    }

    System& system_;
    Sites sites_;
    std::vector<std::vector<Scaled>> forces_, velocities_;
};

}  // namespace

System with_sites(System system) {
    if (rotations_of(system) > 0) { return system; }
    SiteLowering lowering(system);
    if (lowering.find()) { system.sites = std::move(lowering).result(); }
    return system;
}

}  // namespace hvi::gen
