// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "generator/render/render.hpp"
#include "tests/generator/render/tableaux.hpp"

using namespace hvi::gen;

TEST_CASE("both tableaux and all entries") {
    const std::string text = render_markdown(tableau("stormer-verlet"), 3);
    CHECK(text.rfind(R"(# Tableau of `stormer-verlet`

- stages: 2
- basis functions: `1`, `cos(pi*tau)`

| c | A | |
|---|---|---|
| `0` | `0` | `0` |
| `1` | `1/2` | `1/2` |
| **b** | `1/2` | `1/2` |

| c_tilde | A_tilde | |
|---|---|---|
| `1/2` | `1/2` | `0` |
| `1/2` | `1/2` | `0` |
| **b** | `1/2` | `1/2` |

## Entries

| matrix | row | column | exact | decimal | double |
|---|---|---|---|---|---|
| c | 1 | 1 | `0` | `0` | `0x0p+0` |
| c | 2 | 1 | `1` | `1.00` | `0x1p+0` |
)",
                     0) == 0);
    CHECK(text.find("| A_tilde | 2 | 1 | `1/2` | `0.500` | `0x1p-1` |\n") != std::string::npos);
}

TEST_CASE("the rows of a table have as many cells as its head") {
    for (const char* name : {"midpoint", "trig3", "gauss:6"}) {
        std::istringstream lines(render_markdown(tableau(name), 8));
        std::ptrdiff_t cells = 0;
        for (std::string line; std::getline(lines, line);) {
            const std::ptrdiff_t bars = std::count(line.begin(), line.end(), '|');
            if (cells != 0 && bars != 0) CHECK(bars == cells);
            cells = bars;
        }
    }
}

TEST_CASE("what there is not is an empty cell") {
    CHECK(render_markdown(tableau("gauss:6"), 5).find("| c | 1 | 1 |  | `0.033765` | `") !=
          std::string::npos);
    const std::string text = render_markdown(tableau("1, cos(w*tau)", "0, 1"), 5);
    CHECK(text.find("- parameters: `w`\n") != std::string::npos);
    CHECK(text.find("` |  |  |\n") != std::string::npos);
}
