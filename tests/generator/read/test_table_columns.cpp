// The wanted columns of a table.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/table_columns.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

/// x is 0 to 5, u 6 to 17, s 18, c[2] 19, c[5] 20, energy 21.
const std::vector<NameBox> table = {{"x", {{1, 6}}}, {"u", {{0, 2}, {1, 4}}}, {"s", {}},
                                    {"c", {{2, 2}}}, {"c", {{5, 5}}},         {"energy", {}}};

/// `x[2]:1`, or `x[2..4]:1:1` with the strides.
std::string text(const std::vector<ColumnBox>& columns) {
    std::string all;
    for (const auto& [names, number, strides] : columns) {
        std::string ranges, steps, first;
        std::size_t count = 1;
        for (std::size_t d = 0; d < names.ranges.size(); ++d) {
            const auto& [from, to] = names.ranges[d];
            count *= static_cast<std::size_t>(to - from + 1);
            first += (d == 0 ? "" : ",") + std::to_string(from);
            ranges += (d == 0 ? "" : ",") + std::to_string(from) + ".." + std::to_string(to);
            steps += (d == 0 ? ":" : ",") + std::to_string(strides[d]);
        }
        const std::string& indices = count == 1 ? first : ranges;
        all += (all.empty() ? "" : " ") + names.stem +
               (names.ranges.empty() ? "" : "[" + indices + "]") + ":" + std::to_string(number) +
               (count == 1 ? "" : steps);
    }
    return all;
}

std::string chosen(const std::string& list) {
    return text(named_columns(source(list, "--columns"), table, {{"N", 4}}));
}

}  // namespace

TEST_CASE("columns are named one by one, by ranges and as a whole") {
    CHECK(chosen("s") == "s:18");
    CHECK(chosen("energy, x[2]") == "energy:21 x[2]:1");
    CHECK(chosen("x[2..N]") == "x[2..4]:1:1");
    CHECK(chosen("x") == "x[1..6]:0:1");
    CHECK(chosen("u") == "u[0..2,1..4]:6:4,1");
    CHECK(chosen("u[1..2,3]") == "u[1..2,3..3]:12:4,1");
    CHECK(chosen("u[2,4]") == "u[2,4]:17");
    CHECK(chosen("c") == "c[2]:19 c[5]:20");
    CHECK(chosen("c[5], x[1], x[6]") == "c[5]:20 x[1]:0 x[6]:5");
}

TEST_CASE("columns that are not there, or come twice") {
    const auto refused = [](const std::string& list) {
        return refusal([&] { return chosen(list); });
    };
    CHECK(refused("x, enrgy").marked == "x, [enrgy]");
    CHECK(refused("x, enrgy").helps("`energy`"));
    CHECK(refused("quite_another").helps("there are x, u, s, c, energy"));
    CHECK(refused("t").says("the time `t` is the first column in any case"));
    CHECK(refused("s, x[2..7]").marked == "s, [x[2..7]]");
    CHECK(refused("x[0]").says("there is no `x[0]`"));
    CHECK(refused("x[0]").helps("`x[1..6]`"));
    CHECK(refused("c[2..5]").helps("`c[2]` to `c[5]`"));
    CHECK(refused("x[3..2]").says("this range is empty"));
    CHECK(refused("s[1]").says("`s` has no index"));
    CHECK(refused("u[1]").says("`u` has 2 indices"));
    CHECK(refused("x[1,1]").says("`x` has 1 index"));
    CHECK(refused("x[2..4], x[4..5]").says("`x[4]` is named twice"));
    CHECK(refused("x[2..4], x[4..5]").marked == "x[2..4], [x[4..5]]");
    CHECK(refused("u[0,1..4], u[0..2,2]").says("`u[0,2]` is named twice"));
    CHECK(refused("s, s").says("`s` is named twice"));
    for (const char* list : {"", "s,", ",s", "x[", "x[1/2]", "x[M]", "s x", "x[1..2000000]"}) {
        CAPTURE(list);
        CHECK(refused(list).status == 2);
    }
}

TEST_CASE("columns are counted from the left") {
    const auto columns = named_columns(source("s, u[1..2,2..3], x[3..4]"), table, {});
    CHECK(columns_before(columns, "s") == 0U);
    CHECK(columns_before(columns, "u[1,2]") == 1U);
    CHECK(columns_before(columns, "u[2,2]") == 3U);
    CHECK(columns_before(columns, "x[4]") == 6U);
    for (const char* name : {"x[2]", "u[0,2]", "energy", "t"}) {
        CHECK(!columns_before(columns, name));
    }
}

TEST_CASE("of 64 degrees of freedom all are shown, of more the first three of each name") {
    const std::vector<NameBox> few = {{"q", {{1, 64}}}, {"p", {{1, 64}}}, {"energy", {}}};
    CHECK(text(usual_columns(few, 2)) == "q[1..64]:0:1 p[1..64]:64:1 energy:128");
    const std::vector<NameBox> many = {
        {"x", {{0, 999}}}, {"u", {{1, 1000}, {1, 1000}}}, {"energy", {}}, {"spin", {}}};
    CHECK(text(usual_columns(many, 2)) ==
          "x[0..2]:0:1 u[1..1,1..3]:1000:1000,1 energy:1001000 spin:1001001");
    std::vector<NameBox> one_by_one;
    for (int i = 1; i <= 130; ++i) {
        one_by_one.push_back(name_box("q[" + std::to_string(i) + "]"));
    }
    CHECK(text(usual_columns(one_by_one, 130)) == "q[1]:0 q[2]:1 q[3]:2");
}

TEST_CASE("columns are seen one by one, the last index first") {
    std::string seen;
    const auto see = [&](const std::string& name, std::size_t number) {
        seen += name + ":" + std::to_string(number) + " ";
    };
    for_each_column(named_columns(source("energy, u[1..2,2..3], x[6], s", "--columns"), table, {}),
                    see);
    CHECK(seen == "energy:21 u[1,2]:11 u[1,3]:12 u[2,2]:15 u[2,3]:16 x[6]:5 s:18 ");
}
