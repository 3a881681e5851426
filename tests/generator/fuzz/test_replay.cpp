// Every file of the corpus through its target: findings of the fuzzer stay fixed. And some texts of
// each grammar.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <signal.h>
#include <time.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <catch2/catch.hpp>

#include "tests/checkout.hpp"
#include "tests/generator/fuzz/grammars.hpp"
#include "tests/generator/fuzz/targets.hpp"

namespace {

namespace fuzz = hvi::gen::fuzz;

/// Ends the test where an input takes too long; the test then says which.
class Watch {
public:
    Watch() {
        sigevent event{};
        event.sigev_notify = SIGEV_SIGNAL;
        event.sigev_signo = SIGTERM;  // which Catch reports
        REQUIRE(::timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer_) == 0);
        const itimerspec end{{}, {most_seconds, 0}};
        REQUIRE(::timer_settime(timer_, 0, &end, nullptr) == 0);
    }
    ~Watch() { ::timer_delete(timer_); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

private:
    static constexpr time_t most_seconds = 600;

    timer_t timer_{};
};

/// The corpus has one directory for each target.
void replay(const char* target, void (*run)(std::string_view)) {
    std::size_t files = 0;
    const std::string corpus = hvi::test::in_checkout("tests/generator/fuzz/corpus/");
    for (const auto& entry : std::filesystem::directory_iterator(corpus + target)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        INFO(entry.path().filename().string());
        const Watch watch;
        CHECK_NOTHROW(run(bytes));
        ++files;
    }
    CHECK(files > 0);
}

/// Runs the texts of `count` seeds, which are equal on all machines.
void derive(const fuzz::Grammar& grammar, void (*run)(std::string_view), unsigned count) {
    for (unsigned seed = 0; seed < count; ++seed) {
        std::mt19937 random(seed);
        std::string bytes;
        while (bytes.size() < 400) bytes += static_cast<char>(random() & 0xff);
        const std::string text = grammar.derive(bytes);
        INFO("seed " << seed << ":\n" << text);
        const Watch watch;
        CHECK_NOTHROW(run(text));
    }
}

}  // namespace

TEST_CASE("expressions") { replay("expression", fuzz::expression); }
TEST_CASE("lists") { replay("list", fuzz::list); }
TEST_CASE("names") { replay("name", fuzz::name); }
TEST_CASE("parameters") { replay("parameter", fuzz::parameter); }
TEST_CASE("method files") { replay("method_file", fuzz::method_file); }
TEST_CASE("rows of numbers") { replay("rows", fuzz::rows); }
TEST_CASE("scenes") { replay("scene", fuzz::scene); }
TEST_CASE("coefficients") { replay("coefficients", fuzz::coefficients); }
TEST_CASE("Hamiltonians") { replay("hamiltonian", fuzz::hamiltonian); }
TEST_CASE("command lines") { replay("command_line", fuzz::command_line); }
TEST_CASE("commands") { replay("command", fuzz::command); }

TEST_CASE("derived command lines") { derive(fuzz::command_lines(), fuzz::command_line, 500); }
TEST_CASE("derived methods") { derive(fuzz::methods(), fuzz::command, 60); }
TEST_CASE("derived scenes") { derive(fuzz::scenes(), fuzz::command, 200); }
TEST_CASE("derived searches") { derive(fuzz::searches(), fuzz::command, 400); }
TEST_CASE("derived tableau files") { derive(fuzz::tableau_files(), fuzz::command, 30); }

TEST_CASE("inputs too large for the corpus") {
    for (const std::string piece :
         {"(", "-", "2^", "sin(", "1+", "1/", "x*", "1,", "gauss:", "((1", "9", "e"}) {
        std::string text;
        while (text.size() < 100000) text += piece;
        for (const std::size_t size : {text.size(), std::size_t{65535}}) {
            CHECK_NOTHROW(fuzz::expression(text.substr(0, size)));
            CHECK_NOTHROW(fuzz::list(text.substr(0, size)));
            CHECK_NOTHROW(fuzz::name(text.substr(0, size)));
            CHECK_NOTHROW(fuzz::hamiltonian(text.substr(0, size)));
            CHECK_NOTHROW(fuzz::hamiltonian("x\n" + text.substr(0, size) + "\np"));
            CHECK_NOTHROW(fuzz::method_file("basis = \"" + text.substr(0, size) + "\"\nnodes = 0"));
            CHECK_NOTHROW(fuzz::scene("coordinates = \"x\"\nmomenta = \"p\"\nhamiltonian = \"" +
                                      text.substr(0, size) + "\"\n[initial]\nx = 1\np = 1"));
            CHECK_NOTHROW(fuzz::coefficients("{\"A\":[[\"" + text.substr(0, size) +
                                             "\"]],\"b\":[1],\"c\":[0]}"));
        }
    }
}

TEST_CASE("method files with many lines, keys and elements") {
    const auto repeated = [](const std::string& piece, std::size_t times) {
        std::string text;
        for (std::size_t k = 0; k < times; ++k) text += piece;
        return text;
    };
    fuzz::method_file("basis = [" + repeated("1.5,", 200000) + "]\nnodes = 0\n");
    fuzz::method_file("basis = " + repeated("[", 100000));
    fuzz::method_file(repeated("[a]\n", 100000));
    fuzz::method_file(repeated("\n", 500000) + "basis = 1\nnodes = [0.5, tau]");
    std::string parameters = "basis = \"tau\"\nnodes = 0\n[parameters]\n";
    for (int k = 0; k < 50000; ++k) parameters += "w" + std::to_string(k) + " = 0.5\n";
    fuzz::method_file(parameters);
}

TEST_CASE("scenes with many names, values and words") {
    const auto repeated = [](const std::string& piece, int times) {
        std::string text;
        for (int k = 0; k < times; ++k) {
            const std::size_t mark = std::min(piece.find('#'), piece.size());
            text += piece.substr(0, mark);
            if (mark < piece.size()) text += std::to_string(k) + piece.substr(mark + 1);
        }
        return text;
    };
    const std::string system = "coordinates = \"x\"\nmomenta = \"p\"\nhamiltonian = \"x*p\"\n"
                               "initial = {x = 1, p = 0}\n";
    fuzz::scene("coordinates = [" + repeated("\"x#[1..999]\",", 20000) + "]\n");
    fuzz::scene(system + "[parameters]\n" + repeated("a# = 0.5\n", 50000));
    fuzz::scene(system + "[parameters]\na = [" + repeated("1,", 200000) + "]\n");
    fuzz::scene(system + "[invariants]\n" + repeated("a# = \"sum(i=1..19000, x^i)\"\n", 20000));
    fuzz::scene(system + "[run]\n" + repeated("a# = 1\n", 50000));
    fuzz::scene("hamiltonian = \"\"\"" + repeated("\n", 500000) + "x*p\"\"\"\n" + system);
    fuzz::scene(repeated("[[initial]]\n", 50000));
}

TEST_CASE("JSON with many values, keys and brackets") {
    const auto repeated = [](const std::string& piece, std::size_t times) {
        std::string text;
        for (std::size_t k = 0; k < times; ++k) text += piece;
        return text;
    };
    fuzz::coefficients(repeated("[", 1000000));
    fuzz::coefficients(repeated("{\"a\":", 1000000));
    fuzz::coefficients("[" + repeated("1,", 1000000));
    fuzz::coefficients("{" + repeated("\"a\":0,", 200000) + "\"b\":0}");
    fuzz::coefficients(repeated("\n", 1000000) + "{");
    fuzz::coefficients("\"" + repeated("\\\"", 1000000) + "\"");
}
