// Functions that are not defined, not real or not integrable: each with the place in tau and in the
// text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/refusals.hpp"

using namespace hvi::gen;

namespace {

struct Refused {
    std::string basis;  ///< the function after `1, `, with brackets around what the caret marks
    std::string nodes;
    std::string where;  ///< a part of the message
};

void check(int status, const std::vector<Refused>& table) {
    for (const Refused& refused : table) {
        const std::string nodes = refused.nodes;
        std::string text = refused.basis;
        text.erase(text.find('['), 1);
        text.erase(text.find(']'), 1);
        const Refusal answer = refusal([&] { return derive(method("1, " + text, nodes)); });
        CAPTURE(text, nodes, answer.what);
        CHECK(answer.status == status);
        CHECK(answer.name == "--basis");
        CHECK(answer.marked == "1, " + refused.basis);
        CHECK(answer.says(refused.where));
    }
}

}  // namespace

TEST_CASE("a divisor with a zero") {
    check(mathematics, {
                           {"1/[tau]", "0, 1", "divisor is 0 at tau = 0"},
                           {"[tau]^(-2)", "1/2, 1", "divisor is 0 at tau = 0"},
                           {"1/[(tau-1)]", "0, 1/2", "divisor is 0 at tau = 1"},
                           {"2/[(1-3*tau)]", "0, 1", "divisor is 0 at tau = 1/3"},
                           {"1/[(tau^2-1/2)]", "0, 1", "divisor is 0 at tau = sqrt(2)/2"},
                           {"1/[(tau^3-1/2)]", "0, 1", "divisor is 0 near tau = 0.7937"},
                           {"1/[(2*tau-1)^2]", "0, 1", "divisor is 0 at tau = 1/2"},
                           {"1/[cos(pi*tau)]", "0, 1", "divisor is 0 at tau = 1/2"},
                           {"1/[(2*cos(pi*tau)-1)]", "0, 1", "divisor is 0 at tau = 1/3"},
                           {"1/[(1+cos(2*pi*tau))]", "0, 1", "divisor is 0 at tau = 1/2"},
                           {"1/[(exp(tau)-2)]", "0, 1", "divisor is 0 near tau = 0.6931"},
                           {"1/[(cos(tau)-tau)]", "0, 1", "divisor is 0 near tau = 0.7391"},
                           {"1/[log(1+tau)]", "1/2, 1", "divisor is 0 at tau = 0"},
                           {"exp(1/[(tau-1/5)])", "0, 1", "divisor is 0 at tau = 1/5"},
                           {"1/(1+1/[tau])", "1/2, 1", "divisor is 0 at tau = 0"},
                       });
}

TEST_CASE("a removable singularity has no value as it is written") {
    check(mathematics, {
                           {"sin(tau)/[tau]", "0, 1", "not defined on all of [0, 1]"},
                           {"tau/[tau]", "0, 1", "not defined on all of [0, 1]"},
                       });
}

TEST_CASE("nodes outside [0, 1] belong to the domain") {
    check(mathematics,
          {
              {"1/[(1+tau)]", "-1, 1", "on all of [-1, 1]: this divisor is 0 at tau = -1"},
              {"1/[(3-2*tau)]", "0, 2", "on all of [0, 2]: this divisor is 0 at tau = 3/2"},
              {"[sqrt(1+tau)]", "-2, 1", "negative at tau = -2"},
              {"[log(tau+1/2)]", "-1, 1", "negative at tau = -1"},
          });
    CHECK(refusal([] { return derive(method("1, 1/(1+tau)", "-1/2, 3/2")); }).status == 0);
    CHECK(refusal([] { return derive(method("1, sqrt(1+tau)", "-1, 1")); }).status == 0);
}

TEST_CASE("not real on a part of [0, 1]") {
    check(mathematics, {
                           {"[sqrt(tau-1/2)]", "1/2, 1", "negative at tau = 0"},
                           {"[sqrt(1-2*tau)]", "0, 1/2", "negative at tau = 1"},
                           {"[(tau-1/3)^(1/3)]", "1/2, 1", "negative at tau = 0"},
                           {"[log(tau-1/2)]", "3/4, 1", "negative at tau = 0"},
                           {"[log(1/4-tau)]", "0, 1/8", "negative at tau = 1"},
                           {"[sqrt(sin(2*pi*tau))]", "0, 1/4", "negative at tau = 3/4"},
                           {"[asin(2*tau)]", "0, 1/4", "negative at tau = 1"},
                           {"[acos(exp(tau))]", "0, 1", "negative at tau = 1"},
                       });
}

TEST_CASE("infinite within the domain, or not integrable at its end") {
    check(mathematics,
          {
              {"[tan(2*tau)]", "0, 1", "is 0 near tau = 0.7854"},
              {"[tan(pi*tau)]", "0, 1", "is 0 at tau = 1/2"},
              {"[log((tau-1/2)^2)]", "0, 1", "is 0 at tau = 1/2"},
              {"[((tau-1/2)^2)^(-1/4)]", "0, 1", "is 0 at tau = 1/2"},
              {"[tau^(-3/2)]", "1/2, 1", "is 0 at tau = 0"},
              {"1/[(tau*sqrt(tau))]", "1/2, 1", "is 0 at tau = 0"},
              {"[tau^(-1/2)*tau^(-1/2)]", "1/2, 1", "integral is infinite at tau = 0"},
              {"[(1-tau)^(-1/2)*(1-tau)^(-2/3)]", "0, 1/2", "integral is infinite at tau = 1"},
          });
}

TEST_CASE("without a value at a node") {
    check(mathematics, {
                           {"[log(tau)]", "0, 1", "at node 1, c = 0"},
                           {"[1/sqrt(tau)]", "1/2, 0", "at node 2, c = 0"},
                           {"[(1-tau)^(-1/3)]", "0, 1", "at node 2, c = 1"},
                           {"[1/sqrt(1-tau^2)]", "0, 1", "at node 2, c = 1"},
                       });
}

TEST_CASE("what cannot be decided says where") {
    check(mathematics,
          {{"1/[(1+sin(pi*tau+exp(1)))]", "0, 1",
            "cannot decide whether this divisor has a zero near"},
           {"[exp(tau)/(exp(-20)+sin(pi*tau-1)^2)]", "0, 3/4", "cannot enclose the integral"}});
}

TEST_CASE("functions that are not built yet") {
    check(input,
          {
              {"1/[(w-tau)]", "0, 1", "free parameter"},
              {"[exp(w*tau^2)]", "0, 1", "free parameter"},
              {"[cos(w*tau)*exp(tau^2)]", "0, 1", "free parameter"},
              {"1/[(1+tau)]", "0, w", "free parameter"},
              {"[log(tau)*exp(tau)]", "1/2, 1", "singularity at tau = 0 is not built yet"},
              {"[log(sin(pi*tau))]", "1/4, 1/2", "singularity at tau = 0 is not built yet"},
              {"[exp(tau)/sqrt(1-tau^2)]", "0, 1/2", "singularity at tau = 1 is not built yet"},
              {"[sqrt((tau-1/2)^2)]", "0, 1", "is 0 at tau = 1/2"},
              {"2^[tau]", "0, 1", "no rational number"},
              {"[(w+atan(2))]*tau", "0, 1", "free parameter"},
              {"[w*atan(2)*tau]", "0, 1", "free parameter"},
          });
    const Refusal mixed =
        refusal([] { return derive(method("1, exp(tau^2), cos(w*tau)", "0, 1/2, 1")); });
    CHECK(mixed.status == input);
    CHECK(mixed.helps("--param"));
}

TEST_CASE("integrable singularities at an end are allowed") {
    const auto basis =
        GENERATE(as<std::string>(), "1, sqrt(tau)", "1, tau^(1/3)", "1, 1/sqrt(tau)", "1, log(tau)",
                 "1, sqrt(1-tau^2)", "1, sqrt(sin(pi*tau))", "1, exp(tau)/sqrt(1-tau)",
                 "1, tau*asin(tau)", "1, 1/sqrt(1-tau^2)");
    CAPTURE(basis);
    CHECK(refusal([&] { return derive(method(basis, "1/3, 1/2")); }).status == 0);
}
