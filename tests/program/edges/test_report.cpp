// `hvi-gen report --edges`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;
using nlohmann::json;

namespace {

/// A compiler that takes less time, of programs that take a little more; `edit` is a line of shell
/// before it.
std::string compiler(const Directory& directory, const std::string& edit) {
    write(directory / "cxx",
          "#!/bin/sh\n" + edit + "\nexec " + compiler_of_tests() + " \"$@\" -O1\n");
    std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
    return "CXX=./cxx XDG_CACHE_HOME=" + (directory / "cache").string() + " ";
}

json checks_of(const json& report, const std::string& chapter) {
    for (const json& each : report.at("edges"))
        if (each.at("name") == chapter) return each.at("checks");
    FAIL("no chapter " + chapter);
    return {};
}

/// The first case with these words in it.
json find(const json& checks, const std::string& scene, const std::string& words) {
    for (const json& check : checks)
        if (check.at("scene") == scene &&
            check.at("case").get<std::string>().find(words) != std::string::npos)
            return check;
    FAIL("no case " + words + " on " + scene);
    return {};
}

}  // namespace

TEST_CASE("gauss:2 does at the edges what it should") {
    const Directory directory;
    const Outcome result =
        shell(compiler(directory, "") + "hvi-gen report --edges --methods gauss:2 -o out",
              directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    const json report = json::parse(contents(directory / "out/report.json"));
    CHECK(report.at("schema") == "hvi-report/1");
    CHECK(report.at("scenes").empty());

    const json rejections = checks_of(report, "rejections");
    CHECK(rejections.size() == 117);
    CHECK(find(rejections, "kepler", "h = 0").at("seen") == "ok, the state untouched");
    CHECK(find(rejections, "kepler", "q2 = nan").at("seen") ==
          "the step met a value that is infinite or not a number, the state untouched");
    CHECK(find(rejections, "kepler", "all of the state 0").at("expected") ==
          "a status, the state untouched");

    // z^2 times the spectral radius of A A, 1/12, is 0.7 at z = 2.90, and 1.01 at 3.48: of the
    // points 10^(-3 + k/8) these are k < 28, and k > 28.
    const json stiff = checks_of(report, "stiff");
    CHECK(stiff.size() == 3);
    CHECK(find(stiff, "harmonic-oscillator", "as is").at("expected") ==
          "bounded at 57, growing at 0");
    CHECK(find(stiff, "harmonic-oscillator", "fixed points").at("expected") ==
          "bounded at 28, growing at 0, that or stopped at 1, refused at 28");

    // In the chain z <= 0.3 for k < 20; the fixed points expand by 2, z^2 = 24, for k > 29.
    const json chain = checks_of(report, "chain");
    CHECK(chain.size() == 3);
    CHECK(find(chain, "fpu", "Newton").at("expected") ==
          "H kept at 20, bounded at 37, growing or stopped at 0, either at 0");
    CHECK(find(chain, "fpu", "fixed points").at("expected") ==
          "H kept at 20, bounded at 10, growing or stopped at 0, either at 0, refused at 27");

    const json extreme = checks_of(report, "extreme");
    CHECK(extreme.size() == 37);
    CHECK(find(extreme, "kepler", "e = 0.9999: past").at("expected") ==
          "errors that fall with order 4");
    CHECK(find(extreme, "kepler", "e = 0.9999: past")
              .at("seen")
              .get<std::string>()
              .rfind("order 4.0", 0) == 0);
    CHECK(find(extreme, "scaled-kepler", "Newton: H times 2^900").at("seen") ==
          "ok, the same bits");
    // Exponents of three kinds of runs, and what three steppers would lose.
    const json runs = checks_of(report, "long");
    CHECK(runs.size() == 6);
    CHECK(find(runs, "harmonic-oscillator", "134217728 steps").at("expected") ==
          "an exponent below 0.75");
    for (const std::string what : {"sums not compensated", "entries rounded one by one"})
        CHECK(
            find(runs, "kepler", what).at("expected").get<std::string>().find("at the end more") ==
            0);
    const json time = checks_of(report, "time");
    CHECK(time.size() == 21);
    CHECK(
        find(time, "ball", "infinitely many").at("seen").get<std::string>().find("t = 2.9999999") !=
        std::string::npos);
    CHECK(find(time, "oscillator", "dt/ds = 1 - t")
              .at("seen")
              .get<std::string>()
              .rfind("the time does not go on with the steps at t = 1,", 0) == 0);
    CHECK(find(time, "ball", "-p/2, said").at("seen") == "refused");
    CHECK(find(time, "ball", "a jump at t = 1")
              .at("seen")
              .get<std::string>()
              .find("q = 0.5, 0.375,") != std::string::npos);
    CHECK(find(time, "checkpoint", "numbers").at("seen") == "10 with their bits");
    const json symplecticity = checks_of(report, "symplecticity");
    CHECK(symplecticity.size() == 48);
    // (32 steps + 4) 2^-53.
    CHECK(find(symplecticity, "kepler", "1 step of 0.05").at("expected") == "below 4.0e-15");
    CHECK(find(symplecticity, "kepler", "1000 steps of 0.05").at("expected") == "below 3.6e-12");

    const std::string page = contents(directory / "out/report.html");
    CHECK(page.find("cases are as expected") != std::string::npos);
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("src=") == std::string::npos);
}

TEST_CASE("a composition does at the edges what it should") {
    const Directory directory;
    const std::string report = "hvi-gen report --only stiff,extreme,rejections,json "
                               "--methods stormer-verlet-yoshida:4 harmonic-oscillator -o out";
    const Outcome result = shell(compiler(directory, "") + report, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const json found = json::parse(contents(directory / "out/report.json"));
    const json extreme = checks_of(found, "extreme");
    CHECK(find(extreme, "kepler", "e = 0.9999: past").at("expected") ==
          "errors that fall with order 4");
    CHECK(find(extreme, "kepler", "e = 0.9999: past")
              .at("seen")
              .get<std::string>()
              .rfind("order 4.0", 0) == 0);
    CHECK(find(extreme, "kepler", "e = 0.9999: past").at("method") == "stormer-verlet-yoshida:4");
    const json rejections = checks_of(found, "rejections");
    CHECK(find(rejections, "harmonic-oscillator", "and back").at("expected") ==
          "ok, back within 1e-12");
    const json stiff = checks_of(found, "stiff");
    // The bounded ones among the points 10^(-3 + k/8) are k < 26: see test_oscillation.cpp.
    CHECK(find(stiff, "harmonic-oscillator", "57 z").at("expected") ==
          "bounded at 26, growing at 31");
}

TEST_CASE("a stepper that is wrong is seen to be wrong, in each chapter") {
    const Directory directory;
    // The edited stepper accepts states that are not finite, drifts a little too far, and loses
    // momentum. In the chain it gains much, and for a scaled H it drifts too far in large steps
    // alone.
    const std::string edit = "[ -f stepper.hpp ] && sed -i"
                             " -e 's/!hvi::detail::finite(q_, end)/false/'"
                             " -e 's/+ h \\* slope\\[k\\]/+ h * Scalar(1.00001) * slope[k]/'"
                             " -e 's/x.p\\[k\\] = \\(.*\\);/x.p[k] = (\\1) * Scalar(1 - 1e-10);/'"
                             " stepper.hpp"
                             " && sed -i"
                             " -e '/class BasicFpu/,$ s/(1 - 1e-10)/(1.05)/'"
                             " -e '/class BasicScaled/,$ s/(1.00001)/(h > 1 ? 1.00001 : 1.0)/'"
                             " stepper.hpp";
    const Outcome result =
        shell(compiler(directory, edit) + "hvi-gen report --edges --methods stormer-verlet -o out",
              directory.path());
    INFO(result.err);
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK(result.err.find("error: stormer-verlet on pendulum, ") != std::string::npos);
    CHECK(result.err.find("cases are not as expected: see out") != std::string::npos);
    const json report = json::parse(contents(directory / "out/report.json"));
    const auto agrees = [&](const std::string& chapter, const std::string& scene,
                            const std::string& words) {
        const json check = find(checks_of(report, chapter), scene, words);
        INFO(check.dump());
        return check.at("agrees").get<bool>();
    };
    CHECK(agrees("rejections", "kepler", "h = 0"));
    CHECK_FALSE(agrees("rejections", "kepler", "p1 = nan"));
    CHECK_FALSE(agrees("stiff", "harmonic-oscillator", "below the end 2"));
    CHECK(agrees("stiff", "harmonic-oscillator", "above the end 2"));
    CHECK_FALSE(agrees("chain", "fpu", "as is"));
    CHECK_FALSE(agrees("extreme", "kepler", "e = 0.9999: past"));
    CHECK_FALSE(agrees("extreme", "scaled-kepler", "2^-498"));
    CHECK(agrees("extreme", "scaled-kepler", "2^498"));
    CHECK_FALSE(agrees("extreme", "two-bodies", "1e-12, e = 0.5: past"));
    CHECK_FALSE(agrees("extreme", "two-bodies", "1e-12: 5000 steps"));
    CHECK_FALSE(agrees("long", "harmonic-oscillator", "4 runs"));
    CHECK_FALSE(agrees("long", "kepler", "8 runs"));
    // NOTE: where H is not separable, where there is an L and where bodies only turn, the stepper
    // has other lines.
    const std::set<std::string> others{
        "bead-on-hoop",    "chain-of-links", "coupled-rotors",    "double-pendulum", "heavy-top",
        "free-rigid-body", "lagrange-top",   "nonseparable",      "point-vortices",  "qp",
        "robot-arm",       "two-pendulums",  "spherical-pendulum"};
    // NOTE: of bodies on orbits, over many steps the entries of D hide what is lost in momenta
    // alone.
    const std::set<std::string> on_orbits{"spacecraft", "two-rigid-bodies", "water-dimer"};
    for (const json& check : checks_of(report, "symplecticity")) {
        const bool is_one_step = check.at("case").get<std::string>().rfind("1 step ", 0) == 0;
        if (on_orbits.count(check.at("scene")) == 1 && !is_one_step) continue;
        INFO(check.dump());
        CHECK(check.at("agrees") == (others.count(check.at("scene")) == 1));
    }
    CHECK(contents(directory / "out/report.html").find("NOT as expected") != std::string::npos);
}

// Positions move half as far: the frequency is sqrt(1/2), so that p is zero at 4.4 and 8.9, a fall
// takes sqrt(2), and walls are met at t = 2, the end. What depends on the time alone stays.
TEST_CASE("a stepper that moves too slowly is seen where events are counted") {
    const Directory directory;
    const std::string edit = "[ -f main.cpp ] && sed -i"
                             " -e 's/x.q\\[k\\] + h \\* slope/x.q[k] + 0.5 * h * slope/' main.cpp";
    const Outcome result = shell(compiler(directory, edit) +
                                     "hvi-gen report --only time,json --methods stormer-verlet "
                                     "-o out",
                                 directory.path());
    INFO(result.err);
    CHECK(result.status == 1);
    const json time = checks_of(json::parse(contents(directory / "out/report.json")), "time");
    const auto agrees = [&](const std::string& scene, const std::string& words) {
        const json check = find(time, scene, words);
        INFO(check.dump());
        return check.at("agrees").get<bool>();
    };
    CHECK_FALSE(agrees("oscillator", "zero where the run begins"));
    CHECK_FALSE(agrees("oscillator", "a function that is no number"));
    CHECK_FALSE(agrees("ball", "infinitely many"));
    CHECK_FALSE(agrees("corner", "two walls"));
    CHECK(agrees("oscillator", "zero where the run ends"));
    CHECK(agrees("oscillator", "zero twice"));
    CHECK(agrees("oscillator", "steps backward"));
}

TEST_CASE("edges of one's own scene, in its report") {
    use_cache();
    const Directory directory;
    // The scenes have a force at the origin, a wall of infinite height at q = 0, and rest there.
    const std::string scene = "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                              "initial = {q = 1, p = 0}\nrun = {step = 0.1, until = 2}\n";
    write(directory / "pushed.toml", scene + "hamiltonian = \"p^2/2 + q^2/2 + q*cos(t)\"\n");
    write(directory / "wall.toml", scene + "hamiltonian = \"p^2/2 + a[1]*q^2/2 + a[2]/q\"\n"
                                           "parameters = {a = [1, 2]}\n");
    write(directory / "spring.toml", scene + "hamiltonian = \"p^2/2 + q^2/2 - cos(q)\"\n");
    const Outcome result =
        hvi_gen({"report", "pushed.toml", "wall.toml", "spring.toml", "--methods", "gauss:2",
                 "--only", "rejections,csv,json", "-o", "out"},
                directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const json report = json::parse(contents(directory / "out/report.json"));
    CHECK(report.at("scenes").empty());
    CHECK(report.at("edges").size() == 1);
    const json checks = checks_of(report, "rejections");
    const std::string origin = "all of the state 0";
    CHECK(find(checks, "pushed", origin).at("expected") ==
          "ok and finite, or a status and the state untouched");
    CHECK(find(checks, "wall", origin).at("expected") == "a status, the state untouched");
    CHECK(find(checks, "spring", origin).at("expected") == "ok, the state untouched");
    const std::string csv = contents(directory / "out/edges.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + std::ptrdiff_t(checks.size()));
    CHECK(std::filesystem::exists(directory / "out/report.csv") == false);
    CHECK(std::filesystem::exists(directory / "out/report.html") == false);
    bool compiled = false;
    for (const json& part : report.at("time_spent")) compiled |= part.at("on") == "compiling";
    CHECK_FALSE(compiled);  // nothing was measured
}

TEST_CASE("edges of a method that is none") {
    CHECK(hvi_gen({"report", "--edges", "--methods", "gauss:0"}).status == 2);
    CHECK(hvi_gen({"report", "--edges", "--methods", "gauss:2-yoshida:5"}).status == 2);
    CHECK(hvi_gen({"report", "--edges", "--methods", "radau-left:2-yoshida:4"}).status == 1);
    CHECK(hvi_gen({"report", "--edges", "no-such-scene"}).status == 2);
    CHECK(hvi_gen({"report", "--only", "work"}).status == 2);
    CHECK(hvi_gen({"report", "--only", "json"}).status == 2);
}
