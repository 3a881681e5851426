// Parts of H with known flows: which are found, what is refused, and what moves.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/lower/parts.hpp"
#include "generator/lower/system.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

/// A scene of two degrees of freedom; `split` is the text behind its parameters.
std::string planar(const std::string& hamiltonian, const std::string& split = "") {
    return "hamiltonian = \"" + hamiltonian +
           "\"\ncoordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
           "[parameters]\na = 2\nb = 3\n" +
           split + "[initial]\nx = 1\ny = 0\npx = 0\npy = 1\n";
}

std::string body(const std::string& hamiltonian) {
    return "hamiltonian = \"" + hamiltonian +
           "\"\nrotations = [\"R\"]\nangular_momenta = [\"L\"]\n"
           "[initial]\nR = \"identity\"\nL = [1, 2, 3]\n";
}

HamiltonianParts all_of(const std::string& text) {
    const WrittenOutScene scene = unrolled(scene_from_toml(*source(text, "s.toml")));
    return with_parts(system_of(scene), scene).parts.value();
}

std::vector<HamiltonianPart> parts_of(const std::string& text) { return all_of(text).parts; }

std::vector<std::string> flows_of(const std::string& text) {
    std::vector<std::string> flows;
    for (const HamiltonianPart& part : parts_of(text)) { flows.push_back(part.flow); }
    return flows;
}

/// Returns what moves, `q1` and so on.
std::string moved(const HamiltonianPart& part) {
    std::string text;
    for (const Moved& each : part.moved) {
        text += (text.empty() ? "" : " ") + std::string(each.is_conjugate ? "p" : "q") +
                std::to_string(each.component + 1);
    }
    return text;
}

template <class Error>
Error error_of(const std::string& text) {
    try {
        static_cast<void>(parts_of(text));
    } catch (const Error& error) { return error; }
    FAIL("nothing is refused");
    throw;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("parts are found among the terms of H") {
    CHECK(flows_of(planar("px^2/2 + py^2/2 + x^2*y^2")) == Names{"a shear", "a shear"});
    CHECK(flows_of(planar("(px^2 + py^2 + x^2 + y^2)/2 + x^2*y")) ==
          Names{"a quadratic form", "a shear"});
    CHECK(flows_of(planar("(px^2 + py^2)/2 + a*x^2/2 + b*(y^2 - x*y/3)/2 + x^2*y")) ==
          Names{"a coupled quadratic form", "a shear"});
    CHECK(flows_of(planar("(x^2 + px^2)^2 + a*(y^2 + b*py^2)^3")) ==
          Names{"a function of a quadratic form"});
}

TEST_CASE("a function of a sum of forms of one degree of freedom each has a flow") {
    const Names of_form{"a function of a quadratic form"};
    CHECK(flows_of(planar("(x^2 + px^2 + y^2 + py^2)^2/4")) == of_form);
    CHECK(flows_of(planar("log(a + px^2 + (y + b*py)^2 - py^2)")) == of_form);
    CHECK(flows_of(planar("sqrt(1 + x^2 + 2*px^2 + a*y^2)")) == of_form);
    CHECK(flows_of(planar("sqrt(1 + x^2 + px^2)*(1 + x^2 + px^2)")) == of_form);
    CHECK(flows_of(planar("exp(-(x^2 + px^2)*a - y^2 - py^2 + 3)")) == of_form);
    // NOTE: of products of them the slopes are no multiples of those of one form, and of the last
    // the form couples.
    for (const char* other :
         {"(x^2 + px^2)^2*(y^2 + py^2)^2/4", "sqrt(1 + x + x^2 + px^2)",
          "(x^2 + px^2)*sqrt(1 + y^2 + py^2)", "(x^2 + px^2)/(y^2 + py^2)", "(x*py - y*px)^2"}) {
        CAPTURE(other);
        CHECK(std::string(error_of<MathError>(planar(other)).what()).find("no splitting") == 0);
    }
}

TEST_CASE("each part moves what it moves") {
    const std::vector<HamiltonianPart> parts = parts_of(planar("px^2/2 + a*py + x^4*y"));
    REQUIRE(parts.size() == 2);
    CHECK(moved(parts[0]) == "q1 q2");
    CHECK(moved(parts[1]) == "p1 p2");
    CHECK(moved(parts_of(planar("px*y + y^3/3"))[0]) == "q1 p2");
}

TEST_CASE("a product of a coordinate with the momentum of another is a shear") {
    CHECK(flows_of(planar("px*y")) == Names{"a shear"});
}

TEST_CASE("a quadratic form that couples degrees of freedom has a flow, however it is written") {
    const Names coupled{"a coupled quadratic form"};
    CHECK(flows_of(planar("x*py - y*px")) == coupled);
    CHECK(flows_of(planar("((px + b*y/2)^2 + (py - b*x/2)^2)/(2*a)")) == coupled);
    CHECK(flows_of(planar("(px^2 + (py - b*x)^2)/2 - a*y + 3")) == coupled);
    CHECK(flows_of(planar("(x^2 + y^2 + px^2 + py^2)/2 + a*x*y")) == coupled);
    CHECK(flows_of(planar("((x + y)*(px + py) + (x - y)*(px - py))*a + x*py")) == coupled);
    CHECK(flows_of(planar("(px + y)^2/2 + x^2/2 + x*y^3")) ==
          Names{"a coupled quadratic form", "a shear"});
}

TEST_CASE("forms of one degree of freedom need a matrix where three shears make no flow") {
    CHECK(flows_of(planar("x*px + py^2/2")) == Names{"a quadratic form, a shear"});
    const std::vector<HamiltonianPart> parts = parts_of(planar("(x^2 + px^2)/2 + a*y*py + b*py"));
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].flow == "a quadratic form");
    CHECK(moved(parts[0]) == "q1 p1");
    REQUIRE(parts[0].forms.size() == 1);
    CHECK(parts[0].forms[0].degrees == std::vector<std::size_t>{1});
    CHECK(parts[0].forms[0].rows.size() == 5);
    REQUIRE(parts[0].usual);
    CHECK(parts_of(planar("(x^2 + px^2)/2 + x*px/3 + py^2/2"))[0].forms.empty());
}

TEST_CASE("the rows of a form are its second derivatives and its slopes at the origin") {
    const WrittenOutScene scene = unrolled(
        scene_from_toml(*source(planar("(2*x - 3*py)^2/2 + (px + 5*y)^2/2 - 7*y + 11"), "s.toml")));
    const System system = with_parts(system_of(scene), scene);
    const std::vector<FormMoved>& forms = system.parts->parts.at(0).forms;
    REQUIRE(forms.size() == 1);
    CHECK(forms[0].degrees == std::vector<std::size_t>{0, 1});
    const std::vector<long> expected{4, 0, 0, -6, 0, 25, 5, 0, -7, 1, 0, 0, 9, 0};
    REQUIRE(forms[0].rows.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        CAPTURE(k);
        CHECK(forms[0].rows[k] == Graph::number(expected[k]));
    }
}

TEST_CASE("what couples and is no quadratic form, or a large one, is refused") {
    const auto with = [](const std::string& part, const std::string& rest) {
        return planar(part + " + " + rest, "[split]\nA = \"" + part + "\"\nB = \"" + rest + "\"\n");
    };
    const std::string frame = "x*py - y*px";
    for (const std::string& part : {frame + " + x^4", frame + " + x^2*y", frame + " + cos(px)"}) {
        CAPTURE(part);
        CHECK(std::string(error_of<MathError>(with(part, "x^2")).what()) ==
              "the flow of `A` is not known: no flow is known where x, px, y, py move");
    }
    const auto chain = [](int n) {
        std::string text = "[initial]\nq = [0";
        for (int k = 1; k < n; ++k) { text += ", 0"; }
        text += "]\np = [1";
        for (int k = 1; k < n; ++k) { text += ", 1"; }
        const std::string count = std::to_string(n), last = std::to_string(n - 1);
        const std::string form =
            "sum(i=1.." + count + ", p[i]^2/2) + sum(i=1.." + last + ", (q[i+1] - q[i])^2/2)";
        return "hamiltonian = \"" + form + "\"\ncoordinates = [\"q[1.." + count +
               "]\"]\nmomenta = [\"p[1.." + count + "]\"]\n[split]\nA = \"" + form + "\"\n" + text +
               "]\n";
    };
    CHECK(flows_of(chain(8)) == Names{"a coupled quadratic form"});
    const auto refused = error_of<MathError>(chain(9));
    CHECK(refused.help().find("quadratic forms that couple up to 8 degrees") != std::string::npos);
}

TEST_CASE("turns about the axes of a body are parts of their own") {
    const std::vector<HamiltonianPart> parts =
        parts_of(body("L[1]^2/2 + L[2]^2/4 + L[3]^2/6 + R[3,3]"));
    REQUIRE(parts.size() == 4);
    CHECK(moved(parts[0]) == "p1 p2");
    CHECK(moved(parts[1]) == "q2 q3 q5 q6 q8 q9 p2 p3");
    CHECK(moved(parts[2]) == "q1 q3 q4 q6 q7 q9 p1 p3");
    CHECK(moved(parts[3]) == "q1 q2 q4 q5 q7 q8 p1 p2");
    CHECK(parts[2].flow == "a turn about an axis of a body");
    CHECK(flows_of(body("cos(L[2]) + L[2]^4")) == Names{"a turn about an axis of a body"});
}

TEST_CASE("a free symmetric body is one part, whatever its axis is") {
    const Names free_body{"a free symmetric body"};
    const std::vector<HamiltonianPart> parts =
        parts_of(body("(L[1]^2 + L[2]^2)/2 + L[3]^2/6 + R[3,3]"));
    REQUIRE(parts.size() == 2);
    const std::size_t free = parts[0].flow == "a shear" ? 1 : 0;
    CHECK(parts[free].flow == free_body.front());
    CHECK(moved(parts[free]) == "q1 q2 q3 q4 q5 q6 q7 q8 q9 p1 p2");
    CHECK(parts[1 - free].flow == "a shear");
    CHECK(moved(parts_of(body("L[1]^4 + (L[2]^2 + L[3]^2)^2*L[1]"))[0]).find("p2 p3") !=
          std::string::npos);
    CHECK(moved(parts_of(body("L[1]^2/4 + L[2]^2/7 + L[3]^2/4"))[0]).find("p1 p3") !=
          std::string::npos);
    // NOTE: with three equal moments L stays.
    const std::vector<HamiltonianPart> ball = parts_of(body("sqrt(1 + L[1]^2 + L[2]^2 + L[3]^2)"));
    REQUIRE(ball.size() == 1);
    CHECK(ball[0].flow == free_body.front());
    CHECK(moved(ball[0]) == "q1 q2 q3 q4 q5 q6 q7 q8 q9");
    CHECK(flows_of(body("L[1]^2/2 + L[2]^2/3 + L[3]^2/4")).size() == 3);
}

TEST_CASE("parts that are named have to be H") {
    const auto with = [](const std::string& parts) {
        return planar("px^2/2 + py^2/2 + a*x^2*y^2", "[split]\n" + parts);
    };
    CHECK(flows_of(with("A = \"(px^2 + py^2)/2\"\nB = \"a*x^2*y^2\"\n")).size() == 2);
    CHECK(flows_of(with("A = \"px^2/2\"\nB = \"py^2/2\"\nC = \"a*(x*y)^2\"\n")).size() == 3);
    CHECK(flows_of(planar("sum(i=1..2, (px^2 + i*py^2)/(2*a)) + b*(x + y)/2 + x^4",
                          "[split]\nA = \"sum(i=1..2, (px^2 + i*py^2)/(2*a))\"\n"
                          "B = \"b*(x + y)/2 + x^4\"\n"))
              .size() == 2);
    CHECK(flows_of(planar("(px^2 + py^2)/2 - a/sqrt(x^2 + y^2)",
                          "[split]\nA = \"(px^2 + py^2)/2\"\nB = \"-a/sqrt(x^2 + y^2)\"\n"))
              .size() == 2);
    const auto wrong = error_of<InputError>(with("A = \"(px^2 + py^2)/2\"\nB = \"x^2*y^2\"\n"));
    CHECK(std::string(wrong.what()) == "the parts do not add up to the Hamiltonian");
    CHECK(wrong.help().find("H minus their sum is ") != std::string::npos);
    const auto constant =
        error_of<InputError>(with("A = \"(px^2 + py^2)/2\"\nB = \"a*x^2*y^2 + 1\"\n"));
    CHECK(std::string(constant.what()) == "the parts do not add up to the Hamiltonian");
}

TEST_CASE("a part without a known flow is refused with its name and what couples") {
    const auto refused = error_of<MathError>(
        planar("px^2/2 + py^2/2 + x^4", "[split]\nA = \"px^2/2 + x^4\"\nB = \"py^2/2\"\n"));
    CHECK(std::string(refused.what()) ==
          "the flow of `A` is not known: no flow is known where x, px move");
    CHECK(refused.place().has_value());
    CHECK(std::string(error_of<MathError>(planar("x*px*y + py^2/2")).what()).find("no splitting") ==
          0);
    CHECK(std::string(error_of<MathError>(body("L[1]*L[2]")).what()).find("no splitting") == 0);
}

TEST_CASE("the time goes on with the first part that does not depend on it") {
    const std::string wave = planar("(px^2 + py^2)/2 + (x^2 + y^2)/2 - x*cos(a*t)");
    CHECK(flows_of(wave) == std::vector<std::string>{"a quadratic form", "a shear"});
    CHECK(all_of(wave).clock == 0);
    const std::string named = planar("(px^2 + py^2)/2 - x*cos(a*t)",
                                     "[split]\nA = \"-x*cos(a*t)\"\nB = \"(px^2 + py^2)/2\"\n");
    CHECK(all_of(named).clock == 1);
    CHECK_FALSE(all_of(planar("(px^2 + py^2)/2 - x*cos(a)")).clock);
}

TEST_CASE("terms with the time and terms without it are not one part") {
    const std::string drifting = planar("(px^2 + py^2)/2 + px*cos(t) + y^2*x^2*sin(t)");
    CHECK(flows_of(drifting) == std::vector<std::string>(3, "a shear"));
    const HamiltonianParts parts = all_of(drifting);
    CHECK(moved(parts.parts.at(parts.clock.value())) == "q1 q2");
}

TEST_CASE("where all parts depend on the time it is a part of its own") {
    const HamiltonianParts parts = all_of(planar("exp(-t)*(px^2 + py^2)/2 + exp(t)*(x^2 + y^2)/2"));
    REQUIRE(parts.parts.size() == 3);
    CHECK(parts.clock == 2);
    CHECK(parts.parts[2].flow == "the time alone");
    CHECK(parts.parts[2].moved.empty());
}

TEST_CASE("forms that change with the time have no known flow") {
    const MathError named =
        error_of<MathError>(planar("(px^2 + py^2 + cos(t)*x^2)/2",
                                   "[split]\nA = \"(px^2 + cos(t)*x^2)/2\"\nB = \"py^2/2\"\n"));
    CHECK(std::string(named.what()) ==
          "the flow of `A` is not known: no flow is known where x, px move by what depends on the "
          "time");
    const MathError found = error_of<MathError>(planar("(px^2 + py^2)/2 + t*x*px"));
    CHECK(std::string(found.what()).find("the flow of") != std::string::npos);
}
