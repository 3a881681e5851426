// Events of scenes, and rows at given times.
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

/// A ball above a floor: it falls for a time of 1, then is up in the air for 2 again and again.
const std::string ball = "hamiltonian = \"p^2/2 + g*q\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                         "parameters = {g = 1}\ninitial = {q = \"1/2\", p = 0}\n"
                         "run = {method = \"stormer-verlet\", step = \"1/10\", until = 6}\n";

/// q = cos(t).
const std::string spring =
    "hamiltonian = \"p^2/2 + q^2/2 + 0*q^3*s\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
    "parameters = {s = 1}\ninitial = {q = 1, p = 0}\n"
    "run = {method = \"gauss:4\", step = \"1/10\", until = 20}\n";

const std::string planet_of_half =
    "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "initial = {x = \"1/2\", y = 0, px = 0, py = \"sqrt(3)\"}\n"
    "run = {method = \"gauss:4\", step = \"1/20\", until = \"20*pi\"}\n";

}  // namespace

TEST_CASE("a ball bounces, and is back at its height") {
    for (const std::string how : {"", "--interpret"}) {
        const SceneRun found =
            run_scene(ball + "[events.floor]\nzero = \"q\"\ndirection = \"down\"\n"
                             "set = {p = \"-p\"}\ncanonical = true\n",
                      how);
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        REQUIRE(found.events.size() == 4);
        CHECK(found.events[0] == "event,number,t,q,p");
        for (std::size_t k = 1; k <= 3; ++k) {
            CHECK(found.events[k].find("floor," + std::to_string(k) + ",") == 0);
            const std::vector<double> row = found.event(k - 1);
            CHECK(std::abs(row[0] - (2.0 * static_cast<double>(k) - 1)) < 1e-14);
            CHECK(std::abs(row[1]) < 1e-14);
            CHECK(std::abs(row[2] + 1) < 1e-14);  // before it jumps
        }
        const std::vector<double> end = numbers_of(found.table.back());
        CHECK(found.table.size() == 62);
        CHECK(end[0] == 6);
        CHECK(std::abs(end[1] - 0.5) < 1e-13);
        CHECK(found.outcome.out.find("  floor, 3 times\n") != std::string::npos);
    }
}

TEST_CASE("parameters of events are those of the run") {
    const std::string scene = ball + "[events.level]\nzero = \"q - level\"\n"
                                     "[parameters]\ng = 1\nlevel = \"1/4\"\n";
    const auto time = [&](const std::string& words) {
        const std::size_t at = scene.find("parameters = {g = 1}\n");
        std::string text = scene;
        text.erase(at, std::string("parameters = {g = 1}\n").size());
        const SceneRun found = run_scene(text, words);
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        REQUIRE(found.events.size() == 2);
        return found.event(0)[0];
    };
    CHECK(std::abs(time("") - std::sqrt(0.5)) < 1e-14);
    CHECK(std::abs(time("--param level=3/8") - 0.5) < 1e-14);
    CHECK(std::abs(time("--param g=2") - 0.5) < 1e-14);
}

TEST_CASE("the third event of a name ends the run, and the table with it") {
    const SceneRun found =
        run_scene(planet_of_half + "[events.aphelion]\nzero = \"x*px + y*py\"\n"
                                   "direction = \"down\"\nstop = 3\n"
                                   "[events.perihelion]\nzero = \"x*px + y*py\"\n"
                                   "direction = \"up\"\n");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.events.size() == 6);
    for (std::size_t k = 1; k <= 5; ++k) {
        const std::vector<double> row = found.event(k - 1);
        CHECK(found.events[k].find(k % 2 == 1 ? "aphelion," : "perihelion,") == 0);
        CHECK(std::abs(row[0] - static_cast<double>(k) * pi) < 1e-9);
        CHECK(std::abs(row[1] - (k % 2 == 1 ? -1.5 : 0.5)) < 1e-9);
    }
    const std::vector<double> end = numbers_of(found.table.back());
    CHECK(end[0] == found.event(4)[0]);
    CHECK(end[1] == found.event(4)[1]);
    CHECK(found.outcome.out.find("  by the event `aphelion`\n") != std::string::npos);
}

TEST_CASE("events of the time, of angles, and with a cooldown") {
    const SceneRun found =
        run_scene(spring + "[events.clock]\nzero = \"t - 3\"\nstop = false\n"
                           "[events.angle]\nzero = \"atan2(p, q) - 1\"\nperiod = \"2*pi\"\n"
                           "[events.slow]\nzero = \"q\"\ncooldown = \"5*s\"\n"
                           "[events.top]\nzero = \"q - 999/1000\"\n");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    const double a = std::acos(0.999);
    const std::vector<std::pair<std::string, double>> expected{
        {"top", a},          {"slow", pi / 2},    {"clock", 3},       {"angle", 2 * pi - 1},
        {"top", 2 * pi - a}, {"top", 2 * pi + a}, {"slow", 2.5 * pi}, {"angle", 4 * pi - 1},
        {"top", 4 * pi - a}, {"top", 4 * pi + a}, {"slow", 4.5 * pi}, {"angle", 6 * pi - 1},
        {"top", 6 * pi - a}, {"top", 6 * pi + a}};
    REQUIRE(found.events.size() == expected.size() + 1);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        CHECK(found.events[k + 1].find(expected[k].first + ",") == 0);
        CHECK(std::abs(found.event(k)[0] - expected[k].second) < 1e-10);
    }
}

TEST_CASE("bounces that accumulate end a run with a word, and the table is kept") {
    const SceneRun found = run_scene(ball + "[events.floor]\nzero = \"q\"\ndirection = \"down\"\n"
                                            "set = {p = \"-p/2\"}\n");
    CHECK(found.outcome.status == 1);
    CHECK(found.outcome.err.find("the event `floor` comes again and again") != std::string::npos);
    CHECK(found.events.size() > 20);
    CHECK(found.table.back().find("# incomplete: ") == 0);
}

TEST_CASE("jumps that are no canonical map are refused where they say so") {
    const std::string floor = "[events.floor]\nzero = \"q\"\ncanonical = true\n";
    const SceneRun found = run_scene(ball + floor + "set = {p = \"-g*p/2\"}\n");
    CHECK(found.outcome.status == 2);
    CHECK(found.outcome.err.find("the motion with this jump is not symplectic: H changes by ") !=
          std::string::npos);
    for (const std::string jump : {"{q = \"2*q\", p = \"-2*p\"}", "{q = \"p\", p = \"q/2\"}",
                                   "{q = \"q + q^2 + p\"}", "{p = \"-p + q + t\"}"}) {
        CAPTURE(jump);
        CHECK(run_scene(ball + floor + "set = " + jump + "\n").outcome.status == 2);
    }
    // In these scenes H may change by a constant, at a time of its own. The ball falls through a
    // floor that lifts it by 1, at the speeds sqrt(1), sqrt(3), sqrt(5), ...
    const SceneRun lifted = run_scene(ball + floor + "set = {q = \"q + 1\"}\n");
    INFO(lifted.outcome.err);
    REQUIRE(lifted.outcome.status == 0);
    REQUIRE(lifted.events.size() == 19);
    for (std::size_t k = 1; k <= 18; ++k) {
        const std::vector<double> row = lifted.event(k - 1);
        CHECK(std::abs(row[0] - std::sqrt(2.0 * static_cast<double>(k) - 1)) < 1e-13);
        CHECK(std::abs(row[0] + row[2]) < 1e-13);
    }
    const std::string shift = "[events.shift]\nzero = \"t - 1/3\"\ncanonical = true\nset = ";
    for (const std::string jump : {"{q = \"-q\", p = \"-p\"}", "{q = \"2*q\", p = \"p/2\"}",
                                   "{q = \"p\", p = \"-q\"}", "{p = \"p + sin(q)*t\"}"}) {
        CAPTURE(jump);
        CHECK(run_scene(ball + shift + jump + "\n").outcome.status == 0);
    }
    const SceneRun flipped = run_scene(ball + shift + "{p = \"-p\"}\n");
    CHECK(flipped.outcome.status == 2);
    CHECK(flipped.outcome.err.find("dq^dp is not kept") != std::string::npos);
}

TEST_CASE("kinks of H that end steps keep the order, and are no rows") {
    // H = p^2/2 + |q| from q = 1/2 at rest: it falls for a time of 1, and is back after 4.
    const std::string valley =
        "hamiltonian = \"p^2/2 + abs(q)\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
        "initial = {q = \"1/2\", p = 0}\n"
        "run = {method = \"stormer-verlet\", step = \"7/100\", until = 400}\n";
    const std::string ends = "[time]\nkinks = \"events\"\n";
    const auto error = [&](const std::string& scene, const std::string& words) {
        const SceneRun found = run_scene(scene, "--times 0:400:101 " + words);
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        CHECK(found.events.empty());
        double largest = 0;
        for (const auto& row : found.rows())
            largest = std::max(largest, std::hypot(row[1] - 0.5, row[2]));
        return largest;
    };
    CHECK(error(valley + ends, "") < 1e-9);
    CHECK(error(valley + ends, "--interpret") < 1e-9);
    CHECK(error(valley, "") > 1e-5);
    // One spring to the left, another one to the right: half a period of pi/2, and one of pi.
    const std::string springs =
        "hamiltonian = \"p^2/2 + if(q < 0, q^2/2, 2*q^2)\"\ncoordinates = [\"q\"]\n"
        "momenta = [\"p\"]\ninitial = {q = 0, p = 1}\n"
        "run = {method = \"gauss:4\", step = \"1/10\", until = \"150*pi\"}\n";
    const auto at_end = [&](const std::string& scene) {
        const SceneRun found = run_scene(scene, "--times 0:150*pi:2");
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        return std::hypot(found.last()[1], found.last()[2] - 1);
    };
    CHECK(at_end(springs + ends) < 1e-9);
    CHECK(at_end(springs) > 1e-6);
    // Beside events that are rows.
    const SceneRun both = run_scene(springs + ends + "[events.left]\nzero = \"p\"\n");
    REQUIRE(both.outcome.status == 0);
    CHECK(both.events.size() == 201);
    CHECK(std::abs(both.event(0)[0] - std::acos(-1.0) / 4) < 1e-12);
    CHECK(both.outcome.out.find("kink") == std::string::npos);
    CHECK(run_scene(springs + "[time]\nkinks = \"steps\"\n").outcome.status == 2);
    CHECK(run_scene(springs + ends, "--lyapunov").outcome.status == 2);
}

TEST_CASE("rows at given times, of a run that stays what it is") {
    const SceneRun plain = run_scene(planet_of_half),
                   found = run_scene(planet_of_half, "--times 0:2*pi:9 --until 20*pi");
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.table.size() == 10);
    for (std::size_t k = 0; k < 9; ++k) {
        const std::vector<double> row = numbers_of(found.table[k + 1]);
        CHECK(std::abs(row[0] - static_cast<double>(k) * pi / 4) < 1e-15);
        CHECK(std::abs(row[1] * row[4] - row[2] * row[3] - std::sqrt(0.75)) < 1e-14);
    }
    CHECK(std::abs(numbers_of(found.table[5])[1] + 1.5) < 1e-9);
    CHECK(found.table[1] == plain.table[1]);
    // The run ends where the last time is; a part of a step leads to it.
    const SceneRun alone = run_scene(spring, "--times 1/4:pi:2");
    REQUIRE(alone.outcome.status == 0);
    REQUIRE(alone.table.size() == 3);
    CHECK(std::abs(numbers_of(alone.table[1])[1] - std::cos(0.25)) < 1e-14);
    CHECK(std::abs(numbers_of(alone.table[2])[1] + 1) < 1e-12);
    const SceneRun one = run_scene(spring, "--times 1:5:1");
    REQUIRE(one.table.size() == 2);
    CHECK(numbers_of(one.table[1])[0] == 1);
    const SceneRun back = run_scene(spring, "--step=-1/10 --times=0:-1:3");
    INFO(back.outcome.err);
    REQUIRE(back.table.size() == 4);
    CHECK(numbers_of(back.table[3])[0] == -1);
    CHECK(std::abs(numbers_of(back.table[3])[1] - std::cos(1)) < 1e-13);
}

TEST_CASE("a row in so many steps") {
    const SceneRun found = run_scene(spring, "--every 30 --until 10");
    REQUIRE(found.table.size() == 6);  // at 0, 3, 6, 9 and where it ends
    CHECK(numbers_of(found.table[2])[0] == 3);
    CHECK(numbers_of(found.table.back())[0] == 10);
}

TEST_CASE("events where sums stay loops are those where they are written out") {
    const std::string row = "hamiltonian = \"sum(i=1..N, p[i]^2/2 + w[i]^2*q[i]^2/2)\"\n"
                            "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
                            "parameters = {N = 6, w = [1, 2, 3, 4, 5, 6], level = \"1/2\"}\n"
                            "initial = {\"q[i]\" = 1, \"p[i]\" = 0}\n"
                            "run = {method = \"gauss:6\", step = \"1/20\", until = 4}\n"
                            "[events.third]\nzero = \"q[3] - level\"\ncooldown = \"level/100\"\n"
                            "[events.all]\nzero = \"sum(i=1..N, q[i])\"\ndirection = \"down\"\n"
                            "[events.two]\nzero = \"w[2]*q[2] + p[N] + t - 2\"\n"
                            "[events.turn]\nzero = \"atan2(p[1], q[1]) + 3\"\nperiod = \"2*pi\"\n"
                            "[events.flip]\nzero = \"t - 1\"\n"
                            "set = {\"p[i]\" = \"-p[i]*i\", q = [1, 1, 1, 1, 1, \"q[6]\"]}\n";
    const SceneRun out = run_scene(row, "--unroll yes"), loops = run_scene(row, "--unroll no");
    INFO(loops.outcome.err);
    REQUIRE(loops.outcome.status == 0);
    REQUIRE(out.events.size() > 15);
    REQUIRE(loops.events.size() == out.events.size());
    CHECK(loops.events[0] == out.events[0]);
    for (std::size_t k = 0; k + 1 < out.events.size(); ++k) {
        CHECK(loops.events[k + 1].substr(0, 4) == out.events[k + 1].substr(0, 4));
        const std::vector<double> a = out.event(k), b = loops.event(k);
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(std::abs(a[i] - b[i]) < 1e-12);
    }
    CHECK(std::abs(loops.event(0)[0] - pi / 9) < 1e-12);
    const SceneRun other = run_scene(row, "--unroll no --param level=0 --until 3/5");
    REQUIRE(other.events.size() > 2);
    CHECK(std::abs(other.event(1)[0] - pi / 6) < 1e-12);
}

TEST_CASE("events of a thousand, and the columns of their table") {
    const std::string many = "coordinates = [\"q[1..N]\"]\nparameters = {N = 1000}\n"
                             "run = {method = \"gauss:6\", step = \"1/20\", until = 7}\n"
                             "[events.one]\nzero = \"q[500]\"\ndirection = \"down\"\n"
                             "[events.all]\nzero = \"sum(i=1..N, q[i])\"\nstop = 2\n";
    const std::string of_H = "hamiltonian = \"sum(i=1..N, p[i]^2/2 + q[i]^2/2)\"\n"
                             "momenta = [\"p[1..N]\"]\n"
                             "initial = {\"q[i]\" = \"cos(i)\", \"p[i]\" = \"sin(i)\"}\n" +
                             many;
    const std::string of_L = "lagrangian = \"sum(i=1..N, v[i]^2/2 - q[i]^2/2)\"\n"
                             "velocities = [\"v[1..N]\"]\n"
                             "initial = {\"q[i]\" = \"cos(i)\", \"v[i]\" = \"sin(i)\"}\n" +
                             many;
    // q[i] is cos(t - i), and the sum of all goes through 0 each half period.
    double x = 0, y = 0;
    for (int i = 1; i <= 1000; ++i) {
        x += std::cos(i);
        y += std::sin(i);
    }
    const double phase = std::atan2(y, x),
                 all = phase + pi / 2 < 0 ? phase + 1.5 * pi : phase + pi / 2,
                 first = all - pi > 0 ? all - pi : all;
    for (const std::string& scene : {of_H, of_L}) {
        const SceneRun found = run_scene(scene, "--columns q[7],energy,q[500]");
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        REQUIRE(found.events.size() == 4);
        CHECK(found.events[0] == "event,number,t,q[7],q[500]");
        CHECK(std::abs(found.event(0)[0] - first) < 1e-11);
        CHECK(std::abs(found.event(0)[1] - std::cos(first - 7)) < 1e-11);
        CHECK(std::abs(found.event(1)[0] - (500 + pi / 2 - 158 * pi)) < 1e-11);
        CHECK(std::abs(found.event(1)[2]) < 1e-11);
        CHECK(std::abs(found.event(2)[0] - first - pi) < 1e-11);
        CHECK(found.last()[0] == found.event(2)[0]);
    }
}

// q[i] is sin(t), p[i] is cos(t), and no force is between neighbours. Both places of each event are
// in one step.
TEST_CASE("two events in one step are found where sums stay loops, up to a size") {
    const std::string ring =
        "hamiltonian = \"sum(i=1..N, p[i]^2/2 + q[i]^2/2 + (q[i] - q[mod(i, N) + 1])^2/2)\"\n"
        "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
        "initial = {\"q[i]\" = 0, \"p[i]\" = 1}\n"
        "run = {method = \"gauss:6\", step = \"1/10\", until = 4}\n"
        "[events.high]\nzero = \"q[2] - 99995/100000\"\n"
        "[events.sum]\nzero = \"sum(i=1..N, q[i]) - N*99995/100000\"\n"
        "[events.slow]\nzero = \"p[N] + 99995/100000\"\n"
        "[events.time]\nzero = \"(t - 31/20)^2 - 1/1000000\"\n";
    const auto words_of = [](int n) { return "--unroll no --param N=" + std::to_string(n); };
    const SceneRun found = run_scene(ring + "[parameters]\nN = 300\n", words_of(300));
    INFO(found.outcome.err);
    REQUIRE(found.outcome.status == 0);
    REQUIRE(found.events.size() == 9);
    const double width = std::acos(0.99995);
    const auto check = [&](std::size_t k, const std::string& name, double t) {
        CHECK(found.events[k + 1].rfind(name, 0) == 0);
        CHECK(std::abs(found.event(k)[0] - t) < 1e-10);
    };
    check(0, "time,1,", 1.549);
    check(1, "time,2,", 1.551);
    CHECK(std::abs(found.event(2)[0] - (pi / 2 - width)) < 1e-10);
    CHECK(std::abs(found.event(3)[0] - (pi / 2 - width)) < 1e-10);
    CHECK(std::abs(found.event(4)[0] - (pi / 2 + width)) < 1e-10);
    CHECK(std::abs(found.event(5)[0] - (pi / 2 + width)) < 1e-10);
    check(6, "slow,1,", pi - width);
    check(7, "slow,2,", pi + width);
    // H is too long here to be written out.
    const SceneRun large = run_scene(ring + "[parameters]\nN = 8000\n", words_of(8000));
    INFO(large.outcome.err);
    CHECK(large.outcome.status == 0);
    CHECK(large.events.size() == 1);
}

// q = sin(t) by its Lagrangian; a turning point is where v = cos(t) is zero.
TEST_CASE("events of a Lagrangian, of its velocities, and two in one step") {
    const std::string run = "run = {method = \"gauss:8\", step = \"1/10\", until = 4}\n";
    const std::string one = "lagrangian = \"2*v^2 - 2*q^2 + 3*q*v\"\ncoordinates = [\"q\"]\n"
                            "velocities = [\"v\"]\ninitial = {q = 0, v = 1}\n" +
                            run +
                            "[events.high]\nzero = \"q - 99995/100000\"\n"
                            "[events.slow]\nzero = \"v + 99995/100000\"\n"
                            "[events.turn]\nzero = \"v\"\n";
    const std::string many = "lagrangian = \"sum(i=1..N, i*v[i]^2/2 - i*q[i]^2/2)\"\n"
                             "coordinates = [\"q[1..N]\"]\nvelocities = [\"v[1..N]\"]\n"
                             "parameters = {N = 300}\ninitial = {\"q[i]\" = 0, \"v[i]\" = 1}\n" +
                             run +
                             "[events.high]\nzero = \"q[7] - 99995/100000\"\n"
                             "[events.slow]\nzero = \"v[8] + 99995/100000\"\n"
                             "[events.turn]\nzero = \"v[9]\"\n";
    const double width = std::acos(0.99995);
    for (const std::string& scene : {one, many}) {
        const SceneRun found = run_scene(scene);
        INFO(found.outcome.err);
        REQUIRE(found.outcome.status == 0);
        REQUIRE(found.events.size() == 6);
        const auto check = [&](std::size_t k, const std::string& name, double t) {
            CHECK(found.events[k + 1].rfind(name, 0) == 0);
            CHECK(std::abs(found.event(k)[0] - t) < 1e-10);
        };
        check(0, "high,1,", pi / 2 - width);
        check(1, "turn,1,", pi / 2);
        check(2, "high,2,", pi / 2 + width);
        check(3, "slow,1,", pi - width);
        check(4, "slow,2,", pi + width);
    }
}

TEST_CASE("events of lists in files, where sums stay loops") {
    use_cache();
    const Directory directory;
    std::string values = "w\n";
    for (int i = 1; i <= 300; ++i) values += std::to_string(i) + "\n";
    write(directory / "w.csv", values);
    write(directory / "scene.toml",
          "hamiltonian = \"sum(i=1..N, p[i]^2/2 + w[i]*q[i]^2/200)\"\n"
          "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
          "parameters = {N = 300, w = {file = \"w.csv\", column = \"w\"}}\n"
          "initial = {\"q[i]\" = \"1\", \"p[i]\" = 0}\n"
          "run = {method = \"gauss:6\", step = \"1/20\", until = 2}\n"
          "[events.one]\nzero = \"q[225] - w[50]/100\"\nstop = true\n");
    const SceneRun found = run_words_in(directory, "scene.toml");
    INFO(found.outcome.err);
    REQUIRE(found.events.size() == 2);
    // cos(3/2 t) = 1/2
    CHECK(std::abs(found.event(0)[0] - pi / 4.5) < 1e-12);
}

TEST_CASE("events that loops do not have are refused with their place") {
    const auto refused = [&](const std::string& more, const std::string& message,
                             const std::string& words = "") {
        const SceneRun found = run_scene(
            "hamiltonian = \"sum(i=1..N, p[i]^2/2 + abs(q[i]))\"\n"
            "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\nparameters = {N = 400}\n"
            "initial = {\"q[i]\" = 1, \"p[i]\" = 0}\n"
            "run = {method = \"stormer-verlet\", step = \"1/20\", until = 1}\n" +
                more,
            words);
        CAPTURE(more, found.outcome.err);
        CHECK(found.outcome.status == 2);
        CHECK(found.outcome.err.find(message) != std::string::npos);
        CHECK(found.table.empty());
    };
    const std::string wall = "[events.wall]\nzero = \"q[1]\"\n";
    refused("[time]\nkinks = \"events\"\n", "steps that end at kinks are not built where sums");
    refused(wall + "canonical = true\nset = {\"p[i]\" = \"-p[i]\"}\n",
            "no jump is proved to be symplectic where sums stay loops");
    refused("[events.wall]\nzero = \"q[401]\"\n", "there is no `q[401]`");
    refused("[events.wall]\nzero = \"q[1,1]\"\n", "there is no `q[1,1]`");
    refused("[events.wall]\nzero = \"q\"\n", "there is no `q`");
    refused("[events.wall]\nzero = \"r[1]\"\n", "`r");
    refused("[events.wall]\nzero = \"sum(i=1..N, j=1..N, q[i]*q[j])\"\n",
            "the sums expand to more than 100000 words");
    refused(wall + "set = {p = [1, 2]}\n", "a list of 400 values");
    refused(wall + "set = {p = 1}\n", "a list of 400 values");
    refused(wall + "set = {N = 1}\n", "`N` is no variable");
    refused(wall + "set = {\"p[i,j]\" = 1}\n", "`p`");
    refused(wall + "cooldown = -1\n", "this is negative");
    refused(wall + "period = \"q[1]\"\n", "a period cannot depend on the variable");
    refused(wall + "set = {\"p[i]\" = \"-p[i]\"}\n", "events that jump", "--lyapunov");
    // An L of more than 100 000 words.
    const SceneRun found = run_scene("lagrangian = \"sum(i=1..N, v[i]^2/2 - q[i]^2/2)\"\n"
                                     "coordinates = [\"q[1..N]\"]\nvelocities = [\"v[1..N]\"]\n"
                                     "parameters = {N = 20000}\n"
                                     "initial = {\"q[i]\" = 1, \"v[i]\" = 0}\n"
                                     "run = {method = \"gauss:2\", step = \"1/20\", until = 1}\n"
                                     "[events.rest]\nzero = \"v[3]\"\n");
    CHECK(found.outcome.status == 2);
    CHECK(found.outcome.err.find("here events of a Lagrangian are functions of coordinates and") !=
          std::string::npos);
}

TEST_CASE("times and events that are none are refused with their place") {
    const auto refused = [&](const std::string& scene, const std::string& words,
                             const std::string& message) {
        const SceneRun found = run_scene(scene, words);
        CAPTURE(words, scene, found.outcome.err);
        CHECK(found.outcome.status == 2);
        CHECK(found.outcome.err.find(message) != std::string::npos);
        CHECK(found.table.empty());
    };
    refused(spring, "--times 0:10", "FROM:TO:COUNT is wanted here");
    refused(spring, "--times 0:10:0", "a whole number from 1 to 10000000 is wanted here");
    refused(spring, "--times 0:10:x", "a whole number from 1 to 10000000 is wanted here");
    refused(spring, "--times=-1:10:3", "the run begins at t = 0");
    refused(spring, "--times 10:5:3", "these times lead against the steps");
    refused(spring, "--times 0:30:3 --until 20", "the run ends at t = 20");
    refused(spring, "--times 0:q:3", "the scene has no parameter `q`");
    refused(spring, "--times 0:10:3 --every 2", "--times sets the rows");
    refused(spring, "--every 0", "--every");
    const auto event = [&](const std::string& lines, const std::string& message) {
        refused(spring + "[events.wall]\n" + lines, "", message);
    };
    event("direction = \"up\"\n", "this event does not say where it is");
    event("zero = \"r\"\n", "`r`");
    event("zero = \"q\"\ndirection = \"left\"\n", "this is no direction");
    event("zero = \"q\"\nstop = 0\n", "true, or which of the events ends the run");
    event("zero = \"q\"\nset = {}\n", "this says nothing of what jumps");
    event("zero = \"q\"\nset = {s = 1}\n", "`s`");
    event("zero = \"q\"\nset = {p = \"1 +\"}\n", "scene.toml");
    event("zero = \"q\"\ncooldown = -1\n", "this is negative");
    event("zero = \"q\"\nperiod = \"q\"\n", "a period cannot depend on the variable `q`");
    event("zero = \"q\"\ncanonical = 1\n", "true or false is wanted here");
    event("zero = \"q\"\nwhen = 1\n", "`when`");
    refused(spring + "[events]\nwall = \"q\"\n", "", "this event does not say where it is");
    refused("events = 1\n" + spring, "", "`events` is no section");
}

TEST_CASE("events have a picture") {
    use_cache();
    const Directory directory;
    write(directory / "scene.toml",
          "name = \"star\"\n"
          "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
          "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
          "initial = {x = 0, y = \"1/10\", px = \"1/2\", py = 0}\n"
          "run = {method = \"stormer-verlet\", step = \"1/20\", until = 200}\n"
          "[events.through]\nzero = \"x\"\n[events.far]\nzero = \"x - 100\"\n");
    const auto run = [&](const std::string& words) {
        const Outcome outcome =
            shell("exec \"$hvi_gen\" run scene.toml " + words, directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
    };
    run("-o first");
    run("-o second");
    // The picture of x = 0 shows the first other coordinate and its momentum, and nothing of what
    // is far.
    const std::string picture = contents(directory / "first" / "events.svg");
    CHECK(picture == contents(directory / "second" / "events.svg"));
    CHECK(picture.find(">y<") != std::string::npos);
    CHECK(picture.find(">py<") != std::string::npos);
    CHECK(picture.find("far") == std::string::npos);
    std::size_t marks = 0;
    for (std::size_t at = 0; (at = picture.find("xlink:href='#gpPt6'", at)) != std::string::npos;
         ++at)
        ++marks;
    const std::vector<std::string> rows = lines_of(contents(directory / "first" / "events.csv"));
    CHECK(marks == rows.size() - 1);
    run("-o bare --only table");
    CHECK_FALSE(std::filesystem::exists(directory / "bare" / "events.svg"));
    run("-o early --until 1/10");
    CHECK_FALSE(std::filesystem::exists(directory / "early" / "events.svg"));
}
