// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/ir/equal.hpp"
#include "generator/plan/chart_step.hpp"
#include "generator/plan/flow_step.hpp"
#include "generator/plan/free_parameter.hpp"
#include "generator/plan/galerkin_step.hpp"
#include "generator/plan/general_form.hpp"
#include "generator/plan/lanes.hpp"
#include "generator/plan/lattice.hpp"
#include "generator/plan/solver.hpp"
#include "generator/plan/starting_values.hpp"
#include "generator/plan/velocity_form.hpp"
#include "generator/stages/stage_graph.hpp"

namespace hvi::gen {
namespace {

using Place = StageValue::Place;

bool equal(const NumberVector& a, const NumberVector& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!equal(a[i], b[i])) { return false; }
    }
    return true;
}

Partner partner(const Tableau& tableau) {
    bool all_equal = true;
    for (std::size_t i = 0; i < tableau.stages(); ++i) {
        for (std::size_t j = 0; j < tableau.stages(); ++j) {
            if (differ(tableau.A[i][j], tableau.A_tilde[i][j])) { return Partner::different; }
            all_equal = all_equal && equal(tableau.A[i][j], tableau.A_tilde[i][j]);
        }
    }
    return all_equal ? Partner::same : Partner::undecided;
}

NumberMatrix transposed(const NumberMatrix& a) {
    NumberMatrix result(a.empty() ? 0 : a.front().size(), NumberVector(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < a[i].size(); ++j) { result[j][i] = a[i][j]; }
    }
    return result;
}

/// Returns one value for each distinct row, in the order of their first stages.
std::vector<StageValue> distinct(const NumberMatrix& rows, const NumberVector& weights) {
    std::vector<StageValue> values;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        StageValue* found = nullptr;
        for (StageValue& value : values) {
            if (equal(rows[value.stages.front()], rows[i])) { found = &value; }
        }
        if (found == nullptr) { found = &values.emplace_back(); }
        found->stages.push_back(i);
        found->weight = found->weight + weights[i];
    }
    return values;
}

/// Returns one value for each stage.
std::vector<StageValue> separate(const NumberVector& weights) {
    std::vector<StageValue> values(weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        values[i].stages = {i};
        values[i].weight = weights[i];
    }
    return values;
}

/// NOTE: P_j and P_k agree, a~_ji = a~_ki for all i, exactly when a_ij/b_j = a_ik/b_k, that is when
/// columns j and k of m agree. So equal stages are merged by striking out rows and columns of m.
void set_stages(Step& step, const WeightedStages& stages) {
    const auto& [m, b] = stages;
    step.positions = step.is_separable() ? distinct(m, b) : separate(b);
    step.momenta = step.is_separable() ? distinct(transposed(m), b) : separate(b);
    for (const StageValue& position : step.positions) {
        NumberVector row;
        for (const StageValue& momentum : step.momenta) {
            row.push_back(m[position.stages.front()][momentum.stages.front()]);
        }
        step.m.push_back(std::move(row));
    }
    const auto merged = [&](const char* letter, const std::vector<StageValue>& values) {
        for (const StageValue& value : values) {
            if (value.stages.size() < 2) { continue; }
            std::string names;
            for (const std::size_t i : value.stages) {
                names += fmt::format("{}{}_{}", names.empty() ? "" : " = ", letter, i + 1);
            }
            step.decisions.push_back({names + " is evaluated once", "these stages are equal"});
        }
    };
    merged("Q", step.positions);
    merged("P", step.momenta);
}

Place place_of(const NumberVector& row, bool ones_are_end) {
    bool zeros = true;
    bool ones = true;
    for (const Number& entry : row) {
        zeros = zeros && equal(entry, 0);
        ones = ones && equal(entry, 1);
    }
    if (zeros) { return ones_are_end ? Place::start : Place::end; }
    if (ones) { return ones_are_end ? Place::end : Place::start; }
    return Place::inner;
}

/// Sets the places of stages. A row of zeros in m is Q_i = q, of ones the next q; with mt_ji = 1 -
/// m_ij a column of ones is P_j = p, of zeros the next p.
void set_places(Step& step) {
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        step.positions[i].place = place_of(step.m[i], true);
    }
    const NumberMatrix columns = transposed(step.m);
    for (std::size_t j = 0; j < step.momenta.size(); ++j) {
        step.momenta[j].place = place_of(columns[j], false);
    }
    const auto note = [&](const char* letter, const char* state, const StageValue& value) {
        const std::string name = fmt::format("{}_{}", letter, value.stages.front() + 1);
        if (value.place == Place::start) {
            step.decisions.push_back({fmt::format("{} is not solved for", name),
                                      fmt::format("it is {} at the start of the step", state)});
        } else if (value.place == Place::end) {
            step.decisions.push_back({fmt::format("{} takes no sum of its own", name),
                                      fmt::format("it is {} at the end of the step", state)});
        }
    };
    for (const StageValue& value : step.positions) { note("Q", "q", value); }
    for (const StageValue& value : step.momenta) { note("P", "p", value); }
}

/// Returns which stages of a step need which slopes, where that is not disproved: Q_i needs Lq_j
/// unless m_ij = 0, and P_j needs Lp_i unless m~_ji = 1 - m_ij = 0.
StagePattern pattern(const Step& step) {
    StagePattern result;
    result.slopes = slopes_of_all(step.is_separable());
    result.p.resize(step.momenta.size());
    for (const NumberVector& row : step.m) {
        auto& q = result.q.emplace_back();
        for (std::size_t j = 0; j < row.size(); ++j) {
            q.push_back(!equal(row[j], 0));
            result.p[j].push_back(!equal(row[j], 1));
        }
    }
    return result;
}

void set_blocks(Step& step) {
    for (std::vector<StageNode>& group : groups_in_order(pattern(step))) {
        step.blocks.push_back({group.size() > 1, std::move(group)});
    }
    if (step.is_explicit()) {
        step.decisions.push_back(
            {"no solver", "no stage depends on itself: the step is kicks and drifts in turn"});
    } else if (step.coupled_blocks() > 1) {
        step.decisions.push_back(
            {fmt::format("{} smaller systems are solved in turn", step.coupled_blocks()),
             "the stages decouple"});
    }
}

/// Sets how an explicit step sums.
///
/// NOTE: measured in double, against the same steps in more bits. Over 200 000 steps of Kepler's
/// problem, stormer-verlet is off by 2e-3 and rounding adds 1e-11 to that; compensated sums would
/// bring the rounding to 4e-14 and cost a fifth, on six bodies three fifths. For a step of
/// yoshida:6, blanes-moan:6 and kahan-li:8 they cost 6 % or less, and rounding falls from 1e-11 to
/// 4e-13 where kahan-li:8 is off by 5e-11.
void set_sums(Step& step, const OneStepMethod& method, const StepWishes& wishes) {
    constexpr int least_order = 6;
    if (!step.is_explicit()) { return; }
    if (wishes.needs_slopes()) {
        step.form = PairStep{};
        step.decisions.push_back({"the slopes are kept, in compensated sums",
                                  wishes.curve ? "the curve of a step is made of them"
                                               : "the action is summed over them"});
    } else if (method.composition && method.composition->order >= least_order) {
        step.form = ExplicitStep{Sums::compensated};
        step.decisions.push_back(
            {"compensated summation",
             fmt::format("errors of order {} come down to round-off", method.composition->order)});
    } else {
        step.form = ExplicitStep{Sums::plain};
        step.decisions.push_back(
            {"no compensated summation", "the error of the step is far above round-off"});
    }
}

bool has(const std::vector<StageValue>& values, Place place) {
    for (const StageValue& value : values) {
        if (value.place == place) { return true; }
    }
    return false;
}

/// Sets the slopes that are kept: the first of a step is the last of the step before.
void set_kept(Step& step) {
    if (!step.is_separable()) { return; }
    step.kept.force = has(step.positions, Place::start) && has(step.positions, Place::end);
    step.kept.velocity = has(step.momenta, Place::start) && has(step.momenta, Place::end);
    if (step.kept.force) {
        step.decisions.push_back({"one force a step is not evaluated",
                                  "the last one of a step is the first one of the next"});
    }
    if (step.kept.velocity) {
        step.decisions.push_back({"one dH/dp a step is not evaluated",
                                  "the last one of a step is the first one of the next"});
    }
}

void set_times(Step& step, NumberVector c) {
    step.c = std::move(c);
    step.decisions.push_back({"the state has a time", "H depends on it"});
}

/// Returns whether the map of one step, which is linear, is computed by solving a system with so
/// many unknowns for each degree of freedom. Where it is not, the decisions say why.
///
/// NOTE: computing the matrix costs the cube of the number of unknowns, in numbers of twice the
/// digits: 64 take some milliseconds.
bool is_tabulated(Step& step, const SystemProperties& system, std::size_t unknowns_of_each) {
    constexpr std::size_t most_unknowns = 64;
    const std::size_t unknowns = system.degrees_of_freedom * unknowns_of_each;
    if (unknowns <= most_unknowns) { return true; }
    step.decisions.push_back(
        {"iterated, though H is quadratic",
         fmt::format("its matrix has {} unknowns, above {}", unknowns, most_unknowns)});
    return false;
}

void set_map(Step& step, const SystemProperties& system) {
    const bool are_symmetric = system.degrees_of_freedom == 1 || step.is_separable();
    if (are_symmetric && !system.is_degenerate) {
        step.form = TabulatedStep{.as = TabulatedStep::As::shears};
        step.decisions = {
            {"no solver",
             "H is quadratic: a step is a product of three shears where these exist for h, else "
             "with a matrix, computed when h changes"},
            {"no compensated summation",
             "the shears are symplectic however they round; --solver fixed-point iterates with "
             "it"}};
    } else {
        step.form = TabulatedStep{.as = TabulatedStep::As::matrix};
        step.decisions = {
            {"no solver",
             "H is quadratic: a step is a product with a matrix, computed when h changes"},
            {"the matrix is kept in twice the digits, and sums are compensated",
             fmt::format("{}, and a rounded matrix is not symplectic",
                         are_symmetric ? "a singular matrix d2H/dp2 leaves no shears"
                                       : "products of q and p leave no symmetric shears")}};
    }
}

/// NOTE: kicks and drifts are shears as well, and need the standard library alone.
bool tabulate(Step& step, const SystemProperties& system) {
    if (step.is_explicit() || step.from_parameter) { return false; }
    if (!is_tabulated(step, system, step.positions.size() + step.momenta.size())) { return false; }
    set_map(step, system);
    return true;
}

/// Reduces the unknowns for H = p^T K p/2 + U(q).
void eliminate_momenta(Step& step, const SystemProperties& system) {
    if (step.is_explicit() || step.from_parameter) { return; }
    VelocityForm form = velocity_form(step);
    std::vector<Block> order = blocks(form);
    const auto coupled =
        std::count_if(order.begin(), order.end(), [](const Block& block) { return block.coupled; });
    if (coupled != 1) { return; }
    VelocityStep positions;
    positions.form = std::move(form);
    positions.has_diagonal_mass = system.has_diagonal_mass;
    step.form = std::move(positions);
    step.blocks = std::move(order);
    step.kept.velocity = false;
    step.decisions.push_back(
        {"the momenta of the stages are eliminated",
         "the kinetic energy is quadratic: the stages are solved for their positions alone"});
}

/// Notes that the stages keep their momenta for the action (4.19), and are computed one by one.
void note_action(Step& step) {
    if (step.is_explicit()) { return; }
    step.decisions.push_back({"the stages keep their momenta, and are computed one by one",
                              "the action is summed over positions, momenta and slopes"});
}

/// Notes that the stages keep their momenta on a GPU.
void note_threads(Step& step) {
    if (step.is_explicit()) { return; }
    step.decisions.push_back({"the stages keep their momenta",
                              "on a GPU one form serves any H: positions alone need products of "
                              "twice the digits"});
}

void round_coefficients(const Step&, ExplicitStep&) {}
void round_coefficients(const Step&, FlowStep&) {}
void round_tables(const Step& step, RoundedCoefficients& coefficients) {
    coefficients = rounded(step);
}
void round_tables(const Step&, TabulatedCurve& curve) { curve.rounded = rounded(curve.form); }
void round_coefficients(const Step& step, TabulatedStep& form) {
    std::visit([&](auto& tables) { round_tables(step, tables); }, form.tables);
}
void round_coefficients(const Step& step, PairStep& form) { form.coefficients = rounded(step); }
void round_coefficients(const Step& step, ChartStep& form) { form.coefficients = rounded(step); }
void round_coefficients(const Step&, VelocityStep& form) { form.rounded = rounded(form.form); }
void round_coefficients(const Step&, GalerkinStep& form) { form.rounded = rounded(form.form); }

/// Returns the step with all that remains once the rest is decided.
Step completed(Step step, const SystemProperties& system) {
    step.container = system.container;
    const bool is_swept = system.is_lattice && std::holds_alternative<ExplicitStep>(step.form);
    if (is_swept) { step.layout = Layout::sites; }
    std::visit([&](auto& form) { round_coefficients(step, form); }, step.form);
    verify(step);
    return step;
}

/// Returns the solver. NOTE: trajectories side by side differ in how stiff H is for them, and are
/// all iterated.
Solver solver_for(const StepWishes& wishes) {
    const bool are_several = wishes.lanes == Lanes::ensemble || wishes.lanes == Lanes::gpu;
    return are_several && wishes.solver == Solver::automatic ? Solver::fixed_point : wishes.solver;
}

bool may_tabulate(const SystemProperties& system, const StepWishes& wishes) {
    const Solver solver = solver_for(wishes);
    return system.has_linear_map && system.hessian == HessianForm::dense &&
           (solver == Solver::automatic || solver == Solver::sweeps) && !wishes.needs_slopes();
}

/// Returns the lanes. NOTE: the sums of (4.19) take one stage after the other.
Lanes lanes_for(const StepWishes& wishes) { return wishes.action ? Lanes::none : wishes.lanes; }

/// Plans a step in the charts of rotations. Precondition: the stages are set.
Step planned_in_charts(Step step, const OneStepMethod& method, const SystemProperties& system,
                       const StepWishes& wishes) {
    check_no_parameter(method);
    set_charts(step);
    if (system.depends_on_time) { set_times(step, position_times(step)); }
    set_solver(step, solver_for(wishes), wishes.sweeps, system);
    set_lanes(step, lanes_for(wishes), system);
    return step;
}

/// Plans a step as flows of parts of H. The stages are those of kicks and drifts, each of which is
/// the flow of a part of a separable H.
///
/// NOTE: eight trajectories join no flows of steps in a row: the end of one would depend on how
/// many steps it takes between those of others.
Step planned_as_flows(const Tableau& tableau, const OneStepMethod& method,
                      const SystemProperties& system, const StepWishes& wishes) {
    Step step;
    step.slopes = Slopes::of_parts;
    step.partner = partner(tableau);
    WeightedStages stages = weighted_stages(tableau);
    if (method.composition) {
        stages = composed(stages, *method.composition);
        note_composition(step, method);
    }
    const std::size_t decided = step.decisions.size();
    set_stages(step, stages);
    set_places(step);
    set_blocks(step);
    step.decisions.resize(decided);
    set_flows(step, system, stages.b);
    set_lanes(step, lanes_for(wishes), system);
    if (step.layout == Layout::one) {
        step.form = with_joined_ends(std::get<FlowStep>(std::move(step.form)));
    }
    return completed(std::move(step), system);
}

/// Plans all steps of a composition as one, except the start of its iteration.
Step planned_as_one(const Tableau& tableau, const OneStepMethod& method,
                    const SystemProperties& system, const StepWishes& wishes) {
    const std::optional<Composition>& composition = method.composition;
    Step step;
    const bool has_charts = system.rotations > 0;
    step.slopes = has_charts            ? Slopes::joint
                  : system.is_separable ? Slopes::of_parts
                                        : Slopes::one_by_one;
    step.partner = partner(tableau);
    WeightedStages stages = weighted_stages(tableau);
    if (composition) {
        stages = composed(stages, *composition);
        note_composition(step, method);
    }
    set_stages(step, stages);
    if (has_charts) { return planned_in_charts(std::move(step), method, system, wishes); }
    set_places(step);
    set_blocks(step);
    set_sums(step, method, wishes);
    set_kept(step);
    // The time is a coordinate with velocity 1: (4.18c) gives T_i = t + h sum_j a_ij.
    if (system.depends_on_time) { set_times(step, position_times(step)); }
    set_from_parameter(step, tableau, method.place);
    if (may_tabulate(system, wishes) && tabulate(step, system)) { return step; }
    if (!step.is_explicit()) { step.form = PairStep{Iteration{}}; }
    // NOTE: each of the steps of a composition is solved for itself, which the form of (Q, v) would
    // undo; and enclosures do not tell that entries between them are zero.
    if (wishes.action) {
        note_action(step);
    } else if (wishes.lanes == Lanes::gpu) {
        note_threads(step);
    } else if (system.kinetic_is_quadratic && !composition) {
        eliminate_momenta(step, system);
    }
    set_solver(step, solver_for(wishes), wishes.sweeps, system);
    set_lanes(step, lanes_for(wishes), system);
    set_corrections(step, system);
    return step;
}

/// Plans the steps of a composition one after the other, each with its stages in lanes; nothing
/// where these have none.
///
/// NOTE: the method is its own adjoint, as each of the steps has the same tables.
std::optional<Step> planned_in_a_row(const Tableau& tableau, const OneStepMethod& method,
                                     const SystemProperties& system, const StepWishes& wishes) {
    if (method.composition->with_adjoint && !is_symmetric(tableau).holds) { return {}; }
    OneStepMethod base = method;
    base.composition.reset();
    Step step = planned_as_one(tableau, base, system, wishes);
    if (step.layout != Layout::stages) { return {}; }
    step.in_a_row = steps_in_a_row(method);
    note_composition(step, method);
    set_extrapolation(step, {tableau.c, tableau.b});
    return step;
}

Step planned(const Tableau& tableau, const OneStepMethod& method, const SystemProperties& system,
             const StepWishes& wishes) {
    if (system.parts > 0) { return planned_as_flows(tableau, method, system, wishes); }
    // NOTE: all steps of a composition are in one chart.
    if (method.composition && system.rotations == 0) {
        std::optional<Step> one_by_one = planned_in_a_row(tableau, method, system, wishes);
        if (one_by_one) { return completed(*std::move(one_by_one), system); }
    }
    Step step = planned_as_one(tableau, method, system, wishes);
    if (!method.composition) { set_extrapolation(step, {tableau.c, tableau.b}); }
    return completed(std::move(step), system);
}

/// Plans a step by the general Galerkin form with its own unknowns. Decisions that are made are
/// kept.
Step planned_as_curves(Step step, const OneStepMethod& method, const SystemProperties& system,
                       const StepWishes& wishes) {
    check_no_parameter(method);
    set_galerkin(step, method, system, wishes);
    const auto* tableau = std::get_if<Tableau>(&method.base);
    if (tableau != nullptr) { step.partner = partner(*tableau); }
    if (system.depends_on_time) { set_times(step, std::get<GalerkinStep>(step.form).form.c); }
    set_solver(step, solver_for(wishes), wishes.sweeps, system);
    return completed(std::move(step), system);
}

/// Plans a step by the map of the curve, or of several in a row.
Step planned_as_map(const OneStepMethod& method, TabulatedCurve curve,
                    const SystemProperties& system) {
    Step step;
    step.slopes = system.is_separable ? Slopes::of_parts : Slopes::joint;
    step.partner = Partner::different;
    set_map(step, system);
    set_nodes(step, method, curve.form);
    note_composition(step, method);
    std::get<TabulatedStep>(step.form).tables = std::move(curve);
    return completed(std::move(step), system);
}

/// Plans a step by positions alone. Precondition: set_rule() has set them.
Step planned_as_positions(Step step, const OneStepMethod& method, const Quadrature& quadrature,
                          const SystemProperties& system, const StepWishes& wishes) {
    if (std::holds_alternative<ExplicitStep>(step.form)) {
        set_places(step);
        set_blocks(step);
        set_sums(step, method, wishes);
    }
    set_kept(step);
    if (system.depends_on_time) { set_times(step, quadrature.c); }
    set_solver(step, solver_for(wishes), wishes.sweeps, system);
    set_lanes(step, wishes.lanes, system);
    set_corrections(step, system);
    set_extrapolation(step, quadrature);
    return completed(std::move(step), system);
}

Step planned(const GalerkinRule& rule, const OneStepMethod& method, const SystemProperties& system,
             const StepWishes& wishes) {
    check_no_parameter(method);
    check_no_rotations(method.place, system);
    check_general_form(method.place, system);
    const bool is_nystrom = system.kinetic_is_quadratic && !method.composition && !wishes.action;
    Step step;
    Quadrature quadrature;
    if (is_nystrom) { quadrature = set_rule(step, rule); }
    const bool is_explicit = is_nystrom && std::holds_alternative<ExplicitStep>(step.form);
    if (may_tabulate(system, wishes) && !is_explicit) {
        TabulatedCurve curve{galerkin_form(rule), {}, steps_in_a_row(method)};
        if (is_tabulated(step, system, curve.form.nodes() + curve.form.functions())) {
            return planned_as_map(method, std::move(curve), system);
        }
    }
    return is_nystrom ? planned_as_positions(std::move(step), method, quadrature, system, wishes)
                      : planned_as_curves(std::move(step), method, system, wishes);
}

}  // namespace

Step plan(const OneStepMethod& method, const SystemProperties& system, const StepWishes& wishes) {
    verify(method);
    verify(system);
    if (system.side == Side::lagrangian) { return planned_as_curves({}, method, system, wishes); }
    return std::visit([&](const auto& base) { return planned(base, method, system, wishes); },
                      method.base);
}

}  // namespace hvi::gen
