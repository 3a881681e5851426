// Unrolling: sums become terms, and an index becomes a part of a name.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "generator/read/parse.hpp"
#include "generator/read/vocabulary.hpp"

namespace hvi::gen {

/// Whole numbers by name: structural parameters, and indices.
using WholeNumbers = std::map<std::string, long, std::less<>>;

/// The largest size of an index. NOTE: products of two, and sums of many of these, fit in a long.
constexpr long largest_index = 100'000'000;

/// The most words in an expression after its sums are written out and its definitions put in.
constexpr std::size_t most_words_unrolled = 100'000;

/// Returns the expression with its sums written out: `sum(i=1..2, x[i]^2)` is x[1]^2 + x[2]^2, of
/// symbols with the names `x[1]` and `x[2]`, or `u[1,2]` with several indices. Names that are
/// `known` become numbers. A sum whose bounds depend on a name may have no term, and is 0 then.
/// Throws InputError where an index is no whole number of at most 10^8 in size, where a sum without
/// names in its bounds has no term, and for more than 100 000 words.
[[nodiscard]] Expression unrolled(const IndexedExpression& expression,
                                  const WholeNumbers& known = {});

/// Returns the value of an index. Throws InputError, with its place in `source`, as unrolled()
/// does.
[[nodiscard]] long whole_number(const Expression& index,
                                const std::shared_ptr<const Source>& source,
                                const WholeNumbers& known = {});

/// The values of an index, from first to last.
struct IndexInterval {
    long first, last;
};

/// Returns the values of a name's index. Throws InputError as whole_number() does, and where there
/// are none.
[[nodiscard]] IndexInterval interval(const IndexBounds& bounds,
                                     const std::shared_ptr<const Source>& source,
                                     const WholeNumbers& known = {});

/// The texts that declare variables: `["x[1..N]", "y"]` are two.
struct NameTexts {
    struct Text {
        std::vector<Name> names;
        std::shared_ptr<const Source> source;
    };
    std::vector<Text> texts;
    Place place;  ///< the place of all texts
};

/// Reads one text, such as `x, y[1..N]`. Throws InputError as parse_names() does.
[[nodiscard]] NameTexts name_texts(const std::shared_ptr<const Source>& source);

/// Returns each name with each of its indices, the last one running fastest: `x, y[1..3]` is x,
/// y[1], y[2], y[3]. Throws InputError as unrolled() does, where a range is empty, and for more
/// than 1000 names.
[[nodiscard]] NameList unrolled(const NameTexts& names, const WholeNumbers& known = {});

/// Returns `x[3]` for `x` with the index 3, `u[1,2]` for `u` with 1 and 2, and `x` without an
/// index.
[[nodiscard]] std::string indexed_name(std::string_view stem, const Index& index);

}  // namespace hvi::gen
