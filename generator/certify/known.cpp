// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/known.hpp"

#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/methods/nodes.hpp"
#include "generator/read/catalogue.hpp"

namespace hvi::gen {

namespace {

/// Whether the nodes are the roots of P. NOTE: any basis of the polynomials makes one tableau.
bool has_nodes(const MethodEntry& entry, const RationalPolynomial& P) {
    const auto name = std::make_shared<const Source>(Source{"", std::string(entry.name)});
    const Tableau tableau = derive(named_method(name));
    const RationalPolynomial* const own = tableau.node_polynomial();
    return own != nullptr && monic(*own) == P;
}

std::vector<std::string> names_with_nodes(const RationalPolynomial& nodes) {
    const RationalPolynomial P = monic(nodes);
    const long size = P.degree();
    std::vector<std::string> names;
    for (const MethodEntry& entry : named_methods()) {
        if (has_nodes(entry, P)) { names.emplace_back(entry.name); }
    }
    for (const FamilyEntry& entry : node_families()) {
        const std::string name(entry.name);
        if (size >= entry.smallest && family_polynomial({name, size, {}}) == P) {
            names.push_back(name + ":" + std::to_string(size));
        }
    }
    return names;
}

}  // namespace

std::vector<std::string> known_names(const Tableau& tableau) {
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? names_with_nodes(*P) : std::vector<std::string>{};
}

std::vector<std::string> known_adjoints(const Tableau& tableau) {
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? names_with_nodes(P->at_affine(-1, 1)) : std::vector<std::string>{};
}

}  // namespace hvi::gen
