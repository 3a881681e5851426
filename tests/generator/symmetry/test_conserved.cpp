// Brackets of invariants with H, ranks, and the laws that momentum maps obey.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>

#include <catch2/catch.hpp>

#include "tests/generator/symmetry/found.hpp"

using namespace hvi::gen;

namespace {

Hamiltonian hamiltonian(const std::string& text, const std::string& coordinates,
                        const std::string& momenta) {
    return hamiltonian_from_text(given("H", text), given("q", coordinates), given("p", momenta));
}

QuantityFinding finding_of(const Hamiltonian& H, const std::string& invariant) {
    const Hamiltonian I = hamiltonian(invariant, "x, y, z", "px, py, pz");
    return findings(H, {{I.expression, I.source}}).front();
}

}  // namespace

TEST_CASE("Brackets with H") {
    const Hamiltonian kepler =
        hamiltonian("(px^2+py^2+pz^2)/2 - k/sqrt(x^2+y^2+z^2)", "x, y, z", "px, py, pz");
    const auto is_conserved = [&](const char* text) {
        return finding_of(kepler, text).conserved == Vanishing::proved;
    };
    CHECK(is_conserved("x*py-y*px"));
    CHECK(is_conserved("(x*py-y*px)^2 + (y*pz-z*py)^2 + (z*px-x*pz)^2"));
    // Laplace, Runge and Lenz
    CHECK(is_conserved("py*(x*py-y*px) - pz*(z*px-x*pz) - k*x/sqrt(x^2+y^2+z^2)"));
    CHECK(is_conserved("(px^2+py^2+pz^2)/2 - k/sqrt(x^2+y^2+z^2)"));
    CHECK(finding_of(kepler, "px").conserved == Vanishing::refuted);
    CHECK(to_text(finding_of(kepler, "x").bracket) == "px");
    CHECK(
        finding_of(kepler, "py*(x*py-y*px) - pz*(z*px-x*pz) - 2*k*x/sqrt(x^2+y^2+z^2)").conserved ==
        Vanishing::refuted);
}

TEST_CASE("What a method can keep depends on the form of an invariant") {
    const Hamiltonian H = hamiltonian("(px^2+py^2+pz^2+x^2+y^2+z^2)/2", "x, y, z", "px, py, pz");
    const QuantityFinding rotation = finding_of(H, "x*py-y*px");
    CHECK(rotation.is_momentum_map);
    CHECK_FALSE(rotation.quadratic->has_squares);
    const QuantityFinding energy = finding_of(H, "(px^2+x^2)/2");
    CHECK_FALSE(energy.is_momentum_map);
    CHECK(energy.quadratic->has_squares);
    CHECK_FALSE(energy.quadratic->squares_stay);
    CHECK_FALSE(finding_of(H, "(px^2+x^2)^2").quadratic);

    // px is constant: so is its square, whatever the method does
    const Hamiltonian free = hamiltonian("(px^2+py^2+pz^2)/2 + y^4", "x, y, z", "px, py, pz");
    const QuantityFinding square = finding_of(free, "px^2 + 3*pz");
    CHECK(square.quadratic->has_squares);
    CHECK(square.quadratic->squares_stay);

    // made of others
    const Hamiltonian text =
        hamiltonian("(x*py-y*px)^2 - 3*pz*(x*py-y*px) + 1", "x, y, z", "px, py, pz");
    const Hamiltonian L = hamiltonian("x*py-y*px", "x, y, z", "px, py, pz");
    const Hamiltonian P = hamiltonian("pz", "x, y, z", "px, py, pz");
    const Hamiltonian disc =
        hamiltonian("(px^2+py^2+pz^2)/2 + (x^2+y^2)^2", "x, y, z", "px, py, pz");
    const auto all = findings(disc, {{L.expression, L.source},
                                     {P.expression, P.source},
                                     {text.expression, text.source},
                                     {disc.expression, disc.source}});
    CHECK(all[2].made_of == std::vector<std::size_t>{0, 1});
    CHECK(all[3].made_of.empty());
}

TEST_CASE("Ranks of d2H/dp2") {
    CHECK(found_of("q*p").rank == 0);
    CHECK(found_of("p^2/2").rank == 1);
    CHECK(found_of("p^4").rank == 1);
    CHECK(found_of("(p1+p2)^2/2 + q1^2 + q2^4").rank == 1);
    CHECK(found_of("(p1+p2)^4/2 + q1^2*p1 + q2^4").rank == 1);
    CHECK(found_of("p1^2*p2 + q1").rank == 2);
    CHECK(found_of("p1*p2 + p3").rank == 2);
    CHECK(found_of("cos(p1-p2) + cos(p2-p3) + cos(p3-p1)").rank == 2);
    CHECK(found_of("m*p^2").rank == 1);
    // Where no constant vector belongs to what is missing: a square of one form, and lengths, of
    // which p itself is taken to zero.
    CHECK(found_of("(q1*p1+q2*p2)^2").rank == 1);
    CHECK(found_of("(q1*p1+q2*p2+q3*p3)^2 + p1").rank == 1);
    CHECK(found_of("(p1*cos(q1)+p2*sin(q1))^2").rank == 1);
    CHECK(found_of("sqrt(p^2)").rank == 0);
    CHECK(found_of("sqrt(p1^2+p2^2)").rank == 1);
    CHECK(found_of("sqrt(1+p1^2+p2^2)").rank == 2);
    CHECK(found_of("q1*(p1*p2+q2*p3^2)").rank == 3);
}

TEST_CASE("Structure constants are those of brackets, and obey Jacobi's identity") {
    const auto found = found_of("(p1^2+p2^2+p3^2)/2");
    REQUIRE(found.affine.algebra);
    REQUIRE(found.affine.algebra->constants);
    std::map<std::array<std::size_t, 3>, int> c;
    for (const StructureConstant& constant : *found.affine.algebra->constants) {
        const int value = to_text(constant.value) == "1" ? 1 : -1;
        CHECK((to_text(constant.value) == "1" || to_text(constant.value) == "-1"));
        c[{constant.i, constant.j, constant.k}] = value;
        c[{constant.j, constant.i, constant.k}] = -value;
    }
    const std::size_t n = found.affine.basis.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l) {
                    int sum = 0;
                    for (std::size_t m = 0; m < n; ++m)
                        sum += c[{i, j, m}] * c[{m, k, l}] + c[{j, k, m}] * c[{m, i, l}] +
                               c[{k, i, m}] * c[{m, j, l}];
                    CHECK(sum == 0);
                }
}
