// Steps that are flows of parts: their order, and small steps of fast parts.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/plan/flow_step.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;

namespace {

/// Returns the flows one by one, a letter and a fraction for each.
std::vector<std::string> one_by_one(const FlowStep& form) {
    std::vector<std::string> all;
    for (const auto& [moves, times] : form.rounds) {
        for (std::size_t k = 0; k < times; ++k) {
            for (const auto& [part, fraction] : moves) {
                all.push_back(std::string(1, static_cast<char>('A' + part)) + " " +
                              form.fractions[part][fraction].decimal(6));
            }
        }
    }
    return all;
}

using Flows = std::vector<std::string>;

NumberVector halves() { return {tableaux::ratio(1, 2), tableaux::ratio(1, 2)}; }

}  // namespace

// Tuckerman, Berne & Martyna, J. Chem. Phys. 97 (1992) 1990: half a kick of the slow force,
// n steps of velocity Verlet of the rest, half a kick of the slow force.
TEST_CASE("fast parts take their small steps in the middle of a large one") {
    const FlowStep form = flow_step(3, {2, 4}, halves());
    CHECK(one_by_one(form) == Flows{"A 0.5", "B 0.125", "C 0.25", "B 0.25", "C 0.25", "B 0.25",
                                    "C 0.25", "B 0.25", "C 0.25", "B 0.125", "A 0.5"});
    CHECK(form.counts() == std::vector<std::size_t>{2, 5, 4});
    CHECK(form.flows() == 11);
}

TEST_CASE("small steps are a round that is made several times, however many") {
    for (const std::size_t count : {std::size_t{3}, std::size_t{10}, std::size_t{1000}}) {
        const FlowStep form = flow_step(3, {2, count}, halves());
        REQUIRE(form.rounds.size() == 3);
        CHECK(form.rounds[0].moves.size() == 2);
        CHECK(form.rounds[1].moves.size() == 2);
        CHECK(form.rounds[1].times == count - 1);
        CHECK(form.rounds[2].moves.size() == 3);
        CHECK(form.flows() == 2 * count + 3);
        CHECK(form.fractions[1].size() == 2);
        CHECK(form.fractions[2].size() == 1);
    }
}

TEST_CASE("one small step in a large one is the splitting of all parts") {
    const FlowStep form = flow_step(4, {2, 1}, halves());
    CHECK(one_by_one(form) == one_by_one(flow_step(4, {}, halves())));
    CHECK(form.rounds.size() == 1);
}

TEST_CASE("two small steps are no round of their own") {
    const FlowStep form = flow_step(3, {2, 2}, halves());
    CHECK(form.rounds.size() == 1);
    CHECK(one_by_one(form) ==
          Flows{"A 0.5", "B 0.25", "C 0.5", "B 0.5", "C 0.5", "B 0.25", "A 0.5"});
}

TEST_CASE("three fast parts go there and back in each small step") {
    const FlowStep form = flow_step(5, {3, 2}, halves());
    CHECK(one_by_one(form) == Flows{"A 0.5", "B 0.5", "C 0.25", "D 0.25", "E 0.5", "D 0.25",
                                    "C 0.5", "D 0.25", "E 0.5", "D 0.25", "C 0.25", "B 0.5",
                                    "A 0.5"});
}

TEST_CASE("each step of a composition has as many small steps, and slow flows in a row are one") {
    const FlowStep form =
        flow_step(3, {2, 2}, {1, 1, tableaux::ratio(-1, 2), tableaux::ratio(-1, 2)});
    CHECK(one_by_one(form) == Flows{"A 1.", "B 0.5", "C 1.", "B 1.", "C 1.", "B 0.5", "A 0.5",
                                    "B -0.25", "C -0.5", "B -0.5", "C -0.5", "B -0.25", "A -0.5"});
}
