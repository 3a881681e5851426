// Directions along steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A star in a galaxy as a rotation and what disturbs it; the start is moved by parameters.
const std::string split_star =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
    "initial = {x = \"a\", y = \"1/10 + b\", px = \"1/2 + c\", py = \"d\"}\n"
    "run = {method = \"strang\", step = \"1/4\", until = 10}\n";

/// Returns the derivatives of the end by a parameter, from 0 on.
std::vector<double> by_parameter(const SceneRun& run, std::size_t k) {
    const std::string& line = run.sensitivity.at(k + 1);
    return numbers_of(line.substr(line.find(',') + 1));
}

}  // namespace

TEST_CASE("the tangent of a turning flow is its rotation") {
    const SceneRun run = run_scene("hamiltonian = \"2*q^2 + p^2/2\"\ncoordinates = "
                                   "[\"q\"]\nmomenta = [\"p\"]\ninitial = {q = 1, p = 0}\n"
                                   "run = {method = \"strang\", step = \"1/4\", until = 5}\n",
                                   "--split auto --tangent");
    REQUIRE(run.tangent.size() == 2);
    CHECK(run.tangent[0][0] == Approx(std::cos(10.0)).margin(1e-14));
    CHECK(run.tangent[0][1] == Approx(std::sin(10.0) / 2).margin(1e-14));
    CHECK(run.tangent[1][0] == Approx(-2 * std::sin(10.0)).margin(1e-14));
    CHECK(run.tangent[1][1] == Approx(std::cos(10.0)).margin(1e-14));
}

TEST_CASE("the tangent of a splitting is that of its steps") {
    const auto end = [](const std::string& words) {
        const std::vector<double> last = run_scene(split_star, "--split auto " + words).last();
        return std::vector<double>(last.begin() + 1, last.begin() + 5);
    };
    const SceneRun along = run_scene(split_star, "--split auto --tangent");
    REQUIRE(along.tangent.size() == 4);
    const std::vector<std::string> names{"a", "b", "c", "d"};
    for (std::size_t column = 0; column < 4; ++column) {
        const auto ahead = end("--param " + names[column] + "=1e-6"),
                   behind = end("--param " + names[column] + "=-1e-6");
        for (std::size_t row = 0; row < 4; ++row) {
            CAPTURE(row, column);
            CHECK(std::abs(along.tangent[row][column] - (ahead[row] - behind[row]) / 2e-6) < 1e-8);
        }
    }
}

TEST_CASE("derivatives of a flow by parameters are those of its solution") {
    // NOTE: q = cos(w t), and by k = w^2 its derivative is -t sin(w t)/(2 w); p = -w sin(w t). With
    // the start at b, the derivatives by that are cos(w t) and -w sin(w t).
    const std::string spring_scene = "hamiltonian = \"(p^2 + k*q^2)/2\"\ncoordinates = [\"q\"]\n"
                                     "momenta = [\"p\"]\nparameters = {k = 4, b = 1}\n"
                                     "initial = {q = \"b\", p = 0}\n"
                                     "run = {method = \"strang\", step = \"1/4\", until = 5}\n";
    const SceneRun run = run_scene(spring_scene, "--split auto --sensitivity k,b");
    REQUIRE(run.sensitivity.size() == 3);
    const std::vector<double> by_spring = by_parameter(run, 0), by_start = by_parameter(run, 1);
    CHECK(by_spring[0] == Approx(-5 * std::sin(10.0) / 4).epsilon(1e-13));
    CHECK(by_spring[1] == Approx(-(std::sin(10.0) + 10 * std::cos(10.0)) / 4).epsilon(1e-13));
    CHECK(by_start[0] == Approx(std::cos(10.0)).epsilon(1e-13));
    CHECK(by_start[1] == Approx(-2 * std::sin(10.0)).epsilon(1e-13));
    // NOTE: without a spring, by the limits: q'' = -k q from q = 1 has dq/dk = -t^2/2.
    const SceneRun free = run_scene(spring_scene, "--split auto --sensitivity k --param k=0");
    REQUIRE(free.sensitivity.size() == 2);
    const std::vector<double> by_k = by_parameter(free, 0);
    CHECK(by_k[0] == Approx(-12.5).epsilon(1e-13));
    CHECK(by_k[1] == Approx(-5).epsilon(1e-13));
}

TEST_CASE("derivatives of a flow by parameters where H depends on the time") {
    // NOTE: q'' = -k q + f cos(w t) is linear in f, with the derivative (cos w t - cos(sqrt(k) t))/
    // (k - w^2) by it, for a start that does not depend on f.
    const SceneRun run = run_scene("hamiltonian = \"(p^2 + 2*q^2)/2 - f*q*cos(3*t)\"\n"
                                   "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                   "parameters = {f = 1}\ninitial = {q = 1, p = 0}\n"
                                   "run = {method = \"strang\", step = \"1/16\", until = 5}\n",
                                   "--split auto --compose kahan-li:8 --sensitivity f");
    REQUIRE(run.sensitivity.size() == 2);
    const std::vector<double> by_f = by_parameter(run, 0);
    const double root = std::sqrt(2.0);
    CHECK(by_f[0] == Approx((std::cos(root * 5) - std::cos(15.0)) / 7).epsilon(1e-10));
    CHECK(by_f[1] == Approx((3 * std::sin(15.0) - root * std::sin(root * 5)) / 7).epsilon(1e-10));
}

TEST_CASE("derivatives of flows by parameters are refused where they are not known") {
    const std::string spring_scene = "hamiltonian = \"(p^2 + k*q^2)/2\"\ncoordinates = [\"q\"]\n"
                                     "momenta = [\"p\"]\nparameters = {k = 0}\n"
                                     "initial = {q = \"sqrt(k)\", p = 0}\n"
                                     "run = {method = \"strang\", step = \"1/4\", until = 1}\n";
    const SceneRun start = run_scene(spring_scene, "--split auto --sensitivity k");
    CHECK(start.outcome.status == 2);
    CHECK(start.outcome.err.find("error: the derivative of these initial values is not known\n"
                                 "  --sensitivity: k\n"
                                 "                 ^\n") == 0);
    const SceneRun body =
        run_words("free-rigid-body --method strang --until 1 --sensitivity 'inertia[1]'");
    CHECK(body.outcome.status == 2);
    CHECK(body.outcome.err.find("error: --sensitivity is not built for scenes with rotations\n") ==
          0);
}

TEST_CASE("derivatives of flows by parameters are those of their steps") {
    // A trap without its magnetic field, whose matrix is 0 where b stands; orbits by their mass.
    const std::string trap =
        "hamiltonian = \"((px + b*y/2)^2 + (py - b*x/2)^2)/2 + k*(x^2 + y^2)/2 + c*x^4\"\n"
        "split = {A = \"((px + b*y/2)^2 + (py - b*x/2)^2)/2 + k*(x^2 + y^2)/2\", B = \"c*x^4\"}\n"
        "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
        "parameters = {b = 0, k = 1, c = 0.01}\n"
        "initial = {x = 1, y = 0.5, px = 0.1, py = \"1 + b/2 + k\"}\n"
        "run = {method = \"strang\", step = \"1/10\", until = 2}\n";
    const std::string orbit =
        "hamiltonian = \"(px^2 + py^2)/2 - b/sqrt(x^2 + y^2) + k*x^2\"\n"
        "split = {A = \"(px^2 + py^2)/2 - b/sqrt(x^2 + y^2)\", B = \"k*x^2\"}\n"
        "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
        "parameters = {b = 1, k = 0.1}\n"
        "initial = {x = 1, y = 0, px = 0, py = \"6/5*sqrt(b)\"}\n"
        "run = {method = \"strang\", step = \"1/10\", until = 2}\n";
    const auto check = [](const std::string& scene, double b, double k) {
        const SceneRun run = run_scene(scene, "--sensitivity b,k");
        REQUIRE(run.sensitivity.size() == 3);
        const std::vector<std::string> names{"b", "k"};
        const std::vector<double> values{b, k};
        for (std::size_t j = 0; j < 2; ++j) {
            const auto end = [&](double by) {
                return run_scene(scene,
                                 "--param " + names[j] + "=" + std::to_string(values[j] + by))
                    .last();
            };
            // NOTE: differences of order 4.
            const std::vector<double> p = end(1e-3), m = end(-1e-3), pp = end(2e-3),
                                      mm = end(-2e-3);
            const std::vector<double> found = by_parameter(run, j);
            REQUIRE(found.size() == 4);
            for (std::size_t i = 0; i < 4; ++i) {
                CAPTURE(j, i);
                const double expected = (8 * (p[i + 1] - m[i + 1]) - pp[i + 1] + mm[i + 1]) / 12e-3;
                CHECK(std::abs(found[i] - expected) < 1e-9);
            }
        }
    };
    check(trap, 0, 1);
    check(orbit, 1, 0.1);
}

TEST_CASE("the tangent of orbits is that of their places, for every eccentricity") {
    // NOTE: the third is a parabola, and the last one goes on for periods in a step.
    for (const std::string start : {"0.8", "1.2", "sqrt(199/100)", "1.7", "0.1", "1.05, far"}) {
        const std::string speed = start.substr(0, start.find(','));
        const std::string step = start.find(',') == std::string::npos ? "1/2" : "15";
        // NOTE: of parameters alone, so that one program is built for all.
        const auto run = [&](const std::string& words) {
            return run_scene(
                "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\n"
                "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                "parameters = {a = 0, b = 0, c = 0, d = 0, v = 1}\n"
                "initial = {x = \"1 + a\", y = \"b\", px = \"1/10 + c\", py = \"v + d\"}\n"
                "run = {method = \"strang\", step = \"1/2\", until = 30}\n",
                "--split auto --step " + step + " --param 'v=" + speed + "' " + words);
        };
        const SceneRun along = run("--tangent");
        REQUIRE(along.tangent.size() == 4);
        const std::vector<std::string> names{"a", "b", "c", "d"};
        for (std::size_t column = 0; column < 4; ++column) {
            const auto end = [&](const std::string& by) {
                return run("--param " + names[column] + "=" + by).last();
            };
            // NOTE: differences of order 4.
            const std::vector<double> p = end("1e-4"), m = end("-1e-4"), pp = end("2e-4"),
                                      mm = end("-2e-4");
            for (std::size_t row = 0; row < 4; ++row) {
                CAPTURE(start, row, column);
                const std::size_t k = row + 1;
                const double expected = (8 * (p[k] - m[k]) - (pp[k] - mm[k])) / 12e-4;
                const double tolerance = 1e-5 * (1 + std::abs(expected));
                CHECK(std::abs(along.tangent[row][column] - expected) < tolerance);
            }
        }
    }
}

TEST_CASE("the tangent of planets is canonical") {
    const SceneRun run = run_words("outer-solar-system --split jacobi --method mclachlan:8.4 "
                                   "--step 200 --until 20000 --tangent");
    REQUIRE(run.tangent.size() == 36);
    CHECK(run.outcome.out.find("D^T J D - J is ") != std::string::npos);
    const std::string text = run.outcome.out.substr(run.outcome.out.find("D - J is ") + 9);
    CHECK(std::stod(text) < 1e-12);
}

TEST_CASE("the tangent of a free symmetric body is that of its motion") {
    const auto run = [](const std::string& words) {
        return run_words("lagrange-top --step 1/20 --until 5 --tangent " + words);
    };
    const SceneRun flows = run("--method strang --compose kahan-li:8"),
                   charts = run("--method gauss:8");
    REQUIRE(flows.tangent.size() == 6);
    REQUIRE(charts.tangent.size() == 6);
    const std::string text = flows.outcome.out.substr(flows.outcome.out.find("D - J is ") + 9);
    CHECK(std::stod(text) < 1e-14);
    for (std::size_t row = 0; row < 6; ++row) {
        for (std::size_t column = 0; column < 6; ++column) {
            CAPTURE(row, column);
            CHECK(std::abs(flows.tangent[row][column] - charts.tangent[row][column]) < 1e-10);
        }
    }
}

TEST_CASE("Lyapunov exponents go along with flows") {
    const SceneRun flows = run_scene(split_star, "--split auto --lyapunov --until 100");
    const SceneRun kicks = run_scene(split_star, "--method gauss:8 --lyapunov --until 100");
    REQUIRE(flows.said("lyapunov").size() == 1);
    CHECK(flows.said("lyapunov")[0] == Approx(kicks.said("lyapunov").at(0)).margin(2e-3));
}
