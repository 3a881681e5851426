// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_hessian.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/derivative.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

bool depends_on_state(const LoopSystem& system, const Scaled& value) {
    return (system.graph.at(value.node).roles & of_state) != 0;
}

/// The derivatives of a slope by the elements of other slopes of its sum.
std::vector<Scaled> second(LoopSystem& system, const Scaled& slope,
                           const std::vector<AccessSlope>& by) {
    std::vector<Node> inputs;
    for (const AccessSlope& each : by) { inputs.push_back(system.accesses[each.access].node); }
    return gradient(system.graph, slope, inputs);
}

// ---- T ----

enum class Kinetic { other, quadratic, diagonal };

/// Of one sum: whether each slope is the sum of constants times momenta, and of its own alone.
Kinetic kinetic(LoopSystem& system, const LoopSum& sum) {
    // NOTE: a copy, as the graph grows.
    const std::vector<AccessSlope> slopes = sum.by_momenta;
    Kinetic result = Kinetic::diagonal;
    for (std::size_t a = 0; a < slopes.size(); ++a) {
        const std::vector<Scaled> row = second(system, slopes[a].value, slopes);
        std::vector<Scaled> terms{{-slopes[a].value.factor, slopes[a].value.node}};
        for (std::size_t b = 0; b < row.size(); ++b) {
            if (row[b].is_zero()) { continue; }
            if (depends_on_state(system, row[b])) { return Kinetic::other; }
            if (a != b) { result = Kinetic::quadratic; }
            terms.push_back(
                system.graph.product(row[b], {{1, 1}, system.accesses[slopes[b].access].node}));
        }
        if (!system.graph.sum(std::move(terms)).is_zero()) { return Kinetic::other; }
    }
    return result;
}

Kinetic kinetic(LoopSystem& system) {
    Kinetic result = Kinetic::diagonal;
    for (const LoopSum& sum : system.sums) {
        if (!sum.by_momenta.empty()) { result = std::min(result, kinetic(system, sum)); }
    }
    return result;
}

// ---- U ----

bool is_quadratic(LoopSystem& system, const LoopSum& sum) {
    const std::vector<AccessSlope> slopes = sum.by_q;
    for (const AccessSlope& slope : slopes) {
        for (const Scaled& entry : second(system, slope.value, slopes)) {
            if (depends_on_state(system, entry)) { return false; }
        }
    }
    return true;
}

/// Whether an element is told by the indices of all loops, so that it is in few summands: each
/// loop's index stands in one of its indices without those of others.
bool is_told_by(const Access& access, const std::vector<Loop>& loops) {
    const auto has = [](const ElementIndex& index, const Loop& loop) {
        return index.form.coefficient(loop.index) != 0;
    };
    return std::all_of(loops.begin(), loops.end(), [&](const Loop& loop) {
        return std::any_of(
            access.indices.begin(), access.indices.end(), [&](const ElementIndex& index) {
                return has(index, loop) &&
                       std::count_if(loops.begin(), loops.end(),
                                     [&](const Loop& each) { return has(index, each); }) == 1;
            });
    });
}

bool couples_few(const LoopSystem& system, const LoopSum& sum) {
    return std::all_of(sum.by_q.begin(), sum.by_q.end(), [&](const AccessSlope& slope) {
        const Access& access = system.accesses[slope.access];
        return !access.indices.empty() && is_told_by(access, sum.loops);
    });
}

HessianForm hessian_form(const LoopSystem& system, const std::optional<SiteSystem>& sites,
                         Kinetic kinetic, bool is_quadratic) {
    // NOTE: with a K that is not diagonal G K has more places than G.
    if (kinetic != Kinetic::diagonal) { return HessianForm::products; }
    if (sites && sites->ranges.size() == 1) { return HessianForm::band; }
    // NOTE: factors of a lattice in the plane take 2 to 5 times as long as the products that solve
    // the equations (64 x 64 to 128 x 128 sites, h omega = 6), and pay where they are kept.
    const bool are_few =
        is_quadratic && std::all_of(system.sums.begin(), system.sums.end(),
                                    [&](const LoopSum& sum) { return couples_few(system, sum); });
    return are_few ? HessianForm::sparse : HessianForm::products;
}

std::size_t degrees_of_freedom(const LoopSystem& system) {
    std::map<std::string, long> sizes;
    for (const LoopSize& size : system.sizes) { sizes[size.name] = size.value; }
    long count = 0;
    for (const LoopFamily& family : system.coordinates) {
        long elements = 1;
        for (const LoopRange& range : family.ranges) {
            elements *= range.last.at(sizes) - range.first.at(sizes) + 1;
        }
        count += elements;
    }
    return static_cast<std::size_t>(count);
}

// ---- second derivatives ----

LoopEntries entries_of(LoopSystem& system, const LoopSum& sum) {
    LoopEntries result{sum.loops, sum.accesses, {}};
    const std::vector<AccessSlope> slopes = sum.by_q;
    for (const AccessSlope& row : slopes) {
        const std::vector<Scaled> values = second(system, row.value, slopes);
        for (std::size_t b = 0; b < values.size(); ++b) {
            if (values[b].is_zero()) { continue; }
            result.entries.push_back({row.access, slopes[b].access, values[b]});
        }
    }
    return result;
}

/// The element of the vector at the place of a coordinate, among the accesses.
std::size_t direction_of(LoopSystem& system, std::size_t coordinate) {
    Access access = system.accesses[coordinate];
    access.kind = FamilyKind::direction;
    access.node =
        system.graph.input("way along " + system.graph.at(access.node).name, Role::direction).node;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        if (system.accesses[k].node == access.node) { return k; }
    }
    system.accesses.push_back(std::move(access));
    return system.accesses.size() - 1;
}

/// The derivative of U along the vector, whose derivatives by coordinates are the product.
LoopSum product_of(LoopSystem& system, const LoopSum& sum) {
    LoopSum result{sum.loops, {}, sum.accesses, {}, {}};
    const std::vector<AccessSlope> slopes = sum.by_q;
    std::vector<Scaled> terms;
    for (const AccessSlope& slope : slopes) {
        const std::size_t direction = direction_of(system, slope.access);
        result.accesses.push_back(direction);
        terms.push_back(
            system.graph.product(slope.value, {{1, 1}, system.accesses[direction].node}));
    }
    result.value = system.graph.sum(std::move(terms));
    const std::vector<Scaled> values = second(system, result.value, slopes);
    for (std::size_t a = 0; a < slopes.size(); ++a) {
        if (!values[a].is_zero()) { result.by_q.push_back({slopes[a].access, values[a]}); }
    }
    return result;
}

}  // namespace

SystemProperties properties(LoopSystem& system, const std::optional<SiteSystem>& sites) {
    SystemProperties result;
    result.has_any_size = true;
    result.degrees_of_freedom = degrees_of_freedom(system);
    result.is_separable = system.is_separable();
    if (!result.is_separable) { return result; }
    const Kinetic found = kinetic(system);
    result.kinetic_is_quadratic = found != Kinetic::other;
    result.has_diagonal_mass = found == Kinetic::diagonal;
    if (!result.kinetic_is_quadratic) { return result; }
    result.has_linear_map =
        std::all_of(system.sums.begin(), system.sums.end(),
                    [&](const LoopSum& sum) { return is_quadratic(system, sum); });
    result.hessian = hessian_form(system, sites, found, result.has_linear_map);
    return result;
}

LoopHessian loop_hessian(LoopSystem& system, HessianForm form) {
    HVI_CHECK(form != HessianForm::dense);
    LoopHessian result;
    for (const LoopSum& sum : system.sums) {
        if (sum.by_q.empty()) { continue; }
        if (form == HessianForm::products) {
            LoopSum product = product_of(system, sum);
            if (!product.by_q.empty()) { result.products.push_back(std::move(product)); }
        } else {
            LoopEntries entries = entries_of(system, sum);
            if (!entries.entries.empty()) { result.entries.push_back(std::move(entries)); }
        }
    }
    return result;
}

}  // namespace hvi::gen
