// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/loop_gradient.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "generator/equations/index_ranges.hpp"
#include "generator/expr/powers.hpp"
#include "generator/graph/written.hpp"
#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

[[noreturn]] void refuse_index(const std::string& text, const Place& place) {
    throw NoLoops(
        fmt::format("the derivative by an element with the index {} has no formula here", text),
        place);
}

/// Reduces a form by whole moduli: i+N-2 is i-2 modulo N.
AffineForm less_moduli(const AffineForm& form, const AffineForm& modulus) {
    if (modulus.coefficients.empty()) { return form; }
    const auto& [name, per] = *modulus.coefficients.begin();
    return form - form.coefficient(name) / per * modulus;
}

Expression within_sums(Expression term, const std::vector<Loop>& loops) {
    for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop) {
        term = Expression::sum_over(loop->index, as_expression(loop->range.first),
                                    as_expression(loop->range.last), std::move(term));
    }
    return term;
}

/// A summand of a sum. Its accesses are solved for the indices of loops.
class Summand {
public:
    Summand(const System& system, const SystemSum& sum, const Place& place)
        : system_(system), sum_(sum), place_(place) {}

    /// Sets indices of loops so that the access is the element with these indices.
    void solve(const Access& access, const std::vector<Loop>& element);

    /// Returns the terms for a value of the summand, over the remaining loops and under the
    /// conditions.
    [[nodiscard]] std::vector<LoopTermOfSlope> terms(const Scaled& value) const;

private:
    void solve(const ElementIndex& index, const Loop& element);
    void solve_mod(const ElementIndex& index, const Loop& loop, const AffineForm& form,
                   const AffineForm& k);
    [[nodiscard]] const Loop* last_unsolved(const AffineForm& form) const;
    [[nodiscard]] bool has_unsolved(const AffineForm& form) const;
    void set(const std::string& index, ElementIndex value);
    [[nodiscard]] std::optional<std::string> wrapped_in(const AffineForm& form) const;
    /// Puts the solved indices in.
    [[nodiscard]] AffineForm put_in(AffineForm form) const;
    [[nodiscard]] ElementIndex put_in(const ElementIndex& index, const IndexRanges& ranges) const;
    [[nodiscard]] IndexRanges ranges() const;
    [[nodiscard]] std::vector<AffineForm> conditions() const;
    [[nodiscard]] Expression put_in(const Scaled& value, const IndexRanges& ranges) const;

    const System& system_;
    const SystemSum& sum_;
    const Place& place_;
    std::vector<Loop> element_;
    std::map<std::string, ElementIndex> solved_;
    std::vector<AffineForm> conditions_;
};

const Loop* Summand::last_unsolved(const AffineForm& form) const {
    for (auto loop = sum_.loops.rbegin(); loop != sum_.loops.rend(); ++loop) {
        const bool is_unit = std::abs(form.coefficient(loop->index)) == 1;
        if (is_unit && solved_.count(loop->index) == 0) { return &*loop; }
    }
    return nullptr;
}

bool Summand::has_unsolved(const AffineForm& form) const {
    return std::any_of(sum_.loops.begin(), sum_.loops.end(), [&](const Loop& loop) {
        return form.coefficient(loop.index) != 0 && solved_.count(loop.index) == 0;
    });
}

std::optional<std::string> Summand::wrapped_in(const AffineForm& form) const {
    for (const auto& [name, coefficient] : form.coefficients) {
        const auto found = solved_.find(name);
        if (found != solved_.end() && found->second.modulus) { return name; }
    }
    return std::nullopt;
}

AffineForm Summand::put_in(AffineForm form) const {
    for (const auto& [name, value] : solved_) {
        if (form.coefficient(name) == 0) { continue; }
        if (value.modulus) { refuse_index(to_text(as_expression(value)), place_); }
        form = replaced(form, name, value.form);
    }
    return form;
}

void Summand::set(const std::string& index, ElementIndex value) {
    for (auto& [name, other] : solved_) {
        if (other.form.coefficient(index) == 0) { continue; }
        if (value.modulus || other.modulus) { refuse_index(to_text(other.form), place_); }
        other.form = replaced(other.form, index, value.form);
    }
    solved_[index] = std::move(value);
}

void Summand::solve(const ElementIndex& index, const Loop& element) {
    const AffineForm k = AffineForm::of(element.index), form = put_in(index.form);
    const Loop* const loop = last_unsolved(form);
    if (loop == nullptr) {
        if (index.modulus || has_unsolved(form)) {
            refuse_index(to_text(as_expression(index)), place_);
        }
        conditions_.push_back(form - k);
        conditions_.push_back(k - form);
        return;
    }
    if (index.modulus) { return solve_mod(index, *loop, form, k); }
    const long sign = form.coefficient(loop->index);
    set(loop->index, {sign * (k - replaced(form, loop->index, {}))});
}

/// Solves mod(+-i + rest, M) + offset = k for i = first, ..., first + M - 1: each k has one i.
void Summand::solve_mod(const ElementIndex& index, const Loop& loop, const AffineForm& form,
                        const AffineForm& k) {
    const AffineForm &first = loop.range.first, &modulus = *index.modulus;
    const AffineForm rest = replaced(form, loop.index, {});
    const bool is_complete = loop.range.last - first + AffineForm{1} == modulus;
    for (const AffineForm* const part : {&first, &modulus, &index.offset, &rest}) {
        if (!is_complete || has_unsolved(*part) || wrapped_in(*part)) {
            refuse_index(to_text(as_expression(index)), place_);
        }
    }
    const AffineForm offset = put_in(index.offset), begin = put_in(first), M = put_in(modulus);
    const long sign = form.coefficient(loop.index);
    set(loop.index, {less_moduli(sign * (k - offset - rest) - begin, M), M, begin});
    conditions_.push_back(k - offset);
    conditions_.push_back(offset + M - AffineForm{1} - k);
}

void Summand::solve(const Access& access, const std::vector<Loop>& element) {
    element_ = element;
    for (std::size_t d = 0; d < element.size(); ++d) { solve(access.indices[d], element[d]); }
}

ElementIndex Summand::put_in(const ElementIndex& index, const IndexRanges& ranges) const {
    ElementIndex result;
    const auto name = wrapped_in(index.form);
    if (!name) {
        result = {put_in(index.form), index.modulus, put_in(index.offset)};
    } else {
        const ElementIndex& by = solved_.at(*name);
        const long times = index.form.coefficient(*name);
        const AffineForm rest = put_in(replaced(index.form, *name, {}));
        if (index.modulus == by.modulus) {
            result = {times * (by.form + by.offset) + rest, by.modulus, put_in(index.offset)};
        } else if (!index.modulus && times == 1) {
            result = {by.form, by.modulus, by.offset + rest};
        } else {
            refuse_index(to_text(as_expression(index)), place_);
        }
    }
    if (!result.modulus) { return {result.form + result.offset}; }
    result.modulus = put_in(*result.modulus);
    result.form = less_moduli(result.form, *result.modulus);
    const bool is_least_rest =
        is_never_negative(result.form, ranges) &&
        is_never_negative(*result.modulus - AffineForm{1} - result.form, ranges);
    return is_least_rest ? ElementIndex{result.form + result.offset} : result;
}

/// Returns the remaining loops.
IndexRanges Summand::ranges() const {
    IndexRanges result{element_, {}};
    for (const Loop& loop : sum_.loops) {
        if (solved_.count(loop.index) != 0) { continue; }
        result.loops.push_back({loop.index, {put_in(loop.range.first), put_in(loop.range.last)}});
    }
    for (std::size_t outer = 0; outer < result.loops.size(); ++outer) {
        for (std::size_t inner = outer; inner < result.loops.size(); ++inner) {
            const auto& [first, last] = result.loops[outer].range;
            const std::string& index = result.loops[inner].index;
            if (first.coefficient(index) != 0 || last.coefficient(index) != 0) {
                refuse_index(index, place_);
            }
        }
    }
    return result;
}

/// Returns conditions that keep the solved indices within their ranges.
std::vector<AffineForm> Summand::conditions() const {
    std::vector<AffineForm> result;
    for (const AffineForm& condition : conditions_) { result.push_back(put_in(condition)); }
    for (const Loop& loop : sum_.loops) {
        const auto value = solved_.find(loop.index);
        if (value == solved_.end() || value->second.modulus) { continue; }
        result.push_back(value->second.form - put_in(loop.range.first));
        result.push_back(put_in(loop.range.last) - value->second.form);
    }
    return result;
}

Expression Summand::put_in(const Scaled& value, const IndexRanges& ranges) const {
    const auto expression = written(system_.graph, value);
    if (!expression) {
        throw NoLoops("a derivative has more than two thousand words, and is not printed", place_);
    }
    std::set<std::string> symbols;
    insert_parameters(*expression, symbols);
    std::map<std::string, Expression> by;
    for (const std::size_t number : sum_.accesses) {
        const Access& access = system_.accesses[number];
        const std::string& name = system_.graph.at(access.node).name;
        if (access.indices.empty() || symbols.count(name) == 0) { continue; }
        std::vector<Expression> indices;
        for (const ElementIndex& index : access.indices) {
            indices.push_back(as_expression(put_in(index, ranges)));
        }
        by[name] = Expression::element(system_.family(access).name, std::move(indices));
    }
    for (const auto& [index, solution] : solved_) {
        if (symbols.count(index) == 0) { continue; }
        if (solution.modulus) { refuse_index(to_text(as_expression(solution)), place_); }
        by[index] = as_expression(solution.form);
    }
    return with_powers(replaced(*expression, by));
}

std::vector<LoopTermOfSlope> Summand::terms(const Scaled& value) const {
    const IndexRanges all = ranges();
    const Expression term = put_in(value, all);
    std::map<std::string, long> sizes;
    for (const SystemSize& size : system_.sizes) { sizes[size.name] = size.value; }
    std::vector<LoopTermOfSlope> result;
    for (PlacedSum& sum : placed(all, conditions(), sizes, place_)) {
        result.push_back({within_sums(term, sum.loops), std::move(sum.where)});
    }
    return result;
}

std::vector<std::string> free_indices(const System& system,
                                      const std::vector<std::string>& not_free) {
    std::size_t count = 0;
    for (const SystemFamily& family : system.coordinates) {
        count = std::max(count, family.ranges.size());
    }
    std::set<std::string> taken = names_in(system);
    taken.insert(not_free.begin(), not_free.end());
    std::vector<std::string> result;
    const auto add = [&](const std::string& name) {
        if (result.size() < count && taken.count(name) == 0) { result.push_back(name); }
    };
    for (const char* name : {"k", "l", "m", "n", "i", "j"}) { add(name); }
    for (int number = 1; result.size() < count; ++number) { add(fmt::format("k_{}", number)); }
    return result;
}

/// Returns the indices of an element, in the ranges of its family.
std::vector<Loop> element_loops(const SystemFamily& family,
                                const std::vector<std::string>& indices) {
    std::vector<Loop> result;
    for (std::size_t d = 0; d < family.ranges.size(); ++d) {
        result.push_back({indices[d], family.ranges[d]});
    }
    return result;
}

/// Adds a term; terms with equal ranges become one.
void add(ElementSlope& slope, LoopTermOfSlope term) {
    const auto same = std::find_if(slope.begin(), slope.end(), [&](const LoopTermOfSlope& other) {
        return other.where == term.where;
    });
    if (same == slope.end()) {
        slope.push_back(std::move(term));
    } else {
        same->value = Expression::sum({std::move(same->value), std::move(term.value)});
    }
}

}  // namespace

std::set<std::string> names_in(const System& system) {
    std::set<std::string> names;
    for (const auto* families : {&system.coordinates, &system.conjugates}) {
        for (const SystemFamily& family : *families) { names.insert(family.name); }
    }
    for (const SystemTable& table : system.tables) { names.insert(table.family.name); }
    for (const SystemParameter& parameter : system.parameters) { names.insert(parameter.name); }
    for (const SystemSize& size : system.sizes) { names.insert(size.name); }
    for (const SystemSum& sum : system.sums) {
        for (const Loop& loop : sum.loops) { names.insert(loop.index); }
    }
    return names;
}

LoopGradient loop_gradient(const System& system, const std::vector<std::string>& taken,
                           const Place& place) {
    LoopGradient result;
    result.indices = free_indices(system, taken);
    const auto add_all = [&](std::vector<ElementSlope>& slopes,
                             const std::vector<SystemFamily>& families,
                             std::vector<AccessSlope> SystemSum::*of) {
        slopes.resize(families.size());
        for (const SystemSum& sum : system.sums) {
            for (const AccessSlope& by : sum.*of) {
                const Access& access = system.accesses[by.access];
                Summand summand(system, sum, place);
                summand.solve(access, element_loops(families[access.family], result.indices));
                for (LoopTermOfSlope& term : summand.terms(by.value)) {
                    add(slopes[access.family], std::move(term));
                }
            }
        }
    };
    add_all(result.by_coordinates, system.coordinates, &SystemSum::by_q);
    add_all(result.by_momenta, system.conjugates, &SystemSum::by_conjugates);
    return result;
}

Expression element_of(const SystemFamily& family, const std::vector<std::string>& indices) {
    if (family.ranges.empty()) { return Expression::symbol(family.name); }
    std::vector<Expression> symbols;
    for (std::size_t d = 0; d < family.ranges.size(); ++d) {
        symbols.push_back(Expression::symbol(indices[d]));
    }
    return Expression::element(family.name, std::move(symbols));
}

std::string to_text(const SystemFamily& family) {
    std::vector<std::string> ranges;
    for (const auto& [first, last] : family.ranges) {
        ranges.push_back(to_text(as_expression(first)) + ".." + to_text(as_expression(last)));
    }
    return ranges.empty() ? family.name
                          : fmt::format("{}[{}]", family.name, fmt::join(ranges, ","));
}

Expression with_sums(const System& system, const Place& place) {
    std::vector<Expression> terms;
    for (const SystemSum& sum : system.sums) {
        for (LoopTermOfSlope& term : Summand(system, sum, place).terms(sum.value)) {
            terms.push_back(std::move(term.value));
        }
    }
    return Expression::sum(std::move(terms));
}

}  // namespace hvi::gen
