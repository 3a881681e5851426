// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/index_ranges.hpp"

#include <algorithm>
#include <utility>

#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

using Forms = std::vector<AffineForm>;

/// Returns the least value within the ranges, as a form in sizes.
AffineForm least(AffineForm form, const std::vector<Loop>& ranges) {
    for (auto loop = ranges.rbegin(); loop != ranges.rend(); ++loop) {
        const long coefficient = form.coefficient(loop->index);
        if (coefficient == 0) { continue; }
        form = replaced(form, loop->index, coefficient > 0 ? loop->range.first : loop->range.last);
    }
    return form;
}

bool is_not_negative(const AffineForm& form) { return form.is_number() && form.constant >= 0; }

/// Conditions on one index.
struct BoundsOfIndex {
    Forms lowers, uppers;
    Forms others;  ///< conditions without the index
};

BoundsOfIndex bounds_of(const std::string& index, const Forms& conditions, const Place& place) {
    BoundsOfIndex result;
    for (const AffineForm& condition : conditions) {
        const AffineForm rest = replaced(condition, index, {});
        switch (condition.coefficient(index)) {
        case 0: result.others.push_back(condition); break;
        case 1: result.lowers.push_back(-1 * rest); break;
        case -1: result.uppers.push_back(rest); break;
        default:
            throw NoLoops("a derivative has a sum that ends at a fraction of an index, and no "
                          "formula here",
                          place);
        }
    }
    return result;
}

/// Leaves out bounds that others imply. `sign` is 1 for lower bounds, of which the largest counts,
/// and -1 for upper bounds.
Forms narrowest(const Forms& bounds, long sign, const IndexRanges& ranges) {
    Forms result;
    const auto is_implied_by = [&](const AffineForm& bound) {
        return [&, bound](const AffineForm& other) {
            return is_never_negative(sign * (other - bound), ranges);
        };
    };
    for (const AffineForm& bound : bounds) {
        if (std::any_of(result.begin(), result.end(), is_implied_by(bound))) { continue; }
        std::erase_if(result, [&](const AffineForm& other) { return is_implied_by(other)(bound); });
        result.push_back(bound);
    }
    return result;
}

class Placing {
public:
    Placing(const std::vector<Loop>& element, const std::map<std::string, long>& sizes,
            const Place& place)
        : element_(element), sizes_(sizes), place_(place) {}

    /// Places the sum of `loops` under `conditions`. `inner` are loops that have their bounds.
    void add(std::vector<Loop> loops, Forms conditions, std::vector<Loop> inner);

    [[nodiscard]] std::vector<PlacedSum> result() && { return std::move(result_); }

private:
    /// Splits the sum in two parts: the first bound is the narrower one in one, the second in the
    /// other.
    void add_both(std::vector<Loop> loops, const BoundsOfIndex& bounds, long sign,
                  const std::vector<Loop>& inner);
    void finish(Forms conditions, std::vector<Loop> loops);

    const std::vector<Loop>& element_;
    const std::map<std::string, long>& sizes_;
    const Place& place_;
    std::vector<PlacedSum> result_;
};

void Placing::add_both(std::vector<Loop> loops, const BoundsOfIndex& bounds, long sign,
                       const std::vector<Loop>& inner) {
    const Loop loop = loops.back();
    const AffineForm index = AffineForm::of(loop.index);
    const Forms& all = sign > 0 ? bounds.lowers : bounds.uppers;
    Forms conditions = bounds.others;
    for (const AffineForm& lower : bounds.lowers) { conditions.push_back(index - lower); }
    for (const AffineForm& upper : bounds.uppers) { conditions.push_back(upper - index); }
    const auto add_with = [&](const AffineForm& bound, const AffineForm& other, long apart) {
        Forms those = conditions;
        std::erase(those, sign * (index - other));
        std::erase(those, sign * (index - bound));
        those.push_back(sign * (bound - other) - AffineForm{apart});
        (sign > 0 ? loops.back().range.first : loops.back().range.last) = bound;
        add(loops, std::move(those), inner);
    };
    add_with(all[0], all[1], 0);
    add_with(all[1], all[0], 1);
}

void Placing::add(std::vector<Loop> loops, Forms conditions, std::vector<Loop> inner) {
    if (loops.empty()) { return finish(std::move(conditions), std::move(inner)); }
    const Loop loop = loops.back();
    BoundsOfIndex bounds = bounds_of(loop.index, conditions, place_);
    const IndexRanges outer{element_, {loops.begin(), loops.end() - 1}};
    bounds.lowers.insert(bounds.lowers.begin(), loop.range.first);
    bounds.uppers.insert(bounds.uppers.begin(), loop.range.last);
    bounds.lowers = narrowest(bounds.lowers, 1, outer);
    bounds.uppers = narrowest(bounds.uppers, -1, outer);
    if (bounds.lowers.size() > 1) { return add_both(std::move(loops), bounds, 1, inner); }
    if (bounds.uppers.size() > 1) { return add_both(std::move(loops), bounds, -1, inner); }
    const AffineForm first = bounds.lowers.front(), last = bounds.uppers.front();
    if (is_never_negative(first - last - AffineForm{1}, outer)) { return; }
    inner.insert(inner.begin(), {loop.index, {first, last}});
    loops.pop_back();
    add(std::move(loops), std::move(bounds.others), std::move(inner));
}

/// NOTE: the element is always within its own range.
void Placing::finish(Forms conditions, std::vector<Loop> loops) {
    const IndexRanges ranges{element_, {}};
    PlacedSum sum{std::move(loops), {}};
    for (const AffineForm& condition : conditions) {
        if (is_never_negative(-1 * condition - AffineForm{1}, ranges)) { return; }
    }
    // NOTE: a sum with a last index before its first one is 0 anyway.
    std::erase_if(conditions, [&](const AffineForm& condition) {
        return std::any_of(sum.loops.begin(), sum.loops.end(), [&](const Loop& loop) {
            return loop.range.last - loop.range.first == condition;
        });
    });
    for (auto index = element_.rbegin(); index != element_.rend(); ++index) {
        BoundsOfIndex bounds = bounds_of(index->index, conditions, place_);
        bounds.lowers.insert(bounds.lowers.begin(), index->range.first);
        bounds.uppers.insert(bounds.uppers.begin(), index->range.last);
        bounds.lowers = narrowest(bounds.lowers, 1, ranges);
        bounds.uppers = narrowest(bounds.uppers, -1, ranges);
        if (bounds.lowers.size() > 1) { std::erase(bounds.lowers, index->range.first); }
        if (bounds.uppers.size() > 1) { std::erase(bounds.uppers, index->range.last); }
        const std::size_t count = std::max(bounds.lowers.size(), bounds.uppers.size());
        for (std::size_t k = count; k-- > 0;) {
            const Loop one{index->index,
                           {bounds.lowers[std::min(k, bounds.lowers.size() - 1)],
                            bounds.uppers[std::min(k, bounds.uppers.size() - 1)]}};
            if (one != *index) { sum.where.insert(sum.where.begin(), one); }
        }
        conditions = std::move(bounds.others);
    }
    for (const AffineForm& condition : conditions) {
        if (condition.at(sizes_) < 0) { return; }
    }
    result_.push_back(std::move(sum));
}

}  // namespace

bool is_never_negative(const AffineForm& form, const IndexRanges& ranges) {
    const AffineForm lowest = least(least(form, ranges.loops), ranges.element);
    const auto is_more_than_a_range = [&](const Loop& index) {
        return is_not_negative(lowest - (index.range.last - index.range.first));
    };
    return is_not_negative(lowest) ||
           std::any_of(ranges.element.begin(), ranges.element.end(), is_more_than_a_range);
}

std::vector<PlacedSum> placed(const IndexRanges& ranges, const std::vector<AffineForm>& conditions,
                              const std::map<std::string, long>& sizes, const Place& place) {
    Placing placing(ranges.element, sizes, place);
    placing.add(ranges.loops, conditions, {});
    return std::move(placing).result();
}

}  // namespace hvi::gen
