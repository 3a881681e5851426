// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/tangent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "generator/lower/accesses.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/energy.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/taken_names.hpp"
#include "generator/lower/totals.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Families = std::vector<SystemFamily>;
using Starts = std::vector<SystemStart>;

class TangentOfSystem {
public:
    /// `parameter`: the motion is differentiated by it; without it, by the initial values.
    explicit TangentOfSystem(System system, std::optional<Node> parameter = {})
        : system_(with_energy(std::move(system))),
          parameter_(parameter),
          n_(system_.coordinates.size()),
          taken_(taken_names(system_)) {}

    [[nodiscard]] System operator()() && {
        system_.invariants.clear();
        system_.description = fmt::format(
            "K = d{0}/dq dq + d{0}/d{1} d{1}: the motion of {0}, and a direction along it",
            system_.function_letter(), system_.conjugate_letter());
        keep_totals_of_function();
        const Sums sums = std::exchange(system_.sums, {});
        add_families();
        add_accesses();
        add_totals();
        system_.sums = along(sums);
        for (SystemSum& sum : system_.energy) {
            sum = {sum.loops, sum.value, accesses_in(system_, {sum.value}), {}, {}};
        }
        set_starts();
        return differentiated(std::move(system_));
    }

private:
    using Sums = std::vector<SystemSum>;

    /// Adds the families of directions, `d_x` for x: coordinates (q, dq), and the momenta (dp, p).
    /// For an L the velocities are (v, dv), as v goes with q.
    void add_families() {
        system_.coordinates = joined(system_.coordinates, directions_of(system_.coordinates));
        const Families directions = directions_of(system_.conjugates);
        system_.conjugates = has_velocities() ? joined(system_.conjugates, directions)
                                              : joined(directions, system_.conjugates);
        std::vector<std::string> momenta;
        for (const std::string& name : system_.momenta) {
            momenta.push_back(new_name("d_" + name, taken_));
        }
        system_.momenta.insert(system_.momenta.begin(), momenta.begin(), momenta.end());
    }

    [[nodiscard]] bool has_velocities() const { return system_.side == Side::lagrangian; }

    [[nodiscard]] static Families joined(Families first, const Families& second) {
        first.insert(first.end(), second.begin(), second.end());
        return first;
    }

    [[nodiscard]] Families directions_of(Families families) {
        for (SystemFamily& family : families) {
            family.name = new_name("d_" + family.name, taken_);
        }
        return families;
    }

    /// Adds a direction for each element of a variable. NOTE: in the order of the families, which
    /// is that of the accesses in a system that is written out.
    void add_accesses() {
        const std::vector<Access> before = std::exchange(system_.accesses, {});
        const auto keep = [&](FamilyKind kind, std::size_t shift) {
            for (Access access : before) {
                if (access.kind != kind) { continue; }
                access.family += shift;
                system_.accesses.push_back(std::move(access));
            }
        };
        const auto add_directions = [&](FamilyKind kind, std::size_t shift) {
            for (std::size_t a = 0; a < before.size(); ++a) {
                if (before[a].kind != kind) { continue; }
                const std::size_t direction =
                    access_to(system_, kind, before[a].family + shift, before[a].indices);
                directions_[a] = system_.accesses[direction].node;
            }
        };
        keep(FamilyKind::coordinate, 0);
        add_directions(FamilyKind::coordinate, n_);
        if (has_velocities()) {
            keep(FamilyKind::conjugate, 0);
            add_directions(FamilyKind::conjugate, n_);
        } else {
            add_directions(FamilyKind::conjugate, 0);
            keep(FamilyKind::conjugate, n_);
        }
        keep(FamilyKind::table, 0);
    }

    /// Keeps the totals of the function. NOTE: invariants have totals of their own.
    void keep_totals_of_function() {
        system_.totals = totals_in(system_, system_.sums);
        std::reverse(system_.totals.begin(), system_.totals.end());
    }

    /// Adds the derivative of each total along the direction, as a total behind all of them.
    void add_totals() {
        const std::vector<SystemTotal> before = system_.totals;
        for (const SystemTotal& total : before) {
            Sums sums = along(total.sums);
            if (sums.empty()) { continue; }
            const std::string name = "change of " + system_.graph.at(total.node).name;
            const Roles roles = roles_of_total(system_.graph, sums);
            const Node change = system_.graph.input(name, roles).node;
            changes_.emplace_back(total.node, change);
            system_.totals.push_back({change, std::move(sums)});
        }
    }

    /// Returns the derivatives of sums along the direction. NOTE: zero sums are left out, except
    /// the only one of a system that is written out.
    [[nodiscard]] Sums along(const Sums& sums) {
        Sums result;
        for (const SystemSum& sum : sums) {
            const Scaled value = along(sum);
            if (value.is_zero() && !system_.is_written_out()) { continue; }
            result.push_back({sum.loops, value, {}, {}, {}});
        }
        return result;
    }

    /// Returns the derivative of a summand, through totals too.
    [[nodiscard]] Scaled along(const SystemSum& sum) {
        std::vector<Scaled> terms;
        for (const auto* slopes : {&sum.by_q, &sum.by_conjugates}) {
            for (const AccessSlope& slope : *slopes) {
                const Node direction = directions_.at(slope.access);
                terms.push_back(system_.graph.product(slope.value, {{1, 1}, direction}));
            }
        }
        if (parameter_) { terms.push_back(by_parameter(sum.value)); }
        for (const auto& [total, change] : changes_) {
            const Scaled slope = gradient(system_.graph, sum.value, {total}).front();
            terms.push_back(system_.graph.product(slope, {{1, 1}, change}));
        }
        return system_.graph.sum(std::move(terms));
    }

    [[nodiscard]] Scaled by_parameter(const Scaled& value) {
        return gradient(system_.graph, value, {*parameter_}).front();
    }

    /// Returns the initial values of the direction of a family with these initial values.
    [[nodiscard]] SystemStart start_of_direction(const SystemFamily& family,
                                                 const SystemStart& start) {
        if (!parameter_) { return at_zero(family); }
        return std::visit([&](const auto& values) { return by_parameter(family, values); },
                          start.values);
    }

    SystemStart by_parameter(const SystemFamily&, SystemStart::Rule rule) {
        rule.value = by_parameter(rule.value);
        rule.accesses = accesses_in(system_, {rule.value});
        return {std::move(rule)};
    }
    SystemStart by_parameter(const SystemFamily& family, const NumbersInFile&) {
        return at_zero(family);
    }
    SystemStart by_parameter(const SystemFamily& family, const SystemStart::MinusEnergy&) {
        HVI_CHECK(false && "steps compute -H, and nothing differentiates it");
        return at_zero(family);
    }
    template <class Values>
    SystemStart by_parameter(const SystemFamily&, Values all) {
        for (Scaled& value : all.values) { value = by_parameter(value); }
        all.accesses = accesses_in(system_, all.values);
        return {std::move(all)};
    }

    /// Returns the initial values of a direction that begins at 0.
    [[nodiscard]] SystemStart at_zero(const SystemFamily& family) {
        SystemStart::Rule zero{{}, Graph::number(0)};
        std::set<std::string> taken = taken_;
        for (std::size_t d = 0; d < family.ranges.size(); ++d) {
            zero.indices.push_back(new_name("i", taken));
        }
        return {std::move(zero)};
    }

    /// Sets initial values. NOTE: directions are the second and the third quarter; for an L the
    /// second and the last.
    void set_starts() {
        if (system_.initial.empty()) { return; }
        const Starts before = std::exchange(system_.initial, {});
        const auto half = before.begin() + static_cast<std::ptrdiff_t>(n_);
        Starts of_q, of_conjugates;
        for (std::size_t k = 0; k < n_; ++k) {
            const SystemFamily& family = system_.coordinates[k];
            of_q.push_back(start_of_direction(family, before[k]));
            of_conjugates.push_back(start_of_direction(family, before[n_ + k]));
        }
        Starts& all = system_.initial;
        all.assign(before.begin(), half);
        all.insert(all.end(), of_q.begin(), of_q.end());
        all.insert(all.end(), half, before.end());
        all.insert(has_velocities() ? all.end() : all.begin() + 2 * (half - before.begin()),
                   of_conjugates.begin(), of_conjugates.end());
    }

    System system_;
    std::optional<Node> parameter_;
    std::size_t n_;  ///< number of families of coordinates
    std::set<std::string> taken_;
    std::map<std::size_t, Node> directions_;  ///< of the accesses of the system without directions
    std::vector<std::pair<Node, Node>> changes_;  ///< totals, and their derivatives
};

}  // namespace

System with_tangent(System system) {
    HVI_CHECK(rotations_of(system) == 0);
    return TangentOfSystem(std::move(system))();
}

System with_sensitivity(System system, const std::string& parameter) {
    HVI_CHECK(rotations_of(system) == 0);
    const auto found =
        std::find_if(system.parameters.begin(), system.parameters.end(),
                     [&](const SystemParameter& candidate) { return candidate.name == parameter; });
    HVI_CHECK(found != system.parameters.end());
    const Node node = found->node;
    return TangentOfSystem(std::move(system), node)();
}

}  // namespace hvi::gen
