// The commands of hvi-gen and their options, in one table: what is parsed, what --help, the
// completions of shells and the man page say, what excludes what, and which options a generated
// header quotes.
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

/// To come is what CONTRACT.md has and nobody has built: it is refused, and not shown.
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
    std::string_view words;  ///< that stand behind it where options follow: `METHOD [SCENE]`
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

/// What stands behind an option: how it is checked, and what a shell proposes.
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

/// A possible value of an option, and which enumerator it is.
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

/// Other options, named between blanks, and what is said where it is not as with them it should be.
/// In `needs`, one of `SCENE|--hamiltonian` is enough.
struct Relation {
    std::string_view others = {};
    std::string_view what = {};  ///< in place of the usual words; `{}` is the other option
    std::string_view help = {};
};

/// The member of the wishes that an option sets.
using WishMember =
    std::variant<std::monostate, bool StepperWishes::*, Solver StepperWishes::*,
                 Wish<Lanes> StepperWishes::*, Unroll StepperWishes::*,
                 std::optional<Composition> StepperWishes::*, Given StepperWishes::*>;

/// A row. An option may have several, of different commands; in each it means the same.
struct OptionEntry {
    std::string_view name;               ///< `--output`; of a word that stands alone `SCENE`
    std::string_view abbreviation = {};  ///< `-o`
    Commands of = {};                    ///< that take it
    Value value = Value::none;
    std::string_view placeholder = {};     ///< of the value: `FILE`
    std::span<const Choice> choices = {};  ///< where the value is one of them, or some
    WholeRange range = {};                 ///< where the value is a whole number
    std::string_view help = {};            ///< a line; choices are listed behind it
    bool is_repeatable = false;
    Relation needs = {};
    Relation excludes = {};
    WishMember wish = {};
    State state = State::built;

    [[nodiscard]] constexpr bool is_word() const { return !name.starts_with('-'); }
    /// Whether a word belongs to it.
    [[nodiscard]] constexpr bool takes_word() const {
        return value != Value::none && value != Value::mode;
    }
};

/// In the order in which they are shown; a generated header quotes wishes in this order too.
[[nodiscard]] std::span<const OptionEntry> option_table();
[[nodiscard]] std::span<const CommandEntry> command_table();

/// What METHOD is, for people: lines.
[[nodiscard]] std::string_view method_help();

/// The rows of a command.
[[nodiscard]] std::vector<const OptionEntry*> options_of(Command command);
[[nodiscard]] std::vector<const OptionEntry*> options_of(Command command, State state);

/// By its name or abbreviation; null where the command takes no such option.
[[nodiscard]] const OptionEntry* find_option(Command command, std::string_view name);

/// The same. Precondition: the command takes it.
[[nodiscard]] const OptionEntry& option_of(Command command, std::string_view name);

/// Null where there is no command of this name.
[[nodiscard]] const CommandEntry* find_command(std::string_view name);
[[nodiscard]] const CommandEntry& entry_of(Command command);

/// The options that exclude this one or are excluded by it, and are built.
[[nodiscard]] std::vector<const OptionEntry*> not_beside(const OptionEntry& option,
                                                         Command command);

/// `text, json or latex`
[[nodiscard]] std::string names_of(std::span<const Choice> choices);
/// Names of those that are built.
[[nodiscard]] std::vector<std::string_view> built(std::span<const Choice> choices);

/// The help of an option, with its choices.
[[nodiscard]] std::string help_of(const OptionEntry& option);

/// The pieces between separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// How a message speaks of an option: `--solver`; `a scene` where it is the word SCENE.
[[nodiscard]] std::string spoken(std::string_view name);

/// The options of `hvi-gen stepper` that wish the same: ` --compose yoshida:4 --energy`.
[[nodiscard]] std::string options_for(const StepperWishes& wishes,
                                      Command command = Command::stepper);

}  // namespace hvi::gen
