// Scenes whose names have indices, of sizes that parameters give, and whose parts have names.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "generator/read/scene.hpp"
#include "tests/generator/read/scenes.hpp"

using namespace hvi::gen;

namespace {

/// A ring of N springs.
const std::string ring = R"toml(coordinates = "q[1..N]"
momenta = "p[1..N]"
hamiltonian = "sum(i=1..N, p[i]^2/2 + k*(q[mod(i,N)+1]-q[i])^2/2)"
[parameters]
N = 3
k = "w^2"
w = "N/6"
[invariants]
momentum = "sum(i=1..N, p[i])"
[initial]
"q[i]" = "sin(2*pi*i/N)"
"p[j]" = 0
[run]
step = "1/(10*N)"
)toml";

/// A field on a lattice, with a matrix.
const std::string lattice = R"toml(coordinates = "u[1..2,0..1]"
momenta = "v[1..2,0..1]"
hamiltonian = "sum(i=1..2, j=0..1, v[i,j]^2/2 + K[i,j+1]*u[i,j]^2)"
[parameters]
K = [[1, 2], [3, "1/2"]]
[initial]
u = [[1, 2], [3, 4]]
v = [0, 0, 0, "K[2,1]"]
)toml";

/// A planet whose distance has a name.
const std::string with_distances = R"toml(coordinates = ["x[1..2]", "y[1..2]"]
momenta = ["px[1..2]", "py[1..2]"]
hamiltonian = "sum(i=1..2, px[i]^2+py[i]^2)/2 - mu/r[1] - mu/r[2] - U"
[parameters]
mu = 1
[definitions]
s[k] = 0
[initial]
x = [1, 2]
y = [0, 0]
px = [0, 0]
py = [1, 1]
)toml";

std::string text_of_H(const std::string& scene) {
    return to_text(hamiltonian_of(read(scene)).expression);
}

}  // namespace

TEST_CASE("a parameter gives the size of a scene") {
    const WrittenOutScene scene = read(ring);
    CHECK(variables(scene) == Names{"q[1]", "q[2]", "q[3]", "p[1]", "p[2]", "p[3]"});
    CHECK(text_of_H(ring) == "p[1]^2/2+k*(q[2]-q[1])^2/2+p[2]^2/2+k*(q[3]-q[2])^2/2+p[3]^2/2+"
                             "k*(q[1]-q[3])^2/2");
    CHECK(names(scene.parameters) == Names{"k", "w"});
    CHECK(function_of(scene).sizes == WholeNumbers{{"N", 3}});
    CHECK(lines(scene.invariants) == Names{"momentum = p[1]+p[2]+p[3]"});
    CHECK(lines(scene.initial)[1] == "q[2] = sin(2*pi*2/3)");
    CHECK(lines(scene.initial)[5] == "p[3] = 0");
    CHECK(to_text(times_of(written(ring)).step->expression) == "1/(10*3)");
}

TEST_CASE("a list of parameters is as long as it likes") {
    std::string springs = edited(lattice, "[1, 2], [3, \"1/2\"]", "");
    std::string rows;
    for (int i = 0; i < 9; ++i) { rows += "[1, 2, 3, 4, 5, 6, 7, 8, \"1/9\"], "; }
    const WrittenOutScene scene = read(edited(springs, "K = []", "K = [" + rows + "]"));
    CHECK(scene.parameters.size() == 81);
    CHECK(scene.parameters[80].name == "K[9,9]");
    CHECK(to_text(scene.parameters[80].value) == "1/9");
}

TEST_CASE("a parameter may be made of others, which may stand below it") {
    const WrittenOutScene scene = read(ring);
    CHECK(to_text(scene.parameters[0].value) == "(3/6)^2");
    CHECK(to_text(scene.parameters[1].value) == "3/6");
    const Refusal circle = refused(ring, "w = \"N/6\"", "w = \"k\"");
    CHECK(circle.what == "the value of `k` depends on itself");
    CHECK(circle.status == 2);
    CHECK(refused(ring, "N/6", "M/6").says("`M` is neither"));
    CHECK(refused(ring, "N/6", "q[1]").says("cannot depend on the variable `q[1]`"));
    std::string doubled = "a0 = 2\n";
    for (int k = 1; k < 40; ++k) {
        const std::string before = "a" + std::to_string(k - 1);
        doubled += "a" + std::to_string(k) + " = \"" + before + "*" + before + "\"\n";
    }
    CHECK(refused(ring, "k = ", doubled + "k = ").says("more than 100000 words"));
}

TEST_CASE("what is short in a file stays short") {
    std::string copies = "a0 = 2\n", definitions = "U0 = \"q[1]\"\n";
    for (int k = 1; k < 60; ++k) {
        const auto line = [&](const std::string& name) {
            const std::string before = name + std::to_string(std::min(k - 1, 14));
            return name + std::to_string(k) + " = \"" + before + "*" + before + "\"\n";
        };
        copies += line("a");
        definitions += line("U");
    }
    CHECK(refused(ring, "k = ", copies + "k = ").says("more than 100000 words"));
    CHECK(refused(ring, "[invariants]", "[definitions]\n" + definitions + "[invariants]")
              .says("more than 100000 words"));
}

TEST_CASE("a size is no variable") {
    const Refusal twice = refused(ring, "\"p[1..N]\"", "\"p[1..2], N\"");
    CHECK(twice.what == "`N` is a momentum already");
    CHECK(twice.marked == "[N] = 3");
    CHECK(refused(ring, "[invariants]", "[definitions]\nN = 2\n[invariants]").what ==
          "`N` is a variable or a parameter already");
    const auto of_text = [](const std::string& q, const std::string& p) {
        return refusal([&] {
            return hamiltonian_from_text(source("q[1]"), source(q), source(p),
                                         {parse_parameter(source("N=1"))});
        });
    };
    CHECK(of_text("q[1..N], N", "p[1..2]").marked == "q[1..N], [N]");
    CHECK(of_text("q[1..2]", "p[1..N], N").what == "`N` is a variable, and stands in an index too");
}

TEST_CASE("a size that is given takes the place of that in the file") {
    Scene scene = scene_from_toml({"s.toml", ring});
    const auto set = [&](const std::string& text) {
        return assign(scene, parse_parameter(source(text, "--param")));
    };
    CHECK(set("N=1"));
    CHECK(set("w=7"));
    CHECK_FALSE(set("M=2"));
    CHECK_FALSE(set("N[1]=2"));
    const WrittenOutScene one = unrolled(scene);
    CHECK(to_text(hamiltonian_of(one).expression) == "p[1]^2/2+k*(q[1]-q[1])^2/2");
    CHECK(to_text(one.parameters[0].value) == "7^2");
    CHECK(set("N=1/2"));
    const Refusal half = refusal([&] { return unrolled(scene); });
    CHECK(half.what == "a whole number is wanted here");
    CHECK(half.name == "--param");
    CHECK(half.marked == "N=[1/2]");
    Scene matrix = scene_from_toml({"s.toml", lattice});
    CHECK(assign(matrix, parse_parameter(source("K[2,1]=9"))));
    CHECK_FALSE(assign(matrix, parse_parameter(source("K[3,1]=9"))));
    CHECK(to_text(unrolled(matrix).parameters[2].value) == "9");
}

TEST_CASE("a size that is no whole number is refused where its value stands") {
    const Refusal half = refused(ring, "N = 3", "N = \"7/2\"");
    CHECK(half.name == "s.toml:5");
    CHECK(half.marked == "[7/2]");
    CHECK(half.what == "a whole number is wanted here");
    CHECK(refused(ring, "N = 3", "N = 0").says("there is no such index"));
    CHECK(refused(ring, "N = 3", "N = 257").says("more than 256 degrees of freedom"));
    CHECK(refused(ring, "N = 3", "N = 2000").says("more than 1000 names"));
    CHECK(refused(ring, "N = 3", "M = 3").marked == "q[1..[N]]");
    CHECK(refused(ring, "N = 3", "N = [3]").marked == "q[1..[N]]");
}

TEST_CASE("names with two indices have values as a matrix, as a list, or by a rule") {
    const WrittenOutScene scene = read(lattice);
    CHECK(hamiltonian_of(scene).coordinates == Names{"u[1,0]", "u[1,1]", "u[2,0]", "u[2,1]"});
    CHECK(names(scene.parameters) == Names{"K[1,1]", "K[1,2]", "K[2,1]", "K[2,2]"});
    CHECK(lines(scene.initial) == Names{"u[1,0] = 1", "u[1,1] = 2", "u[2,0] = 3", "u[2,1] = 4",
                                        "v[1,0] = 0", "v[1,1] = 0", "v[2,0] = 0",
                                        "v[2,1] = K[2,1]"});
    const WrittenOutScene rule =
        read(edited(lattice, "u = [[1, 2], [3, 4]]", "\"u[a,b]\" = \"10*a + b\""));
    CHECK(lines(rule.initial)[3] == "u[2,1] = 10*2+1");
}

TEST_CASE("what is wrong with a matrix is said where it is") {
    const auto says = [](const std::string& other) {
        const Refusal error = refused(lattice, "[[1, 2], [3, 4]]", other);
        return error.marked.substr(4) + ": " + error.what;
    };
    CHECK(says("[[1, 2], [3]]") == "[[1, 2], [[3]]]: this row has 1 value, and the first one 2");
    CHECK(says("[[1, 2], 3]") == "[[1, 2], [3]]: a row is wanted here, as the first one is");
    CHECK(says("[[1, 2, 3, 4]]") ==
          "[[[1, 2, 3, 4]]]: the indices of `u` run over 2 times 2 values, and these over 1 times "
          "4");
    CHECK(says("[1, 2, 3]") == "[[1, 2, 3]]: `u` has 4 indices, and here are 3 values");
    CHECK(says("[[1, 2], []]") == "[[1, 2], [[]]]: this row has 0 values, and the first one 2");
    CHECK(refused(lattice, "K[i,j+1]", "K[i,j]").what == "there is no `K[1,0]`");
    CHECK(refused(lattice, "K[i,j+1]", "K[i]").what == "there is no `K[1]`");
    CHECK(refused(lattice, "u = [[", "\"u[a]\" = [[").says("a text or a number is wanted"));
    CHECK(refused(lattice, "u = [[1, 2], [3, 4]]", "\"u[a]\" = 1").what ==
          "`u` has 2 indices, and here it has 1");
    CHECK(refused(lattice, "v = [", "u = [").status == 2);
    CHECK(refused(lattice, "v = [0, 0, 0, \"K[2,1]\"]", "\"u[a,b]\" = 1").what ==
          "`u` is given values twice");
    CHECK(refused(lattice, "u[1..2,0..1]\"", "u[1..2,0..1], u[7]\"").what ==
          "`u` is named with 2 and with 1 indices");
}

TEST_CASE("parts of H have names") {
    const auto with = [](const std::string& definitions) {
        return edited(with_distances, "s[k] = 0", definitions);
    };
    const std::string r = "\"r[k]\" = \"sqrt(x[k]^2 + y[k]^2)\"\n";
    const std::string expected =
        "(px[1]^2+py[1]^2+px[2]^2+py[2]^2)/2-mu/sqrt(x[1]^2+y[1]^2)-mu/sqrt(x[2]^2+y[2]^2)-";
    CHECK(text_of_H(with(r + "U = \"x[1]*y[2]\"")) == expected + "x[1]*y[2]");
    CHECK(text_of_H(with(r + "U = \"1/r[2]\"")) == expected + "1/sqrt(x[2]^2+y[2]^2)");
    // The index of the sum in U is not that which r is called with.
    CHECK(text_of_H(with("\"r[k]\" = \"sum(i=1..2, x[i])*y[k]\"\nU = \"sum(i=1..2, r[i])\"")) ==
          "(px[1]^2+py[1]^2+px[2]^2+py[2]^2)/2-mu/((x[1]+x[2])*y[1])-mu/((x[1]+x[2])*y[2])-"
          "((x[1]+x[2])*y[1]+(x[1]+x[2])*y[2])");
    // An index hides what has its name.
    CHECK(text_of_H(with(r + "i = \"mu\"\nU = \"i*sum(i=1..2, i*x[i])\"")) ==
          expected + "mu*(x[1]+2*x[2])");
    const auto says = [&](const std::string& definitions) {
        return refused(with(definitions)).what;
    };
    CHECK(says(r) == "`U` is neither a variable nor a parameter with a value");
    CHECK(says(r + "U = \"mu + V\"").find("`V` is neither") == 0);
    CHECK(says(r + "U = \"U\"").find("`U` is neither") == 0);
    CHECK(says(r + "U = 1\nmu = 2") == "`mu` is a variable or a parameter already");
    CHECK(says(r + "U = 1\nx = 2") == "`x` is a variable or a parameter already");
    CHECK(says("r = 1\nU = 1") == "`r` is defined with 0 indices, and here it has 1");
    CHECK(says(r + "U = \"r\"") == "`r` is defined with 1 index, and here it has 0");
    CHECK(says(r + "sin = 1").find("`sin` is reserved") == 0);
    CHECK(refused(with(r + "U = \"mu +\"")).says("the text ends"));
    std::string doubled = "U0 = \"x[1]\"\n";
    for (int k = 1; k < 40; ++k) {
        const std::string before = "U" + std::to_string(k - 1);
        doubled += "U" + std::to_string(k) + " = \"" + before + "*" + before + "\"\n";
    }
    CHECK(says(r + doubled + "U = \"U39\"").find("more than 100000 words") != std::string::npos);
}

TEST_CASE("a size may be given beside a Hamiltonian of the command line") {
    const std::vector<Parameter> values{parse_parameter(source("N=3"))};
    const auto H = [&](const std::string& text) {
        return hamiltonian_from_text(source(text), source("q[1..N]"), source("p[1..N]"), values);
    };
    const Hamiltonian chain = H("sum(i=1..N, p[i]^2)/(2*N) + q[1]*q[N]");
    CHECK(to_text(chain.expression) == "(p[1]^2+p[2]^2+p[3]^2)/(2*3)+q[1]*q[3]");
    CHECK(chain.coordinates == Names{"q[1]", "q[2]", "q[3]"});
    CHECK(chain.sizes == WholeNumbers{{"N", 3}});
    CHECK(chain.origin == "--hamiltonian \"sum(i=1..N,p[i]^2)/(2*N)+q[1]*q[N]\" --coordinates "
                          "\"q[1], q[2], q[3]\" --momenta \"p[1], p[2], p[3]\"");
    CHECK(refusal([&] {
              return hamiltonian_from_text(source("q[1]"), source("q[1..N]"), source("p[1..N]"));
          }).marked == "q[1..[N]]");
    CHECK(H("q[1] + q[2] + q[3] + p[1]*w").sizes == WholeNumbers{{"N", 3}});
    CHECK(hamiltonian_from_text(source("p^2 + q^2*N"), nullptr, nullptr, values).sizes.empty());
}

TEST_CASE("what names stand for is nested as deep as a stack bears") {
    const auto chain = [](const std::string& name, std::size_t count, const std::string& links) {
        std::string text;
        for (std::size_t k = count; k > 0; --k)
            text += name + std::to_string(k) + " = \"" + links + "(" + name +
                    std::to_string(k - 1) + ")\"\n";
        return text;
    };
    const auto parameters = [&](std::size_t count) {
        return edited(ring, "k = ", chain("a", count, "-") + "a0 = 1\nk = ");
    };
    CHECK(read(parameters(60)).parameters.size() == 63);
    CHECK(refused(parameters(20000)).says("64 parameters"));
    std::string sines;
    for (int k = 0; k < 40; ++k) sines += "sin(sin(sin(";
    const auto with = [&](int count) {
        std::string definitions = "[definitions]\nd0 = \"q[1]\"\n";
        for (int k = 1; k <= count; ++k)
            definitions += "d" + std::to_string(k) + " = \"" + sines + "d" + std::to_string(k - 1) +
                           std::string(120, ')') + "\"\n";
        return edited(edited(ring, "[parameters]", definitions + "[parameters]"), "sum(",
                      "d" + std::to_string(count) + "+sum(");
    };
    CHECK(read(with(9)).mechanics.index() == 0);
    CHECK(refused(with(10)).what ==
          "with its names replaced by their values this is nested deeper than 1200");
}
