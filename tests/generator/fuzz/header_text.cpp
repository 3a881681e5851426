// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/generator/fuzz/header_text.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "tests/generator/fuzz/attempt.hpp"

namespace hvi::gen::fuzz {

namespace {

bool is_in(const std::set<std::string_view>& words, std::string_view word) {
    return words.count(word) != 0;
}

const std::set<std::string_view> keywords{
    "and",      "auto",   "bool",   "break",    "case",    "catch",   "char",     "class",
    "const",    "delete", "double", "else",     "enum",    "export",  "extern",   "false",
    "float",    "for",    "friend", "goto",     "if",      "inline",  "int",      "long",
    "mutable",  "new",    "not",    "nullptr",  "or",      "private", "public",   "register",
    "requires", "return", "short",  "signed",   "sizeof",  "static",  "struct",   "switch",
    "template", "this",   "throw",  "true",     "try",     "typedef", "typename", "union",
    "unsigned", "using",  "void",   "volatile", "wchar_t", "while",   "xor"};

/// Macros of <cmath>, <cstdio>, <cerrno>, <cassert>, and of compilers.
const std::set<std::string_view> macros{
    "M_PI",   "M_E",      "NAN",   "INFINITY", "HUGE_VAL", "FP_NAN",     "EOF", "NULL", "errno",
    "assert", "offsetof", "linux", "unix",     "stdout",   "MATH_ERRNO", "GM",  "LZ",   "I"};

/// Returns lines without comments and preprocessor directives. Texts in quotes stay.
std::vector<std::string> code_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        require(line.empty() || line.back() != '\\' || line.find("//") == std::string::npos,
                "a comment that takes the next line in");
        line.resize(std::min(line.find("//"), line.size()));
        line.resize(line.find_last_not_of(' ') + 1);
        if (!line.empty() && line.front() != '#') lines.push_back(line);
    }
    return lines;
}

std::size_t indent(const std::string& line) { return line.find_first_not_of(' '); }

/// A line behind the end of a statement is no deeper than this began: else it belongs to something
/// that has been torn, as a comment may be.
void check_indents(const std::vector<std::string>& lines) {
    std::size_t deepest = 0;
    bool begins = true;  // a statement
    for (const std::string& line : lines) {
        if (begins) {
            require(indent(line) <= deepest, "a line that belongs to nothing");
            deepest = indent(line);
        }
        const bool is_label = line.ends_with("public:") || line.ends_with("private:") ||
                              line.find("case ") != std::string::npos;
        begins = is_label || line.ends_with(';') || line.ends_with('}') || line.ends_with('{');
        if (is_label || line.ends_with('{')) deepest += 4;
    }
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Words, numbers, texts in quotes, and single other characters.
std::vector<std::string> tokens_of(const std::vector<std::string>& lines) {
    std::vector<std::string> tokens;
    for (const std::string& line : lines) {
        for (std::size_t i = 0; i < line.size();) {
            std::size_t end = i + 1;
            if (line[i] == '"') {
                end = std::min(line.find('"', i + 1), line.size() - 1) + 1;
            } else if (is_word(line[i])) {
                const bool is_number = std::isdigit(static_cast<unsigned char>(line[i])) != 0;
                const auto goes_on = [&](char c) {
                    const char before = line[end - 1];
                    const bool has_exponent = before == 'e' || before == 'p';
                    return is_word(c) ||
                           (is_number && (c == '.' || (has_exponent && (c == '+' || c == '-'))));
                };
                while (end < line.size() && goes_on(line[end])) ++end;
            }
            if (line[i] != ' ') tokens.push_back(line.substr(i, end - i));
            i = end;
        }
    }
    return tokens;
}

void check_brackets(const std::vector<std::string>& tokens) {
    std::string open;
    for (const std::string& token : tokens) {
        if (token == "(") open += ')';
        if (token == "[") open += ']';
        if (token == "{") open += '}';
        if (token != ")" && token != "]" && token != "}") continue;
        require(!open.empty() && open.back() == token.front(), "brackets do not match");
        open.pop_back();
    }
    require(open.empty(), "a bracket stays open");
}

/// Each token with its neighbours.
void check_words(const std::vector<std::string>& tokens) {
    std::string before;
    for (std::size_t i = 0; i < tokens.size(); before = tokens[i++]) {
        const std::string& token = tokens[i];
        const std::string after = i + 1 < tokens.size() ? tokens[i + 1] : "";
        const bool is_number = std::isdigit(static_cast<unsigned char>(token.front())) != 0;
        const bool is_behind_word = !before.empty() && is_word(before.back());
        const bool may_be_number = !is_behind_word && before != ";" && before != "}";
        require(!is_number || may_be_number || before == "return" || before == "case",
                "a number where there can be none");
        require(!is_in(macros, token), "a name that is a macro of the standard library");
        const bool is_parameter = before == "<" || before == ",";  // template <class, class = void>
        if (is_in(keywords, token) && token != "template" && !is_parameter)
            require(before != "." && after != "=", "a keyword as a name");
    }
}

}  // namespace

void check_header(std::string_view text) {
    require(text.ends_with('\n') && text.find("#pragma once") != std::string_view::npos,
            "no whole header");
    const std::vector<std::string> lines = code_lines(text);
    check_indents(lines);
    const std::vector<std::string> tokens = tokens_of(lines);
    check_brackets(tokens);
    check_words(tokens);
}

}  // namespace hvi::gen::fuzz
