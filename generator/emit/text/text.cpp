// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/text/text.hpp"

#include <algorithm>
#include <set>

#include "generator/emit/text/embedded.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Returns where to break a line of at most `room` columns: before a binary operator, else at a
/// blank. The result is the position of the blank; npos when there is none.
std::size_t break_at(std::string_view text, std::size_t room) {
    for (std::size_t i = std::min(room, text.size() - 1); i > 0; --i) {
        const bool is_operator =
            i + 2 < text.size() && text[i + 2] == ' ' && (text[i + 1] == '+' || text[i + 1] == '-');
        if (text[i] == ' ' && is_operator) { return i; }
    }
    const std::size_t blank = text.rfind(' ', room);
    return blank == 0 ? std::string_view::npos : blank;
}

/// Returns where to break a comment. A closed form has no blanks; it is broken before an operator.
std::size_t break_comment_at(std::string_view text, std::size_t room) {
    const std::size_t blank = text.rfind(' ', room);
    if (blank != std::string_view::npos && blank > 0) { return blank; }
    const std::size_t sign = text.find_last_of("+-*/", room);
    return sign == std::string_view::npos || sign == 0 ? room : sign;
}

std::string_view without_leading_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

std::string_view without_trailing_blanks(std::string_view text) {
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// Returns a line of a comment without a backslash at its end, or its trigraph, which would join
/// the next line to it.
std::string_view without_splice(std::string_view line) {
    for (const std::string_view splice : {"\\", "?\?/"}) {
        const std::string_view text = without_trailing_blanks(line);
        const std::size_t begin = text.size() - std::min(text.size(), splice.size());
        if (text.substr(begin) == splice) {
            return without_splice(without_trailing_blanks(text.substr(0, begin)));
        }
    }
    return line;
}

/// Returns a statement in lines. All lines but the first have four columns less.
std::vector<std::string_view> broken(std::string_view statement, std::size_t room) {
    std::vector<std::string_view> lines;
    while (statement.size() > room) {
        const std::size_t end = break_at(statement, room);
        if (end == std::string_view::npos) { break; }
        if (lines.empty()) { room -= 4; }
        lines.push_back(statement.substr(0, end));
        statement.remove_prefix(end + 1);
    }
    lines.push_back(statement);
    return lines;
}

struct Template {
    std::set<std::string_view> declared;
    std::string_view body;
};

Template parse(std::string_view text) {
    constexpr std::string_view mark = "//@";
    constexpr std::string_view hole = "//@   ";
    Template result;
    while (text.substr(0, mark.size()) == mark) {
        const std::size_t end = text.find('\n');
        HVI_CHECK(end != std::string_view::npos);
        const std::string_view line = text.substr(0, end);
        if (line.substr(0, hole.size()) == hole) {
            const std::string_view rest = line.substr(hole.size());
            result.declared.insert(rest.substr(0, rest.find(' ')));
        }
        text.remove_prefix(end + 1);
    }
    result.body = text;
    return result;
}

/// Returns the lines of `value`, all but the first after `indentation` blanks unless they are
/// empty.
std::string indented(std::string_view value, std::size_t indentation) {
    std::string result;
    for (const char c : value) {
        if (c != '\n' && !result.empty() && result.back() == '\n') {
            result.append(indentation, ' ');
        }
        result += c;
    }
    return result;
}

std::string fill_line(std::string_view line, const Holes& holes, std::set<std::string_view>& used) {
    std::string result;
    for (std::size_t at = line.find('@'); at != std::string_view::npos; at = line.find('@')) {
        const std::size_t end = line.find('@', at + 1);
        HVI_CHECK(end != std::string_view::npos);
        const auto found = holes.find(line.substr(at + 1, end - at - 1));
        HVI_CHECK(found != holes.end());
        used.insert(found->first);
        const bool alone = line.find_first_not_of(' ') == at && line.find_last_not_of(' ') == end;
        if (alone && found->second.empty()) { return {}; }
        result += line.substr(0, at);
        result += alone ? indented(found->second, at) : found->second;
        line.remove_prefix(end + 1);
    }
    result += line;
    return result + '\n';
}

std::string shortest(auto value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) { text += ".0"; }
    return text;
}

/// Returns the text without double empty lines, and without an empty line before a brace, which
/// holes that take their lines away may leave.
std::string tidy(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool after_blank = result.size() >= 2 && result.substr(result.size() - 2) == "\n\n";
        const bool closes = without_leading_blanks(text.substr(i)).substr(0, 1) == "}";
        if (after_blank && text[i] == '\n') { continue; }
        if (after_blank && closes && text[i] == ' ') { result.pop_back(); }
        result += text[i];
    }
    return result;
}

}  // namespace

Writer& Writer::close(std::string_view text) {
    HVI_CHECK(depth_ > 0);
    --depth_;
    write(text);
    return *this;
}

Writer& Writer::blank() {
    text_ += '\n';
    return *this;
}

void Writer::write(std::string_view statement) {
    std::vector<std::string_view> lines = broken(statement, room());
    const std::size_t code = std::min(statement.find("//"), statement.size());
    const std::string_view beside = statement.substr(code);
    // NOTE: the second line of a comment would be code.
    if (lines.size() > 1 && lines.back().size() <= beside.size()) {
        comment(without_leading_blanks(beside.substr(2)));
        lines = broken(without_trailing_blanks(statement.substr(0, code)), room());
    }
    std::size_t extra = 0;
    for (const std::string_view line : lines) {
        text_.append(indentation() + extra, ' ').append(line) += '\n';
        extra = 4;
    }
}

Writer& Writer::insert(std::string_view lines) {
    if (lines.empty()) { return *this; }
    text_ += std::string(indentation(), ' ') + indented(lines, indentation()) + '\n';
    return *this;
}

Writer& Writer::comment(std::string_view text, std::string_view mark, std::size_t hang) {
    std::size_t extra = 0;
    while (true) {
        const std::size_t width = room() - mark.size() - extra;
        const bool fits = text.size() <= width;
        const std::size_t end = fits ? text.size() : break_comment_at(text, width);
        text_.append(indentation(), ' ').append(mark).append(extra, ' ');
        text_.append(without_splice(text.substr(0, end))) += '\n';
        if (fits) { return *this; }
        text = without_leading_blanks(text.substr(end));
        extra = hang;
    }
}

std::string Writer::str() const {
    HVI_CHECK(depth_ == 0);
    return text_.empty() ? text_ : text_.substr(0, text_.size() - 1);
}

std::string exact_text(const Number& number) {
    if (const auto form = number.closed_form()) { return to_text(*form); }
    return number.decimal(40) + "...";
}

std::string literal(double value) { return shortest(value); }
std::string literal(float value) { return shortest(value) + "f"; }

std::string_view embedded_template(std::string_view name) {
    for (const EmbeddedFile& file : embedded_templates()) {
        if (file.name == name) { return file.text; }
    }
    HVI_CHECK(false);
    return {};
}

std::string text_literal(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const bool is_plain = ' ' <= c && c <= '~' && c != '"' && c != '\\' && c != '?';
        result +=
            is_plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
    return result + '"';
}

std::string fill(std::string_view template_name, const Holes& holes) {
    const Template source = parse(embedded_template(template_name));
    std::set<std::string_view> used;
    std::string result;
    for (std::string_view rest = source.body; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        HVI_CHECK(end != std::string_view::npos);
        result += fill_line(rest.substr(0, end), holes, used);
        rest.remove_prefix(end + 1);
    }
    HVI_CHECK(used == source.declared);
    HVI_CHECK(used.size() == holes.size());
    return tidy(result);
}

std::string fill_part(std::string_view template_name, const Holes& holes) {
    std::string text = fill(template_name, holes);
    text.pop_back();
    return text;
}

}  // namespace hvi::gen
