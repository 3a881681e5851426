// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/element_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hvi::gen {

namespace {

using Values = std::map<std::string, long>;

struct Interval {
    long first, last;
};

Interval interval(const LoopRange& range, const Values& values) {
    return {range.first.at(values), range.last.at(values)};
}

/// Returns the values of a form for intervals of its names.
Interval bounds(const AffineForm& form, const std::map<std::string, Interval>& names) {
    Interval result{form.constant, form.constant};
    for (const auto& [name, coefficient] : form.coefficients) {
        const Interval& values = names.at(name);
        result.first += coefficient * (coefficient > 0 ? values.first : values.last);
        result.last += coefficient * (coefficient > 0 ? values.last : values.first);
    }
    return result;
}

bool contains(const Interval& outer, const Interval& inner) {
    return outer.first <= inner.first && inner.last <= outer.last;
}

/// Check of one index of an element within loops.
class IndexCheck {
public:
    IndexCheck(const ElementIndex& index, const LoopRange& allowed, const std::vector<Loop>& loops,
               const Values& sizes)
        : index_(index), allowed_(interval(allowed, sizes)), loops_(loops), values_(sizes) {}

    /// Returns whether the index stays in its range for all values of the loops. Otherwise values()
    /// has some for which it does not.
    [[nodiscard]] bool stays() { return stays_roughly() || stays_from(0); }

    /// Returns whether the loops have too many values to look at.
    [[nodiscard]] bool gave_up() const { return seen_ > most_values; }
    [[nodiscard]] const Values& values() const { return values_; }
    [[nodiscard]] long found() const { return found_; }
    [[nodiscard]] const Interval& allowed() const { return allowed_; }

private:
    static constexpr long most_values = 20'000'000;

    /// Returns whether intervals show that the index stays in its range.
    [[nodiscard]] bool stays_roughly() const {
        std::map<std::string, Interval> names;
        for (const auto& [name, value] : values_) { names[name] = {value, value}; }
        for (const Loop& loop : loops_) {
            names[loop.index] = {bounds(loop.range.first, names).first,
                                 bounds(loop.range.last, names).last};
        }
        if (index_.modulus) { return contains(allowed_, of_remainders(names)); }
        return contains(allowed_, bounds(index_.form, names));
    }

    [[nodiscard]] Interval of_remainders(const std::map<std::string, Interval>& names) const {
        const Interval modulus = bounds(*index_.modulus, names);
        const Interval offset = bounds(index_.offset, names);
        return {offset.first, offset.last + modulus.last - 1};
    }

    /// Returns whether the index stays in its range for all values of the loops from number `depth`
    /// on. NOTE: a form is least and largest at the ends of the innermost loop.
    [[nodiscard]] bool stays_from(std::size_t depth) {
        if (depth == loops_.size()) { return stays_here(); }
        const Loop& loop = loops_[depth];
        const auto [first, last] = interval(loop.range, values_);
        const bool is_innermost = depth + 1 == loops_.size() && !index_.modulus;
        const long step = is_innermost ? std::max(last - first, 1L) : 1;
        for (long value = first; value <= last; value += step) {
            values_[loop.index] = value;
            if (!stays_from(depth + 1)) { return false; }
        }
        return true;
    }

    [[nodiscard]] bool stays_here() {
        found_ = index_.form.at(values_);
        if (index_.modulus) {
            const long modulus = index_.modulus->at(values_);
            if (modulus < 1) { return false; }
            found_ = (found_ % modulus + modulus) % modulus + index_.offset.at(values_);
        }
        return ++seen_ <= most_values && allowed_.first <= found_ && found_ <= allowed_.last;
    }

    const ElementIndex& index_;
    Interval allowed_;
    const std::vector<Loop>& loops_;
    Values values_;
    long found_ = 0, seen_ = 0;
};

std::string loop_values(const std::vector<Loop>& loops, const Values& values) {
    std::string text;
    for (const Loop& loop : loops) {
        const auto value = values.find(loop.index);
        if (value == values.end()) { continue; }
        text += fmt::format("{}{} = {}", text.empty() ? " for " : ", ", loop.index, value->second);
    }
    return text;
}

}  // namespace

void check_ranges(const SystemFamily& family, const std::vector<ElementIndex>& indices,
                  const std::vector<Loop>& loops, const std::map<std::string, long>& sizes,
                  const Place& place) {
    for (std::size_t d = 0; d < indices.size(); ++d) {
        IndexCheck check(indices[d], family.ranges[d], loops, sizes);
        if (check.stays()) { continue; }
        if (check.gave_up()) {
            throw InputError(fmt::format("whether `{}` has all of these indices would take too "
                                         "long to find out",
                                         family.name),
                             place, "with smaller sizes it is found, and a program may raise them");
        }
        throw InputError(
            fmt::format("there is no `{}` with the index {}{}", family.name, check.found(),
                        loop_values(loops, check.values())),
            place,
            fmt::format("it runs from {} to {}", check.allowed().first, check.allowed().last));
    }
}

}  // namespace hvi::gen
