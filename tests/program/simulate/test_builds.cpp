// Programs that are compiled side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/program/builds.hpp"
#include "generator/support/child.hpp"
#include "generator/support/error.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::gen;

namespace {

ProgramText program(const std::string& statements) {
    return {"#include <cstdio>\nint main() { " + statements + " }\n", {}};
}

std::string output(const Build& build) { return run_child({built(build).string()}, ".").output; }

}  // namespace

TEST_CASE("programs that are ordered together are compiled each, and each once") {
    hvi::test::use_cache();
    Builds builds(find_compiler());
    std::vector<Build> ordered;
    for (int i = 0; i < 5; ++i)
        ordered.push_back(builds.order(program("std::puts(\"" + std::to_string(i) + "\");")));
    const Build again = builds.order(program("std::puts(\"3\");"));
    for (int i = 0; i < 5; ++i)
        CHECK(output(ordered.at(static_cast<std::size_t>(i))) == std::to_string(i) + "\n");
    CHECK(built(again) == built(ordered.at(3)));
    CHECK(built(ordered.at(0)) != built(ordered.at(1)));
}

TEST_CASE("a program that cannot be compiled does not hinder the others") {
    hvi::test::use_cache();
    Builds builds(find_compiler());
    const Build wrong = builds.order(program("this is no statement;")),
                right = builds.order(program("std::puts(\"right\");"));
    CHECK_THROWS_AS(built(wrong), EnvironmentError);
    CHECK_THROWS_AS(built(wrong), EnvironmentError);  // nor does it go away
    CHECK(output(right) == "right\n");
}

TEST_CASE("what nobody waits for is forgotten") {
    const hvi::test::Directory directory;
    const std::string count = (directory / "count").string(), script = (directory / "cxx").string();
    hvi::test::write(count, "");
    hvi::test::write(script, "#!/bin/sh\n[ \"$1\" = --version ] || echo >> '" + count + "'\nexec " +
                                 hvi::test::compiler_of_tests() + " \"$@\"\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    hvi::test::use_cache();
    constexpr std::size_t ordered = 100;
    {
        Builds builds({{script}, "counted"});
        for (std::size_t i = 0; i < ordered; ++i)
            static_cast<void>(
                builds.order(program("std::puts(\"left " + std::to_string(i) + "\");")));
    }
    // Compilations that have begun come to their end, and no other begins.
    CHECK(hvi::test::lines_of(hvi::test::contents(count)).size() < ordered / 2);
}
