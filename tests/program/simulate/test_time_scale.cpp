// Steps of scaled time, against Kepler's equation and closed forms.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// Checks that a run ends with this status and says why.
void check_refused(const SceneRun& run, int status, const std::string& reason) {
    CAPTURE(run.outcome.err);
    CHECK(run.outcome.status == status);
    CHECK(run.outcome.err.find(reason) != std::string::npos);
}

/// A planet that begins at its perihelion on an ellipse of semi-axis 1.
std::string planet(const std::string& eccentricity, const std::string& more) {
    return "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\n"
           "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
           "parameters = {ecc = \"" +
           eccentricity +
           "\"}\ninitial = {x = \"1-ecc\", y = 0, px = 0, py = \"sqrt((1+ecc)/(1-ecc))\"}\n"
           "run = {method = \"stormer-verlet\", step = \"2*pi/50\", until = \"2*pi\"}\n" +
           more;
}

/// The distance of the Runge-Lenz vector, which is e along x, from (ecc, 0). NOTE: in long double,
/// as near the sun it is a difference of large numbers.
double off_ellipse(const std::vector<double>& row, double eccentricity) {
    const auto exact = [](double value) { return static_cast<long double>(value); };
    const long double x = exact(row[1]), y = exact(row[2]), px = exact(row[3]), py = exact(row[4]);
    const long double L = x * py - y * px, r = std::sqrt(x * x + y * y);
    // At the perihelion the vector leads there, and x is positive.
    const long double along = py * L - x / r - exact(eccentricity);
    return static_cast<double>(std::hypot(along, -px * L - y / r));
}

/// The time on the ellipse where the planet is: Kepler's equation, t = E - e sin E.
double time_there(const std::vector<double>& row, double eccentricity) {
    const double y = row[2] / std::sqrt(1 - eccentricity * eccentricity);
    const double E = std::atan2(y, row[1] + eccentricity);
    return (E < 0 ? E + 2 * pi : E) - eccentricity * std::sin(E);
}

}  // namespace

TEST_CASE("Stormer-Verlet stays on Kepler's ellipse in logarithmic time") {
    const std::string scaled = planet("99/100", "[time]\nscale = \"logarithmic\"\n");
    for (const std::string how : {"", "--interpret"}) {
        const SceneRun found = run_scene(scaled, how + " --until 100*pi");
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        CHECK(found.table.front() == "t,x,y,px,py,energy,J1");
        CHECK(found.table.size() > 2490);
        double off = 0;
        for (const auto& row : found.rows()) off = std::max(off, off_ellipse(row, 0.99));
        CHECK(off < 1e-13);
        CHECK(found.last()[0] == Approx(100 * pi).epsilon(1e-15));
    }
    // The time alone is wrong, by h^2: numbers of an independent program, Preto & Tremaine's way.
    const std::vector<std::pair<int, double>> lag{{50, 8.166e-3}, {100, 2.045e-3}, {200, 5.115e-4}};
    for (const auto& [steps, expected] : lag) {
        const SceneRun found = run_scene(scaled, "--until 7 --step 2*pi/" + std::to_string(steps));
        const double late = found.row(static_cast<std::size_t>(steps))[0] - 2 * pi;
        CAPTURE(steps);
        CHECK(std::abs(late) == Approx(expected).epsilon(1e-3));
    }
}

TEST_CASE("eccentricities up to 0.999999") {
    for (const std::string digits : {"9999/10000", "999999/1000000"}) {
        const double eccentricity = digits.size() < 11 ? 0.9999 : 0.999999;
        const SceneRun found =
            run_scene(planet(digits, "[time]\nscale = \"logarithmic\"\n"), "--until 20*pi");
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        double off = 0;
        for (const auto& row : found.rows()) off = std::max(off, off_ellipse(row, eccentricity));
        CHECK(off < 1e-10);
    }
}

TEST_CASE("compositions are explicit in logarithmic time, and err by h^4") {
    const std::string scaled = planet("9/10", "[time]\nscale = \"logarithmic\"\n");
    const auto late = [&](int steps) {
        const SceneRun found =
            run_scene(scaled, "--compose suzuki:4 --until 7 --step 2*pi/" + std::to_string(steps));
        return std::abs(found.row(static_cast<std::size_t>(steps))[0] - 2 * pi);
    };
    const double ratio = late(40) / late(80);
    CHECK(ratio > 14);
    CHECK(ratio < 18);
}

TEST_CASE("scales of any H, by Gauss methods") {
    for (const std::string scale :
         {"distance", "potential", "arclength", "(x^2 + y^2)^(3/4)", "1/10"}) {
        CAPTURE(scale);
        // One orbit takes some hundreds of steps by each of them.
        const std::string step = scale == "1/10" ? "1/100" : "1/50";
        const SceneRun found = run_scene(planet("9/10", "[time]\nscale = \"" + scale + "\"\n"),
                                         "--method gauss:6 --until 2*pi --step " + step);
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        double late = 0, lost = 0;
        for (std::size_t k = 1; k + 2 < found.table.size(); ++k) {
            late = std::max(late, std::abs(found.row(k)[0] - time_there(found.row(k), 0.9)));
            lost = std::max(lost, std::abs(found.row(k)[5] + 0.5));
        }
        CHECK(late < 1e-7);
        CHECK(lost < 1e-7);
        CHECK(found.last()[0] == 2 * pi);
        CHECK(std::abs(found.last()[1] - 0.1) < 1e-6);
    }
}

TEST_CASE("a power law of time is met in scaled time too") {
    // H = p^2/2 - 2 q/(t + 1)^2 has q'' = 2/(t + 1)^2: q = 2 t - 2 log(t + 1) from rest.
    const SceneRun found = run_scene(
        "hamiltonian = \"p^2/2 - 2*q/(t+1)^2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
        "initial = {q = 0, p = 0}\nrun = {method = \"gauss:6\", step = \"1/50\", until = 9}\n"
        "[time]\nscale = \"(t + 1)*(1 + p^2)\"\n",
        "--times 0:9:4");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.table.size() == 5);
    for (std::size_t k = 0; k < 4; ++k) {
        const double t = found.row(k)[0];
        CHECK(t == 3 * static_cast<double>(k));
        CHECK(std::abs(found.row(k)[1] - (2 * t - 2 * std::log(t + 1))) < 1e-10);
        CHECK(std::abs(found.row(k)[2] - (2 - 2 / (t + 1))) < 1e-10);
    }
}

TEST_CASE("two bodies by their distance") {
    const SceneRun found = run_scene(
        "coordinates = [\"x[1..2]\", \"y[1..2]\"]\nmomenta = [\"px[1..2]\", \"py[1..2]\"]\n"
        "hamiltonian = \"sum(i=1..2, px[i]^2 + py[i]^2)/2 - "
        "1/sqrt((x[1]-x[2])^2 + (y[1]-y[2])^2)\"\n"
        "initial = {x = [\"1/10\", \"-1/10\"], y = [0, 0], px = [0, 0], "
        "py = [\"3/2\", \"-3/2\"]}\n"
        "run = {method = \"gauss:6\", step = \"1/40\", until = 1}\n[time]\nscale = \"distance\"\n");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    // H = 9/4 - 5 at the start.
    for (const auto& row : found.rows()) CHECK(std::abs(row[9] + 2.75) < 1e-9);
    for (const auto& row : found.rows()) CHECK(std::abs(row[1] + row[2]) < 1e-14);
}

TEST_CASE("events and jumps in scaled time") {
    const SceneRun found = run_scene(planet("9/10", "[time]\nscale = \"logarithmic\"\n"
                                                    "[events.aphelion]\nzero = \"x*px + y*py\"\n"
                                                    "direction = \"down\"\n"
                                                    "[events.clock]\nzero = \"t - 1\"\n"),
                                     "--until 4*pi --step 2*pi/800 --compose suzuki:4");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.events.size() == 4);
    CHECK(found.events[0] == "event,number,t,x,y,px,py");
    CHECK(std::abs(numbers_of(found.events[1].substr(std::string("clock,1,").size()))[0] - 1) <
          1e-15);
    for (const std::size_t k : {2u, 3u}) {
        const std::vector<double> row =
            numbers_of(found.events[k].substr(found.events[k].find(',', 9) + 1));
        CHECK(std::abs(row[0] - (k == 2 ? pi : 3 * pi)) < 1e-7);
        CHECK(std::abs(row[1] + 1.9) < 1e-7);
    }
    // A kick at x = -1 changes H, and e with it: H + e stays 0, and so time goes right.
    const SceneRun kicked = run_scene("hamiltonian = \"p^2/2 - 10 + q\"\ncoordinates = [\"q\"]\n"
                                      "momenta = [\"p\"]\ninitial = {q = 1, p = 0}\n"
                                      "run = {method = \"gauss:4\", step = \"1/10\", until = 4}\n"
                                      "[time]\nscale = \"1 + q^2\"\n"
                                      "[events.floor]\nzero = \"q\"\ndirection = \"down\"\n"
                                      "set = {p = \"-p/2\"}\nstop = 2\n");
    INFO(kicked.outcome.err);
    REQUIRE(kicked.outcome.status == 0);
    REQUIRE(kicked.events.size() == 3);
    // The ball falls for sqrt(2), then is up in the air for as long.
    const std::vector<double> behind =
        numbers_of(kicked.events[2].substr(std::string("floor,2,").size()));
    CHECK(std::abs(behind[0] - 2 * std::sqrt(2.0)) < 1e-9);
    CHECK(std::abs(behind[2] + std::sqrt(0.5)) < 1e-9);
}

TEST_CASE("a first step in scaled time that fails is one that fails") {
    // From the perihelion of an eccentric ellipse a step of this size has no stages.
    const SceneRun found =
        run_scene(planet("99/100", "[time]\nscale = \"1 + x^2\"\n"), "--method gauss:6");
    INFO(found.outcome.err);
    check_refused(found, 1, "the run stopped after 0 steps");
}

TEST_CASE("time is scaled for a Lagrangian as for its Hamiltonian") {
    const std::string more = "parameters = {ecc = \"9/10\", m = 3}\n"
                             "run = {method = \"stormer-verlet\", step = \"2*pi/400\", "
                             "until = \"4*pi\"}\n";
    const std::string by_L =
        "lagrangian = \"m*(vx^2 + vy^2)/2 + m/sqrt(x^2 + y^2)\"\n"
        "coordinates = [\"x\", \"y\"]\nvelocities = [\"vx\", \"vy\"]\n"
        "initial = {x = \"1-ecc\", y = 0, vx = 0, vy = \"sqrt((1+ecc)/(1-ecc))\"}\n"
        "invariants = {spin = \"m*(x*vy - y*vx)\"}\n" +
        more;
    const std::string by_H =
        "hamiltonian = \"(px^2 + py^2)/(2*m) - m/sqrt(x^2 + y^2)\"\n"
        "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
        "initial = {x = \"1-ecc\", y = 0, px = 0, py = \"m*sqrt((1+ecc)/(1-ecc))\"}\n"
        "invariants = {spin = \"x*py - y*px\"}\n" +
        more;
    const std::vector<std::pair<std::string, std::string>> scales{
        {"logarithmic", ""},
        {"distance", "--method gauss:6 --step 1/40"},
        {"1/(VELOCITY)", "--method gauss:6 --step 1/20"}};
    for (const auto& scale_and_how : scales) {
        const std::string scale = scale_and_how.first, how = scale_and_how.second;
        CAPTURE(scale, how);
        // A scale of the velocities is one of the momenta over the mass.
        const auto run = [&](const std::string& scene, const std::string& square,
                             const std::string& radial) {
            std::string of = scale;
            if (const std::size_t at = of.find("VELOCITY"); at != std::string::npos)
                of.replace(at, 8, square);
            return run_scene(scene + "[time]\nscale = \"" + of +
                                 "\"\n[events.aphelion]\nzero = \"" + radial +
                                 "\"\ndirection = \"down\"\n",
                             how);
        };
        const SceneRun L = run(by_L, "1 + vx^2 + vy^2", "x*vx + y*vy"),
                       H = run(by_H, "1 + (px^2 + py^2)/m^2", "x*px + y*py");
        INFO(L.outcome.err + H.outcome.err);
        REQUIRE(L.outcome.status == 0);
        CHECK(L.table.front() == "t,x,y,p_x,p_y,energy,spin");
        REQUIRE(L.table.size() == H.table.size());
        for (std::size_t k = 0; k < L.rows().size(); ++k)
            for (std::size_t i = 0; i < 7; ++i) CHECK(std::abs(L.row(k)[i] - H.row(k)[i]) < 1e-8);
        REQUIRE(L.events.size() == 3);
        CHECK(std::abs(L.event(0)[0] - H.event(0)[0]) < 1e-8);
        CHECK(std::abs(L.event(0)[0] - pi) < 1e-3);
        CHECK(std::abs(L.event(0)[1] + 1.9) < 1e-3);
        // m^2 (1 - e^2) is the square of m times the angular momentum.
        CHECK(std::abs(L.row(0)[6] - 3 * std::sqrt(0.19)) < 1e-14);
    }
    const SceneRun set = run_scene(by_L + "[time]\nscale = \"distance\"\n[events.wall]\n"
                                          "zero = \"x\"\nset = {vx = \"-vx\"}\n",
                                   "--method gauss:6");
    check_refused(set, 2, "events of a Lagrangian set nothing");
    // Where L is not quadratic in the velocities its H is not found.
    const SceneRun other = run_scene("lagrangian = \"-sqrt(1 - v^2) - q^2/2\"\n"
                                     "coordinates = [\"q\"]\nvelocities = [\"v\"]\n"
                                     "initial = {q = 1, v = 0}\nrun = {method = \"gauss:4\", "
                                     "step = \"1/10\", until = 1}\n"
                                     "[time]\nscale = \"1 + q^2\"\n");
    check_refused(other, 1, "not seen to be quadratic");
}

TEST_CASE("time is scaled where sums stay loops as where they are written out") {
    const std::string bodies =
        "coordinates = [\"x[1..N]\", \"y[1..N]\"]\nmomenta = [\"px[1..N]\", \"py[1..N]\"]\n"
        "hamiltonian = \"sum(i=1..N, (px[i]^2 + py[i]^2)/(2*m[i])) - sum(i=1..N-1, j=i+1..N, "
        "m[i]*m[j]/sqrt((x[i]-x[j])^2 + (y[i]-y[j])^2))\"\n"
        "parameters = {N = 3, m = [3, 4, 5]}\n"
        "initial = {x = [1, -2, 1], y = [3, -1, -1], \"px[i]\" = 0, \"py[i]\" = 0}\n"
        "run = {method = \"gauss:6\", step = \"1/100\", until = 1}\n"
        "[events.nearer]\nzero = \"x[2] + 19/10 + 0*t\"\n"
        "[events.clock]\nzero = \"t - 1/3\"\n";
    const std::vector<std::string> scales{
        "distance",     "potential", "1/(1 + sum(i=1..N, px[i]^2 + py[i]^2))",
        "1 + t*x[1]^2", "1/2",       "logarithmic"};
    for (const std::string& scale : scales) {
        CAPTURE(scale);
        const std::string words = scale == "logarithmic"
                                      ? "--method stormer-verlet --compose suzuki:4 --unroll "
                                      : "--unroll ";
        const std::string scene = bodies + "[time]\nscale = \"" + scale + "\"\n";
        const SceneRun out = run_scene(scene, words + "yes"),
                       loops = run_scene(scene, words + "no");
        INFO(loops.outcome.err);
        REQUIRE(loops.outcome.status == 0);
        REQUIRE(loops.table.size() == out.table.size());
        // The time, twelve variables, the energy and four momentum maps.
        const auto a = out.rows(), b = loops.rows();
        for (std::size_t k = 0; k < a.size(); ++k) {
            REQUIRE(a[k].size() == 18);
            REQUIRE(b[k].size() == 18);
            for (std::size_t i = 0; i < 18; ++i) CHECK(std::abs(a[k][i] - b[k][i]) < 1e-11);
        }
        REQUIRE(out.events.size() == 3);
        REQUIRE(loops.events.size() == 3);
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}})
            for (std::size_t i = 0; i < out.event(k).size(); ++i)
                CHECK(std::abs(out.event(k)[i] - loops.event(k)[i]) < 1e-11);
        CHECK(std::abs(loops.event(0)[0] - 1.0 / 3) < 1e-13);
    }
}

TEST_CASE("the turned centre of mass is watched where sums stay loops") {
    // Sums of m x, of m y, of px and of py are 13, 9, 3 and 6: so 13*6 - 9*3 = 51 stays.
    const std::string bodies =
        "coordinates = [\"x[1..N]\", \"y[1..N]\"]\nmomenta = [\"px[1..N]\", \"py[1..N]\"]\n"
        "hamiltonian = \"sum(i=1..N, (px[i]^2 + py[i]^2)/(2*m[i])) - sum(i=1..N-1, j=i+1..N, "
        "m[i]*m[j]/sqrt((x[i]-x[j])^2 + (y[i]-y[j])^2))\"\n"
        "parameters = {N = 3, m = [3, 4, 5]}\n"
        "initial = {x = [1, 0, 2], y = [0, 1, 1], \"px[i]\" = 1, \"py[i]\" = \"i\"}\n"
        "run = {method = \"gauss:4\", step = \"1/100\", until = \"1/5\"}\n";
    for (const std::string scale : {"", "[time]\nscale = \"distance\"\n"})
        for (const std::string how : {"--unroll no", "--unroll yes"}) {
            CAPTURE(scale, how);
            const SceneRun run = run_scene(bodies + scale, how);
            INFO(run.outcome.err);
            REQUIRE(run.outcome.status == 0);
            REQUIRE(run.row(0).size() == 18);
            for (const auto& row : run.rows()) CHECK(std::abs(row[17] - 51) < 1e-11);
            CHECK(run.outcome.out.find("\nJ4 ") != std::string::npos);
        }
}

TEST_CASE("a hundred bodies stay on their ellipses in logarithmic time") {
    // They begin on a ring where all are farthest, and are at each time the corners of a polygon:
    // so H is that of Kepler's problem, of the mass M + m/4 (sum of 1/sin).
    const SceneRun found = run_scene(
        "coordinates = [\"x[1..N]\", \"y[1..N]\"]\nmomenta = [\"px[1..N]\", \"py[1..N]\"]\n"
        "hamiltonian = \"sum(i=1..N, (px[i]^2 + py[i]^2)/(2*m) - m/sqrt(x[i]^2 + y[i]^2)) - "
        "sum(i=1..N-1, j=i+1..N, m^2/sqrt((x[i]-x[j])^2 + (y[i]-y[j])^2))\"\n"
        "[parameters]\nN = 100\nm = \"1/N^3\"\n"
        "w = \"sqrt((1 + m/4*sum(k=1..N-1, 1/sin(pi*k/N)))/10)\"\n"
        "[initial]\n\"x[i]\" = \"cos(2*pi*i/N)\"\n\"y[i]\" = \"sin(2*pi*i/N)\"\n"
        "\"px[i]\" = \"-m*w*sin(2*pi*i/N)\"\n\"py[i]\" = \"m*w*cos(2*pi*i/N)\"\n"
        "[run]\nmethod = \"stormer-verlet\"\nstep = \"pi/(50*N^2)\"\nuntil = 5\n"
        "[time]\nscale = \"logarithmic\"\n",
        "--columns x[100],y[100],px[100],py[100]");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.table.size() > 100);
    double mass = 1;
    for (int k = 1; k < 100; ++k) mass += 1e-6 / 4 / std::sin(pi * k / 100);
    double nearest = 1;
    for (const auto& row : found.rows()) {
        const double x = row[1], y = row[2], vx = row[3] * 1e6, vy = row[4] * 1e6;
        const double L = x * vy - y * vx, r = std::hypot(x, y);
        // The vector leads to the perihelion, which is at -x; the eccentricity is 9/10.
        CHECK(std::abs(vy * L / mass - x / r + 0.9) < 1e-11);
        CHECK(std::abs(-vx * L / mass - y / r) < 1e-11);
        nearest = std::min(nearest, r);
    }
    CHECK(nearest < 0.06);
}

TEST_CASE("an H of the time is scaled where sums stay loops") {
    // q[i]'' = 2 i/(t + 1)^2.
    const SceneRun found =
        run_scene("hamiltonian = \"sum(i=1..N, p[i]^2/2 - 2*i*q[i]/(t+1)^2)\"\n"
                  "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\nparameters = {N = 500}\n"
                  "initial = {\"q[i]\" = 0, \"p[i]\" = 0}\n"
                  "run = {method = \"gauss:6\", step = \"1/50\", until = 9}\n"
                  "[time]\nscale = \"(t + 1)*(1 + p[1]^2)\"\n",
                  "--times 0:9:4 --columns q[7]");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.table.size() == 5);
    for (std::size_t k = 0; k < 4; ++k) {
        const double t = found.row(k)[0];
        CHECK(t == 3 * static_cast<double>(k));
        CHECK(std::abs(found.row(k)[1] - 7 * (2 * t - 2 * std::log(t + 1))) < 1e-9);
    }
}

TEST_CASE("scales that loops do not have are refused with their place") {
    const auto refused = [&](const std::string& function, const std::string& scale, int status,
                             const std::string& message, const std::string& more = "") {
        const bool has_L = function.find('v') != std::string::npos;
        const std::string other = has_L ? "v" : "p";
        const SceneRun found = run_scene(
            (has_L ? "lagrangian = \"" : "hamiltonian = \"") + function +
            "\"\ncoordinates = [\"q[1..N]\"]\n" + (has_L ? "velocities" : "momenta") + " = [\"" +
            other + "[1..N]\"]\nparameters = {N = 300}\ninitial = {\"q[i]\" = 1, \"" + other +
            "[i]\" = 0}\nrun = {method = \"gauss:2\", step = \"1/20\", until = 1}\n" +
            "[time]\nscale = \"" + scale + "\"\n" + more);
        CAPTURE(function, scale, found.outcome.err);
        CHECK(found.outcome.status == status);
        CHECK(found.outcome.err.find(message) != std::string::npos);
    };
    const std::string springs = "sum(i=1..N, p[i]^2/2 + q[i]^2/2)";
    refused(springs, "arclength", 2, "the arclength is not built where sums stay loops");
    refused("sum(i=1..N, p[i]^2/2*(1 + q[i]^2))", "logarithmic", 2, "a sum depends on both");
    refused("sum(i=1..N, v[i]^2/2 - q[i]^2/2)", "1 + q[1]^2", 2,
            "not built for a Lagrangian whose sums stay loops");
    refused(springs, "1 + q[301]^2", 2, "301");
    refused(springs, "1 + r", 2, "`r`");
    refused(springs, "1 + q[1]^2", 2, "events that jump are not built where sums stay loops",
            "[events.wall]\nzero = \"q[1]\"\nset = {\"p[i]\" = 0}\n");
    // -U is negative, and has no logarithm.
    refused(springs, "logarithmic", 1, "the run stopped after 0 steps");
}

TEST_CASE("scales that are none are refused with their place") {
    const auto refused = [&](const std::string& scale, int status, const std::string& message,
                             const std::string& words = "") {
        const SceneRun found = run_scene(planet("1/2", "[time]\n" + scale + "\n"), words);
        CAPTURE(scale, found.outcome.err);
        CHECK(found.outcome.status == status);
        CHECK(found.outcome.err.find(message) != std::string::npos);
    };
    refused("scale = \"0\"", 1, "is not seen to be positive where the scene begins");
    refused("scale = \"-x\"", 1, "is not seen to be positive where the scene begins");
    refused("scale = \"sqrt(-x)\"", 1, "has no value where the scene begins");
    refused("scale = \"r\"", 2, "`r`");
    refused("scale = \"x +\"", 2, "scene.toml");
    refused("scale = true", 2, "scene.toml");
    refused("scales = \"x\"", 2, "`scales`");
    refused("", 2, "there is no scale");
    refused("scale = \"distance\"", 1, "steps of this size lead away", "--until=-1");
    const SceneRun mixed =
        run_scene("hamiltonian = \"(1 + q^2)*p^2/2 - 1\"\ncoordinates = [\"q\"]\n"
                  "momenta = [\"p\"]\ninitial = {q = 0, p = 1}\n"
                  "run = {method = \"gauss:4\", step = 0.1, until = 1}\n"
                  "[time]\nscale = \"logarithmic\"\n");
    check_refused(mixed, 2, "depends on both");
    const SceneRun positive = run_scene("hamiltonian = \"p^2/2 + q^2/2\"\ncoordinates = [\"q\"]\n"
                                        "momenta = [\"p\"]\ninitial = {q = 1, p = 0}\n"
                                        "run = {method = \"gauss:4\", step = 0.1, until = 1}\n"
                                        "[time]\nscale = \"logarithmic\"\n");
    check_refused(positive, 1, "-U is not seen to be positive");
}

TEST_CASE("scenes of scaled time and of jumps come with the program") {
    use_cache();
    const Directory directory;
    const auto table = [&](const std::string& scene, const std::string& words = "") {
        const Outcome outcome = shell("exec \"$hvi_gen\" run " + scene + " -o " + scene +
                                          " --only table --no-symmetries " + words,
                                      directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        std::vector<std::vector<double>> rows;
        for (const std::string& line : lines_of(contents(directory / scene / "trajectory.csv")))
            if (line[0] != 't') rows.push_back(numbers_of(line));
        return rows;
    };
    // t,x,y,px,py,energy,angular_momentum,laplace_x,laplace_y
    for (const std::vector<double>& row : table("eccentric-kepler")) {
        CHECK(std::abs(row[7] - 0.99) < 1e-13);
        CHECK(std::abs(row[8]) < 1e-13);
    }
    CHECK(lines_of(contents(directory / "eccentric-kepler" / "events.csv")).size() == 10);
    // The lightest body escapes, the others stay close to one another.
    const std::vector<double> end = table("pythagorean").back();
    CHECK(end[0] == 63);
    CHECK(std::hypot(end[1] - end[3], end[2] - end[4]) > 8);
    CHECK(std::hypot(end[3] - end[5], end[4] - end[6]) < 3);
    // A fall from the height 1 takes sqrt(2).
    static_cast<void>(table("bouncing-ball"));
    const auto bounces = lines_of(contents(directory / "bouncing-ball" / "events.csv"));
    REQUIRE(bounces.size() == 8);
    for (std::size_t k = 1; k < bounces.size(); ++k) {
        const std::string time = bounces[k].substr(bounces[k].find(',', 6) + 1);
        const double expected = std::sqrt(2.0) * (2 * static_cast<double>(k) - 1);
        CHECK(std::stod(time) == Approx(expected).epsilon(1e-14));
    }
}
