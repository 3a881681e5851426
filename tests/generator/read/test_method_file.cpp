// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "generator/read/file.hpp"
#include "generator/read/method.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/read/scratch.hpp"

using namespace hvi::gen;

namespace {

Method read_method(const std::string& text) { return method_from_toml({"m.toml", text}); }

Refusal refused_method_file(const std::string& text) {
    return refusal([&] { return read_method(text); });
}

std::string texts(const List& list) {
    std::string result;
    for (const Item& item : list.items) {
        const auto* family = std::get_if<Family>(&item.what);
        result += (result.empty() ? "" : " ") +
                  (family != nullptr ? family->name : to_text(std::get<Expression>(item.what)));
    }
    return result;
}

}  // namespace

TEST_CASE("a method file with lists as texts") {
    const Method method = read_method("name = \"my method\"\n"
                                      "basis = \"1, cos(w*tau)\"\n"
                                      "nodes = \"gauss:2\"\n"
                                      "weights = \"1/2, 1/2\"\n"
                                      "[parameters]\nw = \"2*pi\"\n");
    CHECK(method.name == "my method");
    CHECK(method.origin == "--method-file m.toml");
    CHECK(texts(method.basis) == "1 cos(w*tau)");
    CHECK(texts(method.nodes) == "gauss");
    CHECK(texts(*method.weights) == "1/2 1/2");
    REQUIRE(method.parameters.size() == 1);
    CHECK(to_text(method.parameters[0].value) == "2*pi");
}

TEST_CASE("numbers in a file mean exactly what is written") {
    const Method method = read_method("basis = [1, \"exp(w*tau)\", \"exp(v*tau)\"]\n"
                                      "nodes = [0, 0.1, 1_0.50e-1 , \"roots(tau-1)\"]\n"
                                      "parameters = { w = 0.3, v = -1.25 }\n");
    CHECK(texts(method.nodes) == "0 1/10 21/20 roots(tau-1)");
    CHECK(to_text(method.parameters[0].value) == "-5/4");
    CHECK(to_text(method.parameters[1].value) == "3/10");
    CHECK(texts(read_method("basis = 1\nnodes = 0.1\n").nodes) == "1/10");
    CHECK(texts(read_method("basis = 1\n\"nodes\" = [ # \u00e4\n 0.2 ]\n").nodes) == "1/5");
}

TEST_CASE("errors name the line of the file and point into it") {
    const Refusal open = refused_method_file("basis = [\"1\",\n  \"cos(tau\"]\nnodes = \"0, 1\"\n");
    CHECK(open.name == "m.toml:2");
    CHECK(open.marked == "cos[(]tau");
    const Refusal word = refused_method_file("basis = \"1\"\nnodes = \"tau\"\n");
    CHECK(word.name == "m.toml:2");
    CHECK(word.marked == "[tau]");
    const Refusal key = refused_method_file("basis = \"1\"\nnodes = \"0\"\n  bases = 1\n");
    CHECK(key.name == "m.toml:3");
    CHECK(key.marked == "  [bases] = 1");
    CHECK(key.helps("`basis`"));
    const Refusal syntax = refused_method_file("basis = \"1\"\nnodes = [0, 1\n");
    CHECK(syntax.status == 2);
    CHECK(syntax.says("no TOML"));
    CHECK(syntax.name.rfind("m.toml:", 0) == 0);
}

TEST_CASE("an item cannot span two elements of an array") {
    CHECK(refused_method_file("basis = [\"bspline(2\", \"1)\"]\nnodes = \"0\"\n").marked ==
          "bspline[(]2");
    CHECK(refused_method_file("basis = [\"1\", \"\"]\nnodes = \"0\"\n").says("empty"));
}

TEST_CASE("keys and types that are wrong") {
    CHECK(refused_method_file("basis = \"1\"\n").says("no `nodes`"));
    CHECK(refused_method_file("").says("no `basis`"));
    CHECK(refused_method_file("basis = true\nnodes = \"0\"\n").marked == "basis = [true]");
    CHECK(refused_method_file("basis = []\nnodes = \"0\"\n").says("empty"));
    CHECK(refused_method_file("basis = [[1]]\nnodes = \"0\"\n").status == 2);
    CHECK(refused_method_file("basis = 1\nnodes = [0, inf]\n").marked == "nodes = [0, [inf]]");
    CHECK(refused_method_file("basis = 1\nnodes = [0, nan]\n").status == 2);
    CHECK(refused_method_file("basis = 1\nnodes = 1979-05-27\n").status == 2);
    CHECK(refused_method_file("basis = 1\nbasis = 2\nnodes = 0\n").says("no TOML"));
    CHECK(refused_method_file("name = 3\nbasis = 1\nnodes = 0\n").marked == "name = [3]");
    CHECK(refused_method_file("parameters = 3\nbasis = 1\nnodes = 0\n").helps("[parameters]"));
}

TEST_CASE("a name stays plain, as it goes into comments and class names") {
    const auto named = [](const std::string& name) {
        return refused_method_file("name = " + name + "\nbasis = 1\nnodes = 0\n").status;
    };
    CHECK(named("\"gauss-2 (mine)\"") == 2);
    CHECK(named("\"Verlet 2.0_b:3+4\"") == 0);
    CHECK(named("\"a\\nb\"") == 2);
    CHECK(named("\"*/\"") == 2);
    CHECK(named("\"\"") == 2);
    CHECK(named("\" a\"") == 2);
    CHECK(named("\"" + std::string(65, 'a') + "\"") == 2);
}

TEST_CASE("parameters in a file") {
    const std::string head = "basis = \"1, cos(w*tau)\"\nnodes = \"0, 1\"\n[parameters]\n";
    CHECK(refused_method_file(head + "e = 1\n").marked == "[e] = 1");
    CHECK(refused_method_file(head + "e = 1\n").helps("`ecc`"));
    CHECK(refused_method_file(head + "\"a b\" = 1\n").status == 2);
    CHECK(refused_method_file(head + "v = 1\n").helps("`w`"));
    CHECK(refused_method_file(head + "w = \"2tau\"\n").name == "m.toml:4");
    CHECK(refused_method_file(head + "w = \"v\"\n").marked == "[v]");
    CHECK(refused_method_file(head + "w = [1]\n").status == 2);
}

TEST_CASE("the name of a file is harmless in a comment") {
    const auto origin = [](const std::string& path) {
        return method_from_toml({path, "basis = 1\nnodes = 0\n"}).origin;
    };
    CHECK(origin("some/where/m.toml") == "--method-file m.toml");
    CHECK(origin("my method.toml") == "--method-file \"my method.toml\"");
    CHECK(origin("a\n#include \\") == "--method-file \"a??include ?\"");
    CHECK(origin("$(x)`y`.toml") == "--method-file \"??x??y?.toml\"");
}

TEST_CASE("files") {
    const Scratch scratch;
    const auto file = scratch.path / "m \u00e4.toml";
    std::ofstream(file) << "basis = 1\nnodes = 0\n";
    CHECK(texts(method_from_file(file).nodes) == "0");
    const auto refused_file = [](const std::filesystem::path& path) {
        return refusal([&] { return method_from_file(path); });
    };
    const Refusal missing = refused_file(scratch.path / "none.toml");
    CHECK(missing.status == 2);
    CHECK(missing.says("cannot open"));
    CHECK(missing.marked == "[" + (scratch.path / "none.toml").string() + "]");
    CHECK(refused_file(scratch.path).says("directory"));
    std::ofstream(scratch.path / "large.toml") << std::string(1024 * 1024 + 1, '#');
    CHECK(refused_file(scratch.path / "large.toml").says("1024 KiB"));
    std::ofstream(scratch.path / "just.toml")
        << "basis = 1\nnodes = 0\n#" << std::string(1024 * 1024 - 21, ' ');
    CHECK(refused_file(scratch.path / "just.toml").status == 0);
}
