// Headers of scenes that say what C++ reads in its own way: they compile without a warning.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "tests/checkout.hpp"
#include "tests/program/cli/program.hpp"

using namespace hvi::test;

namespace {

const std::vector<std::string> read_only{"-std=c++17 -fsyntax-only", "-std=gnu++17 -fsyntax-only"};
/// Options for machines with more instructions.
const std::vector<std::string> optimised{"-std=c++17 -O2",
#ifdef __x86_64__
                                         "-std=c++17 -O3 -march=skylake-avx512"
#endif
};

/// Compiled under the warnings of CONTRACT.md, with and without the compiler's extensions, behind
/// headers that define macros. `use` stands in a function of a file that includes the header.
void check_compiles(const Directory& directory, const std::string& header,
                    const std::string& use = "", const std::vector<std::string>& ways = read_only) {
    write(directory / "unit.cpp", "#include <cassert>\n#include <cerrno>\n#include <climits>\n"
                                  "#include <cmath>\n#include <cstdio>\n#include \"" +
                                      header + "\"\nvoid unit() {\n" + use + "}\n");
    for (const std::string& way : ways) {
        const Outcome outcome = shell(HVI_COMPILER " -c -o unit.o " + way +
                                          " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
                                          " -I . -I '" +
                                          in_checkout("src") + "' unit.cpp",
                                      directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 0);
    }
}

void check_stepper_compiles(const std::string& scene, const std::vector<std::string>& options,
                            const std::string& use = "",
                            const std::vector<std::string>& ways = read_only) {
    const Directory directory;
    write(directory / "scene.toml", scene);
    std::vector<std::string> words = {"stepper",  "scene.toml", "--name",
                                      "Stepper1", "-o",         "stepper.hpp"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = hvi_gen(words, directory.path());
    INFO(scene << outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    check_compiles(directory, "stepper.hpp", use, ways);
}

const std::string oscillator =
    "coordinates = \"q\"\nmomenta = \"p\"\nhamiltonian = \"p^2/2 + k*q^2/2 + q^4\"\n";

}  // namespace

TEST_CASE("decimals of 20 and more digits stand in comments that end with their line") {
    const std::string digits = "1.0015851063790825241";
    const std::string scene =
        "coordinates = \"q\"\nmomenta = \"p\"\n"
        "hamiltonian = \"p^2/2 + a[1]*a[2]*k*q^2/2 + q^4*0.12345678901234567890123456789\"\n"
        "[parameters]\nk = \"" +
        digits + "\"\na = [\"" + digits + digits.substr(2) + "\", \"-" + digits +
        "\"]\n[initial]\nq = \"" + digits +
        "\"\np = \"0.1234567890123456789012345678901234567890\"\n";
    for (const char* method : {"stormer-verlet", "gauss:2"}) {
        check_stepper_compiles(scene, {"--method", method},
                               "    static_assert(hvi::generated::Stepper1::initial().q[0] == " +
                                   digits + ", \"\");\n");
    }
}

TEST_CASE("a description ends with its line") {
    for (const char* description :
         {"ends \\", "ends \\ ", "what?\?/", "\\", "*/ /* // \"", "@name@ %d {} {0}",
          "a description that is longer than a line of the page, and whose first line ends there "
          "\\ "
          "so that the next is no code"}) {
        check_stepper_compiles(std::string("description = '") + description + "'\n" + oscillator +
                                   "[parameters]\nk = 1\n[initial]\nq = 1\np = 0\n",
                               {"--method", "stormer-verlet"});
    }
}

TEST_CASE("parameters that are macros are members with another name") {
    std::string sum, parameters, use;
    for (const std::string name :
         {"M_PI",    "NAN",   "INFINITY", "EOF",      "errno",   "assert", "NULL",
          "linux",   "unix",  "HUGE_VAL", "RAND_MAX", "INT_MAX", "EPERM",  "stdin",
          "DBL_MAX", "isnan", "class",    "I",        "GM",      "major",  "SIGINT"}) {
        sum += "+" + name;
        parameters += name + " = 2\n";
        if (name != "isnan") use += "    parameters." + name + "_ = 3.0;\n";
    }
    check_stepper_compiles("coordinates = \"SEEK_SET[1..2]\"\nmomenta = [\"M_E\", \"EOF1\"]\n"
                           "hamiltonian = \"(M_E^2 + EOF1^2)/2 + (" +
                               sum.substr(1) +
                               ")*(SEEK_SET[1]^2 + SEEK_SET[2]^4)/2\"\n[parameters]\n" +
                               parameters + "[initial]\nSEEK_SET = [1, 1]\nM_E = 0\nEOF1 = 0\n",
                           {"--method", "stormer-verlet"},
                           "    hvi::generated::Stepper1::Parameters parameters;\n" + use +
                               "    parameters.isnan = 3.0;\n");
}

TEST_CASE("an invariant that is spelled as a macro is a function with an underscore behind") {
    for (const std::string size : {"2", "100"}) {
        const std::string scene =
            "name = \"star\"\ncoordinates = [\"x[1.." + size + "]\"]\nmomenta = [\"p[1.." + size +
            "]\"]\nhamiltonian = \"sum(i=1.." + size +
            ", p[i]^2/2 + GM*x[i]^2/2)\"\n[parameters]\nGM = 1\n[invariants]\n"
            "EOF = \"x[1]*p[2] - x[2]*p[1]\"\nLZ = \"sum(i=1.." +
            size +
            ", x[i]^2 + p[i]^2)\"\n[initial]\n\"x[i]\" = \"i\"\n\"p[i]\" = \"-i\"\n"
            "[run]\nmethod = \"gauss:2\"\nstep = \"1/8\"\nuntil = 1\n";
        check_stepper_compiles(scene, {"--method", "gauss:2", "--invariants"},
                               "    hvi::generated::Stepper1::Parameters parameters;\n"
                               "    parameters.GM_ = 1.0;\n"
                               "    const hvi::generated::Stepper1 stepper{parameters};\n"
                               "    const auto x = hvi::generated::Stepper1::initial(parameters);\n"
                               "    (void)(stepper.EOF_(x) + stepper.LZ_(x));\n");
        const Directory directory;
        write(directory / "scene.toml", scene);
        const Outcome outcome = hvi_gen({"run", "scene.toml", "-o", "run"}, directory.path());
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.out.find("\nEOF ") != std::string::npos);
        CHECK(outcome.out.find("\nLZ ") != std::string::npos);
    }
}

TEST_CASE("the frequency that a basis is fitted to is a member under its own name") {
    check_stepper_compiles("coordinates = \"q\"\nmomenta = \"p\"\n"
                           "hamiltonian = \"p^2/2 + NAN*q^2/2 + q^4\"\n[parameters]\nNAN = 2\n"
                           "[initial]\nq = 1\np = 0\n",
                           {"--basis", "1, cos(NAN*tau), sin(NAN*tau)", "--nodes", "0, 1/2, 1"});
}

TEST_CASE("a method whose name means something in C++ gives a class of another name") {
    for (const std::string name : {"system", "status", "vector", "NAN", "EOF"}) {
        const Directory directory;
        write(directory / "method.toml",
              "name = \"" + name + "\"\nbasis = \"1, tau\"\nnodes = \"0, 1\"\n");
        const Outcome outcome =
            hvi_gen({"stepper", "--method-file", "method.toml", "--separable", "-o", "stepper.hpp"},
                    directory.path());
        INFO(name << outcome.err);
        CHECK(outcome.status == 0);
        check_compiles(directory, "stepper.hpp");
    }
}

TEST_CASE("a function of what simplifies to a constant is a constant") {
    for (const std::string function : {"sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "exp"})
        for (const std::string argument : {"q/q", "k^0", "sin(q)^2+cos(q)^2", "sqrt(q^2/q^2)"}) {
            INFO(function << "(" << argument << ")");
            const std::vector<std::string> words = {"stepper",
                                                    "--method",
                                                    "gauss:1",
                                                    "--hamiltonian",
                                                    "k*q^2/2+p^2/2*" + function + "(" + argument +
                                                        ")",
                                                    "--param",
                                                    "k=1"};
            const Outcome outcome = hvi_gen(words);
            CHECK(outcome.status == 0);
            CHECK(outcome.out.find("// " + function + "(1)\n") != std::string::npos);
        }
    const Directory directory;
    const Outcome outcome = hvi_gen(
        {"stepper", "--method", "gauss:1", "--hamiltonian",
         "p^2/2*cosh(q/q)+(q/q)^q*q^2+q^4*(q/q)^(1/3)+log(3*q/q)^(1/7)*q^6", "-o", "stepper.hpp"},
        directory.path());
    CHECK(outcome.status == 0);
    check_compiles(directory, "stepper.hpp");
}

TEST_CASE("an optimiser has nothing to warn of") {
    const std::string step = "    hvi::generated::Stepper1 stepper;\n"
                             "    auto x = hvi::generated::Stepper1::initial();\n"
                             "    static_cast<void>(stepper.step(x, 0.1));\n";
    check_stepper_compiles("coordinates = \"q\"\nvelocities = \"v\"\n"
                           "lagrangian = \"v^2/2 - q^2/2\"\n[initial]\nq = 1\nv = 0\n",
                           {"--method", "gauss:2"}, step, optimised);
    // A force that does not depend on its index, and functions of many numbers at once.
    for (const char* potential : {"x[mod(i,N)+1]", "exp(x[mod(i,N)+1]-x[i]) + cos(x[i])"})
        check_stepper_compiles("coordinates = \"x[1..N]\"\nmomenta = \"p[1..N]\"\n"
                               "hamiltonian = \"sum(i=1..N, p[i]^2/2 + " +
                                   std::string(potential) +
                                   ")\"\n[parameters]\nN = 80\n[initial]\n"
                                   "\"x[i]\" = \"sin(i)\"\n\"p[i]\" = \"0\"\n",
                               {"--method", "stormer-verlet"}, step, optimised);
}
