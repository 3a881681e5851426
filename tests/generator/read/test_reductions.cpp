// Lists of functions of columns, such as `min(x), mean(energy)`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/reductions.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

/// `min(x[2]):1`, with the number of the column.
std::string reduced(const std::string& list) {
    // x is 0 to 5, u 6 to 9, energy 10.
    const std::vector<NameBox> all = {{"x", {{1, 6}}}, {"u", {{1, 2}, {1, 2}}}, {"energy", {}}};
    std::string text;
    for (const Reduction& each : named_reductions(source(list, "--reduce"), all, {{"N", 4}})) {
        const bool is_right = each.name.find(each.kind == ReductionKind::least     ? "min("
                                             : each.kind == ReductionKind::largest ? "max("
                                                                                   : "mean(") == 0;
        text += (text.empty() ? "" : " ") + each.name + (is_right ? ":" : "!") +
                std::to_string(each.column);
    }
    return text;
}

}  // namespace

TEST_CASE("functions of columns are read, each of one column") {
    CHECK(reduced("min(energy)") == "min(energy):10");
    CHECK(reduced(" max ( x[2] ),mean(x[2] )") == "max(x[2]):1 mean(x[2]):1");
    CHECK(reduced("max(u[1,2]), min(u[2,1])") == "max(u[1,2]):7 min(u[2,1]):8");
    CHECK(reduced("mean(x[3..N], energy)") == "mean(x[3]):2 mean(x[4]):3 mean(energy):10");
    CHECK(reduced("min(u)") == "min(u[1,1]):6 min(u[1,2]):7 min(u[2,1]):8 min(u[2,2]):9");
}

TEST_CASE("functions of columns that are not there, or come twice") {
    const auto refused = [](const std::string& list) {
        return refusal([&] { return reduced(list); });
    };
    CHECK(refused("min(x), meen(x)").marked == "min(x), [meen](x)");
    CHECK(refused("min(x), meen(x)").helps("`mean`"));
    CHECK(refused("sum(x)").marked == "[sum](x)");
    CHECK(refused("sum(x)").helps("there are min, max, mean"));
    CHECK(refused("min(energi)").marked == "min([energi])");
    CHECK(refused("min(energi)").helps("`energy`"));
    CHECK(refused("min(x[7])").marked == "min([x[7]])");
    CHECK(refused("min(t)").marked == "min([t])");
    CHECK(refused("max(x), max(x[2])").marked == "max(x), [max(x[2])]");
    CHECK(refused("mean").marked == "[mean]");
    CHECK(refused("energy, min(x)").marked == "[energy], min(x)");
    CHECK(refused("min(x").marked == "min[(]x");
    CHECK(refused("min(x) max(x)").marked == "min(x[)] max(x)");
    CHECK(refused("min(x), , max(x)").says("an item is missing in this list"));
    CHECK(refused("").says("an item is missing in this list"));
    CHECK(refused("min()").says("the text is empty"));
    CHECK(refused("min(x))").marked == "min(x[)])");
}
