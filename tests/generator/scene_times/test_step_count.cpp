// How many steps a run takes is decided exactly.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "generator/scene/step_count.hpp"

using namespace hvi::gen;

namespace {

Steps count(const std::string& step, const std::string& until) {
    const SceneTimes times = times_of(scene_from_toml({"scene.toml", R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 + w*q^2"
[parameters]
w = "1/3"
m = [1, "sqrt(2)"]
[initial]
q = 1
p = 0
)toml"}));
    const auto text = [&](const std::string& name, const std::string& value) {
        return expression_of_parameters(times, name,
                                        std::make_shared<const Source>(Source{name, value}));
    };
    return steps_until(times, text("step", step), text("until", until));
}

}  // namespace

TEST_CASE("quotients that doubles get wrong") {
    CHECK(count("0.1", "0.3").count == 3);  // 0.3/0.1 is 2.9999999999999996
    CHECK(count("1/10", "3/10").size == 0.1);
    CHECK(count("0.1", "0.29999999999999999999").count == 2);
    CHECK(count("1/20", "200").count == 4000);
    CHECK(count("1/3", "10^15/3").count == 1000000000000000);
    CHECK(count("2*pi/100", "200*pi").count == 10000);
    CHECK(count("sqrt(2)", "sqrt(2)*7").count == 7);
    CHECK(count("m[2]", "m[2]*7 - w/10^40").count == 6);
    CHECK(count("log(2)", "log(8)").count >= 2);
}

TEST_CASE("a step that is no part of the run, none, and steps back") {
    CHECK(count("2", "1").count == 0);
    CHECK(count("1", "0").count == 0);
    CHECK(count("-w", "-1").count == 3);
    CHECK(count("-w", "-1").size == -1.0 / 3);
    CHECK_THROWS_AS(count("0", "1"), MathError);
    CHECK_THROWS_AS(count("w - 1/3", "1"), MathError);
    CHECK_THROWS_AS(count("-1", "1"), MathError);
    CHECK_THROWS_AS(count("10^-16", "1"), MathError);
    CHECK_THROWS_AS(count("sqrt(-1)", "1"), MathError);
    CHECK_THROWS_AS(count("q", "1"), InputError);
    CHECK_THROWS_AS(count("m", "1"), InputError);
    CHECK_THROWS_AS(count("1/0", "1"), InputError);
}

TEST_CASE("what is left of the time behind the last step is exactly nothing, or less than a step") {
    CHECK(count("0.1", "0.3").left == 0);
    CHECK(count("sqrt(2)", "sqrt(2)*7").left == 0);
    CHECK(count("1/20", "200").left == 0);
    CHECK(count("1", "0").left == 0);
    CHECK(count("3/10", "2").left == 0.2);
    CHECK(count("3", "2").left == 2);
    CHECK(count("-3/10", "-2").left == -0.2);
    CHECK(count("m[2]", "m[2]*7 + w/10^40").left == Approx(1e-40 / 3));
}

TEST_CASE("times that no double is near") {
    CHECK(count("10^-300", "10^-299").count == 10);
    CHECK(count("10^299", "10^300").count == 10);
    CHECK_THROWS_AS(count("10^400", "10^400"), MathError);
    CHECK_THROWS_AS(count("10^300", "10^310"), MathError);
    CHECK_THROWS_AS(count("10^400", "20"), MathError);
    CHECK_THROWS_AS(count("10^-400", "10^-399"), MathError);
}
