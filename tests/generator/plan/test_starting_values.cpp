// Where the iteration of the stage equations begins: slopes of the last steps, extrapolated.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/plan/plan.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;

namespace {

/// Precondition: the step is iterated.
const std::vector<Extrapolation>& extrapolations(const Step& step) {
    return step.iteration()->extrapolation;
}

Step composed_in_lanes(const Tableau& tableau, const char* composition) {
    const auto text = std::make_shared<const Source>(Source{"--compose", composition});
    return plan({tableau, named_composition(text)},
                {.is_separable = true, .kinetic_is_quadratic = true},
                {.solver = Solver::automatic, .lanes = Lanes::stages});
}

std::vector<double> doubles_of(const NumberVector& numbers) {
    std::vector<double> result;
    for (const Number& number : numbers) { result.push_back(number.nearest_double()); }
    return result;
}

/// sum_j N_ij L_j for slopes f of a step of this size that begins at this time, L_j = size b_j f.
template <class Slope>
double extrapolated_from(const NumberVector& N_i, const Tableau& tableau, double start, double size,
                         Slope f) {
    const std::vector<double> b = doubles_of(tableau.b), c = doubles_of(tableau.c);
    double sum = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
        sum += N_i[j].nearest_double() * size * b[j] * f(start + size * c[j]);
    }
    return sum;
}

}  // namespace

TEST_CASE("extrapolation is exact for polynomials through the nodes") {
    // Slopes 1, c, c^2 of Lobatto: L_i = b_i c_i^k goes to b_i (1 + c_i)^k.
    const Tableau tableau = tableaux::lobatto_3();
    const Step step = plan({tableau}, {.is_separable = false});
    REQUIRE(extrapolations(step).size() == 1);
    const Extrapolation& from = extrapolations(step).front();
    for (int k = 0; k < 3; ++k) {
        const auto power = [&](const Number& x) {
            Number value = 1;
            for (int i = 0; i < k; ++i) { value = value * x; }
            return value;
        };
        for (std::size_t i = 0; i < 3; ++i) {
            Number sum = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                sum = sum + from.last[i][j] * tableau.b[j] * power(tableau.c[j]);
            }
            CHECK((sum - tableau.b[i] * power(Number(1) + tableau.c[i])).is_zero());
        }
    }
}

TEST_CASE("of many stages a polynomial of lower degree, near to the slopes, is extrapolated") {
    const std::size_t s = 16, degree = 10;
    const Tableau tableau = derive(method("gauss:16"));
    const Step step = plan({tableau}, {.is_separable = true}, {.solver = Solver::automatic});
    CHECK(dump(step).find("by the nearest polynomial of degree 10") != std::string::npos);
    const NumberMatrix N = extrapolations(step).at(0).last;
    // f(c_j) goes to f(1 + c_i) for f of this degree, and not for others.
    const auto is_exact = [&](std::size_t k) {
        const auto power = [k](double x) { return std::pow(x - 0.5, static_cast<double>(k)); };
        double farthest = 0, size = 0, largest_sum = 0;
        for (std::size_t i = 0; i < s; ++i) {
            double sum = 0, sizes = 0;
            for (std::size_t j = 0; j < s; ++j) {
                const double entry = N[i][j].nearest_double();
                sum += entry * tableau.b[j].nearest_double() * power(tableau.c[j].nearest_double());
                sizes += std::abs(entry);
            }
            const double right =
                tableau.b[i].nearest_double() * power(1 + tableau.c[i].nearest_double());
            farthest = std::max(farthest, std::abs(sum - right));
            size = std::max(size, std::abs(right));
            largest_sum = std::max(largest_sum, sizes);
        }
        CHECK(largest_sum < 1e8);
        return farthest < 1e-7 * size;
    };
    for (std::size_t k = 0; k <= degree; ++k) { CHECK(is_exact(k)); }
    CHECK_FALSE(is_exact(degree + 1));
    // Least squares: what is left over is orthogonal to polynomials of this degree, so that what
    // is orthogonal to them goes to 0. Of 16 alternating weights sum_j w_j c_j^k = 0 for k < 15,
    // w_j = 1/prod (c_j - c_k).
    std::vector<double> w(s, 1);
    for (std::size_t j = 0; j < s; ++j) {
        for (std::size_t k = 0; k < s; ++k) {
            if (k != j) { w[j] /= tableau.c[j].nearest_double() - tableau.c[k].nearest_double(); }
        }
    }
    const double largest = std::abs(*std::max_element(
        w.begin(), w.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
    for (std::size_t i = 0; i < s; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < s; ++j) {
            sum += N[i][j].nearest_double() * tableau.b[j].nearest_double() * w[j] / largest;
        }
        CHECK(std::abs(sum) < 1e-8);
    }
}

TEST_CASE("where nodes are near to each other, slopes are not extrapolated") {
    const auto is_extrapolated = [](const char* nodes, const char* basis = "1, tau, tau^2") {
        const Step step = plan({derive(method(basis, nodes))}, {.is_separable = true},
                               {.solver = Solver::automatic});
        return !extrapolations(step).empty();
    };
    CHECK(is_extrapolated("1/10, 2/10, 9/10"));
    CHECK_FALSE(is_extrapolated("1/10, 1/10+1/10^10, 9/10"));
    CHECK_FALSE(is_extrapolated("1/10, 1/10+1/10^20, 9/10"));  // one node, in doubles
    // One in each step, in doubles: no polynomial of degree 2 is orthogonal on these.
    CHECK_FALSE(
        is_extrapolated("1/2, 1/2+1/10^20, 1/2+2/10^20, 1/2+3/10^20", "1, tau, tau^2, tau^3"));
}

TEST_CASE("of few stages the slopes of two steps are extrapolated") {
    const auto takes_two = [](const char* name, Solver solver, Lanes lanes = Lanes::none) {
        const Step step = plan({derive(method(name))}, {.is_separable = true},
                               {.solver = solver, .lanes = lanes});
        return !extrapolations(step).empty() && extrapolations(step).at(0).before.has_value();
    };
    CHECK(takes_two("midpoint", Solver::fixed_point));
    CHECK(takes_two("gauss:3", Solver::automatic, Lanes::stages));
    CHECK(takes_two("gauss:5", Solver::automatic));
    CHECK_FALSE(takes_two("gauss:6", Solver::automatic));
    CHECK_FALSE(takes_two("gauss:2", Solver::of_user));
    CHECK_FALSE(takes_two("gauss:2", Solver::newton));
    CHECK_FALSE(takes_two("gauss:2", Solver::fixed_point, Lanes::ensemble));
    // The end of one step is the start of the next: no polynomial has two values there.
    CHECK_FALSE(takes_two("lobatto:3", Solver::fixed_point));

    // Exact for polynomials of degree 2 s - 1: slopes at c - 1 and at c - 2 go to those at c.
    const Tableau tableau = derive(method("gauss:2"));
    const Step step = plan({tableau}, {.is_separable = true}, {.solver = Solver::automatic});
    const Extrapolation from = extrapolations(step).at(0);
    for (int k = 0; k < 4; ++k) {
        const auto power = [&](const Number& x) {
            Number value = 1;
            for (int i = 0; i < k; ++i) { value = value * x; }
            return value;
        };
        for (std::size_t i = 0; i < 2; ++i) {
            Number sum = 0;
            for (std::size_t j = 0; j < 2; ++j) {
                const Number& c = tableau.c[j];
                sum = sum + from.last[i][j] * tableau.b[j] * power(c - Number(1)) +
                      (*from.before)[i][j] * tableau.b[j] * power(c - Number(2));
            }
            CHECK((sum - tableau.b[i] * power(tableau.c[i])).is_zero());
        }
    }
    // Four stages are fitted by least squares, of degree 6; expected from the normal equations, to
    // 60 digits.
    const Extrapolation fitted =
        extrapolations(plan({derive(method("gauss:4"))}, {.is_separable = true},
                            {.solver = Solver::automatic}))
            .at(0);
    CHECK(fitted.last[3][3].nearest_double() == 119.7540900668062);
    CHECK(fitted.last[1][0].nearest_double() == -40.37571180266715);
    CHECK(fitted.before.value()[0][0].nearest_double() == 0.20224718279206355);
    CHECK(fitted.before.value()[2][3].nearest_double() == -312.89049875193206);
}

TEST_CASE("slopes of steps in a row are extrapolated to the size of the next one") {
    const auto is_exact = [](const char* name, const char* composition, bool takes_two) {
        const Tableau tableau = derive(method(name));
        const Step step = composed_in_lanes(tableau, composition);
        const std::vector<double> sizes = doubles_of(step.in_a_row);
        const std::size_t parts = sizes.size();
        const std::vector<Extrapolation> from = extrapolations(step);
        REQUIRE(from.size() == parts);
        const auto f = [](double t) { return 1 + t * (2 - t * (3 + t * (1 - t * t))); };
        for (std::size_t part = 0; part < parts; ++part) {
            REQUIRE(from[part].before.has_value() == takes_two);
            const double last = sizes[(part + parts - 1) % parts];
            const double before = sizes[(part + parts - 2) % parts];
            for (std::size_t i = 0; i < tableau.b.size(); ++i) {
                double L = extrapolated_from(from[part].last[i], tableau, -last, last, f);
                if (takes_two) {
                    L += extrapolated_from((*from[part].before)[i], tableau, -last - before, before,
                                           f);
                }
                const double size = sizes[part];
                CHECK(L == Approx(size * tableau.b[i].nearest_double() *
                                  f(size * tableau.c[i].nearest_double())));
            }
        }
    };
    is_exact("gauss:6", "suzuki:4", false);
    is_exact("gauss:3", "yoshida:4", true);
    is_exact("gauss:4", "yoshida:6", true);
}

TEST_CASE("a step that is much larger than the one before has a polynomial of low degree") {
    // One step of yoshida:8 is 17 times as large.
    const Tableau tableau = derive(method("gauss:10"));
    const Step step = composed_in_lanes(tableau, "yoshida:8");
    const std::vector<double> sizes = doubles_of(step.in_a_row);
    const std::vector<Extrapolation> from = extrapolations(step);
    REQUIRE(from.size() == 15);
    for (std::size_t part = 0; part < 15; ++part) {
        const double last = sizes[(part + 14) % 15];
        for (std::size_t i = 0; i < 10; ++i) {
            double magnified = 0;
            for (const double entry : doubles_of(from[part].last[i])) {
                magnified += std::abs(entry);
            }
            CHECK(magnified <= 1e8);
            CHECK(extrapolated_from(from[part].last[i], tableau, -last, last, [](double) {
                      return 1.0;
                  }) == Approx(sizes[part] * tableau.b[i].nearest_double()));
        }
    }
}
