// Tableaux typed from the paper and from the literature, compared exactly.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

using Row = std::vector<std::string>;
using Rows = std::vector<Row>;

/// A tableau as it stands in print.
struct Published {
    Row c;
    Row b;
    Rows A;
    Rows A_tilde;
    Row c_tilde;
};

bool same_rows(const NumberMatrix& matrix, const Rows& rows) {
    if (matrix.size() != rows.size()) return false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i, texts(matrix[i]), rows[i]);
        if (!same(matrix[i], rows[i])) return false;
    }
    return true;
}

void check(const Tableau& tableau, const Published& published) {
    CHECK(same(tableau.c, published.c));
    CHECK(same(tableau.b, published.b));
    CHECK(same_rows(tableau.A, published.A));
    CHECK(same_rows(tableau.A_tilde, published.A_tilde));
    CHECK(same(tableau.c_tilde, published.c_tilde));
}

/// Whether every text is as short as the published one, or shorter.
bool as_short(const NumberMatrix& matrix, const Rows& published) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < matrix[i].size(); ++j) {
            UNSCOPED_INFO(text(matrix[i][j]) << " for the published " << published[i][j]);
            if (text(matrix[i][j]).size() > published[i][j].size()) return false;
        }
    }
    return true;
}

void check_length(const Tableau& tableau, const Published& published) {
    CHECK(as_short({tableau.c, tableau.b, tableau.c_tilde},
                   {published.c, published.b, published.c_tilde}));
    CHECK(as_short(tableau.A, published.A));
    CHECK(as_short(tableau.A_tilde, published.A_tilde));
}

// Example 4.6
const Published trig3{
    {"0", "1/2", "1"},
    {"(pi-2)/(2*pi)", "2/pi", "(pi-2)/(2*pi)"},
    {{"0", "0", "0"}, {"1/4", "1/pi", "(pi-4)/(4*pi)"}, {"(pi-2)/(2*pi)", "2/pi", "(pi-2)/(2*pi)"}},
    {{"(pi-2)/(2*pi)", "(pi-4)/(pi^2-2*pi)", "0"},
     {"(pi-2)/(2*pi)", "1/pi", "0"},
     {"(pi-2)/(2*pi)", "1/(pi-2)", "0"}},
    {"(pi^2-2*pi-4)/(2*pi^2-4*pi)", "1/2", "(pi^2-2*pi+4)/(2*pi^2-4*pi)"}};

// Example 4.7 (iii)
const Published chebyshev3{{"1/2-sqrt(2)/4", "1/2", "1/2+sqrt(2)/4"},
                           {"1/3", "1/3", "1/3"},
                           {{"1/6+sqrt(2)/48", "1/6-sqrt(2)/6", "1/6-5*sqrt(2)/48"},
                            {"1/6+sqrt(2)/8", "1/6", "1/6-sqrt(2)/8"},
                            {"1/6+5*sqrt(2)/48", "1/6+sqrt(2)/6", "1/6-sqrt(2)/48"}},
                           {{"1/6-sqrt(2)/48", "1/6-sqrt(2)/8", "1/6-5*sqrt(2)/48"},
                            {"1/6+sqrt(2)/6", "1/6", "1/6-sqrt(2)/6"},
                            {"1/6+5*sqrt(2)/48", "1/6+sqrt(2)/8", "1/6+sqrt(2)/48"}},
                           {"1/2-sqrt(2)/4", "1/2", "1/2+sqrt(2)/4"}};

// Example 4.7 (ii); Hairer, Lubich & Wanner, Table II.1.1
const Published gauss2{{"1/2-sqrt(3)/6", "1/2+sqrt(3)/6"},
                       {"1/2", "1/2"},
                       {{"1/4", "1/4-sqrt(3)/6"}, {"1/4+sqrt(3)/6", "1/4"}},
                       {{"1/4", "1/4-sqrt(3)/6"}, {"1/4+sqrt(3)/6", "1/4"}},
                       {"1/2-sqrt(3)/6", "1/2+sqrt(3)/6"}};

}  // namespace

TEST_CASE("Example 4.4: one-stage methods") {
    check(derive(method("symplectic-euler")), {{"0"}, {"1"}, {{"0"}}, {{"1"}}, {"1"}});
    check(derive(method("midpoint")), {{"1/2"}, {"1"}, {{"1/2"}}, {{"1/2"}}, {"1/2"}});
    check(derive(method("adjoint-symplectic-euler")), {{"1"}, {"1"}, {{"1"}}, {{"0"}}, {"0"}});
}

TEST_CASE("Example 4.5: Stormer-Verlet") {
    // The print has A~ = A, which is not symplectic; step 5 gives this A~.
    const Published verlet{{"0", "1"},
                           {"1/2", "1/2"},
                           {{"0", "0"}, {"1/2", "1/2"}},
                           {{"1/2", "0"}, {"1/2", "0"}},
                           {"1/2", "1/2"}};
    const Tableau tableau = derive(method("stormer-verlet"));
    check(tableau, verlet);
    CHECK(same_rows(tableau.galerkin->M, {{"1", "1"}, {"1", "-1"}}));
    CHECK(same_rows(tableau.galerkin->M_inverse, {{"1/2", "1/2"}, {"1/2", "-1/2"}}));
    CHECK(same(tableau.galerkin->B, Row{"1", "0"}));
    CHECK(same_rows(tableau.galerkin->A_psi, {{"0", "0"}, {"1", "0"}}));
    check(derive(method("1, tau", "0, 1")), verlet);
    check(derive(method("lobatto:2")), verlet);
}

TEST_CASE("Example 4.6: three stages with trigonometric functions") {
    const Tableau tableau = derive(method("trig3"));
    check(tableau, trig3);
    check_length(tableau, trig3);
    CHECK(same_rows(tableau.galerkin->M, {{"1", "1", "1"}, {"1", "0", "-1"}, {"0", "1", "0"}}));
    CHECK(same_rows(tableau.galerkin->M_inverse,
                    {{"1/2", "1/2", "-1/2"}, {"0", "0", "1"}, {"1/2", "-1/2", "-1/2"}}));
    CHECK(same(tableau.galerkin->B, Row{"1", "0", "2/pi"}));
    CHECK(same_rows(tableau.galerkin->A_psi,
                    {{"0", "0", "0"}, {"1/2", "1/pi", "1/pi"}, {"1", "0", "2/pi"}}));
}

TEST_CASE("Example 4.7: Chebyshev's quadrature with equal weights") {
    check(derive(method("chebyshev:1")), {{"1/2"}, {"1"}, {{"1/2"}}, {{"1/2"}}, {"1/2"}});
    check(derive(method("chebyshev:2")), gauss2);
    check_length(derive(method("chebyshev:2")), gauss2);
    check(derive(method("chebyshev:3")), chebyshev3);
    check_length(derive(method("chebyshev:3")), chebyshev3);
}

TEST_CASE("Gauss methods") {
    check(derive(method("gauss:2")), gauss2);
    // Hairer, Lubich & Wanner, Table II.1.1
    const Rows A{{"5/36", "2/9-sqrt(15)/15", "5/36-sqrt(15)/30"},
                 {"5/36+sqrt(15)/24", "2/9", "5/36-sqrt(15)/24"},
                 {"5/36+sqrt(15)/30", "2/9+sqrt(15)/15", "5/36"}};
    const Row c{"1/2-sqrt(15)/10", "1/2", "1/2+sqrt(15)/10"};
    check(derive(method("gauss:3")), {c, {"5/18", "4/9", "5/18"}, A, A, c});
}

TEST_CASE("Lobatto IIIA - IIIB pairs") {
    // Hairer, Lubich & Wanner, Tables II.1.2 and II.2.1
    check(derive(method("lobatto:3")),
          {{"0", "1/2", "1"},
           {"1/6", "2/3", "1/6"},
           {{"0", "0", "0"}, {"5/24", "1/3", "-1/24"}, {"1/6", "2/3", "1/6"}},
           {{"1/6", "-1/6", "0"}, {"1/6", "1/3", "0"}, {"1/6", "5/6", "0"}},
           {"0", "1/2", "1"}});
    check(derive(method("lobatto:4")),
          {{"0", "(5-sqrt(5))/10", "(5+sqrt(5))/10", "1"},
           {"1/12", "5/12", "5/12", "1/12"},
           {{"0", "0", "0", "0"},
            {"(11+sqrt(5))/120", "(25-sqrt(5))/120", "(25-13*sqrt(5))/120", "(-1+sqrt(5))/120"},
            {"(11-sqrt(5))/120", "(25+13*sqrt(5))/120", "(25+sqrt(5))/120", "(-1-sqrt(5))/120"},
            {"1/12", "5/12", "5/12", "1/12"}},
           {{"1/12", "(-1-sqrt(5))/24", "(-1+sqrt(5))/24", "0"},
            {"1/12", "(25+sqrt(5))/120", "(25-13*sqrt(5))/120", "0"},
            {"1/12", "(25+13*sqrt(5))/120", "(25-sqrt(5))/120", "0"},
            {"1/12", "(11-sqrt(5))/24", "(11+sqrt(5))/24", "0"}},
           {"0", "(5-sqrt(5))/10", "(5+sqrt(5))/10", "1"}});
}

TEST_CASE("Radau nodes give the A of Radau IIA and I") {
    // Hairer & Wanner, Tables IV.5.1 and IV.5.5
    const Tableau right = derive(method("radau-right:2"));
    CHECK(same(right.c, Row{"1/3", "1"}));
    CHECK(same_rows(right.A, {{"5/12", "-1/12"}, {"3/4", "1/4"}}));
    const Tableau left = derive(method("radau-left:2"));
    CHECK(same(left.c, Row{"0", "2/3"}));
    CHECK(same(left.b, Row{"1/4", "3/4"}));
    CHECK(same_rows(left.A, {{"0", "0"}, {"1/3", "1/3"}}));
}

TEST_CASE("weights of well-known quadratures") {
    const auto weights = [](const std::string& name) { return derive(method(name)).b; };
    CHECK(same(weights("newton-cotes:4"), {"1/8", "3/8", "3/8", "1/8"}));
    CHECK(same(weights("newton-cotes:5"), {"7/90", "16/45", "2/15", "16/45", "7/90"}));
    CHECK(same(weights("newton-cotes-open:3"), {"2/3", "-1/3", "2/3"}));
    CHECK(same(weights("clenshaw-curtis:5"), {"1/30", "4/15", "2/5", "4/15", "1/30"}));
    CHECK(same(weights("fejer:3"), {"2/9", "5/9", "2/9"}));
    CHECK(same(weights("chebyshev:5"), {"1/5", "1/5", "1/5", "1/5", "1/5"}));
    CHECK(same(weights("gauss:4"),
               {"1/4-sqrt(30)/72", "1/4+sqrt(30)/72", "1/4+sqrt(30)/72", "1/4-sqrt(30)/72"}));
}
