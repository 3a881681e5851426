// Functions of a scene's own: how they are declared, where they are called, and their headers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "generator/read/scene.hpp"
#include "tests/generator/read/scenes.hpp"
#include "tests/generator/read/scratch.hpp"

using namespace hvi::gen;

namespace {

/// A scene with headers beside it.
class Files {
public:
    Files() { write("potential.hpp", "template <class X> X V(X);\n"); }

    void write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = scratch_.path / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }

    [[nodiscard]] WrittenOutScene scene(const std::string& text) const {
        write("s.toml", text);
        return unrolled(scene_from_file(scratch_.path / "s.toml"));
    }

    [[nodiscard]] Scene indexed(const std::string& text) const {
        write("s.toml", text);
        return scene_from_file(scratch_.path / "s.toml");
    }

    [[nodiscard]] Refusal refused(const std::string& text) const {
        return refusal([&] {
            static_cast<void>(times_of(indexed(text)));
            return scene(text);
        });
    }

private:
    Scratch scratch_;
};

const std::string well = R"toml(coordinates = ["x", "y"]
momenta = ["px", "py"]
hamiltonian = "(px^2 + py^2)/2 + V(r)"
[parameters]
k = 2
[functions]
V = {header = "potential.hpp", arguments = 1}
[definitions]
r = "sqrt(x^2 + y^2)"
[invariants]
depth = "V(x)"
[initial]
x = "1/2"
y = 0
px = 0
py = "k"
[run]
step = "1/10"
until = 3
)toml";

Names paths(const WrittenOutScene& scene) {
    Names result;
    for (const OwnHeader& header : scene.own.headers) result.push_back(header.path);
    return result;
}

}  // namespace

TEST_CASE("a function of a scene's own is called in H and in invariants") {
    const Files files;
    const WrittenOutScene scene = files.scene(well);
    CHECK(to_text(function_of(scene).expression) == "(px^2+py^2)/2+V(sqrt(x^2+y^2))");
    CHECK(to_text(scene.invariants.front().expression) == "V(x)");
    REQUIRE(scene.own.functions.size() == 1);
    CHECK(scene.own.functions.front().name == "V");
    CHECK(scene.own.functions.front().arguments == 1);
    CHECK(scene.own.includes() == Names{"potential.hpp"});
    REQUIRE(scene.own.headers.size() == 1);
    CHECK(scene.own.headers.front().text == "template <class X> X V(X);\n");
    CHECK(files
              .scene(edited(edited(well, "V(r)", "V(r,k,x,y)"),
                            "arguments = 1}\n[definitions]\nr = \"sqrt(x^2 + y^2)\"\n"
                            "[invariants]\ndepth = \"V(x)\"",
                            "arguments = 4}\n[definitions]\nr = \"x\""))
              .own.functions.front()
              .arguments == 4);
}

TEST_CASE("a call has as many arguments as its function") {
    const Files files;
    const Refusal error = files.refused(edited(well, "V(r)", "2*V(x, y)"));
    CHECK(error.status == 2);
    CHECK(error.what == "`V` takes 1 argument, not 2");
    CHECK(error.marked == "(px^2 + py^2)/2 + 2*[V(x, y)]");
    CHECK(files.refused(edited(well, "V(r)", "V")).what ==
          "`V` is a function and wants an argument");
    CHECK(files.refused(edited(well, "V(r)", "V()")).what == "`V` wants an argument");
    CHECK(files.refused(edited(well, "V(r)", "W(r)")).what == "there is no function `W`");
    CHECK(refused(planet, "mu/sqrt", "foobar(mu)/sqrt").helps("a scene has others in [functions]"));
    CHECK(files.refused(edited(well, "V(r)", "V_1(r)")).what == "there is no function `V_1`");
    CHECK(files.refused(edited(well, "V(r)", "V[1]")).says("`V[1]`"));
    CHECK(refused(planet, "mu/sqrt", "V(mu)/sqrt").what == "there is no function `V`");
}

TEST_CASE("a function of a scene's own has no exact value") {
    const Files files;
    const auto check = [&](const std::string& part, const std::string& other,
                           const std::string& subject, const std::string& marked) {
        const Refusal error = files.refused(edited(well, part, other));
        CHECK(error.status == 2);
        CHECK(error.what == "`V` cannot stand in " + subject);
        CHECK(error.marked == marked);
        CHECK(error.helps("in the Hamiltonian and in invariants"));
    };
    check("k = 2", "k = \"1 + V(2)\"", "the value of a parameter", "1 + [V(2)]");
    check("\"1/2\"", "\"V(k)/2\"", "an initial value", "[V(k)]/2");
    check("\"1/10\"", "\"V(1)\"", "the step size", "[V(1)]");
    check("until = 3", "until = \"V(3)\"", "the time at the end", "[V(3)]");
    check("[run]", "[exact]\nx = \"V(t)\"\ny = 0\npx = 0\npy = 0\n[run]", "an exact solution",
          "[V(t)]");
}

TEST_CASE("by a definition neither") {
    const Files files;
    const std::string scene = edited(well, "sqrt(x^2 + y^2)", "V(2)");
    const Refusal error = files.refused(edited(scene, "\"1/2\"", "\"1 + r\""));
    CHECK(error.what == "`V` cannot stand in an initial value");
    CHECK(error.marked == "1 + [r]");
}

TEST_CASE("a Lagrangian has no functions of its own") {
    const Files files;
    const Refusal error =
        files.refused(edited(edited(well, "hamiltonian", "lagrangian"), "momenta", "velocities"));
    CHECK(error.status == 2);
    CHECK(error.what == "`functions` stands beside `lagrangian`");
    CHECK(error.marked == "[[functions]]");
}

TEST_CASE("what a function cannot be called") {
    const Files files;
    const auto check = [&](const std::string& name, const std::string& what) {
        const Refusal error = files.refused(edited(well, "V = {", name + " = {"));
        CHECK(error.status == 2);
        CHECK(error.what == what);
        CHECK(error.marked == "[" + name + "] = {header = \"potential.hpp\", arguments = 1}");
    };
    check("sin", "`sin` is reserved: it is a function");
    check("if", "`if` is reserved: it is a function");
    check("bspline", "`bspline` is reserved: it is a function");
    check("t", "`t` is reserved: it is the time");
    check("sum", "`sum` has a meaning of its own");
    check("mod", "`mod` has a meaning of its own");
    check("std", "`std` has a meaning of its own");
    check("V_1", "`V_1` looks like a derivative of `V`");
    check("V_12", "`V_12` looks like a derivative of `V`");
    check("\"V W\"", "`V W` is no name for a function");
    check("\"\"", "`` is no name for a function");
    check("\"V(x)\"", "`V(x)` is no name for a function");
    check("\"V[1]\"", "`V[1]` is no name for a function");
    check("_V", "`_V` is no name for a function");
    check("2", "`2` is no name for a function");
    check("\"V;}\"", "`V;}` is no name for a function");
}

TEST_CASE("nothing else is called as a function or a derivative of one") {
    const Files files;
    const auto check = [&](const std::string& part, const std::string& other,
                           const std::string& what) {
        const Refusal error = files.refused(edited(well, part, other));
        CHECK(error.status == 2);
        CHECK(error.what == what);
        CHECK(error.helps("take another name for one of them"));
    };
    const std::string is_function = "`V` is a function of [functions] already";
    check("k = 2", "V = 2\nk = 1", is_function);
    check("k = 2", "V_1 = 2\nk = 1", "`V_1` is a derivative of the function `V`");
    check("k = 2", "V_11 = [2]\nk = 1", "`V_11` is a derivative of the function `V`");
    check("\nr = ", "\nV_2 = \"x\"\nr = ", "`V_2` is a derivative of the function `V`");
    check("depth =", "V_1 =", "`V_1` is a derivative of the function `V`");
    check("[\"x\", \"y\"]", "[\"x\", \"V\"]", is_function);
    check("[\"px\", \"py\"]", "[\"px\", \"V_1[2..2]\"]",
          "`V_1` is a derivative of the function `V`");
    CHECK(files.refused(edited(well, "V(r)", "sum(V=1..2, x^V)")).what ==
          "`V` is a function of [functions]");
    CHECK(
        files.scene(edited(well, "k = 2", "k = 2\nV_ = 1\nV_1x = 2\nW_1 = 3")).parameters.size() ==
        4);
}

TEST_CASE("what a declaration wants") {
    const Files files;
    const auto check = [&](const std::string& value, const std::string& what) {
        const Refusal error =
            files.refused(edited(well, "{header = \"potential.hpp\", arguments = 1}", value));
        CHECK(error.status == 2);
        CHECK(error.what == what);
        CHECK(!error.marked.empty());
        CHECK(!error.help.empty());
    };
    check("1", "a header and a number of arguments are wanted here");
    check("\"potential.hpp\"", "a header and a number of arguments are wanted here");
    check("{}", "the path of a header is wanted here");
    check("{header = 1, arguments = 1}", "the path of a header is wanted here");
    const std::string count = "`arguments` is a whole number from 1 to 4";
    for (const char* const wrong :
         {"", ", arguments = 0", ", arguments = 5", ", arguments = -1", ", arguments = 1.5",
          ", arguments = \"1\"", ", arguments = [1]"})
        check("{header = \"potential.hpp\"" + std::string(wrong) + "}", count);
    check("{header = \"potential.hpp\", arguments = 1, order = 2}",
          "a function has no key `order`");
    CHECK(files
              .refused(edited(well, "[functions]\nV =",
                              "[functions.V]\nheader = \"potential.hpp\"\n"
                              "arguments = 1\n[initial.z]\nx ="))
              .status == 2);
    CHECK(files.refused("functions = 1\n" + edited(well, "[functions]\nV", "[exact]\nV")).what ==
          "`functions` is no section");
}

TEST_CASE("a header stands beside the scene, or below") {
    const Files files;
    files.write("below/deep.hpp", "// deep\n");
    const auto with_header = [](const std::string& path) {
        return edited(well, "\"potential.hpp\"", path);
    };
    CHECK(paths(files.scene(with_header("\"below/deep.hpp\""))) == Names{"below/deep.hpp"});
    const Refusal missing = files.refused(with_header("\"missing.hpp\""));
    CHECK(missing.status == 2);
    CHECK(missing.what == "missing.hpp: cannot open the file: No such file or directory");
    CHECK(missing.marked == "V = {header = [\"missing.hpp\"], arguments = 1}");
    CHECK(files.refused(with_header("\"below\"")).says("a directory where a file is wanted"));
    for (const char* const hostile :
         {"\"\"", "\"/etc/passwd\"", "\"../s.toml\"", "\"below/../potential.hpp\"",
          "\"./potential.hpp\"", "\"below//deep.hpp\"", "\"below/\"", "\"a b.hpp\"",
          "\"a\\\".hpp\"", "'a\\b.hpp'", "\"a\\nb.hpp\"", "\"a\\u0000b.hpp\"", "\"a>.hpp\"",
          "\"~stepper.hpp\"", "\"\\u00e4.hpp\"", "\"$HOME\"", "\"a\\\\\""}) {
        const Refusal error = files.refused(with_header(hostile));
        INFO(hostile);
        CHECK(error.status == 2);
        CHECK(error.what == "this is no path of a header");
        CHECK(error.marked.find("[") != std::string::npos);
    }
}

TEST_CASE("what a header includes by name comes with it") {
    const Files files;
    files.write("below/potential.hpp", "#pragma once\n#include \"table.hpp\"\n"
                                       "  #  include   \"../other.hpp\" // rest\n#include <cmath>\n"
                                       "#include \"missing.hpp\"\n#include \"/etc/passwd\"\n"
                                       "#include \"../../s.toml\"\n#include \"unfinished.hpp\n"
                                       "#include \"\n#include\n// #include \"potential.hpp\"\n");
    files.write("below/table.hpp", "#include \"potential.hpp\"\r\n#include \"../other.hpp\"");
    files.write("other.hpp", "");
    CHECK(paths(files.scene(edited(well, "\"potential", "\"below/potential"))) ==
          Names{"below/potential.hpp", "below/table.hpp", "other.hpp"});
}

TEST_CASE("there are not too many headers, nor too large ones") {
    const Files files;
    for (int k = 0; k < 70; ++k)
        files.write("h" + std::to_string(k) + ".hpp",
                    "#include \"h" + std::to_string(k + 1) + ".hpp\"\n");
    CHECK(files.refused(edited(well, "potential", "h0")).says("more than 64 headers"));
    CHECK(paths(files.scene(edited(well, "potential", "h10"))).size() == 60);
    files.write("large.hpp", std::string(1024 * 1024 + 1, ' '));
    CHECK(files.refused(edited(well, "potential", "large")).what ==
          "large.hpp: the file has more than 1024 KiB");
}

TEST_CASE("a scene of any size has functions of its own") {
    const Files files;
    const std::string chain = R"toml(coordinates = "q[1..N]"
momenta = "p[1..N]"
hamiltonian = "sum(i=1..N, p[i]^2/2 + W(q[i], s)) + sum(i=1..N-1, V(q[i+1] - q[i]))"
[functions]
V = {header = "potential.hpp", arguments = 1}
W = {header = "potential.hpp", arguments = 2}
[parameters]
N = 5
s = 1
[initial]
"q[i]" = "i"
"p[i]" = 0
)toml";
    const Scene scene = files.indexed(chain);
    CHECK(to_text(scene.function.written).find("W(q[i],s)") != std::string::npos);
    CHECK(scene.own.includes() == Names{"potential.hpp"});
    CHECK(scene.own.headers.size() == 1);
    CHECK(files.refused(edited(chain, "\"i\"", "\"V(i)\"")).what ==
          "`V` cannot stand in an initial value");
}
