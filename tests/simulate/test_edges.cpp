// `hvi-gen report --edges`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdlib>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace hvi::test;
using nlohmann::json;

namespace {

/// A compiler that takes less time, of programs that take a little more; `edit` is a line of shell
/// before it.
std::string compiler(const Directory& directory, const std::string& edit) {
    write(directory / "cxx", "#!/bin/sh\n" + edit + "\nexec c++ \"$@\" -O1\n");
    std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
    return "CXX=./cxx XDG_CACHE_HOME=" + (directory / "cache").string() + " ";
}

json checks_of(const json& report, const std::string& chapter) {
    for (const json& each : report.at("chapters"))
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
    const json report = json::parse(contents(directory / "out/edges.json"));
    CHECK(report.at("schema") == "hvi-edges/1");

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
    CHECK(checks_of(report, "long").size() == 3);
    CHECK(checks_of(report, "symplecticity").size() == 10);

    const std::string page = contents(directory / "out/edges.html");
    CHECK(page.find("cases are as expected") != std::string::npos);
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("src=") == std::string::npos);
}

TEST_CASE("a stepper that is wrong is seen to be wrong, in each chapter") {
    const Directory directory;
    // It takes what is not finite, drifts a little far, and loses momentum.
    const std::string edit = "[ -f stepper.hpp ] && sed -i"
                             " -e 's/!hvi::detail::finite(q_, end)/false/'"
                             " -e 's/+ h \\* slope\\[k\\]/+ h * Scalar(1.00001) * slope[k]/'"
                             " -e 's/x.p\\[k\\] = \\(.*\\);/x.p[k] = (\\1) * Scalar(1 - 1e-10);/'"
                             " stepper.hpp";
    const Outcome result =
        shell(compiler(directory, edit) + "hvi-gen report --edges --methods stormer-verlet -o out",
              directory.path());
    INFO(result.err);
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK(result.err.find("error: stormer-verlet on pendulum, ") != std::string::npos);
    CHECK(result.err.find("cases are not as expected: see out") != std::string::npos);
    const json report = json::parse(contents(directory / "out/edges.json"));
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
    CHECK_FALSE(agrees("long", "harmonic-oscillator", "8 runs"));
    CHECK_FALSE(agrees("long", "kepler", "8 runs"));
    // NOTE: where H is not separable the stepper has other lines.
    for (const json& check : checks_of(report, "symplecticity"))
        CHECK(check.at("agrees") == (check.at("scene") == "nonseparable"));
    CHECK(contents(directory / "out/edges.html").find("NOT as expected") != std::string::npos);
}

TEST_CASE("edges of a method that is none") {
    CHECK(hvi_gen({"report", "--edges", "--methods", "gauss:0"}).status == 2);
    CHECK(hvi_gen({"report", "--edges", "no-such-scene"}).status == 2);
}
