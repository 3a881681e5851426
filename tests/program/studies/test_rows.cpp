// Rows of studies beside runs of their own, and beside closed forms.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/studies/study_run.hpp"

using namespace hvi::test;

namespace {

/// A spring whose start, steps and stiffness depend on a parameter in different ways.
const std::string spring =
    "hamiltonian = \"p^2/2 + b*q^2/2 + q^4/4\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
    "parameters = {a = \"1/3\", b = \"2*a\", c = 1}\n"
    "initial = {q = \"b + a/7\", p = \"sqrt(c)\"}\n"
    "run = {method = \"gauss:4\", step = \"a/10\", until = \"10*c\"}\n";

/// Checks that a row has the bits of a run with these values.
void check_row(const TextTable& rows, std::size_t row, const LastRow& run,
               const std::vector<std::string>& columns) {
    for (const std::string& column : columns) {
        CAPTURE(row, column);
        CHECK(rows.at(row, column) == run.at(column));
    }
}

}  // namespace

TEST_CASE("a row has the bits of a run with its parameters") {
    const TextTable rows = study_of(spring, "--vary a=0.1:0.7:3 --vary c=1:2:2 --lanes none");
    CHECK(rows.names == std::vector<std::string>{"row", "a", "c", "q", "p", "t", "status", "steps",
                                                 "energy_error"});
    REQUIRE(rows.rows.size() == 6);
    const std::vector<std::string> a{"0.1", "0.1", "0.4", "0.4", "0.7", "0.7"},
        c{"1", "2", "1", "2", "1", "2"};
    for (std::size_t row = 0; row < 6; ++row) {
        CHECK(rows.at(row, "row") == std::to_string(row));
        CHECK(rows.at(row, "a") == a[row]);
        CHECK(rows.at(row, "c") == c[row]);
        CHECK(rows.at(row, "status") == "ok");
        const LastRow run = run_of(spring, "--param a=" + a[row] + " --param c=" + c[row]);
        check_row(rows, row, run, {"q", "p", "t"});
    }
}

TEST_CASE("a row has the bits of a run with its start, step and end") {
    const TextTable rows =
        study_of(spring, "--vary q=0.2:0.3:2 --vary step=1/20:1/10:2 --vary until=3:5:2 "
                         "--lanes none");
    REQUIRE(rows.rows.size() == 8);
    CHECK(rows.names[1] == "q_0");
    for (std::size_t row = 0; row < 8; ++row) {
        std::string scene = spring;
        const std::string start = "q = \"b + a/7\"";
        scene.replace(scene.find(start), start.size(), "q = " + rows.at(row, "q_0"));
        const LastRow run =
            run_of(scene, "--step " + rows.at(row, "step") + " --until " + rows.at(row, "until"));
        check_row(rows, row, run, {"q", "p", "t"});
    }
}

TEST_CASE("a start that a row has of its own is not computed of its parameters") {
    const TextTable rows = study_of(spring, "--vary c=-1:1:2 --vary p=1:2:2 --until 1");
    REQUIRE(rows.rows.size() == 4);
    for (std::size_t row = 0; row < 4; ++row) {  // sqrt(-1) is no number
        CHECK(rows.at(row, "status") == "ok");
        std::string scene = spring;
        const std::string start = "p = \"sqrt(c)\"";
        scene.replace(scene.find(start), start.size(), "p = " + rows.at(row, "p_0"));
        check_row(rows, row, run_of(scene, "--until 1"), {"q", "p", "t"});
    }
}

TEST_CASE("columns of a row are what was varied, the state, and then what is asked for") {
    const TextTable rows =
        study_of(spring, "--vary c=1:2:2 --columns 'energy, q' --reduce 'min(q), mean(energy)'");
    CHECK(rows.names == std::vector<std::string>{"row", "c", "q", "p", "t", "status", "steps",
                                                 "energy_error", "energy", "min(q)",
                                                 "mean(energy)"});
    for (std::size_t row = 0; row < 2; ++row) {
        const LastRow run = run_of(spring, "--param c=" + rows.at(row, "c"));
        check_row(rows, row, run, {"q", "p", "t", "energy"});
        // H = p^2/2 + b q^2/2 + q^4/4 with b = 2/3.
        const double q = rows.number(row, "q"), p = rows.number(row, "p");
        CHECK(std::abs(rows.number(row, "energy") - (p * p / 2 + q * q / 3 + q * q * q * q / 4)) <
              1e-14);
        CHECK(rows.number(row, "min(q)") <= q);
    }
}

TEST_CASE("a row without a compiler has the bits of such a run") {
    const TextTable rows = study_of(spring, "--vary a=0.1:0.7:3 --interpret");
    check_row(rows, 1, run_of(spring, "--param a=0.4 --interpret"), {"q", "p", "t"});
}

TEST_CASE("rows of an oscillator are where the closed form of the method is") {
    // NOTE: q_n + i p_n/sqrt(1 - h^2/4) turns by 2 asin(h/2) in a step of Stormer and Verlet.
    const std::string scene =
        "hamiltonian = \"p^2/2 + q^2/2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
        "initial = {q = 1, p = 0}\n"
        "run = {method = \"stormer-verlet\", step = \"1/2\", until = 40}\n";
    for (const bool is_alone : {true, false}) {
        const TextTable rows =
            study_of(scene, std::string("--vary q=1:3:5 --vary step=1/4:1/2:2 --columns energy") +
                                (is_alone ? " --reduce 'max(q)'" : ""));
        REQUIRE(rows.rows.size() == 10);
        for (std::size_t row = 0; row < 10; ++row) {
            const double q = rows.number(row, "q_0"), h = rows.number(row, "step");
            const double turn = 2 * std::asin(h / 2), steps = 40 / h;
            CAPTURE(row, q, h, is_alone);
            CHECK(rows.number(row, "steps") == steps);
            CHECK(rows.number(row, "t") == 40);
            const double at_end = q * std::cos(turn * steps);
            CHECK(std::abs(rows.number(row, "q") - at_end) < 1e-11);
            // q^2 (1 - h^2/4) + p^2 is conserved, and H differs from it by h^2 q^2/8.
            const double most = h * h * q * q / 8;
            const double energy = q * q / 2 - most + h * h * at_end * at_end / 8;
            CHECK(std::abs(rows.number(row, "energy") - energy) < 1e-11);
            const double error = rows.number(row, "energy_error");
            CHECK((0.9 * most < error && error <= most + 1e-14));
            if (is_alone) CHECK(rows.number(row, "max(q)") == q);
        }
    }
}

TEST_CASE("rows fail one by one, and say why") {
    const Directory directory;
    write(directory / "scene.toml",
          "hamiltonian = \"(px^2 + py^2)/2 - k/sqrt(x^2 + y^2)\"\n"
          "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {k = 1}\n"
          "initial = {x = 1, y = 0, px = 0, py = 1}\n"
          "run = {method = \"stormer-verlet\", step = \"1/100\", until = 1}\n");
    write(directory / "starts.csv",
          "x,k,step\n1,1,0.01\n0,1,0.01\nnan,1,0.01\n1,inf,0.01\n1,1,0\n1,1,-0.01\n,1,0.01\n"
          "2,2,0.01\n");
    const Outcome outcome =
        study_in(directory, "eval \"$study --initial starts.csv\" && \"$hvi_gen\" collect study");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("rows         8: 2 ok, 1 not_finite, 3 no_number, 2 no_steps\n") !=
          std::string::npos);
    const TextTable rows = table_of(contents(directory / "study" / "rows.csv"));
    const std::vector<std::string> statuses{"ok",       "not_finite", "no_number", "no_number",
                                            "no_steps", "no_steps",   "no_number", "ok"};
    REQUIRE(rows.rows.size() == statuses.size());
    for (std::size_t row = 0; row < statuses.size(); ++row) {
        CAPTURE(row);
        CHECK(rows.at(row, "status") == statuses[row]);
        CHECK((rows.at(row, "steps") == "100") == (statuses[row] == "ok"));
    }
    CHECK(rows.at(1, "x") == "0");  // the state before the step that failed
}

TEST_CASE("events of rows are counted, and end them") {
    const std::string scene =
        "hamiltonian = \"p^2/2 + w^2*q^2/2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
        "parameters = {w = 1, level = 0}\ninitial = {q = 1, p = 0}\n"
        "run = {method = \"gauss:4\", step = \"1/10\", until = 100}\n"
        "[events.up]\nzero = \"q - level\"\ndirection = \"up\"\n"
        "[events.third]\nzero = \"p\"\ndirection = \"down\"\nstop = 3\n";
    // q = cos(w t) rises through a level once in each turn; p falls through 0 at whole turns.
    const TextTable rows = study_of(scene, "--vary w=1:3:3 --vary level=0:1/2:2");
    REQUIRE(rows.rows.size() == 6);
    const double pi = std::acos(-1.0);
    for (std::size_t row = 0; row < 6; ++row) {
        CAPTURE(row);
        CHECK(rows.at(row, "status") == "ok");
        CHECK(rows.at(row, "count(third)") == "3");
        CHECK(rows.at(row, "count(up)") == "3");
        CHECK(std::abs(rows.number(row, "t") - 6 * pi / rows.number(row, "w")) < 1e-6);
    }
    const TextTable high = study_of(scene, "--vary level=1/2:2:2");
    CHECK(high.at(0, "count(up)") == "3");
    CHECK(high.at(1, "count(up)") == "0");
}

TEST_CASE("MEGNO of a row is that of a run") {
    const std::string scene = "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
                              "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                              "initial = {x = 0, y = \"1/10\", px = \"1/2\", py = 0}\n"
                              "run = {method = \"gauss:4\", step = \"1/4\", until = 500}\n";
    const TextTable rows = study_of(scene, "--vary px=1/10:1/2:2 --megno");
    for (std::size_t row = 0; row < 2; ++row) {
        std::string of_row = scene;
        const std::string start = "px = \"1/2\"";
        of_row.replace(of_row.find(start), start.size(), "px = " + rows.at(row, "px_0"));
        const LastRow run = run_of(of_row, "--megno");
        std::vector<double> found;
        for (const std::string& line : lines_of(run.summary))
            for (const std::string key : {"lyapunov ", "megno "})
                if (line.rfind(key, 0) == 0) found.push_back(std::stod(line.substr(key.size())));
        REQUIRE(found.size() == 2);
        CHECK(std::abs(rows.number(row, "lyapunov") / found[0] - 1) < 1e-5);
        CHECK(std::abs(rows.number(row, "megno") / found[1] - 1) < 1e-5);
    }
}

TEST_CASE("rows of Lagrangians, of rotations, in scaled time and of loops") {
    const std::string lagrangian =
        "lagrangian = \"m*(1 + x^2)*vx^2/2 - x^2/2\"\ncoordinates = [\"x\"]\n"
        "velocities = [\"vx\"]\nparameters = {m = 1}\ninitial = {x = 1, vx = \"1/2\"}\n"
        "run = {method = \"gauss:2\", step = \"1/10\", until = 5}\n";
    const TextTable moved = study_of(lagrangian, "--vary vx=1/2:1:2 --vary m=1:2:2");
    REQUIRE(moved.names[1] == "vx_0");
    for (std::size_t row = 0; row < 4; ++row) {
        std::string scene = lagrangian;
        const std::string start = "vx = \"1/2\"";
        scene.replace(scene.find(start), start.size(), "vx = " + moved.at(row, "vx_0"));
        const LastRow run = run_of(scene, "--param m=" + moved.at(row, "m"));
        check_row(moved, row, run, {"x", "t"});
    }

    const std::string body =
        "hamiltonian = \"L[1]^2/2 + L[2]^2/(2*b) + L[3]^2/6\"\nrotations = [\"R\"]\n"
        "angular_momenta = [\"L\"]\nparameters = {b = 2}\n"
        "initial = {R = \"identity\", L = [1, 0, \"1/2\"]}\n"
        "run = {method = \"gauss:2\", step = \"1/10\", until = 5}\n";
    const TextTable bodies = study_of(body, "--vary b=2:5/2:2");
    check_row(bodies, 1, run_of(body, "--param b=2.5"), {"R[1,1]", "L[2]", "t"});

    const std::string scaled =
        "hamiltonian = \"(px^2 + py^2)/2 - k/sqrt(x^2 + y^2)\"\n"
        "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {k = 1}\n"
        "initial = {x = \"1/10\", y = 0, px = 0, py = \"sqrt(19)\"}\n"
        "run = {method = \"stormer-verlet\", step = \"1/20\", until = 20}\n"
        "time = {scale = \"logarithmic\"}\n";
    const TextTable times = study_of(scaled, "--vary k=1:11/10:2");
    check_row(times, 0, run_of(scaled, "--param k=1"), {"x", "px", "t"});
    check_row(times, 1, run_of(scaled, "--param k=1.1"), {"x", "px", "t"});

    const std::string chain =
        "hamiltonian = \"sum(i=1..100, p[i]^2/2) + sum(i=0..100, k*(q[i+1] - q[i])^2/2)\"\n"
        "coordinates = [\"q[1..100]\"]\nmomenta = [\"p[1..100]\"]\nparameters = {k = 1}\n"
        "initial = {\"q[i]\" = \"sin(pi*i/101)\", \"p[i]\" = 0}\n"
        "run = {method = \"stormer-verlet\", step = \"1/10\", until = 5}\n";
    std::string bounded = chain;
    const std::string sum = "sum(i=0..100, k*(q[i+1] - q[i])^2/2)";
    bounded.replace(bounded.find(sum), sum.size(), "sum(i=1..99, k*(q[i+1] - q[i])^2/2)");
    const TextTable loops = study_of(bounded, "--vary k=1:2:2 --unroll no --columns 'q[3]'");
    check_row(loops, 1, run_of(bounded, "--param k=2 --unroll no --columns 'q[3]'"), {"q[3]", "t"});
}
