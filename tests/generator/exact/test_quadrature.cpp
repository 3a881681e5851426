// Integrals without a closed form, against values from elsewhere.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/function.hpp"
#include "tests/generator/exact/refusals.hpp"

using namespace hvi::gen;

TEST_CASE("integrals to 50 digits") {
    // By closed forms in erf, Ei, Si, Ci, li, Beta, hypergeometric and Bessel functions, evaluated
    // with mpmath 1.3 to 80 digits: sqrt(pi)/2 erfi(1), (Ei(2) - Ei(1))/e, Ci(e) - Ci(1),
    // B(3/4, 1/2)/pi, 2F1(1/2, 1/3; 4/3; -1), pi/2 J_1(1), ...
    struct Known {
        std::string function, end, integral;
    };
    const std::vector<Known> table{
        {"exp(tau^2)", "1", "1.4626517459071816088040485868569881551208700962167"},
        {"exp(tau^2)", "1/2", "0.54498710418362222366242013140701667104079810362894"},
        {"exp(-tau^2)", "1", "0.74682413281242702539946743613185300535449968681261"},
        {"tau*exp(tau^2)", "1", "0.85914091422952261768014373567633124887862354684998"},
        {"cos(tau^2)", "1", "0.90452423790027208147478836683255714580799182059550"},
        {"sin(tau^2)", "1", "0.31026830172338110180815242316539650757450938883245"},
        {"exp(tau)/(1+tau)", "1", "1.1253860830832697192032409881915366421568007805313"},
        {"sin(tau)/(1+tau)", "1", "0.28422698551241120133881918999257407538913242749892"},
        {"log(1+tau)*exp(tau)", "1", "0.75878330228045039069891812873386469254046427592346"},
        {"exp(tau)/sqrt(tau)", "1", "2.9253034918143632176080971737139763102417401924335"},
        {"sqrt(tau)*exp(-tau)", "1", "0.37894469164098470380394366597039213790868855578084"},
        {"exp(exp(tau))", "1", "6.3165638390276788487220831332077347640789900773617"},
        {"cos(exp(tau))", "1", "-0.12344592156058835559579322985877296914431320185565"},
        {"1/log(2+tau)", "1", "1.1184248145496991880323334781531082300195006343027"},
        {"tanh(tau)", "1", "0.43378083048302718702649468490012786335883292844810"},
        {"tan(tau)", "1", "0.61562647038601426214703751640889186335093542394637"},
        {"1/(1+tau^3)", "1", "0.83564884826472105333710345970011076678652212748433"},
        {"1/(1+tau^4)", "1", "0.86697298733991103757399516388287071365217536734524"},
        {"1/(2+tau^3)", "1/2", "0.24622743469418055211125300382738952219673126803708"},
        {"sqrt(1+tau^2)", "1", "1.1477935746963190370171490245947451937989161018193"},
        {"1/sqrt(1+tau^3)", "1", "0.90960424263889577391249595922101518570388357971628"},
        {"sqrt(sin(pi*tau))", "1", "0.76275976350181318806232598096361579329262923734807"},
        {"atan(tau)", "1/2", "0.12025202884329818022398057057568994932696798436906"},
        {"1/(1+tau^2)", "1/2", "0.46364760900080611621425623146121440202853705428612"},
        {"tau^(1/3)", "1/2", "0.29763769724403740151594480736355779882340499898122"},
        {"tanh(tau)^2", "1", "0.23840584404423511188054171739520640958723140274206"},
        {"exp(-1000*(tau-1/2)^2)", "1", "0.056049912163979286993112824338688008938543237752108"},
        {"atan(tau)/(1+tau)", "1", "0.27219826128795026631258611227970174341732296254616"},
        {"log(1+tau)/(1+tau^2)", "1", "0.27219826128795026631258611227970174341732296254616"},
        {"asin(tau)*tau", "1", "0.39269908169872415480783042290993786052464617492189"},
        {"sqrt(1-tau^2)*cos(tau)", "1", "0.69122984369208426288314166384697051871873756385722"},
    };
    for (const auto& [function, end, integral] : table) {
        CAPTURE(function, end);
        CHECK(integral_digits(function, end) == integral);
    }
}

TEST_CASE("more digits are had when they are asked for") {
    // sqrt(pi)/2 erfi(1), by the series sum_k 1/(k! (2k+1)) in exact rationals
    const std::string digits = on_new_ground([](const Ground& ground) {
        return function("exp(tau^2)", ground).integral(Number(1), ground).decimal(300);
    });
    Number sum;
    Number factorial(1);
    for (long k = 0; k < 180; ++k) {
        if (k > 0) factorial = factorial * Number(k);
        sum = sum + Number(1) / (factorial * Number(2 * k + 1));
    }
    CHECK(digits == sum.decimal(300));
}

TEST_CASE("a tableau of functions without closed form") {
    const Tableau tableau = derive(method("1, exp(tau^2)", "0, 1"));
    CHECK(text(tableau.c[1]) == "1");
    CHECK(text(tableau.galerkin->M[1][1]) == "e");
    CHECK(text(tableau.galerkin->B[1]) == "none");
    // b = (e - I, I - 1)/(e - 1) with I = sqrt(pi)/2 erfi(1), by mpmath
    CHECK(tableau.b[0].decimal(20) == "0.73074746048959407756");
    CHECK(tableau.b[1].decimal(20) == "0.26925253951040592244");
    CHECK((tableau.b[0] + tableau.b[1]).nearest_double() == 1.0);
    for (const Number& entry : tableau.A[0]) CHECK(entry.is_zero());
}

TEST_CASE("the two routes agree for functions of every kind") {
    const auto given = GENERATE(
        as<std::string>(), "1, 1/(1+tau) | 0, 1", "1, exp(tau^2), tanh(tau) | 0, 1/2, 1",
        "1, sqrt(1+tau), log(1+tau) | gauss:3", "1, 1/(1+tau^4) | 1/3, 1",
        "1, tau^(1/3), exp(tau)*sqrt(tau) | 1/4, 1/2, 1", "1, log(2+tau)/(1+tau^2) | -1/2, 3/2",
        "bspline(2,0), bspline(2,1), bspline(2,2), bspline(2,3) | 0, 1/3, 2/3, 1",
        "1, bspline(1,1)*exp(tau^2), bspline(1,2) | 0, 1/2, 1");
    CAPTURE(given);
    const Routes routes = both_routes(any_method(given));
    const auto& [b, A] = routes.by_integration;
    for (std::size_t i = 0; i < b.size(); ++i) {
        CHECK(b[i].decimal(50) == routes.by_matrix.b[i].decimal(50));
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Number& entry = routes.by_matrix.A[i][j];
            if (entry.known_zero() == true) {
                CHECK(A[i][j].is_zero());
            } else {
                CHECK(A[i][j].decimal(50) == entry.decimal(50));
            }
        }
    }
}

TEST_CASE("constants in the span of functions that nothing is known of") {
    CHECK(refused("exp(tau^2), 1+exp(tau^2)", "0, 1").status == 0);
    CHECK(refused("exp(tau^2), exp(-tau^2)", "0, 1").says("constants are not in the span"));
    CHECK(refused("tau, tanh(tau)", "1/2, 1").says("constants are not in the span"));
    // cosh^2 - sinh^2 = 1 in terms of tanh, which the normal form does not know
    const auto hidden = refused("tanh(tau^2)^2, 1/(exp(tau^2)+exp(-tau^2))^2", "1/2, 1");
    CHECK(hidden.status == 1);
    CHECK(hidden.says("cannot decide whether constants are in the span"));
    CHECK_FALSE(hidden.help.empty());
}

TEST_CASE("parameters with a value are numbers") {
    Method given = method("1, exp(w*tau^2), 1/(w+tau)", "0, 1/2, 1");
    set_parameter(given, parse_parameter(source("w=2", "--param")));
    const Tableau tableau = derive(given);
    CHECK(same(text(tableau.galerkin->B[2]), "log(3/2)"));
    CHECK(tableau.galerkin->B[1].decimal(20) == "2.3644538928052092846");
}

TEST_CASE("long and deep functions come to an end") {
    const auto nested = [](const std::string& open, int count) {
        std::string text = "1, ";
        for (int i = 0; i < count; ++i) text += open;
        return text + "tau^2" + std::string(static_cast<std::size_t>(count), ')');
    };
    CHECK(derive(method(nested("sin(", 150), "0, 1")).b.size() == 2);
    CHECK(derive(method(nested("sqrt(1+", 100), "0, 1")).b.size() == 2);
    CHECK(derive(method(nested("1/(1+", 100), "0, 1")).b.size() == 2);
    CHECK(derive(method("1, (1+tau)^(999/2)", "0, 1")).b.size() == 2);
    CHECK(derive(method("1, (1+tau+tau^3)^(-60)", "0, 1")).b.size() == 2);
    CHECK(refusal([&] { return derive(method(nested("exp(", 50), "0, 1")); }).status == 1);
    CHECK(refusal([] { return derive(method("1, (1+tau)^(9999/2)", "0, 1")); }).status == 2);
}
