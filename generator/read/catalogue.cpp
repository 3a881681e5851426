// The tables of families and named methods.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/catalogue.hpp"

#include <algorithm>
#include <array>

namespace hvi::gen {

namespace {

constexpr std::array<FamilyEntry, 2> basis_table{{
    {"monomials", 1, "1..64", "the polynomials 1, tau, ..., tau^(S-1)", "Section 4.5"},
    {"trig", 1, "1..64", "1, cos(pi*tau), sin(pi*tau), ...", "Example 4.6"},
}};

constexpr std::array<FormEntry, 1> basis_form_table{{
    {"bspline(k,i)", "the i-th B-spline of degree k, i = 0, 1, ..."},
}};

constexpr std::array<FamilyEntry, 9> node_table{{
    {"gauss", 1, "1..64", "Legendre zeros, order 2*S", "Section 6"},
    {"lobatto", 2, "2..64", "Gauss-Lobatto: both ends are nodes", ""},
    {"radau-left", 1, "1..64", "Gauss-Radau with node 0", ""},
    {"radau-right", 1, "1..64", "Gauss-Radau with node 1", ""},
    {"newton-cotes", 2, "2..64", "equally spaced, with both ends", ""},
    {"newton-cotes-open", 1, "1..64", "equally spaced, without the ends", ""},
    {"chebyshev", 1, "1..7, 9", "Chebyshev's, equal weights", "Example 4.7"},
    {"clenshaw-curtis", 2, "2..64", "Chebyshev extrema, both ends", ""},
    {"fejer", 1, "1..64", "Chebyshev zeros, Fejer's first rule", ""},
}};

constexpr std::array<FormEntry, 1> node_form_table{{
    {"roots(P(tau))", "the real roots of a polynomial, ascending"},
}};

constexpr std::array<MethodEntry, 5> method_table{{
    {"symplectic-euler", "1", "0", "symplectic Euler, order 1", "Example 4.4 (i)"},
    {"midpoint", "1", "1/2", "midpoint rule, order 2", "Example 4.4 (ii)"},
    {"adjoint-symplectic-euler", "1", "1", "its adjoint, order 1", "Example 4.4 (iii)"},
    {"stormer-verlet", "1, cos(pi*tau)", "0, 1", "Stormer-Verlet, order 2", "Example 4.5"},
    {"trig3", "1, cos(pi*tau), sin(pi*tau)", "0, 1/2, 1", "three stages, order 2", "Example 4.6"},
}};

}  // namespace

std::span<const FamilyEntry> basis_families() { return basis_table; }

std::span<const FamilyEntry> node_families() { return node_table; }

std::span<const FormEntry> basis_forms() { return basis_form_table; }

std::span<const FormEntry> node_forms() { return node_form_table; }

std::span<const MethodEntry> named_methods() { return method_table; }

const FamilyEntry* find_family(std::span<const FamilyEntry> families, std::string_view name) {
    const auto found = std::find_if(families.begin(), families.end(),
                                    [&](const FamilyEntry& entry) { return entry.name == name; });
    return found == families.end() ? nullptr : &*found;
}

}  // namespace hvi::gen
