// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_time.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "generator/lower/accesses.hpp"
#include "generator/lower/loop_starts.hpp"
#include "generator/lower/loop_sums.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/taken_names.hpp"
#include "generator/lower/totals.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

using Sums = std::vector<SystemSum>;

bool has_role(const System& system, const SystemSum& sum, Role role) {
    return has(system.graph.at(sum.value.node).roles, role);
}

/// Total of r^-3 over pairs of bodies, to the power -1/2.
class DistanceOfBodies {
public:
    DistanceOfBodies(const System& system, const Declarations& names, const Place& place)
        : system_(system), place_(place), taken_(names.taken) {}

    [[nodiscard]] Expression operator()() {
        check();
        const std::string i = new_name("i", taken_), j = new_name("j", taken_);
        std::vector<Expression> squares;
        for (std::size_t f = 0; f < count(); ++f) {
            const std::string& name = system_.coordinates[f].name;
            const Expression between =
                Expression::sum({element(name, i), Expression::negation(element(name, j))});
            squares.push_back(Expression::power(between, Expression::integer(2)));
        }
        const LoopRange& range = system_.coordinates.front().ranges.front();
        const auto bound = [](const AffineForm& form) { return as_expression(ElementIndex{form}); };
        const Expression inner =
            Expression::sum_over(j, bound(AffineForm::of(i) + AffineForm{1}), bound(range.last),
                                 power(Expression::sum(std::move(squares)), -3));
        const Expression all =
            Expression::sum_over(i, bound(range.first), bound(range.last - AffineForm{1}), inner);
        return power(all, -1);
    }

private:
    /// Returns the number of coordinates. NOTE: the last family is the time.
    [[nodiscard]] std::size_t count() const { return system_.coordinates.size() - 1; }

    void check() const {
        const SystemFamily& first = system_.coordinates.front();
        const bool are_bodies =
            first.ranges.size() == 1 &&
            std::all_of(system_.coordinates.begin(), system_.coordinates.end() - 1,
                        [&](const SystemFamily& each) { return each.ranges == first.ranges; });
        if (are_bodies) { return; }
        throw NoLoops("where sums stay loops, bodies have one index, x[1..N] and y[1..N]", place_,
                      "write the scale as an expression");
    }

    [[nodiscard]] static Expression element(const std::string& name, const std::string& index) {
        return Expression::element(name, {Expression::symbol(index)});
    }

    /// Returns base^(numerator/2).
    [[nodiscard]] static Expression power(const Expression& base, long numerator) {
        return Expression::power(
            base, Expression::product({Expression::integer(numerator),
                                       Expression::reciprocal(Expression::integer(2))}));
    }

    const System& system_;
    Place place_;
    std::set<std::string> taken_;
};

class LoopScaling {
public:
    LoopScaling(System system, const Declarations& names, const Scene& scene)
        : system_(std::move(system)), names_(names), scene_(scene), place_(scene.scale->place) {}

    [[nodiscard]] System operator()() {
        const Sums H = std::exchange(system_.sums, {});
        const std::size_t last = system_.conjugates.size() - 1;
        const std::size_t access = access_to(system_, FamilyKind::conjugate, last, {});
        e_ = {{1, 1}, system_.accesses[access].node};
        set_energy(H);
        scale(H);
        return std::move(system_);
    }

private:
    [[nodiscard]] Expression name_of_e() const {
        return Expression::symbol(system_.conjugates.back().name);
    }

    [[nodiscard]] Expression with_e(const Expression& of) const {
        return Expression::sum({of, name_of_e()});
    }

    /// Sets the energy: H, or H + e where H depends on the time.
    void set_energy(const Sums& H) {
        Expression written = system_.expression;
        system_.energy = H;
        const bool has_time = std::any_of(H.begin(), H.end(), [&](const SystemSum& sum) {
            const Node t = system_.graph.input("t", Role::coordinate).node;
            const auto of_time = [&](std::size_t a) { return system_.accesses[a].node == t; };
            return std::any_of(sum.accesses.begin(), sum.accesses.end(), of_time);
        });
        if (has_time) {
            written = with_e(written);
            system_.energy.push_back(term(e_));
        }
        system_.scaled = ScaledTime{system_.coordinates.size() - 1, std::move(written),
                                    scene_.scale->kind == TimeScale::logarithmic};
    }

    [[nodiscard]] SystemSum term(const Scaled& value) {
        return differentiated(system_, {{}, value, {}, {}, {}});
    }

    /// Returns a number that sums add up to.
    [[nodiscard]] Scaled total(const std::string& name, Sums sums) {
        const Scaled input = system_.graph.input(name, roles_of_total(system_.graph, sums));
        system_.totals.push_back({input.node, std::move(sums)});
        return input;
    }

    void scale(const Sums& H) {
        Graph& graph = system_.graph;
        switch (scene_.scale->kind) {
        case TimeScale::expression:
            multiply(H, names_.meant(scene_.scale->expression, scale_rules));
            return;
        case TimeScale::distance:
            multiply(H, {DistanceOfBodies(system_, names_, place_)(), scene_.function.source});
            return;
        case TimeScale::potential: {
            const auto [T, U] = parts(H);
            const Scaled u = total("potential", U), t = total("kinetic", T);
            const Scaled zero = graph.sum({t, u, e_});
            const Scaled negative = graph.times({-1, 1}, u);
            system_.sums = {term(graph.product(zero, graph.inverse(negative)))};
            const Expression of_U = Expression::negation(Expression::symbol("U"));
            const Expression of_H =
                Expression::sum({Expression::symbol("T"), Expression::symbol("U"), name_of_e()});
            system_.expression = Expression::product({of_H, Expression::reciprocal(of_U)});
            return;
        }
        case TimeScale::logarithmic: {
            const auto [T, U] = parts(H);
            const Scaled t = total("kinetic", T), u = total("potential", U);
            const Scaled of_T = graph.call("log", {graph.sum({t, e_})});
            const Scaled of_U = graph.call("log", {graph.times({-1, 1}, u)});
            system_.sums = {term(of_T), term(graph.times({-1, 1}, of_U))};
            const auto log = [](Expression of) { return Expression::call("log", {std::move(of)}); };
            const Expression kinetic = Expression::sum({Expression::symbol("T"), name_of_e()});
            system_.expression = Expression::sum(
                {log(kinetic),
                 Expression::negation(log(Expression::negation(Expression::symbol("U"))))});
            return;
        }
        case TimeScale::arclength: break;
        }
        throw NoLoops("the arclength is not built where sums stay loops: it is made of all "
                      "derivatives of H, each of which is a sum",
                      place_, "\"distance\" or an expression");
    }

    /// Sets K = g (H + e).
    void multiply(const Sums& H, const IndexedExpression& scale) {
        const Scaled g =
            total("scale of the time", sums_of(system_, names_, scale, names_.symbols));
        const Scaled zero = system_.graph.sum({total("H before", H), e_});
        system_.sums = {term(system_.graph.product(g, zero))};
        system_.expression = Expression::product({scale.written, with_e(system_.expression)});
    }

    /// Returns T and U.
    [[nodiscard]] std::pair<Sums, Sums> parts(const Sums& H) const {
        std::pair<Sums, Sums> result;
        for (const SystemSum& sum : H) {
            const bool has_q = has_role(system_, sum, Role::coordinate);
            if (has_q && has_role(system_, sum, Role::conjugate)) {
                throw NoLoops("this scale is one of H = T(p) + U(q), and here a sum depends on "
                              "both",
                              place_, "\"distance\" or an expression go with any H");
            }
            (has_q ? result.second : result.first).push_back(sum);
        }
        return result;
    }

    System system_;
    const Declarations& names_;
    const Scene& scene_;
    Place place_;
    Scaled e_ = {};
};

}  // namespace

void declare_scaled_time(System& system, Declarations& names, const Scene& scene) {
    const Place& place = scene.scale->place;
    if (scene.side == Side::lagrangian) {
        throw NoLoops("a scale of the time is not built for a Lagrangian whose sums stay loops",
                      place, "write its Hamiltonian");
    }
    refuse_rotations(scene, "a scale of the time");
    system.initial = starts_of(system, names, scene);
    const std::size_t n = system.coordinates.size();
    system.initial.insert(system.initial.begin() + static_cast<std::ptrdiff_t>(n),
                          {SystemStart::Rule{{}, Graph::number(0)}});
    system.initial.push_back({SystemStart::MinusEnergy{}});
    system.coordinates.push_back({"t"});
    system.conjugates.push_back({new_name("p_t", names.taken)});
    names.families["t"] = {FamilyKind::coordinate, n};
}

System with_scaled_time(System system, const Declarations& names, const Scene& scene) {
    return LoopScaling(std::move(system), names, scene)();
}

}  // namespace hvi::gen
