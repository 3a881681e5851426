// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lowered_scene.hpp"
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

/// Entries that are not zero.
std::string lines(const HessianBlock& block, const std::vector<std::string>& rows,
                  const std::vector<std::string>& columns) {
    std::string result;
    for (std::size_t i = 0; i < block.size(); ++i) {
        for (std::size_t j = 0; j < block[i].size(); ++j) {
            if (block[i][j].is_zero()) { continue; }
            result += line("d2H/d" + rows[i] + " d" + columns[j], text(block[i][j]));
        }
    }
    return result;
}

std::string found(const LoweredScene& lowered) {
    const Structure& structure = lowered.structure;
    std::string result;
    const auto add = [&](bool holds, const char* what) {
        if (holds) { result += line("found", what); }
    };
    add(structure.is_separable, "H = T(p) + U(q)");
    add(structure.kinetic_is_quadratic, "T is quadratic");
    add(structure.is_quadratic, "H is quadratic");
    add(structure.is_linear_in_p, "H is linear in p");
    add(structure.is_linear_in_q, "H is linear in q");
    add(lowered.system.time.has_value(), "H depends on the time");
    return result;
}

std::string derivatives(const LoweredScene& lowered) {
    const SystemGraph& system = lowered.system;
    const std::vector<std::string>& q = lowered.scene.hamiltonian.coordinates;
    const std::vector<std::string>& p = lowered.scene.hamiltonian.momenta;
    std::string result = line("H", text(system.hamiltonian));
    for (std::size_t i = 0; i < q.size(); ++i) {
        result += line("dH/d" + q[i], text(system.dHdq[i]));
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
        result += line("dH/d" + p[i], text(system.dHdp[i]));
    }
    const Structure& second = lowered.structure;
    return result + lines(second.qq, q, q) + lines(second.qp, q, p) + lines(second.pp, p, p);
}

}  // namespace

std::string dump(const LoweredScene& lowered) {
    const Scene& scene = lowered.scene;
    const Graph& graph = lowered.system.graph;
    std::string result = line("scene", scene.name);
    result += line("coordinates", names(scene.hamiltonian.coordinates));
    result += line("momenta", names(scene.hamiltonian.momenta));
    for (const Parameter& parameter : scene.parameters) {
        result += line("parameter " + parameter.name, to_text(parameter.value));
    }
    result += found(lowered);
    for (Node node = 0; node < graph.size(); ++node) {
        result += line(text(node), text(graph.at(node)));
    }
    result += derivatives(lowered);
    for (std::size_t i = 0; i < lowered.initial.size(); ++i) {
        result += line("initial " + scene.initial[i].name, text(lowered.initial[i]));
    }
    for (std::size_t i = 0; i < lowered.invariants.size(); ++i) {
        result += line("invariant " + scene.invariants[i].name, text(lowered.invariants[i]));
    }
    return result;
}

bool operator==(const LoweredScene& left, const LoweredScene& right) {
    return dump(left) == dump(right);
}

}  // namespace hvi::gen
