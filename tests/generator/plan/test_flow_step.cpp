// Steps that are flows of parts: their order, and small steps of fast parts.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/exact/numbers/number_text.hpp"
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
                              dump(form.fractions[part][fraction]));
            }
        }
    }
    return all;
}

using Flows = std::vector<std::string>;

NumberVector halves() { return {tableaux::ratio(1, 2), tableaux::ratio(1, 2)}; }

}  // namespace

TEST_CASE("fast parts take half of their small steps before the others, and half thereafter") {
    const FlowStep form = flow_step(3, {2, 4}, halves());
    CHECK(one_by_one(form) == Flows{"A 1/8", "B 1/4", "A 1/4", "B 1/4", "A 1/8", "C 1", "A 1/8",
                                    "B 1/4", "A 1/4", "B 1/4", "A 1/8"});
    CHECK(form.counts() == std::vector<std::size_t>{6, 4, 1});
    CHECK(form.flows() == 11);
}

TEST_CASE("of an odd number of small steps the middle one is taken apart") {
    const FlowStep form = flow_step(3, {2, 3}, halves());
    CHECK(one_by_one(form) ==
          Flows{"A 1/6", "B 1/3", "A 1/3", "B 1/6", "C 1", "B 1/6", "A 1/3", "B 1/3", "A 1/6"});
    CHECK(form.flows() == 9);
}

TEST_CASE("small steps are rounds that are made several times, however many") {
    for (const std::size_t count : {std::size_t{6}, std::size_t{11}, std::size_t{1000}}) {
        const FlowStep form = flow_step(3, {2, count}, halves());
        REQUIRE(form.rounds.size() == 5);
        CHECK(form.rounds[0].moves.size() == 1);
        CHECK(form.rounds[1].moves.size() == 2);
        CHECK(form.rounds[1].times == (count - 1) / 2);
        CHECK(form.rounds[3].times == (count - 1) / 2);
        CHECK(form.rounds[4].moves.size() == 1);
        CHECK(form.counts()[1] == count + count % 2);
        CHECK(form.counts()[2] == 1);
        CHECK(form.fractions[0].size() == 2);
    }
}

TEST_CASE("one small step in a large one is the splitting of all parts") {
    const FlowStep form = flow_step(4, {2, 1}, halves());
    CHECK(one_by_one(form) == one_by_one(flow_step(4, {}, halves())));
    CHECK(form.rounds.size() == 1);
}

TEST_CASE("three fast parts go there and back in each small step, as do two slow ones in a step") {
    const FlowStep form = flow_step(5, {3, 2}, halves());
    CHECK(one_by_one(form) == Flows{"A 1/4", "B 1/4", "C 1/2", "B 1/4", "A 1/4", "D 1/2", "E 1",
                                    "D 1/2", "A 1/4", "B 1/4", "C 1/2", "B 1/4", "A 1/4"});
    CHECK(form.rounds.size() == 1);
}

TEST_CASE("each step of a composition has as many small steps, and flows in a row are one") {
    const FlowStep form =
        flow_step(3, {2, 2}, {1, 1, tableaux::ratio(-1, 2), tableaux::ratio(-1, 2)});
    CHECK(one_by_one(form) == Flows{"A 1/2", "B 1", "A 1/2", "C 2", "A 1/2", "B 1", "A 1/4",
                                    "B -1/2", "A -1/4", "C -1", "A -1/4", "B -1/2", "A -1/4"});
}

TEST_CASE(
    "the last flow of a step and the first one of the next are one where parts are the same") {
    const auto joined = [](const FlowStep& form) {
        REQUIRE(form.joined);
        return dump(form.fractions[form.rounds.front().moves.front().part][*form.joined]);
    };
    const FlowStep strang = with_joined_ends(flow_step(2, {}, halves()));
    CHECK(joined(strang) == "1");
    FlowStep rest = strang;
    rest.rounds = strang.between();
    CHECK(one_by_one(rest) == Flows{"B 1"});

    const FlowStep small = with_joined_ends(flow_step(3, {2, 4}, halves()));
    CHECK(joined(small) == "1/4");
    rest = small;
    rest.rounds = small.between();
    CHECK(one_by_one(rest) ==
          Flows{"B 1/4", "A 1/4", "B 1/4", "A 1/8", "C 1", "A 1/8", "B 1/4", "A 1/4", "B 1/4"});

    const auto ratio = tableaux::ratio;
    const FlowStep composed =
        with_joined_ends(flow_step(2, {}, {ratio(1, 6), ratio(1, 3), ratio(1, 3), ratio(1, 6)}));
    CHECK(joined(composed) == "1/3");
    CHECK(composed.fractions[0].size() == 3);
}

TEST_CASE("nothing is joined where a step ends with another part, or is one flow") {
    CHECK_FALSE(with_joined_ends(flow_step(2, {}, {tableaux::ratio(1, 1)})).joined);
    CHECK_FALSE(with_joined_ends(flow_step(1, {}, halves())).joined);
}
