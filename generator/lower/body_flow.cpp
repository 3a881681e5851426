// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/body_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/expr/space.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/function_of_forms.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t entries = rotations_of_space.point;  ///< of R

Scaled input_value(Node node) { return {{1, 1}, node}; }

/// Returns the only component of L that a function depends on; nothing where there are more.
std::optional<std::size_t> only_axis(const FunctionOfBody& body) {
    std::optional<std::size_t> axis;
    for (std::size_t a = 0; a < body.L.size(); ++a) {
        if (body.by_L[a].is_zero()) { continue; }
        if (axis) { return std::nullopt; }
        axis = a;
    }
    return axis;
}

/// Adds a turn about an axis k of a body after changes of R. With w = dH/dL_k it is L_i' = w L_j,
/// L_j' = -w L_i for i, j, k in turn, and the columns i and j of R alike, since R' = R hat(w e_k).
/// NOTE: what the shears do to R is the inverse of what they do to L, so that R L keeps its value
/// however they are rounded.
void add_turn(FlowChanges& changes, TurnAngles& angles, const FunctionOfBody& body, std::size_t k,
              const Scaled& speed, std::vector<Scaled> of_R) {
    Graph& graph = changes.graph();
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    if (!speed.is_zero()) {
        const Scaled half_angle = changes.over_time(graph.times({1, 2}, speed));
        const Shears shears = rotation(graph, angles, half_angle);
        const PlaneChange of_L =
            sheared(graph, input_value(body.L[i]), input_value(body.L[j]), shears);
        changes.add(true, body.first_of_L + i, of_L.x);
        changes.add(true, body.first_of_L + j, of_L.y);
        const auto back = [&](const Scaled& shear) { return graph.times({-1, 1}, shear); };
        const Shears inverse{back(shears.first), back(shears.middle), back(shears.last),
                             shears.sign};
        const auto at = [&](std::size_t e) { return graph.sum({input_value(body.R[e]), of_R[e]}); };
        for (std::size_t row = 0; row < entries; row += 3) {
            const PlaneChange turned = sheared(graph, at(row + j), at(row + i), inverse);
            of_R[row + j] = graph.sum({of_R[row + j], turned.x});
            of_R[row + i] = graph.sum({of_R[row + i], turned.y});
        }
    }
    for (std::size_t e = 0; e < entries; ++e) { changes.add(false, body.first_of_R + e, of_R[e]); }
}

/// Adds a turn about an axis of a body.
bool add_turn_about_axis(FlowChanges& changes, TurnAngles& angles, const FunctionOfBody& body) {
    const auto axis = only_axis(body);
    if (!axis) { return false; }
    std::vector<Node> others = body.R;
    for (std::size_t a = 0; a < body.L.size(); ++a) {
        if (a != *axis) { others.push_back(body.L[a]); }
    }
    if (depend(changes.graph(), {body.by_L[*axis]}, others)) { return false; }
    const std::vector<Scaled> none(entries, Graph::number(0));
    add_turn(changes, angles, body, *axis, body.by_L[*axis], none);
    return true;
}

/// Adds R exp(tau s hat(L)) - R to the values of each flow, and returns it, row by row.
std::vector<Scaled> turn_about_momentum(FlowChanges& changes, const FunctionOfBody& body,
                                        const Scaled& s) {
    Graph& graph = changes.graph();
    RuntimeValues values{RuntimeFunction::turn_about_momentum, {}, {}};
    for (const Node entry : body.R) { values.given.push_back(input_value(entry)); }
    for (const Node component : body.L) { values.given.push_back(input_value(component)); }
    values.given.push_back(changes.over_time(graph.times({1, 2}, s)));
    std::vector<Scaled> of_R;
    for (std::size_t e = 0; e < entries; ++e) {
        const std::string name = fmt::format("change of entry {}", body.first_of_R + e);
        of_R.push_back(graph.input(name, Role::coordinate));
        values.results.push_back(of_R.back().node);
    }
    changes.add(std::move(values));
    return of_R;
}

/// Returns s where the slopes of a function by L_i and L_j are s L_i and s L_j; else nothing.
std::optional<Scaled> speed_across(Graph& graph, const FunctionOfBody& body, std::size_t i,
                                   std::size_t j) {
    const SlopesOfDegrees across{{body.L[i]}, {body.L[j]}, {body.by_L[i]}, {body.by_L[j]}};
    const PlaneForm circle{Graph::number(1), Graph::number(1), Graph::number(0)};
    if (const auto s = speed_of_forms(graph, body.function, {circle}, across)) { return s; }
    const auto found = function_of_forms(graph, body.function, across);
    if (!found) { return std::nullopt; }
    const PlaneForm& form = found->forms.front();
    const bool is_circle =
        form.c.is_zero() && is_proved_zero(graph, difference_of(graph, form.a, form.b));
    return is_circle ? std::optional(graph.product(found->speed, form.a)) : std::nullopt;
}

/// Adds the motion of a free body with H = f(L_i^2 + L_j^2, L_k), k being its axis. With dH/dL_i =
/// s L_i, dH/dL_j = s L_j and u = dH/dL_k - s L_k it is L' = u L x e_k and R' = R hat(s L + u e_k).
/// So s and u are conserved, and R goes on to R exp(tau s hat(L)) exp(tau u hat(e_k)) with L at the
/// beginning: a turn about L, and one about the axis.
bool add_symmetric_body(FlowChanges& changes, TurnAngles& angles, const FunctionOfBody& body) {
    Graph& graph = changes.graph();
    for (std::size_t k = 0; k < body.L.size(); ++k) {
        const auto s = speed_across(graph, body, (k + 1) % 3, (k + 2) % 3);
        if (!s) { continue; }
        const Scaled along = graph.product(*s, input_value(body.L[k]));
        Scaled u = difference_of(graph, body.by_L[k], along);
        if (is_proved_zero(graph, u)) { u = Graph::number(0); }
        if (depend(graph, {*s, u}, body.R)) { continue; }
        add_turn(changes, angles, body, k, u, turn_about_momentum(changes, body, *s));
        return true;
    }
    return false;
}

}  // namespace

std::string add_body_flow(FlowChanges& changes, TurnAngles& angles, const FunctionOfBody& body) {
    const bool feels_torque = std::any_of(body.by_turns.begin(), body.by_turns.end(),
                                          [](const Scaled& slope) { return !slope.is_zero(); });
    if (feels_torque) { return ""; }
    if (add_turn_about_axis(changes, angles, body)) { return "a turn about an axis of a body"; }
    return add_symmetric_body(changes, angles, body) ? "a free symmetric body" : "";
}

}  // namespace hvi::gen
