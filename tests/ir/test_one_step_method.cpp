// The record of a method that takes a step.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>

#include <catch2/catch.hpp>

#include "generator/ir/one_step_method.hpp"
#include "generator/support/error.hpp"
#include "tests/emit/tableaux.hpp"

using namespace hvi::gen;

namespace {

OneStepMethod composed(const char* name) {
    return {tableaux::verlet(),
            named_composition(std::make_shared<const Source>(Source{"--compose", name}))};
}

Tableau& tableau(OneStepMethod& method) { return std::get<Tableau>(method.base); }

bool is_found(const std::function<void(OneStepMethod&)>& mistake) {
    OneStepMethod method = composed("yoshida:4");
    verify(method);
    mistake(method);
    try {
        verify(method);
    } catch (const InternalError&) { return true; }
    return false;
}

}  // namespace

TEST_CASE("a method that contradicts itself is found") {
    CHECK(is_found([](OneStepMethod& method) { tableau(method).A.pop_back(); }));
    CHECK(is_found([](OneStepMethod& method) { tableau(method).A_tilde[0].pop_back(); }));
    CHECK(is_found([](OneStepMethod& method) { tableau(method).c.pop_back(); }));
    CHECK(is_found([](OneStepMethod& method) { tableau(method).parameters = {"w"}; }));
    CHECK(is_found([](OneStepMethod& method) { method.composition->steps.clear(); }));
    CHECK(is_found([](OneStepMethod& method) { method.composition->steps[0] = Number(1); }));
    CHECK(is_found([](OneStepMethod& method) { method.composition->steps[1] = Number(1); }));
}

TEST_CASE("methods are equal where their numbers are") {
    const OneStepMethod yoshida = composed("yoshida:4");
    CHECK(yoshida == composed("yoshida:4"));
    CHECK_FALSE(yoshida == composed("suzuki:4"));
    CHECK_FALSE(yoshida == OneStepMethod{tableaux::verlet()});
    CHECK_FALSE(OneStepMethod{tableaux::verlet()} == OneStepMethod{tableaux::position_verlet()});
    CHECK(dump(yoshida).find("composition: yoshida:4\ngamma: ") == 0);
}
