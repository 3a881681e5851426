// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/function_of_forms.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"

namespace hvi::gen {

namespace {

using Forms = std::vector<PlaneForm>;

Scaled value_of_node(Node node) { return {{1, 1}, node}; }

/// Returns Q = sum_k (q_k dQ/dq_k + p_k dQ/dp_k)/2.
Scaled value_of_forms(Graph& graph, const Forms& forms, const SlopesOfDegrees& of) {
    std::vector<Scaled> terms;
    for (std::size_t k = 0; k < forms.size(); ++k) {
        const auto [by_q, by_p] = slopes_of_form(graph, forms[k], of.q[k], of.p[k]);
        terms.push_back(graph.product(value_of_node(of.q[k]), by_q));
        terms.push_back(graph.product(value_of_node(of.p[k]), by_p));
    }
    return graph.times({1, 2}, graph.sum(std::move(terms)));
}

std::vector<Node> variables_of_degrees(const SlopesOfDegrees& of) {
    std::vector<Node> variables = of.q;
    variables.insert(variables.end(), of.p.begin(), of.p.end());
    return variables;
}

/// Returns the second derivatives of a value as forms; nothing where they vary, or couple degrees
/// of freedom, or where the value has linear terms.
std::optional<Forms> forms_of(Graph& graph, const Scaled& value, const SlopesOfDegrees& of) {
    const std::vector<Node> variables = variables_of_degrees(of);
    const std::size_t degrees = of.q.size();
    Forms forms(degrees);
    const std::vector<Scaled> slopes = gradient(graph, value, variables);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const auto linear = at_origin(graph, slopes[i]);
        if (!linear || !linear->is_zero()) { return std::nullopt; }
        const std::vector<Scaled> second = gradient(graph, slopes[i], variables);
        for (std::size_t j = i; j < second.size(); ++j) {
            const auto entry = constant_value(graph, second[j]);
            const bool couples = i % degrees != j % degrees;
            if (!entry || (couples && !entry->is_zero())) { return std::nullopt; }
            if (couples) { continue; }
            PlaneForm& form = forms[i % degrees];
            (i != j ? form.c : i < degrees ? form.a : form.b) = *entry;
        }
    }
    return forms;
}

/// Returns f'(Q) at the variables. Where all others are 0 the form is b p^2/2 of one momentum, and
/// f(Q) is the function at p = sqrt(2 Q/b). Precondition: b of this degree of freedom is not zero.
Scaled speed_of(Graph& graph, const Scaled& function, const Forms& forms, std::size_t degree,
                const SlopesOfDegrees& of) {
    const Scaled Q = graph.input("value of a quadratic form", Role::direction);
    const Scaled square = graph.product(graph.times({2, 1}, Q), graph.inverse(forms[degree].b));
    std::map<Node, Scaled> point;
    for (const Node q : of.q) { point[q] = Graph::number(0); }
    for (const Node p : of.p) { point[p] = Graph::number(0); }
    point[of.p[degree]] = graph.half_power(square, 1);
    const Scaled slope = gradient(graph, replaced(graph, function, point), {Q.node}).front();
    return replaced(graph, slope, {{Q.node, value_of_forms(graph, forms, of)}});
}

/// Returns whether the slopes are those of Q times the speed, which is proved.
bool are_slopes(Graph& graph, const Forms& forms, const Scaled& speed, const SlopesOfDegrees& of) {
    const auto is_slope = [&](const Scaled& slope, const Scaled& of_form) {
        return is_proved_zero(graph, difference_of(graph, slope, graph.product(speed, of_form)));
    };
    for (std::size_t k = 0; k < forms.size(); ++k) {
        const auto [by_q, by_p] = slopes_of_form(graph, forms[k], of.q[k], of.p[k]);
        if (!is_slope(of.by_p[k], by_p) || !is_slope(of.by_q[k], by_q)) { return false; }
    }
    return true;
}

/// Returns whether the slopes are those of Q times one factor, which is proved: df/dz dQ/dp =
/// df/dp dQ/dz for each variable z and this momentum p. NOTE: it keeps other forms from being put
/// into the function, which might divide by zero there.
bool are_parallel(Graph& graph, const Forms& forms, std::size_t degree, const SlopesOfDegrees& of) {
    const auto form_slopes = [&](std::size_t k) {
        return slopes_of_form(graph, forms[k], of.q[k], of.p[k]);
    };
    const Scaled &slope = of.by_p[degree], of_form = form_slopes(degree).second;
    const auto is_parallel = [&](const Scaled& f_z, const Scaled& Q_z) {
        return is_proved_zero(
            graph, difference_of(graph, graph.product(f_z, of_form), graph.product(slope, Q_z)));
    };
    for (std::size_t k = 0; k < forms.size(); ++k) {
        const auto [by_q, by_p] = form_slopes(k);
        if (!is_parallel(of.by_q[k], by_q) || !is_parallel(of.by_p[k], by_p)) { return false; }
    }
    return true;
}

bool has_momentum(const PlaneForm& form) { return !form.b.is_zero(); }

/// Returns whether three shears move each form, and the flow of one of them begins with p.
bool have_flow(const Forms& forms) {
    return std::any_of(forms.begin(), forms.end(), has_momentum) &&
           std::none_of(forms.begin(), forms.end(),
                        [](const PlaneForm& form) { return form.a.is_zero() && form.b.is_zero(); });
}

/// Returns the derivative by a node of a function that is one of this node, as it is written; else
/// nothing.
std::optional<Scaled> slope_by_node(Graph& graph, const Scaled& function, Node node,
                                    const SlopesOfDegrees& of) {
    const Scaled value = graph.input("value of a quadratic form", Role::direction);
    const Scaled of_value = replaced(graph, function, {{node, value}});
    if (depend(graph, {of_value}, variables_of_degrees(of))) { return std::nullopt; }
    const Scaled slope = gradient(graph, of_value, {value.node}).front();
    return replaced(graph, slope, {{value.node, value_of_node(node)}});
}

/// Returns whether a value depends on a variable of each degree of freedom.
bool depends_on_all(const Graph& graph, const Scaled& value, const SlopesOfDegrees& of) {
    for (std::size_t k = 0; k < of.q.size(); ++k) {
        if (!depend(graph, {value}, {of.q[k], of.p[k]})) { return false; }
    }
    return true;
}

}  // namespace

std::pair<Scaled, Scaled> slopes_of_form(Graph& graph, const PlaneForm& form, Node q, Node p) {
    const auto& [a, b, c] = form;
    const Scaled at_q = value_of_node(q), at_p = value_of_node(p);
    return {graph.sum({graph.product(a, at_q), graph.product(c, at_p)}),
            graph.sum({graph.product(c, at_q), graph.product(b, at_p)})};
}

std::optional<Scaled> speed_of_forms(Graph& graph, const Scaled& function,
                                     const std::vector<PlaneForm>& forms,
                                     const SlopesOfDegrees& slopes) {
    const auto upright = std::find_if(forms.begin(), forms.end(), has_momentum);
    const auto degree = static_cast<std::size_t>(upright - forms.begin());
    if (!are_parallel(graph, forms, degree, slopes)) { return std::nullopt; }
    const Scaled speed = speed_of(graph, function, forms, degree, slopes);
    return are_slopes(graph, forms, speed, slopes) ? std::optional(speed) : std::nullopt;
}

std::optional<FunctionOfForms> function_of_forms(Graph& graph, const Scaled& function,
                                                 const SlopesOfDegrees& slopes) {
    const auto size = static_cast<Node>(graph.size());
    for (Node node = 0; node < size; ++node) {
        const Scaled value = value_of_node(node);
        if (!depends_on_all(graph, value, slopes)) { continue; }
        if (!depend(graph, {function}, {node})) { continue; }
        const auto forms = forms_of(graph, value, slopes);
        if (!forms || !have_flow(*forms)) { continue; }
        // NOTE: the first needs no proof, and roots of forms have none.
        auto speed = slope_by_node(graph, function, node, slopes);
        if (!speed) { speed = speed_of_forms(graph, function, *forms, slopes); }
        if (speed) { return FunctionOfForms{*forms, *speed}; }
    }
    return std::nullopt;
}

}  // namespace hvi::gen
