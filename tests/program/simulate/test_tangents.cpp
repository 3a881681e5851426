// The derivative of the flow, Lyapunov exponents and indicators of chaos.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

std::string one_degree(const std::string& H, const std::string& q, const std::string& p) {
    return "hamiltonian = \"" + H + "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n" +
           "initial = {q = \"" + q + "\", p = \"" + p + "\"}\n" +
           "run = {method = \"gauss:4\", step = \"1/10\", until = 10}\n";
}

/// A star in a galaxy; the start is moved by parameters.
const std::string star = "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
                         "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                         "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
                         "initial = {x = \"a\", y = \"1/10 + b\", px = \"1/2 + c\", py = \"d\"}\n"
                         "invariants = {twice = \"2*x\"}\n"
                         "run = {method = \"gauss:4\", step = \"1/10\", until = 20}\n";

}  // namespace

TEST_CASE("the derivative of the oscillator's steps is their matrix") {
    const SceneRun found = run_scene(one_degree("(p^2 + q^2)/2", "1/3", "1/5"),
                                     "--tangent --method midpoint --until 3");
    // The midpoint rule turns by 2 atan(h/2) in each step.
    const double angle = 30 * 2 * std::atan(0.05), c = std::cos(angle), s = std::sin(angle);
    REQUIRE(found.tangent.size() == 2);
    CHECK(std::abs(found.tangent[0][0] - c) < 1e-14);
    CHECK(std::abs(found.tangent[0][1] - s) < 1e-14);
    CHECK(std::abs(found.tangent[1][0] + s) < 1e-14);
    CHECK(std::abs(found.tangent[1][1] - c) < 1e-14);
}

TEST_CASE("multipliers are the eigenvalues of the derivative") {
    const SceneRun hill = run_scene(one_degree("(p^2 - q^2)/2", "0", "0"), "--tangent --until 1");
    REQUIRE(hill.said("multipliers").size() == 2);
    CHECK(hill.said("multipliers")[0] == Approx(std::exp(1)).epsilon(1e-5));
    CHECK(hill.said("multipliers")[1] == Approx(std::exp(-1)).epsilon(1e-5));
    // The midpoint rule turns by 2 atan(h/2) in each of 20 steps.
    const SceneRun swing =
        run_scene(one_degree("(p^2 + q^2)/2", "1", "0"), "--tangent --method midpoint --until 2");
    CHECK(swing.outcome.out.find("-0.414633+0.909989i -0.414633-0.909989i") != std::string::npos);
}

TEST_CASE("the derivative of a run that an event ends is that of its end") {
    // (p^2 + q^2)/2 from q = 1, p = 0 turns to q = 0 at t = pi/2, in the middle of a step.
    const SceneRun found =
        run_scene(one_degree("(p^2 + q^2)/2", "1", "0") + "[events.through]\nzero = \"q\"\nstop = 1\n",
                  "--tangent --method gauss:8");
    REQUIRE(found.tangent.size() == 2);
    CHECK(std::abs(found.tangent[0][0]) < 1e-13);
    CHECK(std::abs(found.tangent[0][1] - 1) < 1e-13);
    CHECK(std::abs(found.tangent[1][0] + 1) < 1e-13);
    CHECK(std::abs(found.tangent[1][1]) < 1e-13);
}

TEST_CASE("the end is differentiated by parameters") {
    const std::string spring = "hamiltonian = \"(p^2 + w^2*q^2)/2\"\n"
                               "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                               "parameters = {w = \"3/2\", a = 2}\n"
                               "initial = {q = \"a^2\", p = 0}\n"
                               "run = {method = \"gauss:8\", step = \"1/10\", until = 3}\n";
    const SceneRun found = run_scene(spring, "--sensitivity 'w, a'");
    REQUIRE(found.sensitivity.size() == 3);
    CHECK(found.sensitivity[0] == "parameter,q,p");
    // q = a^2 cos(w t), p = -a^2 w sin(w t)
    const double w = 1.5, a = 2, t = 3, c = std::cos(w * t), s = std::sin(w * t);
    const auto by_w = numbers_of(found.sensitivity[1].substr(2));
    const auto by_a = numbers_of(found.sensitivity[2].substr(2));
    REQUIRE(by_w.size() == 2);
    CHECK(by_w[0] == Approx(-a * a * t * s).epsilon(1e-12));
    CHECK(by_w[1] == Approx(-a * a * (s + w * t * c)).epsilon(1e-12));
    CHECK(by_a[0] == Approx(2 * a * c).epsilon(1e-12));
    CHECK(by_a[1] == Approx(-2 * a * w * s).epsilon(1e-12));
}

TEST_CASE("derivatives by parameters are those of runs with other values") {
    const std::vector<std::pair<std::string, std::string>> all = {
        // A Hamiltonian with sums in a function, a Lagrangian, and loops.
        {"hamiltonian = \"(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2) + mu^2*x*py/9\"\n"
         "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {mu = 1}\n"
         "initial = {x = 1, y = 0, px = 0, py = \"sqrt(mu)\"}\n",
         "--method gauss:4"},
        {"lagrangian = \"(1 + mu*x^2)*vx^2/2 - mu*x^4\"\ncoordinates = [\"x\"]\n"
         "velocities = [\"vx\"]\nparameters = {mu = 1}\ninitial = {x = \"mu\", vx = \"mu/2\"}\n",
         "--method gauss:4"},
        {"hamiltonian = \"sum(i=1..4, p[i]^2/2) + sum(i=1..3, mu*(q[i+1] - q[i])^4)\"\n"
         "coordinates = [\"q[1..4]\"]\nmomenta = [\"p[1..4]\"]\nparameters = {mu = 1}\n"
         "initial = {\"q[i]\" = \"mu*sin(i)\", \"p[i]\" = 0}\n",
         "--method stormer-verlet --unroll no"},
    };
    const double by = 1e-5;
    for (const auto& [text, how] : all) {
        CAPTURE(text);
        const std::string scene = text + "run = {step = \"1/50\", until = 2}\n";
        const SceneRun found = run_scene(scene, "--sensitivity mu " + how);
        INFO(found.outcome.err);
        REQUIRE(found.sensitivity.size() == 2);
        const auto derivative = numbers_of(found.sensitivity[1].substr(3));
        const auto up = run_scene(scene, how + " --param mu=1.00001").last();
        const auto down = run_scene(scene, how + " --param mu=0.99999").last();
        for (std::size_t k = 0; k < derivative.size(); ++k)
            CHECK(derivative[k] == Approx((up[1 + k] - down[1 + k]) / (2 * by)).epsilon(1e-6));
    }
}

TEST_CASE("parameters that are none are refused") {
    const auto refused = [](const std::string& names, const std::string& reason) {
        const SceneRun found = run_scene(star, "--sensitivity '" + names + "'");
        CAPTURE(names, found.outcome.err);
        CHECK(found.outcome.status == 2);
        CHECK(found.outcome.err.find(reason) != std::string::npos);
        CHECK(found.table.empty());
    };
    refused("a, e", "there is no parameter `e` to differentiate by");
    refused("a, x", "there is no parameter `x`");
    refused("a,", "a name is wanted here");
    refused("a, b, a", "`a` is named twice");
    refused("", "--sensitivity");
}

TEST_CASE("the derivative is that of runs from starts nearby") {
    const double by = 1e-5;
    for (const std::string how : {"--method stormer-verlet", "--method gauss:4",
                                  "--method stormer-verlet --compose suzuki:4",
                                  "--method lobatto:3 --interpret", "--method midpoint"}) {
        CAPTURE(how);
        const SceneRun found = run_scene(star, "--tangent " + how);
        REQUIRE(found.tangent.size() == 4);
        const std::vector<std::string> names{"a", "b", "c", "d"};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto end = [&](const std::string& value) {
                return run_scene(star, how + " --param " + names[k] + "=" + value).last();
            };
            const auto up = end("1/100000"), down = end("-1/100000");
            for (std::size_t i = 0; i < 4; ++i) {
                const double difference = (up[1 + i] - down[1 + i]) / (2 * by);
                CHECK(std::abs(found.tangent[i][k] - difference) < 1e-6);
            }
        }
    }
}

TEST_CASE("directions that share stages are those of the motion together with a direction") {
    // NOTE: what is interpreted has a (q, p) of its own for each.
    for (const std::string how :
         {"--method stormer-verlet", "--method stormer-verlet --compose suzuki:4",
          "--method gauss:4", "--method lobatto:3"}) {
        CAPTURE(how);
        const std::string words = "--tangent --lyapunov=spectrum --until 199/20 " + how;
        const SceneRun one = run_scene(star, words);
        const SceneRun other = run_scene(star, words + " --interpret");
        REQUIRE(one.tangent.size() == 4);
        REQUIRE(other.tangent.size() == 4);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                CHECK(std::abs(one.tangent[i][k] - other.tangent[i][k]) < 1e-12);
    }
}

TEST_CASE("the derivative stays symplectic over a hundred thousand steps") {
    for (const std::string how : {"--method stormer-verlet", "--method gauss:4"}) {
        const SceneRun found = run_scene(star, "--tangent --step 1/20 --until 5000 " + how);
        double largest = 0, off = 0;
        for (const auto& row : found.tangent)
            for (const double entry : row) largest = std::max(largest, std::abs(entry));
        // J on columns: q with p.
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a + 1; b < 4; ++b) {
                double form = b == a + 2 ? -1 : 0;
                for (std::size_t k = 0; k < 2; ++k)
                    form += found.tangent[k][a] * found.tangent[k + 2][b] -
                            found.tangent[k + 2][a] * found.tangent[k][b];
                off = std::max(off, std::abs(form));
            }
        CAPTURE(how, largest, off);
        CHECK(off < 1e-11 * largest * largest);
        const double changed = found.last()[1] * 2 - found.last().back();
        CHECK(std::abs(changed) < 1e-15);  // the invariant of the scene is there
    }
}

TEST_CASE("exponents of an inverted pendulum are 1 and -1") {
    const std::string hill = one_degree("(p^2 - q^2)/2", "0", "0");
    const SceneRun found = run_scene(hill, "--lyapunov=spectrum --sali");
    REQUIRE(found.said("lyapunov").size() == 2);
    CHECK(found.said("lyapunov")[0] == Approx(1).epsilon(0.05));
    CHECK(found.said("lyapunov")[1] == Approx(-1).epsilon(0.05));
    CHECK(found.said("lyapunov")[0] + found.said("lyapunov")[1] == Approx(0).margin(1e-5));
    // Two directions come together as exp(-2 t).
    REQUIRE(found.said("sali").size() == 1);
    CHECK(found.said("sali")[0] < 10 * std::exp(-20));
    CHECK(found.said("sali")[0] > std::exp(-20) / 100);
    const SceneRun later = run_scene(hill, "--lyapunov --until 1000");
    CHECK(later.said("lyapunov").front() == Approx(1).epsilon(1e-3));
    // MEGNO grows as exponent times time over 2.
    CHECK(later.said("megno").front() == Approx(500).epsilon(0.01));
}

TEST_CASE("MEGNO is 2 where neighbours part with the time, and 0 where they stay") {
    const SceneRun shear = run_scene(one_degree("p^4/4", "0", "1"), "--megno --until 2000");
    CHECK(shear.said("megno").front() == Approx(2).epsilon(0.02));
    const SceneRun swing = run_scene(one_degree("(p^2 + q^2)/2", "1", "0"), "--megno --until 2000");
    CHECK(std::abs(swing.said("megno").front()) < 0.02);
    const SceneRun sali = run_scene(one_degree("(p^2 + q^2)/2", "1", "0"), "--sali");
    CHECK(sali.said("sali").front() > 0.1);
}

TEST_CASE("a chaotic and a regular star") {
    // Both have the energy 1/8: Henon & Heiles 1964, figures 5 and 6.
    const auto exponent = [](const std::string& y, const std::string& py) {
        const std::string scene =
            "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
            "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
            "initial = {x = 0, y = \"" +
            y + "\", px = \"sqrt(1/4 - (" + py + ")^2 - (" + y + ")^2 + 2*(" + y +
            ")^3/3)\", py = \"" + py +
            "\"}\n"
            "run = {method = \"stormer-verlet\", step = \"1/20\", until = 20000}\n";
        return run_scene(scene, "--lyapunov");
    };
    const SceneRun chaotic = exponent("-1/4", "0"), regular = exponent("3/10", "0");
    CAPTURE(chaotic.outcome.out, regular.outcome.out);
    CHECK(chaotic.said("lyapunov").front() > 0.02);
    CHECK(chaotic.said("lyapunov").front() < 0.08);
    CHECK(chaotic.said("megno").front() > 100);
    CHECK(regular.said("lyapunov").front() < 2e-3);
    CHECK(regular.said("megno").front() == Approx(2).epsilon(0.05));
}

TEST_CASE("the derivative of the steps of a Lagrangian is by coordinates and momenta") {
    // A mass that depends on q: p = (1 + q^2) v. Its start is moved by parameters of q and p.
    const std::string track = "lagrangian = \"(1 + q^2)*v^2/2 - q^2/2 - q^3/3\"\n"
                              "coordinates = [\"q\"]\nvelocities = [\"v\"]\n"
                              "parameters = {a = 0, b = 0}\n"
                              "initial = {q = \"1/3 + a\", v = \"(1/5 + b)/(1 + (1/3 + a)^2)\"}\n"
                              "run = {method = \"gauss:4\", step = \"1/10\", until = 5}\n";
    const double by = 1e-5;
    for (const std::string how : {"--method gauss:4", "--method gauss:2 --compose suzuki:4"}) {
        CAPTURE(how);
        const SceneRun found = run_scene(track, "--tangent " + how);
        INFO(found.outcome.err);
        REQUIRE(found.tangent.size() == 2);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto end = [&](const std::string& value) {
                return run_scene(track, how + " --param " + (k == 0 ? "a=" : "b=") + value).last();
            };
            const auto up = end("1/100000"), down = end("-1/100000");
            for (std::size_t i = 0; i < 2; ++i)
                CHECK(std::abs(found.tangent[i][k] - (up[1 + i] - down[1 + i]) / (2 * by)) < 1e-8);
        }
        const auto& D = found.tangent;
        CHECK(std::abs(D[0][0] * D[1][1] - D[0][1] * D[1][0] - 1) < 1e-12);
    }
}

TEST_CASE("directions of a Lagrangian are those of its Hamiltonian") {
    // A spring with a mass of 3, by both; gauss:3 has the same steps for both.
    const std::string more = "initial = {q = \"1/3\", VELOCITY = \"MOMENTUM\"}\n"
                             "run = {method = \"gauss:3\", step = \"1/10\", until = 20}\n";
    const auto scene = [&](const std::string& text, const std::string& name,
                           const std::string& value) {
        std::string end = more;
        end.replace(end.find("VELOCITY"), 8, name);
        end.replace(end.find("MOMENTUM"), 8, value);
        return text + end;
    };
    const std::string by_L =
        scene("lagrangian = \"3*v^2/2 + cos(q) + q^2/8\"\ncoordinates = [\"q\"]\n"
              "velocities = [\"v\"]\n",
              "v", "1/15");
    const std::string by_H =
        scene("hamiltonian = \"p^2/6 - cos(q) - q^2/8\"\ncoordinates = [\"q\"]\n"
              "momenta = [\"p\"]\n",
              "p", "1/5");
    const std::string words = "--tangent --lyapunov --megno --sali";
    const SceneRun L = run_scene(by_L, words), H = run_scene(by_H, words);
    INFO(L.outcome.err + H.outcome.err);
    REQUIRE(L.tangent.size() == 2);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(std::abs(L.tangent[i][k] - H.tangent[i][k]) < 1e-11);
    for (const std::string name : {"lyapunov", "megno", "sali"}) {
        CAPTURE(name);
        REQUIRE(L.said(name).size() == 1);
        CHECK(L.said(name).front() == Approx(H.said(name).front()).epsilon(1e-4));
    }
    // A hill: the exponents are 1 and -1.
    const SceneRun hill =
        run_scene("lagrangian = \"(v^2 + q^2)/2\"\ncoordinates = [\"q\"]\nvelocities = [\"v\"]\n"
                  "initial = {q = 0, v = 0}\n"
                  "run = {method = \"gauss:4\", step = \"1/10\", until = 10}\n",
                  "--lyapunov=spectrum");
    REQUIRE(hill.said("lyapunov").size() == 2);
    CHECK(hill.said("lyapunov")[0] == Approx(1).epsilon(0.05));
    CHECK(hill.said("lyapunov")[1] == Approx(-1).epsilon(0.05));
}

TEST_CASE("directions where sums stay loops are those where they are written out") {
    const std::string pairs = "hamiltonian = \"sum(i=1..N, px[i]^2 + py[i]^2)/2 - sum(i=1..N-1, "
                              "j=i+1..N, k[i]*k[j]/sqrt(1 + (x[i]-x[j])^2 + (y[i]-y[j])^2))\"\n"
                              "coordinates = [\"x[1..N]\", \"y[1..N]\"]\n"
                              "momenta = [\"px[1..N]\", \"py[1..N]\"]\n"
                              "parameters = {N = 4, k = [1, 2, 3, 4]}\n"
                              "initial = {\"x[i]\" = \"i\", \"y[i]\" = \"sin(i)\", "
                              "\"px[i]\" = 0, py = [1, 0, \"1/2\", 0]}\n"
                              "run = {method = \"gauss:3\", step = \"1/20\", until = 2}\n";
    // Sums in products and in functions, and the time.
    const std::string totals =
        "hamiltonian = \"sum(i=1..N, p[i]^2)/2*(1 + sum(i=1..N, q[i]^2)/10) + sqrt(1 + "
        "sum(i=1..N-1, "
        "(q[i+1]-q[i])^2))*sum(i=1..N, i*q[i]^2) + sin(t)*q[1]\"\n"
        "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\nparameters = {N = 5}\n"
        "initial = {\"q[i]\" = \"sin(i)\", \"p[i]\" = \"cos(i)/2\"}\n"
        "run = {method = \"gauss:3\", step = \"1/40\", until = 2}\n";
    const std::string of_L = "lagrangian = \"sum(i=1..N, m[i]*v[i]^2)/2 - sum(i=1..N-1, "
                             "(q[i+1]-q[i])^4/4) - q[1]^2/2\"\n"
                             "coordinates = [\"q[1..N]\"]\nvelocities = [\"v[1..N]\"]\n"
                             "parameters = {N = 4, m = [1, 2, 1, 2]}\n"
                             "initial = {\"q[i]\" = \"sin(i)\", \"v[i]\" = \"cos(i)/2\"}\n"
                             "run = {method = \"stormer-verlet\", step = \"1/20\", until = 2}\n";
    const std::string chain = "fpu-chain --param N=8 --until 20";
    const auto of = [](const std::string& scene, const std::string& words) {
        return scene.find("hamiltonian") == 0 || scene.find("lagrangian") == 0
                   ? run_scene(scene, words)
                   : run_words(scene + " " + words);
    };
    const std::vector<std::pair<std::string, std::string>> all{
        {chain, ""}, {chain, "--method gauss:4"}, {pairs, ""}, {totals, ""}, {of_L, ""}};
    for (const auto& [scene, how] : all) {
        const std::string words = how + " --tangent --lyapunov --sali --unroll ";
        const SceneRun out = of(scene, words + "yes"), loops = of(scene, words + "no");
        CAPTURE(scene, how, loops.outcome.err);
        REQUIRE(out.tangent.size() >= 8);
        REQUIRE(out.tangent.size() == loops.tangent.size());
        for (std::size_t i = 0; i < out.tangent.size(); ++i)
            for (std::size_t k = 0; k < out.tangent.size(); ++k)
                CHECK(std::abs(out.tangent[i][k] - loops.tangent[i][k]) < 1e-12);
        for (const std::string name : {"lyapunov", "megno", "sali"})
            CHECK(loops.said(name).front() == Approx(out.said(name).front()).epsilon(1e-5));
    }
}

TEST_CASE("a thousand hills have the exponent of one") {
    const std::string hills = "hamiltonian = \"sum(i=1..N, (p[i]^2 - q[i]^2)/2)\"\n"
                              "coordinates = [\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
                              "parameters = {N = 1000}\ninitial = {\"q[i]\" = 0, \"p[i]\" = 0}\n"
                              "run = {method = \"gauss:4\", step = \"1/10\", until = 1000}\n";
    const SceneRun found = run_scene(hills, "--lyapunov --megno");
    INFO(found.outcome.err);
    CHECK(found.said("lyapunov").front() == Approx(1).epsilon(1e-3));
    CHECK(found.said("megno").front() == Approx(500).epsilon(0.01));
    // Each of the hills has another direction of its own, and they come together as exp(-2 t).
    const SceneRun sali = run_scene(hills, "--sali --until 10");
    CHECK(sali.said("sali").front() > 0.1);
}

TEST_CASE("directions that are not built are refused") {
    use_cache();
    const auto refused = [](const std::string& line, const std::string& message) {
        const Directory directory;
        write(directory / "scene.toml", star);
        const Outcome outcome =
            shell("exec \"$hvi_gen\" run " + line + " -o out", directory.path());
        CAPTURE(line, outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(message) != std::string::npos);
    };
    refused("scene.toml --lyapunov=all", "no such value of --lyapunov: `all`");
    refused("scene.toml --tangent=1", "--tangent takes no value");
    refused("fpu-chain --tangent --param N=257", "there are 257; it is built for at most 256");
    refused("fpu-chain --lyapunov=spectrum --unroll no",
            "--lyapunov=spectrum takes two directions");
    refused("fpu-chain --tangent --param N=300 --unroll yes", "at most 256");
}

TEST_CASE("an option with a choice behind = swallows no word") {
    use_cache();
    const Directory directory;
    write(directory / "scene.toml", star);
    const Outcome outcome =
        shell("exec \"$hvi_gen\" run --lyapunov scene.toml --only summary", directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("\nlyapunov ") != std::string::npos);
}
