// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/system.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

bool is_rotation(const SystemFamily& family) { return family.space == rotations_of_space; }

/// Returns the number of elements of a point. NOTE: with loops the numbers of a point are elements
/// of its family.
std::size_t point_count(const System& system, const SystemFamily& family) {
    if (family.ranges.empty()) { return 1; }
    std::map<std::string, long> values;
    for (const SystemSize& size : system.sizes) { values[size.name] = size.value; }
    return element_count(family, values) / family.space.point;
}

/// Returns the number of a degree of freedom of a system that is written out.
std::size_t degree_of(const System& system, const Access& access) {
    const std::size_t flat = flat_coordinates(system);
    return access.family < flat
               ? access.family
               : flat + rotations_of_space.tangent * (access.family - flat) + access.component;
}

std::vector<Scaled> derivatives(const System& system, const std::vector<AccessSlope>& slopes) {
    std::vector<Scaled> result(system.degrees_of_freedom(), Graph::number(0));
    for (const AccessSlope& slope : slopes) {
        result[degree_of(system, system.accesses[slope.access])] = slope.value;
    }
    return result;
}

std::vector<Node> nodes_of(const System& system, FamilyKind kind) {
    HVI_CHECK(system.is_written_out());
    std::vector<Node> result;
    for (const Access& access : system.accesses) {
        if (access.kind == kind) { result.push_back(access.node); }
    }
    return result;
}

const SystemSum& only(const std::vector<SystemSum>& sums) {
    HVI_CHECK(sums.size() == 1 && sums.front().loops.empty());
    return sums.front();
}

}  // namespace

bool has_linear_part(const Structure& quadratic) {
    const auto is_not_zero = [](const Scaled& slope) { return !slope.is_zero(); };
    return std::any_of(quadratic.by_q.begin(), quadratic.by_q.end(), is_not_zero) ||
           std::any_of(quadratic.by_p.begin(), quadratic.by_p.end(), is_not_zero);
}

bool is_degenerate(const Hessian& hessian) {
    return std::any_of(hessian.conjugates.begin(), hessian.conjugates.end(), [](const auto& row) {
        return std::all_of(row.begin(), row.end(), [](const Scaled& a) { return a.is_zero(); });
    });
}

std::size_t component_dimensions(const Space& space) {
    return space == rotations_of_space ? 2 : space == angular_momenta ? 1 : 0;
}

bool are_of_one_body(const SystemFamily& q, const SystemFamily& conjugate) {
    if (q.space.tangent != conjugate.space.point) { return false; }
    if (q.ranges.empty() && conjugate.ranges.empty()) { return true; }
    const auto of_bodies = [](const SystemFamily& family) {
        const std::size_t components = component_dimensions(family.space);
        HVI_CHECK(family.ranges.size() >= components);
        return std::vector<LoopRange>(
            family.ranges.begin(), family.ranges.end() - static_cast<std::ptrdiff_t>(components));
    };
    return of_bodies(q) == of_bodies(conjugate);
}

const SystemFamily& System::family(const Access& access) const {
    switch (access.kind) {
    case FamilyKind::coordinate:
    case FamilyKind::direction:
    case FamilyKind::turn: return coordinates.at(access.family);
    case FamilyKind::conjugate:
    case FamilyKind::direction_of_conjugate: return conjugates.at(access.family);
    case FamilyKind::table: break;
    }
    return tables.at(access.family).family;
}

bool System::is_written_out() const {
    return std::all_of(coordinates.begin(), coordinates.end(),
                       [](const SystemFamily& family) { return family.ranges.empty(); });
}

std::size_t System::degrees_of_freedom() const {
    std::size_t count = 0;
    for (const SystemFamily& each : coordinates) {
        count += each.space.tangent * point_count(*this, each);
    }
    return count;
}

std::size_t bodies_of(const System& system) {
    std::size_t count = 0;
    for (const SystemFamily& each : system.coordinates) {
        if (is_rotation(each)) { count += point_count(system, each); }
    }
    return count;
}

bool System::reads_files() const {
    const auto in_file = [](const auto& of) {
        return std::holds_alternative<NumbersInFile>(of.values);
    };
    return std::any_of(tables.begin(), tables.end(), in_file) ||
           std::any_of(initial.begin(), initial.end(), in_file);
}

std::vector<std::string> System::momentum_names() const {
    if (side == Side::lagrangian) { return momenta; }
    std::vector<std::string> names;
    for (const SystemFamily& each : conjugates) { names.push_back(each.name); }
    return names;
}

std::vector<Node> coordinate_nodes(const System& system) {
    return nodes_of(system, FamilyKind::coordinate);
}

std::vector<Node> conjugate_nodes(const System& system) {
    return nodes_of(system, FamilyKind::conjugate);
}

const Scaled& function_of(const System& system) { return only(system.sums).value; }

const Scaled& energy_of(const System& system) { return only(system.energy).value; }

const Scaled& value_of(const SystemValue& value) { return only(value.sums).value; }

std::vector<Scaled> by_coordinates(const System& system) {
    return derivatives(system, only(system.sums).by_q);
}

std::vector<Scaled> by_conjugates(const System& system) {
    return derivatives(system, only(system.sums).by_conjugates);
}

const Hessian& hessian_of(const System& system) { return std::get<Hessian>(system.second); }

std::vector<Scaled> start_of(const System& system) {
    std::vector<Scaled> result;
    for (const SystemStart& start : system.initial) {
        if (const auto* rule = std::get_if<SystemStart::Rule>(&start.values)) {
            result.push_back(rule->value);
        } else {
            const auto& list = std::get<SystemStart::List>(start.values);
            result.insert(result.end(), list.values.begin(), list.values.end());
        }
    }
    return result;
}

std::size_t rotations_of(const System& system) {
    return static_cast<std::size_t>(
        std::count_if(system.coordinates.begin(), system.coordinates.end(), is_rotation));
}

std::size_t flat_coordinates(const System& system) {
    return system.coordinates.size() - rotations_of(system);
}

std::vector<std::size_t> cyclic_coordinates(const System& system) {
    const std::vector<Scaled> slopes = by_coordinates(system);
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < flat_coordinates(system); ++i) {
        if (slopes[i].is_zero()) { result.push_back(i); }
    }
    return result;
}

Expression as_expression(const ElementIndex& index) {
    Expression form = as_expression(index.form);
    if (!index.modulus) { return form; }
    Expression mod = Expression::call("mod", {std::move(form), as_expression(*index.modulus)});
    if (index.offset == AffineForm{}) { return mod; }
    return Expression::sum({std::move(mod), as_expression(index.offset)});
}

std::size_t element_count(const SystemFamily& family, const std::map<std::string, long>& sizes) {
    long count = 1;
    for (const LoopRange& range : family.ranges) {
        count *= range.last.at(sizes) - range.first.at(sizes) + 1;
    }
    return static_cast<std::size_t>(count);
}

bool is_separable(const System& system) {
    const auto none_has = [&](const std::vector<AccessSlope>& slopes, Role role) {
        return std::none_of(slopes.begin(), slopes.end(), [&](const AccessSlope& slope) {
            return has(system.graph.at(slope.value.node).roles, role);
        });
    };
    return std::all_of(system.sums.begin(), system.sums.end(), [&](const SystemSum& sum) {
        return none_has(sum.by_q, Role::conjugate) && none_has(sum.by_conjugates, Role::coordinate);
    });
}

bool operator==(const System& left, const System& right) { return dump(left) == dump(right); }

}  // namespace hvi::gen
