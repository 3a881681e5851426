// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/generator/fuzz/grammar.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hvi::gen::fuzz {

namespace {

/// Returns the text before the mark, and removes both.
std::string_view cut(std::string_view& text, std::string_view mark) {
    const std::size_t end = std::min(text.find(mark), text.size());
    const std::string_view before = text.substr(0, end);
    text.remove_prefix(std::min(end + mark.size(), text.size()));
    return before;
}

}  // namespace

Grammar::Grammar(std::string_view rules) {
    constexpr std::string_view continued = "\n    | ";
    std::string text(rules);
    for (std::size_t at = text.find(continued); at != std::string::npos; at = text.find(continued))
        text.replace(at, continued.size(), " | ");
    for (std::string_view lines = text; !lines.empty();) {
        const std::string_view line = cut(lines, "\n");
        if (!line.empty()) add_rule(line);
    }
    for (const auto& [name, alternatives] : rules_)
        for (const Alternative& alternative : alternatives)
            for (const Part& part : alternative)
                if (part.is_name && rules_.count(part.text) == 0)
                    throw std::logic_error("no rule for <" + part.text + ">");
}

void Grammar::add_rule(std::string_view line) {
    const std::string name(cut(line, ": "));
    if (first_.empty()) first_ = name;
    std::vector<Alternative>& alternatives = rules_[name];
    while (!line.empty()) {
        Alternative& parts = alternatives.emplace_back();
        for (std::string_view left = cut(line, " | "); !left.empty() && left != "_";) {
            std::string text(cut(left, "<"));
            std::replace(text.begin(), text.end(), '~', '\n');
            if (!text.empty()) parts.push_back({false, std::move(text)});
            if (!left.empty()) parts.push_back({true, std::string(cut(left, ">"))});
        }
    }
}

/// One text in the making.
class Grammar::Derivation {
public:
    Derivation(const Grammar& grammar, std::string_view choices)
        : grammar_(grammar), choices_(choices) {}

    std::string text_of(const std::string& name) {
        if (name.front() != '$') return chosen(name);
        const auto known = fixed_.find(name);
        return known != fixed_.end() ? known->second : fixed_[name] = chosen(name);
    }

private:
    std::string chosen(const std::string& name) {
        const auto& alternatives = grammar_.rules_.at(name);
        std::string text;
        for (const Part& part : alternatives[choice() % alternatives.size()])
            text += part.is_name ? text_of(part.text) : part.text;
        return text;
    }

    std::size_t choice() {
        if (choices_.empty()) return 0;
        const auto byte = static_cast<unsigned char>(choices_.front());
        choices_.remove_prefix(1);
        return byte;
    }

    const Grammar& grammar_;
    std::string_view choices_;
    std::map<std::string, std::string> fixed_;
};

std::string Grammar::derive(std::string_view choices) const {
    constexpr std::size_t most_choices = 1000;  // so that texts are short and not deep
    return Derivation(*this, choices.substr(0, most_choices)).text_of(first_);
}

}  // namespace hvi::gen::fuzz
