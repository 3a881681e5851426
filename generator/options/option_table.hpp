// The commands of hvi-gen and their options in one table. The parser, --help, the completions of
// shells and the man page follow it. It also has exclusions, and the options that headers
// quote.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/options/wishes.hpp"

namespace hvi::gen {

/// Whether an entry is built or to come. An entry of CONTRACT.md that is to come is refused, and
/// not shown.
enum class State { built, to_come };

enum class Command {
    tableau,
    check,
    stepper,
    scheme,
    run,
    report,
    symmetries,
    ensemble,
    collect,
    solve,
    module,
    show,
    list,
    cache,
    completions,
    manual,
    help,
};

struct CommandEntry {
    Command command;
    std::string_view name;
    std::string_view words;  ///< words behind it where options follow: `METHOD [SCENE]`
    std::string_view help;   ///< a line
    State state = State::built;
};

/// Some of the commands.
class Commands {
public:
    constexpr Commands() = default;
    constexpr Commands(std::initializer_list<Command> all) {
        for (const Command command : all) bits_ |= bit(command);
    }

    [[nodiscard]] constexpr bool contains(Command command) const {
        return (bits_ & bit(command)) != 0;
    }
    [[nodiscard]] constexpr bool meet(Commands others) const { return (bits_ & others.bits_) != 0; }

private:
    static constexpr unsigned bit(Command command) { return 1U << static_cast<unsigned>(command); }

    unsigned bits_ = 0;
};

/// Kinds of values of options: they determine the checks, and the proposals of shells.
enum class Value {
    none,
    mode,  ///< none, or one of the choices behind `=`
    text,
    whole,     ///< a whole number in a range
    fraction,  ///< a number between 0 and 1
    file,
    directory,
    choice,
    choices,  ///< some of them, between commas
    method,
    methods,  ///< some, between commas
    basis,
    nodes,
    composition,
    scene,
};

/// A possible value of an option, and its enumerator.
struct Choice {
    std::string_view name;
    int value;
    State state = State::built;
};

template <class Enumeration>
constexpr Choice choice(std::string_view name, Enumeration value, State state = State::built) {
    return {name, static_cast<int>(value), state};
}

struct WholeRange {
    int least = 0, most = 0;
};

/// Space-separated names of related options, and the error text when the relation is violated. In
/// `needs`, one of `SCENE|--hamiltonian` is enough.
struct Relation {
    std::string_view others = {};
    std::string_view what = {};  ///< replaces the usual words; `{}` is the other option
    std::string_view help = {};
};

/// The member of the wishes that an option sets.
using WishMember =
    std::variant<std::monostate, bool StepperWishes::*, Solver StepperWishes::*,
                 Wish<int> StepperWishes::*, Wish<Lanes> StepperWishes::*, Unroll StepperWishes::*,
                 std::optional<Composition> StepperWishes::*, Given StepperWishes::*>;

/// A row of the table. An option may have several rows for different commands, with one meaning.
struct OptionEntry {
    std::string_view name;               ///< `--output`; `SCENE` for a word that stands alone
    std::string_view abbreviation = {};  ///< `-o`
    Commands of = {};                    ///< the commands that take it
    Value value = Value::none;
    std::string_view placeholder = {};     ///< the name of the value: `FILE`
    std::span<const Choice> choices = {};  ///< where the value is one of them, or some
    WholeRange range = {};                 ///< where the value is a whole number
    std::string_view help = {};            ///< a line; choices are listed behind it
    bool is_repeatable = false;
    Relation needs = {};
    Relation excludes = {};
    WishMember wish = {};
    State state = State::built;

    [[nodiscard]] constexpr bool is_word() const { return !name.starts_with('-'); }
    /// Whether a word belongs to the option.
    [[nodiscard]] constexpr bool takes_word() const {
        return value != Value::none && value != Value::mode;
    }
};

/// Returns the rows in the order in which they are shown. A generated header quotes wishes in this
/// order too.
[[nodiscard]] std::span<const OptionEntry> option_table();
[[nodiscard]] std::span<const CommandEntry> command_table();

/// Explains METHOD to people, in lines.
[[nodiscard]] std::string_view method_help();

/// Returns the rows of a command.
[[nodiscard]] std::vector<const OptionEntry*> options_of(Command command);
[[nodiscard]] std::vector<const OptionEntry*> options_of(Command command, State state);

/// Returns the option with this name or abbreviation; null where the command takes none.
[[nodiscard]] const OptionEntry* find_option(Command command, std::string_view name);

/// Returns the option with this name or abbreviation. Precondition: the command takes it.
[[nodiscard]] const OptionEntry& option_of(Command command, std::string_view name);

/// Returns null where there is no command of this name.
[[nodiscard]] const CommandEntry* find_command(std::string_view name);
[[nodiscard]] const CommandEntry& entry_of(Command command);

/// Returns the built options that exclude this one or are excluded by it.
[[nodiscard]] std::vector<const OptionEntry*> not_beside(const OptionEntry& option,
                                                         Command command);

/// Returns `text, json or latex`.
[[nodiscard]] std::string names_of(std::span<const Choice> choices);
/// Returns the names of choices that are built.
[[nodiscard]] std::vector<std::string_view> built(std::span<const Choice> choices);

/// Returns the help of an option, with its choices.
[[nodiscard]] std::string help_of(const OptionEntry& option);

/// Returns the pieces between separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// Returns an option's name in messages: `--solver`; `a scene` for the word SCENE.
[[nodiscard]] std::string spoken(std::string_view name);

/// Returns the options of `hvi-gen stepper` that make these wishes: ` --compose yoshida:4
/// --energy`.
[[nodiscard]] std::string options_for(const StepperWishes& wishes,
                                      Command command = Command::stepper);

}  // namespace hvi::gen
