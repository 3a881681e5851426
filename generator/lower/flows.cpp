// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/flows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/form_flow.hpp"
#include "generator/lower/orbits.hpp"
#include "generator/lower/shears.hpp"
#include "generator/lower/turns.hpp"

namespace hvi::gen {

namespace {

/// A degree of freedom, or a body that turns, with the numbers of its variables.
struct Freedom {
    std::vector<std::size_t> positions, momenta;  ///< components of q and p
    std::vector<std::size_t> degrees;             ///< of the slopes by positions
};

/// A function of the variables, and its slopes by degrees of freedom and by conjugates.
class FunctionWithFlow {
public:
    FunctionWithFlow(System& system, const Scaled& function, Node duration, TurnAngles& angles)
        : system_(system),
          graph_(system.graph),
          function_(function),
          angles_(angles),
          tau_{{1, 1}, duration},
          q_(coordinate_nodes(system)),
          p_(conjugate_nodes(system)),
          by_p_(gradient(graph_, function, p_)),
          by_q_(by_turns(system, gradient(graph_, function, q_))) {
        set_freedoms();
    }

    [[nodiscard]] std::variant<Flow, NoFlow> operator()() {
        std::vector<std::string> kinds;
        for (const std::vector<std::size_t>& together : components()) {
            const std::string kind = add(together);
            if (kind.empty()) return NoFlow{"no flow is known where " + names(together) + " move"};
            if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
        }
        std::sort(moved_.begin(), moved_.end(), [](const Moved& left, const Moved& right) {
            return std::pair(left.is_conjugate, left.component) <
                   std::pair(right.is_conjugate, right.component);
        });
        return Flow{fmt::format("{}", fmt::join(kinds, ", ")),
                    std::move(moved_),
                    {},
                    std::move(in_each_flow_),
                    std::move(forms_)};
    }

private:
    // ---- what couples with what ----

    void set_freedoms() {
        const std::size_t flat = flat_coordinates(system_), bodies = bodies_of(system_);
        for (std::size_t k = 0; k < flat; ++k) freedoms_.push_back({{k}, {k}, {k}});
        for (std::size_t r = 0; r < bodies; ++r) {
            Freedom body;
            for (std::size_t e = 0; e < 9; ++e) body.positions.push_back(flat + 9 * r + e);
            for (std::size_t a = 0; a < 3; ++a) body.momenta.push_back(flat + 3 * r + a);
            body.degrees = body.momenta;
            freedoms_.push_back(std::move(body));
        }
    }

    [[nodiscard]] bool is_body(const Freedom& freedom) const {
        return freedom.positions.size() > 1;
    }

    [[nodiscard]] std::vector<Scaled> slopes_of(const Freedom& freedom) const {
        std::vector<Scaled> slopes;
        for (const std::size_t k : freedom.degrees) slopes.push_back(by_q_[k]);
        for (const std::size_t k : freedom.momenta) slopes.push_back(by_p_[k]);
        return slopes;
    }

    /// Returns whether one of the values depends on one of the nodes.
    [[nodiscard]] bool depend(const std::vector<Scaled>& values,
                              const std::vector<Node>& nodes) const {
        std::set<Node> open;
        for (const Scaled& value : values)
            if (!value.is_zero()) open.insert(value.node);
        while (!open.empty()) {
            const Node node = *open.rbegin();
            open.erase(node);
            if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) return true;
            const Computation& computation = graph_.at(node);
            if ((computation.roles & of_state) == 0) continue;
            for (const Scaled& term : computation.terms) open.insert(term.node);
            for (const Node argument : computation.arguments) open.insert(argument);
        }
        return false;
    }

    [[nodiscard]] std::vector<Node> variables_of(const Freedom& freedom) const {
        std::vector<Node> nodes;
        for (const std::size_t k : freedom.positions) nodes.push_back(q_[k]);
        for (const std::size_t k : freedom.momenta) nodes.push_back(p_[k]);
        return nodes;
    }

    /// Returns the degrees of freedom that couple, of those that the function moves.
    [[nodiscard]] std::vector<std::vector<std::size_t>> components() const {
        std::vector<std::size_t> owner(freedoms_.size());
        std::iota(owner.begin(), owner.end(), 0);
        for (std::size_t i = 0; i < freedoms_.size(); ++i) {
            for (std::size_t j = 0; j < freedoms_.size(); ++j) {
                if (owner[i] == owner[j]) continue;
                if (!depend(slopes_of(freedoms_[i]), variables_of(freedoms_[j]))) continue;
                std::replace(owner.begin(), owner.end(), std::max(owner[i], owner[j]),
                             std::min(owner[i], owner[j]));
            }
        }
        std::vector<std::vector<std::size_t>> result;
        for (std::size_t first = 0; first < freedoms_.size(); ++first) {
            std::vector<std::size_t> together;
            for (std::size_t k = first; k < freedoms_.size(); ++k)
                if (owner[k] == first && moves(freedoms_[k])) together.push_back(k);
            if (!together.empty()) result.push_back(std::move(together));
        }
        return result;
    }

    [[nodiscard]] bool moves(const Freedom& freedom) const {
        const std::vector<Scaled> slopes = slopes_of(freedom);
        return std::any_of(slopes.begin(), slopes.end(),
                           [](const Scaled& slope) { return !slope.is_zero(); });
    }

    [[nodiscard]] std::string names(const std::vector<std::size_t>& together) const {
        std::vector<std::string> result;
        for (const std::size_t k : together) {
            result.push_back(system_.coordinates[k].name);
            result.push_back(system_.conjugates[k].name);
        }
        return fmt::format("{}", fmt::join(result, ", "));
    }

    // ---- the kinds of flows ----

    /// Returns a value times the time. NOTE: factors that do not vary, numbers among them, go with
    /// the time, and are one value that is computed when that changes.
    [[nodiscard]] Scaled over_time(const Scaled& value) {
        Scaled fixed = graph_.times(value.factor, tau_), rest{{1, 1}, value.node};
        const Computation computation = graph_.at(value.node);
        const auto varies_at = [&](Node node) { return varies(graph_.at(node).roles); };
        if (computation.operation == Operation::product) {
            const auto [a, b] = std::pair(computation.arguments[0], computation.arguments[1]);
            if (varies_at(a) != varies_at(b)) {
                fixed = graph_.product(fixed, input(varies_at(a) ? b : a));
                rest = input(varies_at(a) ? a : b);
            }
        }
        return graph_.product(graph_.settled(fixed), rest);
    }

    /// Adds the changes of degrees of freedom that couple. Returns the kind; empty where no flow is
    /// known.
    std::string add(const std::vector<std::size_t>& together) {
        if (add_shear(together)) return "a shear";
        if (add_orbits(together)) return name_of_orbits;
        if (together.size() > 1) return add_form(together) ? "a coupled quadratic form" : "";
        const Freedom& one = freedoms_[together.front()];
        if (is_body(one)) return add_turn(one) ? "a turn about an axis of a body" : "";
        if (add_quadratic(one) || add_form(together)) return "a quadratic form";
        return add_function_of_quadratic(one) ? "a function of a quadratic form" : "";
    }

    void add(bool is_conjugate, std::size_t component, const Scaled& change) {
        if (!change.is_zero()) moved_.push_back({is_conjugate, component, change});
    }

    /// Adds kicks, drifts and torques where no slope depends on what moves. NOTE: the rotation of a
    /// body stands where no slope by its angular momentum is there.
    bool add_shear(const std::vector<std::size_t>& together) {
        std::vector<Scaled> slopes;
        std::vector<Node> moving;
        for (const std::size_t k : together) {
            const Freedom& freedom = freedoms_[k];
            const auto move = [&](const Scaled& slope, Node node) {
                slopes.push_back(slope);
                if (!slope.is_zero()) moving.push_back(node);
            };
            for (std::size_t a = 0; a < freedom.degrees.size(); ++a)
                move(by_q_[freedom.degrees[a]], p_[freedom.momenta[a]]);
            for (std::size_t a = 0; a < freedom.momenta.size(); ++a) {
                const Scaled& velocity = by_p_[freedom.momenta[a]];
                if (is_body(freedom) && !velocity.is_zero()) return false;
                if (!is_body(freedom)) move(velocity, q_[freedom.positions[a]]);
            }
        }
        if (depend(slopes, moving)) return false;
        for (const std::size_t k : together) {
            const Freedom& freedom = freedoms_[k];
            for (std::size_t a = 0; a < freedom.degrees.size(); ++a) {
                const Scaled slope = by_q_[freedom.degrees[a]];
                add(true, freedom.momenta[a], graph_.times({-1, 1}, over_time(slope)));
            }
            if (is_body(freedom)) continue;
            const std::size_t k_q = freedom.positions.front();
            add(false, k_q, over_time(by_p_[freedom.momenta.front()]));
        }
        return true;
    }

    /// Adds orbits about each other of bodies that do not turn.
    bool add_orbits(const std::vector<std::size_t>& together) {
        std::vector<std::size_t> numbers;
        std::vector<Node> q, p;
        for (const std::size_t k : together) {
            if (is_body(freedoms_[k])) return false;
            numbers.push_back(freedoms_[k].positions.front());
            q.push_back(q_[numbers.back()]);
            p.push_back(p_[numbers.back()]);
        }
        const auto form = orbit_form_of(graph_, function_, q, p);
        if (!form || !are_apart(graph_, *form)) return false;
        Flow flow = flow_of_orbits(graph_, *form, q, p, tau_.node);
        for (const Moved& moved : flow.moved)
            add(moved.is_conjugate, numbers[moved.component], moved.change);
        std::move(flow.in_each_flow.begin(), flow.in_each_flow.end(),
                  std::back_inserter(in_each_flow_));
        return true;
    }

    /// Adds a turn about an axis k of a body. With w = dH/dL_k it is L_i' = w L_j, L_j' = -w L_i
    /// for i, j, k in turn, and the columns i and j of R alike, since R' = R hat(w e_k). NOTE: what
    /// the shears do to R is the inverse of what they do to L, so that R L keeps its value however
    /// they are rounded.
    bool add_turn(const Freedom& body) {
        std::optional<std::size_t> axis;
        for (std::size_t a = 0; a < 3; ++a) {
            if (!by_q_[body.degrees[a]].is_zero()) return false;
            if (by_p_[body.momenta[a]].is_zero()) continue;
            if (axis) return false;
            axis = a;
        }
        const std::size_t k = axis.value(), i = (k + 1) % 3, j = (k + 2) % 3;
        const Scaled speed = by_p_[body.momenta[k]];
        std::vector<Node> others = variables_of(body);
        std::erase(others, p_[body.momenta[k]]);
        if (depend({speed}, others)) return false;
        const Scaled half_angle = over_time(graph_.times({1, 2}, speed));
        const Shears shears = rotation(graph_, angles_, half_angle);
        const std::size_t L_i = body.momenta[i], L_j = body.momenta[j];
        const PlaneChange of_L = sheared(graph_, input(p_[L_i]), input(p_[L_j]), shears);
        add(true, L_i, of_L.x);
        add(true, L_j, of_L.y);
        const auto back = [&](const Scaled& shear) { return graph_.times({-1, 1}, shear); };
        const Shears inverse{back(shears.first), back(shears.middle), back(shears.last),
                             shears.sign};
        for (std::size_t row = 0; row < 3; ++row) {
            const std::size_t R_i = body.positions[3 * row + i], R_j = body.positions[3 * row + j];
            const PlaneChange of_R = sheared(graph_, input(q_[R_j]), input(q_[R_i]), inverse);
            add(false, R_j, of_R.x);
            add(false, R_i, of_R.y);
        }
        return true;
    }

    [[nodiscard]] static Scaled input(Node node) { return {{1, 1}, node}; }

    /// Returns the second derivatives at q = p = 0.
    [[nodiscard]] std::optional<PlaneForm> form_at_origin(Node q, Node p) {
        const std::vector<Scaled> by_q = gradient(graph_, slope_by_q_, {q, p});
        const std::vector<Scaled> by_p = gradient(graph_, slope_by_p_, {p});
        const auto a = at_origin(graph_, by_q[0]), c = at_origin(graph_, by_q[1]);
        const auto b = at_origin(graph_, by_p[0]);
        if (!a || !b || !c) return {};
        return PlaneForm{*a, *b, *c};
    }

    bool add_quadratic(const Freedom& one) {
        const std::size_t k = one.positions.front();
        slope_by_q_ = by_q_[k];
        slope_by_p_ = by_p_[k];
        const auto form = form_at_origin(q_[k], p_[k]);
        if (!form || !is_gradient_of(*form, q_[k], p_[k])) return false;
        return add_oscillation(k, *form, graph_.times({1, 2}, tau_));
    }

    /// Returns the gradient of the form.
    [[nodiscard]] std::array<Scaled, 2> slopes(const PlaneForm& form, Node q, Node p) {
        const auto& [a, b, c] = form;
        return {graph_.sum({graph_.product(a, input(q)), graph_.product(c, input(p))}),
                graph_.sum({graph_.product(c, input(q)), graph_.product(b, input(p))})};
    }

    [[nodiscard]] bool is_gradient_of(const PlaneForm& form, Node q, Node p) {
        const auto [by_q, by_p] = slopes(form, q, p);
        return is_proved_zero(graph_, difference_of(graph_, slope_by_q_, by_q)) &&
               is_proved_zero(graph_, difference_of(graph_, slope_by_p_, by_p));
    }

    /// Adds the flow of a form over a time, of which the half is given. NOTE: where b = 0 it is
    /// that of a p^2/2 + b q^2/2 - c q p, with q in the place of p and -p in that of q.
    bool add_oscillation(std::size_t k, const PlaneForm& form, const Scaled& half_time) {
        const bool is_exchanged = form.b.is_zero();
        if (is_exchanged && form.a.is_zero()) return false;
        PlaneForm upright = form;
        if (is_exchanged) upright = {form.b, form.a, graph_.times({-1, 1}, form.c)};
        Shears shears = oscillation(graph_, angles_, upright, half_time);
        const Scaled q = input(q_[k]), p = input(p_[k]);
        if (!is_exchanged) {
            const PlaneChange change = sheared(graph_, p, q, shears);
            add(true, k, change.x);
            add(false, k, change.y);
            return true;
        }
        for (Scaled* shear : {&shears.first, &shears.middle, &shears.last}) {
            *shear = graph_.times({-1, 1}, *shear);
        }
        const PlaneChange change = sheared(graph_, q, p, shears);
        add(false, k, change.x);
        add(true, k, change.y);
        return true;
    }

    /// Adds the flow of a quadratic form of several degrees of freedom, or of one that three shears
    /// do not move: q p, or with linear terms.
    bool add_form(const std::vector<std::size_t>& together) {
        if (together.size() > most_coupled) return false;
        std::vector<Node> variables;
        std::vector<Scaled> slopes;
        for (const std::size_t k : together) {
            if (is_body(freedoms_[k])) return false;
            variables.push_back(q_[k]);
            slopes.push_back(by_q_[k]);
        }
        for (const std::size_t k : together) {
            variables.push_back(p_[k]);
            slopes.push_back(by_p_[k]);
        }
        auto rows = rows_of_form(graph_, slopes, variables);
        if (!rows) return false;
        forms_.push_back({together, std::move(*rows)});
        return true;
    }

    /// Adds the flow of f(Q): that of Q over the time f'(Q) tau. NOTE: Q is looked for among forms
    /// that stand in the graph of the function.
    bool add_function_of_quadratic(const Freedom& one) {
        const std::size_t k = one.positions.front();
        const Node q = q_[k], p = p_[k];
        for (const PlaneForm& form : candidates(q, p)) {
            const auto [by_q, by_p] = slopes(form, q, p);
            const Scaled bracket = difference_of(graph_, graph_.product(slope_by_q_, by_p),
                                                 graph_.product(slope_by_p_, by_q));
            if (form.b.is_zero() || !is_proved_zero(graph_, bracket)) continue;
            const auto speed = speed_of(form, q, p);
            if (!speed) continue;
            const Scaled half_time = over_time(graph_.times({1, 2}, *speed));
            if (add_oscillation(k, form, half_time)) return true;
        }
        return false;
    }

    /// Returns quadratic forms that the function may depend on: its own second derivatives, and
    /// those of all that it is computed from.
    [[nodiscard]] std::vector<PlaneForm> candidates(Node q, Node p) {
        std::vector<PlaneForm> forms;
        const auto size = static_cast<Node>(graph_.size());
        for (Node node = 0; node < size; ++node) {
            const Scaled value = input(node);
            const bool is_of_both = depend({value}, {q}) && depend({value}, {p});
            if (!is_of_both || !depend({function_}, {node})) continue;
            const std::vector<Scaled> first = gradient(graph_, value, {q, p});
            const std::vector<Scaled> by_q = gradient(graph_, first[0], {q, p});
            const std::vector<Scaled> by_p = gradient(graph_, first[1], {p});
            const auto a = constant_value(graph_, by_q[0]), c = constant_value(graph_, by_q[1]);
            const auto b = constant_value(graph_, by_p[0]);
            if (a && b && c && !b->is_zero()) forms.push_back({*a, *b, *c});
        }
        return forms;
    }

    /// Returns f'(Q) at the variables. For q = 0 the form is b p^2/2, and f(Q) is the function at p
    /// = sqrt(2 Q/b).
    [[nodiscard]] std::optional<Scaled> speed_of(const PlaneForm& form, Node q, Node p) {
        const Scaled Q = graph_.input("value of a quadratic form", Role::direction);
        const Scaled square = graph_.product(graph_.times({2, 1}, Q), graph_.inverse(form.b));
        const Scaled f =
            replaced(graph_, function_, {{q, Graph::number(0)}, {p, graph_.half_power(square, 1)}});
        const Scaled slope = gradient(graph_, f, {Q.node}).front();
        const auto [by_q, by_p] = slopes(form, q, p);
        const Scaled value = graph_.times(
            {1, 2}, graph_.sum({graph_.product(input(q), by_q), graph_.product(input(p), by_p)}));
        const Scaled speed = replaced(graph_, slope, {{Q.node, value}});
        // NOTE: the slope was derived for one sign of p; here it is proved for both.
        const bool is_it =
            is_proved_zero(graph_,
                           difference_of(graph_, slope_by_p_, graph_.product(speed, by_p))) &&
            is_proved_zero(graph_, difference_of(graph_, slope_by_q_, graph_.product(speed, by_q)));
        return is_it ? std::optional(speed) : std::nullopt;
    }

    System& system_;
    Graph& graph_;
    Scaled function_;
    TurnAngles& angles_;
    Scaled tau_;
    std::vector<Node> q_, p_;
    std::vector<Scaled> by_p_, by_q_;
    std::vector<Freedom> freedoms_;
    std::vector<Moved> moved_;
    std::vector<RuntimeValues> in_each_flow_;
    std::vector<FormMoved> forms_;
    Scaled slope_by_q_, slope_by_p_;  ///< of the degree of freedom that is looked at
};

}  // namespace

std::variant<Flow, NoFlow> flow_of(System& system, const Scaled& function, Node duration) {
    TurnAngles angles;
    std::variant<Flow, NoFlow> result = FunctionWithFlow(system, function, duration, angles)();
    auto* flow = std::get_if<Flow>(&result);
    if (flow == nullptr || angles.conditions.empty()) return result;
    TurnAngles small{true};
    std::variant<Flow, NoFlow> usual = FunctionWithFlow(system, function, duration, small)();
    flow->usual = {std::move(small.conditions), std::move(std::get<Flow>(usual).moved)};
    return result;
}

}  // namespace hvi::gen
