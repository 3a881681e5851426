// `hvi-gen report`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;
using Json = nlohmann::json;

namespace {

Json report(const std::vector<std::string>& words, const Directory& directory) {
    std::vector<std::string> all{"report", "-o", "out"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome result = hvi_gen(all, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    return Json::parse(contents(directory / "out/report.json"));
}

/// The slope of log(error) over log(h), by least squares, where errors are neither large nor near
/// round-off.
double order_of(const Json& points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Json& point : points) {
        if (point["error"].is_null() || point["error"] > 1e-3 || point["error"] < 1e-11) continue;
        const double a = std::log(point["h"].get<double>());
        const double b = std::log(point["error"].get<double>());
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    REQUIRE(n >= 3);
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

TEST_CASE("errors against an exact solution") {
    use_cache();
    const Directory directory;
    const Json json =
        report({"harmonic-oscillator", "--methods", "gauss:2, stormer-verlet", "--steps",
                "1/10, 1/20, 1/40", "--until", "20", "--only", "json,work"},
               directory);
    CHECK(directory.names() == std::vector<std::string>{"out"});
    CHECK(json["schema"] == "hvi-report/1");
    CHECK(json["machine"]["threads"] >= 1);
    CHECK(!json["compiler"]["version"].get<std::string>().empty());
    REQUIRE(json["scenes"].size() == 1);
    const Json& scene = json["scenes"][0];
    CHECK(scene["name"] == "harmonic-oscillator");
    CHECK(scene["reference"] == Json{{"kind", "exact"}, {"error", 0.0}});
    REQUIRE(scene["methods"].size() == 2);
    const Json& gauss = scene["methods"][0];
    CHECK(gauss["name"] == "gauss:2");
    CHECK(gauss["order"] == 4);
    CHECK(gauss["peer"] == false);
    REQUIRE(gauss["points"].size() == 3);
    for (const Json& point : gauss["points"]) {
        const double h = point["h"], until = 20;
        CHECK(std::abs(h * point["steps"].get<double>() - until) < 1e-12);
        // The matrix (6.6) of the paper turns by the angle a with tan a = o/d: what is missing at
        // the end is a turn by N (h - a).
        const double d = std::pow(h, 4) - 60 * h * h + 144, o = 144 * h - 12 * std::pow(h, 3);
        const double turn = point["steps"].get<double>() * (h - std::atan2(o, d));
        CHECK(point["error"].get<double>() ==
              Approx(2 * std::abs(std::sin(turn / 2))).epsilon(1e-3));
        CHECK(point["energy_error"].get<double>() < 1e-14);
        CHECK(point["seconds"].get<double>() > 0);
        CHECK(point["spread"].get<double>() >= 0);
        CHECK(point["status"] == "ok");
    }
    CHECK(scene["methods"][1]["order"] == 2);
    const Json& verlet = scene["methods"][1]["points"];
    CHECK(verlet[1]["error"].get<double>() / verlet[2]["error"].get<double>() ==
          Approx(4).epsilon(0.01));
}

TEST_CASE("errors against a reference solution, with steps that are chosen") {
    use_cache();
    const Directory directory;
    const Json json =
        report({"kepler", "--methods", "gauss:2,gauss:3", "--until", "10"}, directory);
    const Json& scene = json["scenes"][0];
    CHECK(scene["reference"]["kind"] == "gauss:10 in 113 bits");
    CHECK(scene["reference"]["error"].get<double>() < 1e-17);
    const std::map<std::string, double> orders{{"gauss:2", 4}, {"gauss:3", 6}};
    for (const Json& method : scene["methods"]) {
        const Json& points = method["points"];
        CHECK(points.size() == 8);
        CHECK(points.front()["error"] > 1e-3);
        CHECK(points.back()["error"] < 1e-12);
        const double order = orders.at(method["name"]);
        CHECK(method["order"] == order);
        CHECK(order_of(points) == Approx(order).margin(0.4));
        for (const Json& point : points) {
            // Each sweep but the first evaluates every stage, and a new run begins with one more.
            const double stages = order / 2, steps = point["steps"];
            const double counted = point["evaluations"].get<double>() / steps;
            const double sweeps = point["iterations"].get<double>() - 1;
            CHECK(counted == Approx(stages * sweeps).epsilon(0.35));
        }
    }
    const std::vector<std::string> files{"kepler-1-time.svg",   "kepler-2-evaluations.svg",
                                         "kepler-3-energy.svg", "kepler-4-invariants.svg",
                                         "report.csv",          "report.html",
                                         "report.json",         "times.csv"};
    for (const std::string& file : files) CHECK(!contents(directory / ("out/" + file)).empty());
    const std::string csv = contents(directory / "out/report.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 2 * 8);
    // The edges are for those who ask for them.
    CHECK(json["edges"].empty());
    CHECK_FALSE(std::filesystem::exists(directory / "out/edges.csv"));
    double spent = 0;
    for (const Json& part : json["time_spent"]) spent += part["seconds"].get<double>();
    CHECK(spent > 0);
    const std::string html = contents(directory / "out/report.html");
    CHECK(html.find("<svg") != std::string::npos);
    CHECK(html.find("http-equiv") == std::string::npos);
    for (const char* outside : {"src=\"http", "href=\"http", "url(http", "@import"})
        CHECK(html.find(outside) == std::string::npos);
}

TEST_CASE("compositions are measured by the names that they are printed by") {
    use_cache();
    const Directory directory;
    const Json json = report(
        {"--steps", "1/2, 1/3, 1/5, 1/8, 1/12", "--until", "20", "--only", "json,work", "--methods",
         "stormer-verlet-blanes-moan:6, gauss:2-yoshida:6, stormer-verlet", "pendulum"},
        directory);
    const Json& methods = json["scenes"][0]["methods"];
    REQUIRE(methods.size() == 3);
    CHECK(methods[0]["name"] == "stormer-verlet-blanes-moan:6");
    CHECK(methods[1]["name"] == "gauss:2-yoshida:6");
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        CHECK(methods[i]["order"] == 6);
        CHECK(order_of(methods[i]["points"]) == Approx(6).margin(0.4));
    }
    CHECK(methods[2]["order"] == 2);
}

TEST_CASE("a point that fails has a status and no error") {
    use_cache();
    const Directory directory;
    const Json json = report({"nonseparable", "--methods", "midpoint", "--steps", "2,1/50",
                              "--until", "4", "--only", "json,html,csv,work"},
                             directory);
    const Json& points = json["scenes"][0]["methods"][0]["points"];
    REQUIRE(points.size() == 2);
    CHECK(points[0]["status"] != "ok");
    CHECK(points[0]["error"].is_null());
    CHECK(points[0]["seconds"].is_null());
    CHECK(points[1]["status"] == "ok");
}

TEST_CASE("reports that cannot be") {
    use_cache();
    const Directory directory;
    const auto status = [&](const std::vector<std::string>& words) {
        const Outcome result = hvi_gen(words, directory.path());
        CHECK(result.out.empty());
        CHECK(result.err.find("error: ") == 0);
        return result.status;
    };
    CHECK(status({"report"}) == 2);
    CHECK(status({"report", "no-such-scene"}) == 2);
    CHECK(status({"report", "kepler", "--methods", "gauss:65"}) == 2);
    CHECK(status({"report", "kepler", "--methods", "gauss:2,,gauss:3"}) == 2);
    CHECK(status({"report", "kepler", "--methods", ""}) == 2);
    CHECK(status({"report", "kepler", "--methods", "midpoint-yoshida"}) == 2);
    CHECK(status({"report", "kepler", "--methods", "gauss:16-kahan-li:8"}) == 2);
    CHECK(status({"report", "kepler", "--methods", "symplectic-euler-yoshida:4"}) == 1);
    CHECK(status({"report", "kepler", "--steps", "1/10,w"}) == 2);
    CHECK(status({"report", "kepler", "--steps", "0"}) == 1);
    CHECK(status({"report", "kepler", "--steps", "-1/10"}) == 1);
    CHECK(status({"report", "kepler", "--only", "pdf"}) == 2);
    CHECK(directory.names().empty());
}

TEST_CASE("what is there of a report is kept when a scene of it fails") {
    use_cache();
    const Directory directory;
    write(directory / "falls.toml", "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                    "hamiltonian = \"p^2/2 - q^4/4\"\ninitial = {q = 1, p = 1}\n"
                                    "run = {step = 0.1, until = 9}\n");
    const Outcome result = hvi_gen({"report", "harmonic-oscillator", "falls.toml", "--methods",
                                    "midpoint", "--only", "json,html,work", "--until", "9"},
                                   directory.path());
    CHECK(result.status == 1);
    CHECK(result.err.find("error: there is no reference solution") == 0);
    const Json json = Json::parse(contents(directory / "report/report.json"));
    CHECK(json["scenes"].size() == 1);
    CHECK(json["incomplete"].get<std::string>().find("falls") == 0);
    CHECK(contents(directory / "report/report.html").find("Incomplete") != std::string::npos);
}

TEST_CASE("numbers are kept where pictures cannot be drawn") {
    use_cache();
    const Directory directory;
    const std::string report = "hvi-gen report harmonic-oscillator --methods midpoint "
                               "--steps 1/10,1/20 --only work,json,csv,html";
    const Outcome result = shell("CXX=\"$(command -v c++)\"; export CXX; " + report +
                                     " -o first && PATH=/none && " + report + " -o second",
                                 directory.path());
    CHECK(result.status == 3);
    CHECK(result.err.find("gnuplot") != std::string::npos);
    for (const std::string kept : {"first/report.html", "second/report.json", "second/report.csv"})
        CHECK(std::filesystem::exists(directory / kept));
    CHECK_FALSE(std::filesystem::exists(directory / "second/report.html"));
}

TEST_CASE("METHOD stands before those of --methods, the general Galerkin form too") {
    use_cache();
    const Directory directory;
    const std::vector<std::string> simpson = {"--basis", "1, tau", "--nodes", "0, 1/2, 1"};
    std::vector<std::string> words = {
        "pendulum", "--methods", "gauss:2", "--steps",  "1/5, 1/10, 1/20, 1/40",
        "--until",  "5",         "--only",  "json,work"};
    words.insert(words.end(), simpson.begin(), simpson.end());
    const Json json = report(words, directory);
    const Json& methods = json["scenes"][0]["methods"];
    REQUIRE(methods.size() == 2);
    CHECK(methods[0]["name"] == "--basis \"1, tau\" --nodes \"0, 1/2, 1\"");
    CHECK(methods[0]["order"] == 4);
    CHECK(order_of(methods[0]["points"]) == Approx(4).margin(0.1));
    CHECK(methods[1]["name"] == "gauss:2");
    const Outcome alone = hvi_gen({"report", "pendulum", "--param", "w=1"}, directory.path());
    CHECK(alone.status == 2);
    CHECK(alone.err.find("none is given") != std::string::npos);
}
