// `hvi-gen run` on scenes whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/cli/refusals.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;

namespace {

// NOTE: sanitizers end a process that asks for too much memory, where operator new would throw.
#ifdef __has_feature
constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
constexpr bool is_sanitized = false;
#endif

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

namespace {

/// Springs on a plane; one of them begins at `start`.
std::string plane(const std::string& start, int n = 100) {
    return "coordinates = \"u[0..N-1,0..N-1]\"\nmomenta = \"v[0..N-1,0..N-1]\"\n"
           "hamiltonian = \"sum(i=0..N-1, j=0..N-1, (v[i,j]^2 + u[i,j]^2)/2)\"\n"
           "[parameters]\nN = " +
           std::to_string(n) + "\n[initial]\n\"u[i,j]\" = 1\n\"v[i,j]\" = \"" + start +
           "\"\n[run]\nmethod = \"stormer-verlet\"\nstep = \"1/8\"\nuntil = 1\n";
}

Outcome run_plane(const Directory& directory, const std::string& scene) {
    use_cache();
    write(directory / "plane.toml", scene);
    const Outcome outcome = hvi_gen({"run", "plane.toml", "-o", "out"}, directory.path());
    INFO(outcome.err);
    check_form(outcome.err);
    CHECK(outcome.out.empty());
    return outcome;
}

}  // namespace

TEST_CASE("one variable of many that begins with no number is named, and what there is is kept") {
    const Directory directory;
    // -inf at i = 99, j = 98 alone.
    const Outcome outcome = run_plane(directory, plane("log(abs(i - 99) + abs(j - 98))"));
    CHECK(outcome.status == 1);
    CHECK(outcome.err.find("the run stopped after 0 of 8 steps: v[99,98] begins with no finite "
                           "number") != std::string::npos);
    CHECK(names_in(directory / "out") ==
          std::vector<std::string>{"picture.svg", "summary.txt", "trajectory.csv"});
    const auto rows = lines_of(contents(directory / "out/trajectory.csv"));
    REQUIRE(rows.size() == 3);
    CHECK(rows[1].substr(0, 2) == "0,");
    CHECK(rows[2].find("# incomplete: ") == 0);
}

TEST_CASE("a state for which there is no memory: status 3, and nothing is left") {
    const Directory directory;
    const Outcome outcome = run_plane(directory, plane("0", 1000000));  // eight terabytes each
    CHECK(outcome.status == 3);
    if (!is_sanitized)
        CHECK(outcome.err.find("error: there is not enough memory for the run") == 0);
    CHECK(directory.names() == std::vector<std::string>{"plane.toml"});
}

TEST_CASE("a scene without any variable is refused") {
    const Directory directory;
    for (const int n : {0, -5}) {
        const Outcome outcome = run_plane(directory, plane("0", n));
        CHECK(outcome.status == 2);
        CHECK(pointed_at(outcome.err) == "0..N-1");
        CHECK(directory.names() == std::vector<std::string>{"plane.toml"});
    }
}
