// Steps of a counted number of sweeps, beside their tableaux written out and plain loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>

#include <catch2/catch.hpp>

#include "generator/exact/methods/counted_sweeps.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

SweptFamily swept(const std::string& method, SweepForm form, TreeFamily family, int sweeps,
                  int max_order = 8) {
    return swept_family(tableau(method), form, family, sweeps, max_order);
}
SweptFamily in_turn(const std::string& method, int sweeps) {
    return swept(method, SweepForm::in_turn, TreeFamily::general, sweeps);
}
SweptFamily at_once(const std::string& method, int sweeps) {
    return swept(method, SweepForm::at_once, TreeFamily::general, sweeps);
}
SweptFamily separable(const std::string& method, int sweeps) {
    return swept(method, SweepForm::in_turn, TreeFamily::separable, sweeps);
}
SweptFamily nystrom(const std::string& method, int sweeps) {
    return swept(method, SweepForm::positions, TreeFamily::nystrom, sweeps);
}

/// The explicit tableau of sweeps in turn or at once: the start, and of each sweep stages for Lq
/// and stages for Lp.
class WrittenOut {
public:
    WrittenOut(const ButcherPair& pair, bool at_once, int sweeps) {
        NumberMatrix &A = method_.A, &A_tilde = method_.A_tilde;
        A.emplace_back();
        A_tilde.emplace_back();
        std::size_t Lq = 0, Lp = 0;  // their first stages; 0 is the start
        for (int k = 0; k < sweeps; ++k) {
            const std::size_t f = A.size(), g = at_once ? f : f + pair.stages();
            add(A, pair.A, Lq);
            add(A_tilde, pair.A_tilde, Lp);
            if (!at_once) {
                add(A, pair.A, f);
                add(A_tilde, pair.A_tilde, Lp);
            }
            Lq = f;
            Lp = g;
        }
        method_.b = spread(pair.b, Lq);
        method_.b_tilde = spread(pair.b, Lp);
        for (NumberMatrix* const matrix : {&A, &A_tilde}) {
            for (NumberVector& row : *matrix) { row.resize(A.size()); }
        }
        method_.b.resize(A.size());
        method_.b_tilde.resize(A.size());
    }

    [[nodiscard]] const PartitionedMethod& method() const { return method_; }

private:
    /// A row that stands at some stages; slopes at the start are the same for all.
    [[nodiscard]] static NumberVector spread(const NumberVector& row, std::size_t first) {
        if (first == 0) { return {sum(row)}; }
        NumberVector result(first);
        result.insert(result.end(), row.begin(), row.end());
        return result;
    }

    static void add(NumberMatrix& rows, const NumberMatrix& of_method, std::size_t first) {
        for (const NumberVector& row : of_method) { rows.push_back(spread(row, first)); }
    }

    PartitionedMethod method_;
};

std::map<std::string, std::string> residuals_of(const OrderConditions& conditions) {
    std::map<std::string, std::string> result;
    for (const FailedCondition& failed : conditions.failures) {
        result[failed.tree->text] = text(failed.residual);
    }
    return result;
}

// ---- plain loops ----

using Real = long double;
using Complex = std::complex<Real>;
using Point = std::array<Complex, 4>;  ///< q, then p, of two degrees of freedom

/// dH/dq and dH/dp.
using Gradient = std::function<Point(const Point&)>;

/// H = (1 + q1^2) p1^2/2 + (2 + q1 q2) p2^2/2 + q1 p2/3 + q1^4/4 + q1 q2^2.
Point any_H(const Point& x) {
    const auto [q1, q2, p1, p2] = x;
    return {q1 * p1 * p1 + q2 * p2 * p2 / Real(2) + p2 / Real(3) + q1 * q1 * q1 + q2 * q2,
            q1 * p2 * p2 / Real(2) + Real(2) * q1 * q2, (Real(1) + q1 * q1) * p1,
            (Real(2) + q1 * q2) * p2 + q1 / Real(3)};
}

/// T = p1^2/2 + p1 p2^3 + p2^2/2 where it is not quadratic, else (p1^2 + p1 p2 + 2 p2^2)/2, and U =
/// q1^2 q2 + q1^4/4 + q2^3/3 + q1 q2/2.
template <bool quadratic>
Point sum_of_parts(const Point& x) {
    const auto [q1, q2, p1, p2] = x;
    const Complex f1 = quadratic ? p1 + p2 / Real(2) : p1 + p2 * p2 * p2;
    const Complex f2 = quadratic ? Real(2) * p2 + p1 / Real(2) : p2 + Real(3) * p1 * p2 * p2;
    return {Real(2) * q1 * q2 + q1 * q1 * q1 + q2 / Real(2), q1 * q1 + q2 * q2 + q1 / Real(2), f1,
            f2};
}

/// Steps of sweeps from the slopes at the start.
class Loops {
public:
    Loops(const std::string& method, SweepForm form, int sweeps, Gradient gradient)
        : form_(form), sweeps_(sweeps), gradient_(std::move(gradient)) {
        const Tableau exact = tableau(method);
        const auto row = [](const NumberVector& numbers) {
            std::vector<Real> result;
            for (const Number& number : numbers) {
                result.push_back(std::stold(number.decimal(25)));
            }
            return result;
        };
        b_ = row(exact.b);
        for (std::size_t i = 0; i < exact.stages(); ++i) {
            A_.push_back(row(exact.A[i]));
            A_tilde_.push_back(row(exact.A_tilde[i]));
        }
    }

    [[nodiscard]] Point step(const Point& x, Real h) const {
        const std::size_t s = b_.size();
        std::vector<Point> slopes(s, gradient_(x)), stages(s, x);
        const auto set_q = [&] { move(stages, x, h, A_, slopes, 0); };
        const auto set_p = [&] { move(stages, x, h, A_tilde_, slopes, 2); };
        const auto evaluate = [&](std::size_t from) {
            for (std::size_t i = 0; i < s; ++i) {
                const Point all = gradient_(stages[i]);
                for (std::size_t k = from; k < from + 2; ++k) { slopes[i][k] = all[k]; }
            }
        };
        if (form_ == SweepForm::in_turn) { set_q(); }
        for (int k = 0; k < sweeps_; ++k) {
            set_p();
            if (form_ != SweepForm::at_once) { evaluate(2); }
            set_q();
            if (form_ == SweepForm::at_once) { evaluate(2); }
            evaluate(0);
        }
        if (form_ == SweepForm::positions) {
            set_p();
            evaluate(2);
        }
        Point end = x;
        for (std::size_t i = 0; i < s; ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                end[k] += h * b_[i] * slopes[i][k + 2];
                end[k + 2] -= h * b_[i] * slopes[i][k];
            }
        }
        return end;
    }

    /// The largest entry of D^T J D - J, with the derivative D by complex steps.
    [[nodiscard]] Real defect(const Point& x, Real h) const {
        constexpr Real tiny = 1e-60L;
        std::array<std::array<Real, 4>, 4> D{};
        for (std::size_t column = 0; column < 4; ++column) {
            Point moved = x;
            moved[column] += Complex(0, tiny);
            const Point end = step(moved, h);
            for (std::size_t row = 0; row < 4; ++row) { D[row][column] = end[row].imag() / tiny; }
        }
        Real largest = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                Real entry = i + 2 == j ? -1 : j + 2 == i ? 1 : 0;
                for (std::size_t k = 0; k < 2; ++k) {
                    entry += D[k][i] * D[k + 2][j] - D[k + 2][i] * D[k][j];
                }
                largest = std::max(largest, std::abs(entry));
            }
        }
        return largest;
    }

    /// The power of h that a quantity falls with.
    [[nodiscard]] static Real power(const std::function<Real(Real)>& quantity) {
        constexpr Real h = 1.0L / 128;
        return std::log2(quantity(h) / quantity(h / 2));
    }

private:
    /// Moves q (`to` = 0) or p (2) of the stages by the slopes of the other kind.
    static void move(std::vector<Point>& stages, const Point& x, Real h,
                     const std::vector<std::vector<Real>>& A, const std::vector<Point>& slopes,
                     std::size_t to) {
        const Real sign = to == 0 ? h : -h;
        for (std::size_t i = 0; i < stages.size(); ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                Complex sum = 0;
                for (std::size_t j = 0; j < stages.size(); ++j) {
                    sum += A[i][j] * slopes[j][2 - to + k];
                }
                stages[i][to + k] = x[to + k] + sign * sum;
            }
        }
    }

    SweepForm form_;
    int sweeps_;
    Gradient gradient_;
    std::vector<Real> b_;
    std::vector<std::vector<Real>> A_, A_tilde_;
};

constexpr Point start{Complex(0.7L), Complex(-0.4L), Complex(0.3L), Complex(0.9L)};

/// Powers with which D^T J D - J and the distance to the method's own step fall.
std::array<Real, 2> seen(const std::string& method, SweepForm form, int sweeps,
                         const Gradient& gradient) {
    const Loops few(method, form, sweeps, gradient), all(method, form, 60, gradient);
    const auto distance = [&](Real h) {
        const Point a = few.step(start, h), b = all.step(start, h);
        Real sum = 0;
        for (std::size_t k = 0; k < 4; ++k) { sum += std::norm(a[k] - b[k]); }
        return std::sqrt(sum);
    };
    return {Loops::power([&](Real h) { return few.defect(start, h); }), Loops::power(distance)};
}

/// The first coefficients of numerator/denominator as a series in z.
NumberVector series(const NumberVector& numerator, const NumberVector& denominator,
                    std::size_t count) {
    NumberVector result;
    for (std::size_t k = 0; k < count; ++k) {
        Number rest = k < numerator.size() ? numerator[k] : Number(0);
        for (std::size_t j = 1; j <= k && j < denominator.size(); ++j) {
            rest = rest - denominator[j] * result[k - j];
        }
        result.push_back(rest / denominator[0]);
    }
    return result;
}

}  // namespace

TEST_CASE("K sweeps have the order K + 1, up to that of the method") {
    // van der Houwen & Sommeijer, J. Comput. Appl. Math. 29 (1990) 111, for slopes at once.
    for (const int stages : {1, 2, 3, 5}) {
        const std::string method = "gauss:" + std::to_string(stages);
        for (const int sweeps : {1, 2, 3, 4, 9}) {
            CAPTURE(method, sweeps);
            const auto least = [&](int powers) { return std::min({2 * stages, powers, 8}); };
            CHECK(at_once(method, sweeps).order.order == least(sweeps + 1));
            CHECK(in_turn(method, sweeps).order.order == least(sweeps + 1));
            CHECK(separable(method, sweeps).order.order == least(2 * sweeps));
            CHECK(nystrom(method, sweeps).order.order == least(2 * sweeps + 1));
        }
    }
}

TEST_CASE("sweeps violate the conditions that their tableau, written out, violates") {
    for (const std::string method : {"gauss:1", "gauss:2", "lobatto:3"}) {
        const Tableau of_method = tableau(method);
        for (const int sweeps : {1, 2, 3}) {
            CAPTURE(method, sweeps);
            const Orders one_by_one = orders(WrittenOut(of_method, false, sweeps).method(), 6);
            const Orders together = orders(WrittenOut(of_method, true, sweeps).method(), 6);
            const auto compare = [](const SweptFamily& found, const OrderConditions& expected) {
                CHECK(found.order.order == expected.order);
                CHECK(found.order.conditions == expected.conditions);
                CHECK_FALSE(residuals_of(expected).empty());
                CHECK(residuals_of(found.order) == residuals_of(expected));
            };
            compare(in_turn(method, sweeps), one_by_one.general);
            compare(at_once(method, sweeps), together.general);
            compare(separable(method, sweeps), one_by_one.separable);
        }
    }
}

TEST_CASE("one sweep of the midpoint rule with all slopes at once is the rule of Runge") {
    const Number half = Number(1) / Number(2);
    PartitionedMethod runge;
    runge.b = runge.b_tilde = {Number(0), Number(1)};
    runge.A = runge.A_tilde = {{Number(0), Number(0)}, {half, Number(0)}};
    const OrderConditions expected = orders(runge, 4).general;
    CHECK(residuals_of(at_once("midpoint", 1).order) == residuals_of(expected));
}

TEST_CASE("sweeps are symplectic, and the method's, up to the powers that plain loops show") {
    const auto check = [](const std::string& method, SweepForm form, int sweeps,
                          const Gradient& gradient, const SweptFamily& found) {
        CAPTURE(method, sweeps, form);
        const auto [symplectic, agrees] = seen(method, form, sweeps, gradient);
        CHECK_FALSE(found.symplectic.is_at_least);
        CHECK_FALSE(found.agrees.is_at_least);
        CHECK(symplectic == Approx(found.symplectic.power + 1).margin(0.2));
        CHECK(agrees == Approx(found.agrees.power + 1).margin(0.2));
    };
    for (const int sweeps : {1, 2, 3}) {
        for (const std::string method : {"gauss:2", "gauss:3", "lobatto:3", "radau-right:2"}) {
            check(method, SweepForm::in_turn, sweeps, any_H, in_turn(method, sweeps));
            check(method, SweepForm::at_once, sweeps, any_H, at_once(method, sweeps));
        }
    }
    for (const int sweeps : {1, 2}) {
        check("gauss:3", SweepForm::in_turn, sweeps, sum_of_parts<false>,
              separable("gauss:3", sweeps));
        check("gauss:3", SweepForm::positions, sweeps, sum_of_parts<true>,
              nystrom("gauss:3", sweeps));
    }
}

TEST_CASE("more sweeps than the order asks for bring a step nearer to the symplectic one") {
    const SweptFamily few = separable("gauss:1", 3);
    CHECK(few.order.order == 2);
    CHECK(few.agrees.power == 6);
    CHECK(few.symplectic.power == 6);
    // The last power of the diagonal Pade approximant of 2 and 2 that K = 2 does not reach is 0:
    // with c_n = c_(n-1)/2 - c_(n-2)/12 from c_4 = 1/24 and c_5 = 1/144 on, c_6 = 0.
    CHECK(nystrom("gauss:2", 2).agrees.power == 6);
}

TEST_CASE("the map of the oscillator is the method's series, as far as sweeps reach") {
    for (const std::string method : {"gauss:1", "gauss:2", "gauss:3", "lobatto:3", "trig3"}) {
        for (const int sweeps : {1, 2, 4}) {
            CAPTURE(method, sweeps);
            const OscillatorMap whole = oscillator_map(tableau(method));
            const OscillatorMap cut = swept_oscillator(tableau(method), sweeps);
            const std::size_t most = 2 * static_cast<std::size_t>(sweeps) + 1;
            const auto is_cut = [&](const NumberVector& entry, const NumberVector& of_method,
                                    std::size_t highest) {
                const NumberVector expected = series(of_method, whole.D, most + 4);
                for (std::size_t k = 0; k < expected.size(); ++k) {
                    const Number found = k < entry.size() ? entry[k] : Number(0);
                    CAPTURE(k);
                    CHECK(same(text(found), k <= highest ? text(expected[k]) : "0"));
                }
            };
            is_cut(cut.m11, whole.m11, most + 1);
            is_cut(cut.m12, whole.m12, most + 1);
            is_cut(cut.m21, whole.m21, most);
            is_cut(cut.m22, whole.m22, most);
            CHECK(cut.D.size() == 1);
            CHECK_FALSE(cut.determinant_one.holds);
        }
    }
}

TEST_CASE("the energy of the oscillator changes by the determinant") {
    // (1 - z^2/2 + z^4/24) (1 - z^2/2) + (z - z^3/6)^2 = 1 - z^4/24 + ...
    const auto growth = first_of_determinant(swept_oscillator(tableau("gauss:2"), 1));
    REQUIRE(growth);
    CHECK(growth->power == 4);
    CHECK(same(text(growth->coefficient), "-1/24"));
    CHECK_FALSE(first_of_determinant(oscillator_map(tableau("stormer-verlet"))));
}

TEST_CASE("stages of collocation have the order of their number") {
    CHECK(stage_order(tableau("gauss:1")) == 1);
    CHECK(stage_order(tableau("gauss:4")) == 4);
    CHECK(stage_order(tableau("gauss:12")) == 12);
    // Lobatto IIIA and IIIB: c^k/k for k up to s and up to s - 2.
    CHECK(stage_order(tableau("lobatto:4")) == 2);
    CHECK(stage_order(tableau("lobatto:3")) == 1);
}

TEST_CASE("sweeps of a method with a free parameter have the order of most values") {
    const std::string method = "1, tau | w, 1 - w";
    CHECK(in_turn(method, 1).order.order == 2);
    CHECK(separable(method, 3).order.order == 2);
    CHECK(separable(method, 3).agrees.power == 6);
}
