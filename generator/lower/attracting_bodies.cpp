// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/attracting_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/form_flow.hpp"
#include "generator/lower/orbits.hpp"

namespace hvi::gen {

namespace {

class BodiesOfHamiltonian {
public:
    BodiesOfHamiltonian(System& system, const Place& place)
        : system_(system),
          graph_(system.graph),
          place_(place),
          q_(coordinate_nodes(system)),
          p_(conjugate_nodes(system)) {}

    [[nodiscard]] AttractingBodies operator()() && {
        set_masses();
        find_pairs();
        if (bodies_.pairs.empty()) refuse("it has no attraction -k/r of two bodies");
        find_strengths();
        std::set<std::size_t> seen;
        for (const auto& body : bodies_.coordinates) seen.insert(body.begin(), body.end());
        for (std::size_t a = 0; a < q_.size(); ++a)
            if (seen.count(a) == 0)
                refuse(fmt::format("no body is attracted along {}", name_of(a)));
        return std::move(bodies_);
    }

private:
    [[noreturn]] void refuse(const std::string& reason) const {
        throw MathError("this H is not one of bodies that attract each other: " + reason, place_,
                        "orbits need H = sum_i |p_i|^2/(2 m_i) - sum_ij k_ij/|q_i-q_j| + U(q)");
    }

    [[nodiscard]] std::string name_of(std::size_t a) const { return graph_.at(q_[a]).name; }

    /// Sets one over the mass for each coordinate: the second derivatives by momenta.
    void set_masses() {
        if (rotations_of(system_) > 0) refuse("bodies turn");
        const Scaled& H = function_of(system_);
        const std::vector<Scaled> slopes = gradient(graph_, H, p_);
        for (std::size_t a = 0; a < p_.size(); ++a) {
            const auto rows = rows_of_form(graph_, {slopes[a]}, {p_[a]});
            if (!rows || is_proved_zero(graph_, rows->front()) ||
                !is_proved_zero(graph_, rows->back()))
                refuse(fmt::format("{} has no mass of its own", name_of(a)));
            inverse_masses_.push_back(rows->front());
        }
    }

    /// Returns the body that has a coordinate, which is new where none has.
    std::size_t body_of(const std::vector<std::size_t>& coordinates) {
        auto& bodies = bodies_.coordinates;
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const auto& body = bodies[b];
            if (body == coordinates) return b;
            for (const std::size_t a : coordinates)
                if (std::find(body.begin(), body.end(), a) != body.end())
                    refuse(fmt::format("{} is of two bodies", name_of(a)));
        }
        for (const std::size_t a : coordinates)
            if (!is_proved_zero(graph_, difference_of(graph_, inverse_masses_[a],
                                                      inverse_masses_[coordinates.front()])))
                refuse(fmt::format("a body has another mass along {}", name_of(a)));
        bodies.push_back(coordinates);
        return bodies.size() - 1;
    }

    /// Finds the pairs among the distances in H; others are left to the rest of the potential.
    void find_pairs() {
        for (const auto& [inverse, square] : inverse_roots(graph_, function_of(system_))) {
            const auto attraction = attraction_of(graph_, square, q_);
            if (!attraction || !graph_.is_number(attraction->strength)) continue;
            std::vector<std::size_t> first, second;
            for (const LinearForm& component : attraction->components) {
                const auto is = [&](long number) {
                    return [number](const Scaled& a) { return a == Graph::number(number); };
                };
                const auto from = std::find_if(component.begin(), component.end(), is(1));
                const auto to = std::find_if(component.begin(), component.end(), is(-1));
                const auto others = std::count_if(component.begin(), component.end(),
                                                  [](const Scaled& a) { return !a.is_zero(); });
                if (from == component.end() || to == component.end() || others != 2) break;
                first.push_back(static_cast<std::size_t>(from - component.begin()));
                second.push_back(static_cast<std::size_t>(to - component.begin()));
            }
            if (first.size() != attraction->components.size()) continue;
            const std::size_t a = body_of(first), b = body_of(second);
            bodies_.pairs.push_back({a, b, attraction->strength, inverse});
        }
        order_bodies();
    }

    /// Orders the bodies as their coordinates in the scene.
    void order_bodies() {
        std::vector<std::size_t> place(bodies_.coordinates.size());
        const auto before = bodies_.coordinates;
        std::sort(bodies_.coordinates.begin(), bodies_.coordinates.end());
        for (std::size_t b = 0; b < before.size(); ++b) {
            const auto found =
                std::find(bodies_.coordinates.begin(), bodies_.coordinates.end(), before[b]);
            place[b] = static_cast<std::size_t>(found - bodies_.coordinates.begin());
        }
        for (AttractingPair& pair : bodies_.pairs) {
            const auto ends = std::minmax(place[pair.first], place[pair.second]);
            pair.first = ends.first;
            pair.second = ends.second;
        }
        for (const auto& body : bodies_.coordinates)
            bodies_.inverse_masses.push_back(inverse_masses_[body.front()]);
    }

    /// Sets the strengths of the pairs: what is linear in one over the distance.
    void find_strengths() {
        std::map<Node, Scaled> inputs;
        std::vector<Node> distances;
        for (const AttractingPair& pair : bodies_.pairs) {
            const Scaled d =
                graph_.input(fmt::format("inverse distance {}", distances.size()), Role::direction);
            inputs[pair.inverse] = d;
            distances.push_back(d.node);
        }
        const Scaled H = replaced(graph_, function_of(system_), inputs);
        const std::vector<Scaled> slopes = gradient(graph_, H, distances);
        for (std::size_t k = 0; k < slopes.size(); ++k) {
            AttractingPair& pair = bodies_.pairs[k];
            const auto slope = at_origin(graph_, slopes[k]);
            if (!slope) refuse("it divides by a distance");
            pair.is_linear = !varies(graph_.at(slopes[k].node).roles);
            pair.strength = graph_.times({-1, 1}, graph_.product(*slope, pair.strength));
        }
    }

    System& system_;
    Graph& graph_;
    const Place& place_;
    std::vector<Node> q_, p_;
    std::vector<Scaled> inverse_masses_;  ///< of coordinates
    AttractingBodies bodies_;
};

}  // namespace

AttractingBodies attracting_bodies(System& system, const Place& place) {
    return BodiesOfHamiltonian(system, place)();
}

}  // namespace hvi::gen
