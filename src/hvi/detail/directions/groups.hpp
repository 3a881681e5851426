// Any number of directions, in groups of eight and one by one.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace hvi::detail {

/// Directions eight side by side in an `Eight`, and `few` or less that are left over in a `One`
/// each. Both take directions and give them back.
template <class One, class Eight, std::size_t few>
class Groups {
public:
    /// Takes all directions. Allocates where there are more than ever before.
    template <class Directions>
    void take(const Directions& directions) {
        count_ = std::size(directions);
        const std::size_t left = count_ % width;
        const std::size_t ones = left <= few ? left : 0;
        eights_.resize(std::max(eights_.size(), (count_ - ones + width - 1) / width));
        ones_.resize(std::max(ones_.size(), ones));
        each([&](auto& group, std::size_t first, std::size_t count) {
            group.take(std::next(std::begin(directions), static_cast<std::ptrdiff_t>(first)),
                       count);
            return true;
        });
    }

    /// Where they are now.
    template <class Directions>
    void give(Directions& directions) {
        each([&](auto& group, std::size_t first, std::size_t count) {
            group.give(std::next(std::begin(directions), static_cast<std::ptrdiff_t>(first)),
                       count);
            return true;
        });
    }

    /// Calls use(group, first, count) for each group of these directions, until that is false.
    /// Returns whether it was true for all.
    template <class Use>
    bool each(const Use& use) {
        std::size_t first = 0;
        for (Eight& group : eights_) {
            if (count_ - first <= few) { break; }
            const std::size_t count = std::min(width, count_ - first);
            if (!use(group, first, count)) { return false; }
            first += count;
        }
        for (One& group : ones_) {
            if (first == count_) { break; }
            if (!use(group, first++, std::size_t(1))) { return false; }
        }
        return true;
    }

    void forget() {
        for (Eight& group : eights_) { group.forget(); }
        for (One& group : ones_) { group.forget(); }
    }

private:
    static constexpr std::size_t width = Eight::width;

    std::size_t count_ = 0;
    std::vector<Eight> eights_;
    std::vector<One> ones_;
};

}  // namespace hvi::detail
