// The examples in docstrings of public headers compile, and are right.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/runtime/docstrings/examples.hpp"

TEST_CASE("the example of each public header returns 0") {
    for (const docstrings::Example& example : docstrings::examples()) {
        INFO(example.header);
        CHECK(example.main() == 0);
    }
}
