// Maps and generating functions of rules: against tableaux, the oscillator's map and the flow.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/methods/oscillator.hpp"
#include "tests/generator/linear/linear.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Method rule_of(const std::string& basis, const std::string& nodes,
               const std::string& weights = "") {
    return weights.empty() ? method(basis, nodes)
                           : method_from_text(source(basis, "--basis"), source(nodes, "--nodes"),
                                              source(weights, "--weights"));
}

/// Calls `work` with a rule, as with_method() does with a tableau.
template <class Work>
auto with_rule(const Method& method, const std::string& hamiltonian, Work work) {
    return on_new_ground([&](const Ground& new_ground) {
        const auto [derived, ground] = derive_any_on(new_ground, method);
        return work(std::get<GalerkinRule>(derived), form_of(hamiltonian, ground), ground);
    });
}

GeneratingFunction function_of(const Method& method, const std::string& hamiltonian) {
    return with_rule(method, hamiltonian,
                     [](const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
                         const GeneratingFunction found = generating_function(rule, H, ground);
                         CHECK(found.gives_map);
                         CHECK(found.is_symmetric);
                         return GeneratingFunction{
                             {}, {}, {}, {}, found.order_of_difference, found.is_at_least};
                     });
}

/// sum_k coefficients[k] z^k
Number value_at(const NumberVector& coefficients, const Number& z) {
    Number sum;
    for (std::size_t k = coefficients.size(); k-- > 0;) { sum = sum * z + coefficients[k]; }
    return sum;
}

// d2H/dp2 is regular.
constexpr const char* regular[] = {oscillator, any_one, coupled_springs, coupled_any,
                                   "2, 1, 3, 4; 1, 5, -1, 2; 3, -1, 2, 1; 4, 2, 1, 3 | 1, 2, 3, 4"};

}  // namespace

TEST_CASE("a node without a weight changes neither the map nor the generating function") {
    struct Case {
        std::string basis, nodes, with_more, weights;
    };
    for (const Case& given :
         {Case{"1, tau", "0, 1", "0, 1/3, 1", "1/2, 0, 1/2"},
          Case{"1, tau, tau^2", "0, 1/2, 1", "1/4, 0, 1/2, 1", "0, 1/6, 2/3, 1/6"},
          Case{"1, cos(pi*tau)", "1/4, 3/4", "1/4, 1/2, 3/4", "1/2, 0, 1/2"}}) {
        for (const char* const hamiltonian : regular) {
            if (given.basis == "1, cos(pi*tau)" && hamiltonian != regular[0]) { continue; }
            CAPTURE(given.basis, given.nodes, hamiltonian);
            CHECK(with_rule(
                rule_of(given.basis, given.with_more, given.weights), hamiltonian,
                [&](const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
                    const Tableau same =
                        derive_on(ground, method(given.basis, given.nodes)).tableau;
                    const LinearMap map = one_step_map(rule, H, ground),
                                    other = one_step_map(same, H, ground);
                    return are_equal(map.matrix, other.matrix) &&
                           are_equal(map.offset, other.offset) &&
                           are_equal(generating_function(rule, H, ground).discrete,
                                     generating_function(same, H, ground).discrete);
                }));
        }
    }
}

TEST_CASE("the map of the oscillator is the one that stability is decided by") {
    for (const auto& [basis, nodes] :
         std::vector<std::pair<const char*, const char*>>{{"1, tau", "0, 1/2, 1"},
                                                          {"1, tau", "gauss:3"},
                                                          {"1, tau, tau^2", "gauss:6"},
                                                          {"1, cos(pi*tau)", "gauss:3"},
                                                          {"1", "0, 1/2, 1"}}) {
        CAPTURE(basis, nodes);
        CHECK(with_rule(rule_of(basis, nodes), "w^2, 0; 0, 1",
                        [](const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
                            const NumberMatrix M = one_step_map(rule, H, ground).matrix;
                            const OscillatorMap map = oscillator_map(rule);
                            const Number w = read("w", ground), z = read("h*w", ground);
                            const auto entry = [&](const NumberVector& m) {
                                return value_at(m, z) / value_at(map.D, z);
                            };
                            return are_equal(M, {{entry(map.m11), entry(map.m12) / w},
                                                 {entry(map.m21) * w, entry(map.m22)}});
                        }));
    }
}

TEST_CASE("nodes without a closed form have maps and generating functions all the same") {
    for (const char* const hamiltonian : regular) {
        CAPTURE(hamiltonian);
        CHECK(with_rule(rule_of("1, tau", "gauss:6"), hamiltonian,
                        [](const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
                            // NOTE: with enough nodes all rules for polynomials are one.
                            const Method other = method("1, tau", "lobatto:6");
                            const auto same =
                                std::get<GalerkinRule>(derive_any_on(ground, other).method);
                            return is_symplectic(one_step_map(rule, H, ground).matrix) &&
                                   are_equal(one_step_map(rule, H, ground).matrix,
                                             one_step_map(same, H, ground).matrix);
                        }));
    }
}

TEST_CASE("H_d^+ of a rule approximates the exact one to the method's order") {
    // At most min(2s, order of the rule), of which this is one more.
    CHECK(function_of(rule_of("1, tau", "gauss:3"), oscillator).order_of_difference == 5);
    CHECK(function_of(rule_of("1, tau", "0, 1/2, 1"), any_one).order_of_difference == 5);
    CHECK(function_of(rule_of("1, tau, tau^2", "gauss:4"), coupled_any).order_of_difference == 7);
    CHECK(function_of(rule_of("1", "0, 1/2, 1"), any_one).order_of_difference == 3);
    const GeneratingFunction free = function_of(rule_of("1, tau", "gauss:3"), "0, 0; 0, 1/m");
    CHECK(free.is_at_least);
}

TEST_CASE("a rule has no map where d2H/dp2 is singular") {
    const auto work = [](const GalerkinRule& rule, const QuadraticForm& H, const Ground& ground) {
        return one_step_map(rule, H, ground).offset.size();
    };
    const Method simpson = rule_of("1, tau", "0, 1/2, 1");
    CHECK(refusal([&] { return with_rule(simpson, product_qp, work); }).says("d2H/dp2 is regular"));
    CHECK(refusal([&] {
              return with_rule(simpson, "1, 0, 0, 0; 0, 1, 1, 2; 0, 1, 1, 1; 0, 2, 1, 1", work);
          }).says("d2H/dp2 is regular"));
}
