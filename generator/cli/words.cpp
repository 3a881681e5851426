// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/words.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// Returns the number that the whole text is.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
    Number number{};
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    return error == std::errc{} && end == last ? std::optional(number) : std::nullopt;
}

}  // namespace

Place Words::place(std::string_view option, std::size_t n) const {
    const OptionEntry& entry = option_of(command_, option);
    if (entry.is_word()) return line_.place({values(option).at(n)});
    std::vector<std::string> names{std::string(entry.name)};
    if (!entry.abbreviation.empty()) names.emplace_back(entry.abbreviation);
    return line_.place(names, n);
}

std::vector<Given> Words::texts(std::string_view option) const {
    std::vector<Given> texts;
    for (const std::string& value : values(option))
        texts.push_back(given(std::string(option), value));
    return texts;
}

Given Words::value(std::string_view option) const {
    const std::vector<Given> all = texts(option);
    return all.empty() ? nullptr : all.front();
}

Given Words::file(std::string_view option) const {
    Given file = value(option);
    if (file && file->text.empty())
        throw InputError(std::string(option) + " needs the name of a file", place(option));
    return file;
}

std::optional<int> Words::whole_number(std::string_view option) const {
    const Given text = value(option);
    if (!text) return {};
    const auto [least, most] = option_of(command_, option).range;
    const auto number = number_in<int>(text->text);
    if (!number || *number < least || *number > most)
        throw InputError(std::string(option) + " takes a whole number from " +
                             std::to_string(least) + " to " + std::to_string(most),
                         whole(text));
    return number;
}

std::optional<double> Words::fraction(std::string_view option) const {
    const Given text = value(option);
    if (!text) return {};
    const auto number = number_in<double>(text->text);
    if (!number || !(*number > 0 && *number < 1))
        throw InputError(std::string(option) + " takes a positive number below 1", whole(text),
                         "for example 1e-8");
    return number;
}

void refuse_to_come(std::string_view name, const Place& place) {
    throw InputError(std::string(name) + " is to come", place, "it is planned, and not built yet");
}

const Choice* Words::chosen_of(std::string_view option, const Given& text) const {
    if (!text) return nullptr;
    const OptionEntry& entry = option_of(command_, option);
    for (const Choice& choice : entry.choices) {
        if (choice.name != text->text) continue;
        if (choice.state == State::to_come) refuse_to_come(choice.name, whole(text));
        return &choice;
    }
    throw InputError(
        "no such value of " + std::string(option) + ": `" + text->text + "`", whole(text),
        did_you_mean(text->text, built(entry.choices), "one of " + names_of(entry.choices)));
}

std::vector<Given> list_items(const Given& list) {
    const std::string& text = list->text;
    std::vector<Given> items;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        std::string item = text.substr(begin, end - begin);
        item.erase(0, item.find_first_not_of(' '));
        item.erase(item.find_last_not_of(' ') + 1);
        if (item.empty())
            throw InputError("an item is missing in this list", Place{list, {begin, end}});
        items.push_back(given(list->name, std::move(item)));
        begin = end + 1;
    }
    return items;
}

}  // namespace hvi::gen
