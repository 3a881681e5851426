// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/orbit_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/graph/written.hpp"
#include "generator/lower/attracting_bodies.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/flows.hpp"
#include "generator/lower/orbits.hpp"
#include "generator/lower/parts.hpp"
#include "generator/lower/taken_names.hpp"

namespace hvi::gen {

namespace {

/// Makes parts of H. Matrices and forms are those of one axis, with a number for each body.
class OrbitParts {
public:
    OrbitParts(System system, const Place& place)
        : system_(std::move(system)),
          graph_(system_.graph),
          place_(place),
          bodies_(attracting_bodies(system_, place)),
          q_(coordinate_nodes(system_)),
          p_(conjugate_nodes(system_)) {
        std::set<std::string> taken = taken_names(system_);
        parts_.duration = graph_.input(new_name("tau", taken), Role::parameter).node;
        for (const Scaled& inverse : bodies_.inverse_masses)
            masses_.push_back(graph_.inverse(inverse));
        for (std::size_t j = 2; j <= count(); ++j)
            if (is_proved_zero(graph_, mass_before(j)))
                throw MathError(fmt::format("the masses of the first {} bodies add up to 0", j),
                                place_, "orbits are about centres of mass");
    }

    [[nodiscard]] System operator()(SplitChoice coordinates) && {
        const bool is_jacobi = coordinates == SplitChoice::jacobi;
        OrbitForm form{of_coordinates(is_jacobi ? masses_alone() : without_first()), {}};
        std::vector<Scaled> squares;  // of multiples of Q_j
        for (std::size_t j = 1; j < count(); ++j) {
            Scaled strength = Graph::number(0);
            for (const AttractingPair& pair : bodies_.pairs)
                if (pair.second == j && (is_jacobi || pair.first == 0))
                    strength = graph_.sum({strength, pair.strength});
            if (is_proved_zero(graph_, strength)) continue;
            form.attractions.push_back(
                {components(is_jacobi ? from_centre(j) : from_first(j)), strength});
            squares.push_back(
                square(components(is_jacobi ? multiple_from_centre(j) : from_first(j))));
        }
        if (form.attractions.empty())
            throw MathError("no body is attracted by the first one", place_,
                            "orbits are about the first body of the scene: put the heaviest there");
        add_orbits(form, squares);
        if (!is_jacobi) add_motion_of_first();
        add_rest(form);
        if (system_.time) set_clock(graph_, parts_);
        system_.parts = std::move(parts_);
        return std::move(system_);
    }

private:
    [[nodiscard]] std::size_t count() const { return masses_.size(); }

    // ---- forms of one axis ----

    [[nodiscard]] LinearForm zeros() const { return LinearForm(count(), Graph::number(0)); }

    /// Returns the mass of the bodies before one.
    [[nodiscard]] Scaled mass_before(std::size_t j) {
        const auto end = masses_.begin() + static_cast<std::ptrdiff_t>(j);
        return graph_.sum({masses_.begin(), end});
    }

    /// Returns Q_j = q_j - sum_(i<j) m_i q_i/sum_(i<j) m_i.
    [[nodiscard]] LinearForm from_centre(std::size_t j) {
        if (j == 1) return from_first(j);
        const Scaled below = graph_.inverse(mass_before(j));
        LinearForm form = zeros();
        form[j] = Graph::number(1);
        for (std::size_t i = 0; i < j; ++i)
            form[i] = graph_.times({-1, 1}, graph_.product(masses_[i], below));
        return form;
    }

    /// Returns Q_j times that mass, in which no mass stands below a bar.
    [[nodiscard]] LinearForm multiple_from_centre(std::size_t j) {
        LinearForm form = zeros();
        form[j] = mass_before(j);
        for (std::size_t i = 0; i < j; ++i) form[i] = graph_.times({-1, 1}, masses_[i]);
        return form;
    }

    [[nodiscard]] LinearForm from_first(std::size_t j) const {
        LinearForm form = zeros();
        form[j] = Graph::number(1);
        form[0] = Graph::number(-1);
        return form;
    }

    [[nodiscard]] std::vector<LinearForm> masses_alone() const {
        std::vector<LinearForm> K(count(), zeros());
        for (std::size_t b = 0; b < count(); ++b) K[b][b] = bodies_.inverse_masses[b];
        return K;
    }

    /// Returns K - c^T c/m_0, where c p is the momentum that moves the first body: the matrix of
    /// P^2/(2 M) + sum_(i>0) P_i^2/(2 m_i) with P = sum_i p_i, M = sum_i m_i, P_i = p_i - m_i P/M.
    [[nodiscard]] std::vector<LinearForm> without_first() {
        std::vector<LinearForm> K = masses_alone();
        const LinearForm c = motion_of_first();
        for (std::size_t a = 0; a < count(); ++a)
            for (std::size_t b = 0; b < count(); ++b)
                K[a][b] = difference_of(
                    graph_, K[a][b],
                    graph_.product(bodies_.inverse_masses[0], graph_.product(c[a], c[b])));
        return K;
    }

    /// Returns c with c p = sum_(i>0) P_i = (m_0 sum_(i>0) p_i - (M - m_0) p_0)/M.
    [[nodiscard]] LinearForm motion_of_first() {
        const Scaled whole = graph_.inverse(graph_.sum(masses_));
        const Scaled others = graph_.sum({masses_.begin() + 1, masses_.end()});
        LinearForm c(count(), graph_.product(masses_[0], whole));
        c[0] = graph_.times({-1, 1}, graph_.product(others, whole));
        return c;
    }

    // ---- forms of all coordinates ----

    [[nodiscard]] std::size_t axes() const { return bodies_.coordinates.front().size(); }

    [[nodiscard]] LinearForm along(std::size_t axis, const LinearForm& form) const {
        LinearForm result(q_.size(), Graph::number(0));
        for (std::size_t b = 0; b < count(); ++b) result[bodies_.coordinates[b][axis]] = form[b];
        return result;
    }

    [[nodiscard]] std::vector<LinearForm> components(const LinearForm& form) const {
        std::vector<LinearForm> result;
        for (std::size_t axis = 0; axis < axes(); ++axis) result.push_back(along(axis, form));
        return result;
    }

    [[nodiscard]] std::vector<LinearForm> of_coordinates(const std::vector<LinearForm>& K) const {
        std::vector<LinearForm> result(q_.size());
        for (std::size_t b = 0; b < count(); ++b)
            for (std::size_t axis = 0; axis < axes(); ++axis)
                result[bodies_.coordinates[b][axis]] = along(axis, K[b]);
        return result;
    }

    // ---- parts ----

    /// Adds a part. NOTE: a short text tells more than pages of terms.
    void add(const std::string& name, const std::string& text, const Scaled& value, Flow flow) {
        const auto expression = written(graph_, value);
        parts_.parts.push_back({name, expression.value_or(Expression::symbol(too_long_part)),
                                std::move(flow.kind), std::move(flow.moved), std::move(flow.usual),
                                std::move(flow.in_each_flow), std::move(flow.forms), value, text});
    }

    /// Adds a part that moves p alone, or q alone.
    void add_shear(const std::string& name, const std::string& text, const Scaled& value) {
        auto flow = flow_of(system_, value, parts_.duration);
        if (const auto* none = std::get_if<NoFlow>(&flow))
            throw MathError("what is left beside the orbits has no known flow: " + none->reason,
                            place_);
        add(name, text, value, std::get<Flow>(std::move(flow)));
    }

    /// Adds A. NOTE: it is a function of its kinetic energy and of the squares.
    void add_orbits(const OrbitForm& form, const std::vector<Scaled>& squares) {
        if (!are_apart(graph_, form))
            throw MathError("it is not proved that the orbits do not couple", place_,
                            "give masses as numbers, or as parameters without functions");
        std::vector<Scaled> terms{kinetic_energy(form.kinetic)}, made_of = terms;
        made_of.insert(made_of.end(), squares.begin(), squares.end());
        for (const Attraction& attraction : form.attractions)
            terms.push_back(graph_.times({-1, 1}, over_distance(attraction)));
        add("A", "T - sum_j k_j/|Q_j|", graph_.sum(std::move(terms)),
            flow_of_orbits(graph_, form, q_, p_, parts_.duration));
        for (const Scaled& each : made_of) {
            auto expression = written(graph_, each);
            if (!expression) return parts_.parts.back().made_of.clear();
            parts_.parts.back().made_of.push_back(*std::move(expression));
        }
    }

    [[nodiscard]] Scaled kinetic_energy(const std::vector<LinearForm>& K) {
        std::vector<Scaled> terms;
        for (std::size_t a = 0; a < p_.size(); ++a)
            terms.push_back(graph_.product({{1, 1}, p_[a]}, applied(K[a], p_)));
        return graph_.times({1, 2}, graph_.sum(std::move(terms)));
    }

    [[nodiscard]] Scaled applied(const LinearForm& form, const std::vector<Node>& variables) {
        std::vector<Scaled> terms;
        for (std::size_t a = 0; a < form.size(); ++a)
            terms.push_back(graph_.product(form[a], {{1, 1}, variables[a]}));
        return graph_.sum(std::move(terms));
    }

    [[nodiscard]] Scaled square(const std::vector<LinearForm>& vector) {
        std::vector<Scaled> squares;
        for (const LinearForm& component : vector)
            squares.push_back(graph_.half_power(applied(component, q_), 4));
        return graph_.sum(std::move(squares));
    }

    /// Returns k/|Q|.
    [[nodiscard]] Scaled over_distance(const Attraction& attraction) {
        return graph_.product(attraction.strength,
                              graph_.half_power(square(attraction.components), -1));
    }

    /// Adds C = (c p)^2/(2 m_0): all drift by the motion of the first body.
    void add_motion_of_first() {
        std::vector<Scaled> squares;
        for (const LinearForm& c : components(motion_of_first()))
            squares.push_back(graph_.half_power(applied(c, p_), 4));
        add_shear("C", "|sum_j P_j|^2/(2*m_1)",
                  graph_.times({1, 2}, graph_.product(bodies_.inverse_masses[0],
                                                      graph_.sum(std::move(squares)))));
    }

    /// Adds what is left of the potential: U(q) + sum_j k_j/|Q_j|. NOTE: attractions that are those
    /// of orbits are left out of both, so that no two large numbers are to cancel.
    void add_rest(OrbitForm form) {
        std::map<Node, Scaled> removed;
        for (const AttractingPair& pair : bodies_.pairs) {
            if (!pair.is_linear) continue;
            const auto is_its_orbit = [&](const Attraction& attraction) {
                return attraction.components == components(from_first(pair.second)) &&
                       attraction.strength == pair.strength;
            };
            const auto orbit =
                std::find_if(form.attractions.begin(), form.attractions.end(), is_its_orbit);
            if (pair.first != 0 || orbit == form.attractions.end()) continue;
            removed[pair.inverse] = Graph::number(0);
            form.attractions.erase(orbit);
        }
        for (const Node p : p_) removed[p] = Graph::number(0);
        std::vector<Scaled> terms{replaced(graph_, function_of(system_), removed)};
        for (const Attraction& attraction : form.attractions)
            terms.push_back(over_distance(attraction));
        add_shear("B", "U + sum_j k_j/|Q_j|", graph_.sum(std::move(terms)));
    }

    System system_;
    Graph& graph_;
    const Place& place_;
    AttractingBodies bodies_;
    std::vector<Node> q_, p_;
    std::vector<Scaled> masses_;
    HamiltonianParts parts_;
};

}  // namespace

System with_orbits(System system, SplitChoice coordinates, const Place& place) {
    return OrbitParts(std::move(system), place)(coordinates);
}

}  // namespace hvi::gen
