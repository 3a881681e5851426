// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/flows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "generator/lower/body_flow.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/flow_changes.hpp"
#include "generator/lower/form_flow.hpp"
#include "generator/lower/function_of_forms.hpp"
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
          changes_(system.graph, duration),
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
            if (kind.empty()) return NoFlow{reason_at(together)};
            if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
        }
        return std::move(changes_).flow(fmt::format("{}", fmt::join(kinds, ", ")));
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

    [[nodiscard]] static std::vector<Node> nodes_of(const std::vector<Node>& all,
                                                    const std::vector<std::size_t>& components) {
        std::vector<Node> nodes;
        for (const std::size_t k : components) nodes.push_back(all[k]);
        return nodes;
    }

    [[nodiscard]] std::vector<Node> variables_of(const Freedom& freedom) const {
        std::vector<Node> nodes = nodes_of(q_, freedom.positions);
        const std::vector<Node> momenta = nodes_of(p_, freedom.momenta);
        nodes.insert(nodes.end(), momenta.begin(), momenta.end());
        return nodes;
    }

    /// Returns the degrees of freedom that couple, of those that the function moves.
    [[nodiscard]] std::vector<std::vector<std::size_t>> components() const {
        std::vector<std::size_t> owner(freedoms_.size());
        std::iota(owner.begin(), owner.end(), 0);
        for (std::size_t i = 0; i < freedoms_.size(); ++i) {
            for (std::size_t j = 0; j < freedoms_.size(); ++j) {
                if (owner[i] == owner[j]) continue;
                if (!depend(graph_, slopes_of(freedoms_[i]), variables_of(freedoms_[j]))) continue;
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

    [[nodiscard]] std::string reason_at(const std::vector<std::size_t>& together) const {
        return fmt::format("no flow is known where {} move{}", names(together),
                           varies_with_time(together) ? " by what depends on the time" : "");
    }

    // ---- the kinds of flows ----

    /// Returns whether slopes depend on the time. NOTE: what is constant in the flow of a form is
    /// computed when h changes, and not whenever the time does.
    [[nodiscard]] bool varies_with_time(const std::vector<std::size_t>& together) const {
        return std::any_of(together.begin(), together.end(), [&](std::size_t k) {
            const std::vector<Scaled> slopes = slopes_of(freedoms_[k]);
            return std::any_of(slopes.begin(), slopes.end(), [&](const Scaled& slope) {
                return has(graph_.at(slope.node).roles, Role::time);
            });
        });
    }

    /// Adds the changes of degrees of freedom that couple. Returns the kind; empty where no flow is
    /// known.
    std::string add(const std::vector<std::size_t>& together) {
        if (add_shear(together)) return "a shear";
        if (varies_with_time(together)) return "";
        if (add_orbits(together)) return name_of_orbits;
        const Freedom& one = freedoms_[together.front()];
        const bool is_one = together.size() == 1;
        if (is_one && is_body(one)) return add_body_flow(changes_, angles_, function_of_body(one));
        if (is_one && add_quadratic(one)) return "a quadratic form";
        if (add_form(together)) return is_one ? "a quadratic form" : "a coupled quadratic form";
        return add_function_of_forms(together) ? "a function of a quadratic form" : "";
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
        if (depend(graph_, slopes, moving)) return false;
        for (const std::size_t k : together) {
            const Freedom& freedom = freedoms_[k];
            for (std::size_t a = 0; a < freedom.degrees.size(); ++a) {
                const Scaled slope = by_q_[freedom.degrees[a]];
                changes_.add(true, freedom.momenta[a],
                             graph_.times({-1, 1}, changes_.over_time(slope)));
            }
            if (is_body(freedom)) continue;
            const std::size_t k_q = freedom.positions.front();
            changes_.add(false, k_q, changes_.over_time(by_p_[freedom.momenta.front()]));
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
        Flow flow = flow_of_orbits(graph_, *form, q, p, changes_.time().node);
        for (const Moved& moved : flow.moved)
            changes_.add(moved.is_conjugate, numbers[moved.component], moved.change);
        for (RuntimeValues& values : flow.in_each_flow) changes_.add(std::move(values));
        return true;
    }

    [[nodiscard]] FunctionOfBody function_of_body(const Freedom& freedom) const {
        FunctionOfBody body{
            function_, nodes_of(q_, freedom.positions), nodes_of(p_, freedom.momenta), {},
            {},        freedom.positions.front(),       freedom.momenta.front()};
        for (const std::size_t k : freedom.degrees) body.by_turns.push_back(by_q_[k]);
        for (const std::size_t k : freedom.momenta) body.by_L.push_back(by_p_[k]);
        return body;
    }

    [[nodiscard]] static Scaled input(Node node) { return {{1, 1}, node}; }

    /// Returns the second derivatives of one degree of freedom at q = p = 0.
    [[nodiscard]] std::optional<PlaneForm> form_at_origin(std::size_t k) {
        const std::vector<Scaled> by_q = gradient(graph_, by_q_[k], {q_[k], p_[k]});
        const std::vector<Scaled> by_p = gradient(graph_, by_p_[k], {p_[k]});
        const auto a = at_origin(graph_, by_q[0]), c = at_origin(graph_, by_q[1]);
        const auto b = at_origin(graph_, by_p[0]);
        if (!a || !b || !c) return {};
        return PlaneForm{*a, *b, *c};
    }

    bool add_quadratic(const Freedom& one) {
        const std::size_t k = one.positions.front();
        const auto form = form_at_origin(k);
        if (!form || !has_slopes_of(*form, k)) return false;
        return add_oscillation(k, *form, graph_.times({1, 2}, changes_.time()));
    }

    /// Returns whether the slopes of one degree of freedom are those of the form, which is proved.
    [[nodiscard]] bool has_slopes_of(const PlaneForm& form, std::size_t k) {
        const auto [by_q, by_p] = slopes_of_form(graph_, form, q_[k], p_[k]);
        return is_proved_zero(graph_, difference_of(graph_, by_q_[k], by_q)) &&
               is_proved_zero(graph_, difference_of(graph_, by_p_[k], by_p));
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
            changes_.add(true, k, change.x);
            changes_.add(false, k, change.y);
            return true;
        }
        for (Scaled* shear : {&shears.first, &shears.middle, &shears.last}) {
            *shear = graph_.times({-1, 1}, *shear);
        }
        const PlaneChange change = sheared(graph_, q, p, shears);
        changes_.add(false, k, change.x);
        changes_.add(true, k, change.y);
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
        changes_.add(FormMoved{together, std::move(*rows)});
        return true;
    }

    /// Adds the flow of f(Q): that of Q over the time f'(Q) tau.
    bool add_function_of_forms(const std::vector<std::size_t>& together) {
        if (together.size() > most_coupled) return false;
        SlopesOfDegrees slopes;
        for (const std::size_t k : together) {
            if (is_body(freedoms_[k])) return false;
            slopes.q.push_back(q_[k]);
            slopes.p.push_back(p_[k]);
            slopes.by_q.push_back(by_q_[k]);
            slopes.by_p.push_back(by_p_[k]);
        }
        const auto found = function_of_forms(graph_, function_, slopes);
        if (!found) return false;
        const Scaled half_time = changes_.over_time(graph_.times({1, 2}, found->speed));
        for (std::size_t k = 0; k < together.size(); ++k)
            add_oscillation(together[k], found->forms[k], half_time);
        return true;
    }

    System& system_;
    Graph& graph_;
    Scaled function_;
    TurnAngles& angles_;
    FlowChanges changes_;
    std::vector<Node> q_, p_;
    std::vector<Scaled> by_p_, by_q_;
    std::vector<Freedom> freedoms_;
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
