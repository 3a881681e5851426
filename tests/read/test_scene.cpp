// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "generator/read/scene.hpp"
#include "tests/read/refusal.hpp"

using namespace hvi::gen;

namespace {

using Names = std::vector<std::string>;

/// A scene with all sections, whose lines the tests count.
const std::string planet = R"toml(name = "planet"
coordinates = ["x", "y"]
momenta = "px, py"
hamiltonian = "(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)"
[parameters]
mu = 1
ecc = "3/5"
[invariants]
angular = "x*py - y*px"
[initial]
x = "1 - ecc"
y = 0
px = 0
py = "sqrt(mu*(1 + ecc)/(1 - ecc))"
[run]
method = "gauss:4"
step = "1/20"
until = 200
)toml";

/// A scene of three bodies.
const std::string bodies = R"toml(coordinates = "x[1..3]"
momenta = ["p[1..3]"]
hamiltonian = "sum(i=1..3, p[i]^2/(2*m[i])) + x[1]*x[2]"
[parameters]
m = [1, "1/1000", 0.25]
[initial]
x = [1, 2, "-3"]
p = [0, 0, "m[2]"]
)toml";

/// The text with another part in place of one.
std::string edited(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), other);
}

Scene read(const std::string& text) { return scene_from_toml({"s.toml", text}); }

Refusal refused(const std::string& text) {
    return refusal([&] { return read(text); });
}

Refusal refused(const std::string& text, const std::string& part, const std::string& other) {
    return refused(edited(text, part, other));
}

Names names(const std::vector<Parameter>& parameters) {
    Names result;
    for (const Parameter& parameter : parameters) result.push_back(parameter.name);
    return result;
}

/// `x = 1` for each.
Names lines(const std::vector<NamedExpression>& values) {
    Names result;
    for (const NamedExpression& value : values)
        result.push_back(value.name + " = " + to_text(value.expression));
    return result;
}

Scene embedded(const std::string& name) {
    return find_scene(name, {source(name, "SCENE"), {0, name.size()}});
}

}  // namespace

TEST_CASE("a scene is read") {
    const Scene scene = read(planet);
    CHECK(scene.name == "planet");
    CHECK(scene.description.empty());
    CHECK(scene.hamiltonian.coordinates == Names{"x", "y"});
    CHECK(scene.hamiltonian.momenta == Names{"px", "py"});
    CHECK(scene.hamiltonian.origin == "s.toml");
    CHECK(scene.hamiltonian.parameters.empty());
    CHECK(scene.hamiltonian.source->name == "s.toml:4");
    CHECK(names(scene.parameters) == Names{"mu", "ecc"});
    CHECK(to_text(scene.parameters[1].value) == "3/5");
    CHECK(lines(scene.invariants) == Names{"angular = x*py-y*px"});
    CHECK(lines(scene.initial) ==
          Names{"x = 1-ecc", "y = 0", "px = 0", "py = sqrt(mu*(1+ecc)/(1-ecc))"});
    CHECK(scene.initial[3].place.source->name == "s.toml:14");
    CHECK(scene.exact.empty());
    CHECK(scene.run.method->text == "gauss:4");
    CHECK(to_text(scene.run.step->expression) == "1/20");
    CHECK(to_text(scene.run.until->expression) == "200");
}

TEST_CASE("indexed names are all of them, and their values a list") {
    const Scene scene = read(bodies);
    CHECK(scene.name == "s");
    CHECK(variables(scene.hamiltonian) == Names{"x[1]", "x[2]", "x[3]", "p[1]", "p[2]", "p[3]"});
    CHECK(names(scene.parameters) == Names{"m[1]", "m[2]", "m[3]"});
    CHECK(to_text(scene.parameters[2].value) == "1/4");
    CHECK(lines(scene.initial) ==
          Names{"x[1] = 1", "x[2] = 2", "x[3] = -3", "p[1] = 0", "p[2] = 0", "p[3] = m[2]"});
    CHECK(scene.run.method == nullptr);
    CHECK(!scene.run.step);
    const Scene other = read(edited(bodies, "\"x[1..3]\"", "[\"x[2..3]\", \"x[1]\"]"));
    CHECK(other.hamiltonian.coordinates == Names{"x[2]", "x[3]", "x[1]"});
    CHECK(lines(other.initial)[0] == "x[2] = 2");
    CHECK(lines(other.initial)[2] == "x[1] = 1");
}

TEST_CASE("what is in a scene stands as in the file, and means what is written") {
    const std::string text = edited(planet, "mu = 1\n", "mu = 1\nzeta = 0.1\nb = 1e-3\na = -2\n");
    const Scene scene = read(edited(text, "[initial]", "z = \"px\"\nf = \"x\"\n[initial]"));
    CHECK(names(scene.parameters) == Names{"mu", "zeta", "b", "a", "ecc"});
    CHECK(to_text(scene.parameters[1].value) == "1/10");
    CHECK(to_text(scene.parameters[2].value) == "1/1000");
    CHECK(to_text(scene.parameters[3].value) == "-2");
    CHECK(lines(scene.invariants) == Names{"angular = x*py-y*px", "z = px", "f = x"});
}

TEST_CASE("the time may stand in H and in the exact solution") {
    const Scene scene = read("coordinates = \"q\"\nmomenta = \"p\"\n"
                             "hamiltonian = \"p^2/2 + q*cos(t)\"\n"
                             "description = \"driven\"\n"
                             "[initial]\nq = 1\np = 0\n[exact]\nq = \"cos(t)\"\np = \"-sin(t)\"\n");
    CHECK(depends_on_time(scene.hamiltonian));
    CHECK(lines(scene.exact) == Names{"q = cos(t)", "p = -sin(t)"});
    CHECK(scene.description == "driven");
    CHECK(!depends_on_time(read(planet).hamiltonian));
}

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
    CHECK(refused(planet, "mu/sqrt", "bspline(1,0)/sqrt").says("a Hamiltonian"));
    CHECK(refused(planet, "[run]", "[exact]\nx = \"y\"\ny = 0\npx = 0\npy = 0\n[run]").what ==
          "an exact solution cannot depend on the variable `y`");
    CHECK(refused(planet, "\"3/5\"", "\"2*mu\"").what ==
          "the value of a parameter is a number, and `mu` is none");
    CHECK(refused(planet, "\"3/5\"", "\"2*mu\"").marked == "2*[mu]");
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
    check("mu = 1", "mu = [[1]]", "mu = [[[1]]]");
    check("\"x*py - y*px\"", "[\"x\"]", "angular = [[\"x\"]]");
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

TEST_CASE("there are limits to what a scene has") {
    const auto list = [](int count) {
        std::string text = "1";
        for (int k = 1; k < count; ++k) text += ", 1";
        return "[" + text + "]";
    };
    CHECK(refused(planet, "mu = 1", "mu = 1\nm = " + list(62)).status == 0);
    CHECK(refused(planet, "mu = 1", "mu = 1\nm = " + list(63)).says("more than 64 parameters"));
    CHECK(refused(bodies, "x[1..3]", "x[1..65]").says("more than 64 degrees of freedom"));
    std::string invariants;
    for (int k = 0; k < 64; ++k) invariants += "i" + std::to_string(k) + " = \"x\"\n";
    CHECK(refused(planet, "[initial]", invariants + "[initial]").says("more than 64 invariants"));
    std::string sums;
    for (int k = 0; k < 8; ++k) sums += "i" + std::to_string(k) + " = \"sum(i=1..20000, x + i)\"\n";
    CHECK(refused(planet, "[initial]", sums + "[initial]").says("more than 300000 words"));
    CHECK(refused(planet, "mu/sqrt", "sum(i=1..999999, mu)/sqrt").says("100000 words"));
}

TEST_CASE("a parameter of a scene has its value wherever it occurs") {
    const auto set = [](Method& method, Scene& scene, const std::string& text) {
        set_parameter(method, scene, parse_parameter(source(text, "--param")));
    };
    Method method = method_from_text(source("1, cos(mu*w*tau)"), source("0, 1"));
    Scene scene = read(planet);
    set(method, scene, "ecc=1/2");
    CHECK(to_text(scene.parameters[1].value) == "1/2");
    CHECK(scene.hamiltonian.parameters.empty());
    CHECK(method.parameters.empty());
    set(method, scene, "mu=2");
    CHECK(to_text(scene.parameters[0].value) == "2");
    REQUIRE(scene.hamiltonian.parameters.size() == 1);
    REQUIRE(method.parameters.size() == 1);
    set(method, scene, "w=3");
    CHECK(method.parameters.size() == 2);
    const Refusal unknown = refusal([&] {
        set(method, scene, "ec=1");
        return 0;
    });
    CHECK(unknown.marked == "[ec]=1");
    CHECK(unknown.helps("`ecc`"));
    CHECK(refusal([&] {
              set(method, scene, "px=1");
              return 0;
          }).says("is a variable"));
    Scene many = read(bodies);
    set(method, many, "m[2]=7");
    CHECK(to_text(many.parameters[1].value) == "7");
    CHECK(to_text(many.hamiltonian.parameters[0].value) == "7");
    for (const std::string text :
         {"m[2=7", "m[]=1", "m[01]=1", "m[1]x=1", "[1]=1", "m[x]=1", "m[1][2]=3"})
        CHECK(refusal([&] { return parse_parameter(source(text)); }).says("is no name for"));
    CHECK(refusal([&] { return parse_parameter(source("pi[1]=1")); }).says("reserved"));
}

TEST_CASE("the scenes that come with the program are read") {
    struct Facts {
        std::string name;
        std::size_t degrees_of_freedom;
        Names parameters;
        std::size_t invariants;
        bool has_exact;
        std::string method, step, until, some_value;
    };
    const std::vector<Facts> all = {
        {"double-pendulum",
         2,
         {"m1", "m2", "l1", "l2", "g"},
         0,
         false,
         "gauss:4",
         "1/100",
         "100",
         "theta2 = pi/4"},
        {"fpu", 6, {"omega"}, 0, false, "gauss:3", "1/50", "200", "d[1] = 1/omega"},
        {"harmonic-oscillator", 1, {"omega"}, 0, true, "gauss:2", "1/10", "100", "q = 1"},
        {"henon-heiles", 2, {}, 0, false, "gauss:4", "1/4", "1000", "px = sqrt(301/1500)"},
        {"kepler", 2, {"mu", "ecc"}, 1, false, "gauss:4", "1/20", "200", "x = 1-ecc"},
        {"nonseparable", 1, {}, 0, false, "gauss:3", "1/50", "1000", "q = -3"},
        {"outer-solar-system",
         18,
         {"G", "m[1]", "m[2]", "m[3]", "m[4]", "m[5]", "m[6]"},
         6,
         false,
         "gauss:8",
         "300",
         "500000",
         "py[6] = -85351*m[6]/50000000"},
        {"pendulum", 1, {}, 0, false, "gauss:3", "1/10", "1000", "q = 3/2"},
        {"point-vortices",
         4,
         {"g[1]", "g[2]", "g[3]", "g[4]"},
         3,
         false,
         "gauss:3",
         "1/20",
         "100",
         "p[3] = -g[3]"},
        {"qp", 1, {}, 0, true, "chebyshev:3", "1/10", "3", "p = 1"}};
    const std::vector<SceneEntry> entries = scenes();
    REQUIRE(entries.size() == all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Facts& facts = all[k];
        CAPTURE(facts.name);
        const Scene scene = embedded(facts.name);
        CHECK(entries[k].name == facts.name);
        CHECK(entries[k].description == scene.description);
        CHECK(scene.description.size() > 20);
        CHECK(scene.name == facts.name);
        CHECK(scene.hamiltonian.origin == facts.name);
        CHECK(scene.hamiltonian.degrees_of_freedom() == facts.degrees_of_freedom);
        CHECK(names(scene.parameters) == facts.parameters);
        CHECK(scene.invariants.size() == facts.invariants);
        CHECK(scene.initial.size() == 2 * facts.degrees_of_freedom);
        CHECK(scene.exact.size() == (facts.has_exact ? 2 * facts.degrees_of_freedom : 0));
        CHECK(scene.run.method->text == facts.method);
        CHECK(to_text(scene.run.step->expression) == facts.step);
        CHECK(to_text(scene.run.until->expression) == facts.until);
        const Names values = lines(scene.initial);
        CHECK(std::find(values.begin(), values.end(), facts.some_value) != values.end());
    }
}

TEST_CASE("a scene is found by name, or by file") {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() /
        ("hvi-scene-" +
         std::to_string(std::filesystem::file_time_type::clock::now().time_since_epoch().count()) +
         ".toml");
    std::ofstream(file) << planet;
    CHECK(embedded(file.string()).name == "planet");
    CHECK(embedded(file.string()).hamiltonian.origin == file.filename().string());
    std::filesystem::remove(file);
    const Refusal gone = refusal([&] { return embedded(file.string()); });
    CHECK(gone.status == 2);
    CHECK(gone.name == "SCENE");
    CHECK(gone.helps("`hvi-gen list scenes`"));
    const Refusal mistyped = refusal([] { return embedded("keplr"); });
    CHECK(mistyped.what == "there is no scene and no file `keplr`");
    CHECK(mistyped.marked == "[keplr]");
    CHECK(mistyped.helps("`kepler`"));
    CHECK(refusal([] { return embedded("."); }).says("a directory"));
    CHECK(refusal([] { return embedded(""); }).status == 2);
    CHECK(refusal([] { return embedded(std::string(5000, 'x')); }).status == 2);
}
