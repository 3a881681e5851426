// Wrong output of programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/simulate/simulation.hpp"
#include "generator/support/error.hpp"
#include "tests/program/simulate/pretended.hpp"

using namespace hvi::gen;
using namespace hvi::test;

namespace {

Answers heard(const std::vector<std::string>& lines) {
    Answers answers("/somewhere/program");
    for (const std::string& line : lines) answers.hear(line);
    return answers;
}

}  // namespace

TEST_CASE("answers are found by their keys") {
    const Answers answers = heard({"status all is well", "end 1", "end -2.5e300", "steps 7"});
    CHECK(answers.text("status") == "all is well");
    CHECK(answers.integer("steps") == 7);
    CHECK(answers.numbers("end", 2) == std::vector<double>{1, -2.5e300});
    CHECK(answers.numbers("start").empty());
}

TEST_CASE("what is no answer is an error of what is outside, with the program's place") {
    CHECK_THROWS_AS(heard({"garbage"}), EnvironmentError);
    CHECK_THROWS_AS(heard({""}), EnvironmentError);
    const Answers answers = heard({"steps ten", "end 1", "end 1e", "large 1e999"});
    CHECK_THROWS_AS(answers.text("status"), EnvironmentError);
    CHECK_THROWS_AS(answers.integer("steps"), EnvironmentError);
    CHECK_THROWS_AS(answers.number("large"), EnvironmentError);
    CHECK_THROWS_AS(answers.numbers("end"), EnvironmentError);
    CHECK_THROWS_AS(heard({"end 1"}).numbers("end", 2), EnvironmentError);
    CHECK_THROWS_AS(measurement(heard({"status ok", "steps 1", "iterations 1", "evaluations 1",
                                       "end 1", "end 2", "velocity 1"})),
                    EnvironmentError);
    CHECK_THROWS_AS(departure_samples(heard({"time 1", "time 2", "departure 0"})),
                    EnvironmentError);
    CHECK(answers.unexpected("x").help().find("/somewhere ") != std::string::npos);
}

TEST_CASE("programs that say nothing, or anything: status 3") {
    const std::string begin = "printf '%s\\n' 'seconds_of_step 1e-7' 'status ok' 'steps 10' ";
    for (const std::string& program : std::vector<std::string>{
             "",
             "exit 0",
             "exit 1",
             "exit 3",
             "exit 70",
             "echo garbage",
             "echo",
             "echo ' '",
             "head -c 100000 /dev/zero",
             "printf '\\377\\376\\n'",
             "yes",
             "yes garbage",
             "yes progress",
             "echo progress nan; " + right_answers,
             "echo progress 2; " + right_answers,
             begin,
             right_answers + "; exit 1",
             right_answers + " 'start 1'",
             right_answers + " 'rows many'",
             "kill -SEGV $$",
             begin + "'t 1' 'rows 11' 'iterations 0' 'evaluations 10' 'start 0.5' 'largest 0'"}) {
        const PretendedCompiler compiler(program);
        const Outcome outcome = compiler.run("exec timeout 60 $run");
        INFO(program << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find(program == "exit 3" ? "error: cannot write "
                                                   : "error: a compiled program ") == 0);
    }
    const Outcome right = PretendedCompiler().run("$run");
    INFO(right.err);
    CHECK(right.status == 0);
}

TEST_CASE("a run that fails leaves no directory that was not there before") {
    const PretendedCompiler compiler("exit 1");
    for (const char* output : {"a/b/out", "out/"}) {
        const Outcome outcome =
            compiler.run("exec $hvi_gen run scene.toml -o " + std::string(output));
        INFO(outcome.err);
        CHECK(outcome.status == 3);
    }
    CHECK(!std::filesystem::exists(compiler.directory / "a"));
    CHECK(!std::filesystem::exists(compiler.directory / "out"));
    std::filesystem::create_directory(compiler.directory / "kept");
    CHECK(compiler.run("exec $hvi_gen run scene.toml -o kept/new").status == 3);
    CHECK(compiler.run("exec $hvi_gen run scene.toml -o kept").status == 3);
    CHECK(names_in(compiler.directory / "kept").empty());
}
