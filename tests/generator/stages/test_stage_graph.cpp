// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/plan/plan.hpp"
#include "generator/stages/dependency_graph.hpp"
#include "generator/stages/stage_graph.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

PartitionedMethod runge_kutta(const std::vector<std::vector<std::string>>& A,
                              const std::vector<std::string>& b) {
    PartitionedMethod result;
    for (const std::string& weight : b) { result.b.push_back(number(weight)); }
    for (const auto& row : A) {
        NumberVector& numbers = result.A.emplace_back();
        for (const std::string& entry : row) { numbers.push_back(number(entry)); }
    }
    result.b_tilde = result.b;
    result.A_tilde = result.A;
    return result;
}

bool is_explicit(const PartitionedMethod& method, bool separable) {
    return coupled_stages(method, separable).empty();
}

}  // namespace

TEST_CASE("components come in the order in which they can be computed") {
    // 0 needs 1; 1 and 2 need each other; 3 stands alone.
    const auto found = components({{1}, {2}, {1}, {}});
    CHECK(found == std::vector<std::vector<std::size_t>>{{1, 2}, {0}, {3}});
}

TEST_CASE("what Algorithm 4.3 gives is explicit as its scheme is") {
    for (const char* const given :
         {"symplectic-euler", "midpoint", "adjoint-symplectic-euler", "stormer-verlet", "trig3",
          "gauss:2", "lobatto:3", "radau-left:2", "1, exp(tau) | 0, 1", "1, exp(tau^2) | 0, 1",
          "1, tau | 0, 2/3", "1, cos(w*tau) | 0, 1"}) {
        CAPTURE(given);
        const Tableau tableau = derive(any_method(given));
        for (const bool separable : {true, false}) {
            CHECK(is_explicit(partitioned_method(tableau), separable) ==
                  plan({tableau}, {.is_separable = separable}).is_explicit());
        }
    }
}

TEST_CASE("a Runge-Kutta method without a loop is explicit for every H") {
    const auto kutta =
        runge_kutta({{"0", "0", "0"}, {"1/2", "0", "0"}, {"-1", "2", "0"}}, {"1/6", "2/3", "1/6"});
    CHECK(is_explicit(kutta, false));
    CHECK(is_explicit(kutta, true));
    // Stages in another order.
    CHECK(is_explicit(runge_kutta({{"0", "1/2"}, {"0", "0"}}, {"1", "0"}), false));
    CHECK_FALSE(is_explicit(runge_kutta({{"0", "1/2"}, {"1/2", "0"}}, {"1/2", "1/2"}), false));
    // One stage that depends on itself is implicit, even by an entry that is not proved to be zero.
    CHECK_FALSE(is_explicit(runge_kutta({{"1/2"}}, {"1"}), true));
}

TEST_CASE("stages that the step does not use may depend on themselves") {
    CHECK(is_explicit(runge_kutta({{"0", "0"}, {"0", "1/2"}}, {"1", "0"}), false));
    CHECK_FALSE(is_explicit(runge_kutta({{"0", "1/3"}, {"0", "1/2"}}, {"1", "0"}), false));
}

TEST_CASE("degrees of freedom that are told apart") {
    using K = StageNode::Kind;
    const auto groups = [](SlopePattern slopes) {
        return groups_in_order({{{true}}, {{true}}, std::move(slopes)});
    };
    // H = a P_b for the midpoint rule: dH/dp_a = 0, dH/dp_b = a, dH/da = p_b, dH/db = 0.
    const Pattern none{{false, false}, {false, false}};
    const auto chain = groups({{{false, false}, {true, false}}, none, none, {{false, true}, {}}});
    const std::vector<StageNode> expected{{K::Q, 0, 0}, {K::Lq, 0, 1}, {K::Q, 0, 1}};
    std::vector<StageNode> found;
    for (const std::vector<StageNode>& group : chain) {
        REQUIRE(group.size() == 1);
        const bool is_a_position = group[0].kind == K::Q;
        if (is_a_position || group[0] == expected[1]) { found.push_back(group[0]); }
    }
    CHECK(found == expected);
    // All as one need each other.
    CHECK(groups(slopes_of_all(true)).size() == 1);
    CHECK(groups(slopes_of_all(false)).size() == 1);
}
