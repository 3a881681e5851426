// Faults of scenes, and their places.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

TEST_CASE("unknown symbols have their place, and help") {
    const Refusal H = refused(planet, "mu/sqrt", "z/sqrt");
    CHECK(H.name == "s.toml:4");
    CHECK(H.marked == "(px^2 + py^2)/2 - [z]/sqrt(x^2 + y^2)");
    CHECK(H.what == "`z` is neither a variable nor a parameter with a value");
    CHECK(refused(planet, "mu/sqrt", "lambda/sqrt").helps("add it to [parameters]"));
    CHECK(refused(planet, "mu/sqrt", "nu/sqrt").helps("did you mean `mu`?"));
    const auto check = [](const std::string& part, const std::string& other,
                          const std::string& name, const std::string& marked) {
        const Refusal error = refused(planet, part, other);
        CHECK(error.name == name);
        CHECK(error.marked == marked);
        CHECK(error.says("is neither a variable nor a parameter with a value"));
        CHECK(error.helps("did you mean `ecc`?"));
        CHECK(error.status == 2);
    };
    check("y*px", "eccc", "s.toml:9", "x*py - [eccc]");
    check("1 - ecc", "1 - exc", "s.toml:11", "1 - [exc]");
    check("\"1/20\"", "\"ec/20\"", "s.toml:17", "[ec]/20");
    check("200", "\"2*ec\"", "s.toml:18", "2*[ec]");
    const std::string exact = "[exact]\nx = 1\ny = 1\npx = \"2*ecx\"\npy = 0\n[run]";
    check("[run]", exact, "s.toml:18", "2*[ecx]");
}

TEST_CASE("variables and the time stand where they may only") {
    CHECK(refused(planet, "1 - ecc", "1 - y").marked == "1 - [y]");
    CHECK(refused(planet, "1 - ecc", "1 - y").what ==
          "an initial value cannot depend on the variable `y`");
    CHECK(refused(planet, "1 - ecc", "t").says("cannot depend on the time"));
    CHECK(refused(planet, "\"1/20\"", "\"x/20\"").what ==
          "the step size cannot depend on the variable `x`");
    CHECK(refused(planet, "200", "\"px\"").says("cannot depend on the variable `px`"));
    CHECK(refused(planet, "200", "\"t\"").marked == "[t]");
    CHECK(refused(planet, "y*px", "t").what == "an invariant cannot depend on the time `t`");
    CHECK(refused(planet, "y*px", "h").helps("`height`"));
    CHECK(refused(planet, "1 - ecc", "tau").says("reserved"));
    CHECK(refused(planet, "1 - ecc", "roots(ecc)").what ==
          "`roots` cannot stand in an initial value");
    CHECK(refused(planet, "mu/sqrt", "bspline(1,0)/sqrt").says("the Hamiltonian"));
    CHECK(refused(planet, "[run]", "[exact]\nx = \"y\"\ny = 0\npx = 0\npy = 0\n[run]").what ==
          "an exact solution cannot depend on the variable `y`");
    CHECK(refused(planet, "\"3/5\"", "\"2*px\"").what ==
          "the value of a parameter cannot depend on the variable `px`");
    CHECK(refused(planet, "\"3/5\"", "\"2*px\"").marked == "2*[px]");
    CHECK(read(edited(planet, "\"3/5\"", "\"e/pi\"")).parameters.size() == 2);
}

TEST_CASE("an index out of range has its place") {
    const Refusal H = refused(bodies, "x[2]", "x[4]");
    CHECK(H.name == "s.toml:3");
    CHECK(H.marked == "sum(i=1..3, p[i]^2/(2*m[i])) + x[1]*[x[4]]");
    CHECK(H.what == "there is no `x[4]`");
    CHECK(H.help == "the indices of `x` are from 1 to 3");
    CHECK(refused(bodies, "i=1..3", "i=1..4").marked ==
          "sum(i=1..4, [p[i]]^2/(2*m[i])) + x[1]*x[2]");
    CHECK(refused(bodies, ", 0.25]", "]").what == "there is no `m[3]`");
    CHECK(refused(bodies, ", 0.25]", "]").help == "the indices of `m` are 1, 2");
    CHECK(refused(bodies, "\"m[2]\"", "\"m[0]\"").marked == "[m[0]]");
    CHECK(refused(bodies, "\"m[2]\"", "\"m\"").what == "`m` wants an index");
    CHECK(refused(planet, "mu/sqrt", "mu[1]/sqrt").what == "`mu` has no index");
    CHECK(refused(planet, "mu/sqrt", "x[1]/sqrt").helps("a coordinate"));
    CHECK(refused(bodies, "x[1]*x[2]", "x[1/2]").says("a whole number is wanted"));
}

TEST_CASE("names that are taken") {
    const auto check = [](const std::string& part, const std::string& other,
                          const std::string& marked, const std::string& what) {
        const Refusal error = refused(planet, part, other);
        CHECK(error.marked == marked);
        CHECK(error.what == what);
    };
    check("mu = 1", "e = 1", "[e] = 1", "`e` is reserved: it is the number e");
    CHECK(refused(planet, "mu = 1", "e = 1").helps("`ecc`"));
    check("mu = 1", "pi = 1", "[pi] = 1", "`pi` is reserved: it is the number pi");
    check("mu = 1", "t = 1", "[t] = 1", "`t` is reserved: it is the time");
    check("mu = 1", "h = 1", "[h] = 1", "`h` is reserved: it is the step size");
    check("mu = 1", "tau = [1]", "[tau] = [1]",
          "`tau` is reserved: it is the variable of basis functions");
    check("mu = 1", "sin = 1", "[sin] = 1", "`sin` is reserved: it is a function");
    check("mu = 1", "_m = 1", "[_m] = 1", "`_m` is no name for a parameter");
    check("mu = 1", "\"m[1]\" = 1", "[\"m[1]\"] = 1", "`m[1]` is no name for a parameter");
    check("\"x\", \"y\"", "\"x\", \"e\"", "[e]", "`e` is reserved: it is the number e");
    check("px, py", "px, h", "px, [h]", "`h` is reserved: it is the step size");
    check("angular", "cos", "[cos] = \"x*py - y*px\"", "`cos` is reserved: it is a function");
    check("\"x\", \"y\"", "\"x\", \"x\"", "[x]", "`x` is named twice");
    check("px, py", "px, y", "px, [y]", "`y` is a coordinate already");
    check("mu = 1", "px = 1", "[px] = 1", "`px` is a momentum already");
    check("mu = 1", "x = [1]", "[x] = [1]", "`x` is a coordinate already");
    check("angular", "mu", "[mu] = \"x*py - y*px\"", "`mu` is a parameter already");
    check("angular", "x", "[x] = \"x*py - y*px\"", "`x` is a coordinate already");
    check("\"x\", \"y\"", "\"x[1..2]\", \"x\"", "[x]", "`x` is named with an index and without");
    CHECK(refused(planet, "mu = 1", "mu = 1\nmu = 2").says("no TOML"));
}

TEST_CASE("each variable has one value at the beginning") {
    const Refusal missing = refused(planet, "px = 0\n", "");
    CHECK(missing.name == "s.toml:10");
    CHECK(missing.marked == "[[initial]]");
    CHECK(missing.what == "an initial value is missing: that of `px`");
    const Refusal other = refused(planet, "px = 0\n", "pz = 0\n");
    CHECK(other.name == "s.toml:13");
    CHECK(other.marked == "[pz] = 0");
    CHECK(other.what == "`pz` is no variable");
    CHECK(other.helps("`px`"));
    CHECK(refused(planet, "y = 0", "mu = 0").what == "`mu` is no variable");
    CHECK(refused(planet, "y = 0", "velocity = 0").help == "the variables are x, y, px, py");
    CHECK(refused(planet, "y = 0", "y = [0]").says("a text or a number"));
    const Refusal fewer = refused(bodies, "[1, 2, \"-3\"]", "[1, 2]");
    CHECK(fewer.name == "s.toml:7");
    CHECK(fewer.marked == "x = [[1, 2]]");
    CHECK(fewer.what == "`x` has 3 indices, and here are 2 values");
    CHECK(refused(bodies, "[1, 2, \"-3\"]", "[]").says("here are 0 values"));
    CHECK(refused(bodies, "[1, 2, \"-3\"]", "[1, 2, 3, 4]").says("here are 4 values"));
    CHECK(refused(bodies, "[1, 2, \"-3\"]", "1").says("here is 1 value"));
    const Refusal one = refused(bodies, "x = [1", "\"x[1]\" = [1");
    CHECK(one.what == "the value of `x[1]` stands among those of `x`");
    CHECK(one.marked == "[\"x[1]\"] = [1, 2, \"-3\"]");
    CHECK(refused(bodies, "x = [1", "xx = [1").helps("`x`"));
    CHECK(refused(bodies, "x = [1", "momentum = [1").help == "the variables are x, p");
    const Refusal exact = refused(planet, "[run]", "[exact]\nx = 1\n[run]");
    CHECK(exact.marked == "[[exact]]");
    CHECK(exact.what == "an exact solution is missing: that of `y`");
}

TEST_CASE("coordinates and momenta are pairs") {
    const Refusal fewer = refused(planet, "px, py", "px");
    CHECK(fewer.name == "s.toml:3");
    CHECK(fewer.what == "2 coordinates and 1 momentum");
    CHECK(refused(bodies, "p[1..3]", "p[1..4]").marked == "momenta = [[\"p[1..4]\"]]");
}

TEST_CASE("what a scene cannot do without") {
    const auto check = [](const std::string& text, const std::string& line,
                          const std::string& missing) {
        const Refusal error = refused(text, line, "");
        CHECK(error.what == "the scene has no `" + missing + "`");
        CHECK(error.name == "file");
        CHECK(error.marked == "[s.toml]");
        CHECK(error.helps(missing));
        CHECK(error.status == 2);
    };
    check(planet, "coordinates = [\"x\", \"y\"]\n", "coordinates");
    check(planet, "momenta = \"px, py\"\n", "momenta");
    check(planet, "hamiltonian = \"(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)\"\n", "hamiltonian");
    check(planet,
          planet.substr(planet.find("[initial]"), planet.find("[run]") - planet.find("[initial]")),
          "initial");
    CHECK(refused("").says("no `hamiltonian`"));
}

TEST_CASE("keys that no scene has") {
    const Refusal key = refused(planet, "momenta =", "impulses = 1\nmomenta =");
    CHECK(key.marked == "[impulses] = 1");
    CHECK(key.helps("the keys are name, description,"));
    CHECK(refused(planet, "[invariants]", "[invariant]").helps("`invariants`"));
    const Refusal run = refused(planet, "until", "untill");
    CHECK(run.name == "s.toml:18");
    CHECK(run.marked == "[untill] = 200");
    CHECK(run.helps("`until`"));
    CHECK(refused(planet, "momenta", "momentum").helps("`momenta`"));
}

TEST_CASE("values of another type") {
    const auto check = [](const std::string& part, const std::string& other,
                          const std::string& marked) {
        const Refusal error = refused(planet, part, other);
        CHECK(error.marked == marked);
        CHECK(error.status == 2);
        CHECK(!error.help.empty());
    };
    CHECK(refused(planet, "\"planet\"", "[1]").marked == "name = [[1]]");
    check("\"planet\"", "\"planet\"\ndescription = 3", "description = [3]");
    check("\"planet\"", "\"planet\"\ndescription = \"a\\nb\"", "description = [\"a\\nb\"]");
    check("\"planet\"", "\"planet\"\ndescription = \"\u00e9\"", "description = [\"\u00e9\"]");
    check("[\"x\", \"y\"]", "true", "coordinates = [true]");
    check("\"px, py\"", "[1, 2]", "momenta = [[1], 2]");
    check("hamiltonian = \"", "hamiltonian = true #",
          "hamiltonian = [true] #(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)\"");
    check("mu = 1", "mu = true", "mu = [true]");
    check("mu = 1", "mu = [[true]]", "mu = [[[true]]]");
    check("\"x*py - y*px\"", "[[\"x\"]]", "angular = [[[\"x\"]]]");
    check("\"x*py - y*px\"", "[]", "angular = [[]]");
    check("y = 0", "y = 1979-05-27", "y = [1979-05-27]");
    check("\"gauss:4\"", "4", "method = [4]");
    check("step = \"1/20\"", "step = [1]", "step = [[1]]");
    CHECK(refused(planet, "mu = 1", "mu = []").what == "the list is empty");
    CHECK(refused(planet, "[\"x\", \"y\"]", "[]").what == "the list is empty");
    CHECK(refused(planet, "y = 0", "y = inf").marked == "y = [inf]");
    for (const std::string section : {"parameters", "invariants", "initial", "exact", "run"}) {
        const std::string values = section == "initial" ? "" : "initial = {q = 0, p = 0}\n";
        const Refusal error =
            refused("coordinates = \"q\"\nmomenta = \"p\"\nhamiltonian = \"q\"\n" + values +
                    section + " = 3\n");
        CHECK(error.what == "`" + section + "` is no section");
        CHECK(error.marked == section + " = [3]");
        CHECK(error.helps("write a section [" + section + "]"));
    }
}

TEST_CASE("the method of a run is a named one") {
    CHECK(refused(planet, "gauss:4", "gaus:4").helps("`gauss`"));
    CHECK(refused(planet, "gauss:4", "gaus:4").name == "s.toml:16");
    CHECK(refused(planet, "gauss:4", "gauss:0").status == 2);
    CHECK(refused(planet, "gauss:4", "chebyshev:8").status == 1);
    CHECK(refused(planet, "gauss:4", "stormer-verlet").status == 0);
}

TEST_CASE("a place in an H of several lines is in its line") {
    const std::string several = edited(planet, "\"(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)\"",
                                       "\"\"\"\n  (px^2 + py^2)/2\n  - nu/sqrt(x^2 + y^2)\"\"\"");
    try {
        static_cast<void>(read(several));
        FAIL("nu is no parameter");
    } catch (const InputError& error) {
        CHECK(message(error) == "error: `nu` is neither a variable nor a parameter with a value\n"
                                "  s.toml:6:   - nu/sqrt(x^2 + y^2)\n"
                                "                ^~\n"
                                "help: did you mean `mu`?\n");
    }
    const std::string joined = edited(several, "2\n", "2 \\\n");
    CHECK(refused(joined).name == "s.toml:4");  // TOML makes one line of them
}

TEST_CASE("what is to come is refused as such") {
    for (const char* section : {"boundary", "guess"}) {
        const std::string text = planet + "[" + section + "]\nzero = \"y\"\n";
        CAPTURE(section);
        CHECK(refused(text).status == 2);
        CHECK(refused(text).says(" is to come"));
        CHECK(refused(text).name == "s.toml:19");
    }
    for (const char* key : {"ode", "state", "control", "cost", "end_cost"})
        CHECK(refused(key + std::string(" = \"x\"\n") + planet).what ==
              "`" + std::string(key) + "` is to come");
    CHECK(refused("evens = 1\n" + planet).says("no key"));
}

TEST_CASE("a formula without quotes is told that it wants them") {
    for (const char* value : {"pi/4", "sqrt(2)", "1/2", "3 + 4", "\u03c0", "x*2", "-pi"}) {
        CAPTURE(value);
        const Refusal bare = refused(planet, "mu = 1", "mu = " + std::string(value));
        CHECK(bare.says("no TOML"));
        CHECK(bare.help == "formulas stand in quotes, as in phi = \"pi/4\"");
    }
    CHECK(refused(planet, "mu = 1", "mu = 9,81").helps("a decimal number has a point"));
    CHECK(refused(planet, "mu = 1", "mu = \"9,81\"").helps("a decimal number has a point"));
    CHECK(refused(planet, "mu = 1", "\u03bc = 1").helps("names are made of the letters a to z"));
    CHECK(refused(planet, "mu = 1", "mu = \"\u03c9/2\"").helps("write `omega`"));
    CHECK(refused(planet, "mu = 1", "mu = \"\u0394\"").helps("write `Delta`"));
    CHECK(refused(planet, "mu = 1", "mu = \"\u03c0\"").help == "write `pi`");
    CHECK(refused(planet, "mu = 1", "mu = [1, 2").help.empty());
}

TEST_CASE("long lists of names are shortened where they are help") {
    const std::string many = edited(edited(bodies, "x[1..3]", "x[1..60]"), "p[1..3]", "p[1..60]");
    const Refusal missing =
        refused(edited(edited(many, "x = [1, 2, \"-3\"]\n", ""), "p = [0, 0, \"m[2]\"]\n", ""));
    CHECK(missing.says("an initial value is missing"));
    CHECK(missing.helps("each of x[1], x[2], "));
    CHECK(missing.helps(", ..., p[60] has one"));
    CHECK(missing.help.size() <= 100);
    CHECK(refused("sections = 1\n" + planet).help.size() <= 100);
}

TEST_CASE("there are limits to what a scene has") {
    const auto names = [](int count) {
        std::string text = "mu = 1\n";
        for (int k = 0; k < count; ++k) text += "k" + std::to_string(k) + " = [1, 2]\n";
        return text;
    };
    CHECK(refused(planet, "mu = 1", names(62)).status == 0);
    CHECK(refused(planet, "mu = 1", names(63)).says("more than 64 parameters"));
    CHECK(refused(planet, "mu = 1", names(63)).marked == "[ecc] = \"3/5\"");
    CHECK(refused(bodies, "x[1..3]", "x[1..257]").says("more than 256 degrees of freedom"));
    std::string invariants;
    for (int k = 0; k < 64; ++k) invariants += "i" + std::to_string(k) + " = \"x\"\n";
    CHECK(refused(planet, "[initial]", invariants + "[initial]").says("more than 64 invariants"));
    std::string sums;
    for (int k = 0; k < 8; ++k) sums += "i" + std::to_string(k) + " = \"sum(i=1..20000, x + i)\"\n";
    CHECK(refused(planet, "[initial]", sums + "[initial]").says("more than 300000 words"));
    CHECK(refused(planet, "mu/sqrt", "sum(i=1..999999, mu)/sqrt").says("100000 words"));
}
