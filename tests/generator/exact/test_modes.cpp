// Real matrices in a basis in which they fall apart.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "generator/exact/algebra/modes.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

using Doubles = std::vector<std::vector<double>>;

Doubles product(const Doubles& a, const Doubles& b) {
    Doubles result(a.size(), std::vector<double>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < a.size(); ++j) {
            for (std::size_t k = 0; k < a.size(); ++k) { result[i][j] += a[i][k] * b[k][j]; }
        }
    }
    return result;
}

Doubles blocks(const RealModes& modes) {
    const std::size_t size = modes.to.size();
    Doubles D(size, std::vector<double>(size));
    std::size_t at = 0;
    for (std::size_t m = 0; m < modes.real_parts.size(); ++m) {
        D[at][at] = modes.real_parts[m];
        if (m >= modes.real_ones) {
            const double beta = modes.imaginary_parts[m - modes.real_ones];
            D[at][at + 1] = beta;
            D[at + 1][at] = -beta;
            D[at + 1][at + 1] = modes.real_parts[m];
            ++at;
        }
        ++at;
    }
    return D;
}

void check(const NumberMatrix& C) {
    const auto modes = real_modes(C);
    REQUIRE(modes);
    const Doubles again = product(modes->from, product(blocks(*modes), modes->to));
    const Doubles one = product(modes->from, modes->to);
    for (std::size_t i = 0; i < C.size(); ++i) {
        for (std::size_t j = 0; j < C.size(); ++j) {
            CAPTURE(i, j);
            CHECK(again[i][j] == Approx(C[i][j].nearest_double()).margin(1e-12));
            CHECK(one[i][j] == Approx(i == j ? 1 : 0).margin(1e-12));
        }
    }
}

NumberMatrix integers(const std::vector<std::vector<long>>& rows) {
    NumberMatrix result;
    for (const auto& row : rows) {
        NumberVector& numbers = result.emplace_back();
        for (const long entry : row) { numbers.emplace_back(entry); }
    }
    return result;
}

}  // namespace

TEST_CASE("real eigenvalues and pairs, ascending") {
    // diag(3, -2) and a rotation by a quarter, seen from another basis.
    const NumberMatrix C = integers({{3, 0, 5, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, -2}});
    check(C);
    const auto modes = real_modes(C);
    CHECK(modes->real_ones == 2);
    CHECK(modes->real_parts[0] == -2.0);
    CHECK(modes->real_parts[1] == 3.0);
    CHECK(modes->real_parts[2] == 0.0);
    CHECK(modes->imaginary_parts == std::vector<double>{1.0});
    check(integers({{7}}));
    check(integers({{1, 2}, {3, 4}}));
}

TEST_CASE("eigenvalues that are not simple have no basis here") {
    CHECK_FALSE(real_modes(integers({{1, 0}, {0, 1}})));
    CHECK_FALSE(real_modes(integers({{2, 1}, {0, 2}})));
    CHECK_FALSE(real_modes(integers({{0, 0}, {0, 0}})));
}
