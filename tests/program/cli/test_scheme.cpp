// Results of `hvi-gen scheme`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/checkout.hpp"
#include "tests/program/cli/results.hpp"

using namespace hvi::test;

namespace fs = std::filesystem;

TEST_CASE("scheme prints the maps of Section 6") {
    const auto printed = [](const std::string& method, const std::string& H) {
        const std::string text =
            same_every_time({"scheme", "--method", method, "--hamiltonian", H});
        return text.substr(text.find("\n q' = ") + 1);
    };
    CHECK(printed("chebyshev:3", "q*p") ==  // (6.2)
          " q' = -(h^3+10*h^2+48*h+96)*q/(h^3-10*h^2+48*h-96)\n"
          " p' = (-h^3+10*h^2-48*h+96)*p/(h^3+10*h^2+48*h+96)\n");
    CHECK(printed("gauss:2", "q*p") ==  // (6.3)
          " q' = (h^2+6*h+12)*q/(h^2-6*h+12)\n p' = (h^2-6*h+12)*p/(h^2+6*h+12)\n");
    CHECK(printed("chebyshev:3", "p^2/2 + w^2*q^2/2") ==  // (6.5)
          R"( q' = (-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)*q/(h^6*w^6-12*h^4*w^4+288*h^2*w^2
      +9216)
      +(36*h^5*w^4-1248*h^3*w^2+9216*h)*p/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216)
 p' = (-12*h^5*w^6+1248*h^3*w^4-9216*h*w^2)*q/(h^6*w^6-12*h^4*w^4+288*h^2*w^2
      +9216)
      +(-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)*p/(h^6*w^6-12*h^4*w^4
      +288*h^2*w^2+9216)
)");
    CHECK(printed("gauss:2", "(p^2+w^2*q^2)/2") ==  // (6.6)
          R"( q' = (h^4*w^4-60*h^2*w^2+144)*q/(h^4*w^4+12*h^2*w^2+144)
      +(-12*h^3*w^2+144*h)*p/(h^4*w^4+12*h^2*w^2+144)
 p' = (12*h^3*w^4-144*h*w^2)*q/(h^4*w^4+12*h^2*w^2+144)
      +(h^4*w^4-60*h^2*w^2+144)*p/(h^4*w^4+12*h^2*w^2+144)
)");
}

TEST_CASE("scheme in the words of CONTRACT.md") {
    const Directory directory;
    const std::vector<std::string> words = {"scheme",
                                            "--method",
                                            "gauss:2",
                                            "--hamiltonian",
                                            "p^2/2 + w^2*q^2/2",
                                            "--coordinates",
                                            "q",
                                            "--momenta",
                                            "p",
                                            "--param",
                                            "w=1",
                                            "--format",
                                            "json",
                                            "-o",
                                            "map.json"};
    const Outcome outcome = hvi_gen(words, directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.empty());
    const std::string json = contents(directory / "map.json");
    for (const std::string part :
         {"\"schema\": \"hvi-scheme/1\"", "\"variables\": [\n    \"q\",\n    \"p\"\n  ]",
          "\"parameters\": []", "\"w\": \"1\"", "\"(h^4-60*h^2+144)/(h^4+12*h^2+144)\"",
          "\"stages\": null"})
        CHECK(json.find(part) != std::string::npos);
    const std::string pendulum = same_every_time(
        {"scheme", "--method", "stormer-verlet", "--hamiltonian", "p^2/2 - cos(q)"});
    CHECK(pendulum.find(" P_1 = p-h*sin(Q_1)/2\n") != std::string::npos);
    const std::string generating =
        same_every_time({"scheme", "--generating", "--method", "gauss:2", "--hamiltonian", "q*p"});
    CHECK(generating.find(" H_d^+ = (h^2+6*h+12)*q*p'/(h^2-6*h+12)\n") != std::string::npos);
    CHECK(generating.find(" H_d,exact^+ = exp(h)*q*p'\n") != std::string::npos);
    CHECK(generating.find("O(h^5)\n") != std::string::npos);
}

TEST_CASE("scheme prints series of the discrete Hamiltonians") {
    const std::vector<std::string> words = {"scheme",   "--method", "midpoint",
                                            "pendulum", "--series", "3"};
    const std::string text = same_every_time(words);
    CHECK(text.substr(text.find("\ncoefficients")) == R"(
coefficients of powers of h in the exact discrete Hamiltonian, (4.1):

 [1] = q*p'
 [h] = p'^2/2-cos(q)
 [h^2] = p'*sin(q)/2
 [h^3] = p'^2*cos(q)/6-cos(q)^2/6+1/6

and in the H_d^+ of the method, (4.19):

 [1] = q*p'
 [h] = p'^2/2-cos(q)
 [h^2] = p'*sin(q)/2
 [h^3] = p'^2*cos(q)/8-cos(q)^2/8+1/8

difference    H_d^+ - H_d,exact^+ = O(h^3), and its first coefficient is

 [h^3] = cos(q)^2/24-p'^2*cos(q)/24-1/24
)");
    const std::string json = same_every_time(with(words, {"--format", "json"}));
    for (const std::string part :
         {"\"schema\": \"hvi-series/1\"", "\"p*sin(q)/2\"", "\"first_difference\": 3,",
          "\"difference\": \"cos(q)^2/24-p^2*cos(q)/24-1/24\"", "\"undecided\": null"})
        CHECK(json.find(part) != std::string::npos);
    const std::string latex = same_every_time(with(words, {"--format", "latex"}));
    CHECK(latex.find("pendulum --series 3 --format latex\n") != std::string::npos);
    CHECK(latex.find("[h^{2}]\\,H_{d}^{+} &= ") != std::string::npos);
    const Outcome equal = hvi_gen({"scheme", "--method", "gauss:2", "kepler", "--series", "4"});
    CHECK(equal.status == 0);
    CHECK(equal.out.find("difference    none up to h^4\n") != std::string::npos);
    for (const char* wrong : {"0", "13", "-1", "2.5", "many", ""}) {
        const Outcome refused =
            hvi_gen({"scheme", "--method", "midpoint", "pendulum", "--series", wrong});
        CAPTURE(wrong, refused.err);
        CHECK(refused.status == 2);
        CHECK(refused.err.find("--series takes a whole number from 1 to 12") != std::string::npos);
    }
}

TEST_CASE("of the general Galerkin form scheme prints the series too") {
    const std::vector<std::string> words = {"scheme",  "--basis",  "1",        "--nodes",
                                            "gauss:6", "pendulum", "--series", "3"};
    const std::string text = same_every_time(words);
    CHECK(text.find("\ncoefficients of powers of h in the exact") != std::string::npos);
    CHECK(text.find("H_d^+ - H_d,exact^+ = O(h^3), and its") != std::string::npos);
    const std::string json = same_every_time(with(words, {"--format", "json"}));
    for (const char* part : {"\"map\": null", "\"basis\": [", "\"first_difference\": 3,"})
        CHECK(json.find(part) != std::string::npos);
    const std::string latex = same_every_time(with(words, {"--format", "latex"}));
    CHECK(latex.find("\n[h^{1}]\\,H_{d,") != std::string::npos);
}

TEST_CASE("scheme takes a scene by name, and by file") {
    const Directory directory;
    const std::string toml = contents(in_checkout("examples/scenes/harmonic-oscillator.toml"));
    write(directory / "mine.toml", toml);
    write(directory / "harmonic-oscillator", "this is no scene");  // the name wins
    const auto printed = [&](const std::vector<std::string>& words) {
        const Outcome outcome = hvi_gen(with({"scheme"}, words), directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        return outcome.out;
    };
    const std::string given =
        printed({"--method", "gauss:2", "--hamiltonian", "p^2/2+omega^2*q^2/2"});
    CHECK(printed({"--method", "gauss:2", "harmonic-oscillator"}) == given);
    CHECK(printed({"--method", "gauss:2", "mine.toml"}) == given);
    CHECK(printed({"--method", "gauss:2", "./mine.toml"}) == given);
    CHECK(printed({"mine.toml", "--method", "gauss:2"}) == given);
    const std::string fixed = printed(
        {"--method", "gauss:2", "--hamiltonian", "p^2/2+omega^2*q^2/2", "--param", "omega=2"});
    CHECK(printed({"--method", "gauss:2", "mine.toml", "--param", "omega=2"}) == fixed);
    // each option right before the scene, which it must leave alone
    CHECK(printed({"--method", "gauss:2", "--param", "omega=2", "mine.toml"}) == fixed);
    CHECK(printed({"--method", "gauss:2", "--format", "text", "mine.toml"}) == given);
    CHECK(printed({"--method", "gauss:2", "-o", "out", "mine.toml"}).empty());
    CHECK(contents(directory / "out") == given);
    CHECK(printed({"--method", "gauss:2", "--output", "out", "mine.toml"}).empty());
    CHECK(!printed({"--method", "gauss:2", "--generating", "mine.toml"}).empty());
    const std::string trig = printed({"--nodes", "0, 1", "--basis", "1, tau", "mine.toml"});
    CHECK(printed({"--basis", "1, tau", "--nodes", "0, 1", "mine.toml"}) == trig);
    write(directory / "method.toml", "basis = \"1, tau\"\nnodes = \"0, 1\"\n");
    CHECK(!printed({"--method-file", "method.toml", "mine.toml"}).empty());
    CHECK(printed({"--method", "gauss:2", "--param", "ecc=1/3", "kepler"}) ==
          printed({"--method", "gauss:2", "kepler"}));
    const std::string json = printed({"--method", "gauss:2", "kepler", "--format", "json"});
    CHECK(json.find("\"parameters\": [\n    \"mu\"\n  ]") != std::string::npos);
    const std::string latex = printed({"--method", "gauss:2", "mine.toml", "--format", "latex"});
    CHECK(latex.find("% hvi-gen scheme --method gauss:2 mine.toml --format latex\n") == 0);
}

TEST_CASE("scheme of what has indices, and of what depends on time") {
    const std::vector<std::string> words = {"scheme",  "--method",  "gauss:2", "--coordinates",
                                            "x[1..2]", "--momenta", "p[1..2]", "--hamiltonian"};
    const std::string short_form =
        same_every_time(with(words, {"sum(i=1..2, p[i]^2/(2*m[i])) + x[1]*x[2]"}));
    const std::string long_form =
        same_every_time(with(words, {"p[1]^2/(2*m[1]) + p[2]^2/(2*m[2]) + x[1]*x[2]"}));
    CHECK(short_form == long_form);
    CHECK(short_form.find("parameters    m[1], m[2]\n") != std::string::npos);
    const std::string fixed = same_every_time(
        with(words, {"sum(i=1..2, p[i]^2/(2*m[i])) + x[1]*x[2]", "--param", "m[1]=2"}));
    CHECK(fixed.find("values        m[1] = 2\n") != std::string::npos);
    const std::string driven = same_every_time(
        {"scheme", "--method", "lobatto:3", "--hamiltonian", "p^2/2 + (1+cos(t))*q^2/2"});
    CHECK(driven.find(" T_1 = t\n T_2 = t+h/2\n T_3 = t+h\n") != std::string::npos);
    same_every_time({"scheme", "--method", "gauss:3", "outer-solar-system"});
    same_every_time({"scheme", "--method", "gauss:3", "--format", "latex", "point-vortices"});
}

TEST_CASE("scheme --lagrangian of a Hamiltonian, and of a Lagrangian") {
    const Directory directory;
    write(directory / "hoop.toml",
          "coordinates = \"th\"\nvelocities = \"v\"\n"
          "lagrangian = \"m*R^2*(v^2 + W^2*sin(th)^2)/2 + m*g*R*cos(th)\"\n"
          "[parameters]\nm = 1\nR = 1\nW = 2\ng = 1\n[initial]\nth = 1\nv = 0\n");
    const auto printed = [&](const std::vector<std::string>& words) {
        const Outcome outcome =
            hvi_gen(with({"scheme", "--method", "gauss:1"}, words), directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        return outcome.out;
    };
    const auto has = [](const std::string& text, const std::string& part) {
        INFO(text);
        CHECK(text.find(part) != std::string::npos);
    };
    const std::string given = printed({"hoop.toml", "--lagrangian"});
    has(given, "lagrangian    m*R^2*(v^2+W^2*sin(th)^2)/2+m*g*R*cos(th)\n");
    has(given, "\n p_th = R^2*m*v\n");
    has(given, "\n Th_1 = th+h*V_1/2\n");
    has(given, "\n th' = th+h*V_1\n");
    has(printed({"hoop.toml"}),
        "hamiltonian   p_th^2/(2*R^2*m)-R*g*m*cos(th)-R^2*W^2*m*sin(th)^2/2\n");
    has(printed({"hoop.toml", "--lagrangian", "--param", "R=3"}), "\n p_th = 9*m*v\n");
    has(printed({"hoop.toml", "--param", "R=3"}), "values        R = 3\n");
    has(printed({"hoop.toml", "--lagrangian", "--format", "json"}),
        "\"schema\": \"hvi-scheme-lagrangian/1\"");
    has(printed({"hoop.toml", "--lagrangian", "--format", "latex"}),
        "% hvi-gen scheme --method gauss:1 hoop.toml --lagrangian --format latex\n");
    const std::string pendulum =
        same_every_time({"scheme", "--method", "gauss:2", "--lagrangian", "double-pendulum"});
    CHECK(pendulum.find("velocities    theta1_dot, theta2_dot\n") != std::string::npos);
    CHECK(pendulum.find("sin(theta1-theta2)^2") == std::string::npos);
}
