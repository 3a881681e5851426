// Exact entries against numerical interpolation and integration, which share no code with them, for
// random bases and nodes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <arb_hypgeom.h>
#include <arb_mat.h>

#include <random>

#include <catch2/catch.hpp>

#include "generator/exact/numbers/number_value.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

constexpr Precision working_bits = 400;

Ball ball(const std::string& fraction) { return ball_of_rational(fraction, working_bits); }

Ball apply(void (*function)(arb_t, const arb_t, slong), const Ball& argument) {
    Ball result;
    function(result.get(), argument.get(), working_bits);
    return result;
}

/// The value of an expression, straight from its tree.
Ball value(const Expression& expression, const Ball& tau) {
    using Kind = Expression::Kind;
    Ball result;
    const auto part = [&](std::size_t i) { return value(expression.arguments.at(i), tau); };
    switch (expression.kind) {
    case Kind::number: return ball(expression.numerator + "/" + expression.denominator);
    case Kind::symbol:
        if (expression.name == "tau") return tau;
        (expression.name == "pi" ? arb_const_pi : arb_const_e)(result.get(), working_bits);
        return result;
    case Kind::sum:
        for (const Expression& term : expression.arguments) {
            arb_add(result.get(), result.get(), value(term, tau).get(), working_bits);
        }
        return result;
    case Kind::product:
        arb_one(result.get());
        for (const Expression& factor : expression.arguments) {
            arb_mul(result.get(), result.get(), value(factor, tau).get(), working_bits);
        }
        return result;
    case Kind::negation: arb_neg(result.get(), part(0).get()); return result;
    case Kind::reciprocal: return apply(arb_inv, part(0));
    case Kind::power:
        arb_pow(result.get(), part(0).get(), part(1).get(), working_bits);
        return result;
    case Kind::call: break;
    case Kind::element:
    case Kind::sum_over: FAIL("indices are unrolled");
    }
    const std::string& name = expression.name;
    if (name == "sqrt") return apply(arb_sqrt, part(0));
    if (name == "exp") return apply(arb_exp, part(0));
    if (name == "log") return apply(arb_log, part(0));
    if (name == "cos") return apply(arb_cos, part(0));
    REQUIRE(name == "sin");
    return apply(arb_sin, part(0));
}

Ball value(const std::string& text, const Ball& tau = {}) {
    return value(parse_expression(source(text)), tau);
}

/// Gauss's rule with so many nodes that its error for the functions below is under 1e-70.
struct Rule {
    static constexpr slong nodes = 60;
    std::vector<Ball> points{nodes}, weights{nodes};

    Rule() {
        for (slong i = 0; i < nodes; ++i) {
            const auto k = static_cast<std::size_t>(i);
            arb_hypgeom_legendre_p_ui_root(points[k].get(), weights[k].get(), nodes,
                                           static_cast<ulong>(i), working_bits);
        }
    }

    /// The integral over [0, end].
    [[nodiscard]] Ball integral(const Expression& function, const Ball& end) const {
        Ball sum;
        Ball half;
        arb_mul_2exp_si(half.get(), end.get(), -1);
        for (std::size_t k = 0; k < points.size(); ++k) {
            Ball point;
            arb_add_ui(point.get(), points[k].get(), 1, working_bits);
            arb_mul(point.get(), point.get(), half.get(), working_bits);
            arb_addmul(sum.get(), weights[k].get(), value(function, point).get(), working_bits);
        }
        arb_mul(sum.get(), sum.get(), half.get(), working_bits);
        return sum;
    }
};

/// Row r of the integrals over [0, ends[r]] of the functions that interpolate at the nodes.
std::vector<std::vector<Ball>> integrals_of_phi(const std::vector<Expression>& psi,
                                                const std::vector<Ball>& nodes,
                                                const std::vector<Ball>& ends) {
    static const Rule rule;
    const auto s = static_cast<slong>(psi.size());
    arb_mat_t M, integrals, solution;
    arb_mat_init(M, s, s);
    arb_mat_init(integrals, s, static_cast<slong>(ends.size()));
    arb_mat_init(solution, s, static_cast<slong>(ends.size()));
    for (slong i = 0; i < s; ++i) {
        const Expression& function = psi[static_cast<std::size_t>(i)];
        for (slong j = 0; j < s; ++j) {
            const Ball& node = nodes[static_cast<std::size_t>(j)];
            arb_set(arb_mat_entry(M, i, j), value(function, node).get());
        }
        for (std::size_t r = 0; r < ends.size(); ++r) {
            arb_set(arb_mat_entry(integrals, i, static_cast<slong>(r)),
                    rule.integral(function, ends[r]).get());
        }
    }
    REQUIRE(arb_mat_solve(solution, M, integrals, working_bits) != 0);
    std::vector<std::vector<Ball>> rows(ends.size(), std::vector<Ball>(psi.size()));
    for (std::size_t r = 0; r < ends.size(); ++r) {
        for (std::size_t j = 0; j < psi.size(); ++j) {
            arb_set(rows[r][j].get(),
                    arb_mat_entry(solution, static_cast<slong>(j), static_cast<slong>(r)));
        }
    }
    for (auto* matrix : {M, integrals, solution}) arb_mat_clear(matrix);
    return rows;
}

/// To 50 digits of the larger of 1 and the number.
bool agree(const Ball& left, const Ball& right) {
    Ball distance, allowed;
    arb_sub(distance.get(), left.get(), right.get(), working_bits);
    arb_abs(distance.get(), distance.get());
    arb_abs(allowed.get(), right.get());
    arb_add_ui(allowed.get(), allowed.get(), 1, working_bits);
    arb_mul(allowed.get(), allowed.get(),
            ball("1/100000000000000000000000000000000000000000000000000").get(), working_bits);
    return arb_lt(distance.get(), allowed.get()) != 0;
}

/// A list drawn without repetition.
std::string draw(std::vector<std::string> pool, std::size_t count, std::mt19937& generator) {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = generator() % pool.size();
        list += (list.empty() ? "" : ", ") + pool[index];
        pool.erase(pool.begin() + static_cast<long>(index));
    }
    return list;
}

void check(const Tableau& tableau) {
    std::vector<Ball> ends;
    for (const Number& node : tableau.c) ends.push_back(value(text(node)));
    const std::vector<Ball> nodes = ends;
    ends.push_back(ball("1"));
    const auto expected = integrals_of_phi(tableau.provenance.basis, nodes, ends);
    for (std::size_t j = 0; j < tableau.stages(); ++j) {
        CHECK(agree(value(text(tableau.b[j])), expected.back()[j]));
        for (std::size_t i = 0; i < tableau.stages(); ++i) {
            CHECK(agree(value(text(tableau.A[i][j])), expected[i][j]));
            CHECK(agree(value(tableau.A[i][j].decimal(60)), expected[i][j]));
        }
    }
}

/// One number has one text. Only texts that do not take long to read.
void check_reads_back(const Tableau& tableau) {
    for (const NumberMatrix* matrix : {&tableau.A, &tableau.A_tilde}) {
        for (const NumberVector& row : *matrix) {
            for (const Number& entry : row) {
                const std::string written = text(entry);
                if (written.size() < 400) { CHECK(normal(written) == written); }
            }
        }
    }
}

}  // namespace

TEST_CASE("exact entries are what numerical integration gives, for random bases and nodes") {
    const std::vector<std::string> functions{
        "tau",        "tau^2",       "tau^3",        "exp(tau)",         "exp(-tau)",
        "exp(2*tau)", "cos(pi*tau)", "sin(pi*tau)",  "cos(2*pi*tau)",    "tau*exp(tau)",
        "cos(tau)",   "sin(tau)",    "tau*cos(tau)", "exp(tau)*sin(tau)"};
    const std::vector<std::string> nodes{"0", "1/6", "1/3", "1/2", "2/3", "5/6", "1", "-1/6"};
    const unsigned seed = GENERATE(1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U);
    std::mt19937 generator(seed);
    const std::size_t s = 2 + seed % 3;
    const std::string basis = "1, " + draw(functions, s - 1, generator);
    const std::string at = draw(nodes, s, generator);
    CAPTURE(seed, basis, at);
    std::optional<Tableau> tableau;
    try {
        tableau = derive(method(basis, at));
    } catch (const MathError& error) {
        WARN("refused: " << error.what());
        return;
    }
    check(*tableau);
    check_reads_back(*tableau);
}

TEST_CASE("exact entries of the families are what numerical integration gives") {
    for (const char* name : {"gauss:4", "gauss:5", "lobatto:5", "radau-left:3", "radau-right:3",
                             "clenshaw-curtis:5", "fejer:5", "chebyshev:5", "trig3"}) {
        CAPTURE(name);
        const Tableau tableau = derive(named_method(source(name)));
        check(tableau);
        check_reads_back(tableau);
    }
}

TEST_CASE("exponential bases at Gauss nodes are exact") {
    const Tableau tableau = derive(method("1, exp(tau), exp(-tau)", "gauss:3"));
    check(tableau);
    check_reads_back(tableau);
}
