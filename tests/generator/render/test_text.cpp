// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/render/render.hpp"
#include "tests/generator/render/output.hpp"
#include "tests/generator/render/tableaux.hpp"

using namespace hvi::gen;

TEST_CASE("two small tableaux stand side by side, exact and as decimals") {
    CHECK(render_text(tableau("stormer-verlet"), 3) == R"(stormer-verlet

stages      2
basis       1, cos(pi*tau)

 c | A             c~  | A~
 0 | 0    0        1/2 | 1/2  0
 1 | 1/2  1/2      1/2 | 1/2  0
---+---------     -----+---------
 b | 1/2  1/2      b   | 1/2  1/2

to 3 digits

 c    | A                 c~    | A~
 0    | 0      0          0.500 | 0.500  0
 1.00 | 0.500  0.500      0.500 | 0.500  0
------+-------------     -------+-------------
 b    | 0.500  0.500      b     | 0.500  0.500
)");
}

TEST_CASE("wider ones stand one below the other") {
    const std::string text = render_text(tableau("trig3"), 16);
    CHECK(contains(text, "\n 1   | 1/2-1/pi  2/pi  1/2-1/pi\n"));
    CHECK(contains(text, "\n (pi^2-2*pi-4)/(2*pi^2-4*pi) | 1/2-1/pi  (pi-4)/(pi^2-2*pi)  0\n"));
    CHECK(contains(text, "to 15 digits\n"));
    CHECK(contains(text, "-0.0576593107582637"));
}

TEST_CASE("still wider ones are listed entry by entry") {
    const std::string text = render_text(tableau("gauss:4"), 50);
    CHECK(contains(text, "\n A[1,1] = 1/8-sqrt(30)/144\n"));
    CHECK(contains(text, "to 50 digits\n"));
    CHECK(contains(text, "\n b[1] = 0.17392742256872692868653197461099970361767434791695\n"));
}

TEST_CASE("digits that were asked for are cut only where that makes tables") {
    CHECK(contains(render_text(tableau("gauss:3"), 16), "to 14 digits"));
    CHECK(contains(render_text(tableau("gauss:3"), 17), "to 17 digits"));
    CHECK(contains(render_text(tableau("gauss:3"), 4), "to 4 digits"));
    CHECK(contains(render_text(tableau("gauss:6"), 16), "to 16 digits"));
}

TEST_CASE("no line passes the eightieth column") {
    for (const std::string name : {"midpoint", "trig3", "chebyshev:3", "gauss:4", "gauss:5",
                                   "gauss:6", "chebyshev:5", "lobatto:4", "newton-cotes:7"})
        for (const int digits : {1, 16, 50}) {
            CAPTURE(name, digits);
            CHECK(longest_line(render_text(tableau(name), digits)) <= 80);
        }
}

TEST_CASE("numbers without a closed form are decimals") {
    const std::string text = render_text(tableau("gauss:6"), 16);
    CHECK(contains(text, "c[1] = 0.03376524289842399\n"));
    CHECK_FALSE(contains(text, "c[1] = 0.03376524289842399\n\n"));
    CHECK(text.find("c[1] =") == text.rfind("c[1] ="));
}

TEST_CASE("with a free parameter there are no decimals") {
    const std::string text = render_text(tableau("1, cos(w*tau)", "0, 1"), 16);
    CHECK(contains(text, "parameters  w\n"));
    CHECK(contains(text, "sin(w)"));
    CHECK_FALSE(contains(text, "digits"));
    CHECK_FALSE(contains(text, "?"));
}
