// Proposals of shells and the man page; both and --help know every option.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "generator/options/option_table.hpp"
#include "tests/program/cli/results.hpp"

using namespace hvi::test;
using hvi::gen::Command;
using hvi::gen::CommandEntry;
using hvi::gen::OptionEntry;
using hvi::gen::State;

namespace {

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// Sources the completions of bash, and asks for those of a line with the caret at its end.
class Bash {
public:
    Bash() {
        write(directory_ / "completions", same_every_time({"completions", "bash"}));
        write(directory_ / "mine.toml", "");
        write(directory_ / "my words.toml", "");
    }

    /// Returns the replies, sorted, one in a line. NOTE: `breaks` are the default of an interactive
    /// bash.
    std::string operator()(const std::string& line, const std::string& breaks = ":=") const {
        const Outcome outcome =
            shell("source completions; COMP_WORDBREAKS=" + breaks + "; COMP_LINE='" + line +
                      "'; COMP_POINT=${#COMP_LINE}; _hvi_gen hvi-gen && printf '%s\\n' "
                      "\"${COMPREPLY[@]}\" | LC_ALL=C sort | sed '/^$/d'",
                  directory_.path());
        CHECK(outcome.err.empty());
        return outcome.out;
    }

    [[nodiscard]] Outcome run(const std::string& line) const {
        return shell(line, directory_.path());
    }

private:
    Directory directory_;
};

/// A program of this machine, where there is one.
bool is_installed(const std::string& program) {
    return shell("command -v " + program + " >/dev/null").status == 0;
}

/// The part of the text from one line that contains `begin` up to the next with `end`.
std::string part(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    REQUIRE(from != std::string::npos);
    return text.substr(from, text.find(end, from + begin.size()) - from);
}

void for_each_option(auto&& check) {
    for (const CommandEntry& entry : hvi::gen::command_table())
        for (const OptionEntry* option : hvi::gen::options_of(entry.command))
            if (entry.state == State::built) check(entry, *option);
}

std::string with_hyphens(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '-' ? std::string("\\-") : std::string(1, c);
    return result;
}

}  // namespace

TEST_CASE("bash completes commands, options and values") {
    const Bash bash;
    CHECK(bash.run("bash -n completions").err.empty());
    CHECK(bash.run("source completions; complete -p hvi-gen").out ==
          "complete -F _hvi_gen hvi-gen\n");
    CHECK(bash("hvi-gen s") == "scheme\nshow\nstepper\nsymmetries\n");
    CHECK(has(bash("hvi-gen "), "tableau\n"));
    CHECK(bash("hvi-gen --v") == "--version\n");
    CHECK(bash("hvi-gen tableau --d") == "--digits\n");
    CHECK(bash("hvi-gen stepper kepler --e") == "--energy\n--evaluations\n--explain\n");
    CHECK(bash("hvi-gen tableau --format ") == "csv\njson\nlatex\nmarkdown\ntext\n");
    CHECK(bash("hvi-gen check --format ") == "json\ntext\n");
    CHECK(bash("hvi-gen stepper --lanes e") == "ensemble\n");
    CHECK(bash("hvi-gen run --lanes e").empty());
    CHECK(bash("hvi-gen stepper --compose y") == "yoshida:4\nyoshida:6\nyoshida:8\n");
    CHECK(bash("hvi-gen tableau --method tr") == "trig3\n");
    CHECK(bash("hvi-gen tableau --nodes ga") == "gauss:\n");
    CHECK(bash("hvi-gen tableau --basis m") == "monomials:\n");
    CHECK(bash("hvi-gen list m") == "methods\n");
    CHECK(bash("hvi-gen completions ") == "bash\nfish\nzsh\n");
    CHECK(bash("hvi-gen report --only html,s") == "html,stiff\nhtml,svg\nhtml,symplecticity\n");
    CHECK(bash("hvi-gen tableau --digits ").empty());
    CHECK(bash("hvi-gen tableau --unknown=").empty());
    CHECK(bash("hvi-gen unknown --f").empty());
}

TEST_CASE("bash replaces what stands behind its word breaks") {
    const Bash bash;
    CHECK(bash("hvi-gen stepper --compose yoshida:") == "4\n6\n8\n");
    CHECK(bash("hvi-gen tableau --format=m") == "markdown\n");
    CHECK(bash("hvi-gen tableau --format=m", "") == "--format=markdown\n");
    CHECK(bash("hvi-gen stepper --compose=ka") == "kahan-li:8\n");
    CHECK(bash("hvi-gen stepper --compose=kahan-li:") == "8\n");
}

TEST_CASE("bash completes scenes and files") {
    const Bash bash;
    CHECK(bash("hvi-gen run ke") == "kepler\n");
    CHECK(bash("hvi-gen run m") == "mine.toml\nmy words.toml\n");
    CHECK(bash("hvi-gen report kepler pe") == "pendulum\n");
    CHECK(bash("hvi-gen tableau --method-file my") == "my words.toml\n");
    CHECK(bash("hvi-gen run kepler -o m").empty());  // a directory
}

TEST_CASE("zsh and fish read their completions, where they are installed") {
    const Directory directory;
    write(directory / "_hvi-gen", same_every_time({"completions", "zsh"}));
    write(directory / "hvi-gen.fish", same_every_time({"completions", "fish"}));
    if (is_installed("zsh")) CHECK(shell("zsh -n _hvi-gen", directory.path()).status == 0);
    if (is_installed("fish")) CHECK(shell("fish -n hvi-gen.fish", directory.path()).status == 0);
    const std::string zsh = contents(directory / "_hvi-gen");
    CHECK(zsh.rfind("#compdef hvi-gen\n", 0) == 0);
    CHECK(has(zsh, "'(-o --output)'{-o,--output=}'[Write to this file]:FILE:_files'"));
    CHECK(has(zsh, "'--digits=[Significant digits of decimal values (50)]:N: '"));
    CHECK(has(zsh, "(--method --method-file)--nodes=[Nodes in \\[0,1\\]]:NODES:(gauss\\:"));
    CHECK(has(zsh, "'1:SCENE:_hvi_gen_scenes'"));
    CHECK(
        has(contents(directory / "hvi-gen.fish"),
            "-n '__fish_seen_subcommand_from check stepper scheme symmetries' -l hamiltonian -x -d "
            "'H(q, p, t) in place of SCENE: \"p^2/2 + w^2*q^2/2\"'\n"));
    CHECK(
        has(contents(directory / "hvi-gen.fish"), "-s o -l output -r -F -d 'Write to this file'"));
}

TEST_CASE("man shows the manual without a warning, where it is installed") {
    const Directory directory;
    write(directory / "hvi-gen.1", same_every_time({"manual"}));
    for (const std::string line :
         {"groff -man -Tutf8 -ww -z hvi-gen.1", "man --warnings=w -l hvi-gen.1 >/dev/null"}) {
        if (!is_installed(line.substr(0, line.find(' ')))) continue;
        const Outcome outcome = shell("LC_ALL=C.UTF-8 " + line, directory.path());
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
    }
    CHECK(has(contents(directory / "hvi-gen.1"), ".TH HVI\\-GEN 1 "));
}

TEST_CASE("every option that is built is shown, and none that is to come") {
    const std::string bash = hvi_gen({"completions", "bash"}).out;
    const std::string zsh = hvi_gen({"completions", "zsh"}).out;
    const std::string fish = hvi_gen({"completions", "fish"}).out;
    const std::string manual = hvi_gen({"manual"}).out + "\n.SS ";
    for_each_option([&](const CommandEntry& entry, const OptionEntry& option) {
        const std::string command(entry.name), name(option.name);
        INFO(command << " " << name);
        const bool is_shown = option.state == State::built;
        CHECK(has(hvi_gen({command, "--help"}).out, name + " ") == is_shown);
        const std::string chapter = part(manual, ".SS \\fB" + command + "\\fR", "\n.SS ");
        if (option.is_word()) {
            CHECK(has(chapter, "\\fI" + std::string(option.placeholder) + "\\fR\n"));
            return;
        }
        const auto words = part(bash, "\n    " + command + ") candidates='--", "'");
        const std::string of_zsh = part(zsh, "\n    " + command + ")\n", ";;");
        CHECK(has(chapter, "\\fB" + with_hyphens(name) + "\\fR") == is_shown);
        CHECK(has(part(bash, "\n    " + command + ") candidates='--", ";;") + " ",
                  name + (has(words, name + " ") ? " " : "'")) == is_shown);
        CHECK((has(of_zsh, name + "[") || has(of_zsh, name + "=[") || has(of_zsh, name + "}") ||
               has(of_zsh, name + "=}")) == is_shown);
        if (is_shown) CHECK(has(fish, " -l " + name.substr(2) + " "));
    });
}

TEST_CASE("commands that are to come are not shown") {
    const std::string help = hvi_gen({"--help"}).out;
    const std::string manual = hvi_gen({"manual"}).out;
    const std::string bash = hvi_gen({"completions", "bash"}).out;
    const std::string zsh = hvi_gen({"completions", "zsh"}).out;
    const std::string fish = hvi_gen({"completions", "fish"}).out;
    const std::string proposed = part(bash, "candidates='tableau", "'") + " ";
    for (const CommandEntry& entry : hvi::gen::command_table()) {
        const std::string name(entry.name);
        INFO(name);
        const bool is_shown = entry.state == State::built;
        CHECK(has(help, "\n  " + name + " ") == is_shown);
        CHECK(has(manual, ".SS \\fB" + name + "\\fR") == is_shown);
        CHECK((name == "tableau" || has(proposed, " " + name + " ")) == is_shown);
        CHECK(has(zsh, "'" + name + ":") == is_shown);
        CHECK(has(fish, " -a " + name + " -d ") == is_shown);
    }
}
