// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_structure.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/accesses.hpp"
#include "generator/lower/accesses.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/totals.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

bool has_role(const System& system, const Scaled& value, Roles roles) {
    return (system.graph.at(value.node).roles & roles) != 0;
}

/// Returns whether T does not depend on time.
bool is_kinetic_autonomous(const System& system) {
    return std::all_of(system.sums.begin(), system.sums.end(), [&](const SystemSum& sum) {
        return std::none_of(
            sum.by_conjugates.begin(), sum.by_conjugates.end(), [&](const AccessSlope& slope) {
                return has_role(system, slope.value, static_cast<Roles>(Role::time));
            });
    });
}

// ---- T ----

enum class Kinetic { other, quadratic, diagonal };

/// Returns the form of one sum of T: whether each slope is a sum of constants times momenta, and
/// depends on its own momentum alone.
Kinetic kinetic(System& system, const SystemSum& sum) {
    Kinetic result = Kinetic::diagonal;
    const std::vector<std::size_t> momenta = accesses_of(sum.by_conjugates);
    for (const AccessSlope& slope : sum.by_conjugates) {
        const auto row = linear_form(system, slope.value, momenta);
        if (!row) { return Kinetic::other; }
        const bool is_alone = std::all_of(row->begin(), row->end(), [&](const AccessSlope& entry) {
            return entry.access == slope.access;
        });
        if (!is_alone) { result = Kinetic::quadratic; }
    }
    return result;
}

Kinetic kinetic(System& system) {
    Kinetic result = Kinetic::diagonal;
    for (const SystemSum& sum : system.sums) {
        if (!sum.by_conjugates.empty()) { result = std::min(result, kinetic(system, sum)); }
    }
    return result;
}

// ---- U ----

bool is_quadratic(System& system, const SystemSum& sum) {
    std::vector<Scaled> forces;
    for (const AccessSlope& slope : sum.by_q) {
        for (const AccessSlope& entry : slopes(system, slope.value, accesses_of(sum.by_q))) {
            if (has_role(system, entry.value, of_motion)) { return false; }
        }
        forces.push_back(slope.value);
    }
    return !has_kinks(system.graph, forces);
}

/// Returns whether an element determines the indices of all loops, so that it is in few summands:
/// each loop's index stands in one of its indices without those of other loops.
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

bool couples_few(const System& system, const SystemSum& sum) {
    return std::all_of(sum.by_q.begin(), sum.by_q.end(), [&](const AccessSlope& slope) {
        const Access& access = system.accesses[slope.access];
        return !access.indices.empty() && is_told_by(access, sum.loops);
    });
}

HessianForm hessian_form(const System& system, Kinetic kinetic, bool is_quadratic) {
    // NOTE: with a K that is not diagonal G K has more places than G.
    if (kinetic != Kinetic::diagonal) { return HessianForm::products; }
    if (system.sites && system.sites->ranges.size() == 1) { return HessianForm::band; }
    // NOTE: factors of a lattice in the plane take 2 to 5 times as long as the products that solve
    // the equations (64 x 64 to 128 x 128 sites, h omega = 6), and pay where they are kept.
    const bool are_few =
        is_quadratic && std::all_of(system.sums.begin(), system.sums.end(),
                                    [&](const SystemSum& sum) { return couples_few(system, sum); });
    return are_few ? HessianForm::sparse : HessianForm::products;
}

// ---- second derivatives ----

SumEntries second_entries(System& system, const SystemSum& sum) {
    SumEntries result{sum.loops, sum.accesses, {}};
    for (const AccessSlope& row : sum.by_q) {
        for (const AccessSlope& entry : slopes(system, row.value, accesses_of(sum.by_q))) {
            result.entries.push_back({row.access, entry.access, entry.value});
        }
    }
    return result;
}

/// Returns the element of the vector at the place of a variable, as an access.
std::size_t direction_of(System& system, std::size_t variable) {
    Access access = system.accesses[variable];
    access.kind = access.kind == FamilyKind::conjugate ? FamilyKind::direction_of_conjugate
                                                       : FamilyKind::direction;
    access.node =
        system.graph.input("way along " + system.graph.at(access.node).name, Role::direction).node;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        if (system.accesses[k].node == access.node) { return k; }
    }
    system.accesses.push_back(std::move(access));
    return system.accesses.size() - 1;
}

/// Returns the derivative of a sum along the vector; its own derivatives are the product.
SystemSum product_of(System& system, const SystemSum& sum) {
    SystemSum result{sum.loops, {}, {}, {}, {}};
    std::vector<Scaled> terms;
    for (const std::vector<AccessSlope>* each : {&sum.by_q, &sum.by_conjugates}) {
        for (const AccessSlope& slope : *each) {
            const std::size_t direction = direction_of(system, slope.access);
            terms.push_back(
                system.graph.product(slope.value, {{1, 1}, system.accesses[direction].node}));
        }
    }
    result.value = system.graph.sum(std::move(terms));
    result.accesses = accesses_in(system, {result.value});
    result.by_q = slopes(system, result.value, accesses_of(sum.by_q));
    result.by_conjugates = slopes(system, result.value, accesses_of(sum.by_conjugates));
    return result;
}

Structure structure_of_sums(System& system) {
    const bool has_totals = is_made_of_totals(system);
    Structure result;
    result.hessian = has_totals ? HessianForm::none : HessianForm::products;
    result.is_separable = is_separable(system) && is_kinetic_autonomous(system);
    if (!result.is_separable) { return result; }
    const Kinetic found = kinetic(system);
    result.kinetic_is_quadratic = found != Kinetic::other;
    result.has_diagonal_mass = found == Kinetic::diagonal;
    if (!result.kinetic_is_quadratic) { return result; }
    result.is_quadratic =
        !has_totals && std::all_of(system.sums.begin(), system.sums.end(),
                                   [&](const SystemSum& sum) { return is_quadratic(system, sum); });
    result.has_linear_map = result.is_quadratic && !system.time;
    if (!has_totals) { result.hessian = hessian_form(system, found, result.is_quadratic); }
    return result;
}

HessianOfSums second_order(System& system) {
    HessianOfSums result;
    const bool has_entries = system.structure.hessian != HessianForm::products;
    // NOTE: a copy, as accesses are added.
    const std::vector<SystemSum> sums = system.sums;
    for (const SystemSum& sum : sums) {
        SumEntries entries = has_entries ? second_entries(system, sum) : SumEntries{};
        if (!entries.entries.empty()) { result.entries.push_back(std::move(entries)); }
        SystemSum product = product_of(system, sum);
        if (product.by_q.empty() && product.by_conjugates.empty()) { continue; }
        result.products.push_back(std::move(product));
    }
    return result;
}

}  // namespace

/// NOTE: steps of rotations do not use the structure; see with_structure().
System with_structure_of_sums(System system) {
    if (rotations_of(system) > 0) {
        system.structure.hessian = HessianForm::none;
        return system;
    }
    system.structure = structure_of_sums(system);
    if (system.structure.hessian != HessianForm::none) { system.second = second_order(system); }
    return system;
}

}  // namespace hvi::gen
