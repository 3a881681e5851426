// Rows of studies that go eight side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/studies/study_run.hpp"

using namespace hvi::test;

namespace {

const std::string stars =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + k*(x^2*y - y^3/3)\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {k = 1}\n"
    "initial = {x = 0, y = \"1/10\", px = \"2/5\", py = 0}\n"
    "run = {method = \"gauss:4\", step = \"1/4\", until = 50}\n";

const std::string pushed = "hamiltonian = \"p^2/2 - cos(q) - F*q*cos(2*t/3)\"\n"
                           "coordinates = [\"q\"]\nmomenta = [\"p\"]\nparameters = {F = \"1/10\"}\n"
                           "initial = {q = 1, p = 0}\n"
                           "run = {method = \"gauss:4\", step = \"1/10\", until = 10}\n";

/// Checks that rows are those that were taken alone, up to rounding.
void check_beside_alone(const std::string& scene, const std::string& words,
                        const std::vector<std::string>& columns, double apart = 1e-12) {
    const TextTable together = study_of(scene, words),
                    alone = study_of(scene, words + " --lanes none");
    REQUIRE(together.names == alone.names);
    REQUIRE(together.rows.size() == alone.rows.size());
    for (std::size_t row = 0; row < alone.rows.size(); ++row) {
        CAPTURE(scene, words, row);
        for (const std::string word : {"row", "t", "status", "steps"})
            CHECK(together.at(row, word) == alone.at(row, word));
        for (const std::string& column : columns) {
            CAPTURE(column);
            CHECK(std::abs(together.number(row, column) - alone.number(row, column)) < apart);
        }
    }
}

}  // namespace

TEST_CASE("rows side by side are those taken alone, up to rounding") {
    const std::string words = "--vary k=1/2:1:11 --vary step=1/10:1/4:2 --vary until=5:20:3";
    const std::vector<std::string> columns{"x", "y", "px", "py", "energy_error", "energy"};
    for (const std::string method : {"gauss:4", "stormer-verlet", "midpoint"})
        check_beside_alone(stars, words + " --columns energy --method " + method, columns);
    check_beside_alone(
        stars, words + " --columns energy --method stormer-verlet --compose kahan-li:8", columns);
    for (const std::string method : {"gauss:6", "midpoint"})
        check_beside_alone(stars, words + " --columns energy --sweeps 3 --method " + method,
                           columns);
    for (const std::string method : {"gauss:4", "stormer-verlet"})
        check_beside_alone(pushed, "--vary F=0:1:9 --vary q=0:1:3 --method " + method, {"q", "p"});
}

TEST_CASE("rows of flows of parts are those taken alone, up to rounding") {
    const std::string words = "--vary k=1/2:1:5 --vary step=1/10:1/4:2 --vary until=5:20:3";
    for (const std::string method : {"strang --split auto", "mclachlan:8.4 --split auto",
                                     "strang --split auto --compose yoshida:4"})
        check_beside_alone(stars, words + " --columns energy --method " + method,
                           {"x", "y", "px", "py", "energy_error", "energy"});

    // A planet whose mass is varied, on orbits of its own: they are exact, and a period is 2 pi.
    const std::string planet = "hamiltonian = \"(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)\"\n"
                               "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                               "parameters = {mu = 1}\n"
                               "initial = {x = \"1/2\", y = 0, px = 0, py = \"sqrt(3)\"}\n"
                               "run = {method = \"strang\", step = \"pi/8\", until = \"2*pi\"}\n";
    check_beside_alone(planet, "--vary mu=1/2:2:11 --vary y=0:1/4:3 --split auto",
                       {"x", "y", "px", "py", "energy_error"});
    const TextTable rows = study_of(planet, "--vary mu=1:2:2 --split auto");
    CHECK(std::abs(rows.number(0, "x") - 0.5) < 1e-14);
    CHECK(std::abs(rows.number(0, "y")) < 1e-14);
    CHECK(std::abs(rows.number(1, "y")) > 1e-2);
}

TEST_CASE("rows that turn bodies are those taken alone, up to rounding") {
    const std::string body =
        "rotations = [\"R\"]\nangular_momenta = [\"L\"]\n"
        "hamiltonian = \"(L[1]^2 + L[2]^2)/(2*A) + L[3]^2/(2*C) + g*R[3,3]\"\n"
        "parameters = {A = 1, C = \"1/2\", g = 1}\n"
        "initial = {R = {axis = [1, 2, 3], angle = \"1/2\"}, L = [\"1/2\", 1, 2]}\n"
        "run = {method = \"strang\", step = \"1/20\", until = 10}\n";
    const std::vector<std::string> columns{"R[1,1]", "R[3,2]",       "R[3,3]", "L[1]",
                                           "L[3]",   "energy_error", "energy"};
    check_beside_alone(body, "--vary g=0:2:5 --vary C=1/4:1:4 --vary until=5:10:2 --columns energy",
                       columns);
    check_beside_alone(body, "--vary A=1/2:2:7 --vary step=1/20:4/5:2 --columns energy", columns,
                       1e-11);
    // A free body of equal moments turns about its momentum, here by 2 pi or by pi. It begins as
    // R = 1 + sin(1/2) hat(n) + (1 - cos(1/2)) hat(n)^2 with n = (1, 2, 3)/sqrt(14).
    const std::string ball = "rotations = [\"R\"]\nangular_momenta = [\"L\"]\n"
                             "hamiltonian = \"sum(i=1..3, L[i]^2/(2*A))\"\nparameters = {A = 1}\n"
                             "initial = {R = {axis = [1, 2, 3], angle = \"1/2\"}, L = [0, 1, 0]}\n"
                             "run = {method = \"strang\", step = \"pi/16\", until = \"2*pi\"}\n";
    const TextTable rows = study_of(ball, "--vary A=1:2:2");
    const double c = std::cos(0.5), s = std::sin(0.5);
    const double R_11 = c + (1 - c) / 14, R_22 = c + (1 - c) * 4 / 14,
                 R_13 = (1 - c) * 3 / 14 + s * 2 / std::sqrt(14.0);
    for (const std::size_t row : {0U, 1U}) {
        const double sign = row == 0 ? 1 : -1;
        CHECK(std::abs(rows.number(row, "R[1,1]") - sign * R_11) < 1e-14);
        CHECK(std::abs(rows.number(row, "R[1,3]") - sign * R_13) < 1e-14);
        CHECK(std::abs(rows.number(row, "R[2,2]") - R_22) < 1e-14);
    }
}

TEST_CASE("counted sweeps that begin with the slopes of two steps are taken alone") {
    check_beside_alone(stars, "--vary k=1/2:1:5 --method gauss:4 --sweeps 1", {"x", "px"}, 1e-300);
}

TEST_CASE("bits of a row do not depend on the rows beside it") {
    const std::string of_others = " --vary until=5:20:4 --columns energy";
    const TextTable rows = study_of(stars, "--vary k=1/4:1:7" + of_others);
    const TextTable few = study_of(stars, "--vary k=1/2:1:2" + of_others + " --chunk 1");
    REQUIRE(rows.rows.size() == 28);
    for (std::size_t row = 0; row < 8; ++row) {
        const std::size_t same = row < 4 ? 8 + row : 24 + row - 4;  // k is 1/2, and 1
        for (const std::string column :
             {"k", "until", "x", "y", "px", "py", "t", "energy_error", "energy"}) {
            CAPTURE(row, column);
            CHECK(rows.at(same, column) == few.at(row, column));
        }
    }
}

TEST_CASE("a row that is too stiff for fixed points is taken alone, by Newton's method") {
    const std::string scene = "hamiltonian = \"p^2/2 + k*(q^2/2 + q^4/4)\"\n"
                              "coordinates = [\"q\"]\nmomenta = [\"p\"]\nparameters = {k = 1}\n"
                              "initial = {q = \"1/10\", p = 0}\n"
                              "run = {method = \"gauss:2\", step = \"1/10\", until = 10}\n";
    const TextTable rows = study_of(scene, "--vary k=1:1000001:3");
    for (std::size_t row = 0; row < 3; ++row) {
        CAPTURE(row);
        CHECK(rows.at(row, "status") == "ok");
        CHECK(rows.at(row, "steps") == "100");
        if (row == 0) continue;
        const LastRow run = run_of(scene, "--param k=" + rows.at(row, "k"));
        for (const std::string column : {"q", "p"}) CHECK(rows.at(row, column) == run.at(column));
    }
    const TextTable kept = study_of(scene, "--vary k=1:1000001:3 --solver fixed-point");
    CHECK(kept.at(0, "status") == "ok");
    CHECK(kept.at(1, "status") == "not_converged");
}

TEST_CASE("rows side by side fail one by one") {
    const TextTable rows = study_of(stars, "--vary y=1/10:601/10:13 --method stormer-verlet");
    for (std::size_t row = 0; row < 13; ++row) {
        CAPTURE(row);
        const bool is_bound = row == 0;  // the others are above the saddle, and leave for ever
        CHECK(rows.at(row, "status") == (is_bound ? "ok" : "not_finite"));
        CHECK((rows.number(row, "steps") == 200) == is_bound);
    }
}

TEST_CASE("MEGNO of rows side by side is that of rows taken alone") {
    const std::string words =
        "--vary px=1/10:3/10:5 --vary step=1/10:1/5:2 --vary until=50:100:2 --megno";
    const std::vector<std::string> columns{"x",        "y",    "px", "py", "energy_error",
                                           "lyapunov", "megno"};
    for (const std::string method :
         {"stormer-verlet", "gauss:2", "stormer-verlet --compose kahan-li:8"})
        check_beside_alone(stars, words + " --method " + method, columns, 1e-10);
    check_beside_alone(pushed, "--vary F=0:1/10:5 --method stormer-verlet --megno",
                       {"q", "p", "lyapunov", "megno"}, 1e-10);
}

TEST_CASE("a direction that grows for ever is scaled on its way") {
    // The step of Stormer and Verlet for H = p^2/2 - w^2 q^2/2 has the eigenvalues exp(m), exp(-m),
    // with cosh(m) = 1 + (w h)^2/2. Over 1000 units of time directions grow by 2^1400 and more.
    const std::string scene =
        "hamiltonian = \"p^2/2 - w^2*q^2/2\"\n"
        "coordinates = [\"q\"]\nmomenta = [\"p\"]\nparameters = {w = 1}\n"
        "initial = {q = 0, p = 0}\n"
        "run = {method = \"stormer-verlet\", step = \"1/10\", until = 1000}\n";
    const TextTable rows = study_of(scene, "--vary w=1:2:11 --megno");
    for (std::size_t row = 0; row < 11; ++row) {
        CAPTURE(row);
        const double w = rows.number(row, "w"), h = 0.1;
        const double rate = std::acosh(1 + w * w * h * h / 2) / h;
        CHECK(rows.at(row, "status") == "ok");
        CHECK(std::abs(rows.number(row, "lyapunov") - rate) < 2.0 / 1000);
        // ln |v| grows by h times the rate in a step, so that Y_n is rate t, and its mean half of
        // it.
        CHECK(std::abs(rows.number(row, "megno") / (rate * 500) - 1) < 0.01);
    }
}
