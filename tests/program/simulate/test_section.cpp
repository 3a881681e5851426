// Derivatives of the time and the state of an event that ends a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

std::string scene_with_end(const std::string& H, const std::string& start, const std::string& event,
                           const std::string& method) {
    return "hamiltonian = \"" + H + "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\ninitial = {" +
           start + "}\nrun = {method = \"" + method + "\", step = \"3/10\", until = 30}\n" +
           "[events.end]\nstop = 1\n" + event;
}

/// The rows of section.csv, which are named so.
NumberRows section_of(const SceneRun& run, const std::vector<std::string>& names) {
    INFO(run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    REQUIRE(run.section.size() == names.size() + 1);
    std::string head = "of";
    NumberRows rows;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string& line = run.section[k + 1];
        CHECK(line.substr(0, line.find(',')) == names[k]);
        if (k > 0) head += "," + names[k];
        rows.push_back(numbers_of(line.substr(line.find(',') + 1)));
    }
    CHECK(run.section.front() == head);
    return rows;
}

/// A star in a galaxy; the start is moved by parameters.
const std::string star_of_sections =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
    "initial = {x = \"a\", y = \"1/10 + b\", px = \"1/2 + c\", py = \"d\"}\n"
    "run = {method = \"gauss:8\", step = \"1/10\", until = 40}\n";

std::string scene_of_L(const std::string& L, const std::string& start, const std::string& zero) {
    return "lagrangian = \"" + L + "\"\ncoordinates = [\"q\"]\nvelocities = [\"v\"]\ninitial = {" +
           start + "}\nrun = {method = \"gauss:8\", step = \"1/10\", until = 30}\n" +
           "[events.end]\nstop = 1\nzero = \"" + zero + "\"\n";
}

/// Checks that both runs have the same section, up to rounding and the end of iterations.
void check_same_section(const SceneRun& found, const std::vector<std::string>& names,
                        const SceneRun& expected, const std::vector<std::string>& its_names) {
    check_rows(section_of(found, names), section_of(expected, its_names), 1e-9);
    const std::vector<double> of_map = found.said("return map"),
                              expected_of_map = expected.said("return map");
    REQUIRE(of_map.size() == expected_of_map.size());
    for (std::size_t k = 0; k < of_map.size(); ++k)
        CHECK(of_map[k] == Approx(expected_of_map[k]).epsilon(1e-5).margin(1e-8));
}

}  // namespace

TEST_CASE("a fall ends as its closed form says, and so do its neighbours") {
    // q = 4 + 3 t - t^2 is 0 at t = 4, and t* = (p + sqrt(p^2 + 4 q))/2, p* = -sqrt(p^2 + 4 q).
    for (const std::string how : {"--tangent", "--tangent --interpret"}) {
        const SceneRun fall = run_scene(
            scene_with_end("p^2/2 + 2*q", "q = 4, p = 3", "zero = \"q\"\n", "stormer-verlet"), how);
        check_rows(section_of(fall, {"t", "q", "p"}), {{0.2, 0.8}, {0, 0}, {-0.4, -0.6}}, 1e-12);
        // The matrix of the flow stays that of the time of the event.
        check_rows(fall.tangent, {{1, 4}, {0, 1}}, 1e-12);
    }
}

TEST_CASE("the oscillator comes to its surface by its angle") {
    // (q, p) turns clockwise from (3/5, 4/5): dt* = (q dp - p dq)/r^2; at q = 0 there is p = -r.
    const SceneRun found = run_scene(
        scene_with_end("(p^2 + q^2)/2", "q = \"3/5\", p = \"4/5\"", "zero = \"q\"\n", "gauss:16"),
        "--tangent");
    check_rows(section_of(found, {"t", "q", "p"}), {{-0.8, 0.6}, {0, 0}, {-0.6, -0.8}}, 1e-12);
}

TEST_CASE("a surface and a force that depend on the time") {
    // q = q0 + p0 t + t^3 meets t^3 - t + 7 at t* = (7 - q0)/(p0 + 1), which is 3 from (1, 1).
    const SceneRun found = run_scene(
        scene_with_end("p^2/2 - 6*t*q", "q = 1, p = 1", "zero = \"q - t^3 + t - 7\"\n", "gauss:6"),
        "--tangent");
    const double q = -1.0 / 2, p = -3.0 / 2;
    check_rows(section_of(found, {"t", "q", "p"}),
               {{q, p}, {1 + 28 * q, 3 + 28 * p}, {18 * q, 1 + 18 * p}}, 1e-11);
    // No return map leads to a surface that moves.
    CHECK(found.outcome.out.find("return map") == std::string::npos);
}

TEST_CASE("a fall by its Lagrangian, whose momentum depends on the place") {
    // p = 2 v + q, and q = q0 + v0 t - t^2 begins with q0 = 4, v0 = 3, p0 = 10. On the floor it is
    // t = (v0 + s)/2 and p = -2 s with s = sqrt(v0^2 + 4 q0) = 5; dv0 = (dp0 - dq0)/2.
    const std::string L = "v^2 - 4*q + q*v", start = "q = 4, v = 3";
    const SceneRun floor = run_scene(scene_of_L(L, start, "q"), "--tangent");
    check_rows(section_of(floor, {"t", "q", "p_q"}), {{-0.2, 0.4}, {0, 0}, {-0.2, -0.6}}, 1e-12);
    // At the top it is t = v0/2, and p = q = q0 + v0^2/4.
    const SceneRun top = run_scene(scene_of_L(L, start, "v"), "--tangent");
    check_rows(section_of(top, {"t", "q", "p_q"}), {{-0.25, 0.25}, {0.25, 0.75}, {0.25, 0.75}},
               1e-12);
}

TEST_CASE("a Lagrangian and a surface that depend on the time") {
    // p = (1 + t) v is constant, and q = q0 + p ln(1 + t), from q0 = 0 and p = 1.
    const std::string L = "(1 + t)*v^2/2", start = "q = 0, v = 1";
    const double e = std::exp(1.0), ln2 = std::log(2.0);
    const SceneRun place = run_scene(scene_of_L(L, start, "q - 1"), "--tangent");
    check_rows(section_of(place, {"t", "q", "p_q"}), {{-e, -e}, {0, 0}, {0, 1}}, 1e-10);
    // v = 1/2 at t = 2 p - 1; and v = t/2 where t (1 + t) = 2 p, so that 3 dt = 2 dp.
    const SceneRun speed = run_scene(scene_of_L(L, start, "v - 1/2"), "--tangent");
    check_rows(section_of(speed, {"t", "q", "p_q"}), {{0, 2}, {1, ln2 + 1}, {0, 1}}, 1e-10);
    const SceneRun moving = run_scene(scene_of_L(L, start, "v - t/2"), "--tangent");
    check_rows(section_of(moving, {"t", "q", "p_q"}), {{0, 2.0 / 3}, {1, ln2 + 1.0 / 3}, {0, 1}},
               1e-10);
}

TEST_CASE("a section by a Lagrangian is that by its Hamiltonian") {
    // Masses depend on the place, and velocities are coupled: p = (vr + c vf, c vr + r^2 vf).
    const std::string of_both = "coordinates = [\"r\", \"f\"]\nparameters = {c = \"1/3\"}\n"
                                "run = {method = \"gauss:8\", step = \"1/20\", until = 40}\n";
    const std::string vr = "(r^2*pr - c*pf)/(r^2 - c^2)", vf = "(pf - c*pr)/(r^2 - c^2)";
    const std::string by_H =
        of_both + "momenta = [\"pr\", \"pf\"]\nhamiltonian = \"(r^2*pr^2 - 2*c*pr*pf + "
                  "pf^2)/(2*(r^2 - c^2)) - 1/r\"\ninitial = {r = 1, f = 0, pr = \"13/30\", pf = "
                  "\"31/30\"}\n";
    const std::string by_L =
        of_both + "velocities = [\"vr\", \"vf\"]\nlagrangian = \"vr^2/2 + c*vr*vf + "
                  "r^2*vf^2/2 + 1/r\"\ninitial = {r = 1, f = 0, vr = \"1/10\", vf = 1}\n";
    const auto event = [](const std::string& zero) {
        return "[events.end]\nstop = 3\nzero = \"" + zero + "\"\n";
    };
    const std::vector<std::string> of_L{"t", "r", "f", "p_r", "p_f"},
        of_H{"t", "r", "f", "pr", "pf"};
    check_same_section(run_scene(by_L + event("sin(f) - r/4"), "--tangent"), of_L,
                       run_scene(by_H + event("sin(f) - r/4"), "--tangent"), of_H);
    check_same_section(run_scene(by_L + event("vr - vf/50"), "--tangent"), of_L,
                       run_scene(by_H + event(vr + " - " + vf + "/50"), "--tangent"), of_H);
}

TEST_CASE("a section where sums stay loops is that where they are written out") {
    const std::string row = "coordinates = [\"q[1..N]\"]\nparameters = {N = 3, m = [1, 2, 3]}\n"
                            "run = {method = \"gauss:8\", step = \"1/20\", until = 40}\n";
    const std::string of_H =
        row + "momenta = [\"p[1..N]\"]\nhamiltonian = \"sum(i=1..N, p[i]^2/(2*m[i]) - cos(q[i]) - "
              "cos(q[i] - q[mod(i, N) + 1]))\"\n"
              "initial = {\"q[i]\" = \"i/2\", \"p[i]\" = \"m[i]*cos(i)/2\"}\n";
    const std::string of_L =
        row + "velocities = [\"v[1..N]\"]\nlagrangian = \"sum(i=1..N, m[i]*v[i]^2/2 + cos(q[i]) + "
              "cos(q[i] - q[mod(i, N) + 1]))\"\n"
              "initial = {\"q[i]\" = \"i/2\", \"v[i]\" = \"cos(i)/2\"}\n";
    const auto event = [](const std::string& zero) {
        return "[events.end]\nstop = 2\nzero = \"" + zero + "\"\n";
    };
    const std::vector<std::string> names{"t", "q[1]", "q[2]", "q[3]", "p[1]", "p[2]", "p[3]"};
    const std::vector<std::string> names_of_L{"t",      "q[1]",   "q[2]",  "q[3]",
                                              "p_q[1]", "p_q[2]", "p_q[3]"};
    const std::string places = event("q[2] - sum(i=1..N, q[i])/10 - t/1000");
    const SceneRun written = run_scene(of_H + places, "--tangent --unroll yes");
    check_same_section(run_scene(of_H + places, "--tangent --unroll no"), names, written, names);
    check_same_section(run_scene(of_L + places, "--tangent --unroll no"), names_of_L, written,
                       names);
    const std::string speeds = event("p[3]/3 - p[1] + q[1]/7");
    check_same_section(run_scene(of_H + speeds, "--tangent --unroll no"), names,
                       run_scene(of_H + speeds, "--tangent --unroll yes"), names);
    check_same_section(run_scene(of_L + event("v[3] - v[1] + q[1]/7"), "--tangent --unroll no"),
                       names_of_L, run_scene(of_H + speeds, "--tangent --unroll yes"), names);
}

TEST_CASE("derivatives at an event are those of runs from starts nearby") {
    const std::string event = "[events.plane]\nzero = \"x + y^2/3 + px/5\"\nstop = 3\n";
    const SceneRun found = run_scene(star_of_sections + event, "--tangent");
    const NumberRows section = section_of(found, {"t", "x", "y", "px", "py"});
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string name(1, static_cast<char>('a' + k));
        const auto end = [&](const std::string& value) {
            return run_scene(star_of_sections + event, "--param " + name + "=" + value).event(2);
        };
        const std::vector<double> after = end("1e-5"), before = end("-1e-5");
        for (std::size_t row = 0; row < 5; ++row) {
            CAPTURE(name, row);
            CHECK(std::abs((after[row] - before[row]) / 2e-5 - section[row][k]) < 3e-7);
        }
    }
}

TEST_CASE("the return map of a closed orbit has its multipliers") {
    // x swings, and y falls off a hill: in a period of x a direction there grows by exp(pi).
    const std::string hill = "hamiltonian = \"(px^2 + py^2)/2 + x^2/2 - y^2/8\"\n"
                             "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                             "initial = {x = 0, y = 0, px = 1, py = 0}\n"
                             "run = {method = \"gauss:8\", step = \"1/10\", until = 10}\n"
                             "[events.again]\nzero = \"x\"\ndirection = \"up\"\nstop = 1\n";
    const SceneRun found = run_scene(hill, "--tangent");
    const std::vector<double> said = found.said("return map");
    REQUIRE(said.size() == 3);
    CHECK(said[0] == Approx(std::exp(pi)).epsilon(1e-5));
    CHECK(said[1] == Approx(1).epsilon(1e-5));
    CHECK(said[2] == Approx(std::exp(-pi)).epsilon(1e-5));
}

TEST_CASE("where no derivative of an event is built, a run says so and why") {
    const auto says = [](const SceneRun& run, const std::string& what) {
        INFO(run.outcome.err + run.outcome.out);
        CHECK(run.outcome.status == 0);
        CHECK(run.section.empty());
        CHECK(run.tangent.size() == 2);
        return run.outcome.out.find(what) != std::string::npos;
    };
    // From -1 with the velocity 1 steps of 1/8 hit 0 just so, where q^3 has no slope.
    CHECK(says(
        run_scene(scene_with_end("p^2/2", "q = -1, p = 1", "zero = \"q^3\"\n", "stormer-verlet"),
                  "--tangent --step 1/8"),
        "the motion touches `end`"));
    // H has more than 100 000 words here.
    const SceneRun large =
        run_scene("hamiltonian = \"sum(i=1..N, p[i]^2/2) + sum(i=1..N, j=1..N, (q[i] - "
                  "q[j])^2)/2\"\ncoordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
                  "parameters = {N = 130}\ninitial = {\"q[i]\" = 0, \"p[i]\" = 1}\n"
                  "run = {method = \"stormer-verlet\", step = \"1/2\", until = 2}\n"
                  "[events.end]\nzero = \"q[1] - 3/4\"\nstop = 1\n",
                  "--tangent --unroll no");
    INFO(large.outcome.err + large.outcome.out);
    CHECK(large.outcome.status == 0);
    CHECK(large.section.empty());
    CHECK(large.tangent.size() == 260);
    CHECK(large.outcome.out.find("are not built where H is too long to be written out") !=
          std::string::npos);
    // A run that no event ends has none, and without --tangent there is none.
    const std::string fall =
        scene_with_end("p^2/2 + 2*q", "q = 4, p = 3", "zero = \"q\"\n", "gauss:2");
    CHECK(run_scene(fall, "--tangent --until 3").section.empty());
    CHECK(run_scene(fall).section.empty());
}
