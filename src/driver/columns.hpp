// Which numbers of a run are columns of its table, and what they are called.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>

namespace hvi::driver {

/// The part of a text before a separator; what follows it stays.
inline std::string_view take_until(std::string_view& text, std::string_view separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
    return part;
}

/// One of the indices of names: it runs from first to last, and the number of a column grows by
/// `stride` with it.
struct IndexRange {
    std::int64_t first = 0, last = 0, stride = 0;

    [[nodiscard]] bool read(std::string_view bounds, std::string_view stride_text) {
        return driver::read(take_until(bounds, ".."), first) && driver::read(bounds, last) &&
               driver::read(stride_text, stride) && first <= last && stride >= 0;
    }
};

/// Columns that have one name and differ in their indices, `u[1..3,2..5]:65:64,1`: u[1,2] is number
/// 65, and numbers grow by 64 and by 1 with the indices. One column alone is `energy:7`, `x[2]:1`.
class ColumnBox {
public:
    /// False where the text is none.
    [[nodiscard]] bool read(std::string_view text) {
        name_ = take_until(text, ":");
        if (!driver::read(take_until(text, ":"), number_)) { return false; }
        if (text.empty()) { return !name_.empty(); }
        std::string_view bounds = name_;
        name_ = take_until(bounds, "[");
        if (bounds.empty() || bounds.back() != ']') { return false; }
        bounds.remove_suffix(1);
        while (!bounds.empty()) {
            ranges_.emplace_back();
            if (!ranges_.back().read(take_until(bounds, ","), take_until(text, ","))) {
                return false;
            }
        }
        return text.empty();
    }

    /// Calls see(name, number) for each column; the last index runs fastest.
    template <class See>
    void for_each(See see) const {
        if (ranges_.empty()) { return see(name_, number_); }
        see_indices(std::string(name_) + '[', number_, 0, see);
    }

private:
    template <class See>
    void see_indices(const std::string& begun, std::int64_t number, std::size_t depth,
                     See& see) const {
        const IndexRange& range = ranges_[depth];
        const bool is_last = depth + 1 == ranges_.size();
        for (std::int64_t i = range.first; i <= range.last; ++i, number += range.stride) {
            const std::string name = begun + std::to_string(i) + (is_last ? ']' : ',');
            is_last ? see(name, number) : see_indices(name, number, depth + 1, see);
        }
    }

    std::string_view name_;
    std::int64_t number_ = 0;
    std::vector<IndexRange> ranges_;
};

/// The columns in a text: boxes between blanks. Calls see(name, number) for each; false where a box
/// is none.
template <class See>
[[nodiscard]] bool for_each_column(std::string_view text, See see) {
    while (!text.empty()) {
        ColumnBox box;
        if (!box.read(take_until(text, " "))) { return false; }
        box.for_each(see);
    }
    return true;
}

}  // namespace hvi::driver
