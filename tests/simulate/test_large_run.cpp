// `hvi-gen run` on scenes whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"
#include "tests/cli/refusals.hpp"
#include "tests/simulate/cache.hpp"

using namespace hvi::test;

namespace {

/// Free particles that begin as a file says.
const std::string particles = R"toml(coordinates = "x[1..N]"
momenta     = "p[1..N]"
hamiltonian = "sum(i=1..N, p[i]^2/(2*m[i]))"
[parameters]
N = 400
m = {file = "start.csv", column = "mass"}
[initial]
x = {file = "start.csv", column = "x"}
"p[i]" = "m[i]*x[i]"
[run]
method = "stormer-verlet"
step   = "1/4"
until  = 1
)toml";

/// x = i/4 and masses of 1 and 2; `last` is the last row.
std::string start(int count, const std::string& last) {
    std::string text = "x,mass\n";
    for (int i = 1; i < count; ++i)
        text += std::to_string(0.25 * i) + "," + std::to_string(1 + i % 2) + "\n";
    return text + last + "\n";
}

}  // namespace

TEST_CASE("a run reads the files beside its scene, and the same program others") {
    use_cache();
    const Directory directory;
    std::filesystem::create_directory(directory / "in \"here\"");
    std::string scene = particles;
    scene.replace(scene.find("m[i]*x[i]"), 9, "2*m[i]");
    write(directory / "in \"here\"/s.toml", scene);
    const auto last_row = [&](const std::string& last) {
        write(directory / "in \"here\"/start.csv", start(400, last));
        const Outcome result = hvi_gen({"run", "in \"here\"/s.toml", "-o", "out", "--only", "table",
                                        "--columns", "x[1], x[400], p[399]"},
                                       directory.path());
        INFO(result.err);
        REQUIRE(result.status == 0);
        return lines_of(contents(directory / "out/trajectory.csv")).back();
    };
    // After the time 1 each has gone the way of 2, and p[399] is 2 m.
    CHECK(last_row("100,1") == "1,2.25,102,4");
    CHECK(last_row("-7,2") == "1,2.25,-5,4");
}

TEST_CASE("files that do not fit are refused, and nothing is written") {
    const Directory directory;
    const auto refused = [&](const std::string& file, const std::string& scene = particles) {
        write(directory / "s.toml", scene);
        write(directory / "start.csv", file);
        const Outcome result = hvi_gen({"run", "s.toml"}, directory.path());
        INFO(result.err);
        CHECK(result.status == 2);
        CHECK(result.out.empty());
        check_form(result.err);
        CHECK(directory.names() == std::vector<std::string>{"s.toml", "start.csv"});
        return result.err;
    };
    CHECK(pointed_at(refused(start(400, "nan,1"))) == "nan");
    CHECK(pointed_at(refused(start(400, "1,1/0"))) == "1/0");
    CHECK(pointed_at(refused(start(400, "1"))) == "1");
    CHECK(refused(start(399, "1,1")).find("`m` with the index 400") != std::string::npos);
    std::string scene = particles;
    scene.replace(scene.find("\"mass\""), 6, "\"masses\"");
    CHECK(refused(start(400, "1,1"), scene).find("help: did you mean `mass`?") !=
          std::string::npos);
    scene = particles;
    scene.replace(scene.find("(2*m[i])"), 8, "2");
    CHECK(refused(start(401, "1,1"), scene).find("`x` has 400 indices, and here are 401 values") !=
          std::string::npos);
}
