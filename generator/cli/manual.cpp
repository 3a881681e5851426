// `hvi-gen manual`: the man page.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/cli/proposals.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

/// Escapes a text for troff: a hyphen stays the character that is typed.
std::string roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    // NOTE: a period or a quote at the beginning of a line would be a request.
    return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// Returns `-o, --output FILE`.
std::string heading(const OptionEntry& option) {
    if (option.is_word()) return italic(option.placeholder);
    std::string text = bold(option.name);
    if (!option.abbreviation.empty()) text = bold(option.abbreviation) + ", " + text;
    if (option.takes_word()) text += " " + italic(option.placeholder);
    if (option.value == Value::mode) text += "[=" + italic(option.placeholder) + "]";
    return text;
}

/// Describes the options that an option needs or excludes.
std::string relations(const OptionEntry& option, Command command) {
    std::string needs, excludes;
    for (const std::string_view needed : split(option.needs.others, ' ')) {
        std::string names;
        for (const std::string_view other : split(needed, '|'))
            names += (names.empty() ? "" : " or ") + spoken(other);
        needs += (needs.empty() ? "; needs " : " and ") + names;
    }
    for (const OptionEntry* other : not_beside(option, command))
        excludes += (excludes.empty() ? "; not beside " : ", ") + spoken(other->name);
    return roff(needs + excludes);
}

/// Returns the words behind hvi-gen: `tableau METHOD`.
std::string usage(const CommandEntry& entry) {
    return bold(entry.name) + (entry.words.empty() ? "" : " " + italic(entry.words));
}

std::string section(const CommandEntry& entry) {
    std::string text = fmt::format(".SS {}\n{}.\n", usage(entry), roff(entry.help));
    for (const OptionEntry* option : options_of(entry.command, State::built))
        text += fmt::format(".TP\n{}\n{}{}.\n", heading(*option), roff(help_of(*option)),
                            relations(*option, entry.command));
    return text;
}

}  // namespace

void run(const ManualOptions& options) {
    std::string synopsis, commands, method;
    for (const CommandEntry& entry : built_commands()) {
        synopsis +=
            fmt::format(".br\n{} {} [{}]...\n", bold("hvi-gen"), usage(entry), italic("OPTION"));
        commands += section(entry);
    }
    for (const std::string_view line : split(method_help(), '\n')) method += roff(line) + "\n";
    for (std::string* text : {&synopsis, &commands, &method}) text->pop_back();
    write_result(options.output, fill("manual.1.in", {{"version", std::string(version)},
                                                      {"synopsis", synopsis},
                                                      {"commands", commands},
                                                      {"method", method}}));
}

}  // namespace hvi::gen
