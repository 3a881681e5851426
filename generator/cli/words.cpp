// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// The number that the whole of a text is.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
    Number number{};
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    return error == std::errc{} && end == last ? std::optional(number) : std::nullopt;
}

}  // namespace

void Words::check_values() const {
    for (const CLI::Option* option : command_.get_options()) {
        const auto& values = option->results();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string word = values[i].substr(0, values[i].find('='));
            if (word.starts_with("-") && command_.get_option_no_throw(word))
                throw InputError(option->get_name() + " needs a value",
                                 place(option->get_name(), i));
        }
    }
}

Place Words::place(const std::string& option, std::size_t n) const {
    std::vector<std::string> names;
    for (const std::string& name : command_.get_option(option)->get_snames())
        names.push_back("-" + name);
    for (const std::string& name : command_.get_option(option)->get_lnames())
        names.push_back("--" + name);
    return line_.place(names, n);
}

std::vector<Given> Words::texts(const std::string& option) const {
    std::vector<Given> texts;
    for (const std::string& value : values(option)) texts.push_back(given(option, value));
    return texts;
}

Given Words::value(const std::string& option) const {
    const std::vector<Given> all = texts(option);
    if (all.size() > 1) throw InputError(option + " is given twice", place(option, 1));
    return all.empty() ? nullptr : all.front();
}

bool Words::flag(const std::string& option) const {
    for (const std::string& value : command_.get_option(option)->results())
        if (value != "true") throw InputError(option + " takes no value", place(option));
    return command_.count(option) > 0;
}

void Words::one_form_of(const OptionGroups& groups) const {
    const std::string* first = nullptr;
    for (const auto& group : groups) {
        const std::string* here = nullptr;
        for (const std::string& option : group)
            if (!here && !values(option).empty()) here = &option;
        if (first && here)
            throw InputError(*first + " and " + *here + " each give a method", place(*here),
                             "leave one of them out");
        if (here) first = here;
    }
}

std::optional<int> Words::number(const std::string& option, int least, int most) const {
    const Given text = value(option);
    if (!text) return {};
    const auto number = number_in<int>(text->text);
    if (!number || *number < least || *number > most)
        throw InputError(option + " takes a whole number from " + std::to_string(least) + " to " +
                             std::to_string(most),
                         whole(text));
    return number;
}

std::optional<double> Words::fraction(const std::string& option) const {
    const Given text = value(option);
    if (!text) return {};
    const auto number = number_in<double>(text->text);
    if (!number || !(*number > 0 && *number < 1))
        throw InputError(option + " takes a positive number below 1", whole(text),
                         "for example 1e-8");
    return number;
}

std::size_t Words::choice(const std::string& option,
                          const std::vector<std::string_view>& choices) const {
    const Given text = value(option);
    if (!text) return 0;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (choices[i] == text->text) return i;
    }
    std::string all;
    for (const std::string_view each : choices) all.append(all.empty() ? "" : ", ").append(each);
    throw InputError("no such value of " + option + ": `" + text->text + "`", whole(text),
                     did_you_mean(text->text, choices, "one of " + all));
}

std::set<std::string> Words::chosen(const std::string& option,
                                    const std::vector<std::string_view>& choices) const {
    const Given list = value(option);
    std::set<std::string> chosen;
    if (!list) return chosen;
    const std::string all = fmt::format("{}", fmt::join(choices, ", "));
    for (const auto& item : list_items(list)) {
        if (std::find(choices.begin(), choices.end(), item->text) == choices.end())
            throw InputError("no such item of " + option + ": `" + item->text + "`", whole(item),
                             did_you_mean(item->text, choices, "some of " + all));
        chosen.insert(item->text);
    }
    return chosen;
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
