// Small steps of fast parts, on the command line.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/refusals.hpp"

using namespace hvi::test;

namespace {

const std::string stiff_spring = R"toml(name = "spring"
coordinates = ["x"]
momenta = ["p"]
hamiltonian = "p^2/2 + 50*x^2 + x^4"
[split]
bond = "50*x^2"
T = "p^2/2"
slow = "x^4"
small_steps = {parts = ["bond", "T"], count = 10}
[initial]
x = 1
p = 0
)toml";

/// Runs the program where the scene is.
Outcome with_spring(const std::vector<std::string>& words) {
    const Directory directory;
    write(directory / "spring.toml", stiff_spring);
    return hvi_gen(words, directory.path());
}

bool is_in(const std::string& part, const std::string& text) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("fast parts are listed first, with their small steps") {
    const Outcome listed = with_spring({"list", "splits", "spring.toml"});
    CHECK(listed.status == 0);
    CHECK(listed.out ==
          "Parts of H of spring, as [split] names them: their flows are exact\n"
          "  bond  a shear  50*x^2\n"
          "  T     a shear  p^2/2\n"
          "  slow  a shear  x^4\n"
          "not kept by bond, T, slow: energy\n"
          "the first 2 are fast: they take 10 small steps in a large one\n"
          "strang takes 23 flows a step, as in hvi-gen run --method strang spring.toml\n");
}

TEST_CASE("a header has small steps as a loop") {
    const Outcome stepper = with_spring({"stepper", "--method", "strang", "spring.toml"});
    REQUIRE(stepper.status == 0);
    // NOTE: it stands in the loop over steps in a row.
    CHECK(is_in("for (int k = 0; k < 4; ++k) {\n"
                "                flows_2_[0](path);\n"
                "                flows_1_[1](path);\n"
                "            }\n",
                stepper.out));
    CHECK(is_in("//     4 times:\n", stepper.out));
}

TEST_CASE("splittings whose orders need exact flows refuse small steps") {
    for (const char* method : {"saba:4", "mclachlan:8.4"}) {
        const Outcome refused = with_spring({"stepper", "--method", method, "spring.toml"});
        CHECK(refused.status == 2);
        CHECK(refused.out.empty());
        check_form(refused.err);
        CHECK(pointed_at(refused.err) == method);
        CHECK(is_in("is for flows that are exact, and small steps are not", refused.err));
        CHECK(is_in("take strang", refused.err));
    }
}

TEST_CASE("methods that are no splittings step the whole H, whatever its parts are") {
    const auto text = [](const std::string& method, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"stepper", "--method", method, "spring.toml"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome stepper = with_spring(words);
        CHECK(stepper.status == 0);
        return stepper.out;
    };
    CHECK_FALSE(is_in("flows_1_", text("stormer-verlet", {})));
    CHECK_FALSE(is_in("flows_1_", text("saba:4", {"--split", "none"})));
    CHECK(is_in("flows_1_", text("saba:4", {"--split", "auto"})));
}
