// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/unroll.hpp"

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <utility>

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_names = 1000;

std::optional<long> in_range(long value) {
    return -largest_index <= value && value <= largest_index ? std::optional(value) : std::nullopt;
}

/// Returns the value of an expression made of whole numbers, known names, +, -, * and mod.
std::optional<long> whole_value(const Expression& expression, const WholeNumbers& known);

std::optional<long> whole_mod(const Expression& call, const WholeNumbers& known) {
    const auto value = whole_value(call.arguments[0], known);
    const auto modulus = whole_value(call.arguments[1], known);
    if (call.name != "mod" || !value || !modulus || *modulus < 1) { return {}; }
    const long rest = *value % *modulus;
    return rest < 0 ? rest + *modulus : rest;
}

std::optional<long> whole_fold(const Expression& parts, const WholeNumbers& known) {
    const bool is_sum = parts.kind == Expression::Kind::sum;
    std::optional<long> value = is_sum ? 0 : 1;
    for (const Expression& part : parts.arguments) {
        const auto next = whole_value(part, known);
        if (!next) { return {}; }
        value = in_range(is_sum ? *value + *next : *value * *next);
        if (!value) { return {}; }
    }
    return value;
}

std::optional<long> whole_value(const Expression& expression, const WholeNumbers& known) {
    switch (expression.kind) {
    case Expression::Kind::number:
        if (expression.denominator != "1" || expression.numerator.size() > 9) { return {}; }
        return in_range(std::stol(expression.numerator));
    case Expression::Kind::symbol: {
        const auto found = known.find(expression.name);
        return found == known.end() ? std::nullopt : in_range(found->second);
    }
    case Expression::Kind::negation: {
        const auto argument = whole_value(expression.arguments.front(), known);
        return argument ? std::optional(-*argument) : std::nullopt;
    }
    case Expression::Kind::sum:
    case Expression::Kind::product: return whole_fold(expression, known);
    case Expression::Kind::call: return whole_mod(expression, known);
    default: return {};
    }
}

bool has_names(const Expression& expression) {
    bool found = false;
    walk(expression, [&](const Expression& part) {
        found = found || part.kind == Expression::Kind::symbol;
        return !found;
    });
    return found;
}

class Unrolling {
public:
    Unrolling(const std::shared_ptr<const Source>& source, WholeNumbers known)
        : source_(source), known_(std::move(known)) {}

    /// NOTE: the reader's functions build the result, so that it is as flat as what they read.
    [[nodiscard]] Expression operator()(const Expression& written) {
        count(written);
        Expression result = value(written);
        result.range = written.range;
        return result;
    }

private:
    [[nodiscard]] Expression value(const Expression& written) {
        switch (written.kind) {
        case Expression::Kind::number: return written;
        case Expression::Kind::symbol: {
            const auto found = known_.find(written.name);
            return found == known_.end() ? written : Expression::integer(found->second);
        }
        case Expression::Kind::sum: return Expression::sum(summands(written.arguments));
        case Expression::Kind::product: return Expression::product(all(written.arguments));
        case Expression::Kind::element: return element(written);
        case Expression::Kind::sum_over: return Expression::sum(terms(written));
        default: break;
        }
        Expression result = written;
        result.arguments = all(written.arguments);
        return result;
    }

    [[nodiscard]] std::vector<Expression> all(const std::vector<Expression>& written) {
        std::vector<Expression> result;
        result.reserve(written.size());
        for (const Expression& each : written) { result.push_back((*this)(each)); }
        return result;
    }

    /// Returns the summands without sums that have no term.
    [[nodiscard]] std::vector<Expression> summands(const std::vector<Expression>& written) {
        std::vector<Expression> result;
        for (const Expression& each : written) { append(result, each); }
        return result;
    }

    void append(std::vector<Expression>& terms, const Expression& written) {
        Expression term = (*this)(written);
        const bool is_empty =
            written.kind == Expression::Kind::sum_over && term == Expression::integer(0);
        if (!is_empty) { terms.push_back(std::move(term)); }
    }

    [[nodiscard]] Expression element(const Expression& written) {
        Index index;
        for (const Expression& each : written.arguments) {
            index.push_back(whole_number(each, source_, known_));
        }
        return Expression::symbol(indexed_name(written.name, index));
    }

    [[nodiscard]] std::vector<Expression> terms(const Expression& sum) {
        const Expression& lower = sum.arguments[0];
        const Expression& upper = sum.arguments[1];
        const long first = whole_number(lower, source_, known_);
        const long last = whole_number(upper, source_, known_);
        if (first > last && !has_names(lower) && !has_names(upper)) {
            throw InputError("this sum has no term",
                             Place{source_, {lower.range.begin, upper.range.end}});
        }
        const auto before = known_.find(sum.name);
        const auto hidden = before == known_.end() ? std::nullopt : std::optional(before->second);
        std::vector<Expression> result;
        for (long index = first; index <= last; ++index) {
            known_[sum.name] = index;
            append(result, sum.arguments[2]);
        }
        known_.erase(sum.name);
        if (hidden) { known_[sum.name] = *hidden; }
        return result;
    }

    void count(const Expression& written) {
        if (++words_ <= most_words_unrolled) { return; }
        throw InputError(fmt::format("the sums expand to more than {} words", most_words_unrolled),
                         Place{source_, written.range});
    }

    const std::shared_ptr<const Source>& source_;
    WholeNumbers known_;
    std::size_t words_ = 0;
};

/// Calls `visit` with each index, the last component running fastest.
void for_each_index(const std::vector<IndexInterval>& intervals, Index& index,
                    const std::function<void()>& visit) {
    if (index.size() == intervals.size()) {
        visit();
        return;
    }
    const IndexInterval& interval = intervals[index.size()];
    for (long value = interval.first; value <= interval.last; ++value) {
        index.push_back(value);
        for_each_index(intervals, index, visit);
        index.pop_back();
    }
}

}  // namespace

Expression unrolled(const IndexedExpression& expression, const WholeNumbers& known) {
    return Unrolling(expression.source, known)(expression.written);
}

long whole_number(const Expression& index, const std::shared_ptr<const Source>& source,
                  const WholeNumbers& known) {
    const std::optional<long> value = whole_value(index, known);
    if (!value) {
        throw InputError("a whole number is wanted here", Place{source, index.range},
                         "it is made of whole numbers up to 10^8, +, -, *, mod, parameters "
                         "that are whole, and indices of sums around it");
    }
    return *value;
}

IndexInterval interval(const IndexBounds& bounds, const std::shared_ptr<const Source>& source,
                       const WholeNumbers& known) {
    const long first = whole_number(bounds.first, source, known);
    const long last = whole_number(bounds.last, source, known);
    if (first > last) {
        throw InputError(fmt::format("there is no such index: from {} to {}", first, last),
                         Place{source, bounds.range});
    }
    return {first, last};
}

namespace {

/// Appends the names of one text's item; throws where there are too many.
void append(std::vector<DeclaredName>& list, const Name& name,
            const std::shared_ptr<const Source>& source, const WholeNumbers& known) {
    const Place place{source, name.range};
    const std::size_t left = most_names - list.size();
    std::vector<IndexInterval> intervals;
    std::size_t count = 1;
    for (const IndexBounds& bounds : name.bounds) {
        intervals.push_back(interval(bounds, source, known));
        const auto [first, last] = intervals.back();
        if (count <= left) { count *= static_cast<std::size_t>(last - first + 1); }
    }
    if (count > left) {
        throw InputError(fmt::format("there are more than {} names", most_names), place);
    }
    Index index;
    for_each_index(intervals, index, [&] {
        list.push_back({indexed_name(name.stem, index), place});
    });
}

}  // namespace

NameList unrolled(const NameTexts& names, const WholeNumbers& known) {
    NameList list{{}, names.place};
    for (const NameTexts::Text& text : names.texts) {
        for (const Name& name : text.names) { append(list.names, name, text.source, known); }
    }
    return list;
}

NameTexts name_texts(const std::shared_ptr<const Source>& source) {
    return {{{parse_names(source), source}}, whole(source)};
}

std::string indexed_name(std::string_view stem, const Index& index) {
    return index.empty() ? std::string(stem) : fmt::format("{}[{}]", stem, fmt::join(index, ","));
}

}  // namespace hvi::gen
