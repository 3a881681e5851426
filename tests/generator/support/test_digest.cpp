// The digest FNV-1a of 64 bits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/support/digest.hpp"

using namespace hvi::gen;

// Values of http://www.isthe.com/chongo/tech/comp/fnv/, "Test vectors".
TEST_CASE("a digest is that of FNV-1a, in one part or in many") {
    CHECK(digest("") == "cbf29ce484222325");
    CHECK(digest("a") == "af63dc4c8601ec8c");
    CHECK(digest("foobar") == "85944171f73967e8");
    Digest parts;
    for (const char* const part : {"f", "oob", "", "ar"}) parts.add(part);
    CHECK(parts.text() == "85944171f73967e8");
}
