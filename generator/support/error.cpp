// The layout of error messages: what, the place with its caret, help.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/error.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace hvi::gen {

namespace {

constexpr std::size_t text_columns = 64;      ///< the user's text around a caret
constexpr std::size_t name_columns = 60;      ///< the name of that text
constexpr std::size_t wording_columns = 500;  ///< `error:` and `help:`, which may quote the user
constexpr std::size_t quoted_columns = 80;    ///< a word in them, or a text in backticks
constexpr std::string_view cut_mark = "...";

/// Returns the bytes of the UTF-8 character that `text` starts with, or 0 when it starts with none.
std::size_t character_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < 0x80) return 1;
    if (lead < 0xc2 || lead > 0xf4) return 0;
    const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    const std::string_view tail = text.substr(1, length - 1);
    const bool whole =
        tail.size() == length - 1 && std::all_of(tail.begin(), tail.end(), [](char byte) {
            return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
        });
    return whole ? length : 0;
}

/// Returns the character to show in one column of the terminal. Only characters that surely take
/// one column are kept: ASCII, and Latin, Greek and Cyrillic letters. A terminal may act on
/// anything else, or give it two columns or none, so that the caret below would point elsewhere.
std::string_view glyph(std::string_view character) {
    const auto lead = static_cast<unsigned char>(character.front());
    if (character == "\t" || character == "\n" || character == "\r") return " ";
    if (character.size() == 1) return lead >= 0x20 && lead < 0x7f ? character : "?";
    if (character.size() > 2) return "?";
    const unsigned code = (lead & 0x1fU) << 6U | (static_cast<unsigned char>(character[1]) & 0x3fU);
    const bool letter =
        (code >= 0xa1 && code < 0x300 && code != 0xad) || (code >= 0x370 && code < 0x483);
    return letter ? character : "?";
}

/// A text in columns of a terminal.
class Columns {
public:
    explicit Columns(std::string_view text) {
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t length = std::max<std::size_t>(character_length(text.substr(at)), 1);
            glyphs_.push_back(glyph(text.substr(at, length)));
            begins_.push_back(at);
            at += length;
        }
        begins_.push_back(text.size());
    }

    [[nodiscard]] std::size_t size() const { return glyphs_.size(); }

    /// Returns the column of a byte of the text; size() for its end.
    [[nodiscard]] std::size_t of_byte(std::size_t byte) const {
        const auto after =
            std::upper_bound(begins_.begin(), begins_.end(), std::min(byte, begins_.back()));
        return static_cast<std::size_t>(after - begins_.begin()) - 1;
    }

    [[nodiscard]] std::string text(std::size_t begin, std::size_t end) const {
        std::string result;
        for (std::size_t column = begin; column < end; ++column) result += glyphs_[column];
        return result;
    }

private:
    std::vector<std::string_view> glyphs_;
    std::vector<std::size_t> begins_;  ///< the byte at which each column starts, and the text's end
};

/// Shortens a long name in its middle: its end distinguishes files of one directory.
std::string shown_quotation(std::string_view text) {
    constexpr std::size_t tail = quoted_columns / 4;
    const Columns columns(text);
    const std::size_t size = columns.size();
    if (size <= quoted_columns) return columns.text(0, size);
    return columns.text(0, quoted_columns - tail).append(cut_mark) +
           columns.text(size - tail, size);
}

/// Shortens each word, and each text in backticks.
std::string with_short_quotations(std::string_view text) {
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t close =
            text[begin] == '`' ? text.find('`', begin + 1) : std::string_view::npos;
        const std::size_t word = std::min(text.find_first_of(" \n`", begin), text.size());
        const std::size_t end =
            close != std::string_view::npos ? close + 1 : std::max(word, begin + 1);
        result += shown_quotation(text.substr(begin, end - begin));
        begin = end;
    }
    return result;
}

/// Returns wording on one line of bounded length.
std::string wording(std::string_view whole) {
    const std::string text = with_short_quotations(whole);
    const Columns columns(text);
    if (columns.size() <= wording_columns) return columns.text(0, columns.size());
    return columns.text(0, wording_columns).append(cut_mark);
}

/// Returns the name of a source. A long one keeps its end, which distinguishes files of one
/// directory.
std::string shown_name(std::string_view name) {
    const Columns columns(name);
    if (columns.size() <= name_columns) return columns.text(0, columns.size());
    return std::string(cut_mark) + columns.text(columns.size() - name_columns, columns.size());
}

/// Returns the place within its line, for a text that is lines of a file, as `scene.toml:5` and the
/// lines after it.
Place in_its_line(const Place& place) {
    const auto& [name, text] = *place.source;
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const bool in_file =
        digits > 0 && name[digits - 1] == ':' && digits < name.size() && name.size() - digits < 9;
    const std::size_t before = text.substr(0, place.range.begin).rfind('\n');
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (!in_file || (begin == 0 && end == text.size())) return place;
    const auto breaks =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    const std::string number = std::to_string(std::stol(name.substr(digits)) + breaks);
    return {std::make_shared<const Source>(
                Source{name.substr(0, digits) + number, text.substr(begin, end - begin)}),
            {place.range.begin - begin, std::min(place.range.end, end) - begin}};
}

/// Returns the line with the user's text and the line with the caret below it.
std::string place_lines(const Place& whole) {
    const Place place = in_its_line(whole);
    const Columns columns(place.source->text);
    const Range range = place.range;
    const std::size_t caret = columns.of_byte(range.begin);
    const std::size_t last = range.end > range.begin ? columns.of_byte(range.end - 1) : caret;

    const std::size_t context = text_columns / 2;
    const std::size_t latest = columns.size() - std::min(columns.size(), text_columns);
    const std::size_t begin = std::min(caret - std::min(caret, context), latest);
    const std::size_t end = std::min(begin + text_columns, columns.size());
    const std::string_view before = begin > 0 ? cut_mark : "";
    const std::string_view after = end < columns.size() ? cut_mark : "";

    const std::string head = "  " + shown_name(place.source->name) + ": ";
    const std::size_t indent = Columns(head).size() + before.size() + (caret - begin);
    const std::size_t underlined = std::min(last, std::max(end, caret + 1) - 1) - caret;

    std::string lines = head;
    lines.append(before).append(columns.text(begin, end)).append(after).append("\n");
    lines.append(indent, ' ').append("^").append(underlined, '~').append("\n");
    return lines;
}

}  // namespace

Given given(std::string name, std::string text) {
    return std::make_shared<const Source>(Source{std::move(name), std::move(text)});
}

Place whole(std::shared_ptr<const Source> source) {
    const std::size_t size = source->text.size();
    return {std::move(source), {0, size}};
}

/// NOTE: a place without a text is dropped.
Error::Error(ExitStatus status, std::string what, std::optional<Place> place, std::string help)
    : std::runtime_error(std::move(what)),
      status_(status),
      place_(place && place->source == nullptr ? std::nullopt : std::move(place)),
      help_(std::move(help)) {}

MathError::MathError(std::string what, std::optional<Place> place, std::string help)
    : Error(ExitStatus::mathematics, std::move(what), std::move(place), std::move(help)) {}

InputError::InputError(std::string what, std::optional<Place> place, std::string help)
    : Error(ExitStatus::input, std::move(what), std::move(place), std::move(help)) {}

EnvironmentError::EnvironmentError(std::string what, std::string help)
    : Error(ExitStatus::environment, std::move(what), {}, std::move(help)) {}

Interruption::Interruption() : Error(ExitStatus::interrupted, "interrupted", {}, {}) {}

InternalError::InternalError(std::string what)
    : Error(ExitStatus::bug, "internal error: " + std::move(what), {},
            "this is a bug of hvi-gen; please report it with the command that led here") {}

std::string message(const Error& error) {
    std::string text = "error: " + wording(error.what()) + "\n";
    if (error.place()) text += place_lines(*error.place());
    if (!error.help().empty()) text += "help: " + wording(error.help()) + "\n";
    return text;
}

void check_failed(const char* condition, const char* file, int line) {
    throw InternalError(std::string("`") + condition + "` does not hold (" + file + ":" +
                        std::to_string(line) + ")");
}

}  // namespace hvi::gen
