// Quaternions and matrices.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include <hvi/rotation.hpp>

#include "tests/runtime/groups/groups.hpp"

namespace {

void check_both_ways(std::array<double, 4> q) {
    double length = 0;
    for (const double part : q) { length += part * part; }
    length = std::copysign(std::sqrt(length), q[0]);
    const std::array<double, 9> R = hvi::rotation_of(q);
    CHECK(groups::defect(R) < 3e-15);
    CHECK(hvi::detail::determinant(R) > 0);
    const std::array<double, 4> back = hvi::quaternion_of(R);
    for (std::size_t k = 0; k < 4; ++k) { CHECK(std::abs(back[k] - q[k] / length) < 1e-15); }
}

}  // namespace

TEST_CASE("a rotation is that of its quaternion, and back") {
    std::mt19937 engine(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 2000; ++i) {
        check_both_ways({normal(engine), normal(engine), normal(engine), normal(engine)});
    }
    // By nearly half a turn, where w is small, and about each axis.
    for (const double w : {1e-3, 1e-9, 1e-15}) {
        check_both_ways({w, 1, 0, 0});
        check_both_ways({w, 1e-8, -1, 1e-9});
        check_both_ways({w, 0.5, 0.5, -0.7});
        check_both_ways({w, 0, 1e-5, 1});
    }
    check_both_ways({1, 1e-12, 0, 0});
}

TEST_CASE("a quaternion turns as v -> q v q* does") {
    // By 2 pi/3 about the diagonal: x to y, y to z.
    const std::array<double, 9> R = hvi::rotation_of(std::array<double, 4>{1, 1, 1, 1});
    CHECK(R == std::array<double, 9>{0, 0, 1, 1, 0, 0, 0, 1, 0});
    const std::array<double, 9> half = hvi::rotation_of(std::array<double, 4>{0, 0, 0, 2});
    CHECK(half == std::array<double, 9>{-1, 0, 0, 0, -1, 0, 0, 0, 1});
    CHECK(std::isnan(hvi::rotation_of(std::array<double, 4>{})[0]));
}
