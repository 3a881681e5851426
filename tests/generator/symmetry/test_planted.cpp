// Symmetries that are there because a Hamiltonian is made of invariants, hidden by a linear change
// of the variables: all of them are found, and where it is said that there are no others, as many.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <random>

#include <catch2/catch.hpp>

#include "tests/generator/symmetry/found.hpp"

using namespace hvi::gen;

TEST_CASE("Planted symmetries are found under linear changes of the variables") {
    std::mt19937 random(20261124);
    std::size_t count = 0;
    while (count < 50)
        for (const Plan& plan : plans) {
            const SceneSymmetries found = found_of(hidden(plan.hamiltonian, random_change(random)),
                                                   "q1, q2, q3", "p1, p2, p3");
            INFO(plan.hamiltonian << "\n" << found.name);
            CHECK(found.affine.basis.size() == plan.dimension);
            CHECK(found.affine.doubt == "");
            if (plan.dimension > 0) CHECK(algebra_name(found) == plan.algebra);
            ++count;
        }
}
