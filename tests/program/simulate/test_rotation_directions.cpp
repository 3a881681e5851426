// Directions of bodies that turn: the derivative of the flow, and how chaotic it is.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

using Vector3 = std::array<double, 3>;
using Rotation = std::array<double, 9>;  ///< row by row
using Quaternion = std::array<double, 4>;

Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector3 operator*(double c, const Vector3& a) { return {c * a[0], c * a[1], c * a[2]}; }
Vector3 operator-(const Vector3& a, const Vector3& b) { return a + -1.0 * b; }
Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 unit(std::size_t k) {
    Vector3 e{};
    e[k] = 1;
    return e;
}

Quaternion product(const Quaternion& a, const Quaternion& b) {
    const Vector3 u{a[1], a[2], a[3]}, v{b[1], b[2], b[3]};
    const Vector3 w = a[0] * v + b[0] * u + cross(u, v);
    return {a[0] * b[0] - dot(u, v), w[0], w[1], w[2]};
}

/// exp(hat theta) as a quaternion.
Quaternion turn(const Vector3& theta) {
    const double angle = std::sqrt(dot(theta, theta));
    const Vector3 v = angle == 0 ? Vector3{} : (std::sin(angle / 2) / angle) * theta;
    return {std::cos(angle / 2), v[0], v[1], v[2]};
}

/// R a, or R^T a.
Vector3 times(const Rotation& R, const Vector3& a) {
    return {R[0] * a[0] + R[1] * a[1] + R[2] * a[2], R[3] * a[0] + R[4] * a[1] + R[5] * a[2],
            R[6] * a[0] + R[7] * a[1] + R[8] * a[2]};
}
Vector3 transposed_times(const Rotation& R, const Vector3& a) {
    return times({R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]}, a);
}

/// theta of dR = R hat(theta).
Vector3 turn_of(const Rotation& R, const Rotation& dR) {
    Vector3 theta{};
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        for (std::size_t i = 0; i < 9; i += 3)
            theta[a] += (R[i + c] * dR[i + b] - R[i + b] * dR[i + c]) / 2;
    }
    return theta;
}

std::string text_of(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "\"%.17g\"", x);
    return text;
}

template <std::size_t n>
std::string list_of(const std::array<double, n>& all) {
    std::string text;
    for (const double x : all) text += (text.empty() ? "[" : ", ") + text_of(x);
    return text + "]";
}

/// Where a body is, and its angular momentum.
struct Body {
    Quaternion q;
    Vector3 L;
};

/// A scene of one body that begins so, without the lines of its run.
std::string body(const std::string& H, const Body& start) {
    return "rotations = [\"R\"]\nangular_momenta = [\"L\"]\nhamiltonian = \"" + H +
           "\"\ninitial = {R = {quaternion = " + list_of(start.q) + "}, L = " + list_of(start.L) +
           "}\n";
}

/// A body with these principal moments, hung up in gravity at this place of it.
///
/// NOTE: parameters, so that one compiled module serves for all of them.
std::string top(const Vector3& moments, const Vector3& centre, const Body& start) {
    return body("sum(i=1..3, L[i]^2/(2*moments[i])) + sum(i=1..3, R[3,i]*centre[i])", start) +
           "parameters = {moments = " + list_of(moments) + ", centre = " + list_of(centre) + "}\n";
}

const Vector3 moments_of_top{1, 2, 3}, centre_of_top{0.3, 0.1, 1};
std::string chaotic_top(const Body& start) { return top(moments_of_top, centre_of_top, start); }
std::string lagrange_top(const Body& start) { return top({1, 1, 1.5}, {0, 0, 1}, start); }

const Body start_of_top{{std::cos(0.5), 0, std::sin(0.5), 0}, {0.5, 1, -0.7}};

/// R and L in a row of the table of one body.
Rotation rotation_in(const std::vector<double>& row) {
    Rotation R{};
    std::copy_n(row.begin() + 1, 9, R.begin());
    return R;
}
Vector3 momentum_in(const std::vector<double>& row) { return {row[10], row[11], row[12]}; }

/// Start moved by component k of theta and dL.
Body moved(const Body& start, std::size_t k, double by) {
    Body result = start;
    if (k < 3)
        result.q = product(start.q, turn(by * unit(k)));
    else
        result.L[k - 3] += by;
    return result;
}

/// Column k of D, from runs that begin on both sides.
std::array<double, 6> difference(const std::function<SceneRun(const Body&)>& run, const Body& start,
                                 const Rotation& R, std::size_t k) {
    const double by = 1e-5;
    const auto up = run(moved(start, k, by)).last(), down = run(moved(start, k, -by)).last();
    Rotation dR{};
    const Rotation R_up = rotation_in(up), R_down = rotation_in(down);
    for (std::size_t i = 0; i < 9; ++i) dR[i] = (R_up[i] - R_down[i]) / (2 * by);
    const Vector3 theta = turn_of(R, dR);
    const Vector3 dL = 1 / (2 * by) * (momentum_in(up) - momentum_in(down));
    return {theta[0], theta[1], theta[2], dL[0], dL[1], dL[2]};
}

/// The largest entry of D^T J(L) D - J(L_0), over the square of the largest of D, where the
/// coordinates are `flat` ones and then turns, in the order of the rows.
double defect(const std::vector<std::vector<double>>& D, std::size_t flat,
              const std::vector<double>& L0, const std::vector<double>& L) {
    const std::size_t n = D.size() / 2;
    const auto form = [&](const std::vector<double>& of, auto v, auto w) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k) sum += v(k) * w(n + k) - v(n + k) * w(k);
        for (std::size_t r = 0; flat + r < n; r += 3) {
            const auto turn_by = [&](auto d) {
                return Vector3{d(flat + r), d(flat + r + 1), d(flat + r + 2)};
            };
            sum += dot({of[r], of[r + 1], of[r + 2]}, cross(turn_by(v), turn_by(w)));
        }
        return sum;
    };
    double largest = 1, error = 0;
    for (const auto& row : D)
        for (const double entry : row) largest = std::max(largest, std::abs(entry));
    for (std::size_t a = 0; a < 2 * n; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const auto column = [&](std::size_t of) {
                return [&D, of](std::size_t row) { return D[row][of]; };
            };
            const auto e = [](std::size_t of) {
                return [of](std::size_t row) { return row == of ? 1.0 : 0.0; };
            };
            error = std::max(error, std::abs(form(L, column(a), column(b)) - form(L0, e(a), e(b))));
        }
    return error / (largest * largest);
}

// ---- another program: the equations of Euler and Poisson, and their linearisation ----

/// G = R^T e_3 and L of the top in gravity, with a direction theta, dL.
struct Linearised {
    Vector3 G, L, theta, dL;

    [[nodiscard]] Linearised slope() const {
        const Vector3& centre = centre_of_top;
        const Vector3 omega{L[0], L[1] / 2, L[2] / 3}, d_omega{dL[0], dL[1] / 2, dL[2] / 3};
        return {cross(G, omega), cross(L, omega) + cross(G, centre), d_omega - cross(omega, theta),
                cross(dL, omega) + cross(L, d_omega) + cross(cross(G, theta), centre)};
    }
    [[nodiscard]] Linearised plus(double h, const Linearised& k) const {
        return {G + h * k.G, L + h * k.L, theta + h * k.theta, dL + h * k.dL};
    }
    /// Takes a step of the classical method of Runge and Kutta.
    void step(double h) {
        const Linearised a = slope(), b = plus(h / 2, a).slope(), c = plus(h / 2, b).slope(),
                         d = plus(h, c).slope();
        *this = plus(h / 6, a).plus(h / 3, b).plus(h / 3, c).plus(h / 6, d);
    }
    [[nodiscard]] double norm() const { return std::sqrt(dot(theta, theta) + dot(dL, dL)); }
};

/// R^T e_3 of a quaternion.
Vector3 vertical(const Quaternion& q) {
    return {2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]),
            q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3]};
}

}  // namespace

TEST_CASE("the derivative of a free symmetric body is that of its closed form", "[rotations]") {
    // With the moments A, A, C, the angular momentum l in space, and c = 1/C - 1/A,
    //
    //     R = exp(t hat l/A) R_0 exp(t c L_3 hat e_3),    L = exp(-t c L_3 hat e_3) L_0,
    //
    // and with u = t l/A the derivative of exp(hat u) is exp(hat u) hat(dexp_-u du).
    const double A = 2, C = 0.8, t = 3, c = 1 / C - 1 / A;
    const Body start{{0.8, 0, 0.6, 0}, {0.4, -0.7, 1.1}};
    const SceneRun found =
        run_scene(body("(L[1]^2 + L[2]^2)/4 + L[3]^2/(8/5)", start) +
                      "run = {method = \"gauss:6\", step = \"1/10\", until = 3}\n",
                  "--tangent");
    INFO(found.outcome.err);
    REQUIRE(found.tangent.size() == 6);
    const Rotation R0 = rotation_in(found.row(0));
    const Vector3 l = times(R0, start.L), u = t / A * l, e3 = unit(2);
    const double x = std::sqrt(dot(u, u)), angle = t * c * start.L[2];
    const auto dexp = [&](const Vector3& v) {
        const Vector3 w = cross(u, v);
        return v - (1 - std::cos(x)) / (x * x) * w + (x - std::sin(x)) / (x * x * x) * cross(u, w);
    };
    const auto about_axis = [&](const Vector3& v) {  // exp(-angle hat e_3) v
        const double cosine = std::cos(angle), sine = std::sin(angle);
        return Vector3{cosine * v[0] + sine * v[1], cosine * v[1] - sine * v[0], v[2]};
    };
    for (std::size_t k = 0; k < 6; ++k) {
        const Vector3 theta0 = k < 3 ? unit(k) : Vector3{}, dL0 = k < 3 ? Vector3{} : unit(k - 3);
        const Vector3 du = t / A * times(R0, cross(theta0, start.L) + dL0);
        const double turned = t * c * dL0[2];
        const Vector3 theta = turned * e3 + about_axis(theta0 + transposed_times(R0, dexp(du)));
        const Vector3 dL = about_axis(dL0 - turned * cross(e3, start.L));
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(std::abs(found.tangent[i][k] - theta[i]) < 1e-11);
            CHECK(std::abs(found.tangent[3 + i][k] - dL[i]) < 1e-11);
        }
    }
}

TEST_CASE("the derivative of a top is that of runs that begin nearby", "[rotations]") {
    const auto driven_top = [](const Body& start) {
        return body("L[1]^2/2 + L[2]^2/4 + L[3]^2/6 + (1 + cos(2*t))*R[1,2]", start);
    };
    const std::vector<std::pair<std::function<std::string(const Body&)>, std::string>> all{
        {chaotic_top, "--method gauss:4 --until 26/10"},
        {chaotic_top, "--method lobatto:3 --solver newton"},
        {chaotic_top, "--method gauss:2 --compose suzuki:4"},
        {driven_top, "--method gauss:4"}};
    for (const auto& [scene, how] : all) {
        CAPTURE(how);
        const auto run = [&, text = scene](const std::string& words) {
            return [&, words](const Body& start) {
                return run_scene(text(start) + "run = {step = \"1/5\", until = 5}\n", words);
            };
        };
        const SceneRun found = run("--tangent " + how)(start_of_top);
        INFO(found.outcome.err);
        REQUIRE(found.tangent.size() == 6);
        const Rotation R = rotation_in(found.last());
        for (std::size_t k = 0; k < 6; ++k) {
            const std::array<double, 6> column = difference(run(how), start_of_top, R, k);
            for (std::size_t i = 0; i < 6; ++i)
                CHECK(std::abs(found.tangent[i][k] - column[i]) < 1e-7);
        }
    }
}

TEST_CASE("the derivative of a top is that of the equations of Euler and Poisson", "[rotations]") {
    const SceneRun found = run_scene(
        chaotic_top(start_of_top) + "run = {method = \"gauss:4\", step = \"1/40\", until = 5}\n",
        "--tangent");
    REQUIRE(found.tangent.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
        Linearised x{vertical(start_of_top.q), start_of_top.L, k < 3 ? unit(k) : Vector3{},
                     k < 3 ? Vector3{} : unit(k - 3)};
        for (int step = 0; step < 20000; ++step) x.step(5.0 / 20000);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(std::abs(found.tangent[i][k] - x.theta[i]) < 1e-10);
            CHECK(std::abs(found.tangent[3 + i][k] - x.dL[i]) < 1e-10);
        }
    }
}

TEST_CASE("the derivative of bodies stays symplectic", "[rotations]") {
    // NOTE: a regular one, as columns of a chaotic one become parallel.
    const SceneRun top =
        run_scene(lagrange_top(start_of_top) + "run = {method = \"gauss:4\", step = \"1/5\"}\n",
                  "--tangent --until 2000");
    REQUIRE(top.tangent.size() == 6);
    const auto L_of = [](const std::vector<double>& row, std::size_t first, std::size_t count) {
        const auto begin = row.begin() + static_cast<std::ptrdiff_t>(first);
        return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    CHECK(defect(top.tangent, 0, L_of(top.row(0), 10, 3), L_of(top.last(), 10, 3)) < 1e-11);
    // An orbit beside a rotation, and 24 directions that take several steppers.
    const SceneRun craft = run_words("spacecraft --tangent --until 20");
    const std::string says = "D^T J D - J is ";
    const std::size_t said = craft.outcome.out.find(says);
    REQUIRE(said != std::string::npos);
    CHECK(std::stod(craft.outcome.out.substr(said + says.size())) < 1e-13);
    REQUIRE(craft.tangent.size() == 12);
    CHECK(defect(craft.tangent, 3, L_of(craft.row(0), 16, 3), L_of(craft.last(), 16, 3)) < 1e-13);
    const SceneRun rotors = run_words("coupled-rotors --tangent --until 10");
    REQUIRE(rotors.tangent.size() == 24);
    CHECK(defect(rotors.tangent, 0, L_of(rotors.row(0), 37, 12), L_of(rotors.last(), 37, 12)) <
          1e-13);
}

TEST_CASE("a chaotic top has the exponent of another program", "[rotations]") {
    const Body start{start_of_top.q, {1, 1, 1}};
    const auto scene = [&](const std::string& run) {
        return chaotic_top(start) + "run = {method = \"gauss:4\", " + run + "}\n";
    };
    // The direction that a run begins with is generic; orbits agree until rounding has grown.
    Linearised x{vertical(start.q), start.L, {}, {}};
    for (std::size_t k = 1; k <= 6; ++k) {
        const double part = 0.6180339887498949 * static_cast<double>(k);
        (k <= 3 ? x.theta[k - 1] : x.dL[k - 4]) = 0.5 + part - std::floor(part);
    }
    const double norm = x.norm();
    for (int step = 0; step < 200000; ++step) x.step(1.0 / 4000);
    const double growth = std::log(x.norm() / norm) / 50;
    const SceneRun early = run_scene(scene("step = \"1/20\", until = 50"), "--lyapunov");
    REQUIRE(early.said("lyapunov").size() == 1);
    CHECK(growth > 0.1);
    CHECK(early.said("lyapunov").front() == Approx(growth).epsilon(1e-5));
    // In the long run the exponent of this start is 0.138, by steps of 1/200 until 20000.
    const SceneRun late = run_scene(scene("step = \"1/5\", until = 4000"), "--lyapunov");
    CAPTURE(late.outcome.out, late.outcome.err);
    REQUIRE(late.said("lyapunov").size() == 1);
    CHECK(late.said("lyapunov").front() == Approx(0.138).epsilon(0.15));
    CHECK(late.said("megno").front() ==
          Approx(late.said("lyapunov").front() * 4000 / 2).epsilon(0.2));
    // The energy and turns about the vertical have a pair of zeros each.
    const SceneRun all =
        run_scene(scene("step = \"1/5\", until = 2000"), "--lyapunov=spectrum --sali");
    const std::vector<double> exponents = all.said("lyapunov");
    CAPTURE(all.outcome.out);
    REQUIRE(exponents.size() == 6);
    CHECK(exponents[0] == Approx(0.138).epsilon(0.2));
    CHECK(exponents[5] == Approx(-exponents[0]).epsilon(0.05));
    CHECK(std::abs(std::accumulate(exponents.begin(), exponents.end(), 0.0)) < 1e-5);
    for (std::size_t k = 1; k < 5; ++k) CHECK(std::abs(exponents[k]) < 0.01);
    CHECK(all.said("sali").front() < 1e-12);
}

TEST_CASE("bodies whose motion is regular have no exponents", "[rotations]") {
    const std::string run = "run = {method = \"gauss:4\", step = \"1/5\", until = 2000}\n";
    const auto look = [&](const std::string& scene) {
        const SceneRun found = run_scene(scene + run, "--lyapunov");
        CAPTURE(scene, found.outcome.out, found.outcome.err);
        REQUIRE(found.said("lyapunov").size() == 1);
        // Neighbours move apart in proportion to the time: ln(t)/t.
        CHECK(std::abs(found.said("lyapunov").front()) < 2 * std::log(2000) / 2000);
        CHECK(found.said("megno").front() == Approx(2).epsilon(0.05));
    };
    look(top(moments_of_top, {}, start_of_top));  // Euler's
    look(lagrange_top(start_of_top));
    look(top({1, 1, 0.5}, {1, 0, 0}, start_of_top));  // Kovalevskaya's
}

TEST_CASE("directions of bodies that are not built are refused", "[rotations]") {
    use_cache();
    const auto refused = [](const std::string& line, const std::string& message) {
        const Directory directory;
        write(directory / "potential.hpp", "template <class T> T V(T x) { return x; }\n");
        write(directory / "own.toml",
              body("L[1]^2/2 + L[2]^2/2 + L[3]^2/3 + V(R[3,3])", start_of_top) +
                  "functions = {V = {header = \"potential.hpp\", arguments = 1}}\n"
                  "run = {method = \"gauss:4\", step = \"1/5\", until = 1}\n");
        const Outcome outcome = shell("exec \"$hvi_gen\" " + line, directory.path());
        CAPTURE(line, outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(message) != std::string::npos);
    };
    refused("run coupled-rotors --unroll no --lyapunov",
            "--lyapunov is not built for rotations where sums stay loops");
    refused("run own.toml --megno", "--megno is not built for functions of your own");
    refused("run heavy-top --tangent --interpret", "this cannot be run without a compiler");
    refused("run heavy-top --sensitivity m",
            "--sensitivity is not built for scenes with rotations");
    refused("stepper heavy-top --method gauss:4 --tangent",
            "--tangent is not built for scenes with rotations");
}

TEST_CASE("derivatives of an event are not built for bodies, and that is said", "[rotations]") {
    const SceneRun found = run_scene(chaotic_top(start_of_top) +
                                         "run = {method = \"gauss:4\", step = \"1/5\", until = 5}\n"
                                         "[events.level]\nzero = \"R[3,3]\"\nstop = 1\n",
                                     "--tangent");
    CAPTURE(found.outcome.out, found.outcome.err);
    CHECK(found.tangent.size() == 6);
    CHECK(found.section.empty());
    CHECK(found.outcome.out.find("and for rotations") != std::string::npos);
}
