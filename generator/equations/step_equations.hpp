// Formulas of one step of a method for a Hamiltonian system, as `scheme` prints them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/equations/galerkin_equations.hpp"
#include "generator/equations/stage_equations.hpp"
#include "generator/equations/step_title.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/series/discrete_series.hpp"

namespace hvi::gen {

/// The map x -> matrix x + offset, with all coordinates and then all momenta in x. Entries are
/// rational functions of h and the parameters.
struct MapEquations {
    std::vector<std::vector<Expression>> matrix;
    std::vector<Expression> offset;
};

/// The generating function of type II of the map. H_d^+(q_0, p_1) is written in the names of the
/// variables: coordinates for q_0 and momenta for p_1.
struct GeneratingEquations {
    Expression discrete;              ///< (4.19), from the stages
    std::optional<Expression> exact;  ///< (4.1), where it has a closed form
    bool gives_map = false;           ///< p_0 = D_1 H_d^+ and q_1 = D_2 H_d^+ (3.10) are the map
    bool is_symmetric = false;        ///< its mixed second derivatives agree
    int order_of_difference = 0;      ///< H_d^+ - H_d,exact^+ = O(h^k) for this k
    bool is_at_least = false;         ///< whether k may be larger
    bool has_type_one = false;        ///< dq_1/dp_0 is regular, so that one of type I exists too
};

struct StepEquations : StepTitle {
    Expression hamiltonian;
    std::vector<std::string> coordinates, momenta;

    std::optional<MapEquations> map;  ///< where H is quadratic
    std::string obstacle;             ///< why a quadratic H has no map
    std::optional<GeneratingEquations> generating;
    std::optional<StageEquations> stages;       ///< where there is no map
    std::optional<GalerkinEquations> at_nodes;  ///< the equations of the general form
    std::optional<DiscreteSeries> series;
};

/// Returns coordinates, then momenta.
[[nodiscard]] std::vector<std::string> variables(const StepEquations& step);

/// Returns the map of one step where H is quadratic (Leok & Zhang, (6.2) to (6.6)), with
/// `generating` also its generating function. For any other H, and for one that depends on time,
/// returns the equations of the stages (4.18), or (4.6) of the general form. With `series`, adds so
/// many terms of the discrete Hamiltonians of any H. Throws as `derive_any`, `gradient` and
/// `discrete_series` do; MathError for the generating function of another H, and for the general
/// form where d2H/dp2 is singular. Precondition: the names of both go together (see
/// check_together).
[[nodiscard]] StepEquations step_equations(const Method& method, const Hamiltonian& hamiltonian,
                                           bool generating, std::optional<int> series = {});

}  // namespace hvi::gen
