// The map of one step against the paper, a reference, and what it has to satisfy.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/support/error.hpp"
#include "tests/generator/exact/reference.hpp"
#include "tests/generator/linear/linear.hpp"
#include "tests/generator/linear/stages.hpp"

using namespace hvi::gen;

namespace {

bool has_map(const std::string& method, const std::string& hamiltonian,
             const std::string& expected_matrix, const std::string& expected_offset = "0, 0") {
    return with_method(any_method(method), hamiltonian,
                       [&](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                           const LinearMap map = one_step_map(tableau, H, ground);
                           return are_equal(map.matrix, matrix_of(expected_matrix, ground)) &&
                                  are_equal(map.offset, vector_of(expected_offset, ground));
                       });
}

/// The entries as text, row after row.
std::vector<std::string> map_texts(const std::string& method, const std::string& hamiltonian) {
    return with_method(any_method(method), hamiltonian,
                       [&](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                           std::vector<std::string> result;
                           for (const NumberVector& row : one_step_map(tableau, H, ground).matrix) {
                               for (const Number& entry : row) { result.push_back(text(entry)); }
                           }
                           return result;
                       });
}

}  // namespace

// ---- the paper ----

TEST_CASE("(6.2) and (6.3)") {
    CHECK(has_map("chebyshev:3", product_qp,
                  "-(h^3+10*h^2+48*h+96)/(h^3-10*h^2+48*h-96), 0;"
                  "0, -(h^3-10*h^2+48*h-96)/(h^3+10*h^2+48*h+96)"));
    CHECK(has_map("gauss:2", product_qp,
                  "(h^2+6*h+12)/(h^2-6*h+12), 0; 0, (h^2-6*h+12)/(h^2+6*h+12)"));
    CHECK(!has_map("gauss:2", product_qp,
                   "(h^2+6*h+12)/(h^2-6*h+12), 0; 0, (h^2-6*h+12)/(h^2+6*h+13)"));
}

TEST_CASE("(6.5) and (6.6)") {
    const std::string D5 = "/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216)";
    const std::string m5 = "(-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)" + D5;
    CHECK(has_map("chebyshev:3", "w^2, 0; 0, 1",
                  m5 + ", (36*h^5*w^4-1248*h^3*w^2+9216*h)" + D5 + ";" +
                      "(-12*h^5*w^6+1248*h^3*w^4-9216*h*w^2)" + D5 + "," + m5));
    const std::string D6 = "/(h^4*w^4+12*h^2*w^2+144)";
    const std::string m6 = "(h^4*w^4-60*h^2*w^2+144)" + D6;
    CHECK(has_map("gauss:2", "w^2, 0; 0, 1",
                  m6 + ", (-12*h^3*w^2+144*h)" + D6 + "; (12*h^3*w^4-144*h*w^2)" + D6 + "," + m6));
}

TEST_CASE("symplectic Euler and Stoermer-Verlet as everybody knows them") {
    CHECK(has_map("symplectic-euler", "k, 0; 0, 1/m", "1-h^2*k/m, h/m; -h*k, 1"));
    CHECK(has_map("adjoint-symplectic-euler", "k, 0; 0, 1/m", "1, h/m; -h*k, 1-h^2*k/m"));
    CHECK(has_map("stormer-verlet", "k, 0; 0, 1/m",
                  "1-h^2*k/(2*m), h/m; -h*k+h^3*k^2/(4*m), 1-h^2*k/(2*m)"));
}

// ---- the reference ----

TEST_CASE("maps of the oscillator agree with the reference") {
    const Json known = reference("exact/reference_stability.json");
    int count = 0;
    for (const Json& entry : reference_methods()) {
        const auto expected = known.find(entry["name"].get<std::string>());
        if (expected == known.end() || !expected->contains("D")) { continue; }
        CAPTURE(entry["name"]);
        CHECK(with_method(
            method_of(entry), oscillator,
            [&](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                Ground of_z = ground;
                const Number omega = ground.parameter("omega");
                of_z.set_parameter("z", ground.parameter("h") * omega);
                const auto known_entry = [&](const char* name) {
                    return read((*expected)[name].template get<std::string>(), of_z);
                };
                const Number D = known_entry("D");
                const NumberMatrix M = one_step_map(tableau, H, ground).matrix;
                return are_equal(M, {{known_entry("m11") / D, known_entry("m12") / (D * omega)},
                                     {known_entry("m21") * omega / D, known_entry("m22") / D}});
            }));
        ++count;
    }
    CHECK(count == 42);
}

TEST_CASE("maps of H = q p agree with the reference") {
    const Json known = reference("linear/reference_qp.json");
    int count = 0;
    for (const Json& entry : reference_methods()) {
        const auto expected = known.find(entry["name"].get<std::string>());
        if (expected == known.end()) { continue; }
        CAPTURE(entry["name"]);
        CHECK(with_method(
            method_of(entry), product_qp,
            [&](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                const auto known_entry = [&](const char* name) {
                    return read((*expected)[name].template get<std::string>(), ground);
                };
                const NumberMatrix M = one_step_map(tableau, H, ground).matrix;
                return are_equal(M, {{known_entry("Rq_num") / known_entry("Rq_den"), Number(0)},
                                     {Number(0), known_entry("Rp_num") / known_entry("Rp_den")}});
            }));
        ++count;
    }
    CHECK(count == 42);
}

// ---- the stage equations, solved in another way ----

TEST_CASE("a step with numbers is what elimination in the stage equations gives") {
    std::mt19937 generator(20240229);
    for (const char* const name : many_methods) {
        const std::string hamiltonian = random_form(generator);
        CAPTURE(name, hamiltonian);
        CHECK(with_method(any_method(name), hamiltonian,
                          [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                              const Number h = read("1/7", ground);
                              Ground with_step = ground;
                              with_step.set_parameter("h", h);
                              const LinearMap map = one_step_map(tableau, H, with_step);
                              const NumberVector start = vector_of("1, -2, 3, 1/2", ground);
                              return are_equal(plus(map.matrix * start, map.offset),
                                               step_by_elimination(tableau, H, h, start).end);
                          }));
    }
}

TEST_CASE("coordinates of the stages do not matter") {
    for (const char* const name : {"gauss:2", "gauss:3", "lobatto:3", "lobatto:4", "chebyshev:3"}) {
        CAPTURE(name);
        CHECK(with_method(any_method(name), coupled_any,
                          [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                              Tableau by_values = tableau;
                              by_values.galerkin.reset();
                              return tableau.node_polynomial() != nullptr &&
                                     are_equal(one_step_map(tableau, H, ground).matrix,
                                               one_step_map(by_values, H, ground).matrix);
                          }));
    }
}

// ---- what a map of a step has to satisfy ----

TEST_CASE("maps are symplectic") {
    for (const char* const name : many_methods) {
        for (const char* const hamiltonian : many_hamiltonians) {
            CAPTURE(name, hamiltonian);
            CHECK(with_method(
                any_method(name), hamiltonian,
                [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                    return is_symplectic(one_step_map(tableau, H, ground).matrix);
                }));
        }
    }
}

TEST_CASE("determinants are 1") {
    for (const char* const name : many_methods) {
        CAPTURE(name);
        CHECK(with_method(any_method(name), any_one,
                          [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                              const NumberMatrix M = one_step_map(tableau, H, ground).matrix;
                              return (M[0][0] * M[1][1] - M[0][1] * M[1][0]).is_one();
                          }));
    }
}

TEST_CASE("maps of four degrees of freedom are symplectic") {
    for (const char* const name : {"gauss:2", "lobatto:3", "trig3"}) {
        for (const char* const hamiltonian : {four_springs, four_any}) {
            CAPTURE(name, hamiltonian);
            CHECK(with_method(
                any_method(name), hamiltonian,
                [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                    return is_symplectic(one_step_map(tableau, H, ground).matrix);
                }));
        }
    }
}

TEST_CASE("nodes without closed forms do no harm to polynomials") {
    for (const char* const name : {"gauss:8", "chebyshev:9", "clenshaw-curtis:12"}) {
        CAPTURE(name);
        CHECK(with_method(any_method(name), oscillator,
                          [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                              return is_symplectic(one_step_map(tableau, H, ground).matrix);
                          }));
    }
}

TEST_CASE("a method that is not symplectic has no symplectic map") {
    CHECK(with_method(any_method("radau-left:2"), any_one,
                      [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                          Tableau wrong = tableau;
                          wrong.galerkin.reset();
                          wrong.A_tilde = wrong.A;
                          return !is_symplectic(one_step_map(wrong, H, ground).matrix);
                      }));
    // ERRATA A1: the A~ printed in Example 4.5 makes it the trapezoidal rule, which is conjugate to
    // the midpoint rule, and for linear systems the same: only the right one is explicit.
    const std::string midpoint = "(4-h^2*k)/(4+h^2*k), 4*h/(4+h^2*k);"
                                 "-4*h*k/(4+h^2*k), (4-h^2*k)/(4+h^2*k)";
    CHECK(with_method(any_method("stormer-verlet"), "k, 0; 0, 1",
                      [&](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                          Tableau misprint = tableau;
                          misprint.galerkin.reset();
                          misprint.A_tilde = matrix_of("0, 0; 1/2, 1/2", ground);
                          return are_equal(one_step_map(misprint, H, ground).matrix,
                                           matrix_of(midpoint, ground));
                      }));
    CHECK(has_map("midpoint", "k, 0; 0, 1", midpoint));
    CHECK(!has_map("stormer-verlet", "k, 0; 0, 1", midpoint));
}

TEST_CASE("a linear part moves the point around which all turns") {
    for (const char* const name : many_methods) {
        CAPTURE(name);
        // grad H = 0 at (1, -2, 3, 1/2).
        CHECK(with_method(any_method(name), coupled_any,
                          [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                              const NumberVector point = vector_of("1, -2, 3, 1/2", ground);
                              QuadraticForm moved = H;
                              moved.g = H.S * point * Number(-1);
                              const LinearMap about_zero = one_step_map(tableau, H, ground);
                              const LinearMap map = one_step_map(tableau, moved, ground);
                              return are_equal(map.matrix, about_zero.matrix) &&
                                     are_equal(plus(map.matrix * point, map.offset), point);
                          }));
    }
}

TEST_CASE("falling is exact from order 2 on") {
    CHECK(has_map("midpoint", "0, 0; 0, 1/m | m*g, 0", "1, h/m; 0, 1", "-g*h^2/2, -m*g*h"));
    CHECK(has_map("trig3", "0, 0; 0, 1/m | m*g, 0", "1, h/m; 0, 1", "-g*h^2/2, -m*g*h"));
    CHECK(
        !has_map("symplectic-euler", "0, 0; 0, 1/m | m*g, 0", "1, h/m; 0, 1", "-g*h^2/2, -m*g*h"));
}

TEST_CASE("degrees of freedom that do not couple go their own ways") {
    CHECK(has_map("gauss:2", "1, 0, 0, 0; 0, 0, 0, 1; 0, 0, 0, 0; 0, 1, 0, 0 | 0, 0, 2, 0",
                  "1, 0, 0, 0; 0, (h^2+6*h+12)/(h^2-6*h+12), 0, 0;"
                  "-h, 0, 1, 0; 0, 0, 0, (h^2-6*h+12)/(h^2+6*h+12)",
                  "2*h, 0, -h^2, 0"));
    // H = q_1 p_2 and H = q_2 p_1.
    CHECK(has_map("gauss:2", "0, 0, 0, 1; 0, 0, 0, 0; 0, 0, 0, 0; 1, 0, 0, 0",
                  "1, 0, 0, 0; h, 1, 0, 0; 0, 0, 1, -h; 0, 0, 0, 1", "0, 0, 0, 0"));
    CHECK(has_map("gauss:2", "0, 0, 0, 0; 0, 0, 1, 0; 0, 1, 0, 0; 0, 0, 0, 0",
                  "1, h, 0, 0; 0, 1, 0, 0; 0, 0, 1, 0; 0, 0, -h, 1", "0, 0, 0, 0"));
    // q_1 couples with q_3, and q_2 with p_2 alone: twice the same pair, and an oscillator between.
    CHECK(
        with_method(any_method("lobatto:3"),
                    "3, 0, -1, 0, 0, 0; 0, k, 0, 0, 0, 0; -1, 0, 2, 0, 0, 0;"
                    "0, 0, 0, 1, 0, 0; 0, 0, 0, 0, 1, 0; 0, 0, 0, 0, 0, m",
                    [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                        const NumberMatrix M = one_step_map(tableau, H, ground).matrix;
                        const NumberMatrix pair =
                            one_step_map(tableau, form_of(coupled_springs, ground), ground).matrix;
                        const NumberMatrix single =
                            one_step_map(tableau, form_of("k, 0; 0, 1", ground), ground).matrix;
                        return are_equal(M[0], {pair[0][0], Number(0), pair[0][1], pair[0][2],
                                                Number(0), pair[0][3]}) &&
                               are_equal(M[1], {Number(0), single[0][0], Number(0), Number(0),
                                                single[0][1], Number(0)}) &&
                               are_equal(M[5], {pair[3][0], Number(0), pair[3][1], pair[3][2],
                                                Number(0), pair[3][3]});
                    }));
}

// ---- order ----

namespace {

/// The largest entry of M(h) - exp(h J S), for a step that is a number.
double error(const Tableau& tableau, const QuadraticForm& H, Ground ground, const std::string& h) {
    ground.set_parameter("h", read(h, ground));
    const NumberMatrix F = symplectic_matrix(H.degrees_of_freedom()) * H.S * read(h, ground);
    NumberMatrix term = identity(F.size());
    NumberMatrix exponential = term;
    for (long k = 1; k <= 30; ++k) {
        term = term * F * (Number(1) / Number(k));
        exponential = exponential + term;
    }
    double largest = 0;
    for (const NumberVector& row :
         one_step_map(tableau, H, ground).matrix + exponential * Number(-1)) {
        for (const Number& entry : row) {
            largest = std::max(largest, std::abs(entry.nearest_double()));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("maps agree with the flow up to the method's order") {
    const std::pair<const char*, int> orders[] = {
        {"symplectic-euler", 1}, {"stormer-verlet", 2},      {"trig3", 2},   {"chebyshev:3", 4},
        {"gauss:3", 6},          {"radau-left:2", 3},        {"gauss:4", 8}, {"lobatto:4", 6},
        {"chebyshev:4", 6},      {"newton-cotes-open:4", 2},
    };
    for (const auto& [name, order] : orders) {
        CAPTURE(name, order);
        const double ratio = with_method(
            any_method(name), "3, -1, 2, 1; -1, 2, 1, 0; 2, 1, 1, -1; 1, 0, -1, 5",
            [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                return error(tableau, H, ground, "1/256") / error(tableau, H, ground, "1/512");
            });
        CHECK(std::log2(ratio) == Approx(order + 1).margin(0.1));
    }
}

// ---- lowest terms ----

TEST_CASE("entries are in lowest terms") {
    CHECK(map_texts("gauss:2", product_qp) ==
          std::vector<std::string>{"(h^2+6*h+12)/(h^2-6*h+12)", "0", "0",
                                   "(h^2-6*h+12)/(h^2+6*h+12)"});
    CHECK(map_texts("gauss:8", "0, 0; 0, 1") == std::vector<std::string>{"1", "h", "0", "1"});
    CHECK(map_texts("stormer-verlet", "k, 0; 0, 1")[0] == "1-h^2*k/2");
    // Two equal oscillators that couple in no way but through the coordinates chosen.
    const auto turned = map_texts("midpoint", "5/4, 3/4, 0, 0; 3/4, 5/4, 0, 0;"
                                              "0, 0, 5/4, -3/4; 0, 0, -3/4, 5/4");
    CHECK(turned[0] == "(4-h^2)/(h^2+4)");
    CHECK(turned[1] == "0");
}

TEST_CASE("square roots of the coefficients that cancel are gone") {
    const char* const chebyshev =
        "1, tau, tau^2 | 1/2-sqrt(2)/4, 1/2, 1/2+sqrt(2)/4";  // the nodes of chebyshev:3
    CHECK(map_texts(chebyshev, oscillator) == map_texts("chebyshev:3", oscillator));
    const char* const gauss = "1, tau | 1/2-sqrt(3)/6, 1/2+sqrt(3)/6";
    CHECK(map_texts(gauss, coupled_any) == map_texts("gauss:2", coupled_any));
    CHECK(map_texts("gauss:2", "0, sqrt(2); sqrt(2), 0")[3] ==
          "(h^4-6*h^3*sqrt(2)+30*h^2-36*h*sqrt(2)+36)/(h^4-6*h^2+36)");
    CHECK(map_texts("gauss:2", "sqrt(2), 0; 0, sqrt(2)")[0] == "(h^4-30*h^2+36)/(h^4+6*h^2+36)");
}

// ---- refusals ----

namespace {

std::string refusal(const std::string& method, const std::string& hamiltonian) {
    try {
        with_method(any_method(method), hamiltonian,
                    [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                        return one_step_map(tableau, H, ground).offset.size();
                    });
    } catch (const MathError& error) {
        CHECK(!error.help().empty());
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("what has no closed form is refused, and what nobody could read") {
    CHECK(refusal("1, exp(tau^2) | 0, 1", oscillator) ==
          "A[2][1] has no closed form, and so the map of one step has none");
    CHECK(refusal("1, cos(tau), sin(tau), tau, tau^2, tau^3 | gauss:6", oscillator) ==
          "A[1][1] has no closed form, and so the map of one step has none");
    CHECK(refusal("gauss:6", oscillator).empty());
    CHECK(refusal("midpoint", "atan(1/3), 0; 0, 1") ==
          "a coefficient of the Hamiltonian has no closed form, and so the map of one step has "
          "none");
    std::string chain;
    for (int i = 0; i < 66; ++i) {
        for (int j = 0; j < 66; ++j) {
            chain += (j > 0   ? ","
                      : i > 0 ? ";"
                              : "") +
                     std::string(i == j || (i < 33 && j < 33 && std::abs(i - j) == 1) ? "1" : "0");
        }
    }
    CHECK(refusal("gauss:2", chain) == "the map of one step is too long: its stages couple 132 "
                                       "unknowns, more than 128");
    std::string symbols;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            symbols += (j > 0   ? ","
                        : i > 0 ? ";"
                                : "") +
                       std::string("x") + std::to_string(std::min(i, j)) +
                       std::to_string(std::max(i, j));
        }
    }
    CHECK(refusal("gauss:3", symbols) ==
          "the equations of the stages have a solution of more than 1000000 terms");
}
