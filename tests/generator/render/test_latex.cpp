// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/render/render.hpp"
#include "tests/generator/render/tableaux.hpp"

using namespace hvi::gen;

TEST_CASE("the two halves stand side by side as in Example 4.7") {
    CHECK(render_latex(tableau("gauss:2"), 16) ==
          R"(% hvi-gen tableau --method gauss:2 --format latex
\[
\renewcommand{\arraystretch}{1.5}
\begin{array}{c|cc}
\frac{1}{2} - \frac{\sqrt{3}}{6} & \frac{1}{4} & \frac{1}{4} - \frac{\sqrt{3}}{6} \\
\frac{1}{2} + \frac{\sqrt{3}}{6} & \frac{1}{4} + \frac{\sqrt{3}}{6} & \frac{1}{4} \\
\hline
 & \frac{1}{2} & \frac{1}{2}
\end{array}
\qquad
\begin{array}{c|cc}
\frac{1}{2} - \frac{\sqrt{3}}{6} & \frac{1}{4} & \frac{1}{4} - \frac{\sqrt{3}}{6} \\
\frac{1}{2} + \frac{\sqrt{3}}{6} & \frac{1}{4} + \frac{\sqrt{3}}{6} & \frac{1}{4} \\
\hline
 & \frac{1}{2} & \frac{1}{2}
\end{array}
\]
)");
}

TEST_CASE("numbers without a closed form are decimals, small ones with a power of ten") {
    const std::string text = render_latex(tableau("gauss:6"), 5);
    CHECK(text.find("\n0.033765 & 0.042831 & ") != std::string::npos);
    const std::string tiny = render_latex(tableau("1, tau", "1e-30, 1"), 5);
    CHECK(tiny.find("\\frac{1}{1000000000000000000000000000000}") != std::string::npos);
    CHECK(text.find('e', text.find("arraystretch") + 30) != std::string::npos);
}

TEST_CASE("the command in the comment gives the same tableau for any METHOD") {
    const std::string text = render_latex(tableau("1, cos( pi*tau )", "0, 1"), 5);
    CHECK(
        text.rfind("% hvi-gen tableau --basis \"1, cos(pi*tau)\" --nodes \"0, 1\" --format latex\n",
                   0) == 0);
}
