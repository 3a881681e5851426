// `hvi-gen report` on scenes whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;
using Json = nlohmann::json;

namespace {

/// A hundred springs of the frequencies sqrt(i), from x = 1/i at rest.
const std::string hundred_springs = R"toml(coordinates = "x[1..N]"
momenta     = "p[1..N]"
hamiltonian = "sum(i=1..N, p[i]^2/2 + i*x[i]^2/2)"
[parameters]
N = 100
[invariants]
first = "p[1]^2/2 + x[1]^2/2"
[initial]
"x[i]" = "1/i"
"p[i]" = 0
[run]
method = "stormer-verlet"
step   = "1/50"
until  = 5
)toml";

const std::string solution = R"toml([exact]
"x[i]" = "cos(sqrt(i)*t)/i"
"p[i]" = "-sin(sqrt(i)*t)/sqrt(i)"
)toml";

Json report_on(const std::string& scene, const std::vector<std::string>& words) {
    use_cache();
    const Directory directory;
    write(directory / "springs.toml", scene);
    std::vector<std::string> all{"report", "springs.toml", "--unroll", "no", "-o", "out"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome result = hvi_gen(all, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    for (const char* file : {"report.html", "report.csv", "springs-1-time.svg",
                             "springs-2-evaluations.svg", "springs-3-energy.svg"})
        CHECK(contents(directory / "out" / file).empty() == (words.back() == "json"));
    return Json::parse(contents(directory / "out/report.json"));
}

/// Returns the error of `steps` steps of Stormer and Verlet's method. A spring turns by the angle a
/// a step, where sin(a/2) = h omega/2, on an ellipse whose momenta are smaller by cos(a/2).
double error_of_verlet(double until, int steps) {
    const double h = until / steps;
    double sum = 0, size = 0;
    for (int i = 1; i <= 100; ++i) {
        const double omega = std::sqrt(i), half = std::asin(h * omega / 2);
        const double x = std::cos(omega * until) / i, p = -std::sin(omega * until) / omega;
        const double dx = std::cos(2 * half * steps) / i - x;
        const double dp = -std::cos(half) * std::sin(2 * half * steps) / omega - p;
        sum += dx * dx + dp * dp;
        size += x * x + p * p;
    }
    return std::sqrt(sum / size);
}

void check_verlet(const Json& method) {
    CHECK(method["name"] == "stormer-verlet");
    CHECK(method["order"] == 2);
    REQUIRE(method["points"].size() == 3);
    for (const Json& point : method["points"]) {
        const int steps = point["steps"];
        CHECK(point["h"].get<double>() == Approx(5.0 / steps).epsilon(1e-15));
        CHECK(point["error"].get<double>() == Approx(error_of_verlet(5, steps)).epsilon(1e-9));
        CHECK(point["seconds"] > 0);
        CHECK(point["spread"] >= 0);
        CHECK(point["evaluations"] == steps + 1);
        CHECK(point["iterations"] == 0);
        CHECK(point["status"] == "ok");
        // Each spring has at most h^2 omega^2/8 times the energy too much, or too little.
        const double h = point["h"];
        CHECK(point["energy_error"] > 0);
        CHECK(point["energy_error"].get<double>() < h * h * 100 / 4);
    }
}

}  // namespace

TEST_CASE("errors on a large scene are those of the exact solution") {
    const Json json =
        report_on(hundred_springs + solution, {"--methods", "stormer-verlet", "--steps",
                                               "1/50, 1/100, 1/200", "--only", "json"});
    const Json& scene = json["scenes"][0];
    CHECK(scene["reference"] == Json{{"kind", "exact"}, {"error", 0.0}});
    check_verlet(scene["methods"][0]);
    CHECK(json["edges"].empty());
}

TEST_CASE("errors on a large scene against a reference, with all files") {
    const Json json = report_on(
        hundred_springs, {"--methods", "stormer-verlet, gauss:2", "--steps", "1/50, 1/100, 1/200"});
    const Json& scene = json["scenes"][0];
    CHECK(scene["reference"]["kind"] == "stormer-verlet-kahan-li:8 in 64 bits");
    CHECK(scene["reference"]["error"] < 1e-15);
    check_verlet(scene["methods"][0]);
    const Json& points = scene["methods"][1]["points"];
    CHECK(points[0]["error"].get<double>() / points[1]["error"].get<double>() ==
          Approx(16).epsilon(0.05));
    CHECK(points[2]["energy_error"] < 1e-13);
}

TEST_CASE("steps on a large scene are chosen from large errors to round-off") {
    const Json json =
        report_on(hundred_springs + solution, {"--methods", "gauss:3", "--only", "json"});
    const Json& points = json["scenes"][0]["methods"][0]["points"];
    CHECK(points.size() == 8);
    CHECK(points.back()["error"] < 1e-13);
    for (std::size_t k = 1; k < points.size(); ++k) CHECK(points[k]["h"] < points[k - 1]["h"]);
}

TEST_CASE("a large scene that is not separable has a reference too") {
    std::string scene = hundred_springs;
    scene.replace(scene.find("p[i]^2/2"), 8, "p[i]^2*(1 + x[i]^2)/2");
    const Json json = report_on(
        scene, {"--methods", "gauss:2", "--steps", "1/50, 1/100, 1/200", "--only", "json"});
    const Json& found = json["scenes"][0];
    CHECK(found["reference"]["kind"] == "gauss:6 in 64 bits");
    CHECK(found["reference"]["error"] < 1e-15);
    const Json& points = found["methods"][0]["points"];
    for (std::size_t k = 1; k < 3; ++k)
        CHECK(points[k - 1]["error"].get<double>() / points[k]["error"].get<double>() ==
              Approx(16).epsilon(0.1));
}
