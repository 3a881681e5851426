// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/npy_head.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

struct KnownType {
    std::string_view name;
    NpyType type;
    std::size_t size;
};
constexpr KnownType known_types[]{{"<f8", NpyType::f8, 8},
                                  {"<f4", NpyType::f4, 4},
                                  {"<i8", NpyType::i8, 8},
                                  {"<i4", NpyType::i4, 4}};

/// Reads the dictionary of an NPY file, a literal of Python.
class NpyDictionary {
public:
    NpyDictionary(const NumberFile& file, std::string_view text) : file_(file), text_(text) {}

    [[nodiscard]] NpyHead read() {
        NpyHead head;
        demand('{');
        while (!skip('}')) {
            const std::string key = text();
            demand(':');
            if (key == "descr")
                read_type(head);
            else if (key == "shape")
                head.extents = shape();
            else if (key == "fortran_order")
                check_order();
            else
                refuse_file();
            if (!skip(',') && !sees('}')) refuse_file();
        }
        if (head.fields.empty()) refuse_file();
        constexpr std::size_t most_bytes = 1'000'000;  // of an element
        if (head.size > most_bytes) refuse_format(head.has_names);
        return head;
    }

private:
    [[noreturn]] void refuse_file() const { refuse(file_, "this is no NPY file"); }

    [[noreturn]] void refuse_format(bool has_names) const {
        refuse(file_, "the numbers of this file are in a format that is not read",
               has_names ? "a field is one number: dtype=[('x', '<f8'), ('y', '<f8')]"
                         : "save them as numpy.ascontiguousarray(x, dtype='<f8')");
    }

    [[nodiscard]] bool sees(char c) {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
        return at_ < text_.size() && text_[at_] == c;
    }
    [[nodiscard]] bool skip(char c) {
        const bool is_there = sees(c);
        at_ += is_there ? 1 : 0;
        return is_there;
    }
    void demand(char c) {
        if (!skip(c)) refuse_file();
    }

    /// Reads a text in quotes of either kind. NOTE: Python doubles a backslash in it.
    [[nodiscard]] std::string text() {
        const char quote = sees('"') ? '"' : '\'';
        demand(quote);
        const std::size_t end = text_.find(quote, at_);
        if (end == std::string_view::npos) refuse_file();
        std::string result(text_.substr(at_, end - at_));
        if (result.find('\\') != std::string::npos)
            refuse(file_, "a field has a name that is not read: " + result);
        at_ = end + 1;
        return result;
    }

    void read_type(NpyHead& head) {
        if (!skip('[')) {
            if (!sees('\'') && !sees('"')) refuse_file();
            add_field(head, "", text());
            return;
        }
        head.has_names = true;
        while (!skip(']')) {
            demand('(');
            if (sees('(')) refuse_format(true);  // a name with a title
            const std::string name = text();
            demand(',');
            if (!sees('\'') && !sees('"')) refuse_format(true);  // fields in a field
            add_field(head, name, text());
            if (sees(',')) refuse_format(true);  // several numbers in a field
            demand(')');
            if (!skip(',') && !sees(']')) refuse_file();
        }
        if (head.fields.empty()) refuse_format(true);
    }

    /// Adds a field behind the others. NOTE: of fields that are aligned, padding without a name is
    /// written as a type of bytes, '|V4'.
    void add_field(NpyHead& head, const std::string& name, std::string_view type) {
        constexpr std::string_view padding = "|V";
        if (head.has_names && name.empty() && type.substr(0, padding.size()) == padding) {
            type.remove_prefix(padding.size());
            head.size += whole_number(type).value_or(0);
            return;
        }
        const auto* known = std::find_if(std::begin(known_types), std::end(known_types),
                                         [&](const KnownType& one) { return one.name == type; });
        if (known == std::end(known_types)) refuse_format(head.has_names);
        head.fields.push_back({name, known->type, head.size});
        head.size += known->size;
    }

    void check_order() {
        constexpr std::string_view usual = "False";
        if (sees('F') && text_.substr(at_, usual.size()) == usual)
            at_ += usual.size();
        else
            refuse_format(false);
    }

    /// Removes digits from the beginning of a text. Returns their number; empty where there are
    /// none.
    static std::optional<std::size_t> whole_number(std::string_view& text) {
        constexpr std::size_t most_digits = 10;
        std::size_t value = 0, count = 0;
        for (; count < text.size() && is_digit(text[count]) && count < most_digits; ++count)
            value = 10 * value + static_cast<std::size_t>(text[count] - '0');
        text.remove_prefix(count);
        return count == 0 ? std::nullopt : std::optional(value);
    }

    /// Reads `(3, 4)`, or `(3,)`.
    [[nodiscard]] std::vector<std::size_t> shape() {
        std::vector<std::size_t> extents;
        demand('(');
        while (!skip(')')) {
            std::string_view rest = text_.substr(at_);
            const std::optional<std::size_t> extent = whole_number(rest);
            at_ = text_.size() - rest.size();
            if (!extent || (!skip(',') && !sees(')')))
                refuse(file_, "this is no shape of an array");
            extents.push_back(*extent);
        }
        return extents;
    }

    const NumberFile& file_;
    std::string_view text_;
    std::size_t at_ = 0;
};

/// Returns the dictionary, and the number of bytes up to its end. Behind the magic there are two
/// bytes of the version, and the length of the dictionary in two or four.
std::pair<std::string, std::size_t> dictionary(const NumberFile& file, std::ifstream& stream) {
    constexpr std::size_t longest = 1024 * 1024;
    std::string begin(npy_magic.size() + 2 + 4, '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    const std::size_t digits = begin[npy_magic.size()] == 1 ? 2 : 4;
    const std::size_t at = npy_magic.size() + 2 + digits;
    if (static_cast<std::size_t>(stream.gcount()) < at) refuse(file, "this is no NPY file");
    std::size_t length = 0;
    for (std::size_t i = at; i-- > npy_magic.size() + 2;)
        length = 256 * length + static_cast<unsigned char>(begin[i]);
    std::string text(std::min(length, longest), '\0');
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(at));
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (static_cast<std::size_t>(stream.gcount()) != length) refuse(file, "this is no NPY file");
    return {std::move(text), at + length};
}

std::size_t count_of(const NumberFile& file, const std::vector<std::size_t>& extents) {
    constexpr std::size_t most = 1'000'000'000;
    std::size_t count = extents.empty() ? 0 : 1;
    for (const std::size_t extent : extents) {
        if (extent > most) refuse(file, "this is no shape of an array");
        count = std::min(count * extent, most);
    }
    return count;
}

template <class T>
T copied(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

}  // namespace

NpyHead npy_head(const NumberFile& file, std::ifstream& stream) {
    const auto [text, begin] = dictionary(file, stream);
    NpyHead head = NpyDictionary(file, text).read();
    head.begin = begin;
    head.count = count_of(file, head.extents);
    if (std::filesystem::file_size(file.path) != begin + head.count * head.size)
        refuse(file, "the shape of the array is not that of its data");
    if (head.count == 0) refuse(file, "the array is empty");
    return head;
}

std::variant<double, float, std::int64_t, std::int32_t> npy_value(NpyType type, const char* bytes) {
    switch (type) {
    case NpyType::f8: return copied<double>(bytes);
    case NpyType::f4: return copied<float>(bytes);
    case NpyType::i8: return copied<std::int64_t>(bytes);
    case NpyType::i4: break;
    }
    return copied<std::int32_t>(bytes);
}

}  // namespace hvi::gen
