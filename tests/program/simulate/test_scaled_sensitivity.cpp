// Derivatives by parameters of runs in scaled time, against closed forms and differences.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

std::string in_scaled_time(const std::string& scene, const std::string& scale) {
    return scene + "[time]\nscale = \"" + scale + "\"\n";
}

/// The derivatives by the parameters, in the order of the table.
NumberRows derivatives_in(const SceneRun& run) {
    NumberRows result;
    for (std::size_t k = 1; k < run.sensitivity.size(); ++k) {
        const std::string& line = run.sensitivity[k];
        result.push_back(numbers_of(line.substr(line.find(',') + 1)));
    }
    return result;
}

void check_derivatives(const SceneRun& run, const NumberRows& expected, double tolerance) {
    INFO(run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    check_rows(derivatives_in(run), expected, tolerance);
}

/// The parameter k stands in scales alone.
const std::string parameter_spring =
    "hamiltonian = \"p^2/2 + w^2*q^2/2\"\ncoordinates = [\"q\"]\n"
    "momenta = [\"p\"]\nparameters = {w = \"3/2\", a = 2, k = \"1/3\"}\n"
    "initial = {q = \"a^2\", p = 0}\n"
    "run = {method = \"gauss:12\", step = \"1/50\", until = 1}\n";

/// A planet of the semi-axis 1 at its perihelion, around a star of the mass mu.
const std::string parameter_planet =
    "hamiltonian = \"(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "parameters = {mu = 1, ecc = \"1/2\"}\n"
    "initial = {x = \"1-ecc\", y = 0, px = 0, py = \"sqrt(mu*(1+ecc)/(1-ecc))\"}\n"
    "run = {method = \"gauss:12\", step = \"1/20\", until = \"2*pi\"}\n";

}  // namespace

TEST_CASE("derivatives by parameters at a time are those of the oscillator, whatever its steps") {
    // q = a^2 cos(w t), p = -a^2 w sin(w t)
    const double w = 1.5, a = 2, c = std::cos(w), s = std::sin(w);
    const NumberRows expected{
        {-a * a * s, -a * a * (s + w * c)}, {2 * a * c, -2 * a * w * s}, {0, 0}};
    const auto found = [](const std::string& scale, const std::string& how) {
        return run_scene(in_scaled_time(parameter_spring, scale), "--sensitivity " + how);
    };
    check_derivatives(found("1/(k + w*q^2)", "'w, a, k'"), expected, 1e-11);
    check_derivatives(found("1/(k + w*q^2)", "'w, a, k' --interpret"), expected, 1e-11);
    check_derivatives(found("(2 + k*sin(p + t))/a", "'w, a, k' --interpret"), expected, 1e-11);
    check_derivatives(found("arclength", "'w, a' --interpret"), {expected[0], expected[1]}, 1e-11);
}

TEST_CASE("derivatives by parameters in scaled time where H depends on the time") {
    const std::string driven =
        "hamiltonian = \"p^2/2 + w^2*q^2/2 - F*q*cos(t)\"\ncoordinates = [\"q\"]\n"
        "momenta = [\"p\"]\nparameters = {w = 2, F = \"1/2\"}\ninitial = {q = 1, p = 0}\n"
        "run = {method = \"gauss:12\", step = \"1/20\", until = 3}\n";
    // q = cos(w t) + F/(w^2 - 1) (cos(t) - cos(w t))
    const double w = 2, F = 0.5, t = 3, d = w * w - 1, c = std::cos(w * t), s = std::sin(w * t);
    const double beat = std::cos(t) - c, of_beat = -std::sin(t) + w * s;
    const std::vector<double> by_w{-t * s + F * (t * s / d - 2 * w * beat / (d * d)),
                                   -s - w * t * c +
                                       F * ((s + w * t * c) / d - 2 * w * of_beat / (d * d))},
        by_F{beat / d, of_beat / d};
    check_derivatives(run_scene(in_scaled_time(driven, "1/(1 + q^2 + F*sin(t)^2)"),
                                "--sensitivity 'w, F' --interpret"),
                      {by_w, by_F}, 1e-11);
}

TEST_CASE("derivatives by the mass of a star and the eccentricity, after a revolution") {
    // A mass mu makes all faster by sqrt(mu), and the period does not depend on ecc.
    const double e = 0.5, x = 1 - e, v = std::sqrt((1 + e) / (1 - e));
    const NumberRows expected{{0, pi * v, -pi / (x * x), v / 2}, {-1, 0, 0, 1 / (x * x * v)}};
    const std::string names = "--sensitivity 'mu, ecc' --interpret";
    for (const std::string scale : {"distance", "potential", "logarithmic"}) {
        CAPTURE(scale);
        check_derivatives(run_scene(in_scaled_time(parameter_planet, scale), names), expected,
                          1e-8);
    }
    // A Lagrangian, whose momenta are velocities here.
    std::string lagrangian = in_scaled_time(parameter_planet, "distance");
    const auto put = [&](const std::string& before, const std::string& after) {
        lagrangian.replace(lagrangian.find(before), before.size(), after);
    };
    put("hamiltonian = \"(px^2 + py^2)/2 - ", "lagrangian = \"(vx^2 + vy^2)/2 + ");
    put("momenta = [\"px\", \"py\"]", "velocities = [\"vx\", \"vy\"]");
    put("px = 0, py", "vx = 0, vy");
    check_derivatives(run_scene(lagrangian, names), expected, 1e-8);
    // Explicit steps, whose order is 8.
    check_derivatives(
        run_scene(
            in_scaled_time(parameter_planet, "logarithmic"),
            "--sensitivity 'mu, ecc' --method stormer-verlet --compose kahan-li:8 --step 1/40"),
        expected, 1e-7);
}

TEST_CASE("derivatives by parameters in scaled time are those of runs with other values") {
    const std::string star =
        "hamiltonian = \"(px^2 + py^2)/2 + mu*(x^2 + y^2)/2 + mu^2*(x^2*y - y^3/3) + x*py*mu/5\"\n"
        "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {mu = 1}\n"
        "initial = {x = \"mu/10\", y = \"1/5\", px = \"mu^2/3\", py = \"1/4\"}\n"
        "run = {method = \"gauss:8\", step = \"1/20\", until = 5}\n";
    const std::string scene = in_scaled_time(star, "1/(1 + mu*x^2 + y^2)");
    const SceneRun found = run_scene(scene, "--sensitivity mu --interpret");
    const auto difference = [&](const std::string& above, const std::string& below, double by) {
        const std::vector<double> up = run_scene(scene, "--interpret --param mu=" + above).last(),
                                  down = run_scene(scene, "--interpret --param mu=" + below).last();
        std::vector<double> result;
        for (std::size_t k = 1; k < 5; ++k) result.push_back((up.at(k) - down.at(k)) / (2 * by));
        return result;
    };
    const std::vector<double> near = difference("1.001", "0.999", 1e-3),
                              far = difference("1.002", "0.998", 2e-3);
    std::vector<double> extrapolated;
    for (std::size_t k = 0; k < 4; ++k) extrapolated.push_back((4 * near[k] - far[k]) / 3);
    check_derivatives(found, {extrapolated}, 1e-8);
    // In plain time, too.
    check_derivatives(found, derivatives_in(run_scene(star, "--sensitivity mu --interpret")),
                      1e-10);
}

TEST_CASE("derivatives by parameters at the time of an event that ends a run in scaled time") {
    const std::string fall = "hamiltonian = \"p^2/2 + g*q\"\ncoordinates = [\"q\"]\n"
                             "momenta = [\"p\"]\nparameters = {g = 2, v = 3}\n"
                             "initial = {q = 4, p = \"v\"}\n"
                             "run = {method = \"gauss:4\", step = \"1/20\", until = 10}\n";
    const std::string ground = "[events.ground]\nzero = \"q\"\ndirection = \"down\"\nstop = 1\n";
    // q = 4 + 3 t - t^2 = 0 at t = 4.
    check_derivatives(
        run_scene(in_scaled_time(fall, "1/(1 + g*p^2)") + ground, "--sensitivity 'g, v' --tangent"),
        {{-8, -4}, {4, 1}}, 1e-11);
}

TEST_CASE("derivatives by parameters are not built for scaled time where sums stay loops") {
    const std::string springs =
        "hamiltonian = \"sum(i=1..N, p[i]^2/2 + a*q[i]^2/2)\"\ncoordinates = [\"q[1..N]\"]\n"
        "momenta = [\"p[1..N]\"]\nparameters = {N = 2, a = 1}\n"
        "initial = {\"q[i]\" = 1, \"p[i]\" = 0}\n"
        "run = {method = \"gauss:12\", step = \"1/20\", until = 1}\n"
        "[time]\nscale = \"1 + q[1]^2\"\n";
    const double c = std::cos(1), s = std::sin(1), by_q = -s / 2, by_p = -(s + c) / 2;
    check_derivatives(run_scene(springs, "--sensitivity a --interpret"), {{by_q, by_q, by_p, by_p}},
                      1e-11);
    const SceneRun refused = run_scene(springs, "--sensitivity a --unroll no");
    CAPTURE(refused.outcome.err);
    CHECK(refused.outcome.status == 2);
    CHECK(refused.outcome.err.find("--sensitivity is not built for a scale of the time where sums "
                                   "stay loops") != std::string::npos);
    CHECK(refused.outcome.err.find("scale = ") != std::string::npos);
    CHECK(refused.outcome.err.find("--unroll yes") != std::string::npos);
}
