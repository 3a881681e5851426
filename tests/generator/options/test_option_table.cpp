// Every row of the tables says all that is to be said of an option.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/options/option_table.hpp"

using namespace hvi::gen;

namespace {

using Rows = std::vector<OptionEntry>;

Rows rows() { return {option_table().begin(), option_table().end()}; }

bool is_choice(const OptionEntry& row) {
    return row.value == Value::choice || row.value == Value::mode || row.value == Value::choices;
}

std::string fault_in_name(const OptionEntry& row) {
    if (row.name.empty()) return "has no name";
    if (!row.is_word() && (!row.name.starts_with("--") || row.name.size() < 3))
        return "is no long name";
    if (!row.abbreviation.empty() &&
        (row.abbreviation.size() != 2 || row.abbreviation.front() != '-'))
        return "has an abbreviation that is none";
    return "";
}

std::string fault_in_value(const OptionEntry& row) {
    if (row.is_word() && row.value == Value::none) return "is a word without a meaning";
    if (row.placeholder.empty() != (row.value == Value::none)) return "has no placeholder";
    if (row.choices.empty() == is_choice(row)) return "has no choices";
    if ((row.range.least < row.range.most) != (row.value == Value::whole)) return "has no range";
    std::set<std::string_view> names;
    for (const Choice& choice : row.choices)
        if (choice.name.empty() || !names.insert(choice.name).second) return "has a choice twice";
    return "";
}

std::string fault_in_words(const OptionEntry& row) {
    if (row.help.empty() || row.help.ends_with('.') || row.help.size() > 60) return "has no help";
    const bool has_commands =
        std::any_of(command_table().begin(), command_table().end(), [&](const auto& entry) {
            return entry.state == State::built && row.of.contains(entry.command);
        });
    if (!has_commands) return "is of no command";
    const bool relates = !row.needs.others.empty() || !row.excludes.others.empty();
    if (!relates && !(row.needs.help.empty() && row.needs.what.empty() &&
                      row.excludes.help.empty() && row.excludes.what.empty()))
        return "speaks of no other";
    return "";
}

/// Returns the fault where a related option is unknown: each command of the row must take a needed
/// one, and some command an excluded one.
std::string fault_in_relations(const Rows& all, const OptionEntry& row) {
    const auto taken = [&](std::string_view name, Command command) {
        return std::any_of(all.begin(), all.end(), [&](const OptionEntry& other) {
            return other.name == name && other.of.contains(command);
        });
    };
    for (const CommandEntry& entry : command_table()) {
        if (!row.of.contains(entry.command)) continue;
        for (const std::string_view needed : split(row.needs.others, ' '))
            for (const std::string_view other : split(needed, '|'))
                if (!taken(other, entry.command)) return "needs what is not there";
    }
    for (const std::string_view other : split(row.excludes.others, ' ')) {
        const bool is_somewhere =
            std::any_of(command_table().begin(), command_table().end(), [&](const auto& entry) {
                return row.of.contains(entry.command) && taken(other, entry.command);
            });
        if (!is_somewhere || other == row.name) return "excludes what is not there";
    }
    return "";
}

bool share_a_command(const OptionEntry& row, const OptionEntry& other) {
    return std::any_of(command_table().begin(), command_table().end(), [&](const auto& entry) {
        return row.of.contains(entry.command) && other.of.contains(entry.command);
    });
}

std::vector<std::string> faults(const Rows& all) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const OptionEntry& row = all[i];
        for (const std::string& fault : {fault_in_name(row), fault_in_value(row),
                                         fault_in_words(row), fault_in_relations(all, row)})
            if (!fault.empty()) found.push_back(std::string(row.name) + " " + fault);
        for (std::size_t j = 0; j < i; ++j)
            if (all[j].name == row.name && share_a_command(all[j], row))
                found.push_back(std::string(row.name) + " stands twice");
    }
    return found;
}

OptionEntry& row_of(Rows& all, std::string_view name) {
    return *std::find_if(all.begin(), all.end(), [&](const auto& row) { return row.name == name; });
}

}  // namespace

TEST_CASE("no row lacks anything") { CHECK(faults(rows()) == std::vector<std::string>{}); }

TEST_CASE("a row that lacks something is found") {
    const auto fault = [](std::string_view name, auto damage) {
        Rows all = rows();
        damage(row_of(all, name));
        const std::vector<std::string> found = faults(all);
        return found.empty() ? "" : found.front();
    };
    using Row = OptionEntry&;
    CHECK(fault("--digits", [](Row row) { row.help = {}; }) == "--digits has no help");
    CHECK(fault("--digits", [](Row row) { row.range = {}; }) == "--digits has no range");
    CHECK(fault("--digits", [](Row row) { row.of = {}; }) == "--digits is of no command");
    CHECK(fault("--digits", [](Row row) { row.value = Value::none; }) ==
          "--digits has no placeholder");
    CHECK(fault("--solver", [](Row row) { row.choices = {}; }) == "--solver has no choices");
    CHECK(fault("--solver", [](Row row) { row.placeholder = {}; }) ==
          "--solver has no placeholder");
    CHECK(fault("--digits", [](Row row) { row.name = "-digits"; }) == "-digits is no long name");
    CHECK(fault("--digits", [](Row row) { row.name = "--format"; }) == "--format stands twice");
    CHECK(fault("--energy", [](Row row) { row.needs = {"--scene"}; }) ==
          "--energy needs what is not there");
    CHECK(fault("--energy", [](Row row) { row.excludes = {.others = "--energy"}; }) ==
          "--energy excludes what is not there");
    CHECK(fault("--explain", [](Row row) { row.needs.help = "why"; }) ==
          "--explain speaks of no other");
    CHECK(fault("--output", [](Row row) { row.abbreviation = "o"; }) ==
          "--output has an abbreviation that is none");
}

TEST_CASE("every command is found by its name") {
    for (const CommandEntry& entry : command_table()) {
        CHECK(find_command(entry.name) == &entry);
        CHECK(&entry_of(entry.command) == &entry);
        CHECK(!entry.help.empty());
        CHECK(options_of(entry.command).empty() == (entry.state == State::to_come));
    }
    CHECK(find_command("") == nullptr);
    CHECK(find_command("tabeau") == nullptr);
}

TEST_CASE("every wish of a stepper is quoted as its option, in the order of the table") {
    CHECK(options_for({}).empty());
    StepperWishes wishes;
    wishes.separable = wishes.energy = wishes.invariants = true;
    wishes.evaluations = wishes.float128 = wishes.dense = wishes.action = true;
    wishes.solver = Solver::newton_taylor;
    wishes.sweeps.choice = 3;
    wishes.lanes.choice = Lanes::none;
    wishes.class_name = given("--name", "N");
    wishes.composition = named_composition(given("--compose", "yoshida:4"));
    CHECK(options_for(wishes) ==
          " --separable --solver newton-taylor --sweeps 3 --lanes none --compose yoshida:4 "
          "--energy --invariants --evaluations --float128 --dense --action --name N");
}

TEST_CASE("what stands beside what") {
    const auto names = [](std::string_view option, Command command) {
        std::vector<std::string_view> all;
        for (const OptionEntry* other : not_beside(option_of(command, option), command))
            all.push_back(other->name);
        return all;
    };
    using Names = std::vector<std::string_view>;
    CHECK(names("--method-file", Command::tableau) ==
          Names{"--method", "--basis", "--nodes", "--weights"});
    CHECK(names("--tableau", Command::check) ==
          Names{"--method", "--basis", "--nodes", "--weights", "--method-file", "--sweeps"});
    CHECK(names("--separable", Command::stepper) == Names{"SCENE", "--hamiltonian"});
    CHECK(names("--step", Command::run) == Names{"--accuracy"});
    CHECK(names("--explain", Command::stepper) == Names{"--dump"});
    CHECK(names("--name", Command::stepper).empty());
}
