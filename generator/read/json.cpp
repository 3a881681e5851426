// Reads JSON. nlohmann/json decides on its grammar. Its events have no places, and its numbers are
// doubles; but the accepted words are easily found again in the text, which has both.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace hvi::gen {

namespace {

using Kind = JsonValue::Kind;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Finds the words of a text in their order. Precondition: the text is JSON as far as words are
/// asked for.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    Range next() {
        const std::size_t begin = text_.find_first_not_of(" \t\r\n,:", end_);
        HVI_CHECK(begin != std::string_view::npos);
        const bool is_sign = std::string_view("[]{}").find(text_[begin]) != std::string_view::npos;
        end_ = is_sign ? begin + 1
               : text_[begin] == '"'
                   ? end_of_text(begin + 1)
                   : std::min(text_.find_first_of(" \t\r\n,:]}", begin), text_.size());
        return {begin, end_};
    }

private:
    [[nodiscard]] std::size_t end_of_text(std::size_t position) const {
        for (; position < text_.size() && text_[position] != '"'; ++position) {
            if (text_[position] == '\\') { ++position; }
        }
        return position + 1;
    }

    std::string_view text_;
    std::size_t end_ = 0;
};

/// Returns the message of nlohmann/json without its position and without the name of its error.
std::string wording(std::string_view message) {
    const std::size_t column = message.find(", column ");
    const std::size_t begin = message.find(column == std::string_view::npos ? "] " : ": ",
                                           column == std::string_view::npos ? 0 : column);
    return std::string(message.substr(begin == std::string_view::npos ? 0 : begin + 2));
}

/// Builds the value from the events of nlohmann/json, which prescribes the names of the functions.
class Builder {
public:
    Builder(const JsonFile& file, std::string_view text) : file_(file), text_(text), words_(text) {}

    JsonValue result() { return std::move(root_); }

    bool null() { return add(Kind::null, {}); }
    bool boolean(bool /*value*/) { return add(Kind::boolean, {}); }
    bool number_integer(nlohmann::json::number_integer_t /*value*/) { return number(); }
    bool number_unsigned(nlohmann::json::number_unsigned_t /*value*/) { return number(); }
    bool number_float(nlohmann::json::number_float_t /*value*/, const std::string& /*text*/) {
        return number();
    }
    bool string(std::string& value) { return add(Kind::text, std::move(value)); }
    bool binary(nlohmann::json::binary_t& /*value*/) { return false; }  // there is none in a text
    bool start_array(std::size_t /*size*/) { return open(Kind::array); }
    bool end_array() { return close(); }
    bool start_object(std::size_t /*size*/) { return open(Kind::object); }
    bool end_object() {
        check_keys(*open_.back());
        return close();
    }
    bool key(std::string& name) {
        open_.back()->members.push_back({std::move(name), words_.next(), {}});
        return true;
    }
    [[noreturn]] bool parse_error(std::size_t position, const std::string& /*last*/,
                                  const nlohmann::json::exception& error) {
        const std::size_t last = std::min(std::max<std::size_t>(position, 1) - 1, text_.size());
        throw InputError(fmt::format("this is no JSON: {}", wording(error.what())),
                         file_.place({last, std::min(last + 1, text_.size())}));
    }

private:
    bool number() {
        const Range range = words_.next();
        place(Kind::number, std::string(text_.substr(range.begin, range.end - range.begin)), range);
        return true;
    }

    bool add(Kind kind, std::string text) {
        place(kind, std::move(text), words_.next());
        return true;
    }

    JsonValue& place(Kind kind, std::string text, Range range) {
        if (++values_ > JsonFile::most_values) {
            throw InputError(fmt::format("the file has more than {} values", JsonFile::most_values),
                             file_.place(range));
        }
        JsonValue& slot = open_.empty()                    ? root_
                          : open_.back()->is(Kind::object) ? open_.back()->members.back().value
                                                           : open_.back()->items.emplace_back();
        slot.kind = kind;
        slot.text = std::move(text);
        slot.range = range;
        return slot;
    }

    bool open(Kind kind) {
        const Range range = words_.next();
        if (open_.size() == JsonFile::most_depth) {
            throw InputError(fmt::format("the file is nested deeper than {}", JsonFile::most_depth),
                             file_.place(range));
        }
        // NOTE: open values keep their addresses: a list grows only after all values in it are
        // closed.
        open_.push_back(&place(kind, {}, range));
        return true;
    }

    bool close() {
        open_.back()->range.end = words_.next().end;
        open_.pop_back();
        return true;
    }

    void check_keys(const JsonValue& object) const {
        std::vector<const JsonMember*> sorted;
        for (const JsonMember& member : object.members) { sorted.push_back(&member); }
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](const auto* a, const auto* b) { return a->key < b->key; });
        const auto same =
            std::adjacent_find(sorted.begin(), sorted.end(),
                               [](const auto* a, const auto* b) { return a->key == b->key; });
        if (same == sorted.end()) { return; }
        throw InputError(fmt::format("`{}` is given twice", (*same)->key),
                         file_.place((*(same + 1))->range), "leave one of them out");
    }

    const JsonFile& file_;
    std::string_view text_;
    Words words_;
    JsonValue root_;
    std::vector<JsonValue*> open_;
    std::size_t values_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const JsonMember& member) { return member.key == key; });
    return found == members.end() ? nullptr : &found->value;
}

JsonFile::JsonFile(Source file) : file_(std::move(file)), lines_{0} {
    const std::string& text = file_.text;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') { lines_.push_back(i + 1); }
    }
    if (text.starts_with(byte_order_mark) || text.starts_with("\xfe\xff") ||
        text.starts_with("\xff\xfe")) {
        throw InputError("the file begins with a byte order mark", place({0, 2}),
                         "save it as UTF-8 without one");
    }
    Builder builder(*this, text);
    const bool read = nlohmann::json::sax_parse(text, &builder);
    HVI_CHECK(read);
    root_ = builder.result();
}

std::size_t JsonFile::line_of(std::size_t byte) const {
    const auto after = std::upper_bound(lines_.begin(), lines_.end(), byte);
    return static_cast<std::size_t>(after - lines_.begin()) - 1;
}

Place JsonFile::place(Range range) const {
    const std::size_t line = line_of(range.begin);
    const std::size_t begin = lines_[line];
    const std::size_t end = std::min(file_.text.find('\n', begin), file_.text.size());
    const std::size_t last = std::min(std::max(range.begin, range.end), end);
    return {source(range, file_.text.substr(begin, end - begin)),
            {range.begin - begin, std::max(range.begin, last) - begin}};
}

std::shared_ptr<const Source> JsonFile::source(Range range, std::string text) const {
    return std::make_shared<const Source>(
        Source{fmt::format("{}:{}", file_.name, line_of(range.begin) + 1), std::move(text)});
}

}  // namespace hvi::gen
