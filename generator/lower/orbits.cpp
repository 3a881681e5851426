// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/orbits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/form_flow.hpp"

namespace hvi::gen {

namespace {

Scaled node_itself(Node node) { return {{1, 1}, node}; }

/// Returns the value of a linear form; `values` are those of the variables.
Scaled value_of_form(Graph& graph, const LinearForm& form, const std::vector<Scaled>& values) {
    std::vector<Scaled> terms;
    for (std::size_t a = 0; a < form.size(); ++a)
        if (!form[a].is_zero()) terms.push_back(graph.product(form[a], values[a]));
    return graph.sum(std::move(terms));
}

std::vector<Scaled> values_of(const std::vector<Node>& nodes) {
    std::vector<Scaled> values;
    for (const Node node : nodes) values.push_back(node_itself(node));
    return values;
}

// ---- recognition ----

/// Returns the symmetric matrix W where the function is x^T W x/2 and a constant, which is proved.
std::optional<std::vector<LinearForm>> matrix_of(Graph& graph, const Scaled& function,
                                                 const std::vector<Node>& x) {
    const auto rows = rows_of_form(graph, gradient(graph, function, x), x);
    if (!rows) return {};
    const std::size_t size = x.size();
    std::vector<LinearForm> matrix(size, LinearForm(size));
    auto next = rows->begin();
    for (std::size_t a = 0; a < size; ++a) {
        for (std::size_t b = a; b < size; ++b) matrix[a][b] = matrix[b][a] = *next++;
        if (!is_proved_zero(graph, *next++)) return {};
    }
    return matrix;
}

/// The square w sum_c (l_c x)^2.
struct SquareOfVector {
    std::vector<LinearForm> components;  ///< l_c, without a variable in common
    Scaled factor;                       ///< w
};

/// Returns x^T W x as such a square where it is one.
std::optional<SquareOfVector> square_of_vector(Graph& graph, std::vector<LinearForm> matrix) {
    SquareOfVector square{{}, Graph::number(1)};
    const std::size_t size = matrix.size();
    std::vector<bool> is_left(size, true);
    const auto pivot = [&] {
        std::size_t best = size;
        for (std::size_t a = 0; a < size; ++a) {
            if (!is_left[a] || is_proved_zero(graph, matrix[a][a])) continue;
            if (matrix[a][a] == Graph::number(1)) return a;
            best = std::min(best, a);
        }
        return best;
    };
    for (std::size_t a = pivot(); a < size; a = pivot()) {
        const Scaled factor = matrix[a][a], below = graph.inverse(factor);
        if (square.components.empty()) square.factor = factor;
        if (!is_proved_zero(graph, difference_of(graph, factor, square.factor))) return {};
        LinearForm form;
        for (std::size_t b = 0; b < size; ++b) form.push_back(graph.product(matrix[a][b], below));
        for (std::size_t b = 0; b < size; ++b) {
            if (form[b].is_zero()) continue;
            is_left[b] = false;
            for (std::size_t c = 0; c < size; ++c) {
                const Scaled rest = difference_of(
                    graph, matrix[b][c], graph.product(factor, graph.product(form[b], form[c])));
                if (!is_proved_zero(graph, rest)) return {};
            }
        }
        square.components.push_back(std::move(form));
    }
    const bool is_empty = square.components.empty();
    return is_empty ? std::nullopt : std::optional(std::move(square));
}

}  // namespace

std::map<Node, Scaled> inverse_roots(const Graph& graph, const Scaled& function) {
    std::map<Node, Scaled> roots;
    std::set<Node> open{function.node};
    while (!open.empty()) {
        const Node node = *open.rbegin();
        open.erase(node);
        const Computation& computation = graph.at(node);
        if (!varies(computation.roles)) continue;
        if (computation.operation == Operation::inverse_square_root)
            roots[node] = node_itself(computation.arguments.front());
        for (const Scaled& term : computation.terms) open.insert(term.node);
        for (const Node argument : computation.arguments) open.insert(argument);
    }
    return roots;
}

std::optional<Attraction> attraction_of(Graph& graph, const Scaled& square,
                                        const std::vector<Node>& q) {
    const auto start = at_origin(graph, square);
    if (!start || !is_proved_zero(graph, *start)) return {};
    const auto matrix = matrix_of(graph, graph.times({1, 2}, square), q);
    const auto vector = matrix ? square_of_vector(graph, *matrix) : std::nullopt;
    if (!vector) return {};
    return Attraction{vector->components, graph.half_power(vector->factor, -1)};
}

std::optional<OrbitForm> orbit_form_of(Graph& graph, const Scaled& function,
                                       const std::vector<Node>& q, const std::vector<Node>& p) {
    OrbitForm form;
    std::map<Node, Scaled> inverses;
    std::vector<Node> distances;
    for (const auto& [root, square] : inverse_roots(graph, function)) {
        const std::vector<Scaled> slopes = gradient(graph, square, q);
        if (std::all_of(slopes.begin(), slopes.end(),
                        [](const Scaled& slope) { return slope.is_zero(); }))
            continue;
        auto attraction = attraction_of(graph, square, q);
        if (!attraction) return {};
        const Scaled inverse =
            graph.input(fmt::format("inverse distance {}", distances.size()), Role::direction);
        inverses[root] = inverse;
        distances.push_back(inverse.node);
        form.attractions.push_back(*std::move(attraction));
    }
    if (distances.empty()) return {};
    // With the inverse distances as variables the function is linear in them, and else kinetic.
    const Scaled plain = replaced(graph, function, inverses);
    const std::vector<Scaled> slopes = gradient(graph, plain, distances);
    Scaled kinetic = plain;
    for (std::size_t j = 0; j < slopes.size(); ++j) {
        const auto slope = constant_value(graph, slopes[j]);
        if (!slope) return {};
        Scaled& strength = form.attractions[j].strength;
        strength = graph.product(graph.times({-1, 1}, *slope), strength);
        kinetic = difference_of(graph, kinetic, graph.product(*slope, node_itself(distances[j])));
    }
    for (const Scaled& slope : gradient(graph, kinetic, q))
        if (!is_proved_zero(graph, slope)) return {};
    auto matrix = matrix_of(graph, kinetic, p);
    if (!matrix) return {};
    form.kinetic = *std::move(matrix);
    return form;
}

namespace {

/// Returns the rows l K of the components of all vectors, in their order.
std::vector<std::vector<LinearForm>> rates(Graph& graph, const OrbitForm& form) {
    std::vector<std::vector<LinearForm>> result;
    for (const Attraction& attraction : form.attractions) {
        std::vector<LinearForm> rows;
        for (const LinearForm& component : attraction.components) {
            LinearForm row;
            for (const LinearForm& column : form.kinetic)
                row.push_back(value_of_form(graph, component, column));
            rows.push_back(std::move(row));
        }
        result.push_back(std::move(rows));
    }
    return result;
}

}  // namespace

bool are_apart(Graph& graph, const OrbitForm& form) {
    struct Component {
        std::size_t orbit;
        const LinearForm *form, *rate;  ///< l and l K
    };
    const auto all_rates = rates(graph, form);
    std::vector<Component> all;
    for (std::size_t j = 0; j < form.attractions.size(); ++j)
        for (std::size_t c = 0; c < all_rates[j].size(); ++c)
            all.push_back({j, &form.attractions[j].components[c], &all_rates[j][c]});
    std::vector<Scaled> inverse_masses(form.attractions.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Scaled own = value_of_form(graph, *all[i].form, *all[i].rate);
        Scaled& of_orbit = inverse_masses[all[i].orbit];
        const bool is_first = i == 0 || all[i - 1].orbit != all[i].orbit;
        if (is_first) of_orbit = own;
        if (is_proved_zero(graph, own)) return false;
        if (!is_proved_zero(graph, difference_of(graph, own, of_orbit))) return false;
        for (std::size_t k = 0; k < i; ++k)
            if (!is_proved_zero(graph, value_of_form(graph, *all[k].form, *all[i].rate)))
                return false;
    }
    return true;
}

namespace {

/// Builds the flow of orbits.
class OrbitMotion {
public:
    OrbitMotion(Graph& graph, const OrbitForm& form, const std::vector<Node>& q,
                const std::vector<Node>& p, Node duration)
        : graph_(graph),
          form_(form),
          q_(values_of(q)),
          tau_(node_itself(duration)),
          rates_(rates(graph, form)) {
        for (const LinearForm& row : form.kinetic)
            velocity_.push_back(value_of_form(graph, row, values_of(p)));
        of_q_.resize(q.size());
        of_p_.resize(q.size());
    }

    [[nodiscard]] Flow operator()() {
        for (std::size_t a = 0; a < q_.size(); ++a)
            of_q_[a].push_back(graph_.product(tau_, velocity_[a]));
        const std::size_t count = form_.attractions.size();
        // NOTE: by kinds of values, for vectors of the processor: see orbit_values() of the
        // runtime.
        std::vector<Scaled> squares, products, speeds, strengths;
        for (std::size_t j = 0; j < count; ++j) {
            const auto [Q, V] = vectors(j);
            squares.push_back(dot(Q, Q));
            products.push_back(dot(Q, V));
            speeds.push_back(dot(V, V));
            strengths.push_back(graph_.product(form_.attractions[j].strength, inverse_mass(j)));
            add_changes(j, Q, V);
        }
        RuntimeValues values{RuntimeFunction::orbits, std::move(squares), {}};
        for (const auto* more : {&products, &speeds, &strengths})
            values.given.insert(values.given.end(), more->begin(), more->end());
        values.given.push_back(tau_);
        for (std::size_t kind = 0; kind < changes_of_orbit; ++kind)
            for (std::size_t j = 0; j < count; ++j) values.results.push_back(change(kind, j).node);
        std::vector<Moved> moved;
        for (std::size_t a = 0; a < of_q_.size(); ++a)
            moved.push_back({false, a, graph_.sum(std::move(of_q_[a]))});
        for (std::size_t a = 0; a < of_p_.size(); ++a)
            moved.push_back({true, a, graph_.sum(std::move(of_p_[a]))});
        std::erase_if(moved, [](const Moved& each) { return each.change.is_zero(); });
        return {name_of_orbits, std::move(moved), {}, {std::move(values)}};
    }

private:
    struct Motion {
        std::vector<Scaled> Q, V;
    };

    [[nodiscard]] Motion vectors(std::size_t j) {
        Motion motion;
        for (const LinearForm& component : form_.attractions[j].components) {
            motion.Q.push_back(value_of_form(graph_, component, q_));
            motion.V.push_back(value_of_form(graph_, component, velocity_));
        }
        return motion;
    }

    [[nodiscard]] Scaled dot(const std::vector<Scaled>& a, const std::vector<Scaled>& b) {
        std::vector<Scaled> terms;
        for (std::size_t c = 0; c < a.size(); ++c) terms.push_back(graph_.product(a[c], b[c]));
        return graph_.sum(std::move(terms));
    }

    /// Returns l K l^T: one over the mass that moves.
    [[nodiscard]] Scaled inverse_mass(std::size_t j) {
        return value_of_form(graph_, form_.attractions[j].components.front(), rates_[j].front());
    }

    /// Returns f - 1, g - tau, f' and g' - 1 of an orbit, by their number.
    [[nodiscard]] Scaled change(std::size_t kind, std::size_t j) {
        return graph_.input(fmt::format("change {} of orbit {}", kind, j), Role::coordinate);
    }

    /// Adds (f - 1) Q + (g - tau) V and f' Q + (g' - 1) V, as they move coordinates and momenta.
    void add_changes(std::size_t j, const std::vector<Scaled>& Q, const std::vector<Scaled>& V) {
        const Scaled mass = graph_.inverse(inverse_mass(j));
        const auto moved = [&](std::size_t kind, std::size_t c) {
            return graph_.sum(
                {graph_.product(change(kind, j), Q[c]), graph_.product(change(kind + 1, j), V[c])});
        };
        for (std::size_t c = 0; c < Q.size(); ++c) {
            add(of_q_, rates_[j][c], mass, moved(0, c));
            add(of_p_, form_.attractions[j].components[c], mass, moved(2, c));
        }
    }

    void add(std::vector<std::vector<Scaled>>& sums, const LinearForm& form, const Scaled& mass,
             const Scaled& change) {
        for (std::size_t a = 0; a < form.size(); ++a) {
            const Scaled factor = graph_.product(form[a], mass);
            if (!factor.is_zero()) sums[a].push_back(graph_.product(factor, change));
        }
    }

    Graph& graph_;
    const OrbitForm& form_;
    std::vector<Scaled> q_, velocity_;
    Scaled tau_;
    std::vector<std::vector<LinearForm>> rates_;  ///< l K, of each component
    std::vector<std::vector<Scaled>> of_q_, of_p_;
};

}  // namespace

Flow flow_of_orbits(Graph& graph, const OrbitForm& form, const std::vector<Node>& q,
                    const std::vector<Node>& p, Node duration) {
    return OrbitMotion(graph, form, q, p, duration)();
}

}  // namespace hvi::gen
