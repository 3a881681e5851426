// The discrete Hamiltonians of any H as series in h: by closed forms, and in numbers by the
// equations (2.7) and (4.19) themselves.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "generator/exact/methods/order.hpp"
#include "generator/series/series_trees.hpp"
#include "tests/generator/series/series_values.hpp"

using namespace hvi::gen;

namespace {

constexpr const char* henon_heiles = "(p1^2+p2^2)/2 + (q1^2+q2^2)/2 + q1^2*q2 - q2^3/3";
constexpr const char* nonseparable = "(q^2+1)*(p^2+1)/2";
constexpr const char* kepler = "(p1^2+p2^2)/2 - m/sqrt(q1^2+q2^2)";
constexpr const char* driven = "p^2/2 + (1+t)*q^2/2 + sin(t)*q*p";

std::string exact(const std::string& H, int terms) {
    std::string text;
    for (const auto& term : series("midpoint", H, terms).exact)
        text += (text.empty() ? "" : ", ") + to_text(*term);
    return text;
}

/// 0 where there is none.
int first_difference(const std::string& name, const std::string& H, int terms) {
    const DiscreteSeries found = series(name, H, terms);
    CHECK_FALSE(found.undecided);
    return found.first_difference.value_or(0);
}

/// dS/dh - H(D_2 S, p, t + h) of (2.7).
Real residual(const DiscreteSeries& series, const Hamiltonian& H, Real h) {
    const Point point = start(H);
    Point end = point;
    end["t"].value += h;
    for (std::size_t d = 0; d < H.degrees_of_freedom(); ++d) {
        Point along = point;
        along[H.momenta[d]].slope = 1;
        end[H.coordinates[d]] = {sum(series.exact, H, along, {h}).slope};
    }
    return sum(series.exact, H, point, {h, 1}).slope - evaluate(H.expression, end).value;
}

std::vector<Real> rounded(const NumberVector& numbers) {
    std::vector<Real> result;
    for (const Number& number : numbers) result.emplace_back(number.nearest_double());
    return result;
}

std::vector<std::vector<Real>> rounded(const NumberMatrix& rows) {
    std::vector<std::vector<Real>> result;
    for (const NumberVector& row : rows) result.push_back(rounded(row));
    return result;
}

/// The numbers of a tableau.
struct Rounded {
    std::vector<Real> b;
    std::vector<std::vector<Real>> a, a_tilde;

    explicit Rounded(const Tableau& tableau)
        : b(rounded(tableau.b)), a(rounded(tableau.A)), a_tilde(rounded(tableau.A_tilde)) {}
};

/// The second line of (4.19), by stages that solve (4.18) for given q_0 and p_1.
class Step {
public:
    Step(const Rounded& method, const Hamiltonian& H, Real h)
        : method_(method), H_(H), slopes_(gradient(H)), h_(h), stages_(method.b.size(), start(H)) {
        for (int round = 0; round < 200; ++round) update();
    }

    [[nodiscard]] Real discrete_hamiltonian() const {
        const Point point = start(H_);
        Real result = 0;
        for (std::size_t d = 0; d < H_.degrees_of_freedom(); ++d) {
            Real q = point.at(H_.coordinates[d]).value;
            for (std::size_t i = 0; i < stages_.size(); ++i) q += h_ * method_.b[i] * by_p(i, d);
            result += point.at(H_.momenta[d]).value * q;
            for (std::size_t i = 0; i < stages_.size(); ++i)
                result -= h_ * method_.b[i] * stages_[i].at(H_.momenta[d]).value * by_p(i, d);
        }
        for (std::size_t i = 0; i < stages_.size(); ++i)
            result += h_ * method_.b[i] * evaluate(H_.expression, stages_[i]).value;
        return result;
    }

private:
    [[nodiscard]] Real by_p(std::size_t i, std::size_t d) const {
        return evaluate(slopes_.by_momenta[d], stages_[i]).value;
    }
    [[nodiscard]] Real by_q(std::size_t i, std::size_t d) const {
        return evaluate(slopes_.by_coordinates[d], stages_[i]).value;
    }
    void update() {
        std::vector<Point> next(stages_.size(), start(H_));
        for (std::size_t i = 0; i < stages_.size(); ++i)
            for (std::size_t j = 0; j < stages_.size(); ++j) {
                next[i]["t"].value += h_ * method_.a[i][j];
                for (std::size_t d = 0; d < H_.degrees_of_freedom(); ++d) {
                    next[i][H_.coordinates[d]].value += h_ * method_.a[i][j] * by_p(j, d);
                    next[i][H_.momenta[d]].value +=
                        h_ * (method_.b[j] - method_.a_tilde[i][j]) * by_q(j, d);
                }
            }
        stages_ = next;
    }

    const Rounded& method_;
    const Hamiltonian& H_;
    Gradient slopes_;
    Real h_;
    std::vector<Point> stages_;
};

/// H_d^+ of (4.6) for H = p^2/2 + U(q, t) in all degrees of freedom: the stationary value over V of
/// p_1 (q_0 + h B V) - h V^T G V/2 + h sum_i b_i U(Q_i), Q_i = q_0 + h A_i V.
class GeneralStep {
public:
    GeneralStep(const GalerkinRule& rule, const Hamiltonian& H, Real h)
        : b_(rounded(rule.b)),
          c_(rounded(rule.c)),
          B_(rounded(rule.B)),
          A_(rounded(rule.A_psi)),
          G_(rounded(rule.gram)),
          H_(H),
          slopes_(gradient(H)),
          h_(h),
          start_(start(H)),
          V_(B_.size(), std::vector<Real>(H.degrees_of_freedom())) {
        for (int round = 0; round < 40; ++round) update();
    }

    [[nodiscard]] Real discrete_hamiltonian() const {
        Real result = 0;
        for (std::size_t d = 0; d < H_.degrees_of_freedom(); ++d) {
            const Real p = start_.at(H_.momenta[d]).value;
            result += p * start_.at(H_.coordinates[d]).value;
            for (std::size_t k = 0; k < V_.size(); ++k) {
                result += h_ * p * B_[k] * V_[k][d];
                for (std::size_t l = 0; l < V_.size(); ++l)
                    result -= h_ * G_[k][l] * V_[k][d] * V_[l][d] / 2;
            }
        }
        for (std::size_t i = 0; i < b_.size(); ++i)
            result += h_ * b_[i] * evaluate(H_.expression, at_node(i)).value;
        return result;
    }

private:
    /// Returns the point at a node, with p = 0.
    [[nodiscard]] Point at_node(std::size_t i) const {
        Point point = start_;
        point["t"].value += h_ * c_[i];
        for (std::size_t d = 0; d < H_.degrees_of_freedom(); ++d) {
            point[H_.momenta[d]] = {0};
            for (std::size_t k = 0; k < V_.size(); ++k)
                point[H_.coordinates[d]].value += h_ * A_[i][k] * V_[k][d];
        }
        return point;
    }

    /// G V = p_1 B + h sum_i b_i A_i dU/dq(Q_i).
    void update() {
        std::vector<std::vector<Real>> right(V_.size());
        for (std::size_t k = 0; k < V_.size(); ++k)
            for (const std::string& p : H_.momenta) right[k].push_back(start_.at(p).value * B_[k]);
        for (std::size_t i = 0; i < b_.size(); ++i) {
            const Point point = at_node(i);
            for (std::size_t d = 0; d < H_.degrees_of_freedom(); ++d) {
                const Real slope = evaluate(slopes_.by_coordinates[d], point).value;
                for (std::size_t k = 0; k < V_.size(); ++k)
                    right[k][d] += h_ * b_[i] * A_[i][k] * slope;
            }
        }
        for (std::size_t d = 0; d < H_.degrees_of_freedom(); ++d) solve(right, d);
    }

    /// Solves by sweeps of Gauss and Seidel.
    void solve(const std::vector<std::vector<Real>>& right, std::size_t d) {
        for (int sweep = 0; sweep < 200; ++sweep)
            for (std::size_t k = 0; k < V_.size(); ++k) {
                Real rest = right[k][d];
                for (std::size_t l = 0; l < V_.size(); ++l)
                    if (l != k) rest -= G_[k][l] * V_[l][d];
                V_[k][d] = rest / G_[k][k];
            }
    }

    std::vector<Real> b_, c_, B_;
    std::vector<std::vector<Real>> A_, G_;
    const Hamiltonian& H_;
    Gradient slopes_;
    Real h_;
    Point start_;
    std::vector<std::vector<Real>> V_;  ///< by function and degree of freedom
};

constexpr const char* cubic = "1, tau | roots(64*tau^3-96*tau^2+36*tau-1)";
constexpr const char* trigonometric = "1, cos(2*pi*tau) | 1/6, 1/2, 5/6 | 1/3, 1/3, 1/3";

/// The edges at a vertex are all of one kind, and two at most where it is the end on their p.
bool is_nystrom(const SeriesTree& tree) {
    std::vector<End> ends;
    if (tree.above) ends.push_back(*tree.above);
    for (const SeriesTreePointer& child : tree.children) {
        ends.push_back(child->above == End::p ? End::q : End::p);
        if (!is_nystrom(*child)) return false;
    }
    const bool is_one_kind = std::count(ends.begin(), ends.end(), End::p) == 0 ||
                             std::count(ends.begin(), ends.end(), End::q) == 0;
    return is_one_kind && (ends.size() <= 2 || ends.front() == End::q);
}

/// Returns the trees with 0, 1, ... arrows.
std::vector<SeriesTrees> unrooted_trees(SeriesFamily family, int arrows) {
    UnrootedTrees trees(family, [](const SeriesTree&) { return false; });
    std::vector<SeriesTrees> result;
    for (int n = 0; n <= arrows; ++n) result.push_back(trees.next());
    return result;
}

}  // namespace

TEST_CASE("trees without a root, whose edges have a direction") {
    const auto all = unrooted_trees(SeriesFamily::general, 7);
    const std::vector<std::size_t> counts = {1, 1, 3, 8, 27, 91, 350, 1376};  // OEIS A000238
    REQUIRE(all.size() == counts.size());
    for (std::size_t n = 0; n < all.size(); ++n) CHECK(all[n].size() == counts[n]);
}

TEST_CASE("those for a quadratic kinetic energy are some of them") {
    const auto all = unrooted_trees(SeriesFamily::general, 8);
    const auto nystrom = unrooted_trees(SeriesFamily::nystrom, 8);
    for (std::size_t n = 0; n < all.size(); ++n) {
        std::multiset<std::string> expected, found;
        for (const SeriesTreePointer& tree : all[n])
            if (is_nystrom(*tree)) expected.insert(tree->text);
        for (const SeriesTreePointer& tree : nystrom[n]) found.insert(tree->text);
        CHECK(found == expected);
    }
}

// The stationary value of -x y + h (exp(x + y + u) - u - u y) over numbers x, y and u has the
// expansion of trees where all weights are 1, and -1 those of links. It is
// h/(1 - h) (1/(1 - h) + log(1 - h)).
TEST_CASE("trees with links, each once and by its symmetry") {
    const auto all = unrooted_trees(SeriesFamily::linked, 6);
    // Otter: with a vertex marked, less those with an edge marked, and those that a link mirrors.
    const std::vector<std::size_t> counts = {1, 1, 4, 16, 96, 633, 4989};
    double harmonic = 0;
    for (std::size_t n = 0; n < all.size(); ++n) {
        if (n != 0) harmonic += 1 / static_cast<double>(n);
        double sum = 0;
        std::set<std::string> texts;
        for (const SeriesTreePointer& tree : all[n]) {
            int links = 0;
            for (std::size_t at = 0; (at = tree->text.find("link", at)) != std::string::npos; ++at)
                ++links;
            sum += (links % 2 == 0 ? 1 : -1) / static_cast<double>(tree->symmetry);
            texts.insert(tree->text);
        }
        CAPTURE(n);
        CHECK(all[n].size() == counts[n]);
        CHECK(texts.size() == counts[n]);
        CHECK(sum == Approx(static_cast<double>(n) + 1 - harmonic));
    }
}

TEST_CASE("the exact series where the flow is known") {
    CHECK(exact("q*p", 5) == "q*p, p*q/2, p*q/6, p*q/24, p*q/120");  // q_1 = exp(h) q_0
    // q p/cos(h) + (q^2 + p^2)/2 tan(h)
    CHECK(exact("(q^2+p^2)/2", 6) ==
          "(q^2+p^2)/2, p*q/2, p^2/6+q^2/6, 5*p*q/24, p^2/15+q^2/15, 61*p*q/720");
    CHECK(exact("p^2/2 + q", 5) == "p^2/2+q, p/2, 1/6, 0, 0");  // free fall
    // H = p f(q): S is p times q_1
    CHECK(exact("p*q^2", 5) == "p*q^2, p*q^3, p*q^4, p*q^5, p*q^6");  // q_1 = q/(1 - h q)
    CHECK(exact("p*exp(q)", 3) == "p*exp(q), p*exp(2*q)/2, p*exp(3*q)/3");
    CHECK(exact("p*sqrt(1+q^2)", 4) ==  // q_1 = q cosh(h) + sqrt(1 + q^2) sinh(h)
          "p*sqrt(1+q^2), p*q/2, p*sqrt(q^2+1)/6, p*q/24");
    CHECK(exact("p*q*log(q)", 3) ==  // log(q_1) = exp(h) log(q)
          "p*q*log(q), log(q)^2*p*q/2+log(q)*p*q/2, log(q)^3*p*q/6+log(q)^2*p*q/2+log(q)*p*q/6");
    CHECK(exact("p*cos(t)", 4) == "p*cos(t), -p*sin(t)/2, -p*cos(t)/6, p*sin(t)/24");
    CHECK(exact("p^2/2 - cos(q)", 2) == "p^2/2-cos(q), p*sin(q)/2");
}

TEST_CASE("the exact series satisfies the Hamilton-Jacobi equation (2.7)") {
    for (const char* given : {nonseparable, henon_heiles, kepler, driven, "p^2/2 - cos(q)",
                              "exp(q*p) + tan(p)*q + sqrt(1+p^2)"}) {
        const int terms = 5;
        const Hamiltonian H = hamiltonian(given);
        const DiscreteSeries found = series("midpoint", given, terms);
        const Real coarse = residual(found, H, 0.01L), fine = residual(found, H, 0.005L);
        CAPTURE(given, coarse, fine);
        CHECK(std::log2(coarse / fine) == Approx(terms).margin(0.2));
    }
}

TEST_CASE("the series of a method is that of (4.19)") {
    for (const char* name :
         {"adjoint-symplectic-euler", "stormer-verlet", "trig3", "gauss:2", "lobatto:3", "gauss:5"})
        for (const char* given : {nonseparable, henon_heiles, driven, "q*p + p^2 + q"}) {
            const int terms = 4;
            const Hamiltonian H = hamiltonian(given);
            const Rounded method(derive(hvi::gen::method(name)));
            const DiscreteSeries found = series(name, given, terms);
            const auto error = [&](Real h) {
                return Step(method, H, h).discrete_hamiltonian() -
                       sum(found.method, H, start(H), {h}).value;
            };
            const Real coarse = error(0.02L), fine = error(0.01L);
            CAPTURE(name, given, coarse, fine);
            CHECK(std::log2(coarse / fine) == Approx(terms + 1).margin(0.35));
        }
}

TEST_CASE("the series of the general Galerkin form is that of (4.6)") {
    for (const char* given : {"1 | 0, 1", "1, tau | 0, 1/2, 1", "1, tau | 1/3, 1/2, 1",
                              "1-tau, tau | gauss:5", "1, tau^2 | gauss:6", cubic, trigonometric})
        for (const char* H_text : {"p^2/2 - cos(q)", henon_heiles, "p^2/2 + (1+t)*q^3/3"}) {
            const int terms = 4;
            const Hamiltonian H = hamiltonian(H_text);
            const GalerkinRule derived = std::get<GalerkinRule>(derive_any(rule(given)));
            const DiscreteSeries found = series(rule(given), H_text, terms);
            const auto error = [&](Real h) {
                return GeneralStep(derived, H, h).discrete_hamiltonian() -
                       sum(found.method, H, start(H), {h}).value;
            };
            const Real coarse = error(0.04L), fine = error(0.02L);
            CAPTURE(given, H_text, coarse, fine);
            CHECK(std::log2(coarse / fine) == Approx(terms + 1).margin(0.35));
        }
}

TEST_CASE("H_d^+ of symplectic Euler is q_0 p_1 + h H(q_0, p_1)") {
    for (const char* H : {nonseparable, henon_heiles, "p^2/2 - cos(q)"})
        for (std::size_t k = 1; k < 5; ++k)
            CHECK(to_text(series("symplectic-euler", H, 5).method[k].value()) == "0");
}

TEST_CASE("the first difference is behind the order") {
    struct Known {
        const char* name;
        int order;
    };
    for (const Known& known : {Known{"symplectic-euler", 1}, Known{"midpoint", 2},
                               Known{"stormer-verlet", 2}, Known{"trig3", 2}, Known{"gauss:2", 4},
                               Known{"lobatto:3", 4}, Known{"chebyshev:3", 4}, Known{"gauss:3", 6}})
        for (const char* H : {"p^2/2 - cos(q)", nonseparable, henon_heiles}) {
            CAPTURE(known.name, H);
            CHECK(first_difference(known.name, H, 7) == known.order + 1);
        }
    CHECK(first_difference("gauss:5", nonseparable, 7) == 0);  // without closed coefficients
    CHECK(first_difference("gauss:2", kepler, 5) == 5);
    CHECK(first_difference("stormer-verlet", driven, 5) == 3);
    CHECK(to_text(series("midpoint", "p^2/2 - cos(q)", 3).difference.value()) ==
          "cos(q)^2/24-p^2*cos(q)/24-1/24");
}

TEST_CASE("for all named methods the first difference is behind the order that trees prove") {
    for (const char* name : {"symplectic-euler",
                             "midpoint",
                             "adjoint-symplectic-euler",
                             "stormer-verlet",
                             "trig3",
                             "gauss:1",
                             "gauss:2",
                             "lobatto:2",
                             "lobatto:3",
                             "radau-left:1",
                             "radau-left:2",
                             "radau-right:1",
                             "radau-right:2",
                             "newton-cotes:2",
                             "newton-cotes:3",
                             "newton-cotes-open:1",
                             "newton-cotes-open:2",
                             "chebyshev:1",
                             "chebyshev:2",
                             "chebyshev:3",
                             "clenshaw-curtis:2",
                             "clenshaw-curtis:3",
                             "fejer:1",
                             "fejer:2",
                             "fejer:3"}) {
        const int order = orders(derive(method(name)), 6).general.order;
        for (const char* H :
             {nonseparable, "p^2*(1+q^2)/2 + cos(q)", "q*p^3/3 + q^2*p/2 + q^2 + exp(p)"}) {
            CAPTURE(name, H);
            CHECK(first_difference(name, H, order + 1) == order + 1);
        }
    }
}

TEST_CASE("of the general Galerkin form too") {
    struct Known {
        const char* rule;
        int order;  ///< 2s, or what the rule is exact for
    };
    for (const Known& known :
         {Known{"1 | 0, 1", 2}, Known{"1 | gauss:6", 2}, Known{"1, tau | 0, 1/2, 1", 4},
          Known{"1, tau | gauss:3", 4}, Known{"1, tau | gauss:7", 4}, Known{cubic, 3},
          Known{"1, tau, tau^2 | gauss:4", 6}, Known{"1, tau, tau^2 | gauss:8", 6}})
        for (const char* H : {"p^2/2 - cos(q)", henon_heiles, kepler}) {
            const DiscreteSeries found = series(rule(known.rule), H, known.order + 1);
            CAPTURE(known.rule, H);
            CHECK_FALSE(found.undecided);
            CHECK(found.first_difference == known.order + 1);
            CHECK(found.difference);
        }
    CHECK(to_text(series(rule("1 | 0, 1"), "p^2/2 - cos(q)", 3).difference.value()) ==
          to_text(series("stormer-verlet", "p^2/2 - cos(q)", 3).difference.value()));
}

TEST_CASE("some H are kinder than others") {
    // Free fall: symplectic Euler is wrong in h^2 and h^3, and nothing is beyond h^3.
    CHECK(first_difference("symplectic-euler", "p^2/2 + q", 4) == 2);
    CHECK(first_difference("midpoint", "p^2/2 + q", 8) == 3);
    CHECK(first_difference("gauss:2", "p^2/2 + q", 8) == 0);
    CHECK(first_difference("midpoint", "p^2/2", 8) == 0);
    CHECK(first_difference("symplectic-euler", "p^2/2", 8) == 0);
}

TEST_CASE("for quadratic H the power is that of the closed form") {
    for (const char* name : {"symplectic-euler", "stormer-verlet", "trig3", "gauss:2", "lobatto:3"})
        for (const char* H : {"p^2/2 + w^2*q^2/2", "q*p", "a*q*p + b*p^2 + c*q"}) {
            const StepEquations step = step_equations(method(name), hamiltonian(H), true, 6);
            CAPTURE(name, H);
            CHECK(step.series->first_difference == step.generating->order_of_difference);
        }
}

TEST_CASE("what is not decided is not said") {
    // log(2q) - log(q) = log(2), which the normal form does not see.
    const char* const H = "p*(log(2*q)-log(q)) + q*p^2";
    CHECK(first_difference("symplectic-euler", H, 2) == 2);  // by its value at a point
    const DiscreteSeries hidden = series("symplectic-euler", "(log(2*q)-log(q)-log(2))*p + q", 2);
    CHECK_FALSE(hidden.first_difference);
    CHECK(hidden.undecided == 2);
}

TEST_CASE("series that there are not") {
    const Refusal open =
        refusal([] { return series(method("1, exp(tau^2)", "0, 1"), "p^2/2 + q^2/2", 2); });
    CHECK(open.status == 1);
    CHECK(open.says("no closed form"));
}

TEST_CASE("what is too long to be written is decided all the same") {
    const char* const vortices =
        "-(log((q1-q2)^2+(p1-p2)^2) + log((q1-q3)^2+(p1-p3)^2) + log((q2-q3)^2+(p2-p3)^2))/pi";
    const DiscreteSeries gauss = series("gauss:2", vortices, 5);
    CHECK(gauss.exact[0]);
    CHECK_FALSE(gauss.exact[4]);
    CHECK_FALSE(gauss.difference);
    CHECK(gauss.first_difference == 5);
    CHECK(first_difference("stormer-verlet", vortices, 3) == 3);
    CHECK(first_difference("gauss:3", vortices, 5) == 0);
}

TEST_CASE("series are of smooth H") {
    for (const char* H : {"p^2/2 + abs(q)", "p^2/2 + q^2*sign(q)", "p^2/2 + if(q<0, q^2, q^4)"}) {
        const Refusal refused = refusal([&] { return series("midpoint", H, 2); });
        CHECK(refused.says("H is not smooth"));
        CHECK(refused.marked == "[" + std::string(H) + "]");
    }
    CHECK(series("midpoint", "p^2/2 + abs(w)*q^2", 2).exact.size() == 2);
    CHECK(first_difference("midpoint", "p^2/2 + erf(q)", 3) == 3);
}
