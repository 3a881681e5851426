// Methods that are too large for exact arithmetic have no certificate, and the error has its place.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/certify/rule_certificate.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

TEST_CASE("a certificate with free parameters and too long numbers is refused") {
    const Method given = method("1, cos(w*tau), sin(v*tau)", "gauss:3");
    const Refusal refused = refusal([&] { return certify(given, 4); });
    CHECK(refused.status == 1);
    CHECK(refused.says("gets too large: polynomials of more than 8192 terms"));
    CHECK(refused.name == "--basis");
    CHECK(refused.marked == "[1, cos(w*tau), sin(v*tau)]");
    CHECK(refused.helps("--param"));
}
