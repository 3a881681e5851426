// The series of the general Galerkin form for H of which the momenta at the nodes are more than
// their projections: against (4.6) solved in numbers, and by other trees where there are others.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/lower/system.hpp"
#include "generator/series/elementary_hamiltonians.hpp"
#include "generator/series/tree_weights.hpp"
#include "tests/generator/equations/galerkin_solution.hpp"
#include "tests/generator/series/series_values.hpp"

using namespace hvi::gen;

namespace {

constexpr const char* with_metric = "(1+q^2)*p^2/2 + q^4/4";
constexpr const char* relativistic = "sqrt(1+p^2) + q^2/2 + q^3/3";
constexpr const char* quartic = "p^4/4 + p^2/2 + p*q^2 + cos(q)";
constexpr const char* double_pendulum =
    "(p1^2 - 2*cos(q1-q2)*p1*p2 + 2*p2^2)/(2*(1+sin(q1-q2)^2)) - 2*cos(q1) - cos(q2)";
constexpr const char* driven_charge = "(p1-t*q2)^2/2 + (p2+q1^2)^2*(1+q2^2) + exp(p1*p2)";
constexpr const char* quadratic = "a*p^2/2 + b*q*p + q^2";

/// A rule twice: as it is given to the program, and in numbers.
struct RuleInNumbers {
    std::string text;
    NumericRule rule;
};

/// For 1, tau, ..., and the weights of interpolation.
RuleInNumbers with_powers(const std::string& text, int functions, const Reals& c) {
    RuleInNumbers result{text, {{}, c, {}}};
    for (int k = 0; k < functions; ++k) result.rule.psi.push_back(power_of_tau(k));
    std::vector<Reals> powers;
    Reals integrals;
    for (std::size_t k = 0; k < c.size(); ++k) {
        const NumericFunction power = power_of_tau(static_cast<int>(k));
        powers.emplace_back();
        for (const Real node : c) powers.back().push_back(power.value(node));
        integrals.push_back(power.integral(1));
    }
    result.rule.b = solved(powers, integrals);
    return result;
}

RuleInNumbers with_wave() {
    const Real pi = std::acos(-1.0L), third = 1 / 3.0L;
    const NumericFunction wave{[pi](Real x) { return std::cos(2 * pi * x); },
                               [pi](Real x) { return std::sin(2 * pi * x) / (2 * pi); }};
    return {"1, cos(2*pi*tau) | 1/6, 1/2, 5/6 | 1/3, 1/3, 1/3",
            {{power_of_tau(0), wave}, {third / 2, 0.5L, 5 * third / 2}, {third, third, third}}};
}

std::vector<RuleInNumbers> rules_in_numbers() {
    const Real root = std::sqrt(0.15L), sqrt6 = std::sqrt(6.0L), third = 1 / 3.0L;
    const Reals gauss{0.5L - root, 0.5L, 0.5L + root};
    const Reals radau{(4 - sqrt6) / 10, (4 + sqrt6) / 10, 1};
    return {with_powers("1 | 0, 1", 1, {0, 1}),
            with_powers("1 | gauss:3", 1, gauss),
            with_powers("1 | 0, 1/10, 1", 1, {0, 0.1L, 1}),       // a negative weight
            with_powers("1, tau | 1/3, 1, 0", 2, {third, 1, 0}),  // and one that is 0
            with_powers("1, tau | gauss:3", 2, gauss),
            with_powers("1, tau | 0, 1/2, 1", 2, {0, 0.5L, 1}),
            with_powers("1-tau, tau | radau-right:3", 2, radau),
            with_powers("1, tau | 0, 1/4, 1/2, 3/4, 1", 2, {0, 0.25L, 0.5L, 0.75L, 1}),
            with_wave()};
}

/// Returns the stationary value of (4.6), less the value of the series at equal q_0 and p_1.
Real remainder(const RuleInNumbers& given, const Hamiltonian& H, const DiscreteSeries& series,
               Real h) {
    Point start_of_step = start(H);
    start_of_step["h"] = {h};
    const auto& [psi, c, b] = given.rule;
    const NumericStep step(given.rule, H, start_of_step);
    Point point = start_of_step;
    for (const std::string& p : H.momenta) point[p] = {step.end(p)};
    Real value = 0;
    for (std::size_t d = 0; d < H.degrees_of_freedom(); ++d)
        value += point[H.momenta[d]].value * point[H.coordinates[d]].value;
    for (std::size_t i = 0; i < c.size(); ++i) {
        Point at_node = point;
        at_node["t"].value += c[i] * h;
        for (std::size_t d = 0; d < H.degrees_of_freedom(); ++d) {
            const std::string &q = H.coordinates[d], &p = H.momenta[d];
            at_node[q] = {step.at(q + "@" + std::to_string(i))};
            at_node[p] = {step.at(p + "@" + std::to_string(i))};
            Real velocity = 0;
            for (std::size_t j = 0; j < psi.size(); ++j)
                velocity += psi[j].value(c[i]) * step.at(q + "#" + std::to_string(j));
            value -= h * b[i] * (at_node[p].value - point[p].value) * velocity;
        }
        value += h * b[i] * evaluate(H.expression, at_node).value;
    }
    return value - sum(series.method, H, point, {h}).value;
}

/// Over all trees of a family, of two vertices and more.
NumberVector coefficients(SeriesFamily family, const AnyDerivation& method, const System& system,
                          int terms) {
    const TreeWeightPointer weight = method_weight(method.method, method.ground);
    ElementaryHamiltonians<NodeValues> elementary(system, method.ground);
    UnrootedTrees trees(family, [](const SeriesTree&) { return false; });
    NumberVector result(1, Number(static_cast<long>(trees.next().size())));
    for (int k = 1; k < terms; ++k) {
        Number sum;
        for (const SeriesTreePointer& tree : trees.next())
            sum = sum +
                  (*weight)(*tree) * elementary(*tree) / Number(static_cast<long>(tree->symmetry));
        result.push_back(sum);
    }
    return result;
}

}  // namespace

TEST_CASE("the series of the general Galerkin form is that of (4.6) for any regular H") {
    const int terms = 5;
    for (const RuleInNumbers& given : rules_in_numbers())
        for (const char* text : {with_metric, relativistic, quartic, quadratic}) {
            const Hamiltonian H = hamiltonian(text);
            const DiscreteSeries found = series(rule(given.text), text, terms);
            const Real coarse = remainder(given, H, found, 0.02L),
                       fine = remainder(given, H, found, 0.01L);
            CAPTURE(given.text, text, coarse, fine);
            CHECK(std::log2(coarse / fine) == Approx(terms + 1).margin(0.35));
        }
}

TEST_CASE("for more degrees of freedom and with a time too") {
    for (const RuleInNumbers& given :
         {rules_in_numbers()[1], rules_in_numbers()[7], rules_in_numbers()[8]})
        for (const char* text : {double_pendulum, driven_charge}) {
            const int terms = 3;
            const Hamiltonian H = hamiltonian(text);
            const DiscreteSeries found = series(rule(given.text), text, terms);
            const Real coarse = remainder(given, H, found, 0.002L),
                       fine = remainder(given, H, found, 0.001L);
            CAPTURE(given.text, text, coarse, fine);
            CHECK(std::log2(coarse / fine) == Approx(terms + 1).margin(0.35));
        }
}

TEST_CASE("for any regular H the first difference is behind the order") {
    struct Known {
        const char* rule;
        int order;  ///< at most 2s, and what the rule is exact for
    };
    for (const Known& known :
         {Known{"1 | 0, 1", 2}, Known{"1 | gauss:4", 2}, Known{"1, tau | gauss:3", 4},
          Known{"1, tau | 0, 1/2, 1", 4}, Known{"1, tau | radau-right:3", 4},
          Known{"1, tau | lobatto:4", 4}, Known{"1, tau, tau^2 | gauss:4", 6}})
        for (const char* H : {with_metric, relativistic, quartic}) {
            CAPTURE(known.rule, H);
            const DiscreteSeries found = series(rule(known.rule), H, known.order + 1);
            CHECK(found.first_difference == known.order + 1);
            CHECK(found.difference);
        }
}

TEST_CASE("of a quadratic kinetic energy both kinds of trees make one series") {
    for (const char* text : {"p^2/2 - cos(q)", "(2*p1^2+2*p1*p2+p2^2)/2 + q1^2*q2 + q1*q2^3"})
        for (const char* given : {"1 | gauss:3", "1, tau | 0, 1/2, 1", "1, tau | gauss:4"})
            on_new_ground([&](const Ground& ground) {
                const AnyDerivation method = derive_any_on(ground, rule(given));
                const Hamiltonian H = hamiltonian(text);
                const System system = system_of(H, parameter_names(H));
                const NumberVector linked = coefficients(SeriesFamily::linked, method, system, 6),
                                   nystrom = coefficients(SeriesFamily::nystrom, method, system, 6);
                CAPTURE(given, text);
                for (std::size_t k = 0; k < linked.size(); ++k)
                    CHECK((linked[k] - nystrom[k]).is_zero());
                return 0;
            });
}

// NOTE: there are as many nodes with a weight as functions, at which (4.6) is Theorem 4.2.
TEST_CASE("nodes without a weight change nothing") {
    for (const char* H : {with_metric, relativistic, quartic}) {
        const DiscreteSeries linked = series(rule("1, tau | 1/3, 1, 0"), H, 5),
                             tableau = series("radau-right:2", H, 5);
        CAPTURE(H);
        CHECK(linked.first_difference == tableau.first_difference);
        for (std::size_t k = 0; k < 5; ++k)
            CHECK(to_text(linked.method[k].value()) == to_text(tableau.method[k].value()));
    }
}
