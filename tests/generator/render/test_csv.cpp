// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "generator/render/render.hpp"
#include "tests/generator/render/tableaux.hpp"

using namespace hvi::gen;

TEST_CASE("a line for each entry") {
    CHECK(render_csv(tableau("midpoint"), 3) == R"(matrix,row,column,exact,decimal,double
c,1,1,1/2,0.500,0x1p-1
b,1,1,1,1.00,0x1p+0
c_tilde,1,1,1/2,0.500,0x1p-1
A,1,1,1/2,0.500,0x1p-1
A_tilde,1,1,1/2,0.500,0x1p-1
M,1,1,1,1.00,0x1p+0
M_inverse,1,1,1,1.00,0x1p+0
B,1,1,1,1.00,0x1p+0
A_psi,1,1,1/2,0.500,0x1p-1
)");
    const std::string text = render_csv(tableau("trig3"), 5);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1 + 4 * 3 + 5 * 9);
    CHECK(text.find("\nA,1,3,0,0,0x0p+0\n") != std::string::npos);
}

TEST_CASE("what there is not is an empty field") {
    CHECK(render_csv(tableau("gauss:6"), 5).find("\nc,1,1,,0.033765,0x1.") != std::string::npos);
    CHECK(render_csv(tableau("1, cos(w*tau)", "0, 1"), 5).find(",,\n") != std::string::npos);
}
