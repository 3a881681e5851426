// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

std::string text(Node node) { return "#" + std::to_string(node); }

std::string text(const SmallFraction& factor) {
    const std::string above = std::to_string(factor.above);
    return factor.below == 1 ? above : above + "/" + std::to_string(factor.below);
}

std::string text(const Scaled& value) {
    if (value.is_zero()) { return "0"; }
    return value.factor == SmallFraction{1, 1} ? text(value.node)
                                               : text(value.factor) + " " + text(value.node);
}

std::string joined(const auto& values) {
    std::string result;
    for (const auto& value : values) { result += " " + text(value); }
    return result;
}

std::string text(const Computation& node) {
    switch (node.operation) {
    case Operation::constant: return to_text(node.constant);
    case Operation::input: return node.name;
    case Operation::sum: return "sum" + joined(node.terms);
    case Operation::product: return "product" + joined(node.arguments);
    case Operation::inverse: return "inverse" + joined(node.arguments);
    case Operation::square_root: return "square root" + joined(node.arguments);
    case Operation::inverse_square_root: return "inverse square root" + joined(node.arguments);
    case Operation::power: return "power" + joined(node.arguments);
    case Operation::call: return node.name + joined(node.arguments);
    }
    HVI_CHECK(false);
    return {};
}

std::string line(const std::string& name, const std::string& value) {
    return name + ": " + value + "\n";
}

std::string names(const std::vector<std::string>& all) {
    std::string result;
    for (const std::string& name : all) { result += (result.empty() ? "" : " ") + name; }
    return result;
}

/// Returns lines of the entries that are not zero; `second` is d2H or d2L.
std::string lines(const std::string& second, const HessianBlock& block,
                  const std::vector<std::string>& rows, const std::vector<std::string>& columns) {
    std::string result;
    for (std::size_t i = 0; i < block.size(); ++i) {
        for (std::size_t j = 0; j < block[i].size(); ++j) {
            if (block[i][j].is_zero()) { continue; }
            result += line(second + "/d" + rows[i] + " d" + columns[j], text(block[i][j]));
        }
    }
    return result;
}

std::vector<std::string> names_of(const Graph& graph, const std::vector<Node>& inputs) {
    std::vector<std::string> result;
    for (const Node node : inputs) { result.push_back(graph.at(node).name); }
    return result;
}

/// Returns the degrees of freedom that derivatives are by: coordinates, and turns of bodies, `R~1`.
std::vector<std::string> names_of_degrees(const System& system) {
    std::vector<std::string> result;
    for (const SystemFamily& family : system.coordinates) {
        if (family.space == real_line) {
            result.push_back(family.name);
            continue;
        }
        for (std::size_t k = 1; k <= family.space.tangent; ++k) {
            result.push_back(family.name + "~" + std::to_string(k));
        }
    }
    return result;
}

std::vector<std::string> names_of_conjugates(const System& system) {
    return names_of(system.graph, conjugate_nodes(system));
}

/// Returns lines of the blocks of second derivatives; `second` is d2H or d2L.
std::string lines(const std::string& second, const Hessian& all, const System& system) {
    const std::vector<std::string> q = names_of_degrees(system);
    const std::vector<std::string> y = names_of_conjugates(system);
    return lines(second, all.qq, q, q) + lines(second, all.mixed, q, y) +
           lines(second, all.conjugates, y, y);
}

std::string lines(const ConstantTerms& constant, const System& system) {
    std::string result;
    if (const auto* stiff = std::get_if<std::vector<LinearStiffness>>(&constant)) {
        for (const LinearStiffness& each : *stiff) {
            result +=
                line("stiffness " + system.coordinates[each.component].name, text(each.value));
        }
    }
    const auto* all = std::get_if<Hessian>(&constant);
    return all == nullptr ? result : lines("constant d2H", *all, system);
}

std::string found(const System& system) {
    const Structure& structure = system.structure;
    const std::string f(1, system.function_letter()), y(1, system.conjugate_letter());
    std::string result;
    const auto add = [&](bool holds, const std::string& what) {
        if (holds) { result += line("found", what); }
    };
    add(structure.is_separable, f + " = T(" + y + ") + U(q)");
    add(structure.kinetic_is_quadratic, "T is quadratic");
    add(structure.has_diagonal_mass, "K is diagonal");
    result += lines(structure.constant, system);
    add(structure.is_quadratic, f + " is quadratic");
    add(structure.is_linear_in_p, f + " is linear in " + y);
    add(structure.is_linear_in_q, f + " is linear in q");
    add(system.time.has_value(), f + " depends on the time");
    return result;
}

std::string derivatives(const System& system) {
    const std::string f(1, system.function_letter());
    const std::vector<std::string> q = names_of_degrees(system);
    const std::vector<std::string> y = names_of_conjugates(system);
    const std::vector<Scaled> by_q = by_coordinates(system), by_y = by_conjugates(system);
    std::string result = line(f, text(function_of(system)));
    for (std::size_t i = 0; i < q.size(); ++i) {
        result += line("d" + f + "/d" + q[i], text(by_q[i]));
    }
    for (std::size_t i = 0; i < y.size(); ++i) {
        result += line("d" + f + "/d" + y[i], text(by_y[i]));
    }
    result += lines("d2" + f, hessian_of(system), system);
    return system.side == Side::hamiltonian ? result
                                            : result + line("energy", text(energy_of(system)));
}

// ---- sums with loops ----

std::string text(const LoopRange& range) {
    return to_text(range.first) + ".." + to_text(range.last);
}

std::string text(const ElementIndex& index) {
    if (!index.modulus) { return to_text(index.form); }
    const std::string rest = "mod(" + to_text(index.form) + ", " + to_text(*index.modulus) + ")";
    return index.offset == AffineForm{} ? rest : rest + " + " + to_text(index.offset);
}

/// Returns `x[i + 1]`, with its kind: a coordinate, or the direction at one.
std::string text(const System& system, const Access& access) {
    std::string indices;
    for (const ElementIndex& index : access.indices) {
        indices += (indices.empty() ? "[" : ",") + text(index);
    }
    const std::string name = system.family(access).name + (indices.empty() ? "" : indices + "]");
    const bool is_direction =
        access.kind == FamilyKind::direction || access.kind == FamilyKind::direction_of_conjugate;
    return is_direction ? "direction at " + name : name;
}

std::string text(const SystemFamily& family) {
    std::string indices;
    for (const LoopRange& range : family.ranges) {
        indices += (indices.empty() ? "[" : ",") + text(range);
    }
    return family.name + (indices.empty() ? "" : indices + "]");
}

std::string text(const std::vector<SystemFamily>& families) {
    std::vector<std::string> texts;
    for (const SystemFamily& family : families) { texts.push_back(text(family)); }
    return names(texts);
}

/// Returns `i = 1..N - 1, j = i + 1..N`.
std::string text(const std::vector<Loop>& loops) {
    std::string result;
    for (const Loop& loop : loops) {
        result += (result.empty() ? "" : ", ") + loop.index + " = " + text(loop.range);
    }
    return result;
}

std::string lines(const System& system, const std::string& what,
                  const std::vector<SystemSum>& sums) {
    std::string result;
    for (const SystemSum& sum : sums) {
        const std::string over = sum.loops.empty() ? "" : " over " + text(sum.loops);
        result += line(what + over, text(sum.value));
        for (const auto* slopes : {&sum.by_q, &sum.by_conjugates}) {
            for (const AccessSlope& slope : *slopes) {
                result +=
                    line("  by " + text(system, system.accesses[slope.access]), text(slope.value));
            }
        }
    }
    return result;
}

std::string lines(const System& system, const HessianOfSums& second) {
    std::string result;
    for (const SumEntries& sum : second.entries) {
        for (const SumEntry& entry : sum.entries) {
            result +=
                line("d2H/d" + text(system, system.accesses[entry.row]) + " d" +
                         text(system, system.accesses[entry.column]) + " over " + text(sum.loops),
                     text(entry.value));
        }
    }
    return result + lines(system, "along the direction", second.products);
}

std::string text(const System& system, const SystemStart& start) {
    if (const auto* rule = std::get_if<SystemStart::Rule>(&start.values)) {
        return names(rule->indices) + (rule->indices.empty() ? "" : ": ") + text(rule->value);
    }
    if (const auto* list = std::get_if<SystemStart::List>(&start.values)) {
        return std::to_string(list->values.size()) + " values:" + joined(list->values);
    }
    if (const auto* points = std::get_if<SystemStart::Points>(&start.values)) {
        return names(points->indices) + (points->indices.empty() ? "points:" : ": points:") +
               joined(points->values);
    }
    if (std::holds_alternative<SystemStart::MinusEnergy>(start.values)) { return "-H"; }
    const auto& file = std::get<NumbersInFile>(start.values);
    return "in " + (system.directory / file.path).string() + " " + file.column;
}

std::string with_loops(const System& system) {
    std::string result;
    for (const SystemTotal& total : system.totals) {
        result += lines(system, "total " + text(total.node), total.sums);
    }
    result += lines(system, std::string(1, system.function_letter()), system.sums);
    if (system.side == Side::lagrangian) { result += lines(system, "energy", system.energy); }
    if (const auto* second = std::get_if<HessianOfSums>(&system.second)) {
        result += lines(system, *second);
    }
    for (std::size_t k = 0; system.sites && k < system.sites->forces.size(); ++k) {
        result +=
            line("force on a site, " + system.coordinates[k].name, text(system.sites->forces[k]));
        result += line("velocity of a site, " + system.conjugates[k].name,
                       text(system.sites->velocities[k]));
    }
    return result;
}

std::string starts(const System& system) {
    std::string result;
    if (system.is_written_out() && !system.initial.empty()) {
        std::vector<Node> inputs = coordinate_nodes(system);
        const std::vector<Node> others = conjugate_nodes(system);
        inputs.insert(inputs.end(), others.begin(), others.end());
        const std::vector<Scaled> values = start_of(system);
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            result += line("initial " + system.graph.at(inputs[k]).name, text(values[k]));
        }
        return result;
    }
    const std::size_t count = system.coordinates.size();
    for (std::size_t k = 0; k < system.initial.size(); ++k) {
        const SystemFamily& family =
            k < count ? system.coordinates[k] : system.conjugates[k - count];
        result += line("initial " + text(family), text(system, system.initial[k]));
    }
    return result;
}

/// Returns lines of the sizes and variables.
std::string variables(const System& system) {
    const bool has_L = system.side == Side::lagrangian;
    const std::string conjugates = has_L ? "velocities" : "momenta";
    std::string result;
    for (const SystemSize& size : system.sizes) {
        result += line("size " + size.name, std::to_string(size.value));
    }
    if (system.is_written_out()) {
        result += line("coordinates", names(names_of(system.graph, coordinate_nodes(system))));
        if (has_L) { result += line("momenta", names(system.momenta)); }
        result += line(conjugates, names(names_of_conjugates(system)));
    } else {
        result += line("coordinates", text(system.coordinates));
        result += line(conjugates, text(system.conjugates));
    }
    for (std::size_t k = 0; k < system.coordinates.size(); ++k) {
        const SystemFamily& family = system.coordinates[k];
        if (family.space == real_line) { continue; }
        result +=
            line(std::string(family.space.name), text(family) + ", " + text(system.conjugates[k]));
    }
    return result;
}

std::string lines(const HamiltonianParts& parts) {
    std::string result = line("duration", text(parts.duration));
    const auto add_moved = [&](const std::vector<Moved>& all) {
        for (const auto& [is_conjugate, component, change] : all) {
            result += line(fmt::format("{}{} moves by", is_conjugate ? 'p' : 'q', component + 1),
                           text(change));
        }
    };
    for (const HamiltonianPart& part : parts.parts) {
        result += line("part " + part.name, part.flow);
        if (part.usual) {
            for (const Scaled& condition : part.usual->conditions) {
                result += line("not negative", text(condition));
            }
            add_moved(part.usual->moved);
            result += "else\n";
        }
        add_moved(part.moved);
        for (const FormMoved& form : part.forms) {
            std::string degrees;
            for (const std::size_t k : form.degrees) { degrees += fmt::format(" {}", k + 1); }
            result += line("q and p move by a form" + degrees, joined(form.rows));
        }
    }
    if (parts.clock) { result += line("clock", parts.parts[*parts.clock].name); }
    if (const SmallSteps& small = parts.small_steps; small.exist()) {
        result +=
            line("small steps", fmt::format("{}, of the first {} parts", small.count, small.parts));
    }
    return result;
}

}  // namespace

std::string dump(const System& system) {
    std::string result = line("scene", system.name) + variables(system);
    if (system.is_transformed) {
        result += line("H = p v - L, where L", to_text(system.expression));
    }
    if (system.scaled) {
        result += line("time", system.coordinates.at(system.scaled->coordinate).name);
        if (system.is_written_out()) { result += line("energy", text(energy_of(system))); }
    }
    for (const SystemParameter& parameter : system.parameters) {
        result += line("parameter " + parameter.name, to_text(parameter.value));
    }
    for (const SystemTable& table : system.tables) { result += line("table", text(table.family)); }
    result += found(system);
    for (Node node = 0; node < system.graph.size(); ++node) {
        result += line(text(node), text(system.graph.at(node)));
    }
    const bool is_written_out = system.is_written_out();
    result += (is_written_out ? derivatives(system) : with_loops(system)) + starts(system);
    if (system.parts) { result += lines(*system.parts); }
    for (const SystemValue& each : system.invariants) {
        result += is_written_out ? line("invariant " + each.name, text(value_of(each)))
                                 : lines(system, "invariant " + each.name, each.sums);
    }
    return result;
}

}  // namespace hvi::gen
