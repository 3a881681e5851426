// Joins words to a command line, and finds them again.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/command_line.hpp"

#include <algorithm>

namespace hvi::gen {

namespace {

std::string_view name_of(std::string_view word) { return word.substr(0, word.find('=')); }

/// Quotes a word as one would type it, so that blanks do not seem to end it.
std::string quoted(const std::string& word) {
    const bool plain =
        !word.empty() && word.find_first_of(" \t\n\"'$*()[]{};&|<>\\") == std::string::npos;
    return plain ? word : "\"" + word + "\"";
}

}  // namespace

CommandLine::CommandLine(int argc, const char* const* argv)
    : words_(argv + std::min(argc, 1), argv + argc) {
    std::string line = "hvi-gen";
    for (const std::string& word : words_) {
        line += " ";
        const std::size_t begin = line.size();
        line += quoted(word);
        ranges_.push_back({begin, line.size()});
    }
    source_ = std::make_shared<const Source>(Source{"command line", std::move(line)});
}

Place CommandLine::place(const std::vector<std::string>& names, std::size_t n) const {
    const auto is_named = [&](std::string_view word) {
        return std::find(names.begin(), names.end(), word) != names.end();
    };
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (!is_named(words_[i]) && !is_named(name_of(words_[i]))) continue;
        if (n == 0) return {source_, ranges_[i]};
        --n;
    }
    return {source_, {0, source_->text.size()}};
}

Place CommandLine::end() const {
    const std::size_t size = source_->text.size();
    return {source_, {size, size}};
}

}  // namespace hvi::gen
