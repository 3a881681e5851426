// The record of a method that takes a step.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>

#include <catch2/catch.hpp>

#include "generator/ir/one_step_method.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/ir/is_found.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;

namespace {

OneStepMethod composed(const char* name) {
    return {tableaux::verlet(),
            named_composition(std::make_shared<const Source>(Source{"--compose", name}))};
}

Tableau& tableau(OneStepMethod& method) { return std::get<Tableau>(method.base); }

bool is_found(const std::function<void(OneStepMethod&)>& mistake) {
    return hvi::gen::is_found<OneStepMethod>(composed("yoshida:4"), mistake);
}

bool is_found_in_rule(const std::function<void(GalerkinRule&)>& mistake) {
    return hvi::gen::is_found<OneStepMethod>(
        {derive_any(method("1, tau", "0, 1/2, 1"))},
        [&](OneStepMethod& method) { mistake(std::get<GalerkinRule>(method.base)); });
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

TEST_CASE("a rule that contradicts itself is found") {
    CHECK(is_found_in_rule([](GalerkinRule& rule) { rule.b.pop_back(); }));
    CHECK(is_found_in_rule([](GalerkinRule& rule) { rule.Psi.pop_back(); }));
    CHECK(is_found_in_rule([](GalerkinRule& rule) { rule.A_psi[1].pop_back(); }));
    CHECK(is_found_in_rule([](GalerkinRule& rule) { rule.gram.clear(); }));
    CHECK(is_found_in_rule([](GalerkinRule& rule) { rule.n[0].pop_back(); }));
}

TEST_CASE("methods are equal where their numbers are") {
    const OneStepMethod yoshida = composed("yoshida:4");
    CHECK(yoshida == composed("yoshida:4"));
    CHECK_FALSE(yoshida == composed("suzuki:4"));
    CHECK_FALSE(yoshida == OneStepMethod{tableaux::verlet()});
    CHECK_FALSE(OneStepMethod{tableaux::verlet()} == OneStepMethod{tableaux::position_verlet()});
    CHECK(dump(yoshida).find("composition: yoshida:4\ngamma: ") == 0);
}
