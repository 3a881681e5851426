// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/nearest.hpp"

using namespace hvi::gen;

TEST_CASE("typing errors are understood") {
    const std::vector<std::string_view> names{"gauss", "lobatto", "radau-left", "radau-right"};
    CHECK(nearest("gaus", names) == std::vector<std::string_view>{"gauss"});
    CHECK(nearest("guass", names) == std::vector<std::string_view>{"gauss"});
    CHECK(nearest("Lobato", names) == std::vector<std::string_view>{"lobatto"});
    CHECK(nearest("radau_left", names).front() == "radau-left");
}

TEST_CASE("a word that resembles nothing has no suggestion") {
    const std::vector<std::string_view> names{"gauss", "lobatto"};
    CHECK(nearest("verlet", names).empty());
    CHECK(nearest("", names).empty());
    CHECK(nearest(std::string(100000, 'g'), names).empty());
    CHECK(did_you_mean("verlet", names, "otherwise") == "otherwise");
    CHECK(did_you_mean("gaus", names, "otherwise") == "did you mean `gauss`?");
    CHECK(did_you_mean("sinn", {"sin", "sinh"}, "") == "did you mean `sin` or `sinh`?");
}
