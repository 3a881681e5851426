// The generating function of a step against (4.19), the map, the paper and the exact one.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "generator/linear/exact_hamiltonian.hpp"
#include "tests/generator/linear/linear.hpp"
#include "tests/generator/linear/stages.hpp"

using namespace hvi::gen;

namespace {

/// Calls `check` with the generating function, on its ground.
template <class Check>
auto with_function(const std::string& method, const std::string& hamiltonian, Check check) {
    return with_method(any_method(method), hamiltonian,
                       [&](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                           return check(generating_function(tableau, H, ground), ground);
                       });
}

int order_of_difference(const std::string& method, const std::string& hamiltonian) {
    return with_function(method, hamiltonian,
                         [](const GeneratingFunction& function, const Ground&) {
                             CHECK(!function.is_at_least);
                             return function.order_of_difference;
                         });
}

/// The tableau with coefficients for p that were not derived from it.
Tableau with_partner(Tableau tableau, NumberMatrix A_tilde) {
    tableau.galerkin.reset();
    tableau.A_tilde = std::move(A_tilde);
    return tableau;
}

/// Whether p_0 = D_1 H_d^+(q_0, p_1) and q_1 = D_2 H_d^+(q_0, p_1) with (q_1, p_1) from the map,
/// for (q_0, p_0) = 0 and the unit vectors.
bool generates(const QuadraticForm& H_d, const LinearMap& map) {
    const std::size_t size = map.offset.size();
    const std::size_t n = size / 2;
    for (std::size_t k = 0; k <= size; ++k) {
        NumberVector start(size);
        if (k < size) { start[k] = Number(1); }
        const NumberVector end = plus(map.matrix * start, map.offset);
        NumberVector mixed = start;
        NumberVector other = end;
        for (std::size_t i = 0; i < n; ++i) {
            mixed[n + i] = end[n + i];
            other[i] = start[n + i];
            other[n + i] = end[i];
        }
        if (!are_equal(plus(H_d.S * mixed, H_d.g), other)) { return false; }
    }
    return true;
}

}  // namespace

// ---- the definition, and the map ----

TEST_CASE("H_d^+ is what (4.19) says of the stages") {
    std::mt19937 generator(20240301);
    for (const char* const name : many_methods) {
        const std::string hamiltonian = random_form(generator);
        CAPTURE(name, hamiltonian);
        CHECK(with_method(
            any_method(name), hamiltonian,
            [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                const Number h = read("1/7", ground);
                Ground with_step = ground;
                with_step.set_parameter("h", h);
                const Step step =
                    step_by_elimination(tableau, H, h, vector_of("1, -2, 3, 1/2", ground));
                const NumberVector mixed = {Number(1), Number(-2), step.end[2], step.end[3]};
                Number expected = mixed[0] * mixed[2] + mixed[1] * mixed[3];
                for (std::size_t i = 0; i < tableau.stages(); ++i) {
                    const NumberVector& K_i = step.gradients[i];
                    expected = expected + h * tableau.b[i] * value_of(H, step.stages[i]);
                    for (std::size_t j = 0; j < tableau.stages(); ++j) {
                        const NumberVector& K_j = step.gradients[j];
                        expected = expected - h * h * tableau.b[i] * tableau.A[i][j] *
                                                  (K_i[0] * K_j[2] + K_i[1] * K_j[3]);
                    }
                }
                const QuadraticForm discrete = generating_function(tableau, H, with_step).discrete;
                return (value_of(discrete, mixed) - expected).is_zero();
            }));
    }
}

TEST_CASE("H_d^+ generates the map (3.10)") {
    for (const char* const name : many_methods) {
        for (const char* const hamiltonian : many_hamiltonians) {
            CAPTURE(name, hamiltonian);
            CHECK(with_method(
                any_method(name), hamiltonian,
                [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                    const GeneratingFunction function = generating_function(tableau, H, ground);
                    return function.gives_map && function.is_symmetric &&
                           generates(function.discrete, one_step_map(tableau, H, ground));
                }));
        }
    }
}

/// Whether q_1 depends on all of p_0, by the map.
bool q_depends_on_p(const LinearMap& map) {
    const std::size_t n = map.offset.size() / 2;
    NumberMatrix by_p;
    for (std::size_t i = 0; i < n; ++i) {
        const NumberVector& row = map.matrix[i];
        by_p.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(n), row.end());
    }
    return inverse(by_p).has_value();
}

TEST_CASE("there is a function of type I where the end's positions depend on all momenta") {
    for (const char* const hamiltonian : many_hamiltonians) {
        CAPTURE(hamiltonian);
        CHECK(with_method(any_method("gauss:2"), hamiltonian,
                          [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                              return generating_function(tableau, H, ground).has_type_one ==
                                     q_depends_on_p(one_step_map(tableau, H, ground));
                          }));
    }
    const auto has_type_one = [](const char* hamiltonian, const char* method = "midpoint") {
        return with_function(method, hamiltonian,
                             [](const GeneratingFunction& function, const Ground&) {
                                 return function.has_type_one;
                             });
    };
    // In (q, p), or (q1, q2, p1, p2), of p^2/2, q^2/2, q1 p2 - q2 p1, p1^2/2 + q2 p2, and p1 p2 +
    // q1^2:
    CHECK(has_type_one("0, 0; 0, 1"));
    CHECK(has_type_one(oscillator));
    CHECK_FALSE(has_type_one(product_qp));
    CHECK_FALSE(has_type_one("1, 0; 0, 0"));
    CHECK_FALSE(has_type_one("0, 0, 0, 1; 0, 0, -1, 0; 0, -1, 0, 0; 1, 0, 0, 0"));
    CHECK_FALSE(has_type_one("0, 0, 0, 0; 0, 0, 0, 1; 0, 0, 1, 0; 0, 1, 0, 0"));
    CHECK(has_type_one("2, 0, 0, 0; 0, 0, 0, 0; 0, 0, 0, 1; 0, 0, 1, 0"));
    // p1^2/2 + q1 p2: d2H/dp2 is singular, and q_1 all the same depends on both momenta (see
    // docs/inside/paper.md, where type I fails), but where one stage tells it of them.
    const char* const hidden = "0, 0, 0, 1; 0, 0, 0, 0; 0, 0, 1, 0; 1, 0, 0, 0";
    CHECK(has_type_one(hidden, "gauss:2"));
    CHECK_FALSE(has_type_one(hidden, "midpoint"));
}

TEST_CASE("H_d^+ for H = q p by (6.2) and (6.3)") {
    const auto is_qp_times = [](const char* factor) {
        return [factor](const GeneratingFunction& function, const Ground& ground) {
            const Number R = read(factor, ground);
            return are_equal(function.discrete,
                             {{{Number(0), R}, {R, Number(0)}}, NumberVector(2), Number(0)});
        };
    };
    CHECK(with_function("gauss:2", product_qp, is_qp_times("(h^2+6*h+12)/(h^2-6*h+12)")));
    CHECK(with_function("chebyshev:3", product_qp,
                        is_qp_times("-(h^3+10*h^2+48*h+96)/(h^3-10*h^2+48*h-96)")));
    CHECK(!with_function("chebyshev:3", product_qp, is_qp_times("(h^2+6*h+12)/(h^2-6*h+12)")));
}

TEST_CASE("H_d^+ for the oscillator by (6.6)") {
    // From q_1 = m11 q_0 + m12 p_0 and p_1 = m21 q_0 + m22 p_0, all over D.
    CHECK(with_function(
        "gauss:2", "w^2, 0; 0, 1", [](const GeneratingFunction& function, const Ground& ground) {
            const Number D = read("h^4*w^4+12*h^2*w^2+144", ground);
            const Number m22 = read("h^4*w^4-60*h^2*w^2+144", ground);
            const Number m21 = read("12*h^3*w^4-144*h*w^2", ground);
            const Number m12 = read("-12*h^3*w^2+144*h", ground);
            return are_equal(
                function.discrete,
                {{{-m21 / m22, D / m22}, {D / m22, m12 / m22}}, NumberVector(2), Number(0)});
        }));
}

TEST_CASE("a method that is not symplectic has no generating function") {
    CHECK(with_method(any_method("radau-left:2"), any_one,
                      [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                          const auto function =
                              generating_function(with_partner(tableau, tableau.A), H, ground);
                          return !function.is_symmetric && !function.gives_map;
                      }));
    // ERRATA A1: with the A~ that Example 4.5 prints, (4.19) is no generating function. For linear
    // systems there is another one, that of the midpoint rule.
    CHECK(with_method(any_method("stormer-verlet"), "k, 0; 0, 1",
                      [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                          const Tableau misprint =
                              with_partner(tableau, matrix_of("0, 0; 1/2, 1/2", ground));
                          const auto function = generating_function(misprint, H, ground);
                          return function.is_symmetric && !function.gives_map &&
                                 !generates(function.discrete, one_step_map(misprint, H, ground));
                      }));
}

// ---- the exact discrete Hamiltonian ----

namespace {

bool has_exact(const std::string& hamiltonian, const std::string& expected) {
    return with_function(
        "midpoint", hamiltonian, [&](const GeneratingFunction& function, const Ground& ground) {
            return function.exact && are_equal(*function.exact, form_of(expected, ground));
        });
}

bool has_no_exact(const std::string& hamiltonian) {
    return with_function(
        "midpoint", hamiltonian,
        [](const GeneratingFunction& function, const Ground&) { return !function.exact; });
}

}  // namespace

TEST_CASE("exact discrete Hamiltonians in closed form") {
    CHECK(has_exact(product_qp, "0, exp(h); exp(h), 0"));
    CHECK(has_exact("0, -lambda; -lambda, 0", "0, exp(-h*lambda); exp(-h*lambda), 0"));
    CHECK(has_exact("w^2, 0; 0, 1",
                    "w*sin(h*w)/cos(h*w), 1/cos(h*w); 1/cos(h*w), sin(h*w)/(w*cos(h*w))"));
    CHECK(has_exact("0, 0; 0, 1/m", "0, 1; 1, h/m"));
    // Falling: p = p_1 + m g (h - t) and q' = p/m; H_d^+ = p_1 q_1 - integral of p q' - H.
    CHECK(has_exact("0, 0; 0, 1/m | m*g, 0 | k",
                    "0, 1; 1, h/m | m*g*h, g*h^2/2 | m*g^2*h^3/6 + h*k"));
    CHECK(has_exact("0, 0; 0, 0 | a, b", "0, 1; 1, 0 | a*h, b*h | a*b*h^2/2"));
    // (q + p)^2/2: q + p is constant.
    CHECK(has_exact("1, 1; 1, 1", "h/(1-h), 1/(1-h); 1/(1-h), h/(1-h)"));
    CHECK(has_exact("0, 0, 0, 0; 0, 1, 0, 0; 0, 0, 2, 1; 0, 0, 1, 1 | 1, 0, 0, 0",
                    "0, 0, 1, 0; 0, 0, 0, 1; 1, 0, 2*h, h; 0, 1, h, h | 0, 0, 0, 0") == false);
    CHECK(has_exact("0, 0, 0, 0; 0, 0, 0, 0; 0, 0, 2, 1; 0, 0, 1, 1",
                    "0, 0, 1, 0; 0, 0, 0, 1; 1, 0, 2*h, h; 0, 1, h, h"));
    CHECK(has_exact("1, 0, 0, 0; 0, 0, 0, 1; 0, 0, 1, 0; 0, 1, 0, 0",
                    "sin(h)/cos(h), 0, 1/cos(h), 0; 0, 0, 0, exp(h);"
                    "1/cos(h), 0, sin(h)/cos(h), 0; 0, exp(h), 0, 0"));
    CHECK(has_no_exact("k, 0; 0, 1"));
    CHECK(has_no_exact(coupled_springs));
    CHECK(has_no_exact("1, 1; 1, 1 | g, 0"));
    CHECK(has_no_exact("1, 0, 0, 0; 0, k, 0, 0; 0, 0, 1, 0; 0, 0, 0, 1"));
}

namespace {

/// The sum of the first coefficients of the series at h.
NumberMatrix partial_sum(const QuadraticForm& H, const Number& h, std::size_t count) {
    ExactSeries series(H);
    NumberMatrix sum = series[count - 1];
    for (std::size_t k = count - 1; k-- > 0;) { sum = sum * h + series[k]; }
    return sum;
}

double largest(const NumberMatrix& matrix) {
    double result = 0;
    for (const NumberVector& row : matrix) {
        for (const Number& entry : row) {
            result = std::max(result, std::abs(entry.nearest_double()));
        }
    }
    return result;
}

}  // namespace

TEST_CASE("closed forms satisfy the Hamilton-Jacobi equation (2.7)") {
    for (const char* const hamiltonian :
         {"2, 1; 1, 3 | 1, -2", "2, 3; 3, 1 | 1, -2", "2, 0; 0, 2", "-1, 0; 0, 1 | 3, 1",
          "0, 1/2; 1/2, 0 | 1, 1", "1, 1; 1, 1", "0, 0; 0, 3 | 1, 2", "5, 0; 0, 0 | 1, 2"}) {
        CAPTURE(hamiltonian);
        CHECK(with_method(any_method("midpoint"), hamiltonian,
                          [](const Tableau&, const QuadraticForm& H, const Ground& ground) {
                              Ground with_step = ground;
                              const Number h = read("1/64", ground);
                              with_step.set_parameter("h", h);
                              const auto exact = exact_discrete_hamiltonian(H, with_step);
                              return largest(bordered(exact.value()) +
                                             partial_sum(H, h, 25) * Number(-1));
                          }) < 1e-28);
    }
}

TEST_CASE("the exact series generates the flow") {
    CHECK(with_method(any_method("midpoint"),
                      "3, -1, 2, 1; -1, 2, 1, 0; 2, 1, 1, -1; 1, 0, -1, 5 | 1, 2, 3, 4",
                      [](const Tableau&, const QuadraticForm& H, const Ground& ground) {
                          const Number h = read("1/64", ground);
                          // exp of h (JS, Jg; 0, 0)
                          const NumberMatrix J = symplectic_matrix(2);
                          const NumberMatrix F =
                              stacked(beside(J * H.S, J * transpose({H.g})), zeros(1, 5)) * h;
                          NumberMatrix term = identity(5);
                          NumberMatrix flow = term;
                          for (long k = 1; k <= 30; ++k) {
                              term = term * F * (Number(1) / Number(k));
                              flow = flow + term;
                          }
                          const NumberMatrix E = partial_sum(H, h, 25);
                          const NumberMatrix start = identity(5);
                          const NumberMatrix mixed = stacked(
                              stacked(rows(start, 0, 2), rows(flow, 2, 4)), rows(start, 4, 5));
                          const NumberMatrix other = stacked(rows(start, 2, 4), rows(flow, 0, 2));
                          return largest(rows(E * mixed, 0, 4) + other * Number(-1));
                      }) < 1e-28);
}

// ---- the difference ----

TEST_CASE("the discrete Hamiltonian approximates the exact one to the method's order") {
    // A method of order r errs with h^(r+1); H in which all of q and p meet.
    CHECK(order_of_difference("symplectic-euler", any_one) == 2);
    CHECK(order_of_difference("midpoint", any_one) == 3);
    CHECK(order_of_difference("stormer-verlet", any_one) == 3);
    CHECK(order_of_difference("trig3", any_one) == 3);
    CHECK(order_of_difference("gauss:2", any_one) == 5);
    CHECK(order_of_difference("chebyshev:3", any_one) == 5);
    CHECK(order_of_difference("lobatto:3", coupled_any) == 5);
    CHECK(order_of_difference("radau-left:2", coupled_any) == 4);
    CHECK(order_of_difference("gauss:3", coupled_springs) == 7);
    CHECK(order_of_difference("chebyshev:4", coupled_any) == 7);
    CHECK(order_of_difference("gauss:8", oscillator) == 17);
    // For H = q p it is one rational function against exp(h): more than the method's order.
    CHECK(order_of_difference("newton-cotes-open:4", any_one) == 3);
    CHECK(order_of_difference("newton-cotes-open:4", product_qp) == 5);
    // The worst of two parts counts.
    CHECK(order_of_difference("newton-cotes-open:4",
                              "0, 0, 1, 0; 0, 1, 0, 0; 1, 0, 0, 0; 0, 0, 0, 1") == 3);
}

TEST_CASE("the first term of the difference is that of Figure 2") {
    // R(h) - exp(h) = -h^5/720 + ... for GauLe4, and h^5/2880 + ... for Cheby4.
    const auto ratio = [](const char* method) {
        return with_method(
            any_method(method), product_qp,
            [](const Tableau& tableau, const QuadraticForm& H, const Ground& ground) {
                Ground with_step = ground;
                const Number h = read("1/1000", ground);
                with_step.set_parameter("h", h);
                const auto function = generating_function(tableau, H, with_step);
                const Number difference = function.discrete.S[0][1] - ground.exp(h);
                return (difference / power(h, 5)).nearest_double();
            });
    };
    CHECK(ratio("gauss:2") == Approx(-1.0 / 720).epsilon(0.01));
    CHECK(ratio("chebyshev:3") == Approx(1.0 / 2880).epsilon(0.01));
}

TEST_CASE("where a method is exact the difference has no order") {
    for (const char* const hamiltonian :
         {"0, 0; 0, 1/m", "0, 0; 0, 1 | g, 0 | k", "0, 0; 0, 0 | a, b", "1, 1; 1, 1",
          "0, 0, 0, 0; 0, 0, 0, 0; 0, 0, 2, 1; 0, 0, 1, 1"}) {
        CAPTURE(hamiltonian);
        CHECK(with_function(
            "gauss:2", hamiltonian, [](const GeneratingFunction& function, const Ground&) {
                return function.is_at_least && function.order_of_difference == 15 &&
                       (!function.exact || are_equal(function.discrete, *function.exact));
            }));
    }
    // Falling bodies are not exact with one evaluation of the force at the end.
    CHECK(order_of_difference("symplectic-euler", "0, 0; 0, 1 | g, 0") == 2);
}
