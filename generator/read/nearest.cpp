// Suggestions for a mistyped word.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/nearest.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

constexpr std::size_t longest_word = 40;  ///< longer words resemble none of our names

bool same_letter(char left, char right) {
    const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? c - 'A' + 'a' : int{c}; };
    return lower(left) == lower(right);
}

/// Returns the number of insertions, deletions, replacements, and exchanges of neighbours that lead
/// from one word to the other. `row[j]` is the distance of the letters read so far from the first j
/// letters of `right`.
std::size_t distance(std::string_view left, std::string_view right) {
    std::vector<std::size_t> before_last;
    std::vector<std::size_t> last;
    std::vector<std::size_t> row(right.size() + 1);
    for (std::size_t j = 0; j <= right.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= left.size(); ++i) {
        before_last = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= right.size(); ++j) {
            const std::size_t replaced =
                last[j - 1] + (same_letter(left[i - 1], right[j - 1]) ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && same_letter(left[i - 1], right[j - 2]) &&
                same_letter(left[i - 2], right[j - 1]))
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row.back();
}

}  // namespace

std::vector<std::string_view> nearest(std::string_view word,
                                      const std::vector<std::string_view>& candidates) {
    if (word.empty() || word.size() > longest_word) return {};
    const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
    std::vector<std::pair<std::size_t, std::string_view>> found;
    for (const std::string_view candidate : candidates)
        if (const std::size_t errors = distance(word, candidate); errors <= allowed)
            found.emplace_back(errors, candidate);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& left, const auto& right) { return left.first < right.first; });
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < std::min<std::size_t>(found.size(), 3); ++k)
        names.push_back(found[k].second);
    return names;
}

std::string listed(const std::vector<std::string_view>& names) {
    constexpr std::size_t longest = 70;
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const bool is_last = k + 1 == names.size();
        const std::size_t behind = is_last ? 0 : names.back().size() + 7;  // `, ..., ` and the last
        if (k > 0 && text.size() + 2 + names[k].size() + behind > longest)
            return text + (is_last ? ", " : ", ..., ") + std::string(names.back());
        text += (k > 0 ? ", " : "") + std::string(names[k]);
    }
    return text;
}

std::string listed(const std::vector<std::string>& names) {
    return listed(std::vector<std::string_view>{names.begin(), names.end()});
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates,
                         std::string otherwise) {
    const std::vector<std::string_view> names = nearest(word, candidates);
    if (names.empty()) return otherwise;
    std::string text = "did you mean ";
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (k > 0) text += k + 1 == names.size() ? " or " : ", ";
        text += "`" + std::string(names[k]) + "`";
    }
    return text + "?";
}

}  // namespace hvi::gen
