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

constexpr std::array<SplittingEntry, 5> splitting_table{{
    {"strang", "", "half of A, B, half of A: order 2", "Strang 1968"},
    {"saba:S", "1..10", "small B: order (2*S, 2)", "Laskar & Robutel 2001"},
    {"mclachlan:8.2", "", "small B: order (8, 2): saba:4", "McLachlan 1995"},
    {"mclachlan:8.4", "", "small B: order (8, 4)", "McLachlan 1995"},
    {"blanes:10.6.4", "", "small B: order (10, 6, 4)", "Blanes et al. 2013"},
}};

constexpr std::string_view explicit_of_order_4 =
    "write `stormer-verlet` with `--compose yoshida:4`, which takes these steps";
constexpr std::string_view not_symplectic =
    "its energy drifts, and so it is not built; of order 4 are `gauss:2`, and explicit for "
    "T(p) + U(q) `stormer-verlet` with `--compose suzuki:4`";

// NOTE: Stormer-Verlet begins and ends with half a kick, as velocity Verlet does.
constexpr std::array<OtherName, 17> other_name_table{{
    {"verlet", "stormer-verlet", ""},
    {"leapfrog", "stormer-verlet", ""},
    {"velocity-verlet", "stormer-verlet", ""},
    {"stoermer-verlet", "stormer-verlet", ""},
    {"implicit-midpoint", "midpoint", ""},
    {"semi-implicit-euler", "symplectic-euler", ""},
    {"forest-ruth", "", explicit_of_order_4},
    {"yoshida", "", explicit_of_order_4},
    {"yoshida4", "", explicit_of_order_4},
    {"gauss-legendre", "", "write `gauss:S` for S stages, of order 2*S"},
    {"euler", "", "did you mean `symplectic-euler`? The energy of Euler's own method drifts"},
    {"rk4", "", not_symplectic},
    {"rk45", "", not_symplectic},
    {"runge-kutta", "", not_symplectic},
    {"dopri5", "", not_symplectic},
    {"dop853", "", not_symplectic},
    {"ias15", "", not_symplectic},
}};

}  // namespace

std::span<const FamilyEntry> basis_families() { return basis_table; }

std::span<const FamilyEntry> node_families() { return node_table; }

std::span<const FormEntry> basis_forms() { return basis_form_table; }

std::span<const FormEntry> node_forms() { return node_form_table; }

std::span<const MethodEntry> named_methods() { return method_table; }

std::span<const SplittingEntry> splittings() { return splitting_table; }

std::span<const OtherName> other_names() { return other_name_table; }

const FamilyEntry* find_family(std::span<const FamilyEntry> families, std::string_view name) {
    const auto found = std::find_if(families.begin(), families.end(),
                                    [&](const FamilyEntry& entry) { return entry.name == name; });
    return found == families.end() ? nullptr : &*found;
}

}  // namespace hvi::gen
