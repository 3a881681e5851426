// Columns of a table by their names.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <vector>

namespace hvi::detail {

/// Values of an index.
struct IndexRange {
    std::ptrdiff_t first, last;
};

/// A name of a number, or with indices of a number for each of their values. The last index changes
/// fastest.
struct NamedNumbers {
    const char* name;
    std::vector<IndexRange> ranges = {};

    [[nodiscard]] std::size_t size() const {
        std::size_t all = 1;
        for (const IndexRange& range : ranges) {
            const std::ptrdiff_t none = 0, each = range.last - range.first + 1;
            all *= static_cast<std::size_t>(std::max(none, each));
        }
        return all;
    }
};

/// Returns the range of the index of a list that begins at `first`.
template <class Scalar>
[[nodiscard]] std::vector<IndexRange> range_of(const std::vector<Scalar>& list,
                                               std::ptrdiff_t first) {
    return {{first, first + static_cast<std::ptrdiff_t>(list.size()) - 1}};
}

/// Numbers of chosen columns: the time is 0, and the numbers of `names` follow in their order.
class ChosenColumns {
public:
    /// NOTE: keeps a reference to `names`.
    explicit ChosenColumns(const std::vector<NamedNumbers>& names) : names_(names) {}

    /// Chooses columns by names between commas: `t`, `x`, and, for names with indices, also `x[3]`
    /// or `u[1,2]`. Returns false where there is no such name.
    [[nodiscard]] bool choose(std::string_view list) {
        while (true) {
            const std::size_t end = end_of_name(list);
            if (!add(trimmed(list.substr(0, end)))) { return false; }
            if (end == list.size()) { return true; }
            list.remove_prefix(end + 1);
        }
    }

    void add_range(std::size_t first, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) { numbers_.push_back(first + k); }
    }

    [[nodiscard]] const std::vector<std::size_t>& numbers() const { return numbers_; }

private:
    static std::string_view trimmed(std::string_view text) {
        while (!text.empty() && text.front() == ' ') { text.remove_prefix(1); }
        while (!text.empty() && text.back() == ' ') { text.remove_suffix(1); }
        return text;
    }

    /// Returns the end of the first name. NOTE: a comma in brackets is part of a name.
    static std::size_t end_of_name(std::string_view list) {
        bool is_in_brackets = false;
        for (std::size_t k = 0; k < list.size(); ++k) {
            if (list[k] == '[') { is_in_brackets = true; }
            if (list[k] == ']') { is_in_brackets = false; }
            if (list[k] == ',' && !is_in_brackets) { return k; }
        }
        return list.size();
    }

    /// Finds the place of `x[3]` among the numbers of x. Returns false where `text` is no such
    /// element.
    static bool find_element(std::string_view text, const NamedNumbers& family,
                             std::size_t& place) {
        const std::string_view name = family.name;
        const std::size_t length = name.size();
        if (text.size() < length + 2 || text.substr(0, length) != name || text[length] != '[' ||
            text.back() != ']') {
            return false;
        }
        const char* at = text.data() + length + 1;
        const char* const end = text.data() + text.size() - 1;
        place = 0;
        for (const IndexRange& range : family.ranges) {
            std::ptrdiff_t index = 0;
            const auto [stop, error] = std::from_chars(at, end, index);
            if (error != std::errc{} || index < range.first || index > range.last) { return false; }
            const std::size_t size = static_cast<std::size_t>(range.last - range.first + 1);
            place = place * size + static_cast<std::size_t>(index - range.first);
            const bool is_last = &range == &family.ranges.back();
            if (is_last ? stop != end : (stop == end || *stop != ',')) { return false; }
            at = is_last ? stop : stop + 1;
        }
        return !family.ranges.empty();
    }

    [[nodiscard]] bool add(std::string_view text) {
        if (text == "t") {
            numbers_.push_back(0);
            return true;
        }
        std::size_t number = 1;
        for (const NamedNumbers& each : names_) {
            std::size_t place = 0;
            if (text == each.name) {
                add_range(number, each.size());
                return true;
            }
            if (find_element(text, each, place)) {
                numbers_.push_back(number + place);
                return true;
            }
            number += each.size();
        }
        return false;
    }

    const std::vector<NamedNumbers>& names_;
    std::vector<std::size_t> numbers_;
};

}  // namespace hvi::detail
