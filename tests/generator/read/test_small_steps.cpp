// Small steps of fast parts in a scene: what is read, and what is refused.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

namespace {

/// A scene whose parts are named in another order than they flow in.
const std::string spring = R"toml(coordinates = ["x"]
momenta = ["p"]
hamiltonian = "p^2/2 + 50*x^2 + x^4 + cos(x)"
[split]
bond = "50*x^2"
small_steps = {parts = ["T", "bond"], count = 10}
slow = "x^4"
T = "p^2/2"
field = "cos(x)"
[initial]
x = 1
p = 0
)toml";

/// Returns the refusal of a scene in which other small steps are chosen.
Refusal refused_choice(const std::string& choice) {
    return hvi::gen::refused(spring, "{parts = [\"T\", \"bond\"], count = 10}", choice);
}

}  // namespace

TEST_CASE("fast parts are the first, all parts being in the order of the file else") {
    const WrittenOutScene scene = read(spring);
    REQUIRE(scene.split);
    Names names;
    for (const NamedExpression& part : scene.split->parts) { names.push_back(part.name); }
    CHECK(names == Names{"bond", "T", "slow", "field"});
    CHECK(scene.split->small_steps == SmallSteps{2, 10});
    const WrittenOutScene plain =
        read(edited(spring, "small_steps = {parts = [\"T\", \"bond\"], count = 10}\n", ""));
    CHECK(plain.split->parts[0].name == "bond");
    CHECK_FALSE(plain.split->small_steps.exist());
}

TEST_CASE("one small step is a choice, too") {
    CHECK(read(edited(spring, "count = 10", "count = 1")).split->small_steps == SmallSteps{2, 1});
}

TEST_CASE("fast parts are parts, each named once") {
    const Refusal unknown = refused_choice("{parts = [\"T\", \"bnd\"], count = 10}");
    CHECK(unknown.what == "`bnd` is no part");
    CHECK(unknown.name == "s.toml:6");
    CHECK(unknown.marked == "small_steps = {parts = [\"T\", [\"bnd\"]], count = 10}");
    CHECK(unknown.helps("did you mean `bond`?"));
    CHECK(refused_choice("{parts = [\"T\", \"potential\"], count = 2}").help ==
          "the parts are bond, slow, T, field");
    const Refusal twice = refused_choice("{parts = [\"T\", \"bond\", \"T\"], count = 10}");
    CHECK(twice.what == "`T` is named twice");
    CHECK(twice.marked == "small_steps = {parts = [\"T\", \"bond\", [\"T\"]], count = 10}");
}

TEST_CASE("fast parts are two or more, and not all") {
    const Refusal one = refused_choice("{parts = [\"T\"], count = 10}");
    CHECK(one.what == "small steps are taken by two parts or more");
    CHECK(one.marked == "small_steps = {parts = [[\"T\"]], count = 10}");
    CHECK(one.helps("the flow of one part is exact"));
    CHECK(refused_choice("{parts = [], count = 10}").what == one.what);
    const Refusal all =
        refused_choice("{parts = [\"T\", \"bond\", \"slow\", \"field\"], count = 10}");
    CHECK(all.what == "all parts are fast");
    CHECK(all.status == 2);
}

TEST_CASE("the number of small steps is a whole number") {
    const Refusal none = refused_choice("{parts = [\"T\", \"bond\"], count = 0}");
    CHECK(none.what == "a whole number from 1 to 1000000 is wanted here");
    CHECK(none.marked == "small_steps = {parts = [\"T\", \"bond\"], count = [0]}");
    for (const char* count : {"-3", "2.5", "10.0", "\"10\"", "1000001", "true"}) {
        CAPTURE(count);
        CHECK(refused_choice("{parts = [\"T\", \"bond\"], count = " + std::string(count) + "}")
                  .what == none.what);
    }
}

TEST_CASE("small steps have parts and a number") {
    const std::string help = "write small_steps = {parts = [\"A\", \"B\"], count = 10}";
    for (const char* choice : {"{count = 10}", "{parts = [\"T\", \"bond\"]}", "10", "\"x^2\""}) {
        CAPTURE(choice);
        const Refusal error = refused_choice(choice);
        CHECK(error.what == "small steps are of parts, and so many in a large one");
        CHECK(error.help == help);
    }
    const Refusal key = refused_choice("{parts = [\"T\", \"bond\"], number = 10}");
    CHECK(key.what == "a choice of small steps has no key `number`");
    CHECK(key.helps("the keys are parts, count"));
    const Refusal text = refused_choice("{parts = \"T\", count = 10}");
    CHECK(text.what == "a list of fast parts is wanted here");
    CHECK(text.help == "write [\"bond\", \"slow\", \"T\", \"field\"]");
    CHECK(refused_choice("{parts = [1, true], count = 10}").status == 2);
}
