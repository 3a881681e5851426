// Linear equations of many unknowns, against the equations themselves.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/linear/band.hpp>
#include <hvi/detail/linear/gmres.hpp>
#include <hvi/detail/linear/sparse_lu.hpp>
#include <hvi/detail/linear/sparse_matrix.hpp>

using namespace hvi::detail;

namespace {

using Complex = std::complex<double>;
using Matrix = SparseMatrix<double>;

double some(std::size_t k) { return std::sin(2.7 * static_cast<double>(k) + 0.3); }

/// Returns a matrix that couples i with i + distance, for each of the distances, around a ring or
/// not.
Matrix coupled(std::size_t n, const std::vector<std::size_t>& distances, bool is_ring) {
    const auto entries = [&](auto& out) {
        for (std::size_t i = 0; i < n; ++i) {
            out.add(i, i, 3 * some(i));
            for (const std::size_t d : distances) {
                if (!is_ring && i + d >= n) { continue; }
                const std::size_t j = (i + d) % n;
                out.add(i, j, some(i + d));
                out.add(j, i, some(i + d));
            }
        }
    };
    Matrix result;
    result.find_places(n, entries);
    result.set(entries);
    return result;
}

template <class Number>
std::vector<Number> right_side(std::size_t n) {
    std::vector<Number> b(n);
    for (std::size_t i = 0; i < n; ++i) { b[i] = Number(some(7 * i)); }
    return b;
}

/// (1 + factor M) x - b, at most.
template <class Number>
double residual(const Matrix& M, Number factor, const std::vector<Number>& x) {
    const std::vector<Number> b = right_side<Number>(x.size());
    std::vector<Number> product(x.size(), Number(0));
    M.for_each([&](std::size_t i, std::size_t j, double value) { product[i] += value * x[j]; });
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        largest = std::max(largest, std::abs(x[i] + factor * product[i] - b[i]));
    }
    return largest;
}

template <template <class> class FactorsOf, class Number>
void check_solves(const Matrix& M, Number factor) {
    const typename FactorsOf<Number>::Order order(M);
    FactorsOf<Number> factors;
    REQUIRE(factors.compute(M, factor, order));
    std::vector<Number> x = right_side<Number>(M.size());
    factors.solve(x.data(), order);
    CHECK(residual(M, factor, x) < 1e-11);
}

}  // namespace

TEST_CASE("entries at one place are added, and rows are in order") {
    const auto entries = [](auto& out) {
        out.add(1, 0, 2.0);
        out.add(0, 1, 3.0);
        out.add(1, 0, 0.5);
        out.add(2, 2, 1.0);
    };
    Matrix M;
    M.find_places(3, entries);
    M.set(entries);
    M.set(entries);  // not added to what was there
    std::vector<double> found;
    M.for_each([&](std::size_t i, std::size_t j, double value) {
        found.insert(found.end(), {double(i), double(j), value});
    });
    CHECK(found == std::vector<double>{0, 1, 3, 1, 0, 2.5, 2, 2, 1});
    CHECK(M.times(1, std::vector<double>{2, 5, 7}) == 5);
    M.for_each([](std::size_t, std::size_t, double& value) {
        value = std::numeric_limits<double>::quiet_NaN();
    });
    CHECK_FALSE(M.is_finite());
}

TEST_CASE("a chain stays in its order, and a ring is laid double") {
    CHECK(NarrowOrder(coupled(50, {1}, false)).width() == 1);
    CHECK(NarrowOrder(coupled(50, {2}, false)).width() == 1);  // two chains
    CHECK(NarrowOrder(coupled(50, {1, 2}, false)).width() == 2);
    CHECK(NarrowOrder(coupled(50, {1}, true)).width() == 2);
    CHECK(NarrowOrder(coupled(1, {}, false)).width() == 0);
    const NarrowOrder order(coupled(101, {1, 3}, true));
    std::vector<bool> is_taken(101, false);
    for (std::size_t i = 0; i < order.size(); ++i) {
        REQUIRE(order[i] < 101);
        CHECK_FALSE(is_taken[order[i]]);
        is_taken[order[i]] = true;
    }
}

TEST_CASE("factors solve the equations, real ones and complex ones") {
    for (const std::size_t n : {std::size_t{1}, std::size_t{2}, std::size_t{7}, std::size_t{300}}) {
        for (const bool is_ring : {false, true}) {
            CAPTURE(n, is_ring);
            const Matrix M = coupled(n, {1, 2}, is_ring);
            check_solves<BandFactors>(M, 0.7);
            check_solves<BandFactors>(M, 1e6);  // rows are exchanged
            check_solves<BandFactors>(M, Complex(0.3, -2));
            check_solves<SparseLuFactors>(M, 0.7);
            check_solves<SparseLuFactors>(M, Complex(0.3, -2));
        }
    }
}

TEST_CASE("a singular matrix has no factors, and neither has one that is not finite") {
    const auto ones = [](auto& out) {
        for (int i = 0; i < 4; ++i) { out.add(i, i, 1.0); }
    };
    Matrix M;
    M.find_places(4, ones);
    M.set(ones);
    const NarrowOrder order(M);
    BandFactors<double> band;
    SparseLuFactors<double> sparse;
    for (const double factor : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_FALSE(band.compute(M, factor, order));
        CHECK_FALSE(sparse.compute(M, factor, OrderOfEigen(M)));
    }
    CHECK(band.compute(M, 1.0, order));
    CHECK(sparse.compute(M, 1.0, OrderOfEigen(M)));
}

TEST_CASE("equations are solved by products with the matrix") {
    const Matrix M = coupled(400, {1, 20}, true);
    const double factor = 0.12;
    const auto apply = [&](const std::vector<double>& x, std::vector<double>& out) {
        out.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) { out[i] = x[i] + factor * M.times(i, x); }
    };
    const auto nothing = [](const std::vector<double>&) {};
    Gmres<double> gmres;
    for (const double tolerance : {1e-2, 1e-12}) {
        std::vector<double> x = right_side<double>(400);
        REQUIRE(gmres.solve(x, tolerance, apply, nothing));
        CHECK(residual(M, factor, x) < 30 * tolerance);
    }
    // A preconditioner that is the inverse leaves one product.
    const NarrowOrder order(M);
    BandFactors<double> factors;
    REQUIRE(factors.compute(M, factor, order));
    int products = 0;
    std::vector<double> x = right_side<double>(400);
    REQUIRE(gmres.solve(
        x, 1e-9,
        [&](const std::vector<double>& v, std::vector<double>& out) {
            ++products;
            apply(v, out);
        },
        [&](std::vector<double>& v) { factors.solve(v.data(), order); }));
    CHECK(residual(M, factor, x) < 1e-10);
    CHECK(products <= 2);  // and one for the residual

    std::vector<double> zero(400, 0.0);
    CHECK(gmres.solve(zero, 1e-9, apply, nothing));
    CHECK(zero == std::vector<double>(400, 0.0));
    std::vector<double> huge(400, 1e300);
    CHECK(gmres.solve(huge, 1e-9, apply, nothing));
    CHECK(std::isfinite(huge[0]));
}

TEST_CASE("what products do not solve is said to have no solution") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto nothing = [](const std::vector<double>&) {};
    const auto same = [](const std::vector<double>& x, std::vector<double>& out) { out = x; };
    const auto no_numbers = [&](const std::vector<double>& x, std::vector<double>& out) {
        out.assign(x.size(), nan);
    };
    // All products are (x_1, x_1, ..., x_1), of which few right sides are one.
    const auto singular = [](const std::vector<double>& x, std::vector<double>& out) {
        out.assign(x.size(), x[0]);
    };
    Gmres<double> gmres;
    std::vector<double> x = right_side<double>(20);
    x[7] = nan;
    CHECK_FALSE(gmres.solve(x, 1e-9, same, nothing));
    x = right_side<double>(20);
    CHECK_FALSE(gmres.solve(x, 1e-9, no_numbers, nothing));
    x = right_side<double>(20);
    CHECK_FALSE(gmres.solve(x, 1e-9, singular, nothing));
    x = right_side<double>(20);
    CHECK(gmres.solve(x, 1e-9, same, nothing));
}
