// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/accesses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "generator/lower/kernel.hpp"

namespace hvi::gen {

namespace {

std::string text_of(const ElementIndex& index) {
    if (!index.modulus) { return to_text(index.form); }
    const std::string rest =
        fmt::format("mod({}, {})", to_text(index.form), to_text(*index.modulus));
    return index.offset == AffineForm{} ? rest : rest + " + " + to_text(index.offset);
}

std::string text_of(const std::string& name, const std::vector<ElementIndex>& indices) {
    if (indices.empty()) { return name; }
    std::vector<std::string> texts;
    for (const ElementIndex& index : indices) { texts.push_back(text_of(index)); }
    return fmt::format("{}[{}]", name, fmt::join(texts, ","));
}

Role role_of(FamilyKind kind) {
    switch (kind) {
    case FamilyKind::coordinate: return Role::coordinate;
    case FamilyKind::conjugate: return Role::conjugate;
    case FamilyKind::direction:
    case FamilyKind::direction_of_conjugate: return Role::direction;
    case FamilyKind::table:
    case FamilyKind::turn: break;
    }
    return Role::index;
}

}  // namespace

std::vector<std::size_t> accesses_in(const System& system, const std::vector<Scaled>& values) {
    const Kernel whole = kernel(system.graph, values);
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        const Access& access = system.accesses[k];
        // NOTE: turns are no inputs.
        if (access.kind != FamilyKind::turn && whole.uses[access.node] != 0) {
            result.push_back(k);
        }
    }
    return result;
}

std::size_t access_to(System& system, FamilyKind kind, std::size_t family,
                      std::vector<ElementIndex> indices) {
    const std::string name = text_of(system.family({kind, family}).name, indices);
    const Node node = system.graph.input(name, role_of(kind)).node;
    for (std::size_t k = 0; k < system.accesses.size(); ++k) {
        if (system.accesses[k].node == node) { return k; }
    }
    system.accesses.push_back({kind, family, std::move(indices), node});
    return system.accesses.size() - 1;
}

}  // namespace hvi::gen
