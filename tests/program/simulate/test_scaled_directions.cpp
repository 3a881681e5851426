// Directions along runs in scaled time, against closed forms in time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A scene of one degree of freedom.
std::string scaled_scene(const std::string& H, const std::string& start, const std::string& scale,
                         const std::string& more = "") {
    return "hamiltonian = \"" + H + "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\ninitial = {" +
           start +
           "}\nrun = {method = \"gauss:12\", step = \"1/20\", until = 1}\n[time]\nscale = \"" +
           scale + "\"\n" + more;
}

void check_matrix(const SceneRun& run, const std::vector<std::vector<double>>& expected,
                  double tolerance) {
    INFO(run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    REQUIRE(run.tangent.size() == expected.size());
    for (std::size_t row = 0; row < expected.size(); ++row) {
        REQUIRE(run.tangent[row].size() == expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            CAPTURE(row, k, run.tangent[row][k], expected[row][k]);
            CHECK(std::abs(run.tangent[row][k] - expected[row][k]) < tolerance);
        }
    }
}

/// A planet of the semi-axis 1 at its perihelion.
std::string planet_of(double eccentricity, const std::string& more) {
    const std::string e = std::to_string(eccentricity);
    return "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\n"
           "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {ecc = \"" +
           e +
           "\"}\ninitial = {x = \"1-ecc\", y = 0, px = 0, py = \"sqrt((1+ecc)/(1-ecc))\"}\n"
           "run = {method = \"gauss:12\", step = \"1/20\", until = \"2*pi\"}\n" +
           more;
}

/// The derivative of a revolution, as neighbours have periods 2 pi (-2 H)^(-3/2): I - 6 pi f dH^T.
std::vector<std::vector<double>> revolution_of(double eccentricity) {
    const double x = 1 - eccentricity, v = std::sqrt((1 + eccentricity) / (1 - eccentricity));
    const std::vector<double> f{0, v, -1 / (x * x), 0}, slope{1 / (x * x), 0, 0, v};
    std::vector<std::vector<double>> D(4, std::vector<double>(4));
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            D[i][k] = (i == k ? 1.0 : 0.0) - 6 * pi * f[i] * slope[k];
    return D;
}

}  // namespace

TEST_CASE("the derivative at a time is that of the oscillator, whatever its steps are of") {
    const double c = std::cos(1), s = std::sin(1);
    for (const std::string scale : {"1 + q^2", "1/(2 + p + sin(t))", "arclength"})
        for (const std::string how : {"--tangent", "--tangent --interpret"}) {
            CAPTURE(scale, how);
            const SceneRun run =
                run_scene(scaled_scene("(p^2 + q^2)/2", "q = \"3/5\", p = \"4/5\"", scale), how);
            check_matrix(run, {{c, s}, {-s, c}}, 1e-12);
        }
}

TEST_CASE("the derivative in scaled time where H depends on the time") {
    // q'' = 2 q/(1 + t)^2 has the solutions (1 + t)^2 and 1/(1 + t).
    const SceneRun run = run_scene(
        scaled_scene("p^2/2 - q^2/(1 + t)^2", "q = 1, p = \"1/2\"", "1 + q^2 + t*p"), "--tangent");
    check_matrix(run, {{5.0 / 3, 7.0 / 6}, {7.0 / 6, 17.0 / 12}}, 1e-11);
}

TEST_CASE("the derivative of a revolution around the sun") {
    const std::vector<std::vector<double>> D = revolution_of(0.5);
    for (const std::string scale : {"distance", "potential", "logarithmic"}) {
        CAPTURE(scale);
        const std::string scene = planet_of(0.5, "[time]\nscale = \"" + scale + "\"\n");
        check_matrix(run_scene(scene, "--tangent"), D, 1e-8);
    }
    // A Lagrangian, whose momenta are velocities here.
    std::string lagrangian = planet_of(0.5, "[time]\nscale = \"distance\"\n");
    const auto put = [&](const std::string& before, const std::string& after) {
        lagrangian.replace(lagrangian.find(before), before.size(), after);
    };
    put("hamiltonian = \"(px^2 + py^2)/2 - ", "lagrangian = \"(vx^2 + vy^2)/2 + ");
    put("momenta = [\"px\", \"py\"]", "velocities = [\"vx\", \"vy\"]");
    put("px = 0, py", "vx = 0, vy");
    check_matrix(run_scene(lagrangian, "--tangent"), D, 1e-8);
    // Explicit steps, whose order is 8.
    check_matrix(run_scene(planet_of(0.5, "[time]\nscale = \"logarithmic\"\n"),
                           "--tangent --method stormer-verlet --compose kahan-li:8 --step 1/40"),
                 D, 1e-7);
}

TEST_CASE("derivatives at an event in scaled time are those in time") {
    // A fall from 4 with the velocity 3, for which test_section.cpp has the closed form.
    const std::string end = "[events.end]\nzero = \"q + ZERO\"\ndirection = \"down\"\nstop = 1\n";
    const auto rows_of = [&](const std::string& zero) {
        std::string event = end;
        event.replace(event.find("ZERO"), 4, zero);
        const SceneRun run =
            run_scene(scaled_scene("p^2/2 + 2*q", "q = 4, p = 3", "1/(1 + p^2)", event),
                      "--tangent --until 10");
        INFO(run.outcome.err);
        REQUIRE(run.section.size() == 4);
        // The matrix is that of the time of the event.
        REQUIRE(run.tangent.size() == 2);
        CHECK(std::abs(run.tangent[0][1] - run.last()[0]) < 1e-11);
        std::vector<std::vector<double>> rows;
        for (std::size_t k = 1; k < 4; ++k)
            rows.push_back(numbers_of(run.section[k].substr(run.section[k].find(',') + 1)));
        CHECK((run.outcome.out.find("return map") != std::string::npos) == (zero == "0"));
        return rows;
    };
    const std::vector<std::vector<double>> still{{0.2, 0.8}, {0, 0}, {-0.4, -0.6}},
        rows = rows_of("0");
    // q = t^2 - 8: from q + p t - t^2 = t^2 - 8 there is t* = (p + sqrt(p^2 + 8 q + 64))/4.
    const double root = std::sqrt(105), t = (3 + root) / 4, by_q = 1 / root,
                 by_p = (1 + 3 / root) / 4;
    const std::vector<std::vector<double>> moving{
        {by_q, by_p}, {2 * t * by_q, 2 * t * by_p}, {-2 * by_q, 1 - 2 * by_p}},
        rows_of_moving = rows_of("8 - t^2");
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 2; ++k) {
            CAPTURE(i, k);
            CHECK(std::abs(rows[i][k] - still[i][k]) < 1e-11);
            CHECK(std::abs(rows_of_moving[i][k] - moving[i][k]) < 1e-11);
        }
}

TEST_CASE("neighbours that stay, and that part, in scaled time") {
    // Neighbours of an oscillator stay where they are at one time.
    const SceneRun stays = run_scene(scaled_scene("(p^2 + q^2)/2", "q = 1, p = 0", "1/(1 + 3*q^2)"),
                                     "--lyapunov --megno --sali --until 20");
    INFO(stays.outcome.err);
    REQUIRE(stays.outcome.status == 0);
    CHECK(std::abs(stays.said("lyapunov").at(0)) < 1e-9);
    CHECK(std::abs(stays.said("megno").at(0)) < 1e-8);
    CHECK(stays.said("sali").at(0) > 0.01);
    // x swings, and y is on the top of a hill.
    const SceneRun hill = run_scene("hamiltonian = \"(px^2 + x^2 + py^2 - y^2)/2\"\n"
                                    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                                    "initial = {x = 1, y = 0, px = 0, py = 0}\n"
                                    "run = {method = \"gauss:8\", step = \"1/20\", until = 40}\n"
                                    "[time]\nscale = \"1/(1 + 3*x^2)\"\n",
                                    "--lyapunov=spectrum");
    const std::vector<double> all = hill.said("lyapunov");
    REQUIRE(all.size() == 4);
    CHECK(std::abs(all[0] - 1) < 0.02);
    CHECK(std::abs(all[1]) < 0.02);
    CHECK(std::abs(all[2]) < 0.02);
    CHECK(std::abs(all[3] + 1) < 0.02);
}

TEST_CASE("directions in scaled time that are not built are refused with their place") {
    const auto refused = [](const std::string& scene, const std::string& words,
                            const std::string& what) {
        const SceneRun run = run_scene(scene, words);
        CAPTURE(run.outcome.err);
        CHECK(run.outcome.status == 2);
        CHECK(run.outcome.err.find(what) != std::string::npos);
        CHECK(run.outcome.err.find("scale = ") != std::string::npos);
    };
    const std::string springs =
        "hamiltonian = \"sum(i=1..N, p[i]^2/2 + q[i]^2/2)\"\ncoordinates = [\"q[1..N]\"]\n"
        "momenta = [\"p[1..N]\"]\nparameters = {N = 3}\n"
        "initial = {\"q[i]\" = 1, \"p[i]\" = 0}\n"
        "run = {method = \"gauss:4\", step = \"1/10\", until = 1}\n"
        "[time]\nscale = \"1 + q[1]^2\"\n";
    refused(springs, "--tangent --unroll no",
            "--tangent is not built for a scale of the time where sums stay loops");
    refused(springs, "--megno --unroll no", "--megno is not built for a scale of the time where");
}
