// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

using Expressions = std::vector<Expression>;

template <class Test>
bool any_part(const Expression& expression, const Test& test) {
    bool found = false;
    walk(expression, [&](const Expression& part) {
        found = found || test(part);
        return !found;
    });
    return found;
}

/// Returns whether an expression has the name, as a symbol or as the index of a sum.
bool mentions(const Expression& expression, const std::string& name) {
    return any_part(expression, [&](const Expression& part) { return part.name == name; });
}

constexpr long most_terms = 16;

/// Returns the number of terms of a sum with numbers for bounds; for any other sum more than the
/// limit.
long count_of_terms(const Expression& sum) {
    const auto first = affine_form(sum.arguments[0]), last = affine_form(sum.arguments[1]);
    if (!first || !last || !first->is_number() || !last->is_number()) { return most_terms + 1; }
    return std::clamp(last->constant - first->constant + 1, 0L, most_terms + 1);
}

/// Returns the number of terms of the largest sum of an expression, with inner sums written out
/// too.
long count_of_all_terms(const Expression& expression) {
    long most = 1;
    for (const Expression& argument : expression.arguments) {
        most = std::max(most, count_of_all_terms(argument));
    }
    if (expression.kind != Expression::Kind::sum_over) { return most; }
    return std::min(most_terms + 1, most * count_of_terms(expression));
}

/// Returns an expression with short sums written out where their bounds are numbers.
Expression written_out(const Expression& expression) {
    Expression result = expression;
    for (Expression& argument : result.arguments) { argument = written_out(argument); }
    if (result.kind != Expression::Kind::sum_over) { return result; }
    if (count_of_terms(result) > most_terms) { return result; }
    const auto first = affine_form(result.arguments[0]), last = affine_form(result.arguments[1]);
    Expressions terms;
    for (long index = first->constant; index <= last->constant; ++index) {
        terms.push_back(replaced(result.arguments[2], {{result.name, Expression::integer(index)}}));
    }
    Expression sum = Expression::sum(std::move(terms));
    sum.range = expression.range;
    return sum;
}

class Splitting {
public:
    Splitting(const std::shared_ptr<const Source>& source, const TermNames& names)
        : source_(source), names_(names) {}

    /// Adds the summands of an expression, times the factors, within the loops.
    void split(const Expression& expression, const Expressions& factors,
               const std::vector<Loop>& loops) {
        switch (expression.kind) {
        case Expression::Kind::sum:
            if (is_whole(expression)) { return add(expression, factors, loops); }
            for (const Expression& term : expression.arguments) { split(term, factors, loops); }
            return;
        case Expression::Kind::negation: {
            Expressions more = factors;
            more.push_back(Expression::integer(-1));
            return split(expression.arguments.front(), more, loops);
        }
        case Expression::Kind::sum_over:
            // NOTE: values that terms of a short sum share are computed once for all of them.
            if (!loops.empty() && count_of_terms(expression) > 0 &&
                count_of_all_terms(expression) <= most_terms) {
                return split(written_out(expression), factors, loops);
            }
            return split_sum(expression, factors, loops);
        case Expression::Kind::product: return split_product(expression, factors, loops);
        default: return add(expression, factors, loops);
        }
    }

    LoopTerms result;

private:
    /// Returns whether an expression has variables of one kind at most, and no sum.
    [[nodiscard]] bool is_whole(const Expression& expression) const {
        const Roles found = roles(expression);
        return !has_sum(expression) && (found & (found - 1)) == 0;
    }

    [[nodiscard]] Roles roles(const Expression& expression) const {
        Roles found = 0;
        walk(expression, [&](const Expression& part) {
            if (part.kind == Expression::Kind::symbol || part.kind == Expression::Kind::element) {
                found |= names_.roles(part.name);
            }
            return true;
        });
        return found;
    }

    void add(const Expression& expression, const Expressions& factors,
             const std::vector<Loop>& loops) {
        Expressions all = factors;
        all.push_back(with_totals(written_out(expression), loops));
        result.terms.push_back({loops, Expression::product(std::move(all))});
    }

    /// Returns an expression with symbols for its sums. NOTE: inner sums are left to them.
    [[nodiscard]] Expression with_totals(const Expression& expression,
                                         const std::vector<Loop>& loops) {
        if (expression.kind == Expression::Kind::sum_over) {
            check_total(expression, loops);
            std::string name = to_text(expression);
            result.totals.emplace(name, expression);
            Expression symbol = Expression::symbol(std::move(name));
            symbol.range = expression.range;
            return symbol;
        }
        Expression copy = expression;
        for (Expression& argument : copy.arguments) { argument = with_totals(argument, loops); }
        return copy;
    }

    void check_total(const Expression& sum, const std::vector<Loop>& loops) const {
        for (const Loop& loop : loops) {
            if (!mentions(sum, loop.index)) { continue; }
            throw NoLoops(fmt::format("where sums stay loops, a sum of more than 16 terms that has "
                                      "the index `{}` of a sum around it is not built inside a "
                                      "function or a product with sums",
                                      loop.index),
                          Place{source_, sum.range});
        }
    }

    void split_sum(const Expression& sum, const Expressions& factors,
                   const std::vector<Loop>& loops) {
        const auto first = bound(sum.arguments[0]), last = bound(sum.arguments[1]);
        const bool is_empty =
            first.is_number() && last.is_number() && last.constant < first.constant;
        if (is_empty) {
            const Range bounds{sum.arguments[0].range.begin, sum.arguments[1].range.end};
            throw InputError("this sum has no term", Place{source_, bounds});
        }
        LoopTerm inner =
            within_loop({loops, sum.arguments[2]}, sum.name, {first, last}, names_.taken);
        split(inner.term, factors, inner.loops);
    }

    [[nodiscard]] AffineForm bound(const Expression& written) const {
        if (auto form = affine_form(written)) { return std::move(*form); }
        throw NoLoops("where sums stay loops, their bounds are made of whole numbers, sizes and "
                      "other indices by +, - and products with numbers",
                      Place{source_, written.range});
    }

    /// Splits a product. NOTE: only one factor is multiplied out, the others having no variables,
    /// so that no value that was written once is computed twice.
    void split_product(const Expression& product, const Expressions& factors,
                       const std::vector<Loop>& loops) {
        if (is_whole(product)) { return add(product, factors, loops); }
        Expressions more = factors;
        const Expression* inner = nullptr;
        bool is_linear = true;
        for (const Expression& factor : product.arguments) {
            const bool opens =
                has_sum(factor) || (factor.kind == Expression::Kind::sum && !is_whole(factor));
            if (opens && inner != nullptr) { is_linear = false; }
            if (opens) {
                inner = &factor;
            } else {
                more.push_back(factor);
            }
        }
        if (inner != nullptr && is_linear) { return split(*inner, more, loops); }
        add(product, factors, loops);
    }

    const std::shared_ptr<const Source>& source_;
    const TermNames& names_;
};

}  // namespace

LoopTerm within_loop(LoopTerm term, const std::string& index, LoopRange range,
                     const std::set<std::string>& taken) {
    const auto is_free = [&](const std::string& name) {
        return taken.count(name) == 0 && (name == index || !mentions(term.term, name)) &&
               std::none_of(term.loops.begin(), term.loops.end(),
                            [&](const Loop& loop) { return loop.index == name; });
    };
    std::string name = index;
    for (int k = 2; !is_free(name); ++k) { name = fmt::format("{}_{}", index, k); }
    if (name != index) { term.term = replaced(term.term, {{index, Expression::symbol(name)}}); }
    term.loops.push_back({std::move(name), std::move(range)});
    return term;
}

Expression without_sums(const IndexedExpression& expression) {
    if (!has_sum(expression.written)) { return expression.written; }
    Expression result = written_out(expression.written);
    walk(result, [&](const Expression& part) {
        if (part.kind != Expression::Kind::sum_over) { return true; }
        throw NoLoops("a sum inside a function is built only for at most 16 terms, with numbers "
                      "for its bounds, where sums stay loops",
                      Place{expression.source, part.range});
    });
    return result;
}

LoopTerms loop_terms(const IndexedExpression& expression, const TermNames& names) {
    Splitting splitting(expression.source, names);
    splitting.split(expression.written, {}, {});
    return std::move(splitting.result);
}

}  // namespace hvi::gen
