// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/expr/expression.hpp"
#include "generator/read/parse.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

std::string latex(const std::string& text) { return to_latex(parse_expression(source(text))); }

}  // namespace

TEST_CASE("the entries of Examples 4.6 and 4.7 look as in the paper") {
    CHECK(latex("(pi-2)/(2*pi)") == R"(\frac{\pi - 2}{2\pi})");
    CHECK(latex("(pi^2-2*pi-4)/(2*pi^2-4*pi)") == R"(\frac{\pi^{2} - 2\pi - 4}{2\pi^{2} - 4\pi})");
    CHECK(latex("1/6-5*sqrt(2)/48") == R"(\frac{1}{6} - \frac{5\sqrt{2}}{48})");
    CHECK(latex("-1/2") == R"(-\frac{1}{2})");
    CHECK(latex("1/(pi-2)") == R"(\frac{1}{\pi - 2})");
}

TEST_CASE("factors stand side by side, with a dot where two numbers would meet") {
    CHECK(latex("2*pi*tau") == R"(2\pi\tau)");
    CHECK(latex("pi*w") == R"(\pi w)");
    CHECK(latex("w*pi") == R"(w\pi)");
    CHECK(latex("2*3") == R"(2 \cdot 3)");
    CHECK(latex("x*2^k") == R"(x \cdot 2^{k})");
    CHECK(latex("2*(a+b)*c") == R"(2\left(a + b\right)c)");
}

TEST_CASE("functions") {
    CHECK(latex("sqrt(3+2*sqrt(2))") == R"(\sqrt{3 + 2\sqrt{2}})");
    CHECK(latex("exp(-w/2)") == R"(e^{-w/2})");
    CHECK(latex("sin(w/3)") == R"(\sin\left(w/3\right))");
    CHECK(latex("cos(w/(2*pi))") == R"(\cos\left(w/\left(2\pi\right)\right))");
    CHECK(latex("log(2)") == R"(\log\left(2\right))");
    CHECK(latex("log10(x)") == R"(\log_{10}\left(x\right))");
    CHECK(latex("asinh(x)^2") == R"(\operatorname{arsinh}^{2}\left(x\right))");
    CHECK(latex("abs(x-1)") == R"(\left|x - 1\right|)");
    CHECK(latex("abs(x)^2") == R"(\left(\left|x\right|\right)^{2})");
    CHECK(latex("min(x,2)") == R"(\min\left(x, 2\right))");
    CHECK(latex("if(x<0,-x,x)") == R"(\begin{cases}-x & x < 0 \\ x & \text{otherwise}\end{cases})");
    CHECK(latex("if(x<=0,-x,x)").find(R"(x \le 0)") != std::string::npos);
    CHECK(latex("bspline(3,1)") == R"(\operatorname{bspline}\left(3, 1\right))");
}

TEST_CASE("powers") {
    CHECK(latex("sin(x)^2") == R"(\sin^{2}\left(x\right))");
    CHECK(latex("sin(x)^-1") == R"(\left(\sin\left(x\right)\right)^{-1})");
    CHECK(latex("exp(x)^2") == R"(\left(e^{x}\right)^{2})");
    CHECK(latex("(x^2)^3") == R"(\left(x^{2}\right)^{3})");
    CHECK(latex("x^(1/2)") == R"(x^{1/2})");
    CHECK(latex("(1/2)^x") == R"(\left(\frac{1}{2}\right)^{x})");
}

TEST_CASE("names") {
    CHECK(latex("omega") == R"(\omega)");
    CHECK(latex("w1") == "w_{1}");
    CHECK(latex("w_1") == "w_{1}");
    CHECK(to_latex(Expression::symbol("w[1]")) == "w_{1}");
    CHECK(to_latex(Expression::symbol("px[12]")) == "\\mathit{px}_{12}");
    CHECK(to_latex(Expression::symbol("omega[2]")) == "\\omega_{2}");
    CHECK(to_latex(Expression::symbol("x[-1]")) == "x_{-1}");
    CHECK(to_latex(Expression::symbol("X_2[1]")) == "X_{1,2}");
    CHECK(to_latex(Expression::symbol("X1_2")) == "X_{1,2}");
    CHECK(latex("ecc") == R"(\mathit{ecc})");
    CHECK(latex("x_dot") == R"(\dot{x})");
    CHECK(latex("Theta1_dot_2") == R"(\dot{\Theta}_{1,2})");
    CHECK(to_latex(Expression::symbol("x_dot[3]")) == R"(\dot{x}_{3})");
    CHECK(latex("dot_a") == R"(\mathit{dot}_{a})");
    CHECK(latex("omega_max") == R"(\omega_{\mathit{max}})");
    CHECK(latex("a_b_c") == "a_{b,c}");
    CHECK(latex("q12_3") == "q_{12,3}");
    CHECK(latex("p_theta_n") == R"(p_{\theta,n})");
    CHECK(latex("a__b") == R"(\mathit{a\_\_b})");
    CHECK(latex("_") == R"(\mathit{\_})");
    CHECK(to_latex(Expression::symbol("q_{n+1}")) == "q_{n+1}");
    CHECK(latex("w_") == R"(\mathit{w\_})");
}
