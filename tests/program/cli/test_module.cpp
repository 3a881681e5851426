// Files and refusals of `hvi-gen module`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/program/cli/refusals.hpp"
#include "tests/program/cli/results.hpp"

using namespace hvi::test;

namespace {

bool text_has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a module is two files, whose names are printed") {
    const Directory directory;
    const Outcome outcome = hvi_gen({"module", "kepler", "-o", "new/ones"}, directory.path());
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "new/ones/kepler.h\nnew/ones/kepler.cpp\n");
    CHECK(names_in(directory / "new/ones") == std::vector<std::string>{"kepler.cpp", "kepler.h"});
    const std::string header = contents(directory / "new/ones/kepler.h");
    CHECK(
        text_has(header, "\nint kepler_step(kepler_stepper* handle, double* state, double h);\n"));
    CHECK(text_has(header, "\n//     mu = 1\n//     ecc = 3/5\n"));

    // A second call writes the same bytes over these files.
    const std::string source = contents(directory / "new/ones/kepler.cpp");
    CHECK(hvi_gen({"module", "kepler", "-o", "new/ones"}, directory.path()).status == 0);
    CHECK(contents(directory / "new/ones/kepler.cpp") == source);
    CHECK(contents(directory / "new/ones/kepler.h") == header);
}

TEST_CASE("no option of module swallows the scene behind it") {
    const std::vector<std::vector<std::string>> lines = {
        {"--param", "mu=2"},
        {"--method", "gauss:3"},
        {"--solver", "newton"},
        {"--lanes", "none"},
        {"--compose", "yoshida:4", "--method", "stormer-verlet"},
        {"--unroll", "yes"},
        {"--language", "c"},
        {"--name", "planet"},
        {"--output", "."}};
    for (const auto& options : lines) {
        const Directory directory;
        const Outcome outcome =
            hvi_gen(with(with({"module"}, options), {"kepler"}), directory.path());
        INFO(options.front() << outcome.err);
        CHECK(outcome.status == 0);
        const std::string name = options.front() == "--name" ? "planet" : "kepler";
        CHECK(directory.names() == std::vector<std::string>{name + ".cpp", name + ".h"});
        const std::string header = contents(directory / (name + ".h"));
        CHECK(text_has(header, "int " + name + "_abi_version(void);"));
        CHECK(text_has(header, "mu = 2") == (options.front() == "--param"));
    }
}

TEST_CASE("a module says which command writes it again") {
    const Directory directory;
    CHECK(hvi_gen({"module", "--method", "gauss:2", "--param", "mu=2", "--name", "planet",
                   "--lanes", "none", "kepler"},
                  directory.path())
              .status == 0);
    const std::string command = "//     hvi-gen module --method gauss:2 kepler --param \"mu=2\" "
                                "--lanes none --name planet\n";
    CHECK(text_has(contents(directory / "planet.h"), command));
    CHECK(text_has(contents(directory / "planet.cpp"), command));
}

TEST_CASE("a scene without a name that C takes gives its module another") {
    const Directory directory;
    const std::string rest = "\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\nhamiltonian = "
                             "\"p^2/2 + q^2/2\"\n[initial]\nq = 1\np = 0\n";
    write(directory / "time.toml", "name = \"time\"" + rest);
    CHECK(hvi_gen({"module", "--method", "midpoint", "time.toml"}, directory.path()).out ==
          "./scene_time.h\n./scene_time.cpp\n");
    CHECK(hvi_gen({"module", "fpu-chain"}, directory.path()).out ==
          "./fpu_chain.h\n./fpu_chain.cpp\n");
}

TEST_CASE("modules that cannot be are refused") {
    const std::vector<Refusal> refusals = {
        {2, "cobol", {"module", "--language", "cobol", "kepler"}},
        {2, "1st", {"module", "--name", "1st", "kepler"}},
        {2, "a-b", {"module", "--name", "a-b", "kepler"}},
        {2, "a__b", {"module", "--name", "a__b", "kepler"}},
        {2, "_a", {"module", "--name", "_a", "kepler"}},
        {2, "a_", {"module", "--name", "a_", "kepler"}},
        {2, "math", {"module", "--name", "math", "kepler"}},
        {2, "pthread", {"module", "--name", "pthread", "kepler"}},
        {2, "ensemble", {"module", "--lanes", "ensemble", "kepler"}},
        {2, "", {"module"}},
        {2, "", {"module", "--hamiltonian", "p^2/2"}},
        {2, "keplar", {"module", "keplar"}},
        {2, "", {"module", "--basis", "1, exp(w*tau)", "--nodes", "0, 1", "kepler"}},
    };
    for (const Refusal& refusal : refusals) check_refused(refusal, refusal.words);
}

TEST_CASE("a module needs to know where its scene begins") {
    const Directory directory;
    write(directory / "free.toml", "name = \"free\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                   "hamiltonian = \"p^2/2\"\n");
    const Outcome outcome =
        hvi_gen({"module", "--method", "midpoint", "free.toml"}, directory.path());
    CHECK(outcome.status == 2);
    CHECK(text_has(outcome.err, "the scene has no `initial`"));
    CHECK(directory.names() == std::vector<std::string>{"free.toml"});
}

TEST_CASE("a package in Python has its library") {
    const Directory directory;
    const Outcome outcome = hvi_gen(
        {"module", "--method", "midpoint", "--language", "python", "--name", "planet", "kepler"},
        directory.path());
    CHECK(outcome.status == 0);
    const std::vector<std::string> names = names_in(directory / "planet");
    for (const std::string name : {"__init__.py", "_stepper.py", "libplanet.so", "py.typed"})
        CHECK(std::find(names.begin(), names.end(), name) != names.end());
    const std::string text = contents(directory / "planet/__init__.py");
    CHECK(
        text_has(text, "hvi-gen module --method midpoint kepler --name planet --language python"));
    CHECK(text_has(text, "method=\"midpoint\""));
}
