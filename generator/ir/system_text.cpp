// SPDX-License-Identifier: GPL-2.0-or-later
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

/// Entries that are not zero; `second` is d2H or d2L.
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

/// What derivatives are by: coordinates, and turns of bodies, `R~1`.
std::vector<std::string> names_of_degrees(const System& system) {
    std::vector<std::string> names(system.coordinates.begin(),
                                   system.coordinates.begin() +
                                       static_cast<std::ptrdiff_t>(system.flat_coordinates()));
    for (const SystemRotation& rotation : system.rotations) {
        for (const char* axis : {"~1", "~2", "~3"}) { names.push_back(rotation.rotation + axis); }
    }
    return names;
}

/// Blocks of second derivatives; `second` is d2H or d2L.
std::string lines(const std::string& second, const Hessian& all, const System& system) {
    const std::vector<std::string> q = names_of_degrees(system);
    const std::vector<std::string>& y = system.conjugate_names();
    return lines(second, all.qq, q, q) + lines(second, all.mixed, q, y) +
           lines(second, all.conjugates, y, y);
}

std::string lines(const ConstantTerms& constant, const System& system) {
    std::string result;
    if (const auto* stiff = std::get_if<std::vector<LinearStiffness>>(&constant)) {
        for (const LinearStiffness& each : *stiff) {
            result += line("stiffness " + system.coordinates[each.component], text(each.value));
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
    const std::vector<std::string>& y = system.conjugate_names();
    std::string result = line(f, text(system.function));
    for (std::size_t i = 0; i < q.size(); ++i) {
        result += line("d" + f + "/d" + q[i], text(system.by_q[i]));
    }
    for (std::size_t i = 0; i < y.size(); ++i) {
        result += line("d" + f + "/d" + y[i], text(system.by_conjugates[i]));
    }
    result += lines("d2" + f, system.hessian, system);
    return system.side == Side::hamiltonian ? result : result + line("energy", text(system.energy));
}

std::string lines(const std::string& what, const std::vector<SystemValue>& values) {
    std::string result;
    for (const SystemValue& each : values) {
        result += line(what + " " + each.name, text(each.value));
    }
    return result;
}

}  // namespace

std::string dump(const System& system) {
    std::string result = line("scene", system.name);
    result += line("coordinates", names(system.coordinates));
    result += line("momenta", names(system.momenta));
    if (system.side == Side::lagrangian) { result += line("velocities", names(system.velocities)); }
    for (const SystemRotation& rotation : system.rotations) {
        result += line("rotation", rotation.rotation + ", " + rotation.momentum);
    }
    for (const SystemParameter& parameter : system.parameters) {
        result += line("parameter " + parameter.name, to_text(parameter.value));
    }
    result += found(system);
    for (Node node = 0; node < system.graph.size(); ++node) {
        result += line(text(node), text(system.graph.at(node)));
    }
    return result + derivatives(system) + lines("initial", system.initial) +
           lines("invariant", system.invariants);
}

}  // namespace hvi::gen
