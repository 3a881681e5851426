// Whether sums are written out: by the operations that this makes, by wishes, and by need.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "generator/read/unrolling.hpp"

using namespace hvi::gen;

namespace {

Scene chain(const std::string& size, const std::string& more = "") {
    return scene_from_toml(
        Source{"chain.toml", "hamiltonian = \"sum(i=1..N, p[i]^2/2 + x[i]^4)" + more +
                                 "\"\ncoordinates = [\"x[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
                                 "[parameters]\nN = " +
                                 size + "\n[initial]\n\"x[i]\" = 1\n\"p[i]\" = 0\n"});
}

std::size_t operations(const char* expression, std::size_t most = 1000) {
    return operations_written_out(parse_indexed_expression(given("H", expression)), {{"N", 4}},
                                  most);
}

}  // namespace

TEST_CASE("operations are counted as if sums were written out") {
    CHECK(operations("x") == 0);
    CHECK(operations("-x") == 0);
    CHECK(operations("x*y + 2") == 2);
    CHECK(operations("sin(x)/y^2") == 4);  // sin, power, reciprocal, product
    CHECK(operations("sum(i=1..N, x[i]^2)") == 8);
    // Six pairs, each of a difference, a square and an addition, and an addition for each i.
    CHECK(operations("sum(i=1..N, j=i+1..N, (x[i] - x[j])^2)") == 22);
    CHECK(operations("sum(i=1..100000000, x[i])", 50) == 50);
    CHECK(operations("sum(i=1..0, x[i])") == 0);
}

TEST_CASE("sums are written out up to so many operations, and not by degrees of freedom") {
    // Four operations a term: a power, a quotient, a power, an addition, and one for the sum.
    const UnrollDecision few = unroll_decision(chain("256"), {});
    CHECK(few.writes_out);
    CHECK(few.why.find("operations") != std::string::npos);
    // Their second derivatives are a matrix.
    const UnrollDecision many = unroll_decision(chain("257"), {});
    CHECK_FALSE(many.writes_out);
    CHECK(many.why == "there are more than 256 degrees of freedom");
    const UnrollDecision long_ones = unroll_decision(chain("250", " + sum(j=1..N, x[j]*x[1])"), {});
    CHECK_FALSE(long_ones.writes_out);
    CHECK(long_ones.why == "written out they make more than 2000 operations");
    CHECK_FALSE(unroll_decision(chain("65"), {Unroll::no}).writes_out);
    CHECK(unroll_decision(chain("500"), {Unroll::yes}).writes_out);
}

TEST_CASE("a wish that loops do not have writes sums out") {
    const UnrollDecision needed = unroll_decision(chain("500"), {Unroll::automatic, "--dense"});
    CHECK(needed.writes_out);
    CHECK(needed.why.find("--dense") != std::string::npos);
}

TEST_CASE("what loops turn out not to have may be written out where that is left open") {
    CHECK(may_write_out(chain("256"), Unroll::automatic));
    CHECK_FALSE(may_write_out(chain("257"), Unroll::automatic));
    CHECK_FALSE(may_write_out(chain("3"), Unroll::no));
}
