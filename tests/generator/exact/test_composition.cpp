// Sizes of the steps of compositions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/exact/methods/composition.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

Composition named(const std::string_view name) {
    return named_composition(source(std::string(name), "--compose"));
}

Number sum_of_powers(const NumberVector& numbers, unsigned exponent) {
    Number sum(0);
    for (const Number& number : numbers) sum = sum + power(number, exponent);
    return sum;
}

}  // namespace

TEST_CASE("steps of compositions are symmetric and lead to the end") {
    const std::map<std::string_view, std::size_t> counts{{"yoshida:4", 3},      {"yoshida:6", 7},
                                                         {"yoshida:8", 15},     {"suzuki:4", 5},
                                                         {"blanes-moan:6", 20}, {"kahan-li:8", 17}};
    REQUIRE(composition_names().size() == counts.size());
    for (const std::string_view name : composition_names()) {
        INFO(name);
        const NumberVector steps = named(name).steps;
        REQUIRE(steps.size() == counts.at(name));
        CHECK(sum_of_powers(steps, 1).is_one());
        for (std::size_t i = 0; i < steps.size(); ++i)
            CHECK((steps[i] - steps[steps.size() - 1 - i]).is_zero());
    }
}

TEST_CASE("sums of odd powers vanish to 50 digits up to the order") {
    // Conditions of order for what has an expansion of its logarithm in odd powers of h, symmetric
    // methods and the pairs of a method and its adjoint (Hairer, Lubich & Wanner, (III.3.3)).
    for (const std::string_view name : composition_names()) {
        INFO(name);
        const Composition composition = named(name);
        for (unsigned k = 3; k < static_cast<unsigned>(composition.order); k += 2)
            CHECK(std::abs(sum_of_powers(composition.steps, k).nearest_double()) < 1e-50);
        const auto next = static_cast<unsigned>(composition.order) + 1;
        CHECK(std::abs(sum_of_powers(composition.steps, next).nearest_double()) > 1e-6);
    }
}

TEST_CASE("what can be composed") {
    CHECK_NOTHROW(check_composition(named("yoshida:4"), tableau("gauss:3")));
    CHECK_NOTHROW(check_composition(named("blanes-moan:6"), tableau("symplectic-euler")));
    CHECK_THROWS_AS(check_composition(named("yoshida:4"), tableau("symplectic-euler")), MathError);
    CHECK_THROWS_AS(check_composition(named("kahan-li:8"), tableau("radau-left:2")), MathError);
    CHECK_THROWS_AS(named("yoshida:5"), InputError);
}

TEST_CASE("methods by the names that compositions are printed by") {
    const auto composed = [](const std::string& name) {
        return composed_method(std::make_shared<const Source>(Source{"--methods", name}));
    };
    for (const std::string name :
         {"gauss:4", "symplectic-euler", "stormer-verlet-yoshida:6", "gauss:2-kahan-li:8",
          "newton-cotes-open:3-suzuki:4", "adjoint-symplectic-euler-blanes-moan:6"})
        CHECK(composed(name).name() == name);
    CHECK(composed("stormer-verlet").parts() == 1);
    CHECK(composed("gauss:2-kahan-li:8").parts() == 17);
    const auto message_of = [&](const std::string& name) {
        try {
            static_cast<void>(exact_method(composed(name)));
            return std::string();
        } catch (const Error& error) { return message(error); }
    };
    CHECK(message_of("gauss:2-kahan-li:9") == "error: there is no composition `kahan-li:9`\n"
                                              "  --methods: kahan-li:9\n"
                                              "             ^~~~~~~~~~\n"
                                              "help: did you mean `kahan-li:8`?\n");
    CHECK(message_of("stormer-verlte").find("did you mean `stormer-verlet`?") != std::string::npos);
    CHECK(message_of("radau-left:2-yoshida:4").find("\n  --methods: radau-left:2-yoshida:4\n") !=
          std::string::npos);
}
