// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_legendre.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/accesses.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/taken_names.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

using Indices = std::vector<ElementIndex>;

/// The mass of each element of a family of velocities, as a function of its indices.
struct Mass {
    std::vector<std::string> indices;
    Scaled value = Graph::number(0);
};

class LegendreOfSums {
public:
    LegendreOfSums(System lagrangian, const Place& place)
        : system_(std::move(lagrangian)), place_(place), masses_(system_.conjugates.size()) {}

    [[nodiscard]] System operator()() && {
        if (!system_.totals.empty()) { refuse("here sums stand in products or functions"); }
        std::vector<SystemSum> potential;
        const std::vector<SystemSum> sums = std::exchange(system_.sums, {});
        for (const SystemSum& sum : sums) {
            if (sum.by_conjugates.empty()) {
                potential.push_back(negative(sum));
            } else {
                add_masses(sum);
            }
        }
        name_momenta();
        for (std::size_t f = 0; f < masses_.size(); ++f) { system_.sums.push_back(kinetic(f)); }
        for (SystemSum& sum : potential) { system_.sums.push_back(std::move(sum)); }
        for (SystemValue& invariant : system_.invariants) {
            for (SystemSum& sum : invariant.sums) { sum = in_momenta(std::move(sum)); }
        }
        for (std::size_t f = 0; f < masses_.size(); ++f) { start_with_momenta(f); }
        system_.side = Side::hamiltonian;
        system_.is_transformed = true;
        return differentiated(std::move(system_));
    }

private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw NoLoops("where sums stay loops, a Lagrangian is a sum of m v^2/2 over all its "
                      "velocities and of what depends on coordinates alone: " +
                          why,
                      place_, "write its Hamiltonian, or write sums out: --unroll yes");
    }

    [[nodiscard]] bool has_role(const Scaled& value, Roles roles) const {
        return (system_.graph.at(value.node).roles & roles) != 0;
    }

    [[nodiscard]] Scaled negative(const Scaled& value) {
        return system_.graph.times({-1, 1}, value);
    }

    [[nodiscard]] SystemSum negative(const SystemSum& sum) {
        return {sum.loops, negative(sum.value), {}, {}, {}};
    }

    // ---- masses ----

    /// Adds d2L/dv2 of a sum to the masses of its velocities.
    void add_masses(const SystemSum& sum) {
        if (!sum.by_q.empty() || has_role(sum.value, static_cast<Roles>(Role::time))) {
            refuse("here velocities stand beside coordinates or the time");
        }
        const std::vector<std::size_t> velocities = accesses_of(sum.by_conjugates);
        std::map<Node, Scaled> at_rest;
        for (const AccessSlope& slope : sum.by_conjugates) {
            const Access access = system_.accesses[slope.access];
            at_rest[access.node] = Graph::number(0);
            add_mass(access, mass_of(slope, velocities), sum.loops);
        }
        const Scaled constant = replaced(system_.graph, sum.value, at_rest);
        if (constant.is_zero()) { return; }
        system_.sums.push_back({sum.loops, negative(constant), {}, {}, {}});
    }

    /// Returns m of a slope m v.
    [[nodiscard]] Scaled mass_of(const AccessSlope& slope,
                                 const std::vector<std::size_t>& velocities) {
        const auto masses = linear_form(system_, slope.value, velocities);
        const bool is_alone =
            masses && std::all_of(masses->begin(), masses->end(), [&](const AccessSlope& mass) {
                return mass.access == slope.access;
            });
        if (!is_alone) {
            refuse("a kinetic energy is quadratic in each velocity, and couples none of them");
        }
        return masses->empty() ? Graph::number(0) : masses->front().value;
    }

    /// Returns the loops of the indices of an element, where each loop runs over one of its
    /// indices.
    [[nodiscard]] std::vector<std::string> loops_of(const Access& access,
                                                    const std::vector<Loop>& loops) const {
        const SystemFamily& family = system_.family(access);
        std::vector<std::string> result;
        for (std::size_t d = 0; d < access.indices.size(); ++d) {
            const ElementIndex& index = access.indices[d];
            const auto loop = std::find_if(loops.begin(), loops.end(), [&](const Loop& each) {
                return !index.modulus && index.form == AffineForm::of(each.index) &&
                       each.range == family.ranges[d];
            });
            const bool is_new = loop != loops.end() && std::find(result.begin(), result.end(),
                                                                 loop->index) == result.end();
            if (!is_new) { refuse("its sums run over all velocities of a name"); }
            result.push_back(loop->index);
        }
        if (result.size() != loops.size()) { refuse("its sums run over velocities once each"); }
        return result;
    }

    void add_mass(const Access& access, const Scaled& mass, const std::vector<Loop>& loops) {
        const std::vector<std::string> indices = loops_of(access, loops);
        Mass& all = masses_[access.family];
        if (all.value.is_zero()) {
            all = {indices, mass};
            return;
        }
        Indices same;
        for (const std::string& index : all.indices) { same.push_back({AffineForm::of(index)}); }
        const auto moved = at({indices, mass}, same);
        if (!moved) { refuse("two of its sums have indices that cannot be compared"); }
        all.value = system_.graph.sum({all.value, *moved});
    }

    // ---- at other indices ----

    /// Returns a whole number in the graph.
    [[nodiscard]] Scaled number(const AffineForm& form) {
        std::vector<Scaled> terms{Graph::number(form.constant)};
        for (const auto& [name, coefficient] : form.coefficients) {
            const bool is_size =
                std::any_of(system_.sizes.begin(), system_.sizes.end(),
                            [&, &known = name](const auto& size) { return size.name == known; });
            const Scaled input = system_.graph.input(name, is_size ? Role::parameter : Role::index);
            terms.push_back(system_.graph.times({coefficient, 1}, input));
        }
        return system_.graph.sum(std::move(terms));
    }

    /// Returns an index of a table, for other values of the indices of a mass.
    [[nodiscard]] std::optional<ElementIndex> at(const ElementIndex& index, const Mass& mass,
                                                 const Indices& target) const {
        for (std::size_t d = 0; d < target.size(); ++d) {
            const bool is_alone = !index.modulus && index.form == AffineForm::of(mass.indices[d]);
            if (is_alone) { return target[d]; }
        }
        // NOTE: all at once, as the names of both may be the same.
        ElementIndex result = index;
        const auto with_target = [&](const AffineForm& form) {
            AffineForm sum{form.constant};
            for (const auto& [name, coefficient] : form.coefficients) {
                const auto found = std::find(mass.indices.begin(), mass.indices.end(), name);
                const auto d = static_cast<std::size_t>(found - mass.indices.begin());
                sum = sum + coefficient * (found == mass.indices.end() ? AffineForm::of(name)
                                                                       : target[d].form);
            }
            return sum;
        };
        for (std::size_t d = 0; d < target.size(); ++d) {
            const bool depends = index.form.coefficient(mass.indices[d]) != 0;
            if (depends && target[d].modulus) { return std::nullopt; }
        }
        result.form = with_target(index.form);
        return result;
    }

    /// Returns the mass of the element with these indices; empty where no code can express it.
    [[nodiscard]] std::optional<Scaled> at(const Mass& mass, const Indices& target) {
        std::map<Node, Scaled> inputs;
        for (const std::size_t a : accesses_in(system_, {mass.value})) {
            const Access access = system_.accesses[a];
            Indices indices;
            for (const ElementIndex& index : access.indices) {
                const auto moved = at(index, mass, target);
                if (!moved) { return std::nullopt; }
                indices.push_back(*moved);
            }
            const std::size_t other =
                access_to(system_, access.kind, access.family, std::move(indices));
            inputs[access.node] = {{1, 1}, system_.accesses[other].node};
        }
        for (std::size_t d = 0; d < target.size(); ++d) {
            const Node index = system_.graph.input(mass.indices[d], Role::index).node;
            if (!depends_on(mass.value, index)) { continue; }
            if (target[d].modulus) { return std::nullopt; }
            inputs[index] = number(target[d].form);
        }
        return replaced(system_.graph, mass.value, inputs);
    }

    [[nodiscard]] bool depends_on(const Scaled& value, Node input) const {
        return kernel(system_.graph, {value}).uses[input] != 0;
    }

    // ---- H ----

    void name_momenta() {
        std::set<std::string> taken = taken_names(system_);
        for (const Mass& mass : masses_) { taken.insert(mass.indices.begin(), mass.indices.end()); }
        for (std::size_t f = 0; f < system_.conjugates.size(); ++f) {
            system_.conjugates[f].name = new_name("p_" + system_.coordinates[f].name, taken);
        }
    }

    /// Returns the momentum at these indices.
    [[nodiscard]] std::size_t momentum(std::size_t family, Indices indices) {
        return access_to(system_, FamilyKind::conjugate, family, std::move(indices));
    }

    /// Returns the sum of p^2/(2 m) over a family.
    [[nodiscard]] SystemSum kinetic(std::size_t f) {
        const Mass& mass = masses_[f];
        const SystemFamily& family = system_.conjugates[f];
        if (mass.value.is_zero()) { refuse("here a velocity has no mass"); }
        SystemSum sum;
        Indices indices;
        for (std::size_t d = 0; d < family.ranges.size(); ++d) {
            sum.loops.push_back({mass.indices[d], family.ranges[d]});
            indices.push_back({AffineForm::of(mass.indices[d])});
        }
        const std::size_t p = momentum(f, std::move(indices));
        const Scaled at{{1, 1}, system_.accesses[p].node};
        const Scaled velocity = system_.graph.product(at, system_.graph.inverse(mass.value));
        sum.value = system_.graph.times({1, 2}, system_.graph.product(at, velocity));
        return sum;
    }

    /// Returns an invariant, with p/m in place of v.
    [[nodiscard]] SystemSum in_momenta(SystemSum sum) {
        std::map<Node, Scaled> inputs;
        for (const std::size_t a : sum.accesses) {
            const Access access = system_.accesses[a];
            if (access.kind != FamilyKind::conjugate) { continue; }
            const auto mass = at(masses_[access.family], access.indices);
            if (!mass) { refuse("an invariant has velocities at places where no mass is known"); }
            const Scaled p{{1, 1}, system_.accesses[momentum(access.family, access.indices)].node};
            inputs[access.node] = system_.graph.product(p, system_.graph.inverse(*mass));
        }
        const Scaled value = replaced(system_.graph, sum.value, inputs);
        return {std::move(sum.loops), value, {}, {}, {}};
    }

    // ---- initial values ----

    [[nodiscard]] Scaled momentum_at_start(std::size_t f, const Scaled& velocity,
                                           const Indices& indices) {
        return system_.graph.product(*at(masses_[f], indices), velocity);
    }

    /// Turns the initial velocities of a family into momenta.
    void start_with_momenta(std::size_t f) {
        SystemStart& start = system_.initial[system_.coordinates.size() + f];
        if (auto* rule = std::get_if<SystemStart::Rule>(&start.values)) {
            Indices indices;
            for (const std::string& index : rule->indices) {
                indices.push_back({AffineForm::of(index)});
            }
            rule->value = momentum_at_start(f, rule->value, indices);
        } else if (auto* list = std::get_if<SystemStart::List>(&start.values)) {
            start_with_list(f, *list);
        } else {
            refuse("here velocities begin as a file has them");
        }
    }

    /// NOTE: the last index runs fastest.
    void start_with_list(std::size_t f, SystemStart::List& list) {
        std::map<std::string, long> sizes;
        for (const SystemSize& size : system_.sizes) { sizes[size.name] = size.value; }
        const std::vector<LoopRange>& ranges = system_.conjugates[f].ranges;
        std::vector<long> place;
        for (const LoopRange& range : ranges) { place.push_back(range.first.at(sizes)); }
        for (Scaled& value : list.values) {
            Indices indices;
            for (const long index : place) { indices.push_back({AffineForm{index}}); }
            value = momentum_at_start(f, value, indices);
            for (std::size_t d = place.size(); d-- > 0;) {
                if (++place[d] <= ranges[d].last.at(sizes)) { break; }
                place[d] = ranges[d].first.at(sizes);
            }
        }
    }

    System system_;
    const Place& place_;
    std::vector<Mass> masses_;
};

}  // namespace

System legendre_transform(System lagrangian, const Place& place) {
    return LegendreOfSums(std::move(lagrangian), place)();
}

}  // namespace hvi::gen
