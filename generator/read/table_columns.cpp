// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/table_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_shown = 64;  ///< degrees of freedom whose variables are all shown
constexpr std::size_t first_shown = 3;  ///< indices of each name where there are more

std::size_t length(const IndexRange& range) {
    return static_cast<std::size_t>(range.last - range.first + 1);
}

std::size_t count(const NameBox& box) {
    std::size_t product = 1;
    for (const IndexRange& range : box.ranges) { product *= length(range); }
    return product;
}

/// Returns all columns of a box.
ColumnBox columns_of(const NameBox& names, std::size_t number) {
    ColumnBox columns{names, number, std::vector<std::size_t>(names.ranges.size(), 1)};
    for (std::size_t d = names.ranges.size(); d-- > 1;) {
        columns.strides[d - 1] = columns.strides[d] * length(names.ranges[d]);
    }
    return columns;
}

/// Returns the columns of one box after the other.
std::vector<ColumnBox> columns_of(const std::vector<NameBox>& all) {
    std::vector<ColumnBox> columns;
    std::size_t number = 0;
    for (const NameBox& box : all) {
        columns.push_back(columns_of(box, number));
        number += count(box);
    }
    return columns;
}

/// Returns the intersection of a box and ranges of as many indices; empty where there is none.
std::optional<ColumnBox> common(ColumnBox box, const std::vector<IndexRange>& ranges) {
    for (std::size_t d = 0; d < ranges.size(); ++d) {
        IndexRange& range = box.names.ranges[d];
        const IndexRange both{std::max(range.first, ranges[d].first),
                              std::min(range.last, ranges[d].last)};
        if (both.first > both.last) { return {}; }
        box.number += static_cast<std::size_t>(both.first - range.first) * box.strides[d];
        range = both;
    }
    return box;
}

/// Returns `x`, `x[2]`, or `u[1..3,2]`.
std::string in_words(const NameBox& box) {
    std::vector<std::string> indices;
    for (const auto& [first, last] : box.ranges) {
        indices.push_back(first == last ? std::to_string(first)
                                        : fmt::format("{}..{}", first, last));
    }
    return indices.empty() ? box.stem : fmt::format("{}[{}]", box.stem, fmt::join(indices, ","));
}

class ColumnReader {
public:
    ColumnReader(const Given& list, const std::vector<NameBox>& all, const WholeNumbers& sizes)
        : list_(list), all_(columns_of(all)), sizes_(sizes) {}

    [[nodiscard]] std::vector<ColumnBox> read(Range part) {
        for (const Name& name : parse_names(list_, part)) { add(name); }
        return std::move(chosen_);
    }

private:
    void add(const Name& name);
    [[nodiscard]] std::vector<ColumnBox> boxes_of(const Name& name) const;
    [[nodiscard]] std::vector<ColumnBox> parts_of(const std::vector<ColumnBox>& boxes,
                                                  const Name& name) const;
    [[nodiscard]] NameBox wanted(const Name& name, const std::vector<ColumnBox>& boxes) const;
    void check_new(const ColumnBox& box, const Place& place) const;
    [[noreturn]] void refuse_unknown(const Name& name) const;

    Given list_;
    std::vector<ColumnBox> all_;
    const WholeNumbers& sizes_;
    std::vector<ColumnBox> chosen_;
};

void ColumnReader::refuse_unknown(const Name& name) const {
    constexpr std::size_t most_listed = 20;
    const Place place{list_, name.range};
    if (name.stem == "t") {
        throw InputError("the time `t` is the first column in any case", place,
                         "name those that are to follow it");
    }
    std::vector<std::string_view> stems;
    for (const ColumnBox& box : all_) {
        const bool is_new = std::find(stems.begin(), stems.end(), box.names.stem) == stems.end();
        if (is_new && stems.size() < most_listed) { stems.emplace_back(box.names.stem); }
    }
    throw InputError(fmt::format("there is no column `{}`", name.stem), place,
                     did_you_mean(name.stem, stems, fmt::format("there are {}", listed(stems))));
}

/// Returns all boxes that have this name without its indices; at least one.
std::vector<ColumnBox> ColumnReader::boxes_of(const Name& name) const {
    std::vector<ColumnBox> boxes;
    for (const ColumnBox& box : all_) {
        if (box.names.stem == name.stem) { boxes.push_back(box); }
    }
    if (boxes.empty()) { refuse_unknown(name); }
    return boxes;
}

/// Returns the names that a name in the list stands for.
NameBox ColumnReader::wanted(const Name& name, const std::vector<ColumnBox>& boxes) const {
    const Place place{list_, name.range};
    const std::size_t dimension = boxes.front().names.ranges.size();
    if (name.bounds.size() != dimension) {
        throw InputError(dimension == 0 ? fmt::format("`{}` has no index", name.stem)
                                        : fmt::format("`{}` has {} ind{}", name.stem, dimension,
                                                      dimension == 1 ? "ex" : "ices"),
                         place, fmt::format("write `{}`", name.stem));
    }
    NameBox box{name.stem, {}};
    for (const IndexBounds& bounds : name.bounds) {
        box.ranges.push_back(
            {whole_number(bounds.first, list_, sizes_), whole_number(bounds.last, list_, sizes_)});
        if (box.ranges.back().first > box.ranges.back().last) {
            throw InputError("this range is empty", Place{list_, bounds.range});
        }
    }
    return box;
}

void ColumnReader::check_new(const ColumnBox& box, const Place& place) const {
    for (const ColumnBox& other : chosen_) {
        if (other.names.stem != box.names.stem) { continue; }
        if (const auto both = common(other, box.names.ranges)) {
            throw InputError(fmt::format("`{}` is named twice", in_words(both->names)), place);
        }
    }
}

/// Returns the parts of the boxes that a name with indices stands for.
std::vector<ColumnBox> ColumnReader::parts_of(const std::vector<ColumnBox>& boxes,
                                              const Name& name) const {
    const NameBox names = wanted(name, boxes);
    std::vector<ColumnBox> parts;
    std::size_t missing = count(names);
    for (const ColumnBox& box : boxes) {
        if (const auto both = common(box, names.ranges)) {
            parts.push_back(*both);
            missing -= count(both->names);
        }
    }
    if (missing == 0) { return parts; }
    const std::string first = in_words(boxes.front().names), last = in_words(boxes.back().names);
    throw InputError(fmt::format("there is no `{}`", in_words(names)), Place{list_, name.range},
                     boxes.size() == 1 ? fmt::format("there is `{}`", first)
                                       : fmt::format("there are `{}` to `{}`", first, last));
}

void ColumnReader::add(const Name& name) {
    std::vector<ColumnBox> found = boxes_of(name);
    if (!name.bounds.empty()) { found = parts_of(found, name); }
    for (const ColumnBox& box : found) { check_new(box, {list_, name.range}); }
    chosen_.insert(chosen_.end(), found.begin(), found.end());
}

/// Cuts a box down to its first `left` names along the last index, and reduces `left` by their
/// number.
ColumnBox beginning(ColumnBox box, std::size_t& left) {
    if (box.names.ranges.empty()) { return box; }
    for (std::size_t d = 0; d < box.names.ranges.size(); ++d) {
        IndexRange& range = box.names.ranges[d];
        const bool is_last = d + 1 == box.names.ranges.size();
        range.last = is_last ? range.first + static_cast<long>(std::min(left, length(range))) - 1
                             : range.first;
    }
    left -= count(box.names);
    return box;
}

}  // namespace

NameBox name_box(const std::string& name) {
    NameBox box{std::string(without_index(name)), {}};
    for (std::size_t at = name.find('['); at != std::string::npos; at = name.find(',', at + 1)) {
        const long index = std::stol(name.substr(at + 1));
        box.ranges.push_back({index, index});
    }
    return box;
}

std::vector<ColumnBox> named_columns(const Given& list, const std::vector<NameBox>& all,
                                     const WholeNumbers& sizes) {
    return named_columns(list, whole(list).range, all, sizes);
}

std::vector<ColumnBox> named_columns(const Given& list, Range part, const std::vector<NameBox>& all,
                                     const WholeNumbers& sizes) {
    return ColumnReader(list, all, sizes).read(part);
}

std::vector<ColumnBox> usual_columns(const std::vector<NameBox>& all, std::size_t variables) {
    const std::vector<ColumnBox> columns = columns_of(all);
    std::size_t numbers = 0;
    for (std::size_t k = 0; k < variables; ++k) { numbers += count(all[k]); }
    if (numbers <= 2 * most_shown) { return columns; }
    std::map<std::string, std::size_t> left;
    std::vector<ColumnBox> chosen;
    for (const ColumnBox& box : columns) {
        std::size_t& of_stem = left.try_emplace(box.names.stem, first_shown).first->second;
        if (of_stem > 0) { chosen.push_back(beginning(box, of_stem)); }
    }
    return chosen;
}

std::optional<std::size_t> columns_before(const std::vector<ColumnBox>& columns,
                                          const std::string& name) {
    const NameBox one = name_box(name);
    std::size_t before = 0;
    for (const ColumnBox& box : columns) {
        if (box.names.stem == one.stem && common(box, one.ranges)) {
            const ColumnBox all = columns_of(box.names, before);
            return common(all, one.ranges)->number;
        }
        before += count(box.names);
    }
    return {};
}

namespace {

/// Returns the name with this number, from 0 on.
std::string name_at(const NameBox& box, std::size_t number) {
    Index index(box.ranges.size());
    for (std::size_t d = index.size(); d-- > 0; number /= length(box.ranges[d])) {
        index[d] = box.ranges[d].first + static_cast<long>(number % length(box.ranges[d]));
    }
    return indexed_name(box.stem, index);
}

/// Appends the first names of a box, at most `most`.
void append_names(std::vector<std::string>& names, const NameBox& box, std::size_t most) {
    for (std::size_t k = 0; k < std::min(count(box), most); ++k) {
        names.push_back(name_at(box, k));
    }
}

}  // namespace

std::string name_at(const std::vector<NameBox>& boxes, std::size_t number) {
    for (const NameBox& box : boxes) {
        if (number < count(box)) { return name_at(box, number); }
        number -= count(box);
    }
    return {};
}

std::vector<std::string> names_in(const std::vector<NameBox>& boxes,
                                  const std::vector<ColumnBox>& columns) {
    std::vector<std::string> names;
    for (const NameBox& box : boxes) {
        if (count(box) <= most_shown) {
            append_names(names, box, most_shown);
            continue;
        }
        for (const ColumnBox& column : columns) {
            if (column.names.stem == box.stem) { append_names(names, column.names, most_shown); }
        }
    }
    return names;
}

namespace {

using SeeColumn = std::function<void(const std::string&, std::size_t)>;

/// Visits the columns whose names begin with `begun`. `number` is the column's number at the first
/// values of the remaining indices.
void see_indices(const ColumnBox& box, const std::string& begun, std::size_t number,
                 const SeeColumn& see, std::size_t depth) {
    const auto& [first, last] = box.names.ranges[depth];
    const bool is_last = depth + 1 == box.names.ranges.size();
    for (long i = first; i <= last; ++i, number += box.strides[depth]) {
        const std::string name = begun + std::to_string(i) + (is_last ? ']' : ',');
        is_last ? see(name, number) : see_indices(box, name, number, see, depth + 1);
    }
}

}  // namespace

void for_each_column(const std::vector<ColumnBox>& columns, const SeeColumn& see) {
    for (const ColumnBox& box : columns) {
        if (box.names.ranges.empty()) {
            see(box.names.stem, box.number);
        } else {
            see_indices(box, box.names.stem + '[', box.number, see, 0);
        }
    }
}

}  // namespace hvi::gen
